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
  /// Indices of the quantities that multiply a section function at a point of
  /// the axis: its amplitude and derivatives of it.
  namespace FieldPart
  {
    constexpr unsigned int value = 0, ///< Amplitude q.
      shear_value = 1, ///< Amplitude in transverse shear strains (assumed).
      derivative  = 2, ///< Derivative q' along y.
      /// Number of kinds.
      n = 3;
  } // namespace FieldPart

  /// Coefficients of section functions for each FieldPart (value, shear value,
  /// derivative), or the conjugate forces. Rows are section functions, columns
  /// are points (stations) of the axis.
  using FieldParts = std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

  /// Returns zero matrices of @p n_fields rows and @p n_stations columns.
  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations);

  /// Generalized forces conjugate to coefficients of section functions, and
  /// strain energy per length, at points (stations) of the axis.
  struct SectionForces
  {
    /// Constructs zero forces of @p n_fields functions at @p n_stations points.
    explicit SectionForces(const unsigned int n_fields   = 0,
                           const unsigned int n_stations = 0)
      : work(field_parts(n_fields, n_stations))
      , energy(n_stations, 0.)
    {}

    /// Forces conjugate to amplitudes [force / length] and derivatives [force].
    FieldParts work;
    /// Strain energy per length at each station [force].
    std::vector<double> energy;
  };

  /// Converts @p forces, conjugate to the section functions of a Section, to
  /// forces conjugate to the functions number @p list (or modes) of @p space.
  SectionForces
  on_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces);

  /// Computes the generalized forces of a section (linear kinematics). The
  /// amplitudes q of its functions Phi and their derivatives q' along the axis
  /// y determine the strain,
  ///   epsilon = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
  /// the generalized forces with the section matrices S_pq,
  ///   W_0 = int D_s^T C epsilon dA = S_00 q + S_01 q',
  ///   W_1 = int D_y^T C epsilon dA = S_10 q + S_11 q',
  /// and the energy per length (q . W_0 + q' . W_1) / 2. For assumed transverse
  /// shear strains, q has other values in these strains (FieldPart).
  ///
  /// All implementations (make_section_operator()) compute strains before they
  /// multiply by stiffnesses, so small slopes of axis and section cancel
  /// exactly in rigid motions. Keeps a reference to the SectionSpace.
  class SectionOperator
  {
  public:
    /// Constructs the operator of the functions number @p list of @p space,
    /// ascending. largest_rotation() uses every @p stride-th integration point.
    SectionOperator(const SectionSpace       &space,
                    std::vector<unsigned int> list,
                    const unsigned int        stride = 1)
      : space(space)
      , list(std::move(list))
      , stride(stride)
    {}

    virtual ~SectionOperator() = default;

    /// Returns the indices of this operator's functions in the SectionSpace.
    const std::vector<unsigned int> &
    fields() const
    {
      return list;
    }

    /// Returns the generalized forces conjugate to the amplitudes [length] and
    /// derivatives [no unit] in @p q, and the energy per length. Forces of
    /// transverse shear strains are separate (FieldPart::shear_value).
    virtual SectionForces
    forces(const FieldParts &q) const = 0;

    /// Returns the rows of the section matrices S_00, S_01, S_10, S_11 and
    /// Section::S_shear() for fields(). Rows of other functions are empty.
    virtual std::vector<FactorRow>
    stiffness() const = 0;

    /// Returns the largest rotation |curl u| / 2 [rad] for coefficients @p q.
    double
    largest_rotation(const FieldParts &q) const;

  protected:
    const SectionSpace             &space; ///< Available functions.
    const std::vector<unsigned int> list;  ///< Indices in `space`.

  private:
    const unsigned int stride;
  };

  /// Creates the operator of the functions number @p list of @p space,
  /// ascending, rigid ones first: a ProductSectionOperator if possible, else a
  /// PointwiseSectionOperator. @p assumed_shear is true if transverse shear
  /// strains along the axis are assumed.
  std::unique_ptr<const SectionOperator>
  make_section_operator(const SectionSpace       &space,
                        std::vector<unsigned int> list,
                        const bool                assumed_shear);
} // namespace lamella

#endif
