// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/report/validation.h>

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
