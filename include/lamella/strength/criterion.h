// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `strength`: failure criteria of materials and the reserve factors
// of stresses. It is independent of bodies, meshes and load steps.

#ifndef lamella_strength_criterion_h
#define lamella_strength_criterion_h

#include <lamella/base/names.h>
#include <lamella/material/material.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lamella
{
  /// Name of a failure criterion. Formulas and sources: doc/theory/strength.md.
  enum class Criterion
  {
    undefined,
    maximum_stress,
    maximum_strain,
    tsai_hill,
    tsai_wu,
    hoffman,
    hashin, ///< Hashin 1980, in three dimensions
    puck,   ///< fiber and inter-fiber fracture, with its action plane
    von_mises,
    interlaminar, ///< quadratic, at interfaces between plies
    core_shear,
    core_crushing,
    face_wrinkling ///< of a ply upon a core
  };

  template <>
  struct Names<Criterion>
  {
    static constexpr NameOf<Criterion> all[] = {
      {Criterion::maximum_stress, "maximum stress"},
      {Criterion::maximum_strain, "maximum strain"},
      {Criterion::tsai_hill, "Tsai-Hill"},
      {Criterion::tsai_wu, "Tsai-Wu"},
      {Criterion::hoffman, "Hoffman"},
      {Criterion::hashin, "Hashin"},
      {Criterion::puck, "Puck"},
      {Criterion::von_mises, "von Mises"},
      {Criterion::interlaminar, "interlaminar"},
      {Criterion::core_shear, "core shear"},
      {Criterion::core_crushing, "core crushing"},
      {Criterion::face_wrinkling, "face wrinkling"}};
  };

  /// Returns the names of all criteria in the order of the enumeration.
  std::vector<std::string>
  criterion_names();

  /// Returns the name of an entry, e.g. `Strengths`, that @p criterion
  /// requires, but @p material lacks; empty if nothing is missing. Face
  /// wrinkling requires only the moduli of the core.
  std::string
  missing_entry(const Criterion criterion, const Material &material);

  /// Wrinkling stresses of a face sheet under compression along its axes 1 and
  /// 2, as positive numbers [force/length^2].
  struct WrinklingStresses
  {
    double along_1 = 0., along_2 = 0.;
  };

  /// Returns the wrinkling stresses of a face sheet on a thick core (Hoff and
  /// Mautner, J. Aeronaut. Sci. 12 (1945) 285-297),
  ///   sigma = 1/2 (E_f E_c G_c)^(1/3),
  /// for compression along the axes d = 1, 2 of the face. E_f is Young's
  /// modulus of the face along d, E_c that of the core along 3. The shear
  /// modulus of the core in the plane of d and 3 is G_c = G13 cos^2 t + G23
  /// sin^2 t, where t is the angle from the core's axis 1 to d: t =
  /// @p face_angle - @p core_angle, in degrees as in ply_axes(), plus 90 for d
  /// = 2.
  WrinklingStresses
  wrinkling_stresses(const EngineeringConstants &face,
                     const EngineeringConstants &core,
                     const double                face_angle,
                     const double                core_angle);

  /// Result of a failure criterion for one stress.
  struct Assessment
  {
    /// Failure index f, the maximum over all failure modes; 1 at failure.
    double index = 0.;
    /// Reserve factor, the smallest R >= 0 with f(R sigma_mech + sigma_res) = 1
    /// for the mechanical and the residual stress. Empty if R > 1e6; 0 if the
    /// residual stress alone causes failure.
    std::optional<double> reserve;
    /// Failure mode at R, e.g. `tension 1`; without R, that of the largest f.
    std::string_view mode;
    /// Fracture angle of Puck's inter-fiber fracture, from axis 2 to the normal
    /// of the action plane, positive towards axis 3, in degrees from -90 to 90.
    std::optional<double> angle;
  };

  /// The failure surface f(sigma) = 1 of a failure criterion for one material.
  /// Stresses are in the material's own axes, {11, 22, 33, 12, 13, 23}.
  ///
  /// All criteria but Puck's are piecewise quadratic. The coefficients s_i,
  /// p_ij, l_i depend on the failure mode and on the signs of sigma_11,
  /// sigma_22, sigma_33 and sigma_22 + sigma_33:
  ///   f = sum s_i sigma_i^2 + p_12 sigma_11 sigma_22 + p_13 sigma_11 sigma_33
  ///     + p_23 sigma_22 sigma_33 + sum l_i sigma_i.
  /// With the stress R sigma_mech + sigma_res, each f is a parabola in R
  /// between sign changes, and the reserve factor is the smallest root of f = 1
  /// over all modes. If f jumps from below to above 1 at a sign change
  /// (Tsai-Hill, Hashin's fiber mode), the reserve factor is R of this sign
  /// change. Puck's stress exposure for inter-fiber fracture is homogeneous of
  /// degree 1, so R = 1/f without residual stress; otherwise R is found by
  /// bisection.
  class FailureSurface
  {
  public:
    /// Computes the coefficients. missing_entry() must be empty. @p wrinkling
    /// is required for face wrinkling only.
    FailureSurface(const Criterion          criterion,
                   const Material          &material,
                   const WrinklingStresses &wrinkling = {});

    /// Evaluates the criterion for the sum of the @p mechanical stress,
    /// proportional to the loads, and the constant @p residual stress (curing).
    Assessment
    assess(const Voigt &mechanical, const Voigt &residual = Voigt()) const;

    /// Returns only the failure index of @p stress, faster than assess().
    double
    index(const Voigt &stress) const;

  private:
    /// The quadratic function f of one failure mode and one set of signs.
    struct Form
    {
      std::string_view mode;
      Voigt            squares = {}, linear = {};
      /// Coefficients p_12, p_13 and p_23.
      std::array<double, 3> products{};

      /// Returns the symmetric bilinear form of the quadratic terms of f.
      double
      bilinear(const Voigt &s, const Voigt &t) const;
      double
      operator()(const Voigt &s) const
      {
        return bilinear(s, s) + linear * s;
      }
    };

    /// Bits: sigma_11 < 0, sigma_22 < 0, sigma_33 < 0, sigma_22 + sigma_33 < 0.
    using Signs                    = unsigned int;
    static constexpr Signs n_signs = 16;
    static Signs
    signs_of(const Voigt &stress);

    /// Returns f of all failure modes of @p criterion for @p signs.
    std::vector<Form>
    forms_of(const Criterion          criterion,
             const Material          &material,
             const WrinklingStresses &wrinkling,
             const Signs              signs) const;

    /// Returns the smallest R in (@p from, @p to] at which f = 1 for a mode of
    /// @p signs, and that mode. R is @p from if f > 1 there.
    std::optional<std::pair<double, const Form *>>
    first_root(const Signs  signs,
               const Voigt &mechanical,
               const Voigt &residual,
               const double from,
               const double to) const;
    /// Returns the largest f(@p stress) over all modes, and that mode.
    std::pair<double, std::string_view>
    largest_form(const Voigt &stress) const;
    /// Returns the assessment without Puck's inter-fiber fracture.
    Assessment
    assess_forms(const Voigt &mechanical, const Voigt &residual) const;

    /// Returns Puck's stress exposure for inter-fiber fracture on the plane
    /// with its normal at @p angle [rad] from axis 2 to 3.
    double
    exposure(const Voigt &stress, const double angle) const;
    /// Returns the largest exposure over all planes, and its angle.
    std::pair<double, double>
    action_plane(const Voigt &stress) const;
    /// Returns the assessment of Puck's inter-fiber fracture alone.
    Assessment
    assess_planes(const Voigt &mechanical, const Voigt &residual) const;

    std::array<std::vector<Form>, n_signs> forms;

    /// Parameters of Puck's criterion: tensile strength Rt across the fiber,
    /// shear strength Rl along the fiber, shear resistance Ra of the action
    /// plane across the fiber, and inclinations.
    bool             has_planes = false;
    double           Rt = 0., Rl = 0., Ra = 0.;
    PuckInclinations p;
  };
} // namespace lamella

#endif
