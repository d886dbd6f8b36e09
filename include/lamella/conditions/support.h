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
  /// A rigid motion that nothing prevents: the body needs a Stabilization, or
  /// the scene is rejected.
  struct FreeMotion
  {
    /// Motion with rotations about center() times size(), all in displacements.
    RigidMotion motion;
    /// Description, "translation along x with rotation about y"; parts below 1
    /// % are omitted.
    std::string words;

    /// Returns the displacement at @p x, for small rotations of its @p body,
    ///   u(x) = t + w x (x - center), w = rotations / size.
    dealii::Tensor<1, 3>
    at(const dealii::Point<3> &x, const Body &body) const;
  };

  /// Isostatic support of a body: rows that remove unresisted rigid motions
  /// (conditions/isostatic_support.h).
  struct IsostaticSupport
  {
    /// Number of the body in the scene's list.
    unsigned int body = 0;
    /// Removed motions; empty until find_isostatic_motions() is called.
    std::vector<FreeMotion> motions = {};
  };

  /// Rigid motion of a surface at load factor s, R the rotation about theta,
  ///   u(X) = s d + (R(s theta) - 1) (X - c).
  struct RigidRotation
  {
    /// Translation d [length] and rotation theta [rad], scene axes.
    dealii::Tensor<1, 3> translation, rotation;
    dealii::Point<3>     about;

    /// Returns u(@p X).
    dealii::Tensor<1, 3>
    displacement(const double s, const dealii::Point<3> &X) const;
    /// Returns the derivative of u by s, d + theta x R(s theta) (X - c).
    dealii::Tensor<1, 3>
    rate(const double s, const dealii::Point<3> &X) const;
  };

  /// Prescribed displacements (Dirichlet conditions),
  ///   u_c(X) = s d_c for all X of its regions, or n(X) . u(X) = s d,
  /// with the load factor s of its history, or a RigidRotation, which bodies of
  /// small rotations linearize. RowReduction eliminates them exactly, without
  /// penalty or multiplier. Either u or normal is used.
  struct Support
  {
    /// Name in `subsection Support NAME`.
    std::string name;
    /// Regions, possibly of several bodies.
    std::vector<Region> on;
    /// Scene components of u at load factor 1 [length]: 0 is fixed, none free.
    std::array<std::optional<double>, 3> u;
    /// n . u on surfaces with the outward normal n [length]; 0 is symmetry.
    std::optional<double> normal = std::nullopt;
    /// theta of a RigidRotation, which has u as d [rad].
    std::optional<dealii::Tensor<1, 3>> rotation = std::nullopt;
    /// c of a RigidRotation; by default the middle of the held points' box.
    std::optional<dealii::Point<3>> about = std::nullopt;
    /// Isostatic support, without regions and values.
    std::optional<IsostaticSupport> isostatic = std::nullopt;
    /// Number of its history of load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /// The displacement of one point along a direction, row(u) = value, or a mean
  /// of points (isostatic). Its multiplier is the reaction along the direction.
  struct PrescribedFunctional
  {
    /// Compressed row, without constant part or rounding errors.
    BodyFunctional row;
    /// Value at load factor 1, for small rotations [length].
    double value = 0.;
    /// Number of the support in the list.
    unsigned int support = 0;
    /// Direction (unit, scene) of the row's force; isostatic: of its resultant.
    dealii::Tensor<1, 3> direction;
    /// Position in the scene, for moments of reactions and messages.
    dealii::Point<3> position;
    /// Moment of a unit force about the position; zero unless isostatic.
    dealii::Tensor<1, 3> couple = {};
    /// History of the support.
    unsigned int history = 0;
    /// Location of the position in the body; none if isostatic, or on an end of
    /// a body without finite rotations, where section DoFs are prescribed.
    std::optional<Location> location = {};
    /// Rigid motion of the place, if its support has one.
    std::optional<RigidRotation> rotation = {};

    /// Returns the value at load factor @p s for finite rotations [length].
    double
    value_at(const double s) const
    {
      return rotation ? direction * rotation->displacement(s, position) :
                        s * value;
    }
    /// Returns the derivative of value_at() by s.
    double
    rate_at(const double s) const
    {
      return rotation ? direction * rotation->rate(s, position) : value;
    }
  };

  /// Returns the rigid motion that @p support prescribes on @p bodies.
  RigidRotation
  rigid_rotation(const Support &support, const Bodies &bodies);

  /// Returns the unit vector along scene axis @p c, 0, 1 or 2 for x, y, z.
  dealii::Tensor<1, 3>
  scene_axis(const unsigned int c);

  /// Returns the rows of @p supports by support, region and point: up to three
  /// per point for u, one for a normal displacement, one per isostatic motion.
  /// They may be dependent (RowReduction). Weights below 1e-13 of a row's
  /// largest are dropped. Throws InputError for regions outside of their body,
  /// and for a normal displacement on a surface with corners.
  std::vector<PrescribedFunctional>
  prescribed_functionals(const std::vector<Support> &supports,
                         const Bodies               &bodies);

  /// Returns the row @p prescribed of @p body linearized at @p u
  /// (Body::rows_at()), and its value there. The direction of a row with a
  /// rigid motion rotates with the section, which keeps independent rows
  /// independent.
  std::pair<PrescribedFunctional, double>
  row_at(PrescribedFunctional prescribed, const Body &body, const Vector &u);

  /**
   * Returns the rigid motions of @p body, number @p index, that @p rows leave
   * free: the null space of R E, E the rigid motions (rotations times the
   * body's size), by a singular value decomposition with the threshold 1e-8 of
   * the largest singular value. Body::omitted_rigid_motions() count as
   * constrained.
   *
   * The result is in echelon form, rotations first: each motion has a rotation
   * or translation of its own, for readable messages. Rows are folded, sixty at
   * a time, into six with the same singular values, at linear cost.
   */
  std::vector<FreeMotion>
  free_rigid_motions(const Body                              &body,
                     const unsigned int                       index,
                     const std::vector<PrescribedFunctional> &rows);
} // namespace lamella

#endif
