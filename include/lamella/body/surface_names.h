// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_names_h
#define lamella_body_surface_names_h

#include <string>

namespace lamella
{
  /**
   * The names of surfaces that every body has, whatever its section calls its
   * sides: `start` and `end`, where y is 0 and L; `ends`, both of them; `all`,
   * the ends and all sides. Here alone they are compared.
   */
  namespace surface_names
  {
    /// "start", or "end".
    std::string
    of_end(const bool at_start);

    /// Whether @p surface is `all`.
    bool
    is_all(const std::string &surface);

    /// Whether @p surface is one of those that are made of others: `ends`,
    /// `all`.
    bool
    is_several(const std::string &surface);

    /// Whether @p part is @p surface or a part of it.
    bool
    covers(const std::string &surface, const std::string &part);
  } // namespace surface_names
} // namespace lamella

#endif
