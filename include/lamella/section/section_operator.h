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

  /// A section operator that multiplies amplitudes q of section functions and
  /// derivatives q' by a dense matrix,
  ///   [W_0; W_1] = [S_00, S_01; S_10, S_11] [q; q'],
  /// where W_0 and W_1 are work-conjugate to q and q'. The matrix is computed
  /// from Section::moments() for TE-N, N > 1, and from SectionSpace::dense_S()
  /// for rigid functions and modes. With assumed shear strains, TE-N has a
  /// third block row and column for transverse shear.
  ///
  /// To avoid cancellation in slender beams, the shear strain q_w' + q_a / h of
  /// deflection w and slope a, with the reference length h, is summed before
  /// the matrix is applied. The force Q conjugate to this sum is added to the
  /// force on q_w', and Q / h to that on q_a.
  class ProductSectionOperator : public SectionOperator
  {
  public:
    /// Computes the matrix for the functions number @p fields of @p space, with
    /// assumed shear strains if @p assumed_shear. Requires is_possible().
    ProductSectionOperator(const SectionSpace       &space,
                           std::vector<unsigned int> fields,
                           const bool                assumed_shear);

    /// Returns true if dense matrices exist for the functions number @p fields:
    /// TE-N with N > 1, or rigid functions and modes without @p assumed_shear.
    static bool
    is_possible(const SectionSpace              &space,
                const std::vector<unsigned int> &fields,
                const bool                       assumed_shear);

    SectionForces
    forces(const FieldParts &q) const override;

    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// FieldPart of each block row: value and derivative, or all three.
    std::vector<unsigned int> parts;
    /// Matrix S with block columns in the order of the block rows.
    dealii::LAPACKFullMatrix<double> S;

    /// Returns the matrix entry of functions @p a, @p b for parts @p p, @p q.
    double
    product(const unsigned int p,
            const unsigned int q,
            const unsigned int a,
            const unsigned int b) const;

    /// Returns the first row in S of FieldPart @p p. Without assumed shear
    /// strains, FieldPart::shear_value has the rows of FieldPart::value.
    unsigned int
    first_row(const unsigned int p) const;

    /// Returns the entries of S_00, S_01, S_10, S_11 and of the transverse
    /// shear part of S_00 for the functions @p a, @p b.
    std::array<double, 5>
    entries(const unsigned int a, const unsigned int b) const;
  };

  /// A section operator that integrates strains, stresses and generalized
  /// forces over the integration points s of a section with weights w_s,
  ///   epsilon(x_s) = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
  ///   W_0 = sum_s w_s D_s^T C epsilon,   W_1 = sum_s w_s D_y^T C epsilon,
  /// see SectionOperator. It applies to any section. The cost per axis point is
  /// proportional to the number of points s times functions nonzero at each.
  class PointwiseSectionOperator : public SectionOperator
  {
  public:
    /// Constructs the operator of the functions number @p list of @p space.
    PointwiseSectionOperator(const SectionSpace       &space,
                             std::vector<unsigned int> list)
      : SectionOperator(space, std::move(list))
    {}

    SectionForces
    forces(const FieldParts &q) const override;

    /// Returns the stiffness rows of section functions and modes.
    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// The amplitude q of a section function and q', or the conjugate forces. q
    /// has one value per strain component: transverse shear may be assumed.
    struct Coefficient
    {
      Voigt  value;
      double derivative = 0.;
    };

    /// Coefficients of all section functions, axis point by axis point.
    using Coefficients = std::vector<Coefficient>;

    Coefficients
    coefficients(const FieldParts &q) const;

    /// Adds the forces and the energy at the integration point @p point, with
    /// @p law and @p weight, to @p work and @p energy of each axis point.
    void
    add_point(const SectionPoint  &point,
              const double         weight,
              const ElasticLaw    &law,
              const Coefficients  &q,
              Coefficients        &work,
              std::vector<double> &energy) const;
  };
} // namespace lamella

#endif
