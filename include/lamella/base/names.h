// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_names_h
#define lamella_base_names_h

#include <deal.II/base/patterns.h>

#include <cstddef>
#include <optional>
#include <string>

namespace lamella
{
  /// The name of one value of the enumeration @p E. @p name is a string
  /// literal, so that lists of them are constant expressions.
  template <typename E>
  struct NameOf
  {
    /// The value.
    E value;
    /// What scenes, tables and messages call it.
    const char *name;
  };

  /**
   * How scenes and tables write the values of the enumeration @p E: the one
   * list that reading, writing and the pattern of an entry come from.
   * Specialised beside the enumeration,
   *   template <>
   *   struct Names<Strategy>
   *   {
   *     static constexpr NameOf<Strategy> all[] = {
   *       {Strategy::condensed, "condensed"}, {Strategy::full, "full"}};
   *   };
   * in the order in which a message lists them. A value without a name (say,
   * `undefined`) cannot be written in a scene. There is no general definition:
   * an enumeration without a list does not compile where a name of it is asked
   * for. Two values may not share a name, nor one value have two: the first
   * would win.
   */
  template <typename E>
  struct Names;

  /// What @p value is called; empty if it has no name. A linear search, for
  /// lists of a few words. The second template argument takes this function out
  /// of overload resolution for types without a list.
  template <typename E, std::size_t = sizeof(Names<E>)>
  std::string
  name_of(const E value)
  {
    for (const NameOf<E> &entry : Names<E>::all)
      if (entry.value == value)
        return entry.name;
    return "";
  }

  /// What is called @p name, if anything is. Letters count as they stand:
  /// `Full` is not `full`.
  template <typename E>
  std::optional<E>
  named(const std::string &name)
  {
    for (const NameOf<E> &entry : Names<E>::all)
      if (name == entry.name)
        return entry.value;
    return std::nullopt;
  }

  /// The pattern of an entry that takes one of the names. A value that matches
  /// can be read by named() or Entry::choice() without fail.
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
