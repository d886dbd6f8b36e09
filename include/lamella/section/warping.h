// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_warping_h
#define lamella_section_warping_h

#include <lamella/section/section_space.h>

namespace lamella
{
  /// Orthogonalizes, compares and reduces displacements w over a section by
  /// their warping, the component orthogonal to the six rigid motions R_r,
  ///   w <- w - sum_r c_r R_r   with   int R_s . w dA = 0   for all s,
  /// with the energy norm
  ///   |w|^2 = w^T (S_00 + (0.1 / H)^2 S_11) w,
  /// for amplitudes whose derivative along the axis is 0.1 / H times their
  /// value, with the section height H. S_00 and S_11 are section matrices.
  /// Keeps a reference to the section, which must have a rotation about y (not
  /// EBBT, TBT).
  class Warping
  {
  public:
    /// Computes the rigid motions and the energy norm of @p section.
    explicit Warping(const Section &section);

    /// Returns the smaller side of the section's bounding box [length].
    double
    height() const
    {
      return smaller_extent;
    }

    /// Subtracts the rigid motions from the displacement @p field.
    void
    remove_rigid(Vector &field) const;

    /// Returns the load vector of the traction @p field: int Phi_alpha . field
    /// dA for each section function Phi_alpha [length^2].
    Vector
    traction(const Vector &field) const;

    /// Returns M w for each column w of @p fields (M of the energy norm).
    FieldColumns
    metric(const FieldColumns &fields) const;

    /// Returns a basis, orthonormal in the energy norm, of the displacements
    /// @p snapshots without rigid motions and without the span of the columns
    /// @p known, by proper orthogonal decomposition. Each snapshot is
    /// orthogonalized to the rigid motions and the columns @p warpings, scaled
    /// to unit norm, then orthogonalized to @p known, which must include
    /// @p warpings. Eigenvectors of the Gram matrix with eigenvalues above
    /// @p tolerance^2 max(1, largest eigenvalue) form the basis. Snapshots that
    /// are zero up to rounding before scaling are ignored.
    FieldColumns
    basis(const std::vector<Vector> &snapshots,
          const FieldColumns        &warpings,
          const FieldColumns        &known,
          const double               tolerance) const;

    /// Returns the energy norms of the components of @p snapshots orthogonal to
    /// the rigid motions and to the columns @p warpings.
    std::vector<double>
    strengths(const std::vector<Vector> &snapshots,
              const FieldColumns        &warpings) const;

    /// Returns a basis of @p snapshots as basis() does, but without scaling
    /// them to unit norm, so that large snapshots have more weight. Basis
    /// functions are in the order of descending eigenvalues.
    FieldColumns
    weighted_basis(const std::vector<Vector> &snapshots,
                   const FieldColumns        &warpings,
                   const FieldColumns        &known,
                   const double               tolerance) const;

  private:
    /// Displacements orthogonalized to rigid motions and given warpings, their
    /// products with the matrix of the energy norm, and their norms.
    struct WarpingFields
    {
      FieldColumns        fields, metrics;
      std::vector<double> norms;
    };
    WarpingFields
    remove_rigid_parts_of(const std::vector<Vector> &snapshots,
                          const FieldColumns        &warpings) const;

    const Section &section;
    double         smaller_extent;
    Matrix         metric_matrix; ///< Matrix S_00 + (0.1 / H)^2 S_11.
    /// Integrals int R_r . Phi_alpha dA of rigid motions and section functions,
    /// and the inverse of the matrix int R_r . R_s dA.
    std::vector<Vector>              rigid_products;
    dealii::LAPACKFullMatrix<double> inverse;
  };

  /// Returns a basis of the columns of X = @p fields, orthonormal in the inner
  /// product of a matrix M with M X = @p metrics: X U Lambda^(-1/2), with those
  /// eigenvectors U of X^T M X whose eigenvalues Lambda exceed @p tolerance^2
  /// max(1, largest eigenvalue), in descending order.
  FieldColumns
  orthonormal(const FieldColumns &fields,
              const FieldColumns &metrics,
              const double        tolerance);

  /// Returns column @p j of @p columns as a vector.
  Vector
  column_of(const FieldColumns &columns, const unsigned int j);

  /// Returns the columns with the indices @p numbers, in this order.
  FieldColumns
  selected_columns(const FieldColumns              &columns,
                   const std::vector<unsigned int> &numbers);

  /// Returns the matrix [a, b]: the columns of @p a followed by those of @p b.
  FieldColumns
  beside(const FieldColumns &a, const FieldColumns &b);

  /// Returns true if the sections @p a and @p b have the same cells and elastic
  /// constants, up to relative differences of 1e-9. Their theories may differ,
  /// but only theories of the same degree have the same curved cells.
  bool
  have_same_cells(const Section &a, const Section &b);

  /// Projects the displacements @p fields from the section @p from onto the
  /// section functions Phi_alpha of the section @p to, which has the same cells
  /// (have_same_cells()). Each column of @p fields has the coefficients of a
  /// displacement w. The result has the coefficients of its best approximation
  /// v over the area,
  ///   int Phi_alpha . (v - w) dA = 0   for all alpha,
  /// with the integration points of @p to. If the functions of @p to contain
  /// those of @p from (LE-p contains LE-q for p > q), v = w. Throws
  /// NumericsError if the functions of @p to are linearly dependent.
  std::vector<Vector>
  embedded(const FieldColumns &fields, const Section &from, const Section &to);
} // namespace lamella

#endif
