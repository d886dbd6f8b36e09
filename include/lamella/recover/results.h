// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_results_h
#define lamella_recover_results_h

#include <lamella/base/units.h>
#include <lamella/body/body.h>
#include <lamella/contact/contact.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/recover/goal_result.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/modes.h>
#include <lamella/solve/phase.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <complex>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Value of FieldRow::ply for a mean over several plies; tables show 0.
  constexpr unsigned int several_plies = dealii::numbers::invalid_unsigned_int;

  /// Displacement, strains and stresses at a point of a body in one ply.
  struct FieldRow
  {
    std::string body; ///< Name of the body.
    /// Ply, from 0 at the bottom (tables count from 1), or `several_plies`.
    unsigned int ply = 0;
    /// Position in the undeformed scene [length]; for a box its center.
    dealii::Point<3> position;
    FieldSample      sample; ///< Displacement, strains and stresses there.
  };

  /// Fields at one point of an output line (`subsection Line NAME`).
  struct LineRow
  {
    double   s = 0.; ///< Arc length from the start of the line [length].
    FieldRow fields; ///< Fields at the point in one ply.
  };

  /// Fields at one point of an output cut (`subsection Cut NAME`), which has a
  /// grid of points on each section cell.
  struct CutRow
  {
    unsigned int cell = 0; ///< Index of the section cell.
    unsigned int i    = 0; ///< Index of the point along the first side, from 0.
    unsigned int j = 0;  ///< Index of the point along the second side, from 0.
    FieldRow     fields; ///< Fields at the point in the ply of the cell.
  };

  /// Jumps of the traction at the ply interfaces that an output line crosses.
  struct InterfaceJump
  {
    unsigned int interfaces = 0; ///< Number of ply interfaces on the line.
    /// Largest jump of the traction sigma . d, with the unit vector d along the
    /// line, divided by the largest stress component on the line. It is a
    /// discretization error if the line is normal to the plies.
    double of_stress = 0.;
    /// Largest jump of the traction divided by the largest traction on the
    /// line; 0 if the jump is within rounding.
    double of_traction = 0.;
  };

  /// Relative errors of transverse stresses from integrated equilibrium
  /// (`Stress = equilibrium`): the largest difference between the integrated
  /// stresses and the traction on the upper face of the laminate, divided by
  /// the largest transverse stress. A value is empty if the probe, line or cut
  /// requests other stresses.
  struct EquilibriumDefects
  {
    std::vector<std::optional<double>> probes; ///< Error of each probe.
    std::vector<std::optional<double>> lines;  ///< Error of each line.
    std::vector<std::optional<double>> cuts;   ///< Error of each cut.
  };

  /// Serializes a @p number that may be missing (Boost.Serialization).
  template <typename Archive>
  void
  serialize_optional(Archive &archive, std::optional<double> &number)
  {
    bool                has_value = number.has_value();
    double              value     = number.value_or(0.);
    archive &has_value &value;
    number = has_value ? std::optional<double>(value) : std::nullopt;
  }

  /// Smallest reserve factor of a ply by one failure criterion, and its point
  /// (doc/theory/strength.md).
  struct PlyReserve
  {
    unsigned int body = 0;  ///< Index of the body in the scene, from 0.
    unsigned int ply  = 0;  ///< Index of the ply, from 0 at the bottom.
    std::string  criterion; ///< Name of the failure criterion in the scene.
    std::string  mode;      ///< Failure mode, such as `fiber tension`.
    /// Factor on mechanical stresses at which the ply fails; empty if the ply
    /// does not fail at any factor.
    std::optional<double> reserve;
    /// Value of the failure criterion at the computed stresses; 1 at failure.
    double index = 0.;
    /// Position of the point in the undeformed scene [length].
    dealii::Point<3> position;
    /// Angle from axis 2 of the ply to the normal of the fracture plane,
    /// positive towards axis 3 [degrees]; empty if unknown.
    std::optional<double> angle;
    /// Stress error: |element stress - recovered stress| / |recovered stress|.
    double stress_discrepancy = 0.;

    /// Serializes all members (Boost.Serialization).
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &body &ply &criterion &mode &index &position &stress_discrepancy;
      serialize_optional(archive, reserve);
      serialize_optional(archive, angle);
    }
  };

  /// Smallest reserve factor of a ply in one cross-section of a beam.
  struct ReserveAlong
  {
    unsigned int     body = 0; ///< Index of the body in the scene, from 0.
    unsigned int     ply  = 0; ///< Index of the ply, from 0 at the bottom.
    double           s = 0.; ///< Distance from the start of the axis [length].
    dealii::Point<3> position; ///< Point of the undeformed axis [length].
    /// Largest inverse reserve factor by element stresses in the cross-section;
    /// empty if an excluded box of `subsection Strength` contains it.
    std::optional<double> inverse_reserve;
  };

  /// Results at one load factor that the search for first ply failure tried.
  struct FailureTrial
  {
    double load_factor = 0.; ///< Multiplier of all loads of the scene.
    /// Smallest reserve factor of all plies; empty if no ply can fail.
    std::optional<double> reserve;
    Checks                checks; ///< Reactions, contact forces and residuals.
    /// Fields at each probe, one entry per ply, as in StepResults::probes.
    std::vector<std::vector<FieldRow>> probes;
  };

  /// Result of the search for the load factor of first ply failure, at which
  /// the smallest reserve factor is 1.
  struct FirstFailure
  {
    double safe    = 0.; ///< Largest load factor found at which no ply fails.
    double failing = 0.; ///< Smallest load factor found at which a ply fails.
    /// The ply that fails at `failing`; empty if no failure was found.
    std::optional<PlyReserve> where;
    /// Load factors tried in the search, except those without a solution.
    std::vector<FailureTrial> trials;
    /// Warnings about the solution at `failing`, one sentence each.
    std::vector<std::string> warnings;
  };

  /// Results of one contact constraint at the end of a load step.
  struct ContactRow
  {
    /// Position, normal and area of the contact point.
    ContactInterface::Point point;
    double initial_gap = 0.; ///< Gap of the undeformed bodies [length].
    double gap         = 0.; ///< Gap at the end of the load step [length].
    /// Normal contact force, positive in compression [force].
    double force = 0.;
    /// Force on the second side (friction included), and its moment.
    Wrench on_second = {};
    /// Friction results of the contact point.
    struct Friction
    {
      dealii::Tensor<1, 3> shear; ///< Shear force on the second side.
      bool                 slips      = false; ///< True: slip; false: stick.
      double               length     = 0.;    ///< Accumulated slip [length].
      double               dissipated = 0.;    ///< Energy dissipated so far.
    };
    /// Friction results; empty for a contact without friction.
    std::optional<Friction> friction = {};

    /// Returns true if the contact point transmits a force.
    bool
    touches() const
    {
      return force != 0. || (friction && friction->shear.norm() != 0.);
    }
  };

  /// Numbers of contact points that closed and opened in a load step.
  struct StatusChanges
  {
    unsigned int closed = 0; ///< Number of points that came into contact.
    unsigned int opened = 0; ///< Number of points that lost contact.
  };

  /// Results of one load step. Lists have the order of the names in Results.
  struct StepResults
  {
    unsigned int step = 0; ///< Number of the load step, from 1.
    /// Load factor t, which multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    /// Displacements, contact forces, and numbers of iterations.
    State        state;
    Checks       checks; ///< Reactions, contact forces, energies and residuals.
    unsigned int substeps = 1; ///< Number of substeps of the load step.
    /// Relative change of results by the last doubling of substeps; else empty.
    std::optional<double> change = {};
    /// Number of bisections of the load increment because of nonconvergence.
    unsigned int halvings = 0;
    /// Data of the contact algorithm at the end of the step, for a restart.
    StrategyHistory memory;

    /// Fields at each probe: one entry per ply that contains it, bottom first.
    std::vector<std::vector<FieldRow>> probes;
    std::vector<std::vector<LineRow>>  lines; ///< Fields along each line.
    std::vector<std::vector<CutRow>>   cuts;  ///< Fields on each cut.
    std::vector<InterfaceJump>         jumps; ///< Traction jumps of each line.
    std::vector<double>                measures; ///< Value of each measure.
    EquilibriumDefects defects; ///< Errors of `equilibrium` stresses.
    /// Results of the contact points of each contact.
    std::vector<std::vector<ContactRow>> contacts;
    /// Numbers of opened and closed contact points of each contact.
    std::vector<StatusChanges> changes;
    /// Smallest reserve factors, ordered by body, ply and criterion.
    std::vector<PlyReserve> plies;
    /// Reserve factors along beam axes, ordered by body, ply and position.
    std::vector<ReserveAlong> plies_along;

    /// Warnings about this step, one sentence each.
    std::vector<std::string> warnings;

    /// Releases nearly all memory: displacements, contact forces, restart data,
    /// fields, contact points and reserve factors along axes. Checks, jumps,
    /// measures, smallest reserve factors and warnings remain.
    void
    drop_fields();
  };

  /// Harmonic response at a probe in one ply.
  struct HarmonicRow
  {
    double       frequency = 0.; ///< Frequency [Hz].
    unsigned int probe     = 0;  ///< Index of the probe.
    unsigned int ply       = 0;  ///< Ply as in FieldRow.
    /// Complex amplitudes in the order of field_names().
    std::vector<std::complex<double>> values;
  };

  /// Model data of a body in the results.
  struct BodySummary
  {
    std::string  name;     ///< Name in the scene.
    std::string  theory;   ///< Theory in the scene, for example `LE-2`.
    unsigned int dofs = 0; ///< Number of DoFs, including prescribed DoFs.
    /// Statistics of the linear solver; empty for the `full` strategy.
    std::optional<SolverStatistics> solver;
    /// Name of the material of each ply.
    std::vector<std::string> materials = {};
  };

  /// Data of a contact in the results.
  struct ContactSummary
  {
    std::string name;        ///< Name of the contact.
    std::string second_name; ///< Name of the second body or of the obstacle.
    /// Discretization of the constraints, such as node to node.
    Discretization discretization = Discretization::undefined;
    /// Enforcement of the contact law, such as penalty.
    Enforcement  enforcement     = Enforcement::undefined;
    unsigned int rows            = 0;  ///< Number of contact constraints.
    unsigned int unpaired        = 0;  ///< Number of unpaired nodes, side 1.
    unsigned int unpaired_second = 0;  ///< Number of unpaired nodes, side 2.
    double       initial_gap_min = 0.; ///< Smallest initial gap [length].
    double       initial_gap_max = 0.; ///< Largest initial gap [length].
    double       friction        = 0.; ///< Friction coefficient (Coulomb).
    /// Slave surface; null if unknown.
    std::shared_ptr<const SlaveSurface> surface = {};

    /// Returns true for tied surfaces.
    bool
    is_tied() const
    {
      return enforcement == Enforcement::tied;
    }
  };

  /// Results of the analysis of a scene, as copies without references.
  struct Results
  {
    std::string title; ///< Title of the scene.
    Units       units; ///< Labels of the units in which all numbers are given.
    std::vector<BodySummary>    bodies;   ///< Bodies in the order of the scene.
    std::vector<ContactSummary> contacts; ///< Contacts in this order.
    std::vector<std::string>    supports; ///< Names of the supports.
    std::vector<std::string>    probes;   ///< Names of the probes.
    std::vector<std::string>    lines;    ///< Names of the output lines.
    std::vector<std::string>    cuts;     ///< Names of the output cuts.
    std::vector<std::string>    measures; ///< Names of the measures.
    /// Resultant of each load at load factor 1.
    std::vector<LoadResultant> loads;
    /// Mass of all bodies; empty if a density is unknown.
    std::optional<Inertia> inertia;
    double size = 0.; ///< Diagonal of the bounding box of all bodies [length].

    std::vector<StepResults> steps;    ///< Solved load steps, in order.
    unsigned int load_steps = 0;       ///< Number of load steps in the scene.
    bool         converged  = false;   ///< True if all load steps were solved.
    std::vector<std::string> notes;    ///< Notes printed before all warnings.
    std::vector<std::string> endnotes; ///< Notes printed after all warnings.
    /// First ply failure; empty if the scene does not request the search.
    std::optional<FirstFailure> first_failure;
    /// Natural modes about the last load step; empty if not requested.
    std::optional<NaturalModes> natural_modes;
    /// Buckling modes of the last loads, factors ascending.
    std::vector<Mode> buckling_modes;
    /// Steady harmonic response, ordered by frequency, probe and ply.
    std::vector<HarmonicRow> response;
    /// Values of the quantities of subsection Goals in the last load step.
    std::map<std::string, double> quantities;
    /// Quantities of interest with error estimates; empty if not estimated.
    std::vector<GoalResult> goals;
    /// Reason why no errors were estimated; else empty.
    std::string no_goals_reason;
    double      seconds_of_goals = 0.; ///< Wall time of error estimates [s].
    /// Lower bound of the condition number of the stiffness; 0 if unknown.
    double condition_estimate = 0.;

    /// Wall-clock seconds of each phase (phase_names()) and in `total`.
    std::map<std::string, double> seconds;
    unsigned int                  processes = 1; ///< Number of MPI processes.
    double peak_memory = 0.; ///< Peak memory of the largest process [bytes].
    double peak_memory_of_all = 0.; ///< Peak memory of all processes [bytes].

    /// Returns the number of DoFs of all bodies.
    unsigned int
    n_dofs() const;

    /// Returns the notes, the warnings of all load steps (with the step if
    /// there are several), and the endnotes. Warnings that differ by numbers
    /// only are merged, with the numbers of the largest load factor; warnings
    /// that differ by a name are merged with all names.
    std::vector<std::string>
    all_warnings() const;

    /// Returns the largest stiffening and smallest buckling factor.
    NonlinearityEstimate
    worst_nonlinearity() const;

    /// Returns the last solved load step. Throws InputError if there is none.
    const StepResults &
    last() const;

    /// Returns the fields at the probe @p name in the last load step, in the
    /// ply number @p ply (from 1), or if 0 in the lowest ply that contains it.
    /// Throws InputError for an unknown probe, and if it is not in this ply.
    const FieldRow &
    probe(const std::string &name, const unsigned int ply = 0) const;

    /// Returns the reaction force and moment of the support @p name in the last
    /// load step. Throws InputError for an unknown name.
    const Resultant &
    support(const std::string &name) const;
    /// Returns resultant and residuals of the contact @p name in the last load
    /// step. Throws InputError for an unknown name.
    const KktResidual &
    contact(const std::string &name) const;
  };

  /// Returns true if any contact of @p results has friction.
  inline bool
  has_friction(const Results &results)
  {
    return std::any_of(results.contacts.begin(),
                       results.contacts.end(),
                       [](const ContactSummary &contact) {
                         return contact.friction > 0.;
                       });
  }
} // namespace lamella

#endif
