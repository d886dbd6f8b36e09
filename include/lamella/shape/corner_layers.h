// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_corner_layers_h
#define lamella_shape_corner_layers_h

#include <lamella/shape/section_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Rules for grading sections towards their corners.
  struct CornerRules
  {
    /// Ratio of the distances of successive layers from the corner. The optimum
    /// for one corner and growing degrees is 0.15 (Szabo and Babuska, Finite
    /// Element Analysis, 1991, sec. 10.2).
    double ratio = 0.15;
    /// Angle above which a corner is re-entrant, in degrees. Fillets meshed by
    /// a few straight edges are below it.
    double min_reentrant_angle = 225.;
  };

  /// Returns the vertices of @p section with singular stresses, ascending:
  /// re-entrant corners of its boundary, and ends of interfaces between plies
  /// of different material or angle at the boundary.
  std::vector<unsigned int>
  singular_corners(const SectionMesh &section, const CornerRules &rules = {});

  /**
   * Returns @p section with @p layers layers of cells at each of its
   * singular_corners(). Every edge that ends there is split at the fractions
   * r^k from the corner, k = 1 to @p layers, r = CornerRules::ratio. Opposite
   * edges of the cells are split alike. Plies and side names are inherited;
   * edges must be straight. Throws InputError, of the entry `Corner layers` of
   * the subsection @p what, if there are no corners or more than
   * max_section_cells result.
   */
  std::shared_ptr<const SectionMesh>
  graded_to_corners(const SectionMesh &section,
                    const unsigned int layers,
                    const std::string &what,
                    const CornerRules &rules = {});
} // namespace lamella

#endif
