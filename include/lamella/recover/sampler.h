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
  /**
   * The fields of a state where the scene asks for them: at probes, along lines
   * and over cuts. Construction locates all of these, so that one outside of
   * its body is an error before anything is solved.
   *
   * Lines are cut into pieces of one ply each; the places where they enter and
   * leave a ply are sampled on either side, so transverse stresses can be
   * compared across interfaces. A line that runs in an interface is sampled in
   * the lower ply first and then in the upper one. Every process does all of
   * it.
   */
  class Sampler
  {
  public:
    /// All four are referred to and have to live longer. Stresses of bodies
    /// that turn are told in the scene's axes where @p in_scene_axes says so,
    /// else in those of the material. Throws InputError for a probe, its box or
    /// a line's end outside of its body, for a cut that its axis does not
    /// reach, and for equilibrium of a body that is no laminate; the message
    /// names the entry.
    Sampler(const Bodies             &bodies,
            const std::vector<Probe> &probes,
            const std::vector<Line>  &lines,
            const std::vector<Cut>   &cuts,
            const bool                in_scene_axes = false);

    /**
     * Fills the probes, lines, cuts and jumps of @p results for the
     * displacements @p u.
     * @p u has a block for each body. Of each probe a row a ply (of a box one,
     * or two: box_points()), of each line rows along its pieces with the
     * InterfaceJump, of each cut the grids of its cells; of those with stresses
     * by equilibrium their closure errors. @p results must not have any of
     * these yet: rows are appended. Recoveries are made anew for each state,
     * one for each body and kind. @p tractions are what acts on faces.
     */
    void
    sample(const BlockVector   &u,
           StepResults         &results,
           const FaceTractions &tractions = FaceTractions()) const;

    /// Throws InputError with the entry of @p quantity if its probe does not
    /// lie in the ply that it names, or between two while it names none and is
    /// not the same in both whatever the mesh: displacements are, and the
    /// tractions of stresses by equilibrium. (Elements of plies of one law may
    /// happen to agree in one model and not in the next.) Looks at the terms of
    /// measures, too.
    void
    check(const NamedQuantity &quantity) const;

    /// @p quantity, in the lower ply if its probe lies between two and it
    /// names none: what References of a probe are compared with.
    NamedQuantity
    in_lower_ply(NamedQuantity quantity) const;

    /// The probes of the displacements @p u alone, as StepResults has them.
    std::vector<std::vector<FieldRow>>
    sample_probes(const BlockVector &u, const FaceTractions &tractions) const;

  private:
    /// The plies that the probe number @p probe lies in, from 1; "0" of a box
    /// that reaches into several.
    std::vector<std::string>
    plies_at(const unsigned int probe) const;
    /// Of the probe called @p probe, which there is.
    unsigned int
    number_of(const std::string &probe) const;
    /// Whether @p quantity has two values: see check().
    bool
    is_between_plies(const NamedQuantity &quantity) const;
    /// Whether @p column of @p probe is a traction on plies' faces that
    /// equilibrium gives.
    bool
    is_traction_by_equilibrium(const Probe       &probe,
                               const std::string &column) const;

    /// A sample of a line and its arc length from the start [length].
    struct LinePlace
    {
      double   s;
      Location location;
    };

    /// In each ply that the line crosses Line::samples places, equally spaced,
    /// both ends among them. Throws InputError for places outside of the body.
    std::vector<LinePlace>
    places_of(const Line &line) const;
    /// Throws InputError if the body has no section there.
    void
    check_cut(const Cut &cut) const;

    /// The recoveries of one state, by body and kind.
    class Recoveries;
    using Fields = std::function<FieldSample(const Location &)>;
    /// @p fields in the axes that are told.
    Fields
    told(Fields fields) const;
    /// The probes and their closure errors, into @p results.
    void
    sample_probes(Recoveries &recoveries, StepResults &results) const;
    /// The mean of @p fields over @p points of the probe @p p.
    FieldRow
    mean_row(const unsigned int p,
             const BoxPoints   &points,
             const Fields      &fields) const;
    /// The row of a table for @p location, with its @p fields.
    FieldRow
    row_at(const unsigned int body,
           const Location    &location,
           const Fields      &fields) const;
    std::vector<LineRow>
    line_rows(const unsigned int line, Recoveries &recoveries) const;
    /// The elements' own fields, replaced by the recovery's where the cut asks
    /// for them.
    std::vector<CutRow>
    cut_rows(const Cut         &cut,
             const BlockVector &u,
             Recoveries        &recoveries) const;

    const Bodies             &bodies;
    const std::vector<Probe> &probes;
    const std::vector<Line>  &lines;
    const std::vector<Cut>   &cuts;
    const bool                in_scene_axes;

    /// Of each probe the points of each of its rows; of each line its places,
    /// in order.
    std::vector<std::vector<BoxPoints>> probe_points;
    std::vector<std::vector<LinePlace>> line_places;
  };

  /**
   * What @p rows, of a line in the direction @p d, meet at ply interfaces:
   * wherever two rows that follow each other have the same arc length and
   * different plies, the traction t = sigma . d / |d| on either side is
   * compared,
   *   of_stress   = max |t_upper - t_lower| / max |sigma_ij|,
   *   of_traction = max |t_upper - t_lower| / max |t|,
   * the second maxima over the whole line, sigma_ij in scene axes. Equilibrium
   * makes the jump vanish where the line is normal to the plies, so it is an
   * error estimate of transverse stresses. Where tractions should be zero (pure
   * bending) of_traction compares the error with itself; it is 0 where they are
   * below 1e-9 of the stresses.
   */
  InterfaceJump
  interface_jump(const std::vector<LineRow> &rows,
                 const dealii::Tensor<1, 3> &d);

  /// Calls @p use for what has stresses by equilibrium in @p closures, of a
  /// load step of @p results: with `probe`, `line` or `cut`, its name and its
  /// closure error.
  void
  for_each_closure(const Results                           &results,
                   const Closures                          &closures,
                   const std::function<void(const std::string &kind,
                                            const std::string &name,
                                            double             share)> &use);
} // namespace lamella

#endif
