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
  /**
   * A field of the section, Phi_alpha(x, z) in R^3: a sum of expansion
   * functions F_tau times unit vectors. Most have one term. The in-plane linear
   * functions enter as the rotation about the axis (u_x = z, u_z = -x) and the
   * in-plane shear (u_x = z, u_z = x), so that all six rigid motions of a
   * section are fields of their own.
   */
  struct SectionField
  {
    /// @p factor times F of number @p function, in direction @p component: 0,
    /// 1, 2 for x, y, z of the body frame.
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

  /**
   * The numbers of the fields that make up the rigid motions. With h the
   * reference length: unit translations u_x, u_y, u_z; the slopes u_y = (x -
   * x_c) / h and u_y = (z - z_c) / h, which turn the section about z and x; and
   * the rotation 1 / h about y, u_x = (z - z_c) / h, u_z = -(x - x_c) / h,
   * which EBBT and TBT do not have. Each moves the section rigidly. A rigid
   * rotation of the whole beam about x or z is a constant slope with a
   * translation that is linear in y.
   */
  namespace RigidField
  {
    constexpr unsigned int translation_x = 0, translation_y = 1,
                           translation_z = 2, slope_x = 3, slope_z = 4,
                           rotation_y = 5;
    /// How many there are, and motions of a rigid body with them.
    constexpr unsigned int n_all = 6;
    /// The two planes of bending: the deflection, and the slope that shears the
    /// section as the deflection's derivative along the axis does.
    constexpr std::array<std::array<unsigned int, 2>, 2> bending{
      {{{translation_x, slope_x}}, {{translation_z, slope_z}}}};
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
   *
   * The displacement is
   *   u(x, y, z) = sum_alpha Phi_alpha(x, z) q_alpha(y),
   * Eq. 1 with its three components as fields of their own (n_fields() of
   * them). D_s has the derivatives with respect to x and z of Eq. 5, D_y those
   * with respect to y, so that with shape functions N_i(y) the stiffness is the
   * sum of four Kronecker products of these matrices with the axis integrals
   *   int N_i N_j, int N_i N_j', int N_i' N_j, int N_i' N_j'  dy;
   * the transverse shear part of S_00 is kept apart as S_shear(), for shear
   * strains that are interpolated along the axis (MITC). The 3 x 3 nucleus of
   * Eq. 12 for tau, s is the block of fields F_tau e_c, F_s e_d.
   *
   * Memory: the matrices are sparse for layer-wise expansions (fields couple
   * that share a cell; the rows of the linear ones are full), dense for Taylor
   * ones. It is immutable; it shares the section mesh.
   */
  class Section
  {
  public:
    /// Makes the fields, the integration points and the matrices: nearly all of
    /// a section's cost. @p element must be one of @p theory; make_section()
    /// sees to that.
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

    /// The homogeneous parts of the section, bottom to top in a laminate.
    const std::vector<Ply> &
    plies() const
    {
      return expansion->section_mesh().plies;
    }

    /// The smaller and the larger side of the box around it [length].
    std::pair<double, double>
    extents() const
    {
      const auto box = expansion->bounding_box();
      return std::minmax({box.side_length(0), box.side_length(1)});
    }

    /// Displacement DoFs of an axis node, before constraints.
    unsigned int
    n_fields() const
    {
      return fields.size();
    }

    /// @p alpha below n_fields(); the rigid ones as RigidField says.
    const SectionField &
    field(const unsigned int alpha) const
    {
      return fields[alpha];
    }

    /// The coefficients of v x u, @p v in the body's axes, where those of u are
    /// @p q, one for each field: what a turn about v does to a section that has
    /// moved. Of theories with all linear fields.
    std::vector<double>
    turned(const dealii::Tensor<1, 3> &v, const std::vector<double> &q) const;

    /// The degree of the functions of the field @p alpha
    /// (CrossSectionElement::function_degree()). Where they are hierarchical by
    /// degree it ascends with alpha.
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

    /// Number in plies() of the ply that @p cell belongs to.
    unsigned int
    cell_ply(const unsigned int cell) const
    {
      return ply_of_cell[cell];
    }

    /// The law in the body frame at the point @p x of @p cell, its transverse
    /// shear scaled by the theory's shear factor (PlyLaws).
    ElasticLaw
    law(const unsigned int cell, const dealii::Point<2> &x) const
    {
      return laws.at(ply_of_cell[cell], x);
    }

    /// The same at integration point number @p k, without any turn.
    const ElasticLaw &
    law_at_point(const unsigned int k) const
    {
      return point_laws.empty() ? laws.constant(ply_of_cell[points[k].cell]) :
                                  point_laws[k];
    }

    /// The axes of the ply of @p cell at the point @p x, in the body frame.
    Triad
    ply_axes(const unsigned int cell, const dealii::Point<2> &x) const
    {
      return plies()[ply_of_cell[cell]].axes(x);
    }

    /// The fields that live on @p cell at @p unit with their strains, completed
    /// as the theory demands: displacements, strains and stresses of a beam are
    /// made of these. Refers to this object by SectionPoint::fields.
    SectionPoint
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Whether strains of fields are others than their displacements have
    /// (StrainCompletion).
    bool
    completes_strains() const
    {
      return completion != nullptr;
    }

    /// What an initial strain @p initial of @p cell at its point @p x, as heat
    /// makes it, adds to the strains of all fields
    /// (StrainCompletion::of_initial()): zero for theories that complete no
    /// strains.
    Voigt
    completion_of_initial(const unsigned int      cell,
                          const dealii::Point<2> &x,
                          const Voigt            &initial) const;

    /// Whether the theory completes strains by modes of the whole section
    /// (TE-1): what these make of an initial strain is not known at a point.
    bool
    completes_by_modes() const;

    /// A point of the section, its strains completed, and what it stands for in
    /// integrals over the section [length^2].
    using UseOfPoint = std::function<void(const SectionPoint &, const double)>;

    /// Calls @p use with n_gauss_points()^2 points a cell, cell by cell:
    /// integration_points() where these have weights, so that what they
    /// integrate fits the S_pq to the last bit.
    void
    for_each_point(const UseOfPoint &use) const;

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
     *
     * @p p, @p q in {0, 1, 2}; n_fields() x n_fields() each, empty for other
     * sections. With them a residual costs n_fields()^2 an axis point, however
     * many cells there are.
     */
    const dealii::LAPACKFullMatrix<double> &
    moments(const unsigned int p, const unsigned int q) const
    {
      return strain_moments[p][q];
    }

    /// The integration points, n_gauss_points()^2 a cell, cell by cell, their
    /// strains completed. Of a section that spans_the_section() fewer, for
    /// pictures and the rotation: some 500 in all or one a cell, without
    /// weights.
    const std::vector<SectionPoint> &
    integration_points() const
    {
      return points;
    }

    /// Gauss weight times Jacobian [length^2] of each; they sum to the area.
    /// Empty for a section that spans_the_section(), whose integrals are in
    /// moments().
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// S_pq for p, q in {0, 1}. All share one sparsity pattern. n_fields() x
    /// n_fields(), S_10 the transpose of S_01. Fields have no unit, so S_00 is
    /// in force / length^2, S_01 in force / length, S_11 in force. TBT's shear
    /// factor and the completion of strains are in them.
    const Matrix &
    S(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// The part of S_00 that has a transverse shear strain on either side: what
    /// the axis multiplies with the projected shape functions. Of EBBT zero:
    /// its transverse shear strains are dropped.
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
     *
     * The inverse map by Newton's method in the cells whose boxes are near (an
     * R-tree). By ascending cells; a point on a side is in both of its cells.
     * The 2 % hold on straight sides, too, of a section of which any edge is
     * curved; then the nearest cell alone is returned. Nothing is thrown.
     */
    std::vector<std::pair<unsigned int, dealii::Point<2>>>
    locate(const dealii::Point<2> &x, const double tolerance) const;

    /// The integral of dA over the cells as the expansion maps them [length^2];
    /// looked at anew at each call.
    double
    area() const;

  private:
    /// The fields, in the order of RigidField and then of the functions, and
    /// for each cell those that live on it.
    void
    make_fields();
    /// integration_points() and, for the theories that need it, the completion.
    void
    make_points();
    /// A reduced set of points, for the rotation: a Taylor expansion is smooth
    /// over all cells.
    void
    make_sample_points();
    /// Fields couple that share a cell.
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
    /// The matrices as sums of strain_moments.
    void
    add_moments();
    /// Of each matrix the rows of the fields that live on all cells.
    using DenseRows = std::array<std::vector<Vector>, 5>;
    /// Strains, or stresses times weights, of the fields of a cell at its
    /// points, six rows a point: in_plane without and with nothing but the
    /// transverse shear strains, and along.
    using StrainParts = std::array<dealii::LAPACKFullMatrix<double>, 3>;
    void
    find_cell_strains(const unsigned int cell,
                      StrainParts       &strain,
                      StrainParts       &stress) const;
    /// Adds the products of strains and stresses at the points of @p cell to
    /// the matrices, cell by cell as products of dense matrices, and to
    /// @p dense what belongs to its rows.
    void
    add_cell_matrices(const unsigned int cell,
                      const StrainParts &strain,
                      const StrainParts &stress,
                      DenseRows         &dense);
    /// The cells' boxes; those of a section with curved edges grow by a fifth.
    void
    make_boxes();

    /// The place of the point of @p cell nearest to @p x and its distance. The
    /// distance is 0 up to rounding inside of the cell. [length]
    std::pair<dealii::Point<2>, double>
    nearest_in_cell(const unsigned int cell, const dealii::Point<2> &x) const;

    /// The fields at a point with the strains of their displacements. Not yet
    /// completed. EBBT's transverse shear strains are zero.
    SectionPoint
    evaluate_fields(const unsigned int      cell,
                    const dealii::Point<2> &unit) const;

    std::unique_ptr<const CrossSectionElement> expansion;
    Theory                                     section_theory;
    /// By plies, with the shear factor.
    PlyLaws laws;
    /// Of each integration point, where any law varies.
    std::vector<ElasticLaw> point_laws;
    /// Null where the theory completes nothing.
    std::unique_ptr<const StrainCompletion> completion;

    std::vector<SectionField> fields;
    /// Of each cell the fields that live on it, ascending.
    std::vector<std::vector<unsigned int>> cell_fields;
    std::vector<unsigned int>              ply_of_cell;

    std::vector<SectionPoint> points;
    std::vector<double>       weights;

    dealii::SparsityPattern sparsity;
    /// S_00, S_01, S_10, S_11 and S_shear().
    std::array<Matrix, 5> matrices;

    std::array<std::array<dealii::LAPACKFullMatrix<double>, 3>, 3>
      strain_moments;

    /// Whether any edge of the mesh is.
    bool is_curved = false;
    // Bounding boxes of the cells, for locate().
    dealii::RTree<std::pair<dealii::BoundingBox<2>, unsigned int>> boxes;
  };

  /// The section of @p mesh with the fields of @p theory: LagrangeElement for
  /// LE and SV, TaylorElement for all others, of degree 1 for EBBT and TBT. Not
  /// for solid-N, which has no section fields. Its theory() is
  /// Theory::of_section(). Shares @p mesh.
  std::shared_ptr<const Section>
  make_section(std::shared_ptr<const SectionMesh> mesh, const Theory &theory);
} // namespace lamella

#endif
