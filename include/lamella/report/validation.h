// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_validation_h
#define lamella_report_validation_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/shape/laminate.h>
#include <lamella/solve/structure.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Prints the ply table of a section called @p name, the laminate's A, B, D
  /// and the section's EA, EI, GA, k G A and, by @p section, its G J.
  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width,
                 const SectionMesh      &section,
                 const Units            &units);

  /// Prints what the section @p name of the kind @p shape amounts to: cells,
  /// extension, area, second moments, boundaries with their lengths, materials
  /// with their areas, G J.
  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section,
                const Units       &units);

  /// Prints a line a body, a load (what it is in all) and a contact.
  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts,
               const Units                         &units);
} // namespace lamella

#endif
