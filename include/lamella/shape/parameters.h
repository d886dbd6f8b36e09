// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_parameters_h
#define lamella_shape_parameters_h

#include <lamella/shape/shapes.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// The entries of a `subsection Section NAME`.
  struct SectionParameters
  {
    /// Name of an entry -> its text; an entry that is not here has its default.
    std::map<std::string, std::string> entries;

    static void
    declare(dealii::ParameterHandler &prm);

    static SectionParameters
    parse(const dealii::ParameterHandler &prm);

    /**
     * The section that the entries describe, its materials among @p materials;
     * the path of a mesh file is relative to @p folder. Throws InputError,
     * beginning with @p what (`Section NAME`), also for entries that are given
     * but are none of the section's shape.
     */
    SectionShape
    shape(const std::vector<std::string> &materials,
          const std::string              &folder,
          const std::string              &what) const;
  };
} // namespace lamella

#endif
