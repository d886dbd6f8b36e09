// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/material/material.h>

#include <algorithm>

namespace lamella
{
  namespace
  {
    struct LibraryMaterial
    {
      std::string name;
      /// In Pa and kg/m^3, but for one.
      Material material;
      bool     in_pascals = true;
    };



    /// A transversely isotropic ply by five constants [GPa].
    EngineeringConstants
    ply_constants(const double E1,
                  const double E2,
                  const double G12,
                  const double nu12,
                  const double nu23)
    {
      const double G23 = 0.5 * E2 / (1. + nu23);
      return {E1 * 1e9,
              E2 * 1e9,
              E2 * 1e9,
              G12 * 1e9,
              G12 * 1e9,
              G23 * 1e9,
              nu12,
              nu12,
              nu23};
    }



    /// Of such a ply by five strengths [MPa]. No test gives S23: it is that of
    /// a fracture plane at 53 degrees (Davila and Camanho, NASA/TM-2003-212663,
    /// LaRC03), Yc cos a (sin a + cos a / tan 2 a).
    Strengths
    ply_strengths(const double Xt,
                  const double Xc,
                  const double Yt,
                  const double Yc,
                  const double S)
    {
      constexpr double of_Yc = 0.37678;
      return {Xt * 1e6,
              Xc * 1e6,
              Yt * 1e6,
              Yc * 1e6,
              Yt * 1e6,
              Yc * 1e6,
              S * 1e6,
              S * 1e6,
              of_Yc * Yc * 1e6};
    }



    /// The paper's Tables 3 and 7, its core and its half-cylinders. Strengths:
    /// Camanho, Maimi and Davila, Compos. Sci. Technol. 67 (2007) 2715-2727.
    void
    add_paper_materials(std::vector<LibraryMaterial> &all)
    {
      Material carbon(EngineeringConstants{
        165e9, 9e9, 9e9, 5.6e9, 5.6e9, 2.8e9, 0.34, 0.34, 0.5});
      carbon.strengths = Strengths{2326.2e6,
                                   1200.1e6,
                                   62.3e6,
                                   199.8e6,
                                   62.3e6,
                                   199.8e6,
                                   92.3e6,
                                   92.3e6,
                                   75.3e6};
      all.push_back({"IM7-8552", carbon});
      all.push_back(
        {"glass-polyester",
         EngineeringConstants{
           25.8e9, 8.7e9, 8.7e9, 3.5e9, 3.5e9, 2.4e9, 0.34, 0.34, 0.47}});
      all.push_back({"foam-35", EngineeringConstants::isotropic(35e6, 0.4)});
      all.push_back(
        {"hertz-200", EngineeringConstants::isotropic(200., 0.3), false});
    }



    /// AS4-3501-6, E-glass-epoxy (MY750/HY917/DY063): P. D. Soden, M. J.
    /// Hinton, A. S. Kaddour, Compos. Sci. Technol. 58 (1998) 1011-1022.
    /// T300-5208: S. W. Tsai, H. T. Hahn, Introduction to Composite Materials
    /// (1980); its nu23, 0.4, is that of the former's carbon plies.
    void
    add_plies(std::vector<LibraryMaterial> &all)
    {
      Material T300(ply_constants(181., 10.3, 7.17, 0.28, 0.4));
      T300.strengths = ply_strengths(1500., 1500., 40., 246., 68.);
      T300.density   = 1600.;
      T300.expansion = dealii::Point<3>(0.02e-6, 22.5e-6, 22.5e-6);
      all.push_back({"T300-5208", T300});

      Material AS4(ply_constants(126., 11., 6.6, 0.28, 0.4));
      AS4.strengths = ply_strengths(1950., 1480., 48., 200., 79.);
      AS4.expansion = dealii::Point<3>(-1e-6, 26e-6, 26e-6);
      all.push_back({"AS4-3501-6", AS4});

      Material glass(ply_constants(45.6, 16.2, 5.83, 0.278, 0.4));
      glass.strengths = ply_strengths(1280., 800., 40., 145., 73.);
      glass.expansion = dealii::Point<3>(8.6e-6, 26.4e-6, 26.4e-6);
      all.push_back({"E-glass-epoxy", glass});
    }



