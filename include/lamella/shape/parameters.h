// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_parameters_h
#define lamella_shape_parameters_h

#include <lamella/base/entry.h>
#include <lamella/shape/shapes.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Declares and parses the `subsection Section NAME` of a parameter file.
  struct SectionParameters
  {
    /// Largest value of the entry `Cells divided`.
    static constexpr unsigned int max_divisions = 4;
    /// Largest value of the entry `Corner layers`.
    static constexpr unsigned int max_corner_layers = 6;

    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the section described by the entries @p in. @p materials are the
    /// names of all materials; a single one is the default. The path of a mesh
    /// file is relative to @p folder; the file is not read. Throws InputError
    /// for invalid entries, entries that only other shapes have, more than
    /// about 50,000 cells, and more than 10,000 cells in one direction.
    static SectionShape
    parse(const Entries                  &in,
          const std::vector<std::string> &materials,
          const std::string              &folder);
  };
} // namespace lamella

#endif
