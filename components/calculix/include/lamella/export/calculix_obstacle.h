// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_obstacle_h
#define lamella_export_calculix_obstacle_h

#include <lamella/contact/obstacle.h>

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// A layer of 20-node hexahedra along a part of an obstacle's surface, face 2
  /// (CalculiX') of each: a rigid surface. Nodes are numbered from 0.
  struct ObstacleLayer
  {
    /// Positions in the scene's axes.
    std::vector<dealii::Point<3>> nodes;
    /// Twenty nodes of each element, in CalculiX' order.
    std::vector<std::vector<unsigned int>> elements;
    /// Displacement of the obstacle at load factor 1, of all nodes.
    dealii::Tensor<1, 3> displacement;
  };

  /// Returns the layer at the positions @p facing, not empty, of the surface of
  /// @p obstacle, with a margin on all sides: a twentieth of its extent, plus
  /// the obstacle's motion along itself. A plane has 8 x 8 elements, a tenth of
  /// the larger extent deep. Elements of a cylinder span at most 2 degrees, are
  /// about ten times as long as wide and a tenth of the radius deep; their
  /// parabola deviates from the circle by less than 1e-8 radii.
  ObstacleLayer
  make_layer(const Obstacle                      &obstacle,
             const std::vector<dealii::Point<3>> &facing);
} // namespace lamella

#endif
