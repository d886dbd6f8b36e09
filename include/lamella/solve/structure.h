// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `solve`: equilibrium. It owns the structure (bodies with supports
// and loads), the strategies for the active set, the loop over load steps, and
// the checks. It never writes files or depends on the type of body.

#ifndef lamella_solve_structure_h
#define lamella_solve_structure_h

#include <lamella/conditions/follower_load.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/conditions/stabilization.h>
#include <lamella/conditions/support.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace lamella
{
  /// Offsets r_0 of the springs with the forces f = -k (r(u) - r_0) [length],
  /// as [body][spring]; all zero if empty.
  using SpringOffsets = std::vector<std::vector<double>>;

  /// Discrete model of a scene without contact, by the principle of virtual
  /// displacements (Eqs. 8 to 11): bodies with supports, springs and loads.
  /// Contact couples the bodies through constraints only, so K is block
  /// diagonal, and a BlockVector has one block per body.
  ///
  /// Displacements are u = G v + u_p(t) at load factor t (RowReduction), with
  /// the DoFs v that are not constrained by supports and theories, their
  /// expansion G and the prescribed displacements u_p. Solvers use the
  /// condensed stiffness
  ///   G^T (K + sum_k s_k r_k^T r_k) G,
  /// with the stabilizing springs of stiffness s_k and row r_k. A
  /// TangentOperator is the tangent at a state with its solvers. Each process
  /// has whole vectors; element work is distributed.
  class Structure
  {
  public:
    /// Eliminates the DoFs prescribed by @p supports, creates the springs and
    /// integrates @p loads; assembles no matrix. @p bodies must not be empty.
    /// @p stabilizations has one entry per body, or none. Temperatures among
    /// @p loads heat the bodies; if not zero, their weight due to the
    /// acceleration @p gravity (scene axes, length / s^2) is added as the last
    /// load. Throws InputError if a region is not in its body, if supports
    /// contradict each other, or if a body has a free rigid motion (which the
    /// message names) and no stabilization. Collective.
    Structure(Bodies                            bodies,
              const std::vector<Support>       &supports,
              const std::vector<Load>          &loads,
              const std::vector<Stabilization> &stabilizations = {},
              const dealii::Tensor<1, 3>       &gravity        = {});

    /// Returns the bodies in the order of the scene and of vector blocks.
    const Bodies &
    bodies() const
    {
      return all_bodies;
    }

    /// Returns the elimination of the prescribed DoFs of @p body: expansion G,
    /// prescribed displacements u_p and reactions.
    const RowReduction &
    reduction(const unsigned int body) const
    {
      return *reductions[body];
    }

    /// Returns the support conditions R u = t d, in the order of their
    /// reactions in RowReduction::multipliers().
    const std::vector<PrescribedFunctional> &
    prescribed() const
    {
      return rows;
    }

    /// Returns true if a support prescribes a rotation of points of @p body.
    bool
    has_prescribed_rotation(const unsigned int body) const
    {
      return std::any_of(rows.begin(), rows.end(), [&](const auto &row) {
        return row.row.body == body && row.rotation;
      });
    }

    /// Returns the stabilizing springs of @p body, one per free rigid motion.
    const std::vector<Spring> &
    springs(const unsigned int body) const
    {
      return all_springs[body];
    }

    /// Returns the resultants of all loads, then of the weight, at load factor
    /// 1: force and moment about the scene origin, scene axes.
    const std::vector<LoadResultant> &
    load_resultants() const
    {
      return resultants;
    }

    /// Returns true if any body has stabilizing springs.
    bool
    has_springs() const;

    /// Returns the lengths r_k(u) of all springs. As offsets, these make all
    /// spring forces zero at @p u.
    SpringOffsets
    spring_lengths(const BlockVector &u) const;

    /// Returns the load vector f at load factor @p factor and displacements
    /// @p u, in all DoFs: f . v is the work of all loads on v.
    BlockVector
    load(const LoadFactor &factor, const BlockVector &u) const;

    /// Returns the load vector of the undeformed bodies.
    BlockVector
    load(const LoadFactor &factor) const;

    /// Returns true if a load on @p body depends on its displacements.
    bool
    has_follower_loads(const unsigned int body) const
    {
      return !follower_loads[body].empty();
    }

    /// Returns true if a follower load has an unsymmetric derivative.
    bool
    has_unsymmetric_loads() const;

    /// Adds to @p f the change (df/du) w of the follower loads f at load factor
    /// @p factor due to an increment @p w of the displacements @p u.
    void
    add_derivative_of_loads(const LoadFactor  &factor,
                            const BlockVector &u,
                            const BlockVector &w,
                            BlockVector       &f) const;

    /// Calls @p use with the tangent contributions of the follower loads on
    /// @p body at load factor @p factor and displacement @p u (FollowerLoad).
    void
    for_each_block_of_loads(
      const unsigned int                                 body,
      const LoadFactor                                  &factor,
      const Vector                                      &u,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Returns the thermal load vector f_0 (Body::add_thermal_load()). Zero for
    /// unheated bodies, and for finite rotations, where load() includes it.
    const BlockVector &
    thermal_load() const
    {
      return initial_load;
    }

    /// Returns true if any body is heated.
    bool
    is_heated() const;

    /// Returns true if any body has finite rotations.
    bool
    has_finite_rotations() const;

    /// Returns the energy integral epsilon_0 . C epsilon_0 / 2 dV of the
    /// thermal strains epsilon_0 over all bodies.
    double
    thermal_energy() const
    {
      return std::accumulate(initial_energies.begin(),
                             initial_energies.end(),
                             0.);
    }

    /// Returns the energy of the thermal strains of @p body alone.
    double
    thermal_energy(const unsigned int body) const
    {
      return initial_energies[body];
    }

    /// Returns the block sizes of vectors, the numbers of DoFs of the bodies.
    const dealii::BlockIndices &
    blocks() const
    {
      return initial_load.get_block_indices();
    }

    /// Returns the number of DoFs of all bodies, including prescribed DoFs.
    DofIndex
    n_dofs() const;

    /// Returns the diagonal of the bounding box of all bodies.
    double
    size() const;

    /// Returns a vector of zeros, one block per body.
    BlockVector
    zero() const;

    /// Returns u_p(t) at load factor t = @p factor for small rotations, zero in
    /// free DoFs (see TangentOperator::support_increment()).
    BlockVector
    particular(const LoadFactor &factor) const;

    /// Returns true if supports, or the beam theory, keep the functional @p row
    /// at zero for all displacements.
    bool
    holds(const BodyFunctional &row) const;

    /// Returns the springs of @p body as terms s_k r_k^T r_k of its stiffness.
    std::vector<SpringTerm>
    spring_terms(const unsigned int body) const;

    /// Returns the unbalanced forces in all DoFs, without contact forces,
    ///   r = f(t) + f_0 - integral B^T C (B u) dV
    ///       - sum_k s_k (r_k(u) - r_0k) r_k^T,
    /// with t = @p factor, f_0 = thermal_load() and the spring offsets @p rest
    /// (r_0k). Strains B u are computed at each quadrature point. Unlike a
    /// product with the assembled K, they lose no digits in slender bodies:
    /// solutions are refined against this residual. Collective.
    BlockVector
    residual(const BlockVector   &u,
             const LoadFactor    &factor,
             const SpringOffsets &rest = {}) const;

    /// Returns integral B^T C (B u) dV + sum_k s_k (r_k(u) - r_0k) r_k^T.
    BlockVector
    internal_forces(const BlockVector &u, const SpringOffsets &rest = {}) const;

    /// Returns @p u updated by the increment @p change (Body::retract()).
    BlockVector
    retract(const BlockVector &u, const BlockVector &change) const;

    /// Condenses the forces @p r in place onto the free DoFs (G^T r).
    void
    condense(BlockVector &r) const;

  private:
    /// Returns the displacements that supports with load history @p history
    /// prescribe at load factor 1. Throws InputError with support @p names if
    /// dependent conditions have different histories.
    BlockVector
    prescribed_in(const unsigned int              history,
                  const std::vector<std::string> &names) const;

    /// Adds @p load to the loads of its history, or to the follower loads.
    void
    take(const Load &load);
    void
    assemble_weight(const dealii::Tensor<1, 3> &gravity);
    /// Adds the thermal loads of the bodies with temperatures.
    void
    assemble_thermal_load();

    /// Throws InputError with support @p names if a support prescribes a finite
    /// rotation of points that another support prescribes differently.
    void
    check_rotations(const std::vector<std::string> &names) const;

    /// Throws InputError for the first free rigid motion without stabilization.
    void
    check_rigid_motions(const std::vector<Stabilization> &stabilizations) const;

    Bodies all_bodies;
    /// Support conditions of all supports.
    std::vector<PrescribedFunctional> rows;
    /// Reduction and springs of each body.
    std::vector<std::unique_ptr<RowReduction>> reductions;
    std::vector<std::vector<Spring>>           all_springs;
    /// Load and prescribed displacements of each load history at load factor 1.
    struct OfHistory
    {
      BlockVector load, particular;
    };
    std::vector<OfHistory> histories;
    /// Follower loads of each body, with the numbers of their load histories.
    std::vector<
      std::vector<std::pair<std::unique_ptr<FollowerLoad>, unsigned int>>>
                               follower_loads;
    BlockVector                initial_load;
    std::vector<double>        initial_energies;
    std::vector<LoadResultant> resultants;
  };
} // namespace lamella

#endif
