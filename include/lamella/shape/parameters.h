// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_parameters_h
#define lamella_shape_parameters_h

#include <lamella/base/entry.h>
#include <lamella/shape/shapes.h>

#include <string>
#include <vector>

namespace lamella
{
  /// The entries of a `subsection Section NAME`. All shapes declare their
  /// entries in one subsection; a table in the .cc file says which shape has
  /// which.
  struct SectionParameters
  {
    /// `Cells divided` at most.
    static constexpr unsigned int most_divisions = 4;
    /// `Corner layers` at most.
    static constexpr unsigned int most_corner_layers = 6;

    /// Declares them in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /**
     * The section that the entries @p in describe, lengths in the scene's unit,
     * its materials among @p materials; the path of a mesh file is relative to
     * @p folder, and the file is not read. Throws InputError, also for entries
     * that are given but are none of the section's shape, and for more cells
     * than a section can have. A section may have about 50,000 cells, a line of
     * its mesh 10,000: a slip of a digit must not end in a machine out of
     * memory. @p materials are the names in the scene; where there is one only,
     * sections need not name it.
     */
    static SectionShape
    parse(const Entries                  &in,
          const std::vector<std::string> &materials,
          const std::string              &folder);
  };
} // namespace lamella

#endif
