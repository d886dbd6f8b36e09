// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_step_results_h
#define lamella_run_step_results_h

#include <lamella/base/exceptions.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/load_path.h>

#include <memory>

namespace lamella
{
  /// A contact touches nowhere, and what it may touch is inside of a body
  /// between its points: they are too far apart.
  struct BetweenPoints : public NumericsError
  {
    BetweenPoints(const std::string &message,
                  const unsigned int body,
                  const double       y,
                  const double       longest)
      : NumericsError(message)
      , body(body)
      , y(y)
      , longest(longest)
    {}

    /// The body that wants shorter elements, the place along its axis, and the
    /// longest there that would find it [length]; 0 where it is not known.
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

    /// Of contacts that bear no force in any of the steps so far: all of them
    /// if none does, else those of bodies that nothing strains and of obstacles
    /// that move. A sentence, empty if there are none.
    std::string
    note_on_idle_contacts() const;

    /// What @p solved, a state beside the path, says of failure; its reserve
    /// factors into @p plies. The scene must ask for criteria.
    FailureTrial
    trial(const SolvedStep &solved, std::vector<PlyReserve> &plies) const;

    /// The warnings of a load step that comes to @p solved, a state beside the
    /// path with the reserve factors @p plies.
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
    /// Reserve factors of plies, into @p results.
    void
    take_strength(StepResults &results, const FaceTractions &tractions) const;
    /// What the user should know of the state, of what pairing assumed (small
    /// sliding, collinear normals), and of what was @p sampled there: its step,
    /// closures and plies.
    std::vector<std::string>
    warnings(const SolvedStep &solved, const StepResults &sampled) const;
    /// Of bodies that turn, where rollers touch them at few points.
    std::vector<std::string>
    warnings_of_rollers(const SolvedStep &solved) const;
    /// Throws BetweenPoints where a body or an obstacle is inside of a body
    /// between its contact points, and nothing touches.
    void
    require_found(const SolvedStep &solved) const;
    [[noreturn]] void
    throw_between_points(const ContactInterface &contact,
                         const SunkPlace        &sunk,
                         const unsigned int      body) const;
    /// Whether a row of contact number @p contact, or of another of the same
    /// two, carries force.
    bool
    touches(const unsigned int contact, const SolvedStep &solved) const;
    /// Of bodies that turn, where an end of one lies in another.
    std::vector<std::string>
    warnings_of_ends(const SolvedStep &solved) const;
    /// The largest couple of a load, or force of a load, a support or a contact
    /// over the size of the scene, where forces of nodes are not all there is.
    double
    largest_moment(const SolvedStep &solved) const;
    /// What the holds of bodies bear where forces do not balance in
    /// motions that they take out.
    std::vector<std::string>
    warnings_of_holds(const SolvedStep &solved) const;
    /// The numbers of the contacts of note_on_idle_contacts().
    std::vector<unsigned int>
    idle_contacts() const;
    /// Whether contact number @p c has borne a force of more than rounding: one
    /// that strains a body.
    bool
    has_borne(const unsigned int c) const;
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
