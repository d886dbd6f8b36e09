// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_support_h
#define lamella_conditions_support_h

#include <lamella/conditions/region.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Prescribed displacements, imposed exactly.
  struct Support
  {
    std::string         name;
    std::vector<Region> on;
    /// The scene components of u at load factor 1; those without are free.
    std::array<std::optional<double>, 3> u;
    /// On surfaces, n . u with the outward normal n: 0 is symmetry, whichever
    /// way the body is turned.
    std::optional<double> normal = std::nullopt;
  };

  /// The displacement of one point along a direction: row(u) = value.
  struct PrescribedRow
  {
    BodyRow      row;
    double       value   = 0.;
    unsigned int support = 0;
    /// A unit vector of the scene; the force in the row acts along it.
    dealii::Tensor<1, 3> direction;
    dealii::Point<3>     position;
  };

  /// The direction of the scene's axis @p c.
  dealii::Tensor<1, 3>
  scene_axis(const unsigned int c);

  /**
   * The rows of @p supports. They may depend on each other; RowReduction sees
   * to that. Throws InputError for regions that are not in their body.
   */
  std::vector<PrescribedRow>
  prescribed_rows(const std::vector<Support> &supports, const Bodies &bodies);

  /// A rigid motion that nothing prevents.
  struct FreeMotion
  {
    /// The rotations about the body's centre() times its size().
    RigidMotion motion;
    /// As in "translation along x with rotation about y".
    std::string words;

    /// The displacement at @p x of @p body.
    dealii::Tensor<1, 3>
    at(const dealii::Point<3> &x, const Body &body) const;
  };

  /**
   * The rigid motions of @p body, number @p index, that @p rows leave free;
   * none if it is held.
   *
   * They are the null space of R E, where E are the body's rigid motions (the
   * rotations scaled with its size), found by a singular value decomposition
   * with the threshold 1e-8 of the largest singular value.
   */
  std::vector<FreeMotion>
  free_rigid_motions(const Body                       &body,
                     const unsigned int                index,
                     const std::vector<PrescribedRow> &rows);
} // namespace lamella

#endif
