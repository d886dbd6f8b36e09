// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_h
#define lamella_section_section_h

#include <lamella/base/linear_algebra.h>
#include <lamella/section/cross_section_element.h>

#include <boost/geometry/index/rtree.hpp>

#include <deal.II/numerics/rtree.h>

#include <memory>
#include <vector>

namespace lamella
{
  /**
   * A field of the section, Phi_alpha(x, z) in R^3: a sum of expansion
   * functions F_tau times unit vectors. Most have one term. The in-plane linear
   * functions enter as the rotation about the axis (u_x = z, u_z = -x) and the
   * in-plane shear (u_x = z, u_z = x), so that all six rigid motions of a
   * section are fields of their own.
   */
  struct SectionField
  {
    struct Term
    {
      unsigned int function;
      unsigned int component;
      double       factor;
    };
    std::vector<Term> terms;
    /// 0 for the linear fields, which hold the rigid motions, 1 for warping.
    unsigned int level = 0;
  };

  /// The numbers of the fields that make up the rigid motions.
  namespace RigidField
  {
    constexpr unsigned int translation_x = 0, translation_y = 1,
                           translation_z = 2, slope_x = 3, slope_z = 4,
                           rotation_y = 5;
  } // namespace RigidField

  /**
   * The fields that do not vanish at a point of the section, with the part of
   * their strain (order of Eq. 4) that falls on the section: for
   * u = N(y) Phi(x, z) the strain is N in_plane + N' axial(value).
   */
  struct SectionPoint
  {
    unsigned int                      cell = 0;
    dealii::Point<2>                  unit;
    dealii::Point<2>                  position;
    double                            jacobian = 0.;
    const std::vector<unsigned int>  *fields   = nullptr;
    std::vector<dealii::Tensor<1, 3>> value;
    std::vector<Voigt>                in_plane;
    /// (d Phi_x / dz - d Phi_z / dx) / 2, the rotation about the axis.
    std::vector<double> twist;
  };

  /// D_y Phi of Eq. 5: the strain {0, v_y, 0, v_x, 0, v_z} that a derivative
  /// @p v of the displacement along the axis makes.
  Voigt
  axial_strain(const dealii::Tensor<1, 3> &v);

  /**
   * Everything about the section that does not depend on the axis: the fields,
   * the integration points with their elasticity, and the four matrices of
   * Eq. 12,
   *   S_00 = int D_s^T C D_s,  S_01 = int D_s^T C D_y,
   *   S_10 = S_01^T,           S_11 = int D_y^T C D_y     over the section,
   * whose 3 x 3 blocks are the fundamental nucleus. Bodies with the same
   * section and theory share one object.
   */
  class Section
  {
  public:
    explicit Section(std::unique_ptr<const CrossSectionElement> element);

    const CrossSectionElement &
    element() const
    {
      return *expansion;
    }

    const std::vector<Ply> &
    plies() const
    {
      return expansion->section_mesh().plies;
    }

    unsigned int
    n_fields() const
    {
      return fields.size();
    }

    const SectionField &
    field(const unsigned int alpha) const
    {
      return fields[alpha];
    }

    unsigned int
    n_cells() const
    {
      return cell_fields.size();
    }

    /// Number in plies() of the ply that @p cell belongs to.
    unsigned int
    cell_ply(const unsigned int cell) const
    {
      return ply_of_cell[cell];
    }

    /// C in the body frame on @p cell.
    const ElasticTensor &
    elasticity(const unsigned int cell) const
    {
      return elasticities[ply_of_cell[cell]];
    }

    SectionPoint
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// The integration points, (p + 1)^2 Gauss points a cell, with weights.
    const std::vector<SectionPoint> &
    integration_points() const
    {
      return points;
    }

    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// S_pq for p, q in {0, 1}. All share one sparsity pattern.
    const Matrix &
    S(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// The cells that hold the point @p x within @p tolerance (a length), with
    /// its place on the unit square; none if it lies outside of the section.
    std::vector<std::pair<unsigned int, dealii::Point<2>>>
    locate(const dealii::Point<2> &x, const double tolerance) const;

    /// The integral of dA.
    double
    area() const;

  private:
    void
    make_fields();
    void
    make_points();
    void
    make_matrices();

    std::unique_ptr<const CrossSectionElement> expansion;
    std::vector<ElasticTensor>                 elasticities;

    std::vector<SectionField>              fields;
    std::vector<std::vector<unsigned int>> cell_fields;
    std::vector<unsigned int>              ply_of_cell;

    std::vector<SectionPoint> points;
    std::vector<double>       weights;

    dealii::SparsityPattern sparsity;
    std::array<Matrix, 4>   matrices;

    // Bounding boxes of the cells, for locate().
    dealii::RTree<std::pair<dealii::BoundingBox<2>, unsigned int>> boxes;
  };
} // namespace lamella

#endif
