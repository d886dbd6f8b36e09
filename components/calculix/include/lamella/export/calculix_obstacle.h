// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_obstacle_h
#define lamella_export_calculix_obstacle_h

#include <lamella/contact/contact_pair.h>

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// The rigid surface of an obstacle in CalculiX: a layer of 20-node hexahedra
  /// whose faces S2 are on the surface. Node indices begin at 0.
  struct ObstacleLayer
  {
    /// Positions of nodes in scene axes.
    std::vector<dealii::Point<3>> nodes;
    /// Indices of the twenty nodes of each element, in the order of CalculiX.
    std::vector<std::vector<unsigned int>> elements;
    /// Prescribed displacement of all nodes at load factor 1 [length].
    dealii::Tensor<1, 3> displacement;
  };

  /// Returns the elements for the part of the surface of @p obstacle that
  /// contains the points @p facing (not empty), extended on all sides by a
  /// twentieth of its size plus the tangential displacement of the obstacle. A
  /// plane has 8 x 8 elements. Elements of a cylinder span at most 2 degrees;
  /// their parabolic edges deviate from the circle by less than 1e-8 radii.
  ObstacleLayer
  make_layer(const Obstacle                      &obstacle,
             const std::vector<dealii::Point<3>> &facing);
} // namespace lamella

#endif
