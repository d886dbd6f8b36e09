// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `section`: fields over a section. It has the cross-section
// expansions F_tau (Taylor, layer-wise Lagrange), the theories made of them,
// the matrices S_pq of the fundamental nuclei, and the completion of strains.
// It is independent of the axis.

#ifndef lamella_section_section_h
#define lamella_section_section_h

#include <lamella/base/linear_algebra.h>
#include <lamella/section/cross_section_element.h>
#include <lamella/section/ply_laws.h>
#include <lamella/section/section_point.h>
#include <lamella/section/strain_completion.h>
#include <lamella/section/theory.h>

#include <boost/geometry/index/rtree.hpp>

#include <deal.II/lac/lapack_full_matrix.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  /// A field of the section, Phi_alpha(x, z) in R^3: a sum of expansion
  /// functions F_tau times unit vectors, most with one term. The rotation about
  /// the axis (u_x = z, u_z = -x) and the in-plane shear (u_x = z, u_z = x)
  /// combine linear functions. All six rigid motions of a section are thus
  /// fields.
  struct SectionFunction
  {
    /// A term: @p factor times F of number @p function, in direction
    /// @p component (0, 1, 2 for x, y, z of the body frame).
    struct Term
    {
      unsigned int function;
      unsigned int component;
      double       factor;
    };
    std::vector<Term> terms;
    /// Level: 0 for linear fields with the rigid motions, higher for warping.
    unsigned int level = 0;
  };

  /// Numbers of the rigid fields, with the reference length h: unit
  /// translations u_x, u_y, u_z; the slopes u_y = (x - x_c) / h and u_y = (z -
  /// z_c) / h, rotations about z and x; and the rotation 1 / h about y, u_x =
  /// (z - z_c) / h, u_z = -(x - x_c) / h. EBBT and TBT have no rotation about
  /// y. A rigid rotation of the beam about x or z is a constant slope with a
  /// translation linear in y.
  namespace RigidField
  {
    constexpr unsigned int translation_x = 0, translation_y = 1,
                           translation_z = 2, slope_x = 3, slope_z = 4,
                           rotation_y = 5;
    /// Number of rigid fields, and of motions of a rigid body.
    constexpr unsigned int n_all = 6;
    /// The two planes of bending: the deflection, and its slope.
    constexpr std::array<std::array<unsigned int, 2>, 2> bending{
      {{{translation_x, slope_x}}, {{translation_z, slope_z}}}};
  } // namespace RigidField

  /**
   * Fields of a theory on a section, integration points with their elasticity,
   * and the four matrices of Eq. 12, integrals over the section,
   *   S_00 = int D_s^T C D_s,  S_01 = int D_s^T C D_y,
   *   S_10 = S_01^T,           S_11 = int D_y^T C D_y.
   * Bodies with the same section and theory share one object. EBBT and TBT have
   * the five fields of a plane section (no torsion). Other theories have nine
   * linear fields, then each further F_tau times a unit vector. The
   * displacement is
   *   u(x, y, z) = sum_alpha Phi_alpha(x, z) q_alpha(y),
   * Eq. 1 with its components as fields of their own. D_s has the derivatives
   * by x and z of Eq. 5, D_y those by y: with shape functions N_i(y) the
   * stiffness is the sum of four Kronecker products of these matrices with the
   * axis integrals
   *   int N_i N_j, int N_i N_j', int N_i' N_j, int N_i' N_j'  dy.
   * S_shear() is the transverse shear part of S_00, for assumed shear strains
   * along the axis (MITC). The 3 x 3 nucleus of Eq. 12 for tau, s is the block
   * of fields F_tau e_c, F_s e_d. Matrices are sparse for layer-wise expansions
   * (fields couple that share a cell; rows of linear ones are full) and dense
   * for Taylor ones. Immutable; shares the section mesh.
   */
  class Section
  {
  public:
    /// Computes fields, integration points and matrices. @p element must be one
    /// of @p theory (make_section()).
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

    /// Returns the homogeneous parts, bottom to top in a laminate.
    const std::vector<Ply> &
    plies() const
    {
      return expansion->section_mesh().plies;
    }

    /// Returns the smaller and the larger side of the bounding box [length].
    std::pair<double, double>
    extents() const
    {
      const auto box = expansion->bounding_box();
      return std::minmax({box.side_length(0), box.side_length(1)});
    }

    /// Returns the number of DoFs of an axis node, before constraints.
    unsigned int
    n_fields() const
    {
      return fields.size();
    }

    /// Returns the field @p alpha; RigidField numbers the rigid ones.
    const SectionFunction &
    field(const unsigned int alpha) const
    {
      return fields[alpha];
    }

    /// Returns the coefficients of v x u, @p v in body axes, from @p q of u,
    /// one per field. For theories with all linear fields.
    std::vector<double>
    rotated(const dealii::Tensor<1, 3> &v, const std::vector<double> &q) const;

    /// Returns the degree of field @p alpha (function_degree()).
    unsigned int
    field_degree(const unsigned int alpha) const
    {
      return expansion->function_degree(fields[alpha].terms[0].function);
    }

    unsigned int
    n_cells() const
    {
      return cell_fields.size();
    }

    /// Returns the number in plies() of the ply of @p cell.
    unsigned int
    cell_ply(const unsigned int cell) const
    {
      return ply_of_cell[cell];
    }

    /// Returns the law in the body frame at the point @p x of @p cell(PlyLaws).
    ElasticLaw
    law(const unsigned int cell, const dealii::Point<2> &x) const
    {
      return laws.at(ply_of_cell[cell], x);
    }

    /// Returns the stored law at integration point number @p k.
    const ElasticLaw &
    law_at_point(const unsigned int k) const
    {
      return point_laws.empty() ? laws.constant(ply_of_cell[points[k].cell]) :
                                  point_laws[k];
    }

    /// Returns the axes of the ply of @p cell at @p x, in the body frame.
    Triad
    ply_axes(const unsigned int cell, const dealii::Point<2> &x) const
    {
      return plies()[ply_of_cell[cell]].axes(x);
    }

    /// Returns the fields on @p cell at @p unit with completed strains.
    /// SectionPoint::fields refers to this object.
    SectionPoint
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Returns true if strains of fields are completed (StrainCompletion).
    bool
    completes_strains() const
    {
      return completion != nullptr;
    }

    /// Returns the strain that completion adds for the @p initial strain of
    /// @p cell at its point @p x (StrainCompletion::of_initial()); zero without
    /// completion.
    Voigt
    completion_of_initial(const unsigned int      cell,
                          const dealii::Point<2> &x,
                          const Voigt            &initial) const;

    /// Returns true if modes of the section complete strains (TE-1).
    bool
    completes_by_modes() const;

    /// Callback with a point, strains completed, and its weight [length^2].
    using PointCallback =
      std::function<void(const SectionPoint &, const double)>;

    /// Calls @p use with n_gauss_points()^2 points per cell, cell by cell, the
    /// integration points of S_pq.
    void
    for_each_point(const PointCallback &use) const;

    /// Returns true if the fields span all cells with uncompleted strains (TE-2
    /// and higher). Then moments() replace integrals over points, and
    /// integration_points() are few.
    bool
    spans_the_section() const;

    /// Returns int e_p^T C e_q dA for each pair of fields if the section
    /// spans_the_section(), else empty; @p p, @p q in {0, 1, 2}. Strains e_0
    /// without transverse shear and transverse shear strains e_1 belong to a
    /// field's value, e_2 to its derivative along y. A residual costs
    /// n_fields()^2 per axis point.
    const dealii::LAPACKFullMatrix<double> &
    moments(const unsigned int p, const unsigned int q) const
    {
      return strain_moments[p][q];
    }

    /// Returns the integration points, n_gauss_points()^2 per cell, cell by
    /// cell, strains completed. If the section spans_the_section(), some 500
    /// points in all or one per cell, without weights.
    const std::vector<SectionPoint> &
    integration_points() const
    {
      return points;
    }

    /// Returns Gauss weight times Jacobian [length^2] of each point; empty for
    /// a section that spans_the_section().
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// Returns S_pq for @p p, @p q in {0, 1}, of one sparsity pattern: S_00 is
    /// in force / length^2, S_01 in force / length, S_11 in force. Includes
    /// TBT's shear factor and completed strains.
    const Matrix &
    S(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// Returns the part of S_00 with a transverse shear strain on either side,
    /// for projected shape functions on the axis. Zero for EBBT.
    const Matrix &
    S_shear() const
    {
      return matrices[4];
    }

    /// Returns the cells that contain @p x within @p tolerance (a length),
    /// ascending, with positions on the unit square; none outside of the
    /// section. Sections with curved edges extend the tolerance to 2 % of the
    /// cell's size and then return the nearest cell only. Uses Newton's method
    /// in cells from an R-tree.
    std::vector<std::pair<unsigned int, dealii::Point<2>>>
    locate(const dealii::Point<2> &x, const double tolerance) const;

    /// Returns the area of the mapped cells [length^2], by integration.
    double
    area() const;

  private:
    /// Sets the fields, rigid ones first, and for each cell those on it.
    void
    make_fields();
    /// Sets integration_points() and, if needed, the completion.
    void
    make_points();
    /// Sets reduced points for the rotation: a Taylor expansion is smooth.
    void
    make_sample_points();
    /// Sets the pattern: fields couple that share a cell.
    void
    make_pattern();
    /// Integrates the matrices of fields on few cells, cell by cell.
    void
    make_matrices();
    /// Integrates matrices from moments of functions over each ply, evaluating
    /// points once per function.
    void
    make_moments();
    /// Computes the matrices as sums of strain_moments.
    void
    add_moments();
    /// Rows of each matrix for the fields that are nonzero on all cells.
    using DenseRows = std::array<std::vector<Vector>, 5>;
    /// Strains, or stresses times weights, of a cell's fields, six rows per
    /// point: in_plane without and with only the transverse shear strains, and
    /// along.
    using StrainParts = std::array<dealii::LAPACKFullMatrix<double>, 3>;
    void
    find_cell_strains(const unsigned int cell,
                      StrainParts       &strain,
                      StrainParts       &stress) const;
    /// Adds the products at the points of @p cell to the matrices, and to
    /// @p dense those of its rows.
    void
    add_cell_matrices(const unsigned int cell,
                      const StrainParts &strain,
                      const StrainParts &stress,
                      DenseRows         &dense);
    /// Sets the cells' boxes, a fifth larger if edges are curved.
    void
    make_boxes();

    /// Returns the point in @p cell nearest to @p x, and its distance [length].
    std::pair<dealii::Point<2>, double>
    nearest_in_cell(const unsigned int cell, const dealii::Point<2> &x) const;

    /// Returns the fields at a point with the strains of their displacements,
    /// without EBBT's transverse shear strains.
    SectionPoint
    evaluate_fields(const unsigned int      cell,
                    const dealii::Point<2> &unit) const;

    std::unique_ptr<const CrossSectionElement> expansion;
    Theory                                     section_theory;
    /// Laws by ply, with the shear factor.
    PlyLaws laws;
    /// Laws of integration points if any law varies.
    std::vector<ElasticLaw> point_laws;
    /// Completion of strains, or null.
    std::unique_ptr<const StrainCompletion> completion;

    std::vector<SectionFunction> fields;
    /// Fields on each cell, ascending.
    std::vector<std::vector<unsigned int>> cell_fields;
    std::vector<unsigned int>              ply_of_cell;

    std::vector<SectionPoint> points;
    std::vector<double>       weights;

    dealii::SparsityPattern sparsity;
    /// Matrices S_00, S_01, S_10, S_11 and S_shear().
    std::array<Matrix, 5> matrices;

    std::array<std::array<dealii::LAPACKFullMatrix<double>, 3>, 3>
      strain_moments;

    /// Flag: any edge of the mesh is curved.
    bool is_curved = false;
    // Bounding boxes of the cells, for locate().
    dealii::RTree<std::pair<dealii::BoundingBox<2>, unsigned int>> boxes;
  };

  /// Returns the section of @p mesh, which it shares, with the fields of
  /// @p theory, or of Theory::of_section(): LagrangeElement for LE and SV,
  /// TaylorElement for others, of degree 1 for EBBT and TBT. Not for solid-N.
  std::shared_ptr<const Section>
  make_section(std::shared_ptr<const SectionMesh> mesh, const Theory &theory);
} // namespace lamella

#endif
