// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_validation_h
#define lamella_report_validation_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/material/material.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/shape/laminate.h>
#include <lamella/solve/structure.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Prints the data of the material @p name: elastic constants, strengths,
  /// density, expansion; stresses with labels of @p units.
  void
  print_material(std::ostream      &out,
                 const std::string &name,
                 const Material    &material,
                 const Units       &units);

  /// Prints the ply table of the section @p name, the laminate's A, B, D, EA
  /// and EI (free to contract and twist), GA, k G A from the equilibrium of the
  /// plies and, by @p section, G J. A, B, D are those of classical lamination
  /// theory about the mid-plane, in the order yy, xx, xy with y along the beam.
  /// @p plies are from the bottom, at least one; @p width is the section's;
  /// labels are from @p units.
  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width,
                 const SectionMesh      &section,
                 const Units            &units);

  /// Prints the section @p name of the kind @p shape: cells, extents, area,
  /// centroid, second moments, boundaries with lengths, parts with materials
  /// and areas, and G J by Saint-Venant's torsion if known; labels by @p units.
  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section,
                const Units       &units);

  /// Prints the beam properties of the section @p name: E A, principal E I, G
  /// J, k G A, tension and shear center, the 6 x 6 stiffness and, if known, the
  /// mass; or the reason for their absence. Labels are from @p units.
  void
  print_stiffness(std::ostream           &out,
                  const std::string      &name,
                  const SectionStiffness &section,
                  const Units            &units);

  /// Prints a line per body (theory, DoFs), load (sum at load factor 1) and
  /// contact (possible pairs, unpaired nodes).
  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts,
               const Units                         &units);
} // namespace lamella

#endif
