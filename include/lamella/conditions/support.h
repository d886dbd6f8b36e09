// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_support_h
#define lamella_conditions_support_h

#include <lamella/conditions/load_factor.h>
#include <lamella/conditions/region.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A rigid motion that nothing prevents. The stiffness of the body is
  /// singular along it: a Stabilisation has to make it definite for contact to
  /// hold the body, or the scene is refused.
  struct FreeMotion
  {
    /// The rotations about the body's centre() times its size(), so that all
    /// six numbers are displacements of comparable size.
    RigidMotion motion;
    /// As in "translation along x with rotation about y". Parts below a
    /// hundredth of the largest are left out.
    std::string words;

    /// The displacement at @p x of @p body.
    ///
    ///   u(x) = t + w x (x - centre), w = rotations / size,
    ///
    /// in scene axes, for small rotations. @p body is the one it was found for.
    dealii::Tensor<1, 3>
    at(const dealii::Point<3> &x, const Body &body) const;
  };

  /// What `Hold` of a body makes a support of: rows that take rigid motions out
  /// of a body that nothing acts against (conditions/hold.h).
  struct Hold
  {
    /// The number in the scene's list of bodies.
    unsigned int body = 0;
    /// What is held; empty until find_held_motions() has looked.
    std::vector<FreeMotion> motions = {};
  };

  /// A surface that is moved as a whole, the rigid motion
  ///   u(X) = s d + (R(s theta) - 1) (X - c)
  /// at load factor s, R the rotation by |theta| about theta.
  struct RigidTurn
  {
    /// d [length] and theta [rad], scene axes.
    dealii::Tensor<1, 3> translation, rotation;
    dealii::Point<3>     about;

    /// u(@p X).
    dealii::Tensor<1, 3>
    displacement(const double s, const dealii::Point<3> &X) const;
    /// Its derivative, d + theta x R(s theta) (X - c).
    dealii::Tensor<1, 3>
    rate(const double s, const dealii::Point<3> &X) const;
  };

  /// Prescribed displacements, imposed exactly.
  ///
  ///   u_c(X) = s d_c for all X of its regions, or n(X) . u(X) = s d,
  ///
  /// with the load factor s of its history, or those of a RigidTurn; bodies of
  /// small rotations take s (d + theta x (X - c)). Dirichlet conditions,
  /// eliminated
  /// from the unknowns (RowReduction); there is no penalty and no multiplier in
  /// the system. Either u or normal counts.
  struct Support
  {
    /// As in `subsection Support NAME`.
    std::string name;
    /// May lie on several bodies.
    std::vector<Region> on;
    /// The scene components of u at load factor 1; those without are free
    /// [length]. 0 holds the point.
    std::array<std::optional<double>, 3> u;
    /// On surfaces, n . u with the outward normal n: 0 is symmetry, whichever
    /// way the body is turned. Positive outwards [length].
    std::optional<double> normal = std::nullopt;
    /// theta of a RigidTurn, which then has u for d [rad].
    std::optional<dealii::Tensor<1, 3>> rotation = std::nullopt;
    /// Its c; the middle of the box around all that is held without.
    std::optional<dealii::Point<3>> about = std::nullopt;
    /// Of a hold, which has no regions and no values.
    std::optional<Hold> hold = std::nullopt;
    /// Of its load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /// The displacement of one point along a direction: row(u) = value. The force
  /// in the row, its multiplier, is a reaction: force along direction on the
  /// body, and work with value. Of a hold it is the mean of several points.
  struct PrescribedRow
  {
    /// Compressed, with no constant part and no entries that are rounding.
    BodyRow row;
    /// At load factor 1, of small rotations [length].
    double value = 0.;
    /// Its number in the list of supports.
    unsigned int support = 0;
    /// A unit vector of the scene; the force in the row acts along it. Of a
    /// hold the resultant of a unit force in the row.
    dealii::Tensor<1, 3> direction;
    /// Where it acts, in the scene: for moments of reactions and for messages.
    dealii::Point<3> position;
    /// The moment about there of a unit force in the row: not zero of a hold
    /// only.
    dealii::Tensor<1, 3> couple = {};
    /// That of its support.
    unsigned int history = 0;
    /// The same place in its body; none of a hold, and none on an end of a
    /// body that does not turn: what is held there are the numbers of its
    /// section, whatever its state.
    std::optional<Location> location = {};
    /// Where its support turns the place.
    std::optional<RigidTurn> turn = {};

    /// What a body that turns by any angle is to have it measure at load factor
    /// @p s [length].
    double
    value_at(const double s) const
    {
      return turn ? direction * turn->displacement(s, position) : s * value;
    }
    /// The derivative of what its place does along its direction.
    double
    rate_at(const double s) const
    {
      return turn ? direction * turn->rate(s, position) : value;
    }
  };

  /// The turn of @p support, which has one, of places on @p bodies.
  RigidTurn
  rigid_turn(const Support &support, const Bodies &bodies);

  /// The unit vector along the scene's axis @p c, 0, 1 or 2 for x, y, z.
  dealii::Tensor<1, 3>
  scene_axis(const unsigned int c);

  /**
   * The rows of @p supports. They may depend on each other; RowReduction sees
   * to that. Throws InputError for regions that are not in their body. Support
   * by support, region by region, point by point; of u three rows a point or
   * fewer, of normal one, of a hold one a motion. Weights below 1e-13 of a
   * row's largest are dropped, so that what rounding leaves at other nodes does
   * not tie rows together. Throws InputError, too, for a normal displacement on
   * a surface with corners, where there is no normal.
   */
  std::vector<PrescribedRow>
  prescribed_rows(const std::vector<Support> &supports, const Bodies &bodies);

  /// The row @p prescribed of @p body where @p u has moved it, a functional of
  /// changes of that state (Body::rows_at()), and what it measures there. One
  /// without a location stays as it is; one of a turn measures along a
  /// direction that turns with the section, so that rows which are independent
  /// at rest stay so.
  std::pair<PrescribedRow, double>
  row_at(PrescribedRow prescribed, const Body &body, const Vector &u);

  /**
   * The rigid motions of @p body, number @p index, that @p rows leave free;
   * none if it is held.
   *
   * They are the null space of R E, where E are the body's rigid motions (the
   * rotations scaled with its size), found by a singular value decomposition
   * with the threshold 1e-8 of the largest singular value. Motions that the
   * theory does not contain (Body::missing_motions()) count as held. The result
   * is brought to echelon form, rotations first: each motion has a rotation, or
   * failing that a translation, that no other has, so that a user can recognise
   * it. It is not orthonormal. Rows are folded, sixty at a time, into six of
   * the same singular values: the cost is linear in their number and the
   * conditioning not squared, as that of a Gram matrix is.
   */
  std::vector<FreeMotion>
  free_rigid_motions(const Body                       &body,
                     const unsigned int                index,
                     const std::vector<PrescribedRow> &rows);
} // namespace lamella

#endif
