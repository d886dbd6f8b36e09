// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_checks_h
#define lamella_contact_pairing_checks_h

#include <lamella/contact/contact_pair.h>
#include <lamella/contact/pairing.h>

namespace lamella
{
  /// Throws InputError of a contact without any pair within @p search_radius,
  /// with the nearest distance of nodes or tangential offset of node pairs.
  [[noreturn]] void
  throw_no_pairs(const ContactPair &contact,
                 const Bodies      &bodies,
                 const double       search_radius);

  /// Throws InputError if a point of @p gaps that is too deep lies inside the
  /// other body, or if all points are too deep. Others face away through their
  /// own bodies. The second side is the slave if @p on_second.
  void
  check_no_penetration(const ContactPair &contact,
                       const Bodies      &bodies,
                       const bool         on_second,
                       const Gaps        &gaps);
} // namespace lamella

#endif
