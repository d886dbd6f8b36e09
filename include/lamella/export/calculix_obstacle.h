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
  /// is face 2 (CalculiX') of each. Nodes are numbered from 0.
  struct ObstacleLayer
  {
    std::vector<dealii::Point<3>>          nodes;
    std::vector<std::vector<unsigned int>> elements;
    dealii::Tensor<1, 3>                   displacement;
  };

  /**
   * The layer that covers the places @p facing of the surface of @p obstacle,
   * and a margin: a twentieth of its extension on all sides, and as far as the
   * obstacle moves along itself.
   *
   * Around a cylinder each element spans 2 degrees at most. The parabola
   * through its three nodes is off the circle by less than 1e-8 radii.
   */
  ObstacleLayer
  make_layer(const Obstacle                      &obstacle,
             const std::vector<dealii::Point<3>> &facing);
} // namespace lamella

#endif
