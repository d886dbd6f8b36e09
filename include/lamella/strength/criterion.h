// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `strength`: failure criteria of materials, their constants from a
// material's strengths, and reserve factors of stresses. It is independent of
// bodies, meshes and load steps.

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
  /// A failure criterion. Formulas and sources are in doc/theory/strength.md.
  enum class Criterion
  {
    undefined,
    maximum_stress,
    maximum_strain,
    tsai_hill,
    tsai_wu,
    hoffman,
    hashin, ///< in three dimensions, of 1980
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

  /// Returns the names of all criteria, in their order.
  std::vector<std::string>
  criterion_names();

  /// Returns the missing entry of @p material that @p criterion needs, as
  /// `Strengths`; empty if there is none. Face wrinkling needs only the moduli
  /// of the core.
  std::string
  missing_entry(const Criterion criterion, const Material &material);

  /// Magnitudes of the compressive wrinkling stresses of a face along 1, 2.
  struct WrinklingStresses
  {
    double along_1 = 0., along_2 = 0.;
  };

  /**
   * Returns Hoff's wrinkling stresses of a face on a thick core (Hoff and
   * Mautner, J. Aeronaut. Sci. 12 (1945) 285-297),
   *   sigma = 1/2 (E_f E_c G_c)^(1/3),
   * along d = 1, 2 of the face. E_f is its Young's modulus along d, E_c that of
   * the core along 3. The core's shear modulus G_c in the plane of d and 3 is
   * G13 cos^2 + G23 sin^2 of the angle from the core's axis 1 to d:
   * @p face_angle - @p core_angle in degrees (ply_axes()), plus 90 for d = 2.
   */
  WrinklingStresses
  wrinkling_stresses(const EngineeringConstants &face,
                     const EngineeringConstants &core,
                     const double                face_angle,
                     const double                core_angle);

  /// Distance of a stress from failure.
  struct Assessment
  {
    /// The criterion's value f, the largest of its modes: 1 at failure.
    double index = 0.;
    /// Reserve factor, the smallest R >= 0 with f(R sigma_mech + sigma_res) =
    /// 1; empty beyond 1e6, 0 if the residual stress alone fails.
    std::optional<double> reserve;
    /// Failure mode at R, or without R that of largest f: `tension 1`.
    std::string_view mode;
    /// Angle of Puck's inter-fiber fracture from axis 2 to the normal of the
    /// action plane, positive towards 3, in degrees from -90 to 90.
    std::optional<double> angle;
  };

  /**
   * Failure surface f(sigma) = 1 of one criterion for one material. Stresses
   * are in the material's own axes, {11, 22, 33, 12, 13, 23}.
   *
   * All criteria but Puck's are piecewise quadratic, by the signs of sigma_11,
   * sigma_22, sigma_33 and sigma_22 + sigma_33, with a form per mode:
   *   f = sum s_i sigma_i^2 + p_12 sigma_11 sigma_22 + p_13 sigma_11 sigma_33
   *     + p_23 sigma_22 sigma_33 + sum l_i sigma_i.
   * Each piece is a parabola in R along R sigma_mech + sigma_res, and the
   * reserve factor is the first root of any mode. If a criterion jumps past 1
   * at a sign change (Tsai-Hill, Hashin's fiber mode), R is that point. Puck's
   * inter-fiber exposure is homogeneous of degree 1, so R = 1/f without
   * residual stress; with one the first root is bracketed and bisected.
   * assess() allocates no memory.
   */
  class FailureSurface
  {
  public:
    /// Requires an empty missing_entry(). Only face wrinkling uses
    /// @p wrinkling.
    FailureSurface(const Criterion          criterion,
                   const Material          &material,
                   const WrinklingStresses &wrinkling = {});

    /// Assesses the sum of @p mechanical stress, proportional to the loads, and
    /// constant @p residual stress (as of cure).
    Assessment
    assess(const Voigt &mechanical, const Voigt &residual = Voigt()) const;

    /// Returns assess(@p stress).index at less cost.
    double
    index(const Voigt &stress) const;

  private:
    /// A quadratic form of one mode.
    struct Form
    {
      std::string_view mode;
      Voigt            squares = {}, linear = {};
      /// Coefficients of 11 22, 11 33 and 22 33.
      std::array<double, 3> products{};

      /// Returns the symmetric bilinear form of the quadratic part of f.
      double
      bilinear(const Voigt &s, const Voigt &t) const;
      double
      operator()(const Voigt &s) const
      {
        return bilinear(s, s) + linear * s;
      }
    };

    /// Bits of a piece: sigma_11 < 0, sigma_22, sigma_33, sigma_22 + sigma_33.
    using Signs                    = unsigned int;
    static constexpr Signs n_signs = 16;
    static Signs
    signs_of(const Voigt &stress);

    /// Returns the modes of one piece of @p criterion, in its order.
    std::vector<Form>
    forms_of(const Criterion          criterion,
             const Material          &material,
             const WrinklingStresses &wrinkling,
             const Signs              signs) const;

    /// Returns the first R in (@p from, @p to] at which a mode of the piece
    /// @p signs has f = 1 (@p from if f is larger there), and that mode.
    std::optional<std::pair<double, const Form *>>
    first_root(const Signs  signs,
               const Voigt &mechanical,
               const Voigt &residual,
               const double from,
               const double to) const;
    /// Returns the largest f(@p stress) of the modes, and that mode.
    std::pair<double, std::string_view>
    largest_form(const Voigt &stress) const;
    /// Assesses without Puck's inter-fiber fracture.
    Assessment
    assess_forms(const Voigt &mechanical, const Voigt &residual) const;

    /// Returns Puck's stress exposure for inter-fiber fracture on the plane
    /// with its normal at @p angle [rad] from axis 2 to 3.
    double
    exposure(const Voigt &stress, const double angle) const;
    /// Returns the largest exposure over all planes, and its angle.
    std::pair<double, double>
    action_plane(const Voigt &stress) const;
    /// Assesses Puck's inter-fiber fracture.
    Assessment
    assess_planes(const Voigt &mechanical, const Voigt &residual) const;

    std::array<std::vector<Form>, n_signs> forms;

    /// Data of Puck: strength in tension across the fiber, shear along it,
    /// shear resistance of the action plane; inclinations.
    bool             has_planes = false;
    double           Rt = 0., Rl = 0., Ra = 0.;
    PuckInclinations p;
  };
} // namespace lamella

#endif
