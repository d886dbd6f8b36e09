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
  /// Writes the bodies of @p structure, deformed by @p u, to NAME_STEP.vtu in
  /// @p directory for ParaView and returns the name of the file. NAME is
  /// `solution` for load steps. Each
  /// section cell of each axis element is a Lagrange hexahedron. Strains and
  /// stresses are discontinuous between elements. Cell data are the ply (from 1
  /// at the bottom), the fiber direction and the body (from 1). If @p strength
  /// is not null, the largest inverse reserve factor is written at each point.
  /// @p factor is the time in ParaView.
  ///
  /// Cells have the degrees Body::cells().output_degrees, at most 4. Values are
  /// in single precision. Displacements and positions are rounded to 2^-24 of
  /// the largest value in the file; strains and stresses to 2^-11 of the
  /// largest in the element or 2^-24 of that in the file, whichever is larger.
  ///
  /// With several processes, each process writes NAME_STEP.PROCESS.vtu with
  /// its elements; the name of NAME_STEP.pvtu, which combines these files,
  /// is returned. Throws InputError if a file cannot be written. Collective.
  std::string
  write_vtu(const std::string   &directory,
            const std::string   &name,
            const unsigned int   step,
            const double         factor,
            const Structure     &structure,
            const BlockVector   &u,
            const StrengthSweep *strength = nullptr);

  /// Writes NAME.pvd, a collection of @p files (load step, file name) for
  /// ParaView, to @p directory; nothing if @p files is empty. Throws InputError
  /// on failure. Must be called by one process only.
  void
  write_pvd(const std::string                                 &directory,
            const std::string                                 &name,
            const std::vector<std::pair<double, std::string>> &files);
} // namespace lamella

#endif
