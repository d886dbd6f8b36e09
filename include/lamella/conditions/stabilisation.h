// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_stabilisation_h
#define lamella_conditions_stabilisation_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * A spring to the ground in what a row measures: its energy is
   * 1/2 k r(u)^2, its force on the body -k r(u) r^T.
   */
  struct Spring
  {
    Row row;
    /// Force / length.
    double stiffness = 0.;
    /// The Stabilisation that it comes from.
    double share = 0.;
    /// The rigid motion that it holds, in words.
    std::string motion;
  };

  /// A body is held by contact alone in some of its rigid motions; springs of
  /// this share of its axial stiffness then make its stiffness definite. Zero:
  /// no springs.
  struct Stabilisation
  {
    double share = 0.;
  };

  /**
   * One spring for each rigid motion of @p body, number @p index, that @p rows
   * leave free. Each acts in
   *   r(u) = 4 / n sum_p q(X_p) . u(X_p),
   * where the n points X_p are the corners of both ends (all points that are
   * furthest from the end's centroid) and the motions q are made orthonormal in
   * that product; its stiffness is @p stabilisation.share times E A / L (normal
   * modulus and area of the start, distance of the ends). A body and its mirror
   * image are held alike.
   */
  std::vector<Spring>
  stabilising_springs(const Body                       &body,
                      const unsigned int                index,
                      const std::vector<PrescribedRow> &rows,
                      const Stabilisation              &stabilisation);
} // namespace lamella

#endif
