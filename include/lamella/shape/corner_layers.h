// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_corner_layers_h
#define lamella_shape_corner_layers_h

#include <lamella/shape/section_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Parameters for grading the mesh of a section towards singular corners.
  struct CornerRules
  {
    /// Grading factor: ratio of the distances of successive layers from the
    /// corner. 0.15 is optimal for p-extension (Szabo and Babuska, Finite
    /// Element Analysis, 1991, sec. 10.2).
    double ratio = 0.15;
    /// Interior angle in degrees above which a corner counts as re-entrant.
    /// Corners between the straight edges of a fillet have smaller angles.
    double min_reentrant_angle = 225.;
  };

  /// Returns the indices of the mesh vertices with singular stresses,
  /// ascending: re-entrant corners of the boundary, and points where the
  /// boundary meets the interface between plies of different material or angle.
  std::vector<unsigned int>
  singular_corners(const SectionMesh &section, const CornerRules &rules = {});

  /// Returns the mesh @p section with @p layers geometrically graded layers of
  /// cells around each of its singular_corners(). Each edge that ends at such a
  /// corner is split at distances r^k times its length from it, k = 1 to @p
  /// layers, r = CornerRules::ratio. Opposite edges of a cell are split alike.
  /// Edges must be straight. Throws InputError for the entry `Corner layers` in
  /// the subsection @p what if there are no singular corners or too many cells.
  std::shared_ptr<const SectionMesh>
  graded_to_corners(const SectionMesh &section,
                    const unsigned int layers,
                    const std::string &what,
                    const CornerRules &rules = {});
} // namespace lamella

#endif
