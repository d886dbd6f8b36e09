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
  /// A rectangular laminated section: what a scene says of one.
  struct Laminate
  {
    double                   width = 0.;
    std::vector<double>      angles;
    std::vector<double>      thicknesses;
    std::vector<std::string> materials;
    /// Through the thickness, one number for all plies or one a ply.
    std::vector<unsigned int> cells_per_ply{1};
    /// Across the width, one number for each piece between @p across_breaks,
    /// positions that ascend between 0 and the width.
    std::vector<unsigned int> cells_across{1};
    std::vector<double>       across_breaks{};

    /// Sum of the ply thicknesses.
    double
    height() const;

    /// The plies, bottom to top, of the materials in @p library.
    std::vector<Ply>
    plies(const Materials &library) const;
  };

  /**
   * The structured mesh of @p laminate, cells_across times cells_per_ply
   * quadrilaterals a ply, with boundaries `left` (x = 0), `right`, `bottom` (z
   * = 0) and `top`.
   */
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Laminate &laminate, const Materials &materials);

  /**
   * Classical lamination theory of a stack of plies, about the mid-plane:
   * N = A e + B k, M = B e + D k in the order {yy, xx, xy}, y along the beam
   * (Jones, Mechanics of Composite Materials, 2nd ed., Eqs. 4.22 to 4.24).
   */
  struct LaminateStiffness
  {
    dealii::Tensor<2, 3> A, B, D;
    /// Of a strip of the laminate's width, free to contract and twist: from the
    /// inverse of the 6 x 6 matrix of A, B, D (force; force x length^2).
    double EA = 0., EI = 0.;
    /// EI of a strip that is free to contract but held against twist: what
    /// bends where sections cannot follow the coupling of bending and twist.
    double EI_untwisted = 0.;
    /// The integral of G_yz over the section, without a shear correction.
    double GA = 0.;
  };

  LaminateStiffness
  laminate_stiffness(const std::vector<Ply> &plies, const double width);
} // namespace lamella

#endif
