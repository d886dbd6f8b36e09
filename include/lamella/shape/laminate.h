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
  /// A rectangular laminated section: what a scene says of one. Plies lie flat,
  /// one on the other, from z = 0 upwards, and all have the whole width.
  /// `angles`, `thicknesses` and `materials` have one entry a ply, bottom to
  /// top.
  struct Laminate
  {
    /// Along x [length].
    double width = 0.;
    /// Degrees, as of Ply::angle.
    std::vector<double> angles;
    /// [length], all positive.
    std::vector<double> thicknesses;
    /// Names in the scene.
    std::vector<std::string> materials;
    /// Through the thickness, one number for all plies or one a ply.
    std::vector<unsigned int> cells_per_ply{1};
    /// Across the width, one number for each piece between @p across_breaks,
    /// positions that ascend between 0 and the width. The pieces are one more
    /// than the breaks. Cells of a piece are equally wide.
    std::vector<unsigned int> cells_across{1};
    std::vector<double>       across_breaks{};

    /// Sum of the ply thicknesses [length].
    double
    height() const;

    /// The plies, bottom to top, of the materials in @p library. Their bottom
    /// and top follow from the thicknesses. Throws std::out_of_range for a
    /// material that is not there.
    std::vector<Ply>
    plies(const Materials &library) const;
  };

  /**
   * The structured mesh of @p laminate, cells_across times cells_per_ply
   * quadrilaterals a ply, with boundaries `left` (x = 0), `right`, `bottom` (z
   * = 0) and `top`. The material id of a cell is the number of its ply, bottom
   * to top: interfaces are lines of the mesh. Boundary ids are 0 to 3 in the
   * order above.
   */
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Laminate &laminate, const Materials &materials);

  /**
   * Classical lamination theory of a stack of plies, about the mid-plane: N = A
   * e + B k, M = B e + D k in the order {yy, xx, xy}, y along the beam (Jones,
   * Mechanics of Composite Materials, 2nd ed., Eqs. 4.22 to 4.24).
   *
   *   A = sum_k Q_k (z_k - z_k-1)
   *   B = 1/2 sum_k Q_k (z_k^2 - z_k-1^2)
   *   D = 1/3 sum_k Q_k (z_k^3 - z_k-1^3)
   *
   * with Q_k the plane-stress stiffness of ply k in the body's axes (sigma_zz,
   * sigma_xz and sigma_yz condensed out of C), z from the mid-plane, e the
   * strains of the mid-plane and k its curvatures, N and M forces and moments
   * per width. A is in force/length, B in force, D in force times length. No
   * theory of the program uses it: it is what a run's results are compared
   * with, and what notes on the choice of a theory are made of.
   */
  struct LaminateStiffness
  {
    dealii::Tensor<2, 3> A, B, D;
    /// Of a strip of the laminate's width, free to contract and twist: from the
    /// inverse of the 6 x 6 matrix of A, B, D (force; force x length^2). EA = b
    /// / a_11 and EI = b / d_11 with the width b and the compliances a_11 (of
    /// e_yy to N_yy) and d_11 (of k_yy to M_yy).
    double EA = 0., EI = 0.;
    /// EI of a strip that is free to contract but held against twist: what
    /// bends where sections cannot follow the coupling of bending and twist.
    /// The same with the row and column of k_xy left out [force x length^2].
    double EI_untwisted = 0.;
    /// The integral of G_yz over the section, without a shear correction:
    /// C_yz,yz times the area of each ply [force]. Timoshenko's shear stiffness
    /// is this times a shear factor.
    double GA = 0.;
  };

  /// @p plies bottom to top, touching, the lowest from z = 0 on, as those of
  /// Laminate::plies(); @p width is b [length].
  LaminateStiffness
  laminate_stiffness(const std::vector<Ply> &plies, const double width);
} // namespace lamella

#endif
