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
  /// Parts of a field at a station of the axis, as factors of strains and as
  /// conjugates of work: its value q_alpha in all strains but transverse shear,
  /// its value in transverse shear (separate where the axis assumes these
  /// strains), and its derivative along y.
  namespace FieldPart
  {
    constexpr unsigned int value = 0, shear_value = 1, derivative = 2, n = 3;
  } // namespace FieldPart

  /// Numbers for each FieldPart, one row per field of a list, one column per
  /// station of the axis.
  using FieldParts = std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

  /// Returns zeros of @p n_fields rows and @p n_stations columns.
  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations);

  /// Generalized forces of a section at stations of the axis, conjugate to the
  /// coefficients of its fields, and the strain energy per length of the beam.
  struct SectionForces
  {
    explicit SectionForces(const unsigned int n_fields   = 0,
                           const unsigned int n_stations = 0)
      : work(field_parts(n_fields, n_stations))
      , energy(n_stations, 0.)
    {}

    /// Forces per length of the beam for coefficients that are lengths: force /
    /// length on the two values, force on the derivatives.
    FieldParts work;
    /// Energy per length of each station [force].
    std::vector<double> energy;
  };

  /// Returns the forces on the fields @p list of @p space from @p forces on all
  /// fields of its section (SectionSpace::on_list()).
  SectionForces
  on_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces);

  /**
   * The constitutive operator of a section for a list of its fields. With
   * coefficients q and q' at a station of the axis, the strain of Eq. 5
   *   epsilon = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha
   * gives the generalized forces of Eq. 12 before integration over the axis,
   *   W_0 = int D_s^T C epsilon dA = S_00 q + S_01 q',
   *   W_1 = int D_y^T C epsilon dA = S_10 q + S_11 q',
   * the energy per length (q . W_0 + q' . W_1) / 2, and their derivatives, the
   * S_pq. Assumed transverse shear strains have a q of their own (FieldPart).
   *
   * Implementations depend on the section and the list
   * (make_section_operator()) and agree up to rounding. All compute strains
   * first: the slopes of the axis and of the sections of a slender beam in
   * rigid motion cancel while they are small. The section is linear, so
   * stiffness() holds for all q. Refers to the space.
   */
  class SectionOperator
  {
  public:
    /// Constructs the operator of the fields @p list of @p space, ascending.
    /// Rotations use every @p stride-th point of the section.
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

    /// Returns for each field of the space the row of S_00, S_01, S_10, S_11
    /// and of the transverse shear part of S_00, which may be zero if no shear
    /// is assumed; empty for fields not in the list. Units as in Section::S().
    virtual std::vector<FactorRow>
    stiffness() const = 0;

    /// Returns the largest rotation curl u / 2 [rad] at the section's points
    /// (SectionPoint) and the stations of @p q.
    double
    largest_rotation(const FieldParts &q) const;

  protected:
    const SectionSpace             &space;
    const std::vector<unsigned int> list;

  private:
    const unsigned int stride;
  };

  /// Returns the operator of the fields @p list of @p space, ascending, with or
  /// without assumed transverse shear strains on the axis: a
  /// ProductSectionOperator if all fields span the whole section and couple
  /// anyway, else a PointwiseSectionOperator. A list that is not empty begins
  /// with the section's rigid fields.
  std::unique_ptr<const SectionOperator>
  make_section_operator(const SectionSpace       &space,
                        std::vector<unsigned int> list,
                        const bool                assumed_shear);
} // namespace lamella

#endif
