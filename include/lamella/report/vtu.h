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
   * solution_STEP.vtu and returns the file's name without the folder. Each
   * section cell of each axis element is a higher-order hexahedron at positions
   * displaced by u. Strains and stresses are discontinuous between elements and
   * plies. Cells have the number of the ply (from 1 at the bottom), the fiber
   * direction and the number of the body (from 1). @p strength, which may be
   * null, adds the largest 1/R of each point
   * (StrengthSweep::inverse_reserve()). ParaView shows @p factor as the time
   * and @p step as the cycle.
   *
   * Cells have the degrees Body::output_degrees(), at most 4. Values are in
   * single precision: displacements and positions are rounded to 2^-24 of the
   * largest in the file, strains and stresses to 2^-11 of their largest in the
   * element, or 2^-24 of the largest in the file if that is more.
   *
   * Several processes write solution_STEP.PROCESS.vtu for their elements each,
   * and solution_STEP.pvtu for all of them, whose name is returned. Collective.
   * Throws InputError, on all processes, if one cannot write.
   */
  std::string
  write_vtu(const std::string   &directory,
            const unsigned int   step,
            const double         factor,
            const Structure     &structure,
            const BlockVector   &u,
            const StrengthSweep *strength = nullptr);

  /// Writes @p name.pvd into @p directory, a collection of (load step, file)
  /// for ParaView, if there are @p files. Throws InputError on failure. Called
  /// by one process.
  void
  write_pvd(const std::string                                 &directory,
            const std::string                                 &name,
            const std::vector<std::pair<double, std::string>> &files);
} // namespace lamella

#endif
