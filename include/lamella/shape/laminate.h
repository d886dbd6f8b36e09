// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_laminate_h
#define lamella_shape_laminate_h

#include <lamella/shape/section_mesh.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// A rectangular laminated section with plies from z = 0 upwards.
  struct Laminate
  {
    double width = 0.; ///< Width along x [length].
    /// Fiber angles of the plies in degrees, bottom to top (see Ply::angle).
    std::vector<double> angles;
    /// Thicknesses of the plies, bottom to top [length], positive.
    std::vector<double> thicknesses;
    /// Names of the materials of the plies, bottom to top.
    std::vector<std::string> materials;
    /// Number of cells through the thickness of each ply, bottom to top; a
    /// single number applies to all plies.
    std::vector<unsigned int> cells_per_ply{1};
    /// Number of equal cells in each interval of the width, from x = 0.
    std::vector<unsigned int> cells_across{1};
    /// Positions x of the boundaries between the intervals of cells_across,
    /// ascending [length].
    std::vector<double> across_breaks{};

    /// Returns the sum of the ply thicknesses [length].
    double
    height() const;

    /// Returns the plies, bottom to top, with material data from @p library.
    /// Throws std::out_of_range if @p library has no material of this name.
    std::vector<Ply>
    plies(const Materials &library) const;
  };

  /// Returns the structured mesh of @p laminate, with the plies' data from
  /// @p materials. Boundary ids 0 to 3 are `left` (x = 0), `right`, `bottom` (z
  /// = 0) and `top`. The material id of a cell is the index of its ply.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Laminate &laminate, const Materials &materials);

  /// The stiffness matrices A, B, D of classical lamination theory, N = A e + B
  /// k, M = B e + D k in the order {yy, xx, xy} with y along the beam (Jones,
  /// Mechanics of Composite Materials, 2nd ed., Eqs. 4.22 to 4.24):
  ///   A = sum_k Q_k (z_k - z_k-1)
  ///   B = 1/2 sum_k Q_k (z_k^2 - z_k-1^2)
  ///   D = 1/3 sum_k Q_k (z_k^3 - z_k-1^3)
  /// Q_k is the plane-stress stiffness of ply k in the body's axes; its faces
  /// are at the distances z_k-1 and z_k from the mid-plane. e and k are strains
  /// and curvatures of the mid-plane, N and M forces and moments per width.
  /// Units are force/length for A, force for B, force times length for D.
  struct LaminateStiffness
  {
    dealii::Tensor<2, 3> A, ///< Extensional stiffness [force / length].
      B,                    ///< Coupling stiffness [force].
      D;                    ///< Bending stiffness [force length].
    /// Axial stiffness EA = b / a_11 [force] of a strip of width b that is free
    /// to contract and twist. a_11 = e_yy / N_yy and d_11 = k_yy / M_yy are
    /// compliances, entries of the inverse of the 6 x 6 matrix [A, B; B, D].
    double EA = 0.;
    double EI = 0.; ///< Bending stiffness EI = b / d_11 [force length^2].
    /// Bending stiffness of a strip that contracts freely but does not twist.
    double EI_untwisted = 0.;
    /// Shear stiffness, int C_yz,yz dA without shear correction factor [force].
    double GA = 0.;
  };

  /// Computes the stiffnesses of a laminate of @p width; plies bottom to top.
  LaminateStiffness
  laminate_stiffness(const std::vector<Ply> &plies, const double width);
} // namespace lamella

#endif
