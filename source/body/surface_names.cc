// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/surface_names.h>

namespace lamella
{
  std::string
  surface_names::end_name(const bool at_start)
  {
    return at_start ? "start" : "end";
  }



  bool
  surface_names::is_whole_surface(const std::string &surface)
  {
    return surface == "all";
  }



  bool
  surface_names::is_compound_surface(const std::string &surface)
  {
    return surface == "ends" || is_whole_surface(surface);
  }



  bool
  surface_names::covers(const std::string &surface, const std::string &part)
  {
    return surface == part || is_whole_surface(surface) ||
           (surface == "ends" && (part == "start" || part == "end"));
  }
} // namespace lamella
