// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_answer_h
#define lamella_section_section_answer_h

#include <lamella/linear/factor_row.h>
#include <lamella/section/field_space.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /**
   * What multiplies the strains of a field at a station of the axis, and what
   * does work there: the field's value q_alpha in all strains but transverse
   * shear, its value in transverse shear (of its own where the axis assumes
   * these strains), and its derivative along y.
   */
  namespace FieldPart
  {
    constexpr unsigned int value = 0, shear_value = 1, derivative = 2, n = 3;
  } // namespace FieldPart

  /// Of each FieldPart a number for each field of a list, a row each, at each
  /// of some stations of the axis, a column each.
  using FieldParts = std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

  /// That with @p n_fields rows and @p n_stations columns, all zero.
  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations);

  /**
   * What a section does at some stations of the axis: the generalised forces
   * that are conjugate to the coefficients of its fields, and the strain energy
   * per length of the beam.
   */
  struct SectionForces
  {
    explicit SectionForces(const unsigned int n_fields   = 0,
                           const unsigned int n_stations = 0)
      : work(field_parts(n_fields, n_stations))
      , energy(n_stations, 0.)
    {}

    /// Per length of the beam, for coefficients that are lengths: on the two
    /// values in force / length, on the derivatives in force.
    FieldParts work;
    /// [force], of each station.
    std::vector<double> energy;
  };

  /// Those of the fields @p list of @p space from @p forces, those of all
  /// fields of its section (FieldSpace::on_list()).
  SectionForces
  on_list(const FieldSpace                &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces);

  /**
   * What a section answers to a list of its fields: with their coefficients q
   * and q' at a station of the axis, the strain
   *   epsilon = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha
   * of Eq. 5 makes the generalised forces of Eq. 12 before its integral over
   * the axis is taken,
   *   W_0 = int D_s^T C epsilon dA = S_00 q + S_01 q',
   *   W_1 = int D_y^T C epsilon dA = S_10 q + S_11 q',
   * the energy per length (q . W_0 + q' . W_1) / 2, and their derivatives, the
   * S_pq. Where transverse shear strains are assumed their part of q is another
   * one (FieldPart).
   *
   * A beam asks it all along its axis and knows no more of its section than
   * this. Which implementation answers depends on the section and the list
   * (make_section_answer()); they agree up to rounding. In all of them strains
   * come before anything that multiplies them: what cancels in a slender beam
   * that moves rigidly, the slope of the axis and that of its sections, does so
   * while it is small. The section is linear, so that stiffness() holds for all
   * q.
   *
   * Refers to the space, which lives longer.
   */
  class SectionAnswer
  {
  public:
    /// To the fields @p list of @p space, ascending. Of the section's points
    /// every one of @p stride is looked at for rotations.
    SectionAnswer(const FieldSpace         &space,
                  std::vector<unsigned int> list,
                  const unsigned int        stride = 1)
      : space(space)
      , list(std::move(list))
      , stride(stride)
    {}

    virtual ~SectionAnswer() = default;

    /// The list, in the numbers of the space.
    const std::vector<unsigned int> &
    fields() const
    {
      return list;
    }

    /// W_0 in its two parts and W_1, and the energy, for the coefficients @p q
    /// of the list [length] and their derivatives [no unit].
    virtual SectionForces
    forces(const FieldParts &q) const = 0;

    /// The derivatives of the forces: of each field of the space the row of
    /// S_00, S_01, S_10, S_11 and of the part of S_00 in transverse shear;
    /// empty for fields that are not in the list. Where no shear is assumed the
    /// last multiplies nothing and may be zero. Units are those of
    /// Section::S().
    virtual std::vector<FactorRow>
    stiffness() const = 0;

    /// The largest rotation in the section's points (SectionPoint), curl u / 2
    /// [rad], at the stations that @p q is of.
    double
    largest_rotation(const FieldParts &q) const;

  protected:
    const FieldSpace               &space;
    const std::vector<unsigned int> list;

  private:
    const unsigned int stride;
  };

  /**
   * The one that suits the fields @p list of @p space, ascending, on an axis
   * that has assumed transverse shear strains or not: a ProductAnswer where all
   * fields live on the whole section and are coupled anyway, a PointAnswer for
   * all others. A list that is not empty begins with the rigid fields that the
   * section has.
   */
  std::unique_ptr<const SectionAnswer>
  make_section_answer(const FieldSpace         &space,
                      std::vector<unsigned int> list,
                      const bool                assumed_shear);
} // namespace lamella

#endif
