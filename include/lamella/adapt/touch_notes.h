// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_touch_notes_h
#define lamella_adapt_touch_notes_h

#include <lamella/adapt/touch.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Notes what @p touches of @p beam, which is of SV, have no fields.
  void
  note_missing_fields(const Beam               &beam,
                      const std::vector<Touch> &touches,
                      std::vector<std::string> &notes);

  /// Notes which of the @p touches of @p beam, if it is heated, hold sections
  /// in part: end fields do not know what heat does there.
  void
  note_heat_of_guides(const Beam               &beam,
                      const std::vector<Touch> &touches,
                      std::vector<std::string> &notes);
} // namespace lamella

#endif
