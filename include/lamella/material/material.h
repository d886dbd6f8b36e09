// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `material`: elastic constants, density, thermal expansion and
// strengths, their rotation into ply axes, laminate codes, the library of
// built-in materials, and the constitutive law. It is independent of meshes.

#ifndef lamella_material_material_h
#define lamella_material_material_h

#include <lamella/material/elasticity.h>

#include <map>
#include <optional>
#include <string>

namespace lamella
{
  /// Strengths of an orthotropic material in its own axes. X, Y, Z are the
  /// directions 1, 2, 3, with t for tension and c for compression; all values
  /// are positive. Also used for ultimate strains (engineering shear strains).
  struct Strengths
  {
    /// Strengths in tension and compression [force/length^2].
    double Xt = 0., Xc = 0., Yt = 0., Yc = 0., Zt = 0., Zc = 0.;
    /// Shear strengths in the planes 12, 13 and 23 [force/length^2].
    double S12 = 0., S13 = 0., S23 = 0.;
  };

  /// Strengths of a sandwich core in its own axes: 1 along the ribbon of a
  /// honeycomb (L), 2 across it (W), 3 through the thickness; all positive.
  struct CoreStrengths
  {
    /// Compressive strength along 3, shear strengths in the planes 13 and 23.
    double crushing = 0., shear_13 = 0., shear_23 = 0.;
  };

  /// Inclination parameters p of Puck's inter-fiber fracture criterion,
  /// dimensionless: slopes of the fracture curve at zero normal stress on the
  /// fracture plane, for shear along (pl) and across the fiber (pt), on the
  /// tension and compression side. Defaults are for carbon fibers (Puck, Kopp
  /// and Knops, Compos. Sci. Technol. 62 (2002) 371-378).
  struct PuckInclinations
  {
    double pl_tension = 0.35, pl_compression = 0.3;
    double pt_tension = 0.25, pt_compression = 0.25;

    /// Returns the values for glass fibers from the same source.
    static PuckInclinations
    glass()
    {
      return {0.3, 0.25, 0.2, 0.2};
    }
  };

  /// Material data in the material's own axes and the units of the scene.
  /// Optional data that are unknown are empty.
  struct Material
  {
    Material() = default;

    /// Constructs a material with the constants @p elastic only.
    Material(const EngineeringConstants &elastic)
      : elastic(elastic)
    {}

    /// Elastic constants; the default values of zero are invalid.
    EngineeringConstants elastic;
    /// Mass density [force s^2 / length^4], i.e. kg/m^3 or t/mm^3.
    std::optional<double> density;
    /// Coefficients of thermal expansion alpha_1, alpha_2, alpha_3 [1/K].
    std::optional<dealii::Tensor<1, 3>> expansion;
    /// Strengths as stresses, and as ultimate strains.
    std::optional<Strengths> strengths, ultimate_strains;
    /// Tensile yield stress of an isotropic material [force/length^2].
    std::optional<double> yield;
    /// Strengths of a sandwich core. If set, the failure criteria treat the
    /// material as a core.
    std::optional<CoreStrengths> core;
    PuckInclinations             inclinations;
  };

  /// Materials of the scene by name.
  using Materials = std::map<std::string, Material>;

  /// Linear elasticity with an initial strain epsilon_0 due to temperature or
  /// cure, the only constitutive law of the program,
  ///   sigma = C (epsilon - epsilon_0) = dW/depsilon
  ///   W     = 1/2 (epsilon - epsilon_0) . C (epsilon - epsilon_0)
  /// with the stress sigma, the total strain epsilon (engineering shear
  /// strains), the energy density W and the stiffness C.
  class ElasticLaw
  {
  public:
    /// Stores C and epsilon_0 in the same axes, without checks.
    explicit ElasticLaw(const ElasticTensor &stiffness,
                        const Voigt         &initial_strain = Voigt())
      : C(stiffness)
      , initial(initial_strain)
    {}

    /// Returns the stiffness C [force/length^2].
    const ElasticTensor &
    stiffness() const
    {
      return C;
    }

    /// Returns the initial strain epsilon_0, for which the stress is zero.
    const Voigt &
    initial_strain() const
    {
      return initial;
    }

    /// Returns the stress C (@p strain - epsilon_0) [force/length^2] for the
    /// total strain in the axes of this law.
    Voigt
    stress(const Voigt &strain) const
    {
      return C * (strain - initial);
    }

    /// Returns the energy density W for the total @p strain [force/length^2].
    double
    energy_density(const Voigt &strain) const
    {
      return 0.5 * ((strain - initial) * stress(strain));
    }

  private:
    /// Stiffness and initial strain in the same axes.
    ElasticTensor C;
    Voigt         initial;
  };
} // namespace lamella

#endif
