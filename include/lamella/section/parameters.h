// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_parameters_h
#define lamella_section_parameters_h

#include <lamella/section/laminate.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /// The entries of a `subsection Section NAME`.
  struct SectionParameters
  {
    std::string shape, width, layup, ply_thickness, ply_materials;
    std::string cells_per_ply, cells_across;

    static void
    declare(dealii::ParameterHandler &prm);

    static SectionParameters
    parse(const dealii::ParameterHandler &prm);

    /// The laminate that the entries describe, its materials among
    /// @p materials. Throws InputError, beginning with @p what (`Section
    /// NAME`).
    Laminate
    laminate(const std::vector<std::string> &materials,
             const std::string              &what) const;
  };
} // namespace lamella

#endif
