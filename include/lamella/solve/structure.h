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
#include <lamella/conditions/turning_load.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace lamella
{
  /// The offsets r_0 of the stabilising springs in their law
  /// f = -k (r(u) - r_0): what each spring of each body measures where it is
  /// without force, a length, [body][spring]. Empty: zero for all of them.
  using SpringRest = std::vector<std::vector<double>>;

  /**
   * The linear part of a scene, the discrete form of the principle of virtual
   * displacements (Eqs. 8 to 11) without the work of contact: bodies with
   * their supports, springs and loads. Contact couples the bodies through rows
   * only, so each has its own matrix: the stiffness K of the scene is block
   * diagonal, and a BlockVector has one block a body, in the order of the
   * scene.
   *
   * Displacements are u = G v + u_p(t) at load factor t (RowReduction), where v
   * are the DoFs that supports and the theories' own constraints leave free, G
   * expands them and u_p fulfils the prescribed displacements. What solvers see
   * is the condensed stiffness
   *   G^T (K + sum_k s_k r_k^T r_k) G,
   * with the stabilising springs of stiffness s_k and row r_k.
   *
   * Owns the bodies jointly with whoever else holds the pointers, and alone
   * the reductions and springs. Its tangent at a state, and what solves with
   * it, is a Linearisation. Strategies, checks and reports refer
   * to it, so it has to outlive them. Every process knows all of it and holds
   * whole vectors; what costs most, the elements, they share.
   */
  class Structure
  {
  public:
    /**
     * Makes the prescribed rows of @p supports, eliminates them, makes the
     * springs and integrates @p loads; no matrix yet. @p bodies must not be
     * empty; regions of supports and loads name bodies by their place in it.
     * @p stabilisations has one for each body, or is empty: none. Throws
     * InputError if a region is not in its body, if supports contradict each
     * other, or if a body can still move and has no stabilisation (the message
     * names how). Bodies are heated by the temperatures among @p loads, and
     * their weight under @p gravity (scene axes, length / s^2) is one more
     * load, the last, if that is not zero. Collective.
     */
    Structure(Bodies                            bodies,
              const std::vector<Support>       &supports,
              const std::vector<Load>          &loads,
              const std::vector<Stabilisation> &stabilisations = {},
              const dealii::Tensor<1, 3>       &gravity        = {});

    /// In the order of the scene, which is that of the blocks of vectors.
    const Bodies &
    bodies() const
    {
      return all_bodies;
    }

    /// G and u_p of @p body, and the forces in its prescribed rows.
    const RowReduction &
    reduction(const unsigned int body) const
    {
      return *reductions[body];
    }

    /// The prescribed rows of all supports on all bodies, R u = t d; the
    /// numbers that RowReduction::multipliers() gives are places in here.
    const std::vector<PrescribedRow> &
    prescribed() const
    {
      return rows;
    }

    /// Whether a support turns places of @p body.
    bool
    is_turned(const unsigned int body) const
    {
      return std::any_of(rows.begin(), rows.end(), [&](const auto &row) {
        return row.row.body == body && row.turn;
      });
    }

    /// The stabilising springs of @p body, one for each rigid motion that its
    /// supports leave free; none without a Stabilisation.
    const std::vector<Spring> &
    springs(const unsigned int body) const
    {
      return all_springs[body];
    }

    /// Of each load what it is in all, at load factor 1: force and moment
    /// about the scene's origin, scene axes, in the order of the loads, weight
    /// after them.
    const std::vector<LoadResultant> &
    load_resultants() const
    {
      return resultants;
    }

    /// Whether any body has one: then its solution is to be released from them
    /// (ContactSolver::release_springs()).
    bool
    has_springs() const;

    /// What the springs of all bodies measure in the state @p u, r_k(u): as a
    /// rest it makes them free of force there.
    SpringRest
    spring_lengths(const BlockVector &u) const;

    /// The load vector f(t, u) at load factor t = @p factor, not condensed: all
    /// loads together, f . v is their work on the virtual displacement v
    /// (Eq. 10). Those that depend on the state (TurningLoad) are of @p u; all
    /// others do not ask.
    BlockVector
    load(const LoadFactor &factor, const BlockVector &u) const;

    /// That of the undeformed bodies.
    BlockVector
    load(const LoadFactor &factor) const;

    /// Whether a load on @p body depends on its state.
    bool
    has_turning_loads(const unsigned int body) const
    {
      return !turning[body].empty();
    }

    /// Whether one of these has a derivative that is not symmetric.
    bool
    has_skew_loads() const;

    /// f += df(t, u)/du @p w of these.
    void
    add_derivative_of_loads(const LoadFactor  &factor,
                            const BlockVector &u,
                            const BlockVector &w,
                            BlockVector       &f) const;

    /// What these add to its tangent stiffness at load factor @p factor and
    /// the displacement @p u of the body (TurningLoad).
    void
    for_each_block_of_loads(
      const unsigned int                                 body,
      const LoadFactor                                  &factor,
      const Vector                                      &u,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// The load vector f_0 of heat (Body::add_heat()), which no load factor
    /// multiplies; zero where nothing is heated, and of bodies that turn, where
    /// load() has it.
    const BlockVector &
    heat_load() const
    {
      return initial_load;
    }

    /// Whether any body is.
    bool
    is_heated() const;

    /// Whether any body turns by any angle (Body::turns()).
    bool
    turns() const;

    /// integral epsilon_0 . C epsilon_0 / 2 dV over all bodies: what they would
    /// store if they were heated and held everywhere.
    double
    heat_energy() const
    {
      return std::accumulate(initial_energies.begin(),
                             initial_energies.end(),
                             0.);
    }

    /// That of @p body alone.
    double
    heat_energy(const unsigned int body) const
    {
      return initial_energies[body];
    }

    /// How vectors of the scene are divided among bodies.
    const dealii::BlockIndices &
    blocks() const
    {
      return initial_load.get_block_indices();
    }

    /// DoFs of all bodies, those that supports prescribe among them.
    DofIndex
    n_dofs() const;

    /// The diagonal of the box around all bodies, in scene axes: what lengths
    /// are compared with.
    double
    size() const;

    /// A vector of zeros, a block per body.
    BlockVector
    zero() const;

    /// u_p(t) at load factor t = @p factor: the values that supports prescribe,
    /// and zero in the free DoFs. Of small rotations:
    /// Linearisation::way_to_supports() has those of bodies that turn.
    BlockVector
    particular(const LoadFactor &factor) const;

    /// Whether supports and the theory hold @p row: it is zero in all states,
    /// up to rounding.
    bool
    holds(const BodyRow &row) const;

    /// The stabilising springs of @p body as terms s_k r_k^T r_k of its
    /// stiffness: pairs of row and stiffness (force / length).
    std::vector<SpringTerm>
    spring_terms(const unsigned int body) const;

    /**
     * The unbalanced forces without those of contact,
     *   r = f(t) + f_0 - integral B^T C (B u) dV
     *       - sum_k s_k (r_k(u) - r_0k) r_k^T,
     * t = @p factor, f_0 = heat_load(); not condensed. The springs are without
     * force at @p rest.
     * Strain first: at each quadrature point the strains B u are formed from
     * @p u and the stresses C (B u) integrated, instead of K u with an
     * assembled K. Where a slender body's K loses digits to cancellation this
     * does not, which is why solutions are refined against it. Costs a loop
     * over all elements; collective.
     */
    BlockVector
    residual(const BlockVector &u,
             const LoadFactor  &factor,
             const SpringRest  &rest = {}) const;

    /// integral B^T C (B u) dV + sum_k s_k (r_k(u) - r_0k) r_k^T, likewise:
    /// linear in @p u without a @p rest.
    BlockVector
    internal_forces(const BlockVector &u, const SpringRest &rest = {}) const;

    /// The state that @p change makes of the state @p u (Body::updated()).
    BlockVector
    updated(const BlockVector &u, const BlockVector &change) const;

    /// G^T r in place, zero in the eliminated DoFs: the residual that
    /// equilibrium sets to zero. (What is left in the eliminated ones before
    /// that are the reactions.)
    void
    condense(BlockVector &r) const;

  private:
    /// u_p of the rows that go with @p history, at load factor 1. Throws
    /// InputError if rows that depend on each other do not go the same way;
    /// @p names are those of supports.
    BlockVector
    prescribed_in(const unsigned int              history,
                  const std::vector<std::string> &names) const;

    /// Adds @p load to what its history multiplies or, where it turns along,
    /// to what turns; and what it is in all.
    void
    take(const Load &load);
    void
    take_weight(const dealii::Tensor<1, 3> &gravity);
    /// What heat does to bodies, which know their temperatures.
    void
    take_heat();

    /// Throws InputError, with the @p names of supports, where one turns places
    /// by any angle that another holds elsewhere.
    void
    check_turns(const std::vector<std::string> &names) const;

    /// Throws InputError for the first body with a rigid motion that supports
    /// leave free and no stabilisation holds.
    void
    check_held(const std::vector<Stabilisation> &stabilisations) const;

    Bodies all_bodies;
    /// prescribed().
    std::vector<PrescribedRow> rows;
    /// One a body, as are springs.
    std::vector<std::unique_ptr<RowReduction>> reductions;
    std::vector<std::vector<Spring>>           all_springs;
    /// What each history multiplies at load factor 1, that of the scene first.
    struct OfHistory
    {
      BlockVector load, particular;
    };
    std::vector<OfHistory> histories;
    /// Of each body the loads that turn along, with their histories.
    std::vector<
      std::vector<std::pair<std::unique_ptr<TurningLoad>, unsigned int>>>
                               turning;
    BlockVector                initial_load;
    std::vector<double>        initial_energies;
    std::vector<LoadResultant> resultants;
  };
} // namespace lamella

#endif
