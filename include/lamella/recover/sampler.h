// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_sampler_h
#define lamella_recover_sampler_h

#include <lamella/recover/box_points.h>
#include <lamella/recover/face_tractions.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>
#include <lamella/shape/section_mesh.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// Evaluates the fields of a state at probes, along lines and on cuts. The
  /// constructor finds the elements of all points, so points outside the bodies
  /// are detected before the solution. Lines are divided into segments within
  /// one ply and evaluated on both sides of every interface. A line in an
  /// interface is evaluated in the lower ply, then in the upper ply. All
  /// processes evaluate all points.
  class Sampler
  {
  public:
    /// Keeps references to the four lists. Stresses of bodies with finite
    /// rotations are in scene axes if @p in_scene_axes, else in material axes.
    /// Throws InputError, naming the entry, for points outside their body, and
    /// for `equilibrium` stresses of a body that is not a laminate.
    Sampler(const Bodies             &bodies,
            const std::vector<Probe> &probes,
            const std::vector<Line>  &lines,
            const std::vector<Cut>   &cuts,
            const bool                in_scene_axes = false);

    /// Adds the fields of probes, lines and cuts, and the jumps, for the
    /// displacements @p u to @p results, which must not have any. A probe has
    /// one row per ply (a box one row, or two: box_points()), a line has rows
    /// along its segments and an InterfaceJump, a cut the grids of its cells.
    /// `equilibrium` stresses also give defects for the @p tractions on faces.
    void
    sample(const BlockVector   &u,
           StepResults         &results,
           const FaceTractions &tractions = FaceTractions()) const;

    /// Throws InputError with the entry of @p quantity in two cases: its probe
    /// is not in the ply that it names; or it names no ply, the probe is
    /// between two plies, and the quantity may be discontinuous there. For
    /// measures checks the terms.
    void
    check(const NamedQuantity &quantity) const;

    /// Returns @p quantity, with the lower ply of a probe between two plies.
    NamedQuantity
    in_lower_ply(NamedQuantity quantity) const;

    /// Returns StepResults::probes for the displacements @p u.
    std::vector<std::vector<FieldRow>>
    sample_probes(const BlockVector &u, const FaceTractions &tractions) const;

  private:
    /// Returns ply numbers (from 1) of probe number @p probe; "0": a mean.
    std::vector<std::string>
    plies_at(const unsigned int probe) const;
    /// Returns the number of the existing probe named @p probe.
    unsigned int
    number_of(const std::string &probe) const;
    /// Returns true if @p quantity may have two values (check()).
    bool
    is_between_plies(const NamedQuantity &quantity) const;
    /// Returns true if @p column is a traction on ply faces from equilibrium.
    bool
    is_traction_by_equilibrium(const Probe       &probe,
                               const std::string &column) const;

    /// A point of a line, and its arc length from the start [length].
    struct LinePoint
    {
      double   s;
      Location location;
    };

    /// Returns Line::samples equally spaced points, ends included, in each ply
    /// of the line. Throws InputError for points outside the body.
    std::vector<LinePoint>
    places_of(const Line &line) const;
    /// Throws InputError if the body has no section at the position of @p cut.
    void
    check_cut(const Cut &cut) const;

    /// StressRecovery and EquilibriumStress objects of one state, by body.
    class Recoveries;
    using Fields = std::function<FieldSample(const Location &)>;
    /// Returns @p fields transformed to the axes of the output.
    Fields
    told(Fields fields) const;
    /// Adds the rows of probes and their equilibrium defects to @p results.
    void
    sample_probes(Recoveries &recoveries, StepResults &results) const;
    /// Returns the mean of @p fields over @p points of probe number @p p.
    FieldRow
    mean_row(const unsigned int p,
             const BoxPoints   &points,
             const Fields      &fields) const;
    /// Returns the table row for @p location with its @p fields.
    FieldRow
    row_at(const unsigned int body,
           const Location    &location,
           const Fields      &fields) const;
    std::vector<LineRow>
    line_rows(const unsigned int line, Recoveries &recoveries) const;
    /// Returns the rows of a cut, with element or recovered stresses.
    std::vector<CutRow>
    cut_rows(const Cut         &cut,
             const BlockVector &u,
             Recoveries        &recoveries) const;

    const Bodies             &bodies;
    const std::vector<Probe> &probes;
    const std::vector<Line>  &lines;
    const std::vector<Cut>   &cuts;
    const bool                in_scene_axes;

    /// Points of each row of each probe, and points of each line, in order.
    std::vector<std::vector<BoxPoints>> probe_points;
    std::vector<std::vector<LinePoint>> line_sample_points;
  };

  /// Returns the interface jump from the @p rows of a line in direction @p d.
  /// Consecutive rows with the same arc length and different plies give the
  /// tractions t = sigma . d / |d| of both sides, which are compared:
  ///   of_stress   = max |t_upper - t_lower| / max |sigma_ij|,
  ///   of_traction = max |t_upper - t_lower| / max |t|,
  /// with maxima over the whole line in the denominators. Equilibrium requires
  /// zero jumps if the line is normal to the plies, so the jumps estimate the
  /// error of transverse stresses. Rounding (1e-9) counts as 0.
  InterfaceJump
  interface_jump(const std::vector<LineRow> &rows,
                 const dealii::Tensor<1, 3> &d);

  /// Calls @p use with the kind `probe`, `line` or `cut`, the name and the
  /// value for each of @p defects of a load step of @p results.
  void
  for_each_defect(const Results                           &results,
                  const EquilibriumDefects                &defects,
                  const std::function<void(const std::string &kind,
                                           const std::string &name,
                                           double             share)> &use);
} // namespace lamella

#endif
