// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_ply_laws_h
#define lamella_section_ply_laws_h

#include <lamella/material/material.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace lamella
{
  /**
   * The laws of a section's plies in the body frame. That of a ply in a flat
   * plane is one; that of a ply that follows a curved wall is another one at
   * each point, the law in the plane's axes turned about y with its normal.
   * Beams and solids ask this class, so that both turn it alike.
   */
  class PlyLaws
  {
  public:
    /// @p plies are copied. @p shear_factor k multiplies what transverse shear
    /// strains of the body frame do: D C D in place of C with sqrt(k) in D's
    /// places for xy and yz.
    explicit PlyLaws(const std::vector<Ply> &plies,
                     const double            shear_factor = 1.);

    unsigned int
    n_plies() const
    {
      return plies.size();
    }

    /// Whether the law of @p ply depends on the point.
    bool
    varies(const unsigned int ply) const
    {
      return bool(plies[ply].plane.normal_at);
    }

    /// Whether any does.
    bool
    vary() const;

    /// The law of @p ply at the point @p x of the section. Where it varies it
    /// is turned at each call, some microseconds.
    ElasticLaw
    at(const unsigned int ply, const dealii::Point<2> &x) const
    {
      return varies(ply) ? turned(ply, plies[ply].plane.normal_at(x)) :
                           everywhere[ply];
    }

    /// The law of @p ply, which does not vary.
    const ElasticLaw &
    constant(const unsigned int ply) const
    {
      return everywhere[ply];
    }

    /// A normal's harmonics: 1, cos phi, sin phi, ..., cos 4 phi, sin 4 phi.
    static constexpr unsigned int n_harmonics = 9;
    using Harmonics                           = std::array<double, n_harmonics>;

    /// The harmonics of the normal of @p ply at @p x, phi its angle from +x
    /// towards +z.
    Harmonics
    harmonics(const unsigned int ply, const dealii::Point<2> &x) const;

    /**
     * C_0 ... C_8 of @p ply, with which its stiffness at any point is the sum
     * of C_k times harmonics()[k]. A turn about y by phi makes of C a
     * polynomial of degree four in cos phi and sin phi, so nine terms hold it
     * all; they are the discrete Fourier coefficients at nine angles. Integrals
     * of C times functions of the section are then sums of integrals of the
     * functions.
     */
    std::array<ElasticTensor, n_harmonics>
    stiffness_harmonics(const unsigned int ply) const;

  private:
    /// The law of @p ply where its normal is @p normal.
    ElasticLaw
    turned(const unsigned int ply, const dealii::Tensor<1, 2> &normal) const;

    std::vector<Ply> plies;
    double           shear_factor;
    /// C of each ply in its own axes, and the law in the body frame for the
    /// normal that its plane says, wherever that counts.
    std::vector<ElasticTensor> own;
    std::vector<ElasticLaw>    everywhere;
  };
} // namespace lamella

#endif
