// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_checks_h
#define lamella_contact_pairing_checks_h

#include <lamella/contact/contact_pair.h>
#include <lamella/contact/pairing.h>

namespace lamella
{
  /// Throws InputError for a contact without facing points within @p
  /// search_radius [length]. The message gives the smallest distance or offset.
  [[noreturn]] void
  throw_no_pairs(const ContactPair &contact,
                 const Bodies      &bodies,
                 const double       search_radius);

  /// Throws InputError if a slave point deep behind the master surface
  /// (Gaps::deep_penetrations) lies inside the other body, or if @p gaps has no
  /// other points. Deep points outside the other body are accepted: they face
  /// away from it (the upper half of a roller). The slave is the second surface
  /// if @p on_second is true, else the first.
  void
  check_no_penetration(const ContactPair &contact,
                       const Bodies      &bodies,
                       const bool         on_second,
                       const Gaps        &gaps);
} // namespace lamella

#endif
