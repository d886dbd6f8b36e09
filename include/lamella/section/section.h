// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `section`: fields over a section. It owns the cross-section
// expansions F_tau (Taylor, layer-wise Lagrange), the theories made of them,
// the matrices S_pq of the fundamental nuclei, and what strains a theory
// completes or misses. What it says holds at any place along the beam: it never
// knows the axis.

#ifndef lamella_section_section_h
#define lamella_section_section_h

#include <lamella/base/linear_algebra.h>
#include <lamella/section/cross_section_element.h>
#include <lamella/section/section_point.h>
#include <lamella/section/strain_completion.h>
#include <lamella/section/theory.h>

#include <boost/geometry/index/rtree.hpp>

#include <deal.II/lac/lapack_full_matrix.h>

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
    /// 0 for the linear fields, which hold the rigid motions, higher for
    /// warping.
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
   * Everything about the section that does not depend on the axis: the fields
   * of the theory, the integration points with their elasticity, and the four
   * matrices of Eq. 12,
   *   S_00 = int D_s^T C D_s,  S_01 = int D_s^T C D_y,
   *   S_10 = S_01^T,           S_11 = int D_y^T C D_y     over the section,
   * whose 3 x 3 blocks are the fundamental nucleus. Bodies with the same
   * section and theory share one object.
   *
   * Fields: the five of a plane section for EBBT and TBT (no torsion), nine
   * linear ones for the others, then each further F_tau times a unit vector.
   */
  class Section
  {
  public:
    /// @p element must be one of @p theory; make_section() sees to that.
    Section(std::unique_ptr<const CrossSectionElement> element,
            const Theory                              &theory);

    const Theory &
    theory() const
    {
      return section_theory;
    }

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

    /// The law in the body frame on @p cell, its transverse shear scaled by the
    /// theory's shear factor k: D C D in place of C with sqrt(k) in D's places
    /// for xy and yz.
    const ElasticLaw &
    law(const unsigned int cell) const
    {
      return laws[ply_of_cell[cell]];
    }

    SectionPoint
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const;

    /**
     * Whether the theory's fields live on the whole section with strains of
     * their own (TE-2 and higher). What the section's points would be looked at
     * for is then in moments(), whatever the number of cells, and
     * integration_points() are few, for pictures and the rotation.
     */
    bool
    spans_the_section() const;

    /**
     * int e_p^T C e_q dA for each pair of fields, where e_0 are the strains
     * that a field's value multiplies, without transverse shear, e_1 its
     * transverse shear strains, and e_2 those that its derivative along y
     * multiplies. Of a section that spans_the_section().
     */
    const dealii::LAPACKFullMatrix<double> &
    moments(const unsigned int p, const unsigned int q) const
    {
      return strain_moments[p][q];
    }

    /// The integration points, n_gauss_points()^2 a cell, with weights.
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

    /// The part of S_00 that has a transverse shear strain on either side: what
    /// the axis multiplies with the projected shape functions.
    const Matrix &
    S_shear() const
    {
      return matrices[4];
    }

    /**
     * The cells that hold the point @p x within @p tolerance (a length), with
     * its place on the unit square; none if it lies outside of the section.
     * Outside of a curved edge a point is on the section if it is within 2 % of
     * the cell's size: the expansion interpolates the curve.
     */
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
    /// A reduced set of points, for the rotation: a Taylor expansion is smooth
    /// over all cells.
    void
    make_sample_points();
    void
    make_pattern();
    /// The matrices of fields that live on few cells, cell by cell.
    void
    make_matrices();
    /// The matrices of fields that live on the whole section, from the moments
    /// of their functions over each ply: the points of the section are looked
    /// at once, function by function instead of field by field.
    void
    make_moments();
    /// Of each matrix the rows of the fields that live on all cells.
    using DenseRows = std::array<std::vector<Vector>, 5>;
    /// Adds the products of strains and stresses at the points of @p cell to
    /// the matrices, and to @p dense what belongs to its rows; the parts are
    /// in_plane without and with nothing but the transverse shear strains, and
    /// along.
    void
    add_cell_matrices(
      const unsigned int                                     cell,
      const std::array<dealii::LAPACKFullMatrix<double>, 3> &strain,
      const std::array<dealii::LAPACKFullMatrix<double>, 3> &stress,
      DenseRows                                             &dense);
    void
    make_boxes();

    /// The place of the point of @p cell nearest to @p x and its distance.
    std::pair<dealii::Point<2>, double>
    nearest_in_cell(const unsigned int cell, const dealii::Point<2> &x) const;

    /// The fields at a point with the strains of their displacements.
    SectionPoint
    evaluate_fields(const unsigned int      cell,
                    const dealii::Point<2> &unit) const;

    std::unique_ptr<const CrossSectionElement> expansion;
    Theory                                     section_theory;
    std::vector<ElasticLaw>                    laws;
    std::unique_ptr<const StrainCompletion>    completion;

    std::vector<SectionField>              fields;
    std::vector<std::vector<unsigned int>> cell_fields;
    std::vector<unsigned int>              ply_of_cell;

    std::vector<SectionPoint> points;
    std::vector<double>       weights;

    dealii::SparsityPattern sparsity;
    std::array<Matrix, 5>   matrices;

    std::array<std::array<dealii::LAPACKFullMatrix<double>, 3>, 3>
      strain_moments;

    bool is_curved = false;
    // Bounding boxes of the cells, for locate().
    dealii::RTree<std::pair<dealii::BoundingBox<2>, unsigned int>> boxes;
  };

  /// The section of @p mesh with the fields of @p theory.
  std::shared_ptr<const Section>
  make_section(std::shared_ptr<const SectionMesh> mesh, const Theory &theory);
} // namespace lamella

#endif
