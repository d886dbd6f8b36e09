// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_stabilisation_h
#define lamella_conditions_stabilisation_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * A spring to the ground in what a row measures: its energy is 1/2 k r(u)^2,
   * its force on the body -k r(u) r^T. A rank-one term k r^T r of the stiffness
   * (SpringTerm). It condenses and reduces like any other row.
   */
  struct Spring
  {
    /// r, of the DoFs of one body [length]; compressed.
    Row row;
    /// Force / length.
    double stiffness = 0.;
    /// The Stabilisation that it comes from, a pure number.
    double share = 0.;
    /// The rigid motion that it holds, in words.
    std::string motion;
  };

  /// A body is held by contact alone in some of its rigid motions; springs of
  /// this share of its axial stiffness then make its stiffness definite. Zero:
  /// no springs. A small number such as 1e-6; each body has its own. The
  /// springs do not stay in the result: the solution is repeated with their
  /// rest at the state before until they are without force (the proximal point
  /// method, doc/contact.md).
  struct Stabilisation
  {
    double share = 0.;
  };

  /// Of the surface that @p points stand for.
  dealii::Point<3>
  centroid_of(const std::vector<SurfacePoint> &points);

  /// The corners of @p surface of @p body: all points that are furthest from
  /// its centroid, so that a body and its mirror image are held alike, and if
  /// that is one alone those furthest from it.
  std::vector<SurfacePoint>
  far_points(const Body &body, const std::string &surface);

  /**
   * One spring for each rigid motion of @p body, number @p index, that @p rows
   * leave free. Each acts in
   *   r(u) = 4 / n sum_p q(X_p) . u(X_p),
   * where the n points X_p are the corners of both ends (all points that are
   * furthest from the end's centroid) and the motions q are made orthonormal in
   * that product; its stiffness is @p stabilisation.share times E A / L (normal
   * modulus and area of the start, distance of the ends). A body and its mirror
   * image are held alike.
   *
   * Where the furthest point of an end is one alone, those furthest from it are
   * taken, too: one point would not hold a turn. The factor 4 / n makes springs
   * independent of how many corners the section has. Since the motions are
   * orthonormal at the points, the r of one vanishes on all others: no spring
   * resists what another one holds.
   *
   * None if @p stabilisation.share is zero or the rows hold the body. @p rows
   * may be those of all bodies; others than @p index are passed over.
   */
  std::vector<Spring>
  stabilising_springs(const Body                       &body,
                      const unsigned int                index,
                      const std::vector<PrescribedRow> &rows,
                      const Stabilisation              &stabilisation);
} // namespace lamella

#endif
