// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_field_space_h
#define lamella_section_field_space_h

#include <lamella/linear/factor_row.h>
#include <lamella/section/section.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// Fields of a section, a column each, in its own fields Phi_alpha: column j
  /// is the field sum_alpha c_(alpha j) Phi_alpha. n_fields() rows, stored
  /// column by column.
  using FieldColumns = dealii::LAPACKFullMatrix<double>;

  /**
   * What the nodes of a beam may carry: the fields of a section and further
   * ones that are combinations of these, its modes (Saint-Venant fields,
   * response fields and end fields). All live in one space, so they share S_pq,
   * and nodes with different lists are neighbours without any treatment.
   *
   * The fields are numbered through: those of the section first, as it numbers
   * them, then the modes. A *dense* list has the six rigid fields and modes and
   * nothing else: what a body of dense lists costs does not depend on the
   * number of the section's fields any more. The rigid fields and the modes
   * together, in this order, are the dense fields, numbered 0 ...
   * n_dense() - 1.
   *
   * Products of modes are made once, S_pq between any two dense fields,
   *   B^T S_pq B,   B = [rigid fields, modes],
   * in n_fields() x n_dense() numbers and as many squared. Immutable; shares
   * the section.
   */
  class FieldSpace
  {
  public:
    /// Those of the section and no modes.
    explicit FieldSpace(std::shared_ptr<const Section> section);

    /// With the modes @p columns, which have as many rows as the section has
    /// fields. A section of EBBT or TBT has no rotation about y: none of these.
    FieldSpace(std::shared_ptr<const Section> section, FieldColumns columns);

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

    /// Of the section and modes together.
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

    /// The number of the first mode.
    unsigned int
    first_mode() const
    {
      return base->n_fields();
    }

    /// The rigid fields and the modes.
    unsigned int
    n_dense() const
    {
      return n_rigid + n_modes();
    }

    /// The number among the dense fields of the field @p alpha, or n_dense() of
    /// a field of the section that is not rigid.
    unsigned int
    dense_number(const unsigned int alpha) const
    {
      return alpha < n_rigid ?
               alpha :
               (alpha < first_mode() ? n_dense() :
                                       alpha - first_mode() + n_rigid);
    }

    /// Whether the fields @p list are dense, and modes among what there is.
    bool
    is_dense(const std::vector<unsigned int> &list) const;

    /// Coarse fields are eliminated before others (SectionField::level); modes
    /// are warping.
    unsigned int
    level(const unsigned int alpha) const
    {
      return alpha < first_mode() ? base->field(alpha).level : 1;
    }

    /// Of each field the largest displacement that a unit of it makes at the
    /// integration points; 1 of one that makes none there.
    const std::vector<double> &
    sizes() const
    {
      return of_fields;
    }

    /// The field @p alpha as numbers for the fields of the section.
    Vector
    in_section_fields(const unsigned int alpha) const;

    /// Turns numbers for all fields into numbers for those of the section:
    /// adds what the modes are made of to the first entries of @p coefficients
    /// (n_fields() of them) and cuts the rest off.
    void
    expand(std::vector<double> &coefficients) const;

    /// The transpose of expand(): appends to the work @p work that is done on
    /// the fields of the section that on the modes.
    void
    append_modes(std::vector<double> &work) const;

    /// Numbers for the fields @p list, a row each of @p q, as numbers for those
    /// of the section: what the modes are made of is added to these. A column
    /// of them stands for itself.
    dealii::LAPACKFullMatrix<double>
    in_section(const std::vector<unsigned int>        &list,
               const dealii::LAPACKFullMatrix<double> &q) const;

    /// The transpose of in_section(): from the work on the fields of the
    /// section, a row each of @p work, that on those of @p list.
    dealii::LAPACKFullMatrix<double>
    on_list(const std::vector<unsigned int>        &list,
            const dealii::LAPACKFullMatrix<double> &work) const;

    /// What mode number @p j is made of: a number for each field of the
    /// section.
    const double *
    mode(const unsigned int j) const
    {
      return &modes(0, j);
    }

    /// S_pq between dense fields, in their numbering. Empty without modes.
    const dealii::LAPACKFullMatrix<double> &
    dense_S(const unsigned int p, const unsigned int q) const
    {
      return dense[2 * p + q];
    }

    /// The rows of S_pq at all fields of which @p carried is true (n_fields()
    /// of them); the others are empty, and columns of fields that are not
    /// carried are left out.
    std::vector<FactorRow>
    rows(const std::vector<bool> &carried) const;

  private:
    static constexpr unsigned int n_rigid = RigidField::n_all;

    /// S_pq B for one of the section's five matrices, n_fields() x n_dense().
    dealii::LAPACKFullMatrix<double>
    times_dense(const Matrix &S) const;

    /// sizes().
    std::vector<double>
    measured() const;

    std::shared_ptr<const Section> base;
    FieldColumns                   modes;
    std::vector<double>            of_fields;
    /// B^T S B for S_00, S_01, S_10, S_11 and S_shear.
    std::array<dealii::LAPACKFullMatrix<double>, 5> dense;
  };
} // namespace lamella

#endif
