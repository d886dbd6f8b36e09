// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `strength`: when a material fails. It owns the failure criteria,
// their constants from a material's strengths, and what stresses may be
// multiplied with until one is met. It never knows where a stress comes from:
// no bodies, no meshes, no load steps.

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
  /// What decides on failure. Formulas and sources stand in doc/strength.md.
  enum class Criterion
  {
    undefined,
    maximum_stress,
    maximum_strain,
    tsai_hill,
    tsai_wu,
    hoffman,
    hashin, ///< in three dimensions, of 1980
    puck,   ///< fibre and inter-fibre fracture, with its action plane
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

  /// The names of all criteria, in their order.
  std::vector<std::string>
  criterion_names();

  /// What of @p material @p criterion needs and nobody has given: the entry of
  /// its subsection, `Strengths`; empty if nothing is missing. Of face
  /// wrinkling nothing is asked of the face; its core needs its moduli alone.
  std::string
  missing_entry(const Criterion criterion, const Material &material);

  /// Sizes of the compressive stresses along 1 and 2 of a face at which it
  /// wrinkles, [force/length^2].
  struct WrinklingStresses
  {
    double along_1 = 0., along_2 = 0.;
  };

  /**
   * Hoff's stresses of a face on a thick core (Hoff and Mautner, J. Aeronaut.
   * Sci. 12 (1945) 285-297),
   *   sigma = 1/2 (E_f E_c G_c)^(1/3),
   * where along d = 1, 2 of the face E_f is its Young's modulus along d, E_c
   * that of the core along 3, and G_c the core's shear modulus in the plane of
   * d and 3: G13 cos^2 + G23 sin^2 of the angle from the core's axis 1 to d,
   * @p face_angle - @p core_angle in degrees (ply_axes()), and a right angle
   * more of d = 2. Nothing is checked.
   */
  WrinklingStresses
  wrinkling_stresses(const EngineeringConstants &face,
                     const EngineeringConstants &core,
                     const double                face_angle,
                     const double                core_angle);

  /// How near a stress is to failure.
  struct Assessment
  {
    /// The criterion's value f, of several modes the largest: 1 at failure.
    double index = 0.;
    /// The smallest R >= 0 at which f(R sigma_mech + sigma_res) comes to 1;
    /// none where it never does, or not up to 1e6. 0 if the residual stress
    /// alone fails.
    std::optional<double> reserve;
    /// What fails at that R, or without one has the largest f: `tension 1`.
    std::string_view mode;
    /// Of Puck's inter-fibre fracture: from axis 2 to the normal of the action
    /// plane, positive towards 3, in degrees from -90 to 90.
    std::optional<double> angle;
  };

  /**
   * One criterion for one material: where its failure surface f(sigma) = 1
   * lies. Stresses are in the material's own axes, {11, 22, 33, 12, 13, 23}.
   *
   * All criteria but Puck's are pieces of quadratic forms,
   *   f = sum s_i sigma_i^2 + p_12 sigma_11 sigma_22 + p_13 sigma_11 sigma_33
   *     + p_23 sigma_22 sigma_33 + sum l_i sigma_i,
   * one a mode, which one by the signs of sigma_11, sigma_22, sigma_33 and
   * sigma_22 + sigma_33. Along R sigma_mech + sigma_res each piece is a
   * parabola in R, from sign change to sign change, and the reserve factor
   * the first root of any mode. Where a criterion jumps at a sign change
   * (Tsai-Hill, Hashin's fibre mode), f may pass 1 there; R is that place.
   *
   * Puck's inter-fibre exposure is homogeneous of degree 1, so R = 1/f without
   * a residual stress; with one the first root is bracketed and bisected.
   *
   * Made once a material: some hundred numbers. assess() allocates nothing.
   */
  class FailureSurface
  {
  public:
    /// missing_entry() must be empty. @p wrinkling counts for that criterion
    /// alone.
    FailureSurface(const Criterion          criterion,
                   const Material          &material,
                   const WrinklingStresses &wrinkling = {});

    /// Of @p mechanical, which grows with the loads, and @p residual, which
    /// stays (of cure, say).
    Assessment
    assess(const Voigt &mechanical, const Voigt &residual = Voigt()) const;

    /// f(@p stress) = assess(@p stress).index, at less cost.
    double
    index(const Voigt &stress) const;

  private:
    /// A quadratic form in stresses, as above.
    struct Form
    {
      std::string_view mode;
      Voigt            squares = {}, linear = {};
      /// Of 11 22, 11 33 and 22 33.
      std::array<double, 3> products{};

      /// Its part of second degree as a symmetric bilinear form, so that
      /// bilinear(s, s) is that part of f(s).
      double
      bilinear(const Voigt &s, const Voigt &t) const;
      double
      operator()(const Voigt &s) const
      {
        return bilinear(s, s) + linear * s;
      }
    };

    /// The signs that choose a piece, bit by bit: sigma_11 < 0, sigma_22 < 0,
    /// sigma_33 < 0, sigma_22 + sigma_33 < 0.
    using Signs                    = unsigned int;
    static constexpr Signs n_signs = 16;
    static Signs
    signs_of(const Voigt &stress);

    /// The modes of one piece, of each criterion in its order.
    std::vector<Form>
    forms_of(const Criterion          criterion,
             const Material          &material,
             const WrinklingStresses &wrinkling,
             const Signs              signs) const;

    /// The first R in (@p from, @p to] at which a mode of the piece @p signs
    /// comes to 1, `from` where one is there already, and that mode.
    std::optional<std::pair<double, const Form *>>
    first_root(const Signs  signs,
               const Voigt &mechanical,
               const Voigt &residual,
               const double from,
               const double to) const;
    /// The largest f(@p stress) of the modes of its piece, and that mode.
    std::pair<double, std::string_view>
    largest_form(const Voigt &stress) const;
    /// assess() without Puck's inter-fibre fracture.
    Assessment
    assess_forms(const Voigt &mechanical, const Voigt &residual) const;

    /// Puck's stress exposure for inter-fibre fracture on the plane whose
    /// normal is @p angle (in rad) from axis 2 towards 3.
    double
    exposure(const Voigt &stress, const double angle) const;
    /// The largest over all planes, and its angle.
    std::pair<double, double>
    action_plane(const Voigt &stress) const;
    /// Puck's inter-fibre fracture.
    Assessment
    assess_planes(const Voigt &mechanical, const Voigt &residual) const;

    std::array<std::vector<Form>, n_signs> forms;

    /// Of Puck: tension across the fibre, shear along it, and the resistance
    /// of the action plane against shear across it; the inclinations.
    bool             has_planes = false;
    double           Rt = 0., Rl = 0., Ra = 0.;
    PuckInclinations p;
  };
} // namespace lamella

#endif
