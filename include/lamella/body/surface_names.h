// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_names_h
#define lamella_body_surface_names_h

#include <string>

namespace lamella
{
  /// Names of surfaces that every body has: `start` (y = 0), `end` (y = L),
  /// `ends` (both), `all` (ends and sides). They are compared only here.
  namespace surface_names
  {
    /// Returns "start" or "end".
    std::string
    end_name(const bool at_start);

    /// Returns true if @p surface is `all`.
    bool
    is_whole_surface(const std::string &surface);

    /// Returns true if @p surface consists of others: `ends`, `all`.
    bool
    is_compound_surface(const std::string &surface);

    /// Returns true if @p part is @p surface or a part of it.
    bool
    covers(const std::string &surface, const std::string &part);
  } // namespace surface_names
} // namespace lamella

#endif
