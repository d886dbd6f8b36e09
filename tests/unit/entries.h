// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_entries_h
#define lamella_tests_unit_entries_h

#include <lamella/base/patterns.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Names of entries and what they are set to; the last one of a name counts.
  using Settings = std::vector<std::pair<std::string, std::string>>;

  /**
   * What @p Parameters reads from its subsection @p path with these @p settings
   * and the further arguments @p context. Throws InputError as the reader of a
   * scene does, also for a value that does not match the pattern of its entry.
   */
  template <typename Parameters, typename... Context>
  auto
  parsed(const std::string &path,
         const Settings    &settings,
         const Context &...context)
  {
    dealii::ParameterHandler prm;
    for (const std::string &part : split(path, '/'))
      prm.enter_subsection(part);
    Parameters::declare(prm);
    for (const auto &[name, value] : settings)
      try
        {
          prm.set(name, value);
        }
      catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          patterns::refuse(Entry(path + "/" + name, value), prm);
        }
    return Parameters::parse(Entries(prm, path), context...);
  }
} // namespace lamella

#endif
