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
  /// The laws of a section's plies in the body frame, for beams and solids. A
  /// ply in a plane has one law. The law in a curved wall varies: its axes are
  /// rotated about y with the normal.
  class PlyLaws
  {
  public:
    /// Constructs the laws of @p plies. @p shear_factor k scales transverse
    /// shear in the body frame: D C D replaces C, with sqrt(k) in D for xy and
    /// yz.
    explicit PlyLaws(const std::vector<Ply> &plies,
                     const double            shear_factor = 1.);

    unsigned int
    n_plies() const
    {
      return plies.size();
    }

    /// Returns true if the law of @p ply depends on the point.
    bool
    has_varying_law(const unsigned int ply) const
    {
      return bool(plies[ply].plane.normal_at);
    }

    /// Returns true if the law of any ply depends on the point.
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

    /// Returns the law of @p ply, which does not vary.
    const ElasticLaw &
    constant(const unsigned int ply) const
    {
      return constant_laws[ply];
    }

    /// Harmonics of a normal: 1, cos phi, sin phi, ..., cos 4 phi, sin 4 phi.
    static constexpr unsigned int n_harmonics = 9;
    using Harmonics                           = std::array<double, n_harmonics>;

    /// Returns the harmonics of the normal of @p ply at @p x, phi from +x to
    /// +z.
    Harmonics
    harmonics(const unsigned int ply, const dealii::Point<2> &x) const;

    /// Returns C_0 ... C_8 of @p ply: its stiffness at any point is the sum of
    /// C_k times harmonics()[k]. Nine terms are exact, since rotation about y
    /// gives a polynomial of degree four in cos phi and sin phi; they are
    /// discrete Fourier coefficients at nine angles.
    std::array<ElasticTensor, n_harmonics>
    stiffness_harmonics(const unsigned int ply) const;

  private:
    /// Returns the law of @p ply where its normal is @p normal.
    ElasticLaw
    law_with_normal(const unsigned int          ply,
                    const dealii::Tensor<1, 2> &normal) const;

    std::vector<Ply> plies;
    double           shear_factor;
    /// C of each ply in its own axes, and its law in the body frame if
    /// constant.
    std::vector<ElasticTensor> own;
    std::vector<ElasticLaw>    constant_laws;
  };
} // namespace lamella

#endif
