// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_enforcement_h
#define lamella_contact_enforcement_h

#include <lamella/base/names.h>

namespace lamella
{
  /// Enforcement of the contact constraints by one law, g + a lambda = 0, with
  /// the compliance a = 1 / eps [length / force] for `penalty` and a = 0 for
  /// the other two (doc/theory/contact.md).
  enum class Enforcement
  {
    undefined,
    penalty,              ///< lambda = eps max(0, -g): bodies penetrate
    augmented_lagrangian, ///< penalty about a multiplier estimate, improved
                          ///< until there is no penetration
    exact                 ///< Lagrange multipliers: g >= 0
  };

  template <>
  struct Names<Enforcement>
  {
    static constexpr NameOf<Enforcement> all[] = {
      {Enforcement::penalty, "penalty"},
      {Enforcement::augmented_lagrangian, "augmented lagrangian"},
      {Enforcement::exact, "exact"}};
  };

  /// Unit of a penalty. If too small, bodies penetrate; if too large, stiffness
  /// drowns in rounding (Eq. 24; doc/theory/penalty.md).
  enum class PenaltyKind
  {
    undefined,
    automatic, ///< a multiple of the row's local stiffness
    per_node,  ///< force / length, as in the paper's Eq. 23
    per_area   ///< force / length^3, times the tributary area: mesh-independent
  };

  /// Names of the numeric penalties in a scene (`auto` replaces the number).
  template <>
  struct Names<PenaltyKind>
  {
    static constexpr NameOf<PenaltyKind> all[] =
      {{PenaltyKind::per_area, "area"}, {PenaltyKind::per_node, "node"}};
  };

  /// The penalty parameter epsilon_N of Eq. 20, as given in a scene.
  struct Penalty
  {
    /// Mandatory: row_penalty() asserts it.
    PenaltyKind kind = PenaltyKind::undefined;
    /// Penalty in the unit of its kind, or its multiple; positive.
    double value = 0.;
  };

  /// Stiffness E_n A / h [force / length] of the cell below one side of a pair:
  /// a bar of section A and length h.
  struct LocalStiffness
  {
    /// E_n = n.n : C : n.n of the ply [force/length^2]; tributary area A
    /// [length^2]; depth h of the cell along the normal [length].
    double normal_modulus = 0., area = 0., depth = 0.;
  };

  /// Returns epsilon_N of one row [force / length]:
  ///   automatic   value * min over both sides of E_n A / h
  ///   per_node    value
  ///   per_area    value * A, A that of @p first (both sides have the same)
  /// `automatic` is defined for floating bodies and exceeds the stiffness of
  /// the bodies behind the row. Depths must not be zero.
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second);

  /// Returns the contact force lambda = epsilon max(0, -g) of a gap @p g with
  /// the penalty @p epsilon (magnitude of Eq. 25), along n of the row on the
  /// second body, and along -n on the first.
  double
  contact_force(const double epsilon, const double g);
} // namespace lamella

#endif
