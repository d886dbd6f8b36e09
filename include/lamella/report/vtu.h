// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_vtu_h
#define lamella_report_vtu_h

#include <lamella/recover/strength_sweep.h>
#include <lamella/solve/structure.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * Writes the deformed bodies for ParaView into @p directory as
   * solution_STEP.vtu: a higher-order hexahedron for each section cell of each
   * axis element, positions displaced by u (so do not warp again; subtract
   * `displacement` for the undeformed scene), strains and stresses
   * discontinuous between elements and so per ply; for each cell the ply's
   * number (from 1 at the bottom), the fibre direction, the body's number (from
   * 1). Returns the file's name without the folder. With @p strength, which may
   * be null, comes the largest 1/R of each point by the elements' own stresses
   * (StrengthSweep::inverse_reserve()). @p factor is the time and @p step the
   * cycle that ParaView shows.
   *
   * Cells are of Body::picture_degrees(), 4 at most along each coordinate.
   * Values are pictures, not numbers: single precision, displacements and
   * positions rounded to 2^-24 of what is largest in the file, each component
   * of strains and stresses to 2^-11 of its largest in the element, or 2^-24 of
   * the largest component in the file if that is more.
   *
   * Several processes write solution_STEP.PROCESS.vtu each, of their elements,
   * and solution_STEP.pvtu for all of them, whose name is returned: all call
   * this. Throws InputError, on all, if one cannot write.
   */
  std::string
  write_vtu(const std::string   &directory,
            const unsigned int   step,
            const double         factor,
            const Structure     &structure,
            const BlockVector   &u,
            const StrengthSweep *strength = nullptr);

  /// Writes @p name.pvd into @p directory, the collection of (load step, file)
  /// for ParaView, if there are @p files; one of the same name is replaced.
  /// Throws InputError if it cannot. One process calls it.
  void
  write_pvd(const std::string                                 &directory,
            const std::string                                 &name,
            const std::vector<std::pair<double, std::string>> &files);
} // namespace lamella

#endif
