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
  /// Failure criteria. Formulas and sources are in doc/theory/strength.md.
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
    interlaminar, ///< quadratic delamination criterion at ply interfaces
    core_shear,
    core_crushing,
    face_wrinkling ///< local buckling of a face sheet on a core
  };

  /// Names of the failure criteria in parameter files.
  template <>
  struct Names<Criterion>
  {
    /// Value and name of each failure criterion.
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

  /// Returns the names of all failure criteria in the order of Criterion.
  std::vector<std::string>
  criterion_names();

  /// Returns the parameter, e.g. `Strengths`, that @p criterion requires and @p
  /// material lacks; empty if none. Face wrinkling requires core moduli only.
  std::string
  missing_entry(const Criterion criterion, const Material &material);

  /// Wrinkling stresses of a face sheet, positive [force / length^2].
  struct WrinklingStresses
  {
    double along_1 = 0.; ///< Compression along axis 1 of the face sheet.
    double along_2 = 0.; ///< Compression along axis 2 of the face sheet.
  };

  /// Returns the wrinkling stresses of a face sheet on a thick core (Hoff and
  /// Mautner, J. Aeronaut. Sci. 12 (1945) 285-297),
  ///   sigma = 1/2 (E_f E_c G_c)^(1/3),
  /// for compression along the axes d = 1, 2 of the face. E_f is Young's
  /// modulus of the face along d, E_c that of the core along 3. The shear
  /// modulus of the core in the plane of d and 3 is G_c = G13 cos^2 t + G23
  /// sin^2 t. The angle t from axis 1 of the core to d is @p face_angle - @p
  /// core_angle, in degrees as in ply_axes(), plus 90 for d = 2.
  WrinklingStresses
  wrinkling_stresses(const EngineeringConstants &face,
                     const EngineeringConstants &core,
                     const double                face_angle,
                     const double                core_angle);

  /// Result of a failure criterion for the stress at one point.
  struct Assessment
  {
    /// Failure index, the maximum over all failure modes; 1 at failure.
    double index = 0.;
    /// Reserve factor: the smallest R >= 0 for which R times the mechanical
    /// stress plus the residual stress has the failure index 1. Empty if R >
    /// 1e6; 0 if the residual stress alone causes failure.
    std::optional<double> reserve;
    /// Failure mode at the reserve factor, e.g. `tension 1`; without reserve
    /// factor, the mode with the largest failure index.
    std::string_view mode;
    /// Fracture angle of Puck's inter-fiber fracture [degrees], from axis 2 to
    /// the normal of the action plane, positive towards axis 3; else empty.
    std::optional<double> angle;
  };

  /// The failure surface f(sigma) = 1 of a failure criterion for one material,
  /// with stresses sigma in material axes, {11, 22, 33, 12, 13, 23}.
  ///
  /// All criteria except Puck's are piecewise quadratic. The coefficients s_i,
  /// p_ij, l_i depend on the failure mode and on the signs of sigma_11,
  /// sigma_22, sigma_33 and sigma_22 + sigma_33:
  ///   f = sum s_i sigma_i^2 + p_12 sigma_11 sigma_22 + p_13 sigma_11 sigma_33
  ///     + p_23 sigma_22 sigma_33 + sum l_i sigma_i.
  /// For the stress R sigma_mech + sigma_res, f is a parabola in R as long as
  /// no sign changes. The reserve factor is the smallest root R of f = 1 over
  /// all modes, or R of a sign change where f jumps above 1 (Tsai-Hill,
  /// Hashin's fiber mode). Puck's stress exposure for inter-fiber fracture is
  /// homogeneous of degree 1: R = 1/f without residual stress, else bisection.
  class FailureSurface
  {
  public:
    /// Computes the coefficients; missing_entry() must be empty. @p wrinkling
    /// is used by face wrinkling only.
    FailureSurface(const Criterion          criterion,
                   const Material          &material,
                   const WrinklingStresses &wrinkling = {});

    /// Returns index, reserve factor and failure mode for the @p mechanical
    /// stress, proportional to the loads, plus constant @p residual stress.
    Assessment
    assess(const Voigt &mechanical, const Voigt &residual = Voigt()) const;

  private:
    /// The quadratic function f of one failure mode for given stress signs.
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

    /// Signs of the stresses as bits, set if sigma_11 < 0, sigma_22 < 0,
    /// sigma_33 < 0, and sigma_22 + sigma_33 < 0.
    using Signs                    = unsigned int;
    static constexpr Signs n_signs = 16;
    static Signs
    signs_of(const Voigt &stress);

    /// Returns f of all failure modes of @p criterion for stress @p signs.
    std::vector<Form>
    forms_of(const Criterion          criterion,
             const Material          &material,
             const WrinklingStresses &wrinkling,
             const Signs              signs) const;

    /// Returns the smallest factor R in (@p from, @p to] of @p mechanical at
    /// which f = 1, and the failure mode. R is @p from if f > 1 there.
    std::optional<std::pair<double, const Form *>>
    first_root(const Signs  signs,
               const Voigt &mechanical,
               const Voigt &residual,
               const double from,
               const double to) const;
    /// Returns the largest failure index f(@p stress) of all failure modes, and
    /// the name of that mode.
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
