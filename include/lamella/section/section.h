// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_h
#define lamella_section_section_h

// The room `section`: displacement functions over a section. Cross-section
// expansions F_tau (Taylor, layer-wise Lagrange), beam theories, the section
// matrices S_pq of the fundamental nuclei, and the completion of strains. It is
// independent of the axis.

#include <lamella/base/linear_algebra.h>
#include <lamella/section/cross_section_element.h>
#include <lamella/section/ply_laws.h>
#include <lamella/section/section_point.h>
#include <lamella/section/strain_completion.h>
#include <lamella/section/theory.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <boost/geometry/index/rtree.hpp>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  /// A displacement field over a section, one of the functions Phi_alpha(x, z)
  /// whose amplitudes are the DoFs of a beam: a sum of expansion functions
  /// F_tau(x, z) times unit vectors. Most have one term. Rotation about the
  /// axis (u_x = z, u_z = -x) and in-plane shear (u_x = z, u_z = x) have two.
  struct SectionFunction
  {
    /// A factor times an expansion function F_tau times a unit vector.
    struct Term
    {
      unsigned int function;  ///< Index tau of F_tau.
      unsigned int component; ///< Direction: 0, 1, 2 for x, y, z of the body.
      double       factor;    ///< Coefficient [no unit].
    };
    std::vector<Term> terms; ///< Terms of the sum.
    /// Rank in the elimination of DoFs by supports; 0 for linear functions.
    unsigned int level = 0;
  };

  /// Indices of the rigid section functions, with centroid (x_c, z_c) and
  /// length h. Slopes are rotations about z and x. No rotation_y in EBBT and
  /// TBT.
  namespace RigidField
  {
    constexpr unsigned int translation_x = 0, ///< u_x = 1.
      translation_y                      = 1, ///< u_y = 1.
      translation_z                      = 2, ///< u_z = 1.
      slope_x                            = 3, ///< u_y = (x - x_c) / h.
      slope_z                            = 4, ///< u_y = (z - z_c) / h.
      rotation_y = 5; ///< u_x = (z - z_c) / h, u_z = -(x - x_c) / h.
    /// Number of rigid section functions.
    constexpr unsigned int n_all = 6;
    /// Deflection and slope of each bending plane, x-y and y-z.
    constexpr std::array<std::array<unsigned int, 2>, 2> bending{
      {{{translation_x, slope_x}}, {{translation_z, slope_z}}}};
  } // namespace RigidField

  /// A cross-section with a beam theory: its section functions Phi_alpha,
  /// integration points with constitutive laws, and section matrices
  ///   S_00 = int D_s^T C D_s,  S_01 = int D_s^T C D_y,
  ///   S_10 = S_01^T,           S_11 = int D_y^T C D_y.
  /// The displacement is
  ///   u(x, y, z) = sum_alpha Phi_alpha(x, z) q_alpha(y),
  /// with amplitudes q_alpha. The strain is sum_alpha q_alpha D_s Phi_alpha +
  /// q_alpha' D_y Phi_alpha: D_s has the derivatives by x and z, D_y those by
  /// y. C is the elasticity matrix. With axial shape functions N_i(y), the
  /// stiffness of a beam is the sum of four Kronecker products of S_pq with
  ///   int N_i N_j, int N_i N_j', int N_i' N_j, int N_i' N_j'  dy.
  /// EBBT and TBT have five functions, without torsion. Other theories have
  /// nine linear functions, then each further F_tau times each unit vector.
  /// Matrices are sparse for layer-wise expansions except for linear functions.
  /// Immutable; shares ownership of the mesh.
  class Section
  {
  public:
    /// Computes section functions, integration points and matrices. @p element
    /// must be the expansion of @p theory (see make_section()).
    Section(std::unique_ptr<const CrossSectionElement> element,
            const Theory                              &theory);

    /// Returns the beam theory.
    const Theory &
    theory() const
    {
      return section_theory;
    }

    /// Returns the expansion with the functions F_tau(x, z).
    const CrossSectionElement &
    element() const
    {
      return *expansion;
    }

    /// Returns the plies of the section, bottom to top in a laminate.
    const std::vector<Ply> &
    plies() const
    {
      return expansion->section_mesh().plies;
    }

    /// Returns the shorter and the longer side of the bounding box [length].
    std::pair<double, double>
    extents() const
    {
      const auto box = expansion->bounding_box();
      return std::minmax({box.side_length(0), box.side_length(1)});
    }

    /// Returns the number of section functions, which is the number of DoFs of
    /// an axis node, with constrained DoFs included.
    unsigned int
    n_fields() const
    {
      return fields.size();
    }

    /// Returns section function @p alpha; RigidField has indices of rigid ones.
    const SectionFunction &
    field(const unsigned int alpha) const
    {
      return fields[alpha];
    }

    /// Returns the coefficients of the cross product @p v x u of @p v (body
    /// axes) and the displacement u with coefficients @p q. Not for EBBT and
    /// TBT.
    std::vector<double>
    rotated(const dealii::Tensor<1, 3> &v, const std::vector<double> &q) const;

    /// Returns the polynomial degree of section function number @p alpha.
    unsigned int
    field_degree(const unsigned int alpha) const
    {
      return expansion->function_degree(fields[alpha].terms[0].function);
    }

    /// Returns the number of cells of the section mesh.
    unsigned int
    n_cells() const
    {
      return cell_fields.size();
    }

    /// Returns the index in plies() of the ply of @p cell.
    unsigned int
    cell_ply(const unsigned int cell) const
    {
      return ply_of_cell[cell];
    }

    /// Returns the law at the point @p x of @p cell, in axes of the body.
    ElasticLaw
    law(const unsigned int cell, const dealii::Point<2> &x) const
    {
      return laws.at(ply_of_cell[cell], x);
    }

    /// Returns the law at integration point number @p k, in axes of the body.
    const ElasticLaw &
    law_at_point(const unsigned int k) const
    {
      return point_laws.empty() ? laws.constant(ply_of_cell[points[k].cell]) :
                                  point_laws[k];
    }

    /// Returns the ply axes at the point @p x of @p cell, in the body frame.
    Triad
    ply_axes(const unsigned int cell, const dealii::Point<2> &x) const
    {
      return plies()[ply_of_cell[cell]].axes(x);
    }

    /// Evaluates the section functions of @p cell, with the strains of
    /// StrainCompletion, at the reference coordinates @p unit. The result keeps
    /// a pointer to data of this object.
    SectionPoint
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Returns true if StrainCompletion corrects strains for Poisson locking.
    bool
    completes_strains() const
    {
      return completion != nullptr;
    }

    /// Returns StrainCompletion::of_initial(), the correction for Poisson
    /// locking due to the @p initial strain at the point @p x of @p cell.
    Voigt
    completion_of_initial(const unsigned int      cell,
                          const dealii::Point<2> &x,
                          const Voigt            &initial) const;

    /// Returns true if ContractionModes correct Poisson locking (TE-1).
    bool
    completes_by_modes() const;

    /// Callback with an integration point and its weight [length^2].
    using PointCallback =
      std::function<void(const SectionPoint &, const double)>;

    /// Calls @p use with the integration points of the section matrices,
    /// n_gauss_points()^2 per cell, cell by cell.
    void
    for_each_point(const PointCallback &use) const;

    /// Returns true if section functions are polynomials over the whole
    /// section: TE-N, N > 1. The section matrices are then computed from
    /// moments(), and integration_points() have no weights.
    bool
    spans_the_section() const;

    /// Returns the matrix int e_p^T C e_q dA over pairs of section functions,
    /// for @p p and @p q from 0 to 2; empty except for TE-N with N > 1. The
    /// strain of a function with amplitude a(y) is a (e_0 + e_1) + a' e_2,
    /// where e_1 are the transverse shear strains due to a, e_0 its other
    /// strains, and e_2 all strains due to a'.
    const dealii::LAPACKFullMatrix<double> &
    moments(const unsigned int p, const unsigned int q) const
    {
      return strain_moments[p][q];
    }

    /// Returns the integration points, n_gauss_points()^2 per cell, cell by
    /// cell. TE-N, N > 1, has sample points without weights instead.
    const std::vector<SectionPoint> &
    integration_points() const
    {
      return points;
    }

    /// Returns Gauss weight times Jacobian determinant of each integration
    /// point [length^2]; empty for TE-N with N > 1.
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// Returns the section matrix S_pq. An index 0 means values, 1 derivatives
    /// along y, of the amplitudes of section functions. Units: S_00 force /
    /// length^2, S_01 force / length, S_11 force. Includes the shear factor of
    /// TBT and StrainCompletion. All S_pq have one sparsity pattern.
    const Matrix &
    S(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// Returns the contribution of transverse shear strains to S_00, the
    /// section stiffness without axial derivatives. Axis elements with assumed
    /// shear strains (MITC) need it separately. Zero for EBBT.
    const Matrix &
    S_shear() const
    {
      return matrices[4];
    }

    /// Returns the cells that contain @p x within @p tolerance [length],
    /// ascending, with the reference coordinates of @p x; none if @p x is
    /// outside of the section. With curved edges, the tolerance is at least 2 %
    /// of the cell's size, and only the nearest cell is returned.
    std::vector<std::pair<unsigned int, dealii::Point<2>>>
    locate(const dealii::Point<2> &x, const double tolerance) const;

    /// Returns the area of the section [length^2], by integration.
    double
    area() const;

  private:
    /// Creates the section functions and lists those of each cell.
    void
    make_fields();
    /// Computes integration points and, for EBBT, TBT and TE-1, `completion`.
    void
    make_points();
    /// Selects sample points at which the largest rotation is computed.
    void
    make_sample_points();
    /// Creates the sparsity pattern: entries for functions of a common cell.
    void
    make_pattern();
    /// Integrates S_pq cell by cell, except for TE-N with N > 1.
    void
    make_matrices();
    /// Computes moments() from integrals of products of F_tau over each ply.
    void
    make_moments();
    /// Computes S_pq as sums of moments().
    void
    add_moments();
    /// Rows of S_00, S_01, S_10, S_11 and S_shear() for the linear functions.
    using DenseRows = std::array<std::vector<Vector>, 5>;
    /// Strains, or stresses times weights, of the functions of a cell, six rows
    /// per point: e_0, e_1 and e_2 of moments().
    using StrainParts = std::array<dealii::LAPACKFullMatrix<double>, 3>;
    void
    find_cell_strains(const unsigned int cell,
                      StrainParts       &strain,
                      StrainParts       &stress) const;
    /// Adds products of strain and stress of @p cell to matrices or @p dense.
    void
    add_cell_matrices(const unsigned int cell,
                      const StrainParts &strain,
                      const StrainParts &stress,
                      DenseRows         &dense);
    /// Computes bounding boxes of cells, 20 % larger if edges are curved.
    void
    make_boxes();

    /// Returns the reference coordinates of the point of @p cell nearest to
    /// @p x, and its distance from @p x [length].
    std::pair<dealii::Point<2>, double>
    nearest_in_cell(const unsigned int cell, const dealii::Point<2> &x) const;

    /// Evaluates the section functions at a point without StrainCompletion, and
    /// without transverse shear strains for EBBT.
    SectionPoint
    evaluate_fields(const unsigned int      cell,
                    const dealii::Point<2> &unit) const;

    std::unique_ptr<const CrossSectionElement> expansion;
    Theory                                     section_theory;
    /// Laws of the plies, including the shear factor.
    PlyLaws laws;
    /// Law at each integration point if the law of any ply varies, else empty.
    std::vector<ElasticLaw> point_laws;
    /// Correction of Poisson locking; null if there is none.
    std::unique_ptr<const StrainCompletion> completion;

    std::vector<SectionFunction> fields;
    /// Indices of the nonzero section functions on each cell, ascending.
    std::vector<std::vector<unsigned int>> cell_fields;
    std::vector<unsigned int>              ply_of_cell;

    std::vector<SectionPoint> points;
    std::vector<double>       weights;

    dealii::SparsityPattern sparsity;
    /// Matrices S_00, S_01, S_10, S_11 and S_shear().
    std::array<Matrix, 5> matrices;

    std::array<std::array<dealii::LAPACKFullMatrix<double>, 3>, 3>
      strain_moments;

    /// True if any edge of the mesh is curved.
    bool is_curved = false;
    // Bounding boxes of the cells, for locate().
    dealii::RTree<std::pair<dealii::BoundingBox<2>, unsigned int>> boxes;
  };

  /// Creates the section of @p mesh for @p theory. The expansion is a
  /// LagrangeElement for LE and SV (Theory::of_section()), otherwise a
  /// TaylorElement, of degree 1 for EBBT and TBT. Not for solid-N.
  std::shared_ptr<const Section>
  make_section(const std::shared_ptr<const SectionMesh> &mesh,
               const Theory                             &theory);

  /// Returns the positions (x, z) of the points of @p section with singular
  /// stresses: re-entrant corners, and ends of ply interfaces on the boundary.
  std::vector<dealii::Point<2>>
  corners_of(const Section &section);
} // namespace lamella

#endif
