// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_laminate_h
#define lamella_shape_laminate_h

#include <lamella/shape/section_mesh.h>

#include <deal.II/base/tensor.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// A rectangular laminated section, stacked from z = 0 upwards. `angles`,
  /// `thicknesses` and `materials` have one entry per ply, bottom to top.
  struct Laminate
  {
    /// Width along x [length].
    double width = 0.;
    /// Fiber angles in degrees (Ply::angle).
    std::vector<double> angles;
    /// Thicknesses [length], positive.
    std::vector<double> thicknesses;
    /// Names of the materials in the scene.
    std::vector<std::string> materials;
    /// Number of cells through the thickness, for all plies or for each.
    std::vector<unsigned int> cells_per_ply{1};
    /// Number of equal cells across the width, for each piece between
    /// @p across_breaks, ascending positions between 0 and the width.
    std::vector<unsigned int> cells_across{1};
    std::vector<double>       across_breaks{};

    /// Returns the sum of the ply thicknesses [length].
    double
    height() const;

    /// Returns the plies, bottom to top, with materials from @p library. Throws
    /// std::out_of_range for an unknown material.
    std::vector<Ply>
    plies(const Materials &library) const;
  };

  /// Returns the structured mesh of @p laminate, cells_across times
  /// cells_per_ply quadrilaterals per ply. Boundaries 0 to 3 are `left` (x =
  /// 0), `right`, `bottom` (z = 0) and `top`. The material id of a cell is its
  /// ply.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Laminate &laminate, const Materials &materials);

  /**
   * Classical lamination theory of a stack of plies about the mid-plane: N = A
   * e + B k, M = B e + D k in the order {yy, xx, xy}, y along the beam (Jones,
   * Mechanics of Composite Materials, 2nd ed., Eqs. 4.22 to 4.24):
   *   A = sum_k Q_k (z_k - z_k-1)
   *   B = 1/2 sum_k Q_k (z_k^2 - z_k-1^2)
   *   D = 1/3 sum_k Q_k (z_k^3 - z_k-1^3)
   * Q_k is the plane-stress stiffness of ply k in the body's axes, z the
   * distance from the mid-plane. e and k are strains and curvatures of the
   * mid-plane, N and M forces and moments per width. A is in force/length, B in
   * force, D in force times length. Used for comparisons and for notes on
   * theories only.
   */
  struct LaminateStiffness
  {
    dealii::Tensor<2, 3> A, B, D;
    /// Stiffnesses of a strip of the laminate's width b, free to contract and
    /// twist, EA = b / a_11 [force] and EI = b / d_11 [force x length^2]. The
    /// compliances a_11 (of e_yy to N_yy) and d_11 (of k_yy to M_yy) are from
    /// the inverse of the 6 x 6 matrix of A, B, D.
    double EA = 0., EI = 0.;
    /// EI of a strip free to contract, but not to twist [force x length^2].
    double EI_untwisted = 0.;
    /// Integral of C_yz,yz, without a shear correction factor [force].
    double GA = 0.;
  };

  /// Computes the stiffnesses of @p plies (Laminate::plies()) of @p width b.
  LaminateStiffness
  laminate_stiffness(const std::vector<Ply> &plies, const double width);
} // namespace lamella

#endif
