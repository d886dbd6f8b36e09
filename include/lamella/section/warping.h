// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_warping_h
#define lamella_section_warping_h

#include <lamella/section/section_space.h>

namespace lamella
{
  /// Comparison and reduction of section fields by their warping, the part
  /// without the six rigid motions of the section in the inner product of the
  /// area,
  ///   w <- w - sum_r c_r R_r   with   int R_s . w dA = 0   for all s,
  /// with the norm
  ///   |w|^2 = w^T (S_00 + (0.1 / H)^2 S_11) w,
  /// the energy of a field whose amplitude varies along the axis over some ten
  /// heights H of the section. Refers to the section, which must have a
  /// rotation about y.
  class Warping
  {
  public:
    explicit Warping(const Section &section);

    /// Returns H, the smaller extent of the section's box [length].
    double
    height() const
    {
      return smaller_extent;
    }

    /// Makes @p field orthogonal to the rigid fields over the area.
    void
    remove_rigid(Vector &field) const;

    /// Returns int Phi_alpha . w dA for each field alpha of the section, with w
    /// = @p field [length^2]: the load vector of the traction w.
    Vector
    traction(const Vector &field) const;

    /// Returns (S_00 + (0.1 / H)^2 S_11) w.
    Vector
    metric(const Vector &field) const;
    /// Returns metric() of each column.
    FieldColumns
    metric(const FieldColumns &fields) const;

    /// Returns an orthonormal basis, in the product of metric(), of what
    /// @p snapshots add to the rigid fields and @p known. Each is made
    /// orthogonal to the rigid fields and the columns @p warpings and scaled to
    /// unit norm, then made orthogonal to @p known, which contain the warpings.
    /// The basis has the eigenvectors of the Gram matrix of the rest with
    /// eigenvalues above @p tolerance^2 times the largest, or times 1 if that
    /// is less (proper orthogonal decomposition). Snapshots that are warpings
    /// up to rounding are dropped.
    FieldColumns
    basis(const std::vector<Vector> &snapshots,
          const FieldColumns        &warpings,
          const FieldColumns        &known,
          const double               tolerance) const;

    /// Returns the norms of @p snapshots without their rigid part and the
    /// columns @p warpings.
    std::vector<double>
    strengths(const std::vector<Vector> &snapshots,
              const FieldColumns        &warpings) const;

    /// Returns a basis() of snapshots that are not scaled, the strongest
    /// combination first, cut below @p tolerance. They are made orthogonal to
    /// @p warpings and then to @p known, which contain these.
    FieldColumns
    weighted_basis(const std::vector<Vector> &snapshots,
                   const FieldColumns        &warpings,
                   const FieldColumns        &known,
                   const double               tolerance) const;

  private:
    /// Fields without rigid parts and warpings, their metric() and their norms.
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
    /// Matrix S_00 + (0.1 / H)^2 S_11.
    Matrix metric_matrix;
    /// Products int R_r . Phi_alpha dA, and the inverse among rigid fields.
    std::vector<Vector>              rigid_products;
    dealii::LAPACKFullMatrix<double> inverse;
  };

  /// Returns columns that span @p fields and are orthonormal in a product M,
  /// where @p metrics are M times the fields: X U Lambda^(-1/2). The
  /// eigenvectors U of the Gram matrix X^T M X have eigenvalues above
  /// @p tolerance^2 times the largest, or times 1 if that is less.
  FieldColumns
  orthonormal(const FieldColumns &fields,
              const FieldColumns &metrics,
              const double        tolerance);

  /// Returns column @p j as a field.
  Vector
  column_of(const FieldColumns &columns, const unsigned int j);

  /// Returns the columns @p numbers, in their order.
  FieldColumns
  selected_columns(const FieldColumns              &columns,
                   const std::vector<unsigned int> &numbers);

  /// Returns [a, b]: the columns of @p a and then those of @p b.
  FieldColumns
  beside(const FieldColumns &a, const FieldColumns &b);
} // namespace lamella

#endif
