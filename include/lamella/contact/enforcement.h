// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_enforcement_h
#define lamella_contact_enforcement_h

#include <lamella/base/names.h>

namespace lamella
{
  /// Enforcement of the contact constraints by the law g + a lambda = 0 of an
  /// active constraint, with the compliance a = 1 / eps [length / force] for
  /// `penalty` and a = 0 for the other two methods (doc/theory/contact.md).
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

  /// Unit of a penalty parameter. A small penalty permits penetration; a large
  /// one increases rounding errors (doc/theory/penalty.md).
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

  /// Penalty parameter of a contact, as given in a scene file.
  struct Penalty
  {
    /// Unit of `value`. Must be set: row_penalty() asserts that.
    PenaltyKind kind = PenaltyKind::undefined;
    /// Positive penalty; if `automatic`, a multiple of the local stiffness.
    double value = 0.;
  };

  /// Stiffness E_n A / h [force / length] of the cell behind one side of a
  /// contact constraint: a bar of cross section A and length h.
  struct LocalStiffness
  {
    /// Elastic modulus E_n of the ply and depth h of the cell along the normal
    /// [force / length^2, length]; tributary area A [length^2].
    double normal_modulus = 0., area = 0., depth = 0.;
  };

  /// Returns the penalty parameter of one constraint [force / length]:
  ///   automatic   value * min over both sides of E_n A / h
  ///   per_node    value
  ///   per_area    value * A, A that of @p first (both sides have the same)
  /// with the normal modulus E_n, tributary area A and cell depth h > 0 of
  /// LocalStiffness. `automatic` also suits unsupported bodies.
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second);

  /// Returns the contact force epsilon max(0, -g) for the gap @p g and the
  /// penalty @p epsilon. It acts along the normal on the second body.
  double
  contact_force(const double epsilon, const double g);
} // namespace lamella

#endif
