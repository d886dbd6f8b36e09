// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `material`: elastic constants and their limits, density, expansion
// and strengths, the rotation of plies, codes of layups, the library of
// built-in materials, and the constitutive law. It is independent of meshes.

#ifndef lamella_material_material_h
#define lamella_material_material_h

#include <lamella/material/elasticity.h>

#include <map>
#include <optional>
#include <string>

namespace lamella
{
  /// Strengths of an orthotropic material in its own axes, positive also in
  /// compression: tension (t) and compression (c) along 1, 2 and 3 as X, Y and
  /// Z, and shear. Also used for strains (engineering shear strains) at
  /// failure.
  struct Strengths
  {
    /// Tension and compression along 1, 2 and 3 [force/length^2].
    double Xt = 0., Xc = 0., Yt = 0., Yc = 0., Zt = 0., Zc = 0.;
    /// Shear in the planes 12, 13 and 23 [force/length^2].
    double S12 = 0., S13 = 0., S23 = 0.;
  };

  /// Strengths of a sandwich core in its own axes: 1 along the ribbon of a
  /// honeycomb (L), 2 across it (W), 3 through the thickness; all positive.
  struct CoreStrengths
  {
    /// Compression along 3, shear 13 and shear 23 [force/length^2].
    double crushing = 0., shear_13 = 0., shear_23 = 0.;
  };

  /// Slopes p of Puck's fracture curves at zero normal stress on the fracture
  /// plane, dimensionless: of shear along the fiber (l) and across it (t),
  /// towards tension and compression. Defaults are for carbon (Puck, Kopp and
  /// Knops, Compos. Sci. Technol. 62 (2002) 371-378; pt at its lower end).
  struct PuckInclinations
  {
    double pl_tension = 0.35, pl_compression = 0.3;
    double pt_tension = 0.25, pt_compression = 0.25;

    /// Returns the values for glass of that source.
    static PuckInclinations
    glass()
    {
      return {0.3, 0.25, 0.2, 0.2};
    }
  };

  /// A material in its own axes and the units of the scene. Optional data are
  /// empty if not given.
  struct Material
  {
    Material() = default;

    /// Converts elastic constants to a material without other data.
    Material(const EngineeringConstants &elastic)
      : elastic(elastic)
    {}

    /// Elastic constants; zero, which is invalid, until set.
    EngineeringConstants elastic;
    /// Mass per volume [force s^2 / length^4], as kg/m^3 or t/mm^3.
    std::optional<double> density;
    /// Thermal expansion alpha_1, alpha_2, alpha_3 [1/K].
    std::optional<dealii::Tensor<1, 3>> expansion;
    /// Stresses and strains at failure.
    std::optional<Strengths> strengths, ultimate_strains;
    /// Tensile yield stress of an isotropic material [force/length^2].
    std::optional<double> yield;
    /// Core strengths, which make it a sandwich core in the failure criteria.
    std::optional<CoreStrengths> core;
    PuckInclinations             inclinations;
  };

  /// Materials by name in the scene, sorted.
  using Materials = std::map<std::string, Material>;

  /// Linear elasticity with an initial strain epsilon_0 (heat, cure), the only
  /// constitutive law of the program (Eq. 6 extended),
  ///   sigma = C (epsilon - epsilon_0) = dW/depsilon
  ///   W     = 1/2 (epsilon - epsilon_0) . C (epsilon - epsilon_0)
  /// with engineering shear strains (Eq. 4) and symmetric positive definite C.
  /// Because of -C epsilon_0, stresses are affine functionals of the DoFs.
  class ElasticLaw
  {
  public:
    /// Stores C and epsilon_0 in the same axes, without checks.
    explicit ElasticLaw(const ElasticTensor &stiffness,
                        const Voigt         &initial_strain = Voigt())
      : C(stiffness)
      , initial(initial_strain)
    {}

    /// Returns C, 6 x 6 [force/length^2].
    const ElasticTensor &
    stiffness() const
    {
      return C;
    }

    /// Returns epsilon_0, the strain without stress.
    const Voigt &
    initial_strain() const
    {
      return initial;
    }

    /// Returns C (@p strain - epsilon_0) [force/length^2], for the total strain
    /// D u (Eq. 5) in the law's axes.
    Voigt
    stress(const Voigt &strain) const
    {
      return C * (strain - initial);
    }

    /// Returns the strain energy density W at @p strain [force/length^2].
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
