// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_strain_completion_h
#define lamella_section_strain_completion_h

#include <lamella/section/ply_laws.h>
#include <lamella/section/section_point.h>
#include <lamella/section/taylor_element.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace lamella
{
  /// Corrects Poisson locking in theories of low order (EBBT, TBT, TE-1), whose
  /// functions cannot describe the lateral contraction of a bent section:
  /// eps_yy = kappa z requires u_x = -nu kappa x z and u_z = -nu kappa (z^2 -
  /// x^2) / 2. Without correction, the section is too stiff, by 35 % at nu =
  /// 0.3. The missing strains are added to those of each section function;
  /// stresses, energies and forces follow from the completed strains.
  ///
  /// The missing warping is condensed out by zero transverse stresses
  /// (FreeContraction) or by modes (ContractionModes). The added strains have
  /// no displacements, so a support that fixes u_x does not constrain them.
  class StrainCompletion
  {
  public:
    virtual ~StrainCompletion() = default;

    /// Adds the missing strains due to lateral contraction to the strains of
    /// all section functions at @p point. Must be called only once per point.
    virtual void
    complete(SectionPoint &point) const = 0;

    /// Returns the strain due to free lateral contraction that an @p initial
    /// strain (e.g. thermal) at a point causes in addition to the strain of the
    /// displacements. This default implementation returns zero.
    virtual Voigt
    of_initial(const unsigned int /*cell*/,
               const dealii::Point<2> & /*x*/,
               const Voigt & /*initial*/) const
    {
      return {};
    }
  };

  /// Strain completion for EBBT and TBT by zero transverse stresses sigma_xx =
  /// sigma_zz = sigma_xz = 0 at each point. The strains a = {yy, xy, yz}
  /// determine the others, b = {xx, zz, xz},
  ///   eps_b = -C_bb^-1 C_ba eps_a,
  /// with the elasticity matrix C of the ply in the body frame. The reduced
  /// stiffness is C_aa - C_ab C_bb^-1 C_ba.
  class FreeContraction : public StrainCompletion
  {
  public:
    /// Constructs the completion from laws of plies and the ply of each cell.
    FreeContraction(const PlyLaws                   &laws,
                    const std::vector<unsigned int> &ply_of_cell);

    /// Completes the strains eps of all section functions at @p point: keeps
    /// {yy, xy, yz} and computes {xx, zz, xz} from zero transverse stresses.
    void
    complete(SectionPoint &point) const override;

    /// Returns eps_0 - P eps_0 for the @p initial strain eps_0. P keeps {yy,
    /// xy, yz} and computes {xx, zz, xz} from zero stresses xx, zz and xz.
    Voigt
    of_initial(const unsigned int      cell,
               const dealii::Point<2> &x,
               const Voigt            &initial) const override;

  private:
    /// Returns the matrix P at a point, where P eps keeps {yy, xy, yz} and
    /// computes {xx, zz, xz} from zero transverse stresses.
    ElasticTensor
    completion_at(const unsigned int cell, const dealii::Point<2> &x) const;

    PlyLaws laws;
    /// Matrix P of each ply with a constant law.
    std::vector<ElasticTensor> completion;
    std::vector<unsigned int>  ply_of_cell;
  };

  /// Strain completion for TE-1 by modes of the whole section. The modes are
  /// the in-plane displacements F_tau e_x and F_tau e_z with the polynomials
  /// F_tau of degree 2. For each strain eps of TE-1, their amplitudes minimize
  /// the energy, so that the displacement is
  ///   v = - K^-1 int (D_s v)^T C eps dA,   K = int (D_s v)^T C D_s v dA
  /// (static condensation; derivatives of v along y are neglected). The mean
  /// strain of each mode is subtracted, so that int D_s v dA = 0 and TE-1's
  /// constant in-plane strains are not affected.
  ///
  /// For one isotropic material, the modes contain the exact contraction under
  /// bending, and TE-1 has the bending stiffness of TBT. There are six modes,
  /// two for each quadratic polynomial.
  class ContractionModes : public StrainCompletion
  {
  public:
    /// Polynomial degree of the modes.
    static constexpr unsigned int mode_degree = 2;

    /// Computes the amplitudes of the modes from the integration @p points and
    /// @p weights of the section. Their strains must not be completed.
    ContractionModes(const std::shared_ptr<const SectionMesh> &mesh,
                     const std::vector<SectionPoint>          &points,
                     const std::vector<double>                &weights,
                     const PlyLaws                            &laws,
                     const std::vector<unsigned int>          &ply_of_cell,
                     const unsigned int                        n_fields);

    void
    complete(SectionPoint &point) const override;

  private:
    /// Computes the mean strain of each mode over the section.
    void
    find_means(const std::vector<SectionPoint> &points,
               const std::vector<double>       &weights);
    /// Adds the contribution of a point to the stiffness @p K of the modes and
    /// to their loads, which of_in_plane and of_along contain at first.
    void
    add_energies(const SectionPoint               &point,
                 const double                      weight,
                 const ElasticTensor              &C,
                 dealii::LAPACKFullMatrix<double> &K);
    /// Returns the in-plane strains of all modes at a point, minus their means
    /// over the section [1 / length].
    std::vector<Voigt>
    mode_strains(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Expansion TE-2 on the same mesh; its quadratic functions are the modes.
    TaylorElement      modes;
    std::vector<Voigt> means; ///< Mean strain of each mode over the section.
    /// Amplitudes of the modes due to the in-plane strains D_s Phi and the
    /// strains with axial derivatives D_y Phi of each section function Phi.
    dealii::LAPACKFullMatrix<double> of_in_plane, of_along;
  };
} // namespace lamella

#endif
