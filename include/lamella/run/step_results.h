// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_step_results_h
#define lamella_run_step_results_h

#include <lamella/base/exceptions.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/load_path.h>

#include <memory>

namespace lamella
{
  /// Exception: an inactive contact has a penetrating body between its points,
  /// which are too far apart.
  struct UndetectedPenetration : public NumericsError
  {
    UndetectedPenetration(const std::string &message,
                          const unsigned int body,
                          const double       y,
                          const double       longest)
      : NumericsError(message)
      , body(body)
      , y(y)
      , longest(longest)
    {}

    /// The body that needs shorter elements, the place along its axis, and the
    /// longest sufficient length [length]; 0 if it is not known.
    unsigned int body;
    double       y, longest;
  };

  /**
   * Makes results of what a load step came to: fields at probes, lines and
   * cuts, contact pairs, reserve factors of plies, measures, and what the user
   * should know of it. Refers to the scene.
   */
  class StepRecorder
  {
  public:
    /// @p facts, referred to, has the names of @p built's probes, lines and
    /// cuts. @p cured is the state at load factor zero of heated bodies, whose
    /// stresses stay when loads grow; null where nothing is heated.
    StepRecorder(const BuiltScene                  &built,
                 const Results                     &facts,
                 std::shared_ptr<const BlockVector> cured = nullptr);

    /// What step number @p step, from 1, came to, all but measures and what the
    /// strategy has learnt; @p previous, the state of the step before, tells
    /// which pairs began and ceased to touch.
    StepResults
    record(const unsigned int step,
           const SolvedStep  &solved,
           const State       &previous) const;

    /// The measures of the last of the steps in @p results, into it.
    void
    take_measures(Results &results) const;

    /// Returns a sentence on contacts without a force in all steps so far: on
    /// all if none has one, else on those of unstrained bodies and moving
    /// obstacles. Empty if there are none.
    std::string
    note_on_idle_contacts() const;

    /// What @p solved, a state beside the path, says of failure; its reserve
    /// factors into @p plies. The scene must ask for criteria.
    FailureTrial
    trial(const SolvedStep &solved, std::vector<PlyReserve> &plies) const;

    /// Returns the warnings of @p solved, a state beside the load path, with
    /// the reserve factors @p plies.
    std::vector<std::string>
    warnings_beside(const SolvedStep       &solved,
                    std::vector<PlyReserve> plies) const;

    /// The largest change of what the scene's goals are between @p one and
    /// @p other, two ends of a step from @p before, each over its scale
    /// (ResultNumbers::scale_of()). Zero if it has none.
    double
    change_of_goals(const SolvedStep &one,
                    const SolvedStep &other,
                    const State      &before) const;

  private:
    /// What goals are asked of: a run whose only step came to @p solved.
    Results
    bare_results(const SolvedStep &solved, const State &before) const;
    /// Whether @p row of @p contact was pressed in the @p previous state.
    bool
    has_touched(const State       &previous,
                const unsigned int contact,
                const unsigned int row) const;
    /// The pairs of all contacts, into @p results.
    void
    take_contacts(const SolvedStep &solved,
                  const State      &previous,
                  StepResults      &results) const;
    /// Writes reserve factors of plies into @p results.
    void
    take_strength(StepResults &results, const FaceTractions &tractions) const;
    /// Returns warnings about the state, the assumptions of contact (small
    /// sliding, collinear normals), and the step, equilibrium defects and plies
    /// in @p sampled.
    std::vector<std::string>
    warnings(const SolvedStep &solved, const StepResults &sampled) const;
    /// Of bodies that turn, where rollers touch them at few points.
    std::vector<std::string>
    warnings_of_rollers(const SolvedStep &solved) const;
    /// Throws UndetectedPenetration where a body or an obstacle is inside of a
    /// body between its contact points, and nothing touches.
    void
    require_found(const SolvedStep &solved) const;
    [[noreturn]] void
    throw_undetected_penetration(const ContactInterface &contact,
                                 const SunkPlace        &sunk,
                                 const unsigned int      body) const;
    /// Returns whether contact number @p contact, or another one of the same
    /// two bodies, has an active constraint.
    bool
    touches(const unsigned int contact, const SolvedStep &solved) const;
    /// Returns the deepest end of a body in contact number @p c, if it is deep
    /// enough to change the contact force by 0.1 %.
    std::optional<SunkEnd>
    sunk_end(const unsigned int c, const SolvedStep &solved) const;
    /// Returns warnings where an end of a body lies in another one and has no
    /// contact constraints. Throws MissingEnds if a contact's discretization
    /// is automatic.
    std::vector<std::string>
    warnings_of_ends(const SolvedStep &solved) const;
    /// Returns @p checks with the resultants of contacts that are parts of
    /// others (ContactPair::part_of) in those others.
    Checks
    with_parts(Checks checks) const;
    /// The largest couple of a load, or force of a load, a support or a contact
    /// over the size of the scene, where forces of nodes are not all there is.
    double
    largest_moment(const SolvedStep &solved) const;
    /// What the holds of bodies bear where forces do not balance in
    /// motions that they take out.
    std::vector<std::string>
    warnings_of_holds(const SolvedStep &solved) const;
    /// Returns the numbers of the contacts of note_on_idle_contacts().
    std::vector<unsigned int>
    idle_contacts() const;
    /// Returns whether contact number @p c has had a force above rounding,
    /// which strains a body.
    bool
    has_carried_force(const unsigned int c) const;
    /// What is to be said of stresses whose equilibrium does not close.
    std::vector<std::string>
    warnings_of_closures(const Closures &closures) const;

    const BuiltScene                  &built;
    const Scene                       &scene;
    const Structure                   &structure;
    std::shared_ptr<const BlockVector> cured;
    const Results                     &facts;
  };
} // namespace lamella

#endif
