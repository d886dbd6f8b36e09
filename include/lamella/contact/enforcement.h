// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_enforcement_h
#define lamella_contact_enforcement_h

#include <lamella/base/names.h>

namespace lamella
{
  /// How the rows of a contact keep apart what they pair. All three are one
  /// law, g + a lambda = 0 where the bodies touch, with the compliance a = 1 /
  /// eps [length / force] for `penalty` and a = 0 for the other two. How each
  /// strategy gets there is in doc/contact.md.
  enum class Enforcement
  {
    undefined,
    penalty,              ///< lambda = eps max(0, -g): bodies penetrate
    augmented_lagrangian, ///< the same about an estimate of lambda, improved
                          ///< until no penetration is left
    exact                 ///< multipliers: g >= 0 itself
  };

  template <>
  struct Names<Enforcement>
  {
    static constexpr NameOf<Enforcement> all[] = {
      {Enforcement::penalty, "penalty"},
      {Enforcement::augmented_lagrangian, "augmented lagrangian"},
      {Enforcement::exact, "exact"}};
  };

  /// How a penalty is given. doc/penalty.md measures what size does: too soft
  /// leaves a penetration, too stiff drowns the bodies' own stiffness in
  /// rounding (the paper's Eq. 24).
  enum class PenaltyKind
  {
    undefined,
    automatic, ///< a multiple of the row's local stiffness
    per_node,  ///< force / length, as in the paper's Eq. 23
    per_area   ///< force / length^3, times the tributary area: mesh-independent
  };

  /// What a scene says of a number (and `auto` in its place).
  template <>
  struct Names<PenaltyKind>
  {
    static constexpr NameOf<PenaltyKind> all[] =
      {{PenaltyKind::per_area, "area"}, {PenaltyKind::per_node, "node"}};
  };

  /// The penalty parameter epsilon_N of the paper's Eq. 20, as a scene gives
  /// it.
  struct Penalty
  {
    /// Has to be set: row_penalty() asserts it.
    PenaltyKind kind = PenaltyKind::undefined;
    /// The penalty in the unit of its kind, or for `automatic` the multiple (no
    /// unit; a scene's `auto` is 1e6). Positive.
    double value = 0.;
  };

  /// The stiffness of the cell below one side of a pair against a force on its
  /// surface: a bar of section A and length h, E_n A / h [force / length].
  struct LocalStiffness
  {
    /// E_n = n.n : C : n.n of the ply there, without contraction
    /// [force/length^2]; the tributary area A [length^2]; the depth h [length]
    /// of the cell, normal to the surface.
    double normal_modulus = 0., area = 0., depth = 0.;
  };

  /**
   * epsilon_N of one row [force / length]:
   *   automatic   value * min over both sides of E_n A / h
   *   per_node    value
   *   per_area    value * A, A that of @p first (both sides have the same)
   * `automatic` takes the softer side of the pair; it does not depend on the
   * basis of the section and is defined for floating bodies, too. It is larger
   * than the stiffness of the bodies behind the row, which nobody knows before
   * anything is solved. Depths must not be zero.
   */
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second);

  /// The contact force of a gap @p g [length] under the penalty @p epsilon
  /// [force / length] (the size of Eq. 25), positive in compression:
  ///   lambda = epsilon max(0, -g).
  /// With n of the row it acts on the second body, and against n on the first.
  double
  contact_force(const double epsilon, const double g);
} // namespace lamella

#endif
