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
  /// Kinds of coefficients of a section function at a point of the axis: its
  /// amplitude q, its amplitude in transverse shear strains (different if these
  /// are assumed), and the derivative q' along y.
  namespace FieldPart
  {
    constexpr unsigned int value = 0, shear_value = 1, derivative = 2, n = 3;
  } // namespace FieldPart

  /// Coefficients, or conjugate forces, for each FieldPart. Rows are section
  /// functions, columns are points (stations) of the axis.
  using FieldParts = std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

  /// Returns zero matrices of @p n_fields rows and @p n_stations columns.
  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations);

  /// Generalized forces conjugate to coefficients of section functions, and
  /// strain energy per length, at points (stations) of the axis.
  struct SectionForces
  {
    explicit SectionForces(const unsigned int n_fields   = 0,
                           const unsigned int n_stations = 0)
      : work(field_parts(n_fields, n_stations))
      , energy(n_stations, 0.)
    {}

    /// Generalized forces: force / length on the amplitudes, force on the
    /// derivatives, if coefficients are lengths.
    FieldParts work;
    /// Strain energy per length at each station [force].
    std::vector<double> energy;
  };

  /// Returns, from @p forces conjugate to all section functions, the forces
  /// conjugate to the functions @p list of @p space.
  SectionForces
  on_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces);

  /// Computes the generalized forces of a section (linear kinematics) from the
  /// coefficients of its functions. Coefficients q and their derivatives q'
  /// along y at a point (station) of the axis determine the strain,
  ///   epsilon = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
  /// the generalized forces with the section matrices S_pq,
  ///   W_0 = int D_s^T C epsilon dA = S_00 q + S_01 q',
  ///   W_1 = int D_y^T C epsilon dA = S_10 q + S_11 q',
  /// and the energy per length (q . W_0 + q' . W_1) / 2. For assumed transverse
  /// shear strains, q has other values in these strains (see FieldPart).
  ///
  /// All implementations (see make_section_operator()) compute strains before
  /// they multiply by stiffnesses. Thus the small slopes of the axis and the
  /// sections cancel exactly in rigid motions of slender beams. Keeps a
  /// reference to the SectionSpace.
  class SectionOperator
  {
  public:
    /// Constructs the operator of the functions @p list of @p space, ascending.
    /// largest_rotation() samples every @p stride-th integration point.
    SectionOperator(const SectionSpace       &space,
                    std::vector<unsigned int> list,
                    const unsigned int        stride = 1)
      : space(space)
      , list(std::move(list))
      , stride(stride)
    {}

    virtual ~SectionOperator() = default;

    /// Returns the numbers of the functions in the SectionSpace.
    const std::vector<unsigned int> &
    fields() const
    {
      return list;
    }

    /// Returns W_0, with its transverse shear part separate (FieldPart), W_1
    /// and the energy per length for the coefficients @p q [length] and q' [no
    /// unit].
    virtual SectionForces
    forces(const FieldParts &q) const = 0;

    /// Returns the rows of S_00, S_01, S_10, S_11 and Section::S_shear() for
    /// the functions of the list. Rows of other functions are empty.
    virtual std::vector<FactorRow>
    stiffness() const = 0;

    /// Returns the largest rotation |curl u| / 2 [rad] for coefficients @p q.
    double
    largest_rotation(const FieldParts &q) const;

  protected:
    const SectionSpace             &space;
    const std::vector<unsigned int> list;

  private:
    const unsigned int stride;
  };

  /// Creates the operator of the functions @p list of @p space, ascending,
  /// beginning with the rigid functions: a ProductSectionOperator if possible,
  /// else a PointwiseSectionOperator. @p assumed_shear is true if transverse
  /// shear strains along the axis are assumed.
  std::unique_ptr<const SectionOperator>
  make_section_operator(const SectionSpace       &space,
                        std::vector<unsigned int> list,
                        const bool                assumed_shear);
} // namespace lamella

#endif
