// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_validation_h
#define lamella_report_validation_h

#include <lamella/contact/gap_rows.h>
#include <lamella/section/laminate.h>
#include <lamella/solve/structure.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Prints the ply table of a section called @p name, the laminate's A, B, D
  /// and the section's EA, EI, GA.
  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width);

  /// Prints what the section @p name of the kind @p shape amounts to: cells,
  /// extension, area, second moments, boundaries with their lengths, materials
  /// with their areas.
  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section);

  /// Prints a line a body and a line a contact.
  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
