// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_validation_h
#define lamella_report_validation_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/material/material.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/structure.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Prints elastic constants, strengths, density and thermal expansion of the
  /// material @p name, with labels of @p units.
  void
  print_material(std::ostream      &out,
                 const std::string &name,
                 const Material    &material,
                 const Units       &units);

  /// Prints for the laminated section @p name with the mesh @p section, the @p
  /// plies (from the bottom, at least one) and the width @p width:
  /// - plies; matrices A, B, D of classical lamination theory about the
  ///   mid-plane (rows yy, xx, xy with y along the beam);
  /// - stiffnesses E A and E I with free lateral contraction and twist;
  /// - G A, k G A (from equilibrium of plies); G J (torsion, from the mesh).
  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width,
                 const SectionMesh      &section,
                 const Units            &units);

  /// Prints the section @p name of the kind @p shape: cells, extents, area,
  /// centroid, second moments of area, lengths of boundaries, areas of
  /// materials, and G J (Saint-Venant) if available; labels by @p units.
  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section,
                const Units       &units);

  /// Prints the beam properties of the section @p name: E A, principal E I, G
  /// J, k G A, tension center, shear center, the 6 x 6 stiffness and, if known,
  /// the mass; or the reason why they could not be computed.
  void
  print_stiffness(std::ostream           &out,
                  const std::string      &name,
                  const SectionStiffness &section,
                  const Units            &units);

  /// Prints theory and DoFs of each body, the resultant of each load at load
  /// factor 1, and the numbers of paired and unpaired nodes of each contact.
  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts,
               const Units                         &units);
} // namespace lamella

#endif
