// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_constraint_assembly_h
#define lamella_contact_constraint_assembly_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/gap_integrals.h>

#include <map>
#include <vector>

namespace lamella
{
  /// Contact points on the current surfaces of a contact, with the mortar
  /// integrals over them, from which constraints are assembled.
  struct EvaluatedPoints
  {
    const ContactSides &undeformed,             ///< Undeformed surfaces.
      &sides;                                   ///< Current surfaces.
    const std::vector<GapPoint>     &points;    ///< Points and projections.
    const std::vector<GapIntegrals> &integrals; ///< One per constraint.
  };

  /// Gap that is added to the gap of a constraint [length], by the number of
  /// its slave node, which pairings do not change.
  using GapOffsets = std::map<unsigned int, double>;

  /// Returns the multiplier functions of @p interface; null for constraints of
  /// single points.
  inline const SlaveSurface *
  functions_of(const ContactInterface &interface)
  {
    return interface.discretization == Discretization::surface_to_surface ?
             interface.surface.get() :
             nullptr;
  }

  /// Sets positions, normals and functionals of the gap constraints of @p
  /// interface, such that GapConstraint::gap() is the gap of @p at plus its
  /// offset in @p offsets at the displacements @p u and load factor @p factor.
  /// Constraints without a projection have the gap @p open [length].
  void
  set_gaps(const EvaluatedPoints &at,
           const BlockVector     &u,
           const LoadFactor      &factor,
           const double           open,
           const GapOffsets      &offsets,
           ContactInterface      &interface);

  /// Sets two slip functionals of each constraint i of @p interface, one for
  /// each unit tangent t_a of its normal n, each with a functional per body:
  ///   s_a = sum_k t_a . P_k . (v_2(X_k) - v_1(X_k)),
  ///   P_k = 1/A_i int phi_i psi_k (I - n n) dA,
  /// with trace functions psi_k, multiplier functions phi_i of integral A_i,
  /// and displacements v_1 and v_2 of the two sides.
  void
  set_slips(const EvaluatedPoints &at, ContactInterface &interface);

  /// Sets SlipConstraint::initial so that the slips of @p interface at @p u and
  /// @p factor are the slip increments of @p integrals.
  void
  offset_slips(const std::vector<GapIntegrals> &integrals,
               const BlockVector               &u,
               const LoadFactor                &factor,
               ContactInterface                &interface);
} // namespace lamella

#endif
