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
  /// Samples the fields of a state at probes, along lines and over cuts. The
  /// constructor locates all of them, so positions outside of bodies are found
  /// before solving. Lines are split into pieces of one ply each and sampled on
  /// both sides of every interface. A line in an interface is sampled in the
  /// lower ply, then in the upper one. Every process samples everything.
  class Sampler
  {
  public:
    /// Stores references to the four lists. Stresses of bodies with finite
    /// rotations are in scene axes if @p in_scene_axes, else in material axes.
    /// Throws InputError, naming the entry, for positions outside of their
    /// body, and for equilibrium of a body that is no laminate.
    Sampler(const Bodies             &bodies,
            const std::vector<Probe> &probes,
            const std::vector<Line>  &lines,
            const std::vector<Cut>   &cuts,
            const bool                in_scene_axes = false);

    /// Appends the probes, lines, cuts and jumps for the displacements @p u to
    /// @p results, which must not have any. A probe has a row per ply (a box
    /// one, or two: box_points()), a line rows along its pieces and an
    /// InterfaceJump, a cut the grids of its cells; stresses by equilibrium add
    /// closure errors for the @p tractions on faces.
    void
    sample(const BlockVector   &u,
           StepResults         &results,
           const FaceTractions &tractions = FaceTractions()) const;

    /// Throws InputError with the entry of @p quantity if its probe is not in
    /// the ply that it names, or lies between two plies, none named, and is not
    /// continuous there on every mesh. Checks the terms of measures, too.
    void
    check(const NamedQuantity &quantity) const;

    /// Returns @p quantity, in the lower ply if its probe lies between two.
    NamedQuantity
    in_lower_ply(NamedQuantity quantity) const;

    /// Returns the probes for the displacements @p u, as in StepResults.
    std::vector<std::vector<FieldRow>>
    sample_probes(const BlockVector &u, const FaceTractions &tractions) const;

  private:
    /// Returns the plies of probe @p probe, from 1; "0" for a box over several.
    std::vector<std::string>
    plies_at(const unsigned int probe) const;
    /// Returns the number of the existing probe called @p probe.
    unsigned int
    number_of(const std::string &probe) const;
    /// Returns whether @p quantity has two values: see check().
    bool
    is_between_plies(const NamedQuantity &quantity) const;
    /// Returns whether @p column is a traction on ply faces from equilibrium.
    bool
    is_traction_by_equilibrium(const Probe       &probe,
                               const std::string &column) const;

    /// A sample of a line and its arc length from the start [length].
    struct LinePoint
    {
      double   s;
      Location location;
    };

    /// Returns Line::samples equally spaced places, ends included, in each ply
    /// of the line. Throws InputError outside of the body.
    std::vector<LinePoint>
    places_of(const Line &line) const;
    /// Throws InputError if the body has no section there.
    void
    check_cut(const Cut &cut) const;

    /// The recoveries of one state, by body and kind.
    class Recoveries;
    using Fields = std::function<FieldSample(const Location &)>;
    /// Returns @p fields in the axes of the output.
    Fields
    told(Fields fields) const;
    /// Adds the probes and their closure errors to @p results.
    void
    sample_probes(Recoveries &recoveries, StepResults &results) const;
    /// Returns the mean of @p fields over @p points of the probe @p p.
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
    /// Returns the rows of a cut, of the elements' own or recovered fields.
    std::vector<CutRow>
    cut_rows(const Cut         &cut,
             const BlockVector &u,
             Recoveries        &recoveries) const;

    const Bodies             &bodies;
    const std::vector<Probe> &probes;
    const std::vector<Line>  &lines;
    const std::vector<Cut>   &cuts;
    const bool                in_scene_axes;

    /// Points of each row of each probe, and places of each line, in order.
    std::vector<std::vector<BoxPoints>> probe_points;
    std::vector<std::vector<LinePoint>> line_sample_points;
  };

  /**
   * Returns the interface jump of the @p rows of a line in direction @p d.
   * Where consecutive rows have the same arc length and different plies, the
   * tractions t = sigma . d / |d| on both sides are compared:
   *   of_stress   = max |t_upper - t_lower| / max |sigma_ij|,
   *   of_traction = max |t_upper - t_lower| / max |t|,
   * with denominators over the whole line. Equilibrium makes the jump zero
   * where the line is normal to the plies, so it estimates the error of
   * transverse stresses. of_traction is 0 for tractions below 1e-9 of the
   * stresses.
   */
  InterfaceJump
  interface_jump(const std::vector<LineRow> &rows,
                 const dealii::Tensor<1, 3> &d);

  /// Calls @p use with `probe`, `line` or `cut`, its name and error for each of
  /// @p defects of a load step of @p results.
  void
  for_each_defect(const Results                           &results,
                  const EquilibriumDefects                &defects,
                  const std::function<void(const std::string &kind,
                                           const std::string &name,
                                           double             share)> &use);
} // namespace lamella

#endif
