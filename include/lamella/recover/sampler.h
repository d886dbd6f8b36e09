// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_sampler_h
#define lamella_recover_sampler_h

#include <lamella/body/body.h>
#include <lamella/recover/face_tractions.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Weights (with sum 1) and points of a quadrature rule for a mean value.
  using BoxPoints = std::vector<std::pair<double, Location>>;

  /// Returns the corners of a box with center @p middle and lengths @p edges.
  std::vector<dealii::Point<3>>
  box_corners(const dealii::Point<3>     &middle,
              const dealii::Tensor<1, 3> &edges);

  /// Returns the quadrature points X_q and weights w_q of the mean of a field f
  /// over the box with the center @p middle and the edge lengths @p edges in
  /// @p body,
  ///   1/V int f dV = sum_q w_q f(X_q).
  /// If edges have zero length, the mean is over an area, a line or a point.
  /// Integrals over x, y and z are nested and divided at element sides into
  /// intervals, in skewed elements into four each. Each has p / 2 + 2 Gauss
  /// points for displacements of degree p. The result is one quadrature rule,
  /// or two, for the lower and the upper ply, if the box is flat or a point and
  /// lies in a ply interface. Throws InputError, which names the scene entry @p
  /// path, if a corner or a point is not in the body, or for more than 200,000
  /// points. Not collective.
  std::vector<BoxPoints>
  box_points(const Body                 &body,
             const dealii::Point<3>     &middle,
             const dealii::Tensor<1, 3> &edges,
             const std::string          &path);

  /// Evaluates displacements, strains and stresses at probes, along lines and
  /// on cuts. The constructor finds the elements of all points, so points
  /// outside the bodies are detected before the solution. Lines are divided
  /// into segments within one ply, with points on both sides of every
  /// interface. A line in an interface is evaluated in the lower ply, then in
  /// the upper ply. All processes evaluate all points.
  class Sampler
  {
  public:
    /// Keeps references to the four lists. For finite rotations, stresses refer
    /// to scene axes if @p in_scene_axes, else to axes that rotate with the
    /// material. Throws InputError, naming the entry, for points outside their
    /// body, and for `equilibrium` stresses of a body that is not a laminate.
    Sampler(const Bodies             &bodies,
            const std::vector<Probe> &probes,
            const std::vector<Line>  &lines,
            const std::vector<Cut>   &cuts,
            const bool                in_scene_axes = false);

    /// Evaluates the displacements @p u and stores probes, lines, cuts, jumps
    /// and defects in @p results, in which these lists must be empty. A probe
    /// has one entry per ply (a box one entry, or two: box_points()), a line
    /// its points and an InterfaceJump, a cut the grids of its cells.
    /// `equilibrium` stresses use the @p tractions on faces.
    void
    sample(const BlockVector   &u,
           StepResults         &results,
           const FaceTractions &tractions = FaceTractions()) const;

    /// Throws InputError, which names the scene entry of @p quantity, if its
    /// probe is not in the requested ply. Also throws if no ply is requested
    /// although the quantity may be discontinuous at the probe, on a ply
    /// interface. Both terms of a measure are checked.
    void
    check(const NamedQuantity &quantity) const;

    /// Returns @p quantity. If it requests no ply, is discontinuous, and its
    /// probe lies on a ply interface, the result requests the lower ply.
    NamedQuantity
    in_lower_ply(NamedQuantity quantity) const;

    /// Returns the fields at all probes (StepResults::probes) for the
    /// displacements @p u and the @p tractions on faces.
    std::vector<std::vector<FieldRow>>
    sample_probes(const BlockVector &u, const FaceTractions &tractions) const;

  private:
    /// Returns the ply numbers from 1 ("0": several) of probe number @p probe.
    std::vector<std::string>
    plies_at(const unsigned int probe) const;
    /// Returns the index of the probe named @p probe, which must exist.
    unsigned int
    number_of(const std::string &probe) const;
    /// Returns true if @p quantity requests no ply, its probe lies on a ply
    /// interface, and the values of both plies may differ.
    bool
    is_between_plies(const NamedQuantity &quantity) const;
    /// Returns true if @p column is a transverse stress from equilibrium.
    bool
    is_traction_by_equilibrium(const Probe       &probe,
                               const std::string &column) const;

    /// A point of a line, and its distance s from the start [length].
    struct LinePoint
    {
      double   s;
      Location location;
    };

    /// Returns Line::samples equally spaced points of @p line, ends included,
    /// in each ply. Throws InputError for points outside the body.
    std::vector<LinePoint>
    places_of(const Line &line) const;
    /// Throws InputError if the body has no section at the position of @p cut.
    void
    check_cut(const Cut &cut) const;

    /// StressRecovery and EquilibriumStress objects of each body.
    class Recoveries;
    using Fields = std::function<FieldSample(const Location &)>;
    /// Returns @p fields, transformed to scene axes if these are requested.
    Fields
    told(Fields fields) const;
    /// Adds the fields and equilibrium defects of all probes to @p results.
    void
    sample_probes(Recoveries &recoveries, StepResults &results) const;
    /// Returns the mean of @p fields over the @p points of probe number @p p.
    FieldRow
    mean_row(const unsigned int p,
             const BoxPoints   &points,
             const Fields      &fields) const;
    /// Returns the values of @p fields at @p location of a body, for a table.
    FieldRow
    row_at(const unsigned int body,
           const Location    &location,
           const Fields      &fields) const;
    /// Returns the fields on the grid of @p cut.
    std::vector<CutRow>
    cut_rows(const Cut         &cut,
             const BlockVector &u,
             Recoveries        &recoveries) const;

    const Bodies             &bodies;
    const std::vector<Probe> &probes;
    const std::vector<Line>  &lines;
    const std::vector<Cut>   &cuts;
    const bool                in_scene_axes;

    /// Quadrature points of each probe in each ply, and points of each line.
    std::vector<std::vector<BoxPoints>> probe_points;
    std::vector<std::vector<LinePoint>> line_sample_points;
  };

  /// Returns the traction jumps at the ply interfaces of a line with the
  /// direction @p d and the fields @p rows. At an interface, the tractions t =
  /// sigma . d / |d| in both plies are compared:
  ///   of_stress   = max |t_upper - t_lower| / max |sigma_ij|,
  ///   of_traction = max |t_upper - t_lower| / max |t|,
  /// with maxima over the whole line in the denominators. Equilibrium requires
  /// zero jumps if the line is normal to the plies, so the jumps estimate the
  /// error of transverse stresses. Jumps within rounding (1e-9) are set to 0.
  InterfaceJump
  interface_jump(const std::vector<LineRow> &rows,
                 const dealii::Tensor<1, 3> &d);

  /// Calls @p use for each equilibrium defect in @p defects (of a load step of
  /// @p results) that is not empty, with the kind `probe`, `line` or `cut`, the
  /// name of the probe, line or cut, and the value.
  void
  for_each_defect(const Results                           &results,
                  const EquilibriumDefects                &defects,
                  const std::function<void(const std::string &kind,
                                           const std::string &name,
                                           double             share)> &use);
} // namespace lamella

#endif
