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
  /// Displacements over a section, one per column: entry (alpha, j) is the
  /// coefficient of the section function Phi_alpha in displacement j.
  using FieldColumns = dealii::LAPACKFullMatrix<double>;

  /// All functions that nodes of a beam may use: first the section functions of
  /// a Section, then modes. A mode is a linear combination of section
  /// functions: a Saint-Venant warping, a response to a harmonic load, or a
  /// boundary-layer mode. Different nodes may use different functions.
  ///
  /// A *dense* list has only the six rigid functions and modes, so its cost
  /// does not depend on the number of section functions. The matrices of these
  /// dense functions, numbered 0 ... n_dense() - 1,
  ///   B^T S_pq B,   B = [rigid functions, modes],
  /// are computed once. Immutable; shares the ownership of the section.
  class SectionSpace
  {
  public:
    /// Constructs a space of the section functions without modes.
    explicit SectionSpace(std::shared_ptr<const Section> section);

    /// Constructs a space with the modes @p columns. Not for EBBT and TBT.
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

    /// Returns the number of section functions and modes.
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

    /// Returns the number of dense functions, i.e. rigid functions and modes.
    unsigned int
    n_dense() const
    {
      return n_rigid + n_modes();
    }

    /// Returns the number of function @p alpha among the dense functions;
    /// n_dense() if it is not dense.
    unsigned int
    dense_number(const unsigned int alpha) const
    {
      return alpha < n_rigid ?
               alpha :
               (alpha < first_mode() ? n_dense() :
                                       alpha - first_mode() + n_rigid);
    }

    /// Returns whether there are modes and all functions @p list are dense.
    bool
    is_dense(const std::vector<unsigned int> &list) const;

    /// Returns the level of @p alpha in the elimination order; 1 for modes.
    unsigned int
    level(const unsigned int alpha) const
    {
      return alpha < first_mode() ? base->field(alpha).level : 1;
    }

    /// Returns for each function its largest displacement |Phi_alpha| at the
    /// integration points, or 1 if it is zero there.
    const std::vector<double> &
    sizes() const
    {
      return of_fields;
    }

    /// Returns the coefficients of function @p alpha in the section functions.
    Vector
    in_section_functions(const unsigned int alpha) const;

    /// Converts @p coefficients of all n_fields() functions to coefficients of
    /// the section functions, which then include the modes.
    void
    expand(std::vector<double> &coefficients) const;

    /// Appends the generalized forces on modes to the forces @p work on the
    /// section functions, the transpose of expand().
    void
    append_modes(std::vector<double> &work) const;

    /// Converts coefficients @p q of the functions @p list, one row each, to
    /// coefficients of the section functions.
    dealii::LAPACKFullMatrix<double>
    in_section(const std::vector<unsigned int>        &list,
               const dealii::LAPACKFullMatrix<double> &q) const;

    /// Returns the generalized forces on the functions @p list from the forces
    /// @p work on the section functions, the transpose of in_section().
    dealii::LAPACKFullMatrix<double>
    on_list(const std::vector<unsigned int>        &list,
            const dealii::LAPACKFullMatrix<double> &work) const;

    /// Returns the coefficients of mode @p j in the section functions.
    const double *
    mode(const unsigned int j) const
    {
      return &modes(0, j);
    }

    /// Returns the matrix B^T S_pq B of dense functions; empty without modes.
    const dealii::LAPACKFullMatrix<double> &
    dense_S(const unsigned int p, const unsigned int q) const
    {
      return dense[2 * p + q];
    }

    /// Returns the rows of the section matrices S_pq, restricted to the
    /// functions whose flag in @p carried is true; other rows are empty.
    std::vector<FactorRow>
    rows(const std::vector<bool> &carried) const;

  private:
    static constexpr unsigned int n_rigid = RigidField::n_all;

    /// Returns S B for one of the five section matrices S.
    dealii::LAPACKFullMatrix<double>
    times_dense(const Matrix &S) const;

    /// Computes the result of sizes().
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
