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
    /// Constructs the exception with the @p message and the data below.
    UndetectedPenetration(const std::string &message,
                          const unsigned int body,
                          const double       y,
                          const double       longest)
      : NumericsError(message)
      , body(body)
      , y(y)
      , longest(longest)
    {}

    unsigned int body; ///< Index of the body that needs shorter axis elements.
    double       y,    ///< Position of the penetration along the axis [length].
      longest; ///< Largest element that detects it [length]; 0 if unknown.
  };

  /// Computes the results of load steps: fields at probes, lines and cuts,
  /// contact results, reserve factors, differences of probe values, warnings.
  class StepRecorder
  {
  public:
    /// Constructs a recorder for the model @p built; @p facts has the names of
    /// probes, lines, cuts and measures. Keeps references to both. Reserve
    /// factors do not multiply the stresses of @p thermal_part, the
    /// displacements due to temperatures alone; null if there are none.
    StepRecorder(const BuiltScene                  &built,
                 const Results                     &facts,
                 std::shared_ptr<const BlockVector> thermal_part = nullptr);

    /// Returns the results of load step number @p step, from 1, without
    /// measures. Changes of contact are relative to the state @p previous.
    StepResults
    record(const unsigned int step,
           const SolvedStep  &solved,
           const State       &previous) const;

    /// Adds differences of probe values (measures) to the last of @p results,
    /// and sets the values of its goals (Results::quantities).
    void
    add_measures(Results &results) const;

    /// Returns a warning that names contacts without force in all load steps,
    /// or an empty text. If other contacts have forces, a contact of strained
    /// bodies with each other or a fixed obstacle is not named: it may be open
    /// on purpose.
    std::string
    note_on_idle_contacts() const;

    /// Returns the results of @p solved, a solution at a trial load factor of
    /// the search for first failure. Stores its reserve factors in @p plies.
    FailureTrial
    trial(const SolvedStep &solved, std::vector<PlyReserve> &plies) const;

    /// Returns the warnings for the solution @p solved, with reserve factors @p
    /// plies, for a trial load factor in the search for first failure.
    std::vector<std::string>
    warnings_off_path(const SolvedStep       &solved,
                      std::vector<PlyReserve> plies) const;

    /// Returns the largest relative change of a goal between @p one and @p
    /// other, solutions of a load step with different numbers of substeps. @p
    /// before is the state at its start (see ResultNumbers::scale_of()).
    double
    change_of_goals(const SolvedStep &one,
                    const SolvedStep &other,
                    const State      &before) const;

  private:
    /// Returns results with the load step @p solved only, to evaluate goals.
    Results
    minimal_results(const SolvedStep &solved, const State &before) const;
    /// Returns true if constraint @p row of @p contact was active before.
    bool
    was_active(const State       &previous,
               const unsigned int contact,
               const unsigned int row) const;
    /// Adds gaps, pressures and slips at all contact points to @p results.
    void
    record_contacts(const SolvedStep &solved,
                    const State      &previous,
                    StepResults      &results) const;
    /// Returns warnings on the solution @p solved, on violated assumptions of
    /// contact, and on fields, equilibrium defects and plies in @p sampled.
    std::vector<std::string>
    warnings(const SolvedStep &solved, const StepResults &sampled) const;
    /// Returns warnings on cylindrical obstacles at finite rotations: too few
    /// contact points, or line contact although the body wraps around them.
    std::vector<std::string>
    warnings_of_rollers(const SolvedStep &solved) const;
    /// Throws UndetectedPenetration if bodies in an inactive contact penetrate.
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
    /// it may change the contact force considerably (by about 0.1 %).
    std::optional<EndPenetration>
    end_penetration(const unsigned int c, const SolvedStep &solved) const;
    /// Returns warnings if an end of a body penetrates another body without
    /// contact constraints. Throws MissingEnds if the discretization is `auto`.
    std::vector<std::string>
    warnings_of_ends(const SolvedStep &solved) const;
    /// Adds the forces of contacts created at body ends to those of the
    /// original contacts (ContactPair::part_of) in @p checks and returns these.
    Checks
    with_part_resultants(Checks checks) const;
    /// Returns the largest moment, or force times the size of the scene, of a
    /// load, support or contact: the scale of rounding errors of resultants.
    double
    largest_moment(const SolvedStep &solved) const;
    /// Returns warnings on reactions of isostatic supports (unbalanced loads).
    std::vector<std::string>
    warnings_of_isostatic_supports(const SolvedStep &solved) const;
    /// Returns the indices of the contacts that note_on_idle_contacts() names.
    std::vector<unsigned int>
    idle_contacts() const;
    /// Returns true if contact @p c has been active with strained bodies.
    bool
    has_carried_force(const unsigned int c) const;
    /// Returns warnings on stresses by equilibrium with large defects.
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
