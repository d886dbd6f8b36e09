// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_space_h
#define lamella_section_section_space_h

#include <lamella/linear/factor_row.h>
#include <lamella/section/section.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// Fields of a section, one per column, in its own fields Phi_alpha: column j
  /// is the field sum_alpha c_(alpha j) Phi_alpha. n_fields() rows, stored by
  /// column.
  using FieldColumns = dealii::LAPACKFullMatrix<double>;

  /**
   * The fields that nodes of a beam may carry: those of a section, then modes,
   * combinations of these (Saint-Venant fields, response fields and end
   * fields). All share S_pq, so nodes with different lists may be neighbors.
   *
   * A *dense* list has only the six rigid fields and modes: its cost does not
   * depend on the number of the section's fields. The rigid fields and then the
   * modes are the dense fields, numbered 0 ... n_dense() - 1. S_pq between
   * them,
   *   B^T S_pq B,   B = [rigid fields, modes],
   * is computed once, in n_fields() x n_dense() numbers and as many squared.
   * Immutable; shares the section.
   */
  class SectionSpace
  {
  public:
    /// Constructs a space of the section's fields without modes.
    explicit SectionSpace(std::shared_ptr<const Section> section);

    /// Constructs a space with the modes @p columns, of n_fields() rows each.
    /// Not for sections of EBBT or TBT, without rotation about y.
    SectionSpace(std::shared_ptr<const Section> section, FieldColumns columns);

    const Section &
    section() const
    {
      return *base;
    }

    std::shared_ptr<const Section>
    shared_section() const
    {
      return base;
    }

    /// Returns the number of fields of the section and modes.
    unsigned int
    n_fields() const
    {
      return base->n_fields() + n_modes();
    }

    unsigned int
    n_modes() const
    {
      return modes.n();
    }

    /// Returns the number of the first mode.
    unsigned int
    first_mode() const
    {
      return base->n_fields();
    }

    /// Returns the number of rigid fields and modes.
    unsigned int
    n_dense() const
    {
      return n_rigid + n_modes();
    }

    /// Returns the number of @p alpha among dense fields, or n_dense() for a
    /// field of the section that is not rigid.
    unsigned int
    dense_number(const unsigned int alpha) const
    {
      return alpha < n_rigid ?
               alpha :
               (alpha < first_mode() ? n_dense() :
                                       alpha - first_mode() + n_rigid);
    }

    /// Returns true if there are modes and the fields @p list are dense.
    bool
    is_dense(const std::vector<unsigned int> &list) const;

    /// Returns the level of elimination, coarse first (SectionFunction::level);
    /// modes are warping.
    unsigned int
    level(const unsigned int alpha) const
    {
      return alpha < first_mode() ? base->field(alpha).level : 1;
    }

    /// Returns for each field the largest displacement of its unit at the
    /// integration points; 1 if that is zero.
    const std::vector<double> &
    sizes() const
    {
      return of_fields;
    }

    /// Returns the field @p alpha in the fields of the section.
    Vector
    in_section_functions(const unsigned int alpha) const;

    /// Changes @p coefficients of all n_fields() fields to those of the
    /// section's fields, adding modes to these and dropping the rest.
    void
    expand(std::vector<double> &coefficients) const;

    /// Appends to @p work on the fields of the section that on the modes, the
    /// transpose of expand().
    void
    append_modes(std::vector<double> &work) const;

    /// Returns numbers @p q for the fields @p list, one row each, in the fields
    /// of the section, modes included; columns are independent.
    dealii::LAPACKFullMatrix<double>
    in_section(const std::vector<unsigned int>        &list,
               const dealii::LAPACKFullMatrix<double> &q) const;

    /// Returns the work on the fields @p list from @p work on those of the
    /// section, one row each: the transpose of in_section().
    dealii::LAPACKFullMatrix<double>
    on_list(const std::vector<unsigned int>        &list,
            const dealii::LAPACKFullMatrix<double> &work) const;

    /// Returns the coefficients of mode @p j in the fields of the section.
    const double *
    mode(const unsigned int j) const
    {
      return &modes(0, j);
    }

    /// Returns S_pq between dense fields; empty without modes.
    const dealii::LAPACKFullMatrix<double> &
    dense_S(const unsigned int p, const unsigned int q) const
    {
      return dense[2 * p + q];
    }

    /// Returns the rows of S_pq of all @p carried fields (n_fields() flags),
    /// without columns of others; other rows are empty.
    std::vector<FactorRow>
    rows(const std::vector<bool> &carried) const;

  private:
    static constexpr unsigned int n_rigid = RigidField::n_all;

    /// Returns S_pq B for one of the five matrices, n_fields() x n_dense().
    dealii::LAPACKFullMatrix<double>
    times_dense(const Matrix &S) const;

    /// Returns the result of sizes().
    std::vector<double>
    measured() const;

    std::shared_ptr<const Section> base;
    FieldColumns                   modes;
    std::vector<double>            of_fields;
    /// Products B^T S B for S_00, S_01, S_10, S_11 and S_shear.
    std::array<dealii::LAPACKFullMatrix<double>, 5> dense;
  };
} // namespace lamella

#endif
