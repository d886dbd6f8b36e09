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
  /// The constitutive laws of the plies of a section in axes of the body. The
  /// law of a plane ply is constant. In a curved wall, the law depends on the
  /// point, since the ply axes rotate about y with the normal of the wall.
  class PlyLaws
  {
  public:
    /// Computes the laws of @p plies with elasticity matrices D C D. D is
    /// diagonal: sqrt(k) for the strains xy and yz, 1 for others, where k is @p
    /// shear_factor, the shear correction factor.
    explicit PlyLaws(const std::vector<Ply> &plies,
                     const double            shear_factor = 1.);

    /// Returns the number of plies.
    unsigned int
    n_plies() const
    {
      return plies.size();
    }

    /// Returns true if the law of @p ply depends on the point of the section.
    bool
    has_varying_law(const unsigned int ply) const
    {
      return bool(plies[ply].plane.normal_at);
    }

    /// Returns true if the law of any ply depends on the point of the section.
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

    /// Returns the law of @p ply. Requires that has_varying_law() is false.
    const ElasticLaw &
    constant(const unsigned int ply) const
    {
      return constant_laws[ply];
    }

    /// Number of Fourier terms 1, cos phi, sin phi, ..., cos 4 phi, sin 4 phi.
    static constexpr unsigned int n_harmonics = 9;
    /// Values of these Fourier terms for the angle phi of a ply normal.
    using Harmonics = std::array<double, n_harmonics>;

    /// Returns 1, cos phi, sin phi, ..., sin 4 phi at the point @p x, where phi
    /// is the angle of the normal of @p ply from +x towards +z.
    Harmonics
    harmonics(const unsigned int ply, const dealii::Point<2> &x) const;

    /// Returns the matrices C_k with which the stiffness of @p ply at a point
    /// is the sum of h_k C_k with its harmonics() h_k. This is exact, since a
    /// rotated stiffness is a polynomial of degree 4 in cos phi and sin phi.
    std::array<ElasticTensor, n_harmonics>
    stiffness_harmonics(const unsigned int ply) const;

  private:
    /// Returns the law of @p ply at a point with the normal @p normal.
    ElasticLaw
    law_with_normal(const unsigned int          ply,
                    const dealii::Tensor<1, 2> &normal) const;

    std::vector<Ply> plies;
    double           shear_factor;
    /// Stiffness of each ply in its axes; constant laws in axes of the body.
    std::vector<ElasticTensor> own;
    std::vector<ElasticLaw>    constant_laws;
  };
} // namespace lamella

#endif
