// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_enforcement_h
#define lamella_contact_enforcement_h

namespace lamella
{
  /// How the rows of a contact keep apart what they pair.
  enum class Enforcement
  {
    undefined,
    penalty,              ///< lambda = eps max(0, -g): bodies penetrate
    augmented_lagrangian, ///< the same about an estimate of lambda, improved
                          ///< until no penetration is left
    exact                 ///< multipliers: g >= 0 itself
  };

  /// How a penalty is given.
  enum class PenaltyKind
  {
    undefined,
    automatic, ///< a multiple of the row's local stiffness
    per_node,  ///< force / length, as in the paper's Eq. 23
    per_area   ///< force / length^3, times the tributary area: mesh-independent
  };

  struct Penalty
  {
    PenaltyKind kind = PenaltyKind::undefined;
    /// The penalty, or for `automatic` the multiple.
    double value = 0.;
  };

  /// What one side of a pair offers against a force: E_n A / h with the normal
  /// modulus, the tributary area and the depth of the cell below.
  struct LocalStiffness
  {
    double normal_modulus = 0., area = 0., depth = 0.;
  };

  /**
   * epsilon_N of one row in force / length. `automatic` takes the softer side
   * of the pair: epsilon = value * min(E_n A / h), which does not depend on the
   * basis of the section and is defined for floating bodies, too.
   */
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second);

  /// The contact force of a gap @p g (Eq. 25), positive in compression:
  /// epsilon max(0, -g).
  double
  contact_force(const double epsilon, const double g);
} // namespace lamella

#endif
