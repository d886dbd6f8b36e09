// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_h
#define lamella_contact_pairing_h

#include <lamella/body/body.h>

#include <vector>

namespace lamella
{
  /// Two points that face each other, numbers in the lists of surface points.
  struct PointPair
  {
    unsigned int first = 0, second = 0;
    /// The outward normal of the first body, and (X_2 - X_1) . n (Eq. 17).
    dealii::Tensor<1, 3> normal;
    double               initial_gap = 0.;
  };

  struct Pairing
  {
    std::vector<PointPair> pairs;
    /// Points of the first surface that face no point of the second.
    unsigned int unpaired = 0;
    /// The smallest distance between the two sets of points, whatever they
    /// face, and the smallest sideways offset: what to tell if nothing pairs.
    double nearest_distance = 0., smallest_offset = 0.;
  };

  /**
   * Node-to-node pairs: for each point of @p first the nearest point of
   * @p second, if it lies along the first's normal (sideways offset below
   * @p tolerance times the square root of the tributary area) and the normals
   * oppose each other.
   */
  Pairing
  pair_node_to_node(const std::vector<SurfacePoint> &first,
                    const std::vector<SurfacePoint> &second,
                    const double                     tolerance);
} // namespace lamella

#endif
