// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/material/library.h>

#include <algorithm>

namespace lamella
{
  namespace
  {
    struct LibraryMaterial
    {
      std::string          name;
      EngineeringConstants constants;
      bool                 in_pascals;
      /// Only where a source is known (doc/strength.md).
      std::optional<Strengths> strengths = {};
    };

    const std::vector<LibraryMaterial> &
    materials()
    {
      static const std::vector<LibraryMaterial> all{
        {"IM7-8552",
         {165e9, 9e9, 9e9, 5.6e9, 5.6e9, 2.8e9, 0.34, 0.34, 0.5},
         true,
         Strengths{2326.2e6,
                   1200.1e6,
                   62.3e6,
                   199.8e6,
                   62.3e6,
                   199.8e6,
                   92.3e6,
                   92.3e6,
                   75.3e6}},
        {"glass-polyester",
         {25.8e9, 8.7e9, 8.7e9, 3.5e9, 3.5e9, 2.4e9, 0.34, 0.34, 0.47},
         true},
        {"foam-35", EngineeringConstants::isotropic(35e6, 0.4), true},
        {"hertz-200", EngineeringConstants::isotropic(200., 0.3), false}};
      return all;
    }
  } // namespace



  std::vector<std::string>
  library_materials()
  {
    std::vector<std::string> names;
    for (const LibraryMaterial &material : materials())
      names.push_back(material.name);
    return names;
  }



  Material
  library_material(const std::string &name, const Units &units)
  {
    return library_material(Entry("Library", name), units);
  }



  Material
  library_material(const Entry &entry, const Units &units)
  {
    const auto found =
      std::find_if(materials().begin(),
                   materials().end(),
                   [&entry](const auto &m) { return m.name == entry.text(); });
    if (found == materials().end())
      entry.refuse("no such built-in material",
                   "The nearest is '" +
                     nearest_name(entry.text(), library_materials()) +
                     "'; all of them: " + joined(library_materials()) + ".");
    Material material(found->constants);
    material.strengths = found->strengths;
    if (found->in_pascals)
      {
        EngineeringConstants &c = material.elastic;
        for (double *modulus : {&c.E1, &c.E2, &c.E3, &c.G12, &c.G13, &c.G23})
          *modulus *= units.pascal;
      }
    if (found->in_pascals && material.strengths)
      {
        Strengths &s = *material.strengths;
        for (double *strength :
             {&s.Xt, &s.Xc, &s.Yt, &s.Yc, &s.Zt, &s.Zc, &s.S12, &s.S13, &s.S23})
          *strength *= units.pascal;
      }
    return material;
  }
} // namespace lamella
