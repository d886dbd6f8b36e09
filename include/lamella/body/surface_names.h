// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_names_h
#define lamella_body_surface_names_h

#include <string>

namespace lamella
{
  /// Functions on the names of surfaces that every body has: `start` (y = 0),
  /// `end` (y = L), `ends` (both), `all` (ends and lateral surfaces).
  namespace surface_names
  {
    /// Returns "start" if @p at_start is true, otherwise "end".
    std::string
    end_name(const bool at_start);

    /// Returns true if @p surface is `all`: ends and lateral surfaces.
    bool
    is_whole_surface(const std::string &surface);

    /// Returns true if @p surface is `ends` or `all`, which combine surfaces.
    bool
    is_compound_surface(const std::string &surface);

    /// Returns true if the surface @p surface is @p part or contains it.
    bool
    covers(const std::string &surface, const std::string &part);
  } // namespace surface_names
} // namespace lamella

#endif
