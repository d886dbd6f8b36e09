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
  /// The constitutive laws of the plies of a section in the body frame, for
  /// beams and solids. The law of a plane ply is constant. The law of a ply in
  /// a curved wall varies, since the ply axes rotate about y with the normal.
  class PlyLaws
  {
  public:
    /// Computes the laws of @p plies. The @p shear_factor k scales transverse
    /// shear stiffness: D C D replaces the elasticity matrix C in the body
    /// frame, where the diagonal matrix D is sqrt(k) for xy and yz, else 1.
    explicit PlyLaws(const std::vector<Ply> &plies,
                     const double            shear_factor = 1.);

    unsigned int
    n_plies() const
    {
      return plies.size();
    }

    /// Returns whether the law of @p ply depends on the point of the section.
    bool
    has_varying_law(const unsigned int ply) const
    {
      return bool(plies[ply].plane.normal_at);
    }

    /// Returns whether the law of any ply depends on the point of the section.
    bool
    has_varying_laws() const;

    /// Returns the law of @p ply at the point @p x of the section.
    ElasticLaw
    at(const unsigned int ply, const dealii::Point<2> &x) const
    {
      return has_varying_law(ply) ?
               law_with_normal(ply, plies[ply].plane.normal_at(x)) :
               constant_laws[ply];
    }

    /// Returns the law of @p ply, which must be constant.
    const ElasticLaw &
    constant(const unsigned int ply) const
    {
      return constant_laws[ply];
    }

    /// Values 1, cos phi, sin phi, ..., cos 4 phi, sin 4 phi. phi is the angle
    /// of the ply normal from +x towards +z.
    static constexpr unsigned int n_harmonics = 9;
    using Harmonics                           = std::array<double, n_harmonics>;

    /// Returns the harmonics of the normal of @p ply at the point @p x.
    Harmonics
    harmonics(const unsigned int ply, const dealii::Point<2> &x) const;

    /// Returns the Fourier coefficients C_k of the stiffness of @p ply: at any
    /// point, the stiffness is the sum of C_k harmonics()[k], k = 0 ... 8. Nine
    /// terms are exact, since a rotated stiffness is a polynomial of degree
    /// four in cos phi and sin phi.
    std::array<ElasticTensor, n_harmonics>
    stiffness_harmonics(const unsigned int ply) const;

  private:
    /// Returns the law of @p ply at a point with the normal @p normal.
    ElasticLaw
    law_with_normal(const unsigned int          ply,
                    const dealii::Tensor<1, 2> &normal) const;

    std::vector<Ply> plies;
    double           shear_factor;
    /// Stiffness of each ply in its own axes; constant laws in the body frame.
    std::vector<ElasticTensor> own;
    std::vector<ElasticLaw>    constant_laws;
  };
} // namespace lamella

#endif
