// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `material`: elastic constants, density, thermal expansion and
// strengths, their rotation into ply axes, laminate codes, the library of
// built-in materials, and the constitutive law. It is independent of meshes.

#ifndef lamella_material_material_h
#define lamella_material_material_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/elasticity.h>

#include <map>
#include <optional>
#include <string>

#include <vector>

namespace lamella
{
  /// Strengths of an orthotropic material in its axes 1, 2, 3, as positive
  /// stresses [force/length^2]. The struct also stores ultimate strains; shear
  /// values are then engineering shear strains.
  struct Strengths
  {
    double Xt  = 0.; ///< Tensile strength along axis 1.
    double Xc  = 0.; ///< Compressive strength along axis 1.
    double Yt  = 0.; ///< Tensile strength along axis 2.
    double Yc  = 0.; ///< Compressive strength along axis 2.
    double Zt  = 0.; ///< Tensile strength along axis 3.
    double Zc  = 0.; ///< Compressive strength along axis 3.
    double S12 = 0.; ///< Shear strength in the plane 12.
    double S13 = 0.; ///< Shear strength in the plane 13.
    double S23 = 0.; ///< Shear strength in the plane 23.
  };

  /// Strengths of a sandwich core in its material axes: 1 along the ribbon of a
  /// honeycomb (L), 2 across it (W), 3 through the thickness; all positive.
  struct CoreStrengths
  {
    double crushing = 0.; ///< Compressive strength along 3 [force/length^2].
    double shear_13 = 0.; ///< Shear strength in the plane 13 [force/length^2].
    double shear_23 = 0.; ///< Shear strength in the plane 23 [force/length^2].
  };

  /// Inclination parameters p of Puck's inter-fiber fracture criterion,
  /// dimensionless: slopes of the fracture curve (shear stress over normal
  /// stress on the fracture plane) at zero normal stress. Defaults are for
  /// carbon fibers (Puck et al., Compos. Sci. Technol. 62 (2002) 371-378).
  struct PuckInclinations
  {
    double pl_tension     = 0.35; ///< Shear along the fiber, tension side.
    double pl_compression = 0.3;  ///< Shear along the fiber, compression side.
    double pt_tension     = 0.25; ///< Shear across the fiber, tension side.
    double pt_compression = 0.25; ///< Shear across the fiber, compression side.

    /// Returns the parameters for glass fibers (Puck, Kopp and Knops 2002).
    static PuckInclinations
    glass()
    {
      return {0.3, 0.25, 0.2, 0.2};
    }
  };

  /// Elastic constants, strengths, density and thermal expansion of a material,
  /// in its material axes and the units of the scene file.
  struct Material
  {
    Material() = default;

    /// Constructs a material that has only the elastic constants @p elastic.
    Material(const EngineeringConstants &elastic)
      : elastic(elastic)
    {}

    /// Elastic constants; the default values of zero are invalid.
    EngineeringConstants elastic;
    /// Mass density [force s^2 / length^4]; empty if unknown.
    std::optional<double> density;
    /// Thermal expansion along the axes 1, 2, 3 [1/K]; empty if unknown.
    std::optional<dealii::Tensor<1, 3>> expansion;
    /// Strengths [force/length^2]; empty if unknown.
    std::optional<Strengths> strengths;
    /// Ultimate strains (strains at failure); empty if unknown.
    std::optional<Strengths> ultimate_strains;
    /// Tensile yield stress (isotropic) [force/length^2]; empty if unknown.
    std::optional<double> yield;
    /// Strengths of a sandwich core; empty if the material is not a core.
    std::optional<CoreStrengths> core;
    /// Inclination parameters of Puck's inter-fiber fracture criterion.
    PuckInclinations inclinations;
  };

  /// Materials of a scene file by name (`subsection Material NAME`).
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
    /// Stores the stiffness [force/length^2] and the initial strain, both in
    /// the same axes, without checks.
    explicit ElasticLaw(const ElasticTensor &stiffness,
                        const Voigt         &initial_strain = Voigt())
      : C(stiffness)
      , initial(initial_strain)
    {}

    /// Returns the elastic stiffness tensor [force/length^2].
    const ElasticTensor &
    stiffness() const
    {
      return C;
    }

    /// Returns the initial strain due to temperature or cure (at zero stress).
    const Voigt &
    initial_strain() const
    {
      return initial;
    }

    /// Returns the stress [force/length^2] for the total strain @p strain.
    Voigt
    stress(const Voigt &strain) const
    {
      return C * (strain - initial);
    }

    /// Returns the elastic energy per volume for the total strain @p strain.
    double
    energy_density(const Voigt &strain) const
    {
      return 0.5 * ((strain - initial) * stress(strain));
    }

  private:
    /// Elastic stiffness and initial strain, both in the same axes.
    ElasticTensor C;
    Voigt         initial;
  };

  /// Returns the names of the built-in materials in the order of the library.
  std::vector<std::string>
  library_materials();

  /// Returns the built-in material @p name, converted to the stress unit of @p
  /// units. Data that its source (doc/reference/materials.md) lacks are empty.
  /// hertz-200, whose modulus has no unit, is not converted. Throws InputError,
  /// which suggests the most similar name, if there is no such material.
  Material
  library_material(const std::string &name, const Units &units);
  /// Returns the built-in material whose name is the text of @p entry, in the
  /// stress unit of @p units. Throws InputError if there is none.
  Material
  library_material(const Entry &entry, const Units &units);

  /// Parses a laminate code such as `0/90/0`, `[0/90]s` or `[0/+-45/90]2s` and
  /// returns the ply angles in degrees (see ply_axes()), bottom to top. Angles
  /// are separated by slashes; `+-45` or `-+45` is a pair of plies. Brackets
  /// may be followed by a repetition factor and by `s` for a symmetric
  /// laminate. Repetition precedes reflection: [0/90]2s is 0/90/0/90/90/0/90/0.
  ///
  /// A code has at most 1000 characters and a repetition factor from 1 to 1000.
  /// Throws InputError if the text of @p entry is not a laminate code.
  std::vector<double>
  parse_layup(const Entry &entry);
} // namespace lamella

#endif
