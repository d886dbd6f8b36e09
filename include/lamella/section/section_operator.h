// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_operator_h
#define lamella_section_section_operator_h

#include <lamella/linear/factor_row.h>
#include <lamella/section/section_space.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// Parts of a field at a station of the axis, factors of strains and
  /// conjugates of work: its value q_alpha, its value in transverse shear
  /// (separate for assumed strains), and its derivative along y.
  namespace FieldPart
  {
    constexpr unsigned int value = 0, shear_value = 1, derivative = 2, n = 3;
  } // namespace FieldPart

  /// Numbers for each FieldPart, a row per field, a column per station.
  using FieldParts = std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

  /// Returns zeros of @p n_fields rows and @p n_stations columns.
  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations);

  /// Generalized forces of a section at stations of the axis, conjugate to the
  /// coefficients of its fields, and the strain energy per length.
  struct SectionForces
  {
    explicit SectionForces(const unsigned int n_fields   = 0,
                           const unsigned int n_stations = 0)
      : work(field_parts(n_fields, n_stations))
      , energy(n_stations, 0.)
    {}

    /// Forces per length: force / length on the two values, force on the
    /// derivatives, for coefficients that are lengths.
    FieldParts work;
    /// Energy per length of each station [force].
    std::vector<double> energy;
  };

  /// Returns the forces on the fields @p list of @p space from @p forces on all
  /// fields of its section.
  SectionForces
  on_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces);

  /**
   * The constitutive operator of a section for a list of its fields.
   * Coefficients q and q' at a station of the axis give the strain of Eq. 5
   *   epsilon = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
   * the generalized forces of Eq. 12 before integration over the axis,
   *   W_0 = int D_s^T C epsilon dA = S_00 q + S_01 q',
   *   W_1 = int D_y^T C epsilon dA = S_10 q + S_11 q',
   * the energy per length (q . W_0 + q' . W_1) / 2, and their derivatives, the
   * S_pq. Assumed transverse shear strains have a q of their own (FieldPart).
   *
   * Implementations (make_section_operator()) agree up to rounding. All compute
   * strains first: the slopes of the axis and of the sections of a slender beam
   * in rigid motion cancel while they are small. The operator is linear. Refers
   * to the space.
   */
  class SectionOperator
  {
  public:
    /// Constructs the operator of the fields @p list of @p space, ascending.
    /// Rotations use every @p stride-th point.
    SectionOperator(const SectionSpace       &space,
                    std::vector<unsigned int> list,
                    const unsigned int        stride = 1)
      : space(space)
      , list(std::move(list))
      , stride(stride)
    {}

    virtual ~SectionOperator() = default;

    /// Returns the list, in the numbers of the space.
    const std::vector<unsigned int> &
    fields() const
    {
      return list;
    }

    /// Returns W_0 in its two parts, W_1 and the energy for the coefficients
    /// @p q of the list [length] and their derivatives [no unit].
    virtual SectionForces
    forces(const FieldParts &q) const = 0;

    /// Returns for each field of the list the row of S_00, S_01, S_10, S_11 and
    /// of the transverse shear part of S_00, as in Section::S(). Rows of other
    /// fields of the space are empty.
    virtual std::vector<FactorRow>
    stiffness() const = 0;

    /// Returns the largest rotation curl u / 2 [rad] for the coefficients @p q.
    double
    largest_rotation(const FieldParts &q) const;

  protected:
    const SectionSpace             &space;
    const std::vector<unsigned int> list;

  private:
    const unsigned int stride;
  };

  /// Returns the operator of the fields @p list of @p space, ascending, with or
  /// without @p assumed_shear on the axis: a ProductSectionOperator if all
  /// fields span the whole section, else a PointwiseSectionOperator. A nonempty
  /// list begins with the rigid fields.
  std::unique_ptr<const SectionOperator>
  make_section_operator(const SectionSpace       &space,
                        std::vector<unsigned int> list,
                        const bool                assumed_shear);
} // namespace lamella

#endif
