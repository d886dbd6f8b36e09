// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_obstacle_h
#define lamella_export_calculix_obstacle_h

#include <lamella/contact/obstacle.h>

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// A layer of 20-node hexahedra along a part of an obstacle's surface, which
  /// is face 2 (CalculiX') of each: a rigid surface for a program that knows
  /// contact between elements only. Nodes are numbered from 0.
  struct ObstacleLayer
  {
    /// Positions in the scene's axes.
    std::vector<dealii::Point<3>> nodes;
    /// Twenty nodes each, in CalculiX' order.
    std::vector<std::vector<unsigned int>> elements;
    /// The obstacle's at load factor 1, of all nodes alike.
    dealii::Tensor<1, 3> displacement;
  };

  /**
   * The layer that covers the places @p facing of the surface of @p obstacle,
   * and a margin: a twentieth of its extension on all sides, and as far as the
   * obstacle moves along itself.
   *
   * Along a plane there are 8 x 8 elements, a tenth of the larger extension
   * deep. Around a cylinder each element spans 2 degrees at most, is about ten
   * times as long as wide and a tenth of the radius deep. The parabola through
   * its three nodes is off the circle by less than 1e-8 radii.
   *
   * @p facing must not be empty; of it only the extension is kept.
   */
  ObstacleLayer
  make_layer(const Obstacle                      &obstacle,
             const std::vector<dealii::Point<3>> &facing);
} // namespace lamella

#endif
