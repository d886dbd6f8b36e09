// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_step_results_h
#define lamella_run_step_results_h

#include <lamella/base/exceptions.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/load_path.h>

#include <memory>

namespace lamella
{
  /// Exception: a body penetrates an inactive contact between its points.
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
    /// longest sufficient length [length]; 0 if unknown.
    unsigned int body;
    double       y, longest;
  };

  /// Recorder of load step results: fields at probes, lines and cuts, contact
  /// pairs, reserve factors of plies, measures, and warnings.
  class StepRecorder
  {
  public:
    /// Refers to @p facts with the names of @p built's requests. @p
    /// thermal_part is the state of heated bodies at load factor zero, whose
    /// stresses do not grow with loads, or null.
    StepRecorder(const BuiltScene                  &built,
                 const Results                     &facts,
                 std::shared_ptr<const BlockVector> thermal_part = nullptr);

    /// Returns the results of step number @p step, from 1, without measures. @p
    /// previous, the state before, shows which pairs opened and closed.
    StepResults
    record(const unsigned int step,
           const SolvedStep  &solved,
           const State       &previous) const;

    /// Adds the measures of the last step to @p results.
    void
    add_measures(Results &results) const;

    /// Returns a sentence on contacts without a force so far: on all if none
    /// has one, else on those of unstrained bodies and moving obstacles.
    std::string
    note_on_idle_contacts() const;

    /// Returns the failure results of @p solved, a state beside the load path,
    /// and sets its reserve factors @p plies.
    FailureTrial
    trial(const SolvedStep &solved, std::vector<PlyReserve> &plies) const;

    /// Returns the warnings of @p solved, a state beside the load path.
    std::vector<std::string>
    warnings_off_path(const SolvedStep       &solved,
                      std::vector<PlyReserve> plies) const;

    /// Returns the largest change of goals between @p one and @p other, two
    /// ends of a step from @p before, over its scale
    /// (ResultNumbers::scale_of()).
    double
    change_of_goals(const SolvedStep &one,
                    const SolvedStep &other,
                    const State      &before) const;

  private:
    /// Returns results with @p solved as the only step, to evaluate goals.
    Results
    minimal_results(const SolvedStep &solved, const State &before) const;
    /// Returns whether @p row of @p contact was active in @p previous.
    bool
    was_active(const State       &previous,
               const unsigned int contact,
               const unsigned int row) const;
    /// Writes the pairs of all contacts into @p results.
    void
    record_contacts(const SolvedStep &solved,
                    const State      &previous,
                    StepResults      &results) const;
    /// Writes reserve factors of plies into @p results.
    void
    record_strength(StepResults &results, const FaceTractions &tractions) const;
    /// Returns warnings about the state, the assumptions of contact, and the
    /// step, equilibrium defects and plies in @p sampled.
    std::vector<std::string>
    warnings(const SolvedStep &solved, const StepResults &sampled) const;
    /// Returns warnings of few points on rollers at finite rotations.
    std::vector<std::string>
    warnings_of_rollers(const SolvedStep &solved) const;
    /// Throws UndetectedPenetration if an inactive contact is penetrated.
    void
    require_found(const SolvedStep &solved) const;
    [[noreturn]] void
    throw_undetected_penetration(const ContactInterface    &contact,
                                 const CylinderPenetration &penetration,
                                 const unsigned int         body) const;
    /// Returns whether contact number @p contact, or another one of the same
    /// two bodies, has an active constraint.
    bool
    touches(const unsigned int contact, const SolvedStep &solved) const;
    /// Returns the deepest end of a body in contact number @p c, if it is deep
    /// enough to change the contact force by 0.1 %.
    std::optional<EndPenetration>
    end_penetration(const unsigned int c, const SolvedStep &solved) const;
    /// Returns warnings where an end of a body lies in another one and has no
    /// contact constraints. Throws MissingEnds if a contact's discretization
    /// is automatic.
    std::vector<std::string>
    warnings_of_ends(const SolvedStep &solved) const;
    /// Returns @p checks with the resultants of contacts that are parts of
    /// others (ContactPair::part_of) in those others.
    Checks
    with_part_resultants(Checks checks) const;
    /// Returns the largest couple of a load, or force of a load, support or
    /// contact times the size of the scene; if these are rounding, the largest
    /// nodal force times that size.
    double
    largest_moment(const SolvedStep &solved) const;
    /// Returns warnings of forces in isostatic supports if the loads are not in
    /// equilibrium in the removed motions.
    std::vector<std::string>
    warnings_of_isostatic_supports(const SolvedStep &solved) const;
    /// Returns the numbers of the contacts of note_on_idle_contacts().
    std::vector<unsigned int>
    idle_contacts() const;
    /// Returns whether contact number @p c has had a force above rounding,
    /// which strains a body.
    bool
    has_carried_force(const unsigned int c) const;
    /// Returns warnings of stresses by equilibrium that do not balance.
    std::vector<std::string>
    warnings_of_defects(const EquilibriumDefects &defects) const;

    const BuiltScene                  &built;
    const Scene                       &scene;
    const Structure                   &structure;
    std::shared_ptr<const BlockVector> thermal_part;
    const Results                     &facts;
  };
} // namespace lamella

#endif
