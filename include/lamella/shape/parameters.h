// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_parameters_h
#define lamella_shape_parameters_h

#include <lamella/base/entry.h>
#include <lamella/shape/shapes.h>

#include <string>
#include <vector>

namespace lamella
{
  /// The entries of a `subsection Section NAME`, in common for all shapes.
  struct SectionParameters
  {
    /// Upper limit of `Cells divided`.
    static constexpr unsigned int max_divisions = 4;
    /// Upper limit of `Corner layers`.
    static constexpr unsigned int max_corner_layers = 6;

    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the section in @p in, lengths in the scene's unit. @p materials
    /// are the scene's names; if there is only one, sections need not name it.
    /// The path of a mesh file is relative to @p folder; the file is not read.
    /// Throws InputError, also for entries of other shapes and for more than
    /// about 50,000 cells, or 10,000 in a mesh line.
    static SectionShape
    parse(const Entries                  &in,
          const std::vector<std::string> &materials,
          const std::string              &folder);
  };
} // namespace lamella

#endif
