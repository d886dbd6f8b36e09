// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/version.h>
#include <lamella/material/material.h>
#include <lamella/report/page.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace lamella
{
  namespace
  {
    /// The constants of @p material as the scene writes them.
    nlohmann::json
    constants_of(const Material &material)
    {
      const EngineeringConstants &e = material.elastic;
      nlohmann::json              constants;
      constants["elastic"] = {
        e.E1, e.E2, e.E3, e.G12, e.G13, e.G23, e.nu12, e.nu13, e.nu23};
      if (material.strengths)
        {
          const Strengths &s     = *material.strengths;
          constants["strengths"] = {
            s.Xt, s.Xc, s.Yt, s.Yc, s.Zt, s.Zc, s.S12, s.S13, s.S23};
        }
      return constants;
    }



    /// What the page says that no folder has.
    std::string
    program_data()
    {
      nlohmann::json known;
      known["version"] = version();
      for (const auto &[unit, pascal] :
           {std::pair("Pa", 1.), std::pair("MPa", 1e-6)})
        for (const std::string &name : library_materials())
          {
            Units units;
            units.pascal = pascal;
            known["materials"][unit][name] =
              constants_of(library_material(name, units));
          }
      return known.dump();
    }
  } // namespace



  void
  make_page(const std::string &folder, const std::string &target)
  {
    const std::string python = python_with("jinja2");
    if (python.empty())
      throw InputError(
        "report.no-jinja2: the report needs python3 with Jinja2, which was not "
        "found. Install the package python3-jinja2, as scripts/setup does.");
    // Names of files are UTF-8 whatever the user's language is.
    exec_program(python,
                 {"-X",
                  "utf8",
                  path_of_script("report.py"),
                  folder,
                  "--output=" + target,
                  "--program=" + program_data()});
  }
} // namespace lamella
