// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_corner_layers_h
#define lamella_shape_corner_layers_h

#include <lamella/shape/section_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// How sections are graded towards their corners.
  struct CornerRules
  {
    /// What each layer is of the next one's distance from the corner: between
    /// the 0.15 that is best for one corner with degrees that grow with the
    /// layers (Szabo and Babuska, Finite Element Analysis, 1991, sec. 10.2) and
    /// that of halves there is little to choose.
    double ratio = 0.15;
    /// A corner is re-entrant if its angle is above this, in degrees: fillets
    /// that are meshed by a few straight edges are none.
    double least_angle = 225.;
  };

  /**
   * The vertices of @p section at which stresses have no limit, in ascending
   * order: corners of its boundary that are re-entrant, of an L or where web
   * and flange meet, say, and places where plies that differ in material or
   * angle end at the boundary, as at free edges of angle plies.
   */
  std::vector<unsigned int>
  singular_corners(const SectionMesh &section, const CornerRules &rules = {});

  /**
   * @p section with @p layers layers of cells at each of its
   * singular_corners(): of every edge that ends there the fractions r^k from
   * the corner on, k = 1 to @p layers and r CornerRules::ratio, become edges of
   * their own, as do those of all edges that face it across cells, so
   * that cells match everywhere. Plies and the names of sides are inherited.
   * Edges have to be straight. Throws InputError, of the entry `Corner layers`
   * of the subsection @p what, if there are no corners or that makes more than
   * most_section_cells.
   */
  std::shared_ptr<const SectionMesh>
  graded_to_corners(const SectionMesh &section,
                    const unsigned int layers,
                    const std::string &what,
                    const CornerRules &rules = {});
} // namespace lamella

#endif
