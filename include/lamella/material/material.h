// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `material`: what a body is made of. It owns the elastic constants
// and their limits, density, expansion and strengths, the rotation of plies,
// the code of layups, the library of built-in materials, and the law that makes
// a stress of a strain, the only one there is. It never knows where the
// material is: it has no meshes.

#ifndef lamella_material_material_h
#define lamella_material_material_h

#include <lamella/material/elasticity.h>

#include <map>
#include <optional>
#include <string>

namespace lamella
{
  /// The strengths of an orthotropic material in its own axes, all positive,
  /// stresses in the units of the scene: tension (t) and compression (c) along
  /// 1, 2 and 3 as X, Y and Z, and shear.
  struct Strengths
  {
    double Xt = 0., Xc = 0., Yt = 0., Yc = 0., Zt = 0., Zc = 0.;
    double S12 = 0., S13 = 0., S23 = 0.;
  };

  /**
   * A material, in its own axes and the units of the scene: the elastic
   * constants, which every one has, and what only some scenes ask for.
   */
  struct Material
  {
    Material() = default;

    /// One of which nothing but its elasticity is known.
    Material(const EngineeringConstants &elastic)
      : elastic(elastic)
    {}

    EngineeringConstants elastic;
    /// Mass per volume.
    std::optional<double> density;
    /// alpha_1, alpha_2, alpha_3: strain per kelvin.
    std::optional<dealii::Tensor<1, 3>> expansion;
    std::optional<Strengths>            strengths;
  };

  /// Name in the scene -> material.
  using Materials = std::map<std::string, Material>;

  /**
   * sigma = C (epsilon - epsilon_0) (Eq. 6 with an initial strain, which
   * nothing causes but the material itself: heat, cure). Everything that turns
   * strains into stresses asks one of these, so that no stress, force or energy
   * forgets what another remembers.
   */
  class ElasticLaw
  {
  public:
    /// C and epsilon_0 in the same axes.
    explicit ElasticLaw(const ElasticTensor &stiffness,
                        const Voigt         &initial_strain = Voigt())
      : C(stiffness)
      , initial(initial_strain)
    {}

    const ElasticTensor &
    stiffness() const
    {
      return C;
    }

    const Voigt &
    initial_strain() const
    {
      return initial;
    }

    /// C (@p strain - epsilon_0).
    Voigt
    stress(const Voigt &strain) const
    {
      return C * (strain - initial);
    }

    /// (@p strain - epsilon_0) . C (@p strain - epsilon_0) / 2.
    double
    energy_density(const Voigt &strain) const
    {
      return 0.5 * ((strain - initial) * stress(strain));
    }

  private:
    ElasticTensor C;
    Voigt         initial;
  };
} // namespace lamella

#endif
