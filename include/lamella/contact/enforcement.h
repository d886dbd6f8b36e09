// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_enforcement_h
#define lamella_contact_enforcement_h

#include <lamella/base/names.h>

namespace lamella
{
  /// Enforcement of contact constraints. An active constraint satisfies g + a
  /// lambda = 0 with gap g, force lambda and compliance a = 1 / eps for
  /// `penalty` (parameter eps [force / length]), else a = 0.
  enum class Enforcement
  {
    undefined,
    penalty,              ///< lambda = eps max(0, -g): bodies penetrate
    augmented_lagrangian, ///< penalty about a multiplier estimate, improved
                          ///< until there is no penetration
    exact                 ///< Lagrange multipliers: g >= 0
  };

  /// Names of the enforcement methods in parameter files.
  template <>
  struct Names<Enforcement>
  {
    static constexpr NameOf<Enforcement> all[] = {
      {Enforcement::penalty, "penalty"},
      {Enforcement::augmented_lagrangian, "augmented lagrangian"},
      {Enforcement::exact, "exact"}}; ///< Value and name of each method.
  };

  /// Unit of a penalty parameter. A small penalty permits penetration; a large
  /// one increases rounding errors (doc/theory/penalty.md).
  enum class PenaltyKind
  {
    undefined,
    automatic, ///< a multiple of the local stiffness of the cells in contact
    per_node,  ///< force / length, as in Eq. 23 of Nagaraj et al. 2020
    per_area   ///< force / length^3, times the tributary area: mesh-independent
  };

  /// Names of units of a numeric penalty; `auto` needs no unit.
  template <>
  struct Names<PenaltyKind>
  {
    /// Value and name of each unit.
    static constexpr NameOf<PenaltyKind> all[] =
      {{PenaltyKind::per_area, "area"}, {PenaltyKind::per_node, "node"}};
  };

  /// Penalty parameter of a contact, as given in a scene file.
  struct Penalty
  {
    /// Unit of `value`. Must be set before row_penalty().
    PenaltyKind kind = PenaltyKind::undefined;
    /// Positive penalty; if `automatic`, a multiple of the local stiffness.
    double value = 0.;
  };

  /// Stiffness E_n A / h [force / length] of the cell behind one side of a
  /// contact constraint: a bar of modulus E_n, cross section A and length h.
  struct LocalStiffness
  {
    double normal_modulus = 0., ///< Modulus along the normal [force/length^2].
      area                = 0., ///< Tributary area [length^2].
      depth               = 0.; ///< Cell depth along the normal [length].
  };

  /// Returns the penalty parameter of one constraint [force / length]:
  ///   automatic   value * min over both sides of E_n A / h
  ///   per_node    value
  ///   per_area    value * A, A that of @p first (both sides have the same)
  /// with the members of @p penalty, and the normal modulus E_n, tributary area
  /// A and cell depth h > 0 of @p first and @p second. Supports do not enter.
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second);
} // namespace lamella

#endif
