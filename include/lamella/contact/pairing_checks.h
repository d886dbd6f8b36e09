// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_checks_h
#define lamella_contact_pairing_checks_h

#include <lamella/contact/contact_pair.h>
#include <lamella/contact/pairing.h>

namespace lamella
{
  /// Throws InputError of a contact nothing of which faces the other side
  /// within @p reach [length]; the message gives the nearest distance of nodes,
  /// and of pairs of nodes the best sideways offset.
  [[noreturn]] void
  fail_without_pairs(const ContactPair &contact,
                     const Bodies      &bodies,
                     const double       reach);

  /**
   * Throws InputError if a place of @p gaps that lies far behind the other side
   * is inside of the other body, or if there is none but such places. Places
   * far behind each other either look away from each other through their own
   * bodies, and then do not pair, or the bodies lie in each other. The second
   * side carries the points if @p on_second. Undeformed.
   */
  void
  check_not_passed(const ContactPair &contact,
                   const Bodies      &bodies,
                   const bool         on_second,
                   const Gaps        &gaps);
} // namespace lamella

#endif