    /// Fabric of AS4 (five-harness satin AGP370-5H/3501-6S), 1 along the warp:
    /// I. M. Daniel, O. Ishai, Engineering Mechanics of Composite Materials,
    /// 2nd ed. (2006), Table A.5, in plane; typical values out of plane.
    void
    add_fabric(std::vector<LibraryMaterial> &all)
    {
      Material oriented_material(EngineeringConstants{
        77e9, 75e9, 13.8e9, 6.5e9, 5.1e9, 4.1e9, 0.06, 0.5, 0.37});
      oriented_material.strengths =
        Strengths{963e6, 900e6, 856e6, 900e6, 60e6, 813e6, 71e6, 75e6, 65e6};
      oriented_material.density = 1600.;
      all.push_back({"woven-carbon-epoxy", oriented_material});
    }



    /// 7075-T6: Aluminum Association, Aluminum Standards and Data (typical).
    /// Steel: EN 1993-1-1:2005, 3.2.6, Table 3.1 (to 40 mm), EN 1991-1-1.
    void
    add_metals(std::vector<LibraryMaterial> &all)
    {
      const auto add = [&all](const char  *name,
                              const double E,
                              const double nu,
                              const double yield,
                              const double density,
                              const double expansion) {
        Material metal(EngineeringConstants::isotropic(E, nu));
        metal.yield     = yield;
        metal.density   = density;
        metal.expansion = dealii::Point<3>(expansion, expansion, expansion);
        all.push_back({name, metal});
      };
      add("7075-T6", 71.7e9, 0.33, 503e6, 2810., 23.6e-6);
      add("steel-S355", 210e9, 0.3, 355e6, 7850., 12e-6);
    }



    /// Rohacell-71-WF: Evonik's data sheet of ROHACELL WF (E 105 MPa and G 42
    /// MPa make nu 0.25). Nomex-48: Hexcel, Honeycomb Sandwich Design
    /// Technology, HRH-10, 48 kg/m^3, 3 mm cells, hexagonal, typical values; 1
    /// along the ribbon. What the sheet does not have, since a honeycomb has
    /// next to nothing of it, is a hundredth of E3 here, and zero.
    void
    add_cores(std::vector<LibraryMaterial> &all)
    {
      Material foam(EngineeringConstants::isotropic(105e6, 0.25));
      foam.core    = CoreStrengths{1.7e6, 1.3e6, 1.3e6};
      foam.density = 75.;
      all.push_back({"Rohacell-71-WF", foam});

      Material comb(EngineeringConstants{
        1.38e6, 1.38e6, 138e6, 1.38e6, 40e6, 25e6, 0., 0., 0.});
      comb.core    = CoreStrengths{2.4e6, 1.25e6, 0.73e6};
      comb.density = 48.;
      all.push_back({"Nomex-48", comb});
    }



    const std::vector<LibraryMaterial> &
    materials()
    {
      static const std::vector<LibraryMaterial> all = [] {
        std::vector<LibraryMaterial> some;
        add_paper_materials(some);
        add_plies(some);
        add_fabric(some);
        add_metals(some);
        add_cores(some);
        return some;
      }();
      return all;
    }



    /// @p material, which is in Pa and kg/m^3, in those of @p units.
    Material
    converted(Material material, const Units &units)
    {
      const auto scale = [&units](const std::vector<double *> &stresses) {
        for (double *stress : stresses)
          *stress *= units.pascal;
      };
      EngineeringConstants &c = material.elastic;
      scale({&c.E1, &c.E2, &c.E3, &c.G12, &c.G13, &c.G23});
      if (material.strengths)
        {
          Strengths &s = *material.strengths;
          scale(
            {&s.Xt, &s.Xc, &s.Yt, &s.Yc, &s.Zt, &s.Zc, &s.S12, &s.S13, &s.S23});
        }
      if (material.yield)
        scale({&*material.yield});
      if (material.core)
        scale({&material.core->crushing,
               &material.core->shear_13,
               &material.core->shear_23});
      // A stress is a force over length^2, a density one over length^4.
      if (material.density)
        *material.density *= units.pascal * units.pascal;
      return material;
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
      entry.refuse(
        "material.unknown-material: there is no such built-in material",
        "Check the spelling: the most similar name is '" +
          nearest_name(entry.text(), library_materials()) +
          "'; the built-in materials are " + joined(library_materials()) + ".");
    return found->in_pascals ? converted(found->material, units) :
                               found->material;
  }
} // namespace lamella
