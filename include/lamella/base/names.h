// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_names_h
#define lamella_base_names_h

#include <deal.II/base/patterns.h>

#include <cstddef>
#include <optional>
#include <string>

namespace lamella
{
  /// A value of the enumeration @p E and its name.
  template <typename E>
  struct NameOf
  {
    E           value; ///< Value of the enumeration.
    const char *name;  ///< Name in scenes, tables and messages.
  };

  /// List of the names of the values of the enumeration @p E, to read and write
  /// these values. Specialized in the header of the enumeration, e.g.
  ///   template <>
  ///   struct Names<Strategy>
  ///   {
  ///     static constexpr NameOf<Strategy> all[] = {
  ///       {Strategy::condensed, "condensed"}, {Strategy::full, "full"}};
  ///   };
  /// Messages list the names in this order. Values without a name, such as
  /// `undefined`, cannot be set by the user. Names and values must be unique.
  template <typename E>
  struct Names;

  /// Returns the name of @p value from Names<E>; empty if it has none. SFINAE
  /// excludes types without a specialization of Names.
  template <typename E, std::size_t = sizeof(Names<E>)>
  std::string
  name_of(const E value)
  {
    for (const NameOf<E> &entry : Names<E>::all)
      if (entry.value == value)
        return entry.name;
    return "";
  }

  /// Returns the value of the enumeration @p E with the name @p name
  /// (case-sensitive), or std::nullopt if there is none.
  template <typename E>
  std::optional<E>
  named(const std::string &name)
  {
    for (const NameOf<E> &entry : Names<E>::all)
      if (name == entry.name)
        return entry.value;
    return std::nullopt;
  }

  /// Returns the deal.II pattern that matches the names of the values of @p E.
  template <typename E>
  dealii::Patterns::Selection
  selection()
  {
    std::string names;
    for (const NameOf<E> &entry : Names<E>::all)
      names += (names.empty() ? "" : "|") + std::string(entry.name);
    return dealii::Patterns::Selection(names);
  }
} // namespace lamella

#endif
