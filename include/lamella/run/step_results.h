// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_step_results_h
#define lamella_run_step_results_h

#include <lamella/base/exceptions.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/load_path.h>

#include <memory>

namespace lamella
{
  /// Exception: a body penetrates another one between inactive contact points.
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

    /// The body that needs shorter elements, the position along its axis, and
    /// the largest sufficient element length [length]; 0 if unknown.
    unsigned int body;
    double       y, longest;
  };

  /// Computes the results of load steps: fields at probes, lines and cuts,
  /// contact points, reserve factors of plies, measures, and warnings.
  class StepRecorder
  {
  public:
    /// Keeps references to @p built and to @p facts, which has the names of
    /// probes, lines, cuts and measures. @p thermal_part are the displacements
    /// of heated bodies at load factor zero (constant stresses), or null.
    StepRecorder(const BuiltScene                  &built,
                 const Results                     &facts,
                 std::shared_ptr<const BlockVector> thermal_part = nullptr);

    /// Returns the results of load step number @p step, from 1, without
    /// measures. The state @p previous shows which points opened and closed.
    StepResults
    record(const unsigned int step,
           const SolvedStep  &solved,
           const State       &previous) const;

    /// Adds the values of measures in the last step to @p results.
    void
    add_measures(Results &results) const;

    /// Returns a note on contacts without a force so far: on all if none has a
    /// force, else on contacts of unstrained bodies and moving obstacles.
    std::string
    note_on_idle_contacts() const;

    /// Returns the failure results of @p solved, a solution of the search for
    /// first failure, and sets its reserve factors @p plies.
    FailureTrial
    trial(const SolvedStep &solved, std::vector<PlyReserve> &plies) const;

    /// Returns the warnings of @p solved, a solution of the search for first
    /// failure with the reserve factors @p plies.
    std::vector<std::string>
    warnings_off_path(const SolvedStep       &solved,
                      std::vector<PlyReserve> plies) const;

    /// Returns the largest change of a goal between @p one and @p other, two
    /// solutions from @p before, over ResultNumbers::scale_of().
    double
    change_of_goals(const SolvedStep &one,
                    const SolvedStep &other,
                    const State      &before) const;

  private:
    /// Returns results with @p solved as the only step, to evaluate goals.
    Results
    minimal_results(const SolvedStep &solved, const State &before) const;
    /// Returns true if row @p row of @p contact was active in @p previous.
    bool
    was_active(const State       &previous,
               const unsigned int contact,
               const unsigned int row) const;
    /// Adds the contact points of all contacts to @p results.
    void
    record_contacts(const SolvedStep &solved,
                    const State      &previous,
                    StepResults      &results) const;
    /// Adds the reserve factors of plies to @p results.
    void
    record_strength(StepResults &results, const FaceTractions &tractions) const;
    /// Returns warnings about the state, the assumptions of contact, and the
    /// fields, equilibrium defects and plies in @p sampled.
    std::vector<std::string>
    warnings(const SolvedStep &solved, const StepResults &sampled) const;
    /// Returns warnings on rollers with few points at finite rotations.
    std::vector<std::string>
    warnings_of_rollers(const SolvedStep &solved) const;
    /// Throws UndetectedPenetration if bodies penetrate in an inactive contact.
    void
    require_found(const SolvedStep &solved) const;
    [[noreturn]] void
    throw_undetected_penetration(const ContactInterface    &contact,
                                 const CylinderPenetration &penetration,
                                 const unsigned int         body) const;
    /// Returns true if contact number @p contact, or another contact of the
    /// same two bodies, has an active constraint.
    bool
    touches(const unsigned int contact, const SolvedStep &solved) const;
    /// Returns the deepest penetration of a body end in contact number @p c, if
    /// it changes the contact force by more than 0.1 %.
    std::optional<EndPenetration>
    end_penetration(const unsigned int c, const SolvedStep &solved) const;
    /// Returns warnings if an end of a body penetrates another body without
    /// contact constraints. Throws MissingEnds if the discretization is `auto`.
    std::vector<std::string>
    warnings_of_ends(const SolvedStep &solved) const;
    /// Returns @p checks, in which the resultants of contacts that complement
    /// others at body ends (ContactPair::part_of) are added to the latter.
    Checks
    with_part_resultants(Checks checks) const;
    /// Returns the largest moment of a load, or force of a load, support or
    /// contact times the size of the scene; nodal forces if these are zero.
    double
    largest_moment(const SolvedStep &solved) const;
    /// Returns warnings of forces in isostatic supports if the loads are not in
    /// equilibrium for the motions that these supports constrain.
    std::vector<std::string>
    warnings_of_isostatic_supports(const SolvedStep &solved) const;
    /// Returns the numbers of the contacts in note_on_idle_contacts().
    std::vector<unsigned int>
    idle_contacts() const;
    /// Returns true if contact @p c has had a force that strains a body.
    bool
    has_carried_force(const unsigned int c) const;
    /// Returns warnings on `equilibrium` stresses with large defects.
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
