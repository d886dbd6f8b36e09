// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_linearisation_h
#define lamella_solve_linearisation_h

#include <lamella/solve/structure.h>

#include <functional>
#include <memory>
#include <vector>

namespace lamella
{
  /**
   * What belongs to one state u of a structure: its tangent stiffness there,
   *   K(u) = d f_int / du,
   * the springs' with it, as terms that a matrix is assembled from, as a
   * product, and, where they are made, as solvers of each body. Whoever solves,
   * takes compliances or duals refers to one of these and never to a structure,
   * so that no stiffness is there without the state that it is of. It does not
   * change: another state has another one. As long as all bodies are linear
   * that of u = 0 is that of every state, and a run has one for good.
   *
   * Refers to the structure, which must outlive it. Collective.
   */
  class Linearisation
  {
  public:
    /// Callbacks for each body: at the begin and end of its work, after the
    /// assembly of its stiffness, and with the size of its factor before memory
    /// is allocated. Each may be empty. An exception of `sized` prevents the
    /// factorization.
    struct BodyMonitor
    {
      std::function<void(const Body &)>                     begins, assembled;
      std::function<void(const Body &)>                     ends;
      std::function<void(const Body &, const FactorSize &)> sized;
    };

    /// About @p u, without solvers: what the `full` strategy assembles.
    Linearisation(const Structure   &structure,
                  const BlockVector &u,
                  const LoadFactor  &factor = LoadFactor());

    /// About @p u, with what solves with the condensed stiffness of each body,
    /// as @p asked; after the @p correction that led to u, if there is one
    /// (Body::make_tangent_solver()). Loads that turn along add theirs at load
    /// factor @p factor, and to the solvers only, as are more @p springs of
    /// each body. Throws LostDigits where one is not positive definite in
    /// doubles, InputError as Body::solver_kind() does, and what @p monitor
    /// throws.
    Linearisation(const Structure   &structure,
                  const BlockVector &u,
                  const SolverKind   asked,
                  const BodyMonitor &monitor    = {},
                  const BlockVector &correction = BlockVector(),
                  const LoadFactor  &factor     = LoadFactor(),
                  const std::vector<std::vector<SpringTerm>> &springs = {});

    const Structure &
    of() const
    {
      return structure;
    }

    /// The prescribed rows of all supports as functionals of changes of the
    /// state, and G of @p body with them: those of the structure but for bodies
    /// whose rows turn.
    const std::vector<PrescribedRow> &
    prescribed() const
    {
      return moved_rows.empty() ? structure.prescribed() : moved_rows;
    }
    const RowReduction &
    reduction(const unsigned int body) const
    {
      return moved_reductions.empty() || moved_reductions[body] == nullptr ?
               structure.reduction(body) :
               *moved_reductions[body];
    }

    /// G^T r in place, zero in the eliminated DoFs.
    void
    condense(BlockVector &r) const;

    /// What supports move bodies by from load factor @p from, that of the
    /// state, to @p to. Where rows turn, or supports do (RigidTurn), it is what
    /// takes the state to where the supports are then, to the first order: what
    /// is of second order compresses a beam that has not bent yet.
    BlockVector
    way_to_supports(const LoadFactor &from, const LoadFactor &to) const;

    /// The place of a support that is off what it prescribes, and how far as a
    /// share of what it may be off by.
    struct Missed
    {
      dealii::Point<3> place;
      double           share = 0.;
    };
    /// The one that is off the most at load factor @p at of the rows that no
    /// correction follows, which may be by what turns put warpings off.
    Missed
    missed_most(const LoadFactor &at) const;

    /// What K(u) of @p body is assembled from, its springs among it.
    StiffnessTerms
    terms(const unsigned int body) const;

    /// K(u) @p w of all bodies and springs, not condensed; strain first, as
    /// Structure::internal_forces() is.
    BlockVector
    apply(const BlockVector &w) const;

    /// What solves with the condensed stiffness of @p body, if this has solvers
    /// (an assertion fails otherwise).
    const LinearSolver &
    solver(const unsigned int body) const;

    /// K(u)^-1 @p r, which need not be condensed; zero in what supports
    /// prescribe. With solvers. Loads that turn along have a part of the
    /// tangent that is not symmetric, A, in no factor: with it x is that of
    ///   (1 + K^-1 A) x = K^-1 r,
    /// by GMRES, or K^-1 r if that does not come to an end.
    BlockVector
    solve(BlockVector r) const;

    /// The largest diagonal entry of the condensed stiffness of @p body, force
    /// over length where the DoF is a displacement. Where there are no solvers
    /// (`full`) the first call assembles the body's matrix to see.
    double
    largest_stiffness(const unsigned int body) const;

    /// The largest estimate of a condition number of the bodies' stiffnesses, a
    /// lower bound; 0 if unknown.
    double
    condition_estimate() const;

  private:
    /// Makes the rows and reductions of bodies whose rows turn.
    void
    move_supports();

    /// What solves with the stiffness of @p body and its @p springs.
    std::unique_ptr<LinearSolver>
    make_solver(const unsigned int             body,
                const SolverKind               asked,
                const Vector                  &correction,
                const std::vector<SpringTerm> &springs,
                const SolverMonitor           &monitor) const;

    /// K^-1 @p r.
    BlockVector
    solve_symmetric(BlockVector r) const;
    /// A @p w.
    BlockVector
    skew_part(const BlockVector &w) const;

    const Structure                           &structure;
    const BlockVector                          state;
    const LoadFactor                           factor;
    std::vector<std::unique_ptr<LinearSolver>> solvers;
    /// Where no rows turn empty; of each row what it measures in the state.
    std::vector<PrescribedRow>                 moved_rows;
    std::vector<double>                        measured;
    std::vector<std::unique_ptr<RowReduction>> moved_reductions;
    /// largest_stiffness() where no solver knows it, once asked for.
    mutable std::vector<double> stiffest;
  };

  /// That of u = 0 with solvers: of linear bodies the one there is.
  std::shared_ptr<const Linearisation>
  linearised(const Structure                  &structure,
             const SolverKind                  asked   = SolverKind::automatic,
             const Linearisation::BodyMonitor &monitor = {});

  /// That of u = 0 without solvers: what the `full` strategy takes.
  std::shared_ptr<const Linearisation>
  linearised_without_solvers(const Structure &structure);
} // namespace lamella

#endif
