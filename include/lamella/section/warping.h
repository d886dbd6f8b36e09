// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_warping_h
#define lamella_section_warping_h

#include <lamella/section/field_space.h>

namespace lamella
{
  /**
   * How fields of a section's own are compared and cut to a basis: warping is
   * what is left of a field without the six rigid motions of the section, in
   * the inner product of the area,
   *   w <- w - sum_r c_r R_r   with   int R_s . w dA = 0   for all s,
   * and is measured by
   *   |w|^2 = w^T (S_00 + (0.1 / H)^2 S_11) w,
   * the energy of a field whose amplitude varies along the axis over some ten
   * heights H of the section. (Taking out the amplitudes of the rigid fields
   * alone would not do: where a support frees the warping the section would
   * turn with it.)
   *
   * Refers to the section, which must have a rotation about y.
   */
  class Warping
  {
  public:
    explicit Warping(const Section &section);

    /// H: the smaller extent of the section's box [length].
    double
    height() const
    {
      return smaller_extent;
    }

    /// Makes @p field orthogonal to the rigid fields over the area.
    void
    remove_rigid(Vector &field) const;

    /// int Phi_alpha . w dA for each field alpha of the section, w the field
    /// @p field [length^2]: the load vector of the traction w.
    Vector
    traction(const Vector &field) const;

    /// (S_00 + (0.1 / H)^2 S_11) w.
    Vector
    metric(const Vector &field) const;
    /// That of each column.
    FieldColumns
    metric(const FieldColumns &fields) const;

    /**
     * An orthonormal basis, in the product of metric(), of what the fields
     * @p snapshots add to the rigid fields and the columns @p known. Each is
     * made free of the rigid fields and the columns @p warpings and scaled to
     * unit norm (natural weights are wrong where stiffnesses differ by 1000),
     * then made free of @p known, which hold the warpings; of the Gram matrix
     * of what is left the eigenvectors are taken whose eigenvalues are above
     * @p tolerance^2 times the largest, or times 1 where that is less (proper
     * orthogonal decomposition). Snapshots that hold nothing beside the
     * warpings but rounding are left out.
     */
    FieldColumns
    basis(const std::vector<Vector> &snapshots,
          const FieldColumns        &warpings,
          const FieldColumns        &known,
          const double               tolerance) const;

    /// The norms of what is left of each of @p snapshots without its rigid part
    /// and the columns @p warpings; 0 where that is rounding.
    std::vector<double>
    strengths(const std::vector<Vector> &snapshots,
              const FieldColumns        &warpings) const;

    /// basis() of snapshots that bring their own weights: not scaled, and what
    /// is below @p tolerance is cut. Freed of the columns @p warpings and then
    /// of @p known, which hold these; the strongest combination first.
    FieldColumns
    weighted_basis(const std::vector<Vector> &snapshots,
                   const FieldColumns        &warpings,
                   const FieldColumns        &known,
                   const double               tolerance) const;

  private:
    /// Fields without their rigid parts and the warpings, a column each, their
    /// metric() and their norms (strengths()).
    struct Freed
    {
      FieldColumns        fields, metrics;
      std::vector<double> norms;
    };
    Freed
    freed(const std::vector<Vector> &snapshots,
          const FieldColumns        &warpings) const;

    const Section &section;
    double         smaller_extent;
    /// S_00 + (0.1 / H)^2 S_11.
    Matrix metric_matrix;
    /// int R_r . Phi_alpha dA, and the inverse of its part among the rigid
    /// fields.
    std::vector<Vector>              rigid_products;
    dealii::LAPACKFullMatrix<double> inverse;
  };

  /**
   * Columns that span what @p fields do and are orthonormal in a product M,
   * where @p metrics are M times the fields: X U Lambda^(-1/2) with the
   * eigenvectors U of the Gram matrix X^T M X whose eigenvalues are above
   * @p tolerance^2 times the largest, or times 1 where that is less.
   */
  FieldColumns
  orthonormal(const FieldColumns &fields,
              const FieldColumns &metrics,
              const double        tolerance);

  /// Column @p j as a field.
  Vector
  column_of(const FieldColumns &columns, const unsigned int j);

  /// The columns @p numbers, in their order.
  FieldColumns
  these_of(const FieldColumns              &columns,
           const std::vector<unsigned int> &numbers);

  /// [a, b]: the columns of the one and then the other.
  FieldColumns
  beside(const FieldColumns &a, const FieldColumns &b);
} // namespace lamella

#endif
