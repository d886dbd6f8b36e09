// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_names_h
#define lamella_base_names_h

#include <deal.II/base/patterns.h>

#include <cstddef>
#include <optional>
#include <string>

namespace lamella
{
  /// Name of a value of the enumeration @p E.
  template <typename E>
  struct NameOf
  {
    /// The value.
    E value;
    /// Name in scenes, tables and messages.
    const char *name;
  };

  /**
   * List of names of the enumeration @p E, used for reading, writing and
   * patterns. Specialized beside the enumeration,
   *   template <>
   *   struct Names<Strategy>
   *   {
   *     static constexpr NameOf<Strategy> all[] = {
   *       {Strategy::condensed, "condensed"}, {Strategy::full, "full"}};
   *   };
   * in the order of messages. Values without a name (`undefined`) cannot be
   * written in a scene. Names and values must be unique.
   */
  template <typename E>
  struct Names;

  /// Returns the name of @p value; empty if it has none. SFINAE excludes types
  /// without a list.
  template <typename E, std::size_t = sizeof(Names<E>)>
  std::string
  name_of(const E value)
  {
    for (const NameOf<E> &entry : Names<E>::all)
      if (entry.value == value)
        return entry.name;
    return "";
  }

  /// Returns the value called @p name (case-sensitive), if there is one.
  template <typename E>
  std::optional<E>
  named(const std::string &name)
  {
    for (const NameOf<E> &entry : Names<E>::all)
      if (name == entry.name)
        return entry.value;
    return std::nullopt;
  }

  /// Returns the pattern of an entry that takes one of the names.
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
