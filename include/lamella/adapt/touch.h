// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_touch_h
#define lamella_adapt_touch_h

#include <lamella/adapt/section_load.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/gap_rows.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Something that touches a beam (a load, a support, a side of a contact) as
   * the section sees it. What acts there does so through rows over the DoFs,
   *   r(u) = sum_i sum_alpha w_i f_alpha u_(i,alpha),
   * products of weights of the axis and a section load vector f: those vectors
   * are all that the section can be asked to answer. A beam that carries all
   * fields of its section at all nodes tells them.
   */
  struct Touch
  {
    /// As in "contact nose".
    std::string name;
    /// The section load vectors f, unit length each and independent, in the
    /// section's fields.
    std::vector<Vector> loads;
    /// Those of the mean of all rows, weighted with their areas, and of what
    /// varies linearly across: what the section feels from afar.
    std::vector<Vector> smooth;
    /// The axis elements that it is on, or the node: from, to [length].
    double begin = 0., end = 0.;
    /// The shortest axis element there, or of those beside the node: no load
    /// can vary faster along the axis than it can show [length].
    double element = 0.;
    /// Whether it takes hold of the section as a whole: a clamp
    /// (is_clamp()).
    bool holds_section = false;
    /// Whether it is nothing but an end that is free to deform.
    bool is_free = false;
    /// Its rows then, r(u) = 0 each, their DoFs the fields of the section.
    std::vector<Row> held;
    /// Whether it is a side of a contact, whether a support, and whether heat.
    bool presses = false, holds = false, heats = false;
  };

  /// What touches the body number @p body, @p beam, which carries all fields at
  /// all nodes. In the order of supports, loads, contacts; a contact is
  /// followed by what rubs along either tangent. What presses normal
  /// to the axis is taken without its part along it (where surfaces slope).
  /// Heat that varies along the axis is a load where it does, in the name
  /// "heat", after the loads.
  std::vector<Touch>
  find_touches(const Beam                          &beam,
               const unsigned int                   body,
               const Bodies                        &bodies,
               const std::vector<Support>          &supports,
               const std::vector<Load>             &loads,
               const std::vector<ContactInterface> &contacts,
               const TouchRules                    &rules = {});

  /// Returns the load vector of @p load on body number @p body, at factor 1.
  Vector
  load_on(const Load &load, const unsigned int body, const Bodies &bodies);

  /// The ends of @p beam, if it is heated, that none of @p touches holds as a
  /// whole: stress that heat makes along the axis ends there.
  std::vector<Touch>
  heated_free_ends(const Beam &beam, const std::vector<Touch> &touches);
} // namespace lamella

#endif
