// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_validation_h
#define lamella_report_validation_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/material/material.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/shape/laminate.h>
#include <lamella/solve/structure.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Prints what is known of the material @p name, of the library or typed:
  /// elastic constants, strengths, yield stress, core strengths, density,
  /// expansion; @p units label the stresses.
  void
  print_material(std::ostream      &out,
                 const std::string &name,
                 const Material    &material,
                 const Units       &units);

  /**
   * Prints the ply table of a section called @p name, the laminate's A, B, D
   * and the section's EA, EI, GA, k G A and, by @p section, its G J: what a
   * hand calculation of the beam begins with. A, B, D are those of classical
   * lamination theory about the mid-plane, in the order yy, xx, xy with y along
   * the beam (force / length, force, force length); EA, EI are of the laminate
   * free to contract and twist, k G A comes from the equilibrium of the plies.
   * @p plies are from the bottom, at least one; @p width is the section's.
   * Entries of A, B, D that are rounding are printed as zero.
   */
  void
  print_laminate(std::ostream           &out,
                 const std::string      &name,
                 const std::vector<Ply> &plies,
                 const double            width,
                 const SectionMesh      &section,
                 const Units            &units);

  /// Prints what the section @p name of the kind @p shape (its name) amounts
  /// to: cells, extension, area, centroid, second moments about it, boundaries
  /// with their lengths, parts with their materials and areas, and G J by
  /// Saint-Venant's torsion where that is known. @p units label it.
  void
  print_section(std::ostream      &out,
                const std::string &name,
                const std::string &shape,
                const SectionMesh &section,
                const Units       &units);

  /// Prints what the section @p name is to a program of beams: E A, principal
  /// E I, G J, k G A, tension and shear centre, the 6 x 6 stiffness and, where
  /// it is known, mass; or in words why there is none. Numbers of points in the
  /// section's coordinates; @p units label all.
  void
  print_stiffness(std::ostream           &out,
                  const std::string      &name,
                  const SectionStiffness &section,
                  const Units            &units);

  /// Prints a line a body (theory, DoFs), a load (what it is in all at load
  /// factor 1) and a contact (pairs that may touch, nodes without a partner).
  void
  print_bodies(std::ostream                        &out,
               const Structure                     &structure,
               const std::vector<ContactInterface> &contacts,
               const Units                         &units);
} // namespace lamella

#endif
