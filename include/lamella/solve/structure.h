// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `solve`: equilibrium. It owns the structure (bodies with what holds
// and loads them), the strategies that find which gap rows carry force, the
// loop over load steps, the checks of what came out, and Results, which is all
// that others need of a run. It never writes a file and never knows what a beam
// or a solid is.

#ifndef lamella_solve_structure_h
#define lamella_solve_structure_h

#include <lamella/conditions/load.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/conditions/stabilisation.h>
#include <lamella/conditions/support.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// What each stabilising spring of each body measures where it is without
  /// force; empty: nothing.
  using SpringRest = std::vector<std::vector<double>>;

  /**
   * The linear part of a scene: bodies with their supports and loads. Contact
   * couples the bodies through rows only, so each has its own matrix.
   *
   * Displacements are u = G v + t u_p at load factor t (RowReduction).
   */
  class Structure
  {
  public:
    /**
     * @p stabilisations has one for each body, or is empty: none. Throws
     * InputError if a region is not in its body, if supports contradict each
     * other, or if a body can still move and has no stabilisation (the message
     * names how).
     */
    Structure(Bodies                            bodies,
              const std::vector<Support>       &supports,
              const std::vector<Load>          &loads,
              const std::vector<Stabilisation> &stabilisations = {});

    const Bodies &
    bodies() const
    {
      return all_bodies;
    }

    const RowReduction &
    reduction(const unsigned int body) const
    {
      return *reductions[body];
    }

    /// The prescribed rows of all supports.
    const std::vector<PrescribedRow> &
    prescribed() const
    {
      return rows;
    }

    /// The stabilising springs of @p body.
    const std::vector<Spring> &
    springs(const unsigned int body) const
    {
      return all_springs[body];
    }

    /// Of each load what it is in all, at load factor 1.
    const std::vector<LoadResultant> &
    load_resultants() const
    {
      return resultants;
    }

    bool
    has_springs() const;

    /// What the springs of all bodies measure in the state @p u.
    SpringRest
    spring_lengths(const BlockVector &u) const;

    /// The load vector at load factor 1.
    const BlockVector &
    load() const
    {
      return unit_load;
    }

    DofIndex
    n_dofs() const;

    /// The diagonal of the box around all bodies: what lengths are compared
    /// with.
    double
    size() const;

    /// A vector of zeros, a block per body.
    BlockVector
    zero() const;

    /// u_p at load factor @p factor.
    BlockVector
    particular(const double factor) const;

    /// Is told, of each body, when work on it begins and ends, when its
    /// stiffness is assembled, and how large its factor becomes before memory
    /// is spent on it.
    struct BodyMonitor
    {
      std::function<void(const Body &)>                     begins, assembled;
      std::function<void(const Body &)>                     ends;
      std::function<void(const Body &, const FactorSize &)> sized;
    };

    /// Makes what solves with the condensed stiffness of each body, as
    /// @p asked.
    void
    make_solvers(const SolverKind   asked   = SolverKind::automatic,
                 const BodyMonitor &monitor = {});

    /// Of make_solvers().
    const LinearSolver &
    solver(const unsigned int body) const;

    /// The largest diagonal entry of the condensed stiffness of @p body.
    double
    largest_stiffness(const unsigned int body) const;

    /// The stabilising springs of @p body as terms of its stiffness.
    std::vector<SpringTerm>
    spring_terms(const unsigned int body) const;

    /// factor * load - integral B^T C (B u) - spring forces, strain first; not
    /// condensed. The springs are without force at @p rest.
    BlockVector
    residual(const BlockVector &u,
             const double       factor,
             const SpringRest  &rest = {}) const;

    /// G^T r in place: the residual that equilibrium sets to zero.
    void
    condense(BlockVector &r) const;

  private:
    void
    check_held(const std::vector<Stabilisation> &stabilisations) const;

    Bodies                                     all_bodies;
    std::vector<PrescribedRow>                 rows;
    std::vector<std::unique_ptr<RowReduction>> reductions;
    std::vector<std::vector<Spring>>           all_springs;
    std::vector<std::unique_ptr<LinearSolver>> solvers;
    /// largest_stiffness() where no solver knows it, once asked for.
    mutable std::vector<double> stiffest;
    BlockVector                 unit_load;
    std::vector<LoadResultant>  resultants;
  };
} // namespace lamella

#endif
