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
  /// 1, 2 and 3 as X, Y and Z, and shear. What a failure criterion compares
  /// stresses in ply axes with. Xc is the size of the compressive strength and
  /// so positive, too. `Strengths` of a `subsection Material` sets them; the
  /// same nine, as strains, are its `Ultimate strains`, shear strains
  /// engineering ones.
  struct Strengths
  {
    /// Tension and compression along 1, 2 and 3 [force/length^2].
    double Xt = 0., Xc = 0., Yt = 0., Yc = 0., Zt = 0., Zc = 0.;
    /// Shear in the planes 12, 13 and 23 [force/length^2].
    double S12 = 0., S13 = 0., S23 = 0.;
  };

  /// What the core of a sandwich bears, in its own axes, 1 along the ribbon of
  /// a honeycomb (L), 2 across it (W), 3 through the thickness; all positive.
  struct CoreStrengths
  {
    /// Compression along 3, shear 13 and shear 23 [force/length^2].
    double crushing = 0., shear_13 = 0., shear_23 = 0.;
  };

  /// The slopes p of Puck's fracture curves where the normal stress on the
  /// fracture plane is zero, pure numbers: of shear along the fibre (l) and
  /// across it (t), towards tension and towards compression. By default those
  /// for carbon that Puck, Kopp and Knops (Compos. Sci. Technol. 62 (2002)
  /// 371-378) recommend, of the range for pt the lower end.
  struct PuckInclinations
  {
    double pl_tension = 0.35, pl_compression = 0.3;
    double pt_tension = 0.25, pt_compression = 0.25;

    /// Those for glass of the same source.
    static PuckInclinations
    glass()
    {
      return {0.3, 0.25, 0.2, 0.2};
    }
  };

  /**
   * A material, in its own axes and the units of the scene: the elastic
   * constants, which every one has, and what only some scenes ask for. What is
   * optional is empty where nobody has said it, and never a default that
   * somebody might mistake for a measurement. Materials are plain values,
   * copied into each ply that is made of them.
   */
  struct Material
  {
    Material() = default;

    /// One of which nothing but its elasticity is known. Implicit on purpose:
    /// such constants are a material.
    Material(const EngineeringConstants &elastic)
      : elastic(elastic)
    {}

    /// Zero, and so no material, until set.
    EngineeringConstants elastic;
    /// Mass per volume, in the mass that force and length make:
    /// [force s^2 / length^4], kg/m^3 of m and N, t/mm^3 of mm and N.
    std::optional<double> density;
    /// alpha_1, alpha_2, alpha_3: strain per kelvin. In the material's own
    /// axes.
    std::optional<dealii::Tensor<1, 3>> expansion;
    /// Stresses, and strains, at which it fails.
    std::optional<Strengths> strengths, ultimate_strains;
    /// Of an isotropic material the stress at which it yields in tension
    /// [force/length^2].
    std::optional<double> yield;
    /// What makes it the core of a sandwich to the failure criteria.
    std::optional<CoreStrengths> core;
    PuckInclinations             inclinations;
  };

  /// Name in the scene -> material. Sorted by name.
  using Materials = std::map<std::string, Material>;

  /**
   * sigma = C (epsilon - epsilon_0) (Eq. 6 with an initial strain, which
   * nothing causes but the material itself: heat, cure). Everything that turns
   * strains into stresses asks one of these, so that no stress, force or energy
   * forgets what another remembers.
   *
   *   sigma = C (epsilon - epsilon_0)
   *   W     = 1/2 (epsilon - epsilon_0) . C (epsilon - epsilon_0)
   *
   * so that sigma = dW/depsilon. Strains are Voigt vectors with engineering
   * shear strains (Eq. 4), and C is symmetric positive definite. The part -C
   * epsilon_0 is what makes stress rows affine (Row::constant()) and what loads
   * a body without any force from outside. 42 numbers, copied freely.
   */
  class ElasticLaw
  {
  public:
    /// C and epsilon_0 in the same axes. Of a section these are the body's axes
    /// (Ply::stiffness()). Nothing is checked.
    explicit ElasticLaw(const ElasticTensor &stiffness,
                        const Voigt         &initial_strain = Voigt())
      : C(stiffness)
      , initial(initial_strain)
    {}

    /// C, 6 x 6 [force/length^2].
    const ElasticTensor &
    stiffness() const
    {
      return C;
    }

    /// epsilon_0; zero if nothing strains the material but stress.
    const Voigt &
    initial_strain() const
    {
      return initial;
    }

    /// C (@p strain - epsilon_0). @p strain is the whole strain D u (Eq. 5), in
    /// the law's axes; the result is in the same axes and in the order of Eq. 4
    /// [force/length^2].
    Voigt
    stress(const Voigt &strain) const
    {
      return C * (strain - initial);
    }

    /// (@p strain - epsilon_0) . C (@p strain - epsilon_0) / 2. Energy per
    /// volume [force/length^2]: zero where the strain is the initial one.
    double
    energy_density(const Voigt &strain) const
    {
      return 0.5 * ((strain - initial) * stress(strain));
    }

  private:
    /// In the same axes as the initial strain.
    ElasticTensor C;
    Voigt         initial;
  };
} // namespace lamella

#endif
