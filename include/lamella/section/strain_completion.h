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
  /**
   * Sections of low theories cannot contract by their own functions: under
   * bending with the strain eps_yy = kappa z a beam wants u_x = -nu kappa x z
   * and u_z = -nu kappa (z^2 - x^2) / 2, which is of degree two. Held, the
   * section is too stiff (Poisson locking: by 35 % at nu = 0.3). A completion
   * adds the missing strains to those of each field; with the full elasticity
   * C the stresses, energies and forces then all follow from the completed
   * strains, and nothing else in the program knows of it.
   *
   * In the words of beam theory: the warping that the section's own fields lack
   * is condensed out, by a plane-stress-like law or by modes. TE-2, LE and
   * higher theories contract by themselves and have none. Completed strains
   * belong to no displacements: a support that holds u_x does not hold them.
   */
  class StrainCompletion
  {
  public:
    virtual ~StrainCompletion() = default;

    /// Completes the strains of the fields at @p point. Changes
    /// SectionPoint::in_plane and along of all its fields, and nothing else. To
    /// be called once a point.
    virtual void
    complete(SectionPoint &point) const = 0;

    /// What an initial strain @p initial of the section cell @p cell adds to
    /// the strains of all fields, whatever they are: heat widens a section,
    /// too. None by default.
    virtual Voigt
    of_initial(const unsigned int /*cell*/,
               const dealii::Point<2> & /*x*/,
               const Voigt & /*initial*/) const
    {
      return {};
    }
  };

  /**
   * Free contraction at each point, for EBBT and TBT: sigma_xx = sigma_zz =
   * sigma_xz = 0. With a the kept strains {yy, xy, yz} and b the others,
   *   eps_b = -C_bb^-1 C_ba eps_a,
   * so that the law of a is C_aa - C_ab C_bb^-1 C_ba.
   *
   * For a ply at an angle the law is that of the rotated C, so that G_yz is the
   * series and not the mean of G_13 and G_23.
   */
  class FreeContraction : public StrainCompletion
  {
  public:
    /// @p laws of each ply, @p ply_of_cell of each cell. The laws are those of
    /// the section, with the shear factor; they are copied.
    FreeContraction(const PlyLaws                   &laws,
                    const std::vector<unsigned int> &ply_of_cell);

    /// eps becomes P eps, whatever xx, zz and xz had been.
    void
    complete(SectionPoint &point) const override;

    /// eps_0 - P eps_0: with it sigma = C (P eps + (eps_0 - P eps_0) - eps_0)
    /// has no xx, zz and xz either.
    Voigt
    of_initial(const unsigned int      cell,
               const dealii::Point<2> &x,
               const Voigt            &initial) const override;

  private:
    /// P of @p cell at @p x.
    ElasticTensor
    completion_at(const unsigned int cell, const dealii::Point<2> &x) const;

    PlyLaws laws;
    /// P of each ply whose law is one: eps = P eps with the kept strains as
    /// they are. P of others is made at each point.
    std::vector<ElasticTensor> completion;
    std::vector<unsigned int>  ply_of_cell;
  };

  /**
   * Contraction by modes of the whole section, for TE-1: the in-plane
   * displacements v = F_tau e_x, F_tau e_z with the polynomials F_tau of degree
   * 2 up to mode_degree follow the strain eps = N a + N' b of TE-1's own fields
   * such that the energy of the section is least,
   *   v = - K^-1 int (D_s v)^T C eps dA,   K = int (D_s v)^T C D_s v dA
   * (static condensation; the derivatives of v along y are neglected, as every
   * beam theory does). Each mode is taken less the linear displacement that has
   * its mean strain, int D_s v dA = 0: TE-1's own in-plane terms, whose strains
   * are constant, then keep their stiffness, which they lose with the law of
   * FreeContraction.
   *
   * For one isotropic material the modes are the exact contraction under
   * bending, and TE-1 bends like TBT; in laminates they are what TE-2 would do.
   * There are two modes a polynomial beyond the linear ones, six in all, so a
   * small dense K.
   */
  class ContractionModes : public StrainCompletion
  {
  public:
    /// Bending contracts a section by quadratic displacements.
    static constexpr unsigned int mode_degree = 2;

    /**
     * From @p points with @p weights, the integration points of the section
     * with the strains of @p n_fields fields, not yet completed.
     * The arguments are not needed any more afterwards but for the mesh, which
     * is shared.
     */
    ContractionModes(std::shared_ptr<const SectionMesh> mesh,
                     const std::vector<SectionPoint>   &points,
                     const std::vector<double>         &weights,
                     const PlyLaws                     &laws,
                     const std::vector<unsigned int>   &ply_of_cell,
                     const unsigned int                 n_fields);

    void
    complete(SectionPoint &point) const override;

  private:
    /// The means over the section, from its integration points.
    void
    find_means(const std::vector<SectionPoint> &points,
               const std::vector<double>       &weights);
    /// Adds what @p point stands for, with its law @p C, to @p K and to the
    /// right hand sides, of_in_plane and of_along.
    void
    add_energies(const SectionPoint               &point,
                 const double                      weight,
                 const ElasticTensor              &C,
                 dealii::LAPACKFullMatrix<double> &K);
    /// D_s v of all modes at a point, less their means. Two for each
    /// polynomial, of its displacement along x and along z. [1 / length]
    std::vector<Voigt>
    mode_strains(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// TE-2 on the same mesh, for its functions from the fourth on.
    TaylorElement modes;
    /// Of each mode its mean strain over the section.
    std::vector<Voigt> means;
    /// Amplitudes of the modes: for each mode and field, to the strains that N
    /// and N' multiply.
    dealii::LAPACKFullMatrix<double> of_in_plane, of_along;
  };
} // namespace lamella

#endif
