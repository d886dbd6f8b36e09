// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_mass_matrix_h
#define lamella_solve_mass_matrix_h

#include <lamella/solve/structure.h>

#include <vector>

namespace lamella
{
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
} // namespace lamella

#endif
