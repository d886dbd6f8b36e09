// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_small_motions_h
#define lamella_solve_small_motions_h

#include <lamella/body/second_order.h>
#include <lamella/linear/eigenpairs.h>
#include <lamella/solve/linear_system.h>
#include <lamella/solve/structure.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// The geometric stiffness K_G of the linear and membrane stresses of a state
  /// of linear kinematics, and the energy of the membrane stresses
  /// (SecondOrder).
  class GeometricStiffness
  {
  public:
    /// Computes the stresses at @p state, which @p solver has solved: one
    /// linear system with fixed active constraints. Collective.
    GeometricStiffness(LinearSystem &solver, const State &state);

    /// Returns K_G @p v. Collective.
    BlockVector
    operator()(const BlockVector &v) const;

    /// Returns the strain energy of the membrane stress of each body.
    const std::vector<double> &
    membrane_energies() const
    {
      return energies;
    }

    /// Returns the largest SecondOrder::largest_short_wave_ratio().
    double
    largest_short_wave_ratio() const;

  private:
    std::vector<std::unique_ptr<SecondOrder>> bodies;
    std::vector<double>                       energies;
  };

  /// The linear equations of small motions of a structure about an equilibrium
  /// state, for eigenvalue problems:
  ///   (K + K_G) v = f + B^T lambda,   B v + a lambda = 0,
  /// with the tangent stiffness K without stabilizing springs, an optional
  /// geometric stiffness K_G, and the constraints B of all closed gaps and the
  /// slips of closed points with friction, which stick (compliance a of penalty
  /// contacts). Uses the factorizations of a LinearSystem.
  ///
  /// The factors contain stabilizing springs S^T S (rows sqrt(k) r of each
  /// spring). With solutions Z = K_s^-1 S^T of the system with springs and G =
  /// S Z, Woodbury's formula K^-1 = K_s^-1 + Z (1 - G)^-1 Z^T removes them.
  /// Eigenvectors q of G with eigenvalue 1 belong to rigid motions Z q, which
  /// springs alone hold. Solutions are then restricted to forces in equilibrium
  /// and to motions v with R^T M v = 0 for the rigid motions R (FETI: Farhat
  /// and Roux, Int. J. Numer. Meth. Engng 32 (1991) 1205-1227).
  class SmallMotions
  {
  public:
    /// Prepares the equations about @p state, which @p system has solved. @p
    /// weight is the product with the mass matrix M or another weight; it
    /// must not be empty. @p prestress is the product with K_G, or empty.
    /// Keeps references. Collective, as are all functions.
    SmallMotions(LinearSystem  &system,
                 const State   &state,
                 const Operator weight,
                 const Operator prestress = {});

    /// Returns (K + K_G + sum b a^-1 b^T) @p v, with the constraints b of
    /// closed gaps that have a compliance a; internal forces are computed from
    /// strains.
    BlockVector
    times_stiffness(const BlockVector &v) const;

    /// Returns the solution for the forces @p f, of which the part that
    /// accelerates rigid motions is subtracted.
    BlockVector
    solve(const BlockVector &f) const;

    /// Returns the rigid motions R with R^T M R = 1 that supports and closed
    /// contacts leave free, except those without mass.
    const std::vector<BlockVector> &
    rigid_motions() const
    {
      return rigid;
    }

    /// Returns the largest |B @p v| of closed constraints.
    double
    largest_jump(const BlockVector &v) const;

    /// Returns the dimension of the space of solutions.
    unsigned int
    n_free_dofs() const;

  private:
    /// Returns the solution of K_s v = f + B^T lambda with springs, refined.
    BlockVector
    solve_with_springs(const BlockVector &f) const;
    /// Returns the solution without geometric stiffness.
    BlockVector
    solve_without_prestress(BlockVector f) const;
    /// Returns the relative error of a solution without refinement.
    double
    error_without_refinement();
    /// Sets `refinements` such that a solution whose error would be @p error
    /// without refinement has the relative error @p wanted.
    void
    choose_refinements(const double error, const double wanted);
    /// Sets `correction` and the rigid motions.
    void
    remove_springs();
    void
    add_rigid_motion(BlockVector motion);
    /// Subtracts the parts of @p v along rigid motions.
    void
    subtract_rigid_motions(BlockVector &v) const;

    LinearSystem           &system;
    const Structure        &structure;
    const GapConstraints   &rows;
    const ActiveConstraints closed;
    const Operator          weight, prestress;
    /// Number of corrections by iterative refinement of each solution.
    unsigned int refinements = 0;
    /// Springs, with sqrt(k) times their functionals, and Z.
    std::vector<BodyFunctional> springs;
    std::vector<BlockVector>    Z;
    /// Rows: (1 - G)^-1 in eigenvectors of G, without rigid motions.
    dealii::FullMatrix<double> correction;
    std::vector<BlockVector>   rigid, weighted_rigid;
  };

  /// The consistent mass matrix M = int rho R^T R dV of a structure, with the
  /// density rho and the displacement functionals R of its DoFs: one sparse
  /// matrix per body, in all DoFs, also prescribed ones (virtual work of the
  /// inertial forces, delta u . M u'').
  class MassMatrix
  {
  public:
    /// Assembles the matrix of @p structure at the displacements @p u. Throws
    /// InputError if a density is unknown. Collective.
    MassMatrix(const Structure &structure, const BlockVector &u);

    /// Returns M @p v. Collective.
    BlockVector
    operator()(const BlockVector &v) const;

    /// Returns the kinetic energy v . M v / 2 of each body for velocities @p v.
    std::vector<double>
    energies(const BlockVector &v) const;

  private:
    std::vector<dealii::SparsityPattern> patterns;
    std::vector<Matrix>                  matrices;
  };

  /// The equations of small vibrations of a structure about a state.
  struct VibrationEquations
  {
    /// Prepares the equations about @p state, which @p system has solved, with
    /// the geometric stiffness @p prestress or null. Keeps references. Throws
    /// as MassMatrix and SmallMotions do. Collective.
    VibrationEquations(LinearSystem             &system,
                       const State              &state,
                       const GeometricStiffness *prestress);

    VibrationEquations(const VibrationEquations &) = delete;

    LinearSystem             &system;    ///< Stiffness and closed contacts.
    const State              &state;     ///< Equilibrium state.
    const GeometricStiffness *prestress; ///< K_G or null.
    const MassMatrix          mass;      ///< Mass matrix M.
    const SmallMotions        motions;   ///< Stiffness K + K_G.
  };

  /// Returns the rigid motions of all bodies together at the displacements @p
  /// u: translations along the scene axes, and rotations about @p center.
  std::vector<BlockVector>
  rigid_motions_about(const Structure        &structure,
                      const BlockVector      &u,
                      const dealii::Point<3> &center);
} // namespace lamella

#endif
