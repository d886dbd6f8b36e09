// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `solve`: equilibrium. It owns the structure (bodies with supports
// and loads), the strategies for the active set, the loop over load steps, and
// the checks. It never writes files or depends on the type of body.

#ifndef lamella_solve_structure_h
#define lamella_solve_structure_h

#include <lamella/body/body_solver.h>
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
  /// Lengths r_0 at which springs have no force, as [body][spring]; all zero if
  /// empty. The spring force is -k (r(u) - r_0) with length r, stiffness k.
  using SpringOffsets = std::vector<std::vector<double>>;

  /// Discrete model of a scene without contact: bodies with supports, springs
  /// and loads, by the principle of virtual displacements (Eqs. 8 to 11 of
  /// Nagaraj et al. 2020). The stiffness K is block diagonal, since contact
  /// couples the bodies through constraints only. A BlockVector has one block
  /// per body.
  ///
  /// Displacements are u = G v + u_p(t) at load factor t (RowReduction), with
  /// the unconstrained DoFs v, their expansion G and the prescribed
  /// displacements u_p. Solvers use the condensed stiffness
  ///   G^T (K + sum_k s_k r_k^T r_k) G,
  /// where stabilizing spring k has the stiffness s_k and the elongation r_k u.
  /// Each process stores complete vectors; element loops are distributed.
  class Structure
  {
  public:
    /// Eliminates the DoFs prescribed by @p supports, creates the springs and
    /// integrates @p loads; assembles no matrix. @p bodies must not be empty.
    /// @p stabilizations is empty or has one entry per body. Unless the
    /// acceleration @p gravity is zero (scene axes, length / s^2), the weight
    /// is the last load. Throws InputError if a region is not in its body,
    /// supports contradict each other, or a body has an unconstrained
    /// rigid-body motion and no stabilization. Collective.
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

    /// Returns the elimination of the DoFs of @p body that supports prescribe.
    const RowReduction &
    reduction(const unsigned int body) const
    {
      return *reductions[body];
    }

    /// Returns the support conditions of all bodies, linear equations for the
    /// displacements, in the order of RowReduction::multipliers().
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

    /// Returns the resultants of all loads in the order of the scene, then of
    /// the weight, at load factor 1: force and moment about the scene origin.
    const std::vector<LoadResultant> &
    load_resultants() const
    {
      return resultants;
    }

    /// Returns true if any body has stabilizing springs.
    bool
    has_springs() const;

    /// Returns the lengths of all springs at the displacements @p u. If used as
    /// offsets, all spring forces are zero at @p u.
    SpringOffsets
    spring_lengths(const BlockVector &u) const;

    /// Returns the load vector in all DoFs at load factor @p factor and
    /// displacements @p u, which follower loads depend on.
    BlockVector
    load(const LoadFactor &factor, const BlockVector &u) const;

    /// Returns the load vector of the undeformed bodies at @p factor.
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

    /// Adds to @p f this process's share of the change of the follower loads at
    /// load factor @p factor due to the increment @p w of the displacements @p
    /// u.
    void
    add_derivative_of_loads(const LoadFactor  &factor,
                            const BlockVector &u,
                            const BlockVector &w,
                            BlockVector       &f) const;

    /// Throws NumericsError if an element is inside out at @p u, that is, det F
    /// <= 0 at one of its Gauss points. Collective.
    void
    check_orientation(const BlockVector &u) const;

    /// Calls @p use with this process's tangent stiffness of each follower load
    /// (FollowerLoad) on @p body at load factor @p factor and displacements @p
    /// u. If @p with_values is false, the blocks contain the DoFs only.
    void
    for_each_block_of_loads(const unsigned int   body,
                            const LoadFactor    &factor,
                            const Vector        &u,
                            const bool           with_values,
                            const BlockCallback &use) const;

    /// Returns the load vector of the thermal strains; zero without
    /// temperatures, and for finite rotations, where load() includes it.
    const BlockVector &
    thermal_load() const
    {
      return initial_load;
    }

    /// Returns true if any body has a temperature load.
    bool
    is_heated() const;

    /// Returns true if all loads and prescribed displacements are proportional
    /// to the load factor of the scene, for linear structures.
    bool
    is_proportional() const
    {
      return histories.size() == 1 && !is_heated();
    }

    /// Returns true if any body has finite rotations.
    bool
    has_finite_rotations() const;

    /// Returns the energy integral of the thermal strains epsilon_0 over all
    /// bodies, with the stiffness C: int epsilon_0 . C epsilon_0 / 2 dV.
    double
    thermal_energy() const
    {
      return std::accumulate(initial_energies.begin(),
                             initial_energies.end(),
                             0.);
    }

    /// Returns the energy of the thermal strains of @p body.
    double
    thermal_energy(const unsigned int body) const
    {
      return initial_energies[body];
    }

    /// Returns the block sizes of vectors: the number of DoFs of each body.
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

    /// Returns the prescribed displacements at load factor @p factor for small
    /// rotations, zero in free DoFs.
    BlockVector
    particular(const LoadFactor &factor) const;

    /// Returns true if @p row, a linear functional of the displacements of a
    /// body, is always zero due to supports or the beam theory.
    bool
    holds(const BodyFunctional &row) const;

    /// Returns the stiffness matrices of the springs of @p body, s_k r_k^T r_k
    /// with spring stiffness s_k and length gradient r_k.
    std::vector<SpringTerm>
    spring_terms(const unsigned int body) const;

    /// Returns the largest diagonal entry of the stiffness of @p body in its
    /// free DoFs at zero displacements. The first call assembles the matrix,
    /// the result is stored. Collective.
    double
    largest_stiffness(const unsigned int body) const;

    /// Returns the unbalanced forces in all DoFs, without contact forces,
    ///   r = f(t) + f_0 - integral B^T C (B u) dV
    ///       - sum_k s_k (r_k(u) - r_0k) r_k^T,
    /// with the load vector f at t = @p factor, the thermal load f_0, strains B
    /// u, stiffness C, and for spring k the stiffness s_k, the length r_k and
    /// its offset r_0k = @p rest. Strains are computed at each quadrature
    /// point, which loses no digits for slender bodies. Collective.
    BlockVector
    residual(const BlockVector   &u,
             const LoadFactor    &factor,
             const SpringOffsets &rest = {}) const;

    /// Returns the internal forces of bodies and springs with offsets @p rest.
    BlockVector
    internal_forces(const BlockVector &u, const SpringOffsets &rest = {}) const;

    /// Returns the displacements @p u, updated by the increment @p change.
    /// Finite rotations are composed, not added (Body::retract()).
    BlockVector
    retract(const BlockVector &u, const BlockVector &change) const;

    /// Condenses the forces @p r in place onto the free DoFs.
    void
    condense(BlockVector &r) const;

  private:
    /// Returns the displacements that supports of the load history of index @p
    /// history prescribe at load factor 1. Throws InputError with support @p
    /// names if linearly dependent conditions have different histories.
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

    /// Throws InputError for an unconstrained body without stabilization.
    void
    check_rigid_motions(const std::vector<Stabilization> &stabilizations) const;

    Bodies all_bodies;
    /// Support conditions of all bodies.
    std::vector<PrescribedFunctional> rows;
    /// Elimination of prescribed DoFs, and springs, of each body.
    std::vector<std::unique_ptr<RowReduction>> reductions;
    std::vector<std::vector<Spring>>           all_springs;
    /// Load and prescribed displacements of a load history at load factor 1.
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
    /// Cached largest_stiffness(), 0 if unknown.
    mutable std::vector<double> stiffest;
  };
} // namespace lamella

#endif
