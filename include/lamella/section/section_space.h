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
  /// A matrix whose columns are displacements over a section: entry (alpha, j)
  /// is the amplitude of section function number alpha in displacement j.
  using FieldColumns = dealii::LAPACKFullMatrix<double>;

  /// All functions of x and z with which the nodes of a beam may describe the
  /// displacement of a section: first the section functions of a Section, then
  /// modes. A mode is a linear combination of section functions: a Saint-Venant
  /// warping, the displacement due to a harmonic load, or a boundary-layer
  /// mode. Nodes may use different functions.
  ///
  /// Modes and the six rigid section functions are called *dense*, since they
  /// are nonzero on the whole section. With the columns B of the dense
  /// functions and the section matrices S_pq (see Section), the matrices B^T
  /// S_pq B are computed once. Immutable; shares the ownership of the section.
  class SectionSpace
  {
  public:
    /// Constructs the space of the functions of @p section, without modes.
    explicit SectionSpace(std::shared_ptr<const Section> section);

    /// Constructs the space with @p columns as modes. Not for EBBT and TBT.
    SectionSpace(std::shared_ptr<const Section> section,
                 const FieldColumns            &columns);

    /// Returns the cross-section.
    const Section &
    section() const
    {
      return *base;
    }

    /// Returns the cross-section with shared ownership.
    std::shared_ptr<const Section>
    shared_section() const
    {
      return base;
    }

    /// Returns the number of functions: section functions and modes.
    unsigned int
    n_fields() const
    {
      return base->n_fields() + n_modes();
    }

    /// Returns the number of modes.
    unsigned int
    n_modes() const
    {
      return modes.n();
    }

    /// Returns the index of the first mode, the number of section functions.
    unsigned int
    first_mode() const
    {
      return base->n_fields();
    }

    /// Returns the number of dense functions: rigid functions and modes.
    unsigned int
    n_dense() const
    {
      return n_rigid + n_modes();
    }

    /// Returns the index of function @p alpha among the dense functions (rigid
    /// section functions, then modes); n_dense() if it is neither.
    unsigned int
    dense_number(const unsigned int alpha) const
    {
      return alpha < n_rigid ?
               alpha :
               (alpha < first_mode() ? n_dense() :
                                       alpha - first_mode() + n_rigid);
    }

    /// Returns true if there are modes, and each function in @p list is a rigid
    /// section function or a mode.
    bool
    is_dense(const std::vector<unsigned int> &list) const;

    /// Returns the level of function @p alpha: supports eliminate DoFs of low
    /// levels first. It is 0 for section functions linear in x and z, higher
    /// for other ones, and 1 for modes.
    unsigned int
    level(const unsigned int alpha) const
    {
      return alpha < first_mode() ? base->field(alpha).level : 1;
    }

    /// Returns the largest displacement |Phi_alpha| of each section function
    /// and mode at the integration points; 1 for functions that are zero there.
    const std::vector<double> &
    sizes() const
    {
      return of_fields;
    }

    /// Returns function @p alpha as coefficients of the section functions.
    Vector
    in_section_functions(const unsigned int alpha) const;

    /// Converts @p coefficients of all section functions and modes to
    /// coefficients of the section functions alone.
    void
    expand(std::vector<double> &coefficients) const;

    /// Returns displacements as coefficients of the section functions. Column k
    /// of @p q has the amplitudes of the functions @p list in displacement k.
    dealii::LAPACKFullMatrix<double>
    in_section(const std::vector<unsigned int>        &list,
               const dealii::LAPACKFullMatrix<double> &q) const;

    /// Returns the generalized forces on the functions @p list, from the forces
    /// @p work on the section functions; this is the transpose of in_section().
    dealii::LAPACKFullMatrix<double>
    on_list(const std::vector<unsigned int>        &list,
            const dealii::LAPACKFullMatrix<double> &work) const;

    /// Returns the coefficients of mode @p j, one per section function.
    const double *
    mode(const unsigned int j) const
    {
      return &modes(0, j);
    }

    /// Returns B^T S_pq B with the section matrix S_pq and the columns B of the
    /// rigid section functions and modes; empty without modes.
    const dealii::LAPACKFullMatrix<double> &
    dense_S(const unsigned int p, const unsigned int q) const
    {
      return dense[2 * p + q];
    }

    /// Returns the rows of the section matrices S_pq over section functions and
    /// modes. Only functions whose flag in @p carried is true have entries.
    std::vector<FactorRow>
    rows(const std::vector<bool> &carried) const;

    /// Returns the rows of the mass matrix int rho Phi_alpha . Phi_beta dA over
    /// section functions and modes [mass / length of the beam], with a density
    /// rho for each ply, as FactorRow::entries[0]; its other entries are zero.
    /// Only functions whose flag in @p carried is true have entries.
    std::vector<FactorRow>
    mass_rows(const std::vector<double> &densities,
              const std::vector<bool>   &carried) const;

  private:
    static constexpr unsigned int n_rigid = RigidField::n_all;

    /// Returns S B for one of the five section matrices S, with the columns B
    /// of the rigid section functions and modes.
    dealii::LAPACKFullMatrix<double>
    times_dense(const Matrix &S) const;

    /// Computes the largest displacement of each function, see sizes().
    std::vector<double>
    measured() const;

    std::shared_ptr<const Section> base;
    FieldColumns                   modes;
    std::vector<double>            of_fields;
    /// Products B^T S B for S_00, S_01, S_10, S_11 and S_shear; see dense_S().
    std::array<dealii::LAPACKFullMatrix<double>, 5> dense;
  };
} // namespace lamella

#endif
