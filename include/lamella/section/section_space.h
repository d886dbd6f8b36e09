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
  /// Fields of a section, one per column: column j is the field sum_alpha
  /// c_(alpha j) Phi_alpha in the section's own fields. n_fields() rows.
  using FieldColumns = dealii::LAPACKFullMatrix<double>;

  /**
   * The fields of the nodes of a beam: those of a section, then modes,
   * combinations of these (Saint-Venant fields, response fields and
   * boundary-layer modes). All share S_pq, so nodes with different lists may be
   * neighbors.
   *
   * A *dense* list has only the six rigid fields and modes: its cost does not
   * depend on the number of the section's fields. S_pq between the dense
   * fields, numbered 0 ... n_dense() - 1,
   *   B^T S_pq B,   B = [rigid fields, modes],
   * is computed once. Immutable; shares the section.
   */
  class SectionSpace
  {
  public:
    /// Constructs a space of the section's fields without modes.
    explicit SectionSpace(std::shared_ptr<const Section> section);

    /// Constructs a space with the modes @p columns, of n_fields() rows each.
    /// Not for sections of EBBT or TBT.
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

    /// Returns the number of @p alpha among dense fields, or n_dense() if it is
    /// not.
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

    /// Returns the level of elimination, coarse first; modes are warping.
    unsigned int
    level(const unsigned int alpha) const
    {
      return alpha < first_mode() ? base->field(alpha).level : 1;
    }

    /// Returns for each field the largest displacement of its unit at the
    /// integration points, or 1.
    const std::vector<double> &
    sizes() const
    {
      return of_fields;
    }

    /// Returns the field @p alpha in the fields of the section.
    Vector
    in_section_functions(const unsigned int alpha) const;

    /// Changes @p coefficients of all n_fields() fields to those of the
    /// section's fields, adding modes to these.
    void
    expand(std::vector<double> &coefficients) const;

    /// Appends to @p work on the section's fields that on modes: expand()^T.
    void
    append_modes(std::vector<double> &work) const;

    /// Returns numbers @p q for the fields @p list, one row each, in the fields
    /// of the section.
    dealii::LAPACKFullMatrix<double>
    in_section(const std::vector<unsigned int>        &list,
               const dealii::LAPACKFullMatrix<double> &q) const;

    /// Returns the work on the fields @p list from @p work on those of the
    /// section: in_section()^T.
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

    /// Returns the rows and columns of S_pq of all @p carried fields
    /// (n_fields() flags); other rows are empty.
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
