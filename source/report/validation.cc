// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/report/validation.h>
#include <lamella/section/theory_limits.h>
#include <lamella/shape/properties.h>

#include <cmath>
#include <iomanip>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// ` [N mm^2]`: force times length^@p n; empty without units.
    std::string
    unit(const Units &units, const int n)
    {
      if (units.force.empty())
        return "";
      return " [" + units.force +
             (n < 0 ? "/" :
              n > 0 ? " " :
                      "") +
             (n == 0 ? "" : units.length) +
             (std::abs(n) < 2 ? "" : "^" + std::to_string(std::abs(n))) + "]";
    }



    /// Prints G J, if it is known.
    void
    print_torsion(std::ostream      &out,
                  const SectionMesh &section,
                  const Units       &units)
    {
      if (const auto GJ = torsional_stiffness(section))
        out << "  GJ " << *GJ << unit(units, 2)
            << " (Saint-Venant's torsion, LE-2 on this mesh)\n";
    }



    /// ` in the wall 'left', normal (-1, 0)`; empty for level plies in no wall.
    std::string
    in_words(const PlyPlane &plane)
    {
      const bool  level = !plane.normal_at && plane.normal[1] == 1.;
      std::string words =
        plane.wall.empty() ? "" : " in the wall '" + plane.wall + "'";
      if (plane.normal_at)
        words += ", normal as that of the wall";
      else if (!level || !plane.wall.empty())
        words += ", normal " + to_text(dealii::Point<2>(plane.normal));
      return words;
    }



    /// @p m below the names of its columns, behind those of its rows.
    void
    print_matrix(std::ostream &out, const SectionTensor &m)
    {
      out << "     ";
      for (const char *column : section_force_names)
        out << std::setw(14) << column;
      for (unsigned int i = 0; i < 6; ++i)
        {
          out << "\n  " << section_force_names[i];
          for (unsigned int j = 0; j < 6; ++j)
            out << std::setw(14) << m[i][j];
        }
      out << "\n";
    }



    /// `Xt 2326.2, Xc 1200.1`.
    std::string
    listed(const std::vector<std::pair<const char *, double>> &numbers)
    {
      std::vector<std::string> words;
      for (const auto &[name, number] : numbers)
        words.push_back(std::string(name) + " " + to_text(number));
      return joined(words);
    }



    std::string
    listed(const EngineeringConstants &c)
    {
      return listed({{"E1", c.E1},
                     {"E2", c.E2},
                     {"E3", c.E3},
                     {"G12", c.G12},
                     {"G13", c.G13},
                     {"G23", c.G23},
                     {"nu12", c.nu12},
                     {"nu13", c.nu13},
                     {"nu23", c.nu23}});
    }



    std::string
    listed(const Strengths &s)
    {
      return listed({{"Xt", s.Xt},
                     {"Xc", s.Xc},
                     {"Yt", s.Yt},
                     {"Yc", s.Yc},
                     {"Zt", s.Zt},
                     {"Zc", s.Zc},
                     {"S12", s.S12},
                     {"S13", s.S13},
                     {"S23", s.S23}});
    }



    /// A, B and D of a laminate of the height @p h.
    void
    print_matrices(std::ostream            &out,
                   const LaminateStiffness &stiffness,
                   const double             h,
                   const Units             &units)
    {
      // What is left of sums that cancel, over what they are made of.
      const double A = stiffness.A.norm();
      struct Part
      {
        const char                 *letter;
        const dealii::Tensor<2, 3> *matrix;
        double                      scale;
        int                         lengths;
      };
      for (const Part &part : {Part{"A", &stiffness.A, A, -1},
                               Part{"B", &stiffness.B, A * h, 0},
                               Part{"D", &stiffness.D, A * h * h, 1}})
        for (unsigned int r = 0; r < 3; ++r)
          {
            out << "  " << (r == 0 ? part.letter : " ");
            for (unsigned int c = 0; c < 3; ++c)
              {
                const double value = (*part.matrix)[r][c];
                out << std::setw(14)
                    << (std::abs(value) <
                            arithmetic::rounding_of_sums * part.scale ?
                          0. :
                          value);
              }
            out << (r == 0 ? unit(units, part.lengths) : "") << "\n";
          }
    }



    /// What @p load is in all, in a scene of the size @p size; of a
    /// temperature, which has no resultant, that it is one.
    void
    print_load(std::ostream        &out,
               const LoadResultant &load,
               const double         size,
               const Units         &units)
    {
      // What is left of a force whose tractions cancel.
      const dealii::Tensor<1, 3> resultant =
        load.force.norm() * size <
            arithmetic::rounding_of_results * load.moment.norm() ?
          dealii::Tensor<1, 3>() :
          load.force;

      out << "Load " << load.name << ": ";
      if (load.is_temperature)
        {
          out << "a temperature, which has no resultant\n";
          return;
        }
      const std::string force = units.force.empty() ? "" : " " + units.force;
      out << "resultant " << to_text(resultant) << force << " in all, moment "
          << to_text(load.moment) << force
          << (units.length.empty() ? "" : " " + units.length)
          << " about the origin\n";
    }
  } // namespace



  void
  print_material(std::ostream      &out,
                 const std::string &name,
                 const Material    &material,
                 const Units       &units)
  {
    out << "Material " << name
        << (units.stress.empty() ? "" : " [" + units.stress + "]") << ": "
        << listed(material.elastic) << "\n";
    if (material.strengths)
      out << "  strengths " << listed(*material.strengths) << "\n";
    if (material.ultimate_strains)
      out << "  ultimate strains " << listed(*material.ultimate_strains)
          << "\n";
    if (material.yield)
      out << "  yield " << to_text(*material.yield) << "\n";
    if (const auto &core = material.core)
      out << "  core: "
          << listed({{"crushing", core->crushing},
                     {"shear 13", core->shear_13},
                     {"shear 23", core->shear_23}})
          << "\n";
    if (material.density)
      out << "  density " << to_text(*material.density)
          << (units.length == "m"  ? " kg/m^3" :
              units.length == "mm" ? " t/mm^3" :
                                     "")
          << "\n";
    if (const auto &alpha = material.expansion)
      out << "  expansion " << to_text((*alpha)[0]) << ", "
          << to_text((*alpha)[1]) << ", " << to_text((*alpha)[2]) << " per K\n";
  }



  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width,
                 const SectionMesh      &section,
                 const Units            &units)
  {
    out << "\nSection " << name << ": " << width << " x " << plies.back().top
        << ", plies from the bottom:\n";
    for (unsigned int i = 0; i < plies.size(); ++i)
      out << "  " << std::setw(3) << i + 1 << "  " << std::setw(6)
          << plies[i].angle << " deg  z " << std::setw(10) << plies[i].bottom
          << " to " << std::setw(10) << plies[i].top << "  "
          << plies[i].material << "\n";

    const LaminateStiffness stiffness = laminate_stiffness(plies, width);
    out
      << "  Classical lamination theory about the mid-plane, order yy, xx, xy "
         "(y along the beam):\n";
    print_matrices(out, stiffness, plies.back().top, units);
    out << "  EA " << stiffness.EA << unit(units, 0) << ", EI " << stiffness.EI
        << unit(units, 2) << ", GA " << stiffness.GA << unit(units, 0)
        << ", kGA " << shear_stiffness(plies, width) << unit(units, 0)
        << "\n  (EA, EI: free to contract and twist; GA: int G_yz dA, no shear "
           "factor; kGA: from the\n  equilibrium of the plies)\n";
    print_torsion(out, section, units);
    out << "\n";
  }



  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section,
                const Units       &units)
  {
    const SectionProperties p = section_properties(section);
    // Of a symmetric section rounding is left of the mixed moment.
    const double mixed =
      std::abs(p.second_moments[0][1]) <
          arithmetic::rounding_of_results * trace(p.second_moments) ?
        0. :
        p.second_moments[0][1];
    const auto rounded = [&p](const double x) {
      return std::abs(x) <
                 arithmetic::rounding_of_results * p.low.distance(p.high) ?
               0. :
               x;
    };
    out << "\nSection " << name << ": " << shape << ", "
        << section.mesh.n_active_cells() << " cells, x " << p.low[0] << " to "
        << p.high[0] << ", z " << p.low[1] << " to " << p.high[1] << "\n  area "
        << p.area << ", centroid (" << rounded(p.centroid[0]) << ", "
        << rounded(p.centroid[1]) << ")\n  second moments about it: int z^2 dA "
        << p.second_moments[1][1] << ", int x^2 dA " << p.second_moments[0][0]
        << ", int x z dA " << mixed << "\n  boundaries:";
    for (const auto &[boundary, length] : p.boundary_lengths)
      out << "  " << boundary << " (length " << length << ")";
    out << "\n";
    for (unsigned int i = 0; i < section.plies.size(); ++i)
      out << "  part " << i + 1 << ": " << section.plies[i].material << ", "
          << section.plies[i].angle << " deg"
          << in_words(section.plies[i].plane) << ", area " << p.ply_areas[i]
          << "\n";
    print_torsion(out, section, units);
    out << "\n";
  }



  void
  print_stiffness(std::ostream           &out,
                  const std::string      &name,
                  const SectionStiffness &section,
                  const Units            &units)
  {
    out << "Section " << name << " as a beam, by Saint-Venant's states in "
        << section.expansion << ":\n";
    if (!section.fault.empty())
      {
        out << "  not computed: " << section.fault << "\n\n";
        return;
      }
    const SectionConstants &c = section.constants;
    out << "  EA " << c.EA << unit(units, 0) << ", GJ " << c.GJ
        << unit(units, 2) << ", kGA_x " << c.kGA_x << unit(units, 0)
        << ", kGA_z " << c.kGA_z << unit(units, 0) << "\n  EI_1 " << c.EI[0]
        << unit(units, 2) << " about the axis at " << c.angle
        << " deg from x towards z, EI_2 " << c.EI[1] << unit(units, 2)
        << " about that at right angles\n  tension center "
        << to_text(c.tension_center) << ", shear center "
        << to_text(c.shear_center) << "\n  stiffness about "
        << to_text(section.reference_point) << ": forces" << unit(units, 0)
        << ", couplings of forces and moments" << unit(units, 1) << ", moments"
        << unit(units, 2) << "\n";
    print_matrix(out, section.stiffness);
    if (section.mass)
      {
        out << "  mass per length about the same point, density times length "
               "^2, ^3 and ^4\n";
        print_matrix(out, *section.mass);
      }
    out << "\n";
  }



  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts,
               const Units                         &units)
  {
    for (const auto &body : structure.bodies())
      out << "Body " << body->name() << ": " << body->theory() << ", "
          << body->n_dofs() << " DoFs\n";
    out << structure.n_dofs() << " DoFs in all\n";
    for (const LoadResultant &load : structure.load_resultants())
      print_load(out, load, structure.size(), units);
    for (const ContactInterface &contact : contacts)
      out << "Contact " << contact.name << ": " << contact.rows.size()
          << (contact.is_tied() ? " tied pairs, " : " pairs that may touch, ")
          << name_of(contact.discretization)
          << (contact.unpaired == 0 ? "" :
                                      ", " + std::to_string(contact.unpaired) +
                                        " nodes of First that face none")
          << "\n";
    out << std::flush;
  }
} // namespace lamella
