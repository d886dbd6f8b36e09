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
   * Completion of strains for low theories, whose fields cannot describe the
   * contraction of sections: bending with eps_yy = kappa z requires u_x = -nu
   * kappa x z and u_z = -nu kappa (z^2 - x^2) / 2. Otherwise the section is too
   * stiff (Poisson locking: by 35 % at nu = 0.3). The missing strains are added
   * to those of each field; C gives stresses, energies and forces from
   * completed strains.
   *
   * The missing warping is condensed out, by a plane-stress-like law or by
   * modes. TE-2, LE and higher theories have no completion. Completed strains
   * belong to no displacements: a support that fixes u_x does not constrain
   * them.
   */
  class StrainCompletion
  {
  public:
    virtual ~StrainCompletion() = default;

    /// Completes the strains of all fields at @p point. Call it once per point.
    virtual void
    complete(SectionPoint &point) const = 0;

    /// Returns the strain that an initial strain of a section cell adds to the
    /// strains of all fields. None by default.
    virtual Voigt
    of_initial(const unsigned int /*cell*/,
               const dealii::Point<2> & /*x*/,
               const Voigt & /*initial*/) const
    {
      return {};
    }
  };

  /// Free contraction at each point, sigma_xx = sigma_zz = sigma_xz = 0, for
  /// EBBT and TBT. The kept strains a = {yy, xy, yz} determine the others b,
  ///   eps_b = -C_bb^-1 C_ba eps_a,
  /// so that the law of a is C_aa - C_ab C_bb^-1 C_ba. C of a ply at an angle
  /// is rotated, so that G_yz is the series and not the mean of G_13 and G_23.
  class FreeContraction : public StrainCompletion
  {
  public:
    /// Constructs the completion from the section's laws of each ply, with the
    /// shear factor, and the ply of each cell.
    FreeContraction(const PlyLaws                   &laws,
                    const std::vector<unsigned int> &ply_of_cell);

    /// Replaces eps by P eps, which does not depend on xx, zz and xz.
    void
    complete(SectionPoint &point) const override;

    /// Returns eps_0 - P eps_0, which makes xx, zz and xz of the stress vanish.
    Voigt
    of_initial(const unsigned int      cell,
               const dealii::Point<2> &x,
               const Voigt            &initial) const override;

  private:
    /// Returns P of @p cell at @p x.
    ElasticTensor
    completion_at(const unsigned int cell, const dealii::Point<2> &x) const;

    PlyLaws laws;
    /// Completion P of each ply with a constant law, eps = P eps. P of other
    /// plies is computed at each point.
    std::vector<ElasticTensor> completion;
    std::vector<unsigned int>  ply_of_cell;
  };

  /**
   * Contraction by modes of the whole section, for TE-1. The in-plane
   * displacements v = F_tau e_x, F_tau e_z with the polynomials F_tau of degree
   * 2 up to mode_degree follow the strain eps = N a + N' b of TE-1's own fields
   * with minimal energy,
   *   v = - K^-1 int (D_s v)^T C eps dA,   K = int (D_s v)^T C D_s v dA
   * (static condensation, without derivatives of v along y). The linear
   * displacement with its mean strain is subtracted from each mode, so that int
   * D_s v dA = 0: TE-1's own in-plane terms of constant strain keep their
   * stiffness.
   *
   * The modes of one isotropic material are the exact contraction under
   * bending, and TE-1 bends like TBT; those of laminates are those of TE-2.
   * There are two modes per polynomial beyond the linear ones, six in all.
   */
  class ContractionModes : public StrainCompletion
  {
  public:
    /// Degree of the modes: bending contracts sections quadratically.
    static constexpr unsigned int mode_degree = 2;

    /// Computes the modes from the integration points of the section and the
    /// uncompleted strains of fields. Shares the mesh.
    ContractionModes(std::shared_ptr<const SectionMesh> mesh,
                     const std::vector<SectionPoint>   &points,
                     const std::vector<double>         &weights,
                     const PlyLaws                     &laws,
                     const std::vector<unsigned int>   &ply_of_cell,
                     const unsigned int                 n_fields);

    void
    complete(SectionPoint &point) const override;

  private:
    /// Computes mean strains over the section from its integration points.
    void
    find_means(const std::vector<SectionPoint> &points,
               const std::vector<double>       &weights);
    /// Adds integrals at a point to K, of_in_plane and of_along.
    void
    add_energies(const SectionPoint               &point,
                 const double                      weight,
                 const ElasticTensor              &C,
                 dealii::LAPACKFullMatrix<double> &K);
    /// Returns D_s v of all modes at a point, less their means [1 / length].
    std::vector<Voigt>
    mode_strains(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// TE-2 on the same mesh, of which functions from the fourth on are used.
    TaylorElement modes;
    /// Mean strain of each mode over the section.
    std::vector<Voigt> means;
    /// Amplitudes of each mode for each field, for strains of N and N'.
    dealii::LAPACKFullMatrix<double> of_in_plane, of_along;
  };
} // namespace lamella

#endif
