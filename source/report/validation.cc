// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/report/validation.h>
#include <lamella/section/properties.h>

#include <iomanip>
#include <ostream>

namespace lamella
{
  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width)
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
    for (const auto &[letter, matrix] : {std::make_pair("A", &stiffness.A),
                                         std::make_pair("B", &stiffness.B),
                                         std::make_pair("D", &stiffness.D)})
      for (unsigned int r = 0; r < 3; ++r)
        {
          out << "  " << (r == 0 ? letter : " ");
          for (unsigned int c = 0; c < 3; ++c)
            out << std::setw(14) << (*matrix)[r][c];
          out << "\n";
        }
    out << "  EA " << stiffness.EA << ", EI " << stiffness.EI << ", GA "
        << stiffness.GA
        << "\n  (EA, EI: free to contract and twist; GA: int G_yz dA, no shear "
           "factor)\n\n";
  }



  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section)
  {
    const SectionProperties p = section_properties(section);
    // Of a symmetric section rounding is left of the mixed moment.
    const double mixed =
      std::abs(p.second_moments[0][1]) < 1e-12 * trace(p.second_moments) ?
        0. :
        p.second_moments[0][1];
    const auto rounded = [&p](const double x) {
      return std::abs(x) < 1e-12 * p.low.distance(p.high) ? 0. : x;
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
          << section.plies[i].angle << " deg, area " << p.ply_areas[i] << "\n";
    out << "\n";
  }



  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts)
  {
    for (const auto &body : structure.bodies())
      out << "Body " << body->name() << ": " << body->theory() << ", "
          << body->n_dofs() << " DoFs\n";
    out << structure.n_dofs() << " DoFs in all\n";
    for (const ContactInterface &contact : contacts)
      out << "Contact " << contact.name << ": " << contact.rows.size()
          << " pairs that may touch"
          << (contact.unpaired == 0 ? "" :
                                      ", " + std::to_string(contact.unpaired) +
                                        " nodes of First that face none")
          << "\n";
    out << std::flush;
  }
} // namespace lamella
