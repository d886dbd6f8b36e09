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
  /// A rigid motion of a body that no support constrains. A scene with such a
  /// body is rejected unless it has a Stabilization.
  struct FreeMotion
  {
    /// Three translations, then three rotations about the center of the body
    /// times Body::size() [length].
    RigidMotion motion;
    /// Description for messages, such as "translation along x with rotation
    /// about y", without components below 1 %.
    std::string words;

    /// Returns the displacement at @p x for small rotations of @p body,
    ///   u(x) = t + w x (x - c), w = rotations / Body::size(),
    /// with the translations t and the center c of the body.
    dealii::Tensor<1, 3>
    at(const dealii::Point<3> &x, const Body &body) const;
  };

  /// Isostatic support of a body, which constrains the rigid motions that
  /// neither other supports nor contacts resist (isostatic_support.h).
  struct IsostaticSupport
  {
    /// Index of the body in the scene.
    unsigned int body = 0;
    /// Rigid motions to constrain; set by find_isostatic_motions().
    std::vector<FreeMotion> motions = {};
  };

  /// Prescribed rigid motion of a surface: at load factor s, point X moves by
  ///   u(X) = s d + (R(s theta) - 1) (X - c),
  /// where R(s theta) is the rotation by the vector s theta about the center c.
  struct RigidRotation
  {
    dealii::Tensor<1, 3>
      translation,          ///< Translation at load factor 1 [length].
      rotation;             ///< Rotation vector at load factor 1 [rad].
    dealii::Point<3> about; ///< Center of the rotation, scene axes.

    /// Returns the displacement u(X) of point @p X at load factor @p s.
    dealii::Tensor<1, 3>
    displacement(const double s, const dealii::Point<3> &X) const;
    /// Returns the derivative of displacement() with respect to @p s at @p X.
    dealii::Tensor<1, 3>
    rate(const double s, const dealii::Point<3> &X) const;
  };

  /// Prescribed displacements (Dirichlet conditions) of regions: at load factor
  /// s and for all points X,
  ///   u_c(X) = s d_c for components c, or n(X) . u(X) = s d,
  /// or the displacements of a RigidRotation, linearized for bodies with small
  /// rotations. Either `u` or `normal` is used. RowReduction eliminates them.
  struct Support
  {
    /// Name in `subsection Support NAME`.
    std::string name;
    /// Regions, possibly of several bodies, on which the support acts.
    std::vector<Region> on;
    /// Components at load factor 1, scene axes [length]; free if without value.
    std::array<std::optional<double>, 3> u;
    /// Displacement along the outward normal at load factor 1 [length], 0 for
    /// symmetry; empty if components `u` are prescribed.
    std::optional<double> normal = std::nullopt;
    /// Rotation vector [rad] of a RigidRotation with translation `u`, or empty.
    std::optional<dealii::Tensor<1, 3>> rotation = std::nullopt;
    /// Center of rotation; if empty, center of the bounding box of the regions.
    std::optional<dealii::Point<3>> about = std::nullopt;
    /// Set for an isostatic support, which has no regions and no values.
    std::optional<IsostaticSupport> isostatic = std::nullopt;
    /// Index of the history of load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /// A linear constraint row(u) = value on the DoFs u of a body by a support.
  /// row(u) is the displacement of a point along a direction or, for an
  /// isostatic support, a mean over points. The Lagrange multiplier is the
  /// reaction along the direction.
  struct PrescribedFunctional
  {
    /// Linear functional of the DoFs, without constant part.
    BodyFunctional row;
    /// Prescribed displacement at load factor 1 for small rotations [length].
    double value = 0.;
    /// Index of the support in the scene.
    unsigned int support = 0;
    /// Direction of the reaction or its resultant (unit vector, scene axes).
    dealii::Tensor<1, 3> direction;
    /// Undeformed point at which the reaction acts, scene axes.
    dealii::Point<3> position;
    /// Moment about `position` of the reaction, for a unit Lagrange multiplier.
    /// Nonzero only for isostatic supports, whose reactions are distributed.
    dealii::Tensor<1, 3> couple = {};
    /// Copy of Support::history, the index of the history of load factors.
    unsigned int history = 0;
    /// Constrained point of the body; empty for isostatic supports and where
    /// section DoFs are prescribed (ends of bodies without finite rotations).
    std::optional<Location> location = {};
    /// Rigid motion that the support prescribes; empty without a rotation.
    std::optional<RigidRotation> rotation = {};

    /// Returns the prescribed displacement at load factor @p s [length].
    double
    value_at(const double s) const
    {
      return rotation ? direction * rotation->displacement(s, position) :
                        s * value;
    }
    /// Returns the derivative of value_at() with respect to load factor @p s.
    double
    rate_at(const double s) const
    {
      return rotation ? direction * rotation->rate(s, position) : value;
    }
  };

  /// Returns the rigid motion that @p support prescribes by its rotation.
  RigidRotation
  rigid_rotation(const Support &support, const Bodies &bodies);

  /// Returns the unit vector along scene axis @p c, 0, 1 or 2 for x, y, z.
  dealii::Tensor<1, 3>
  scene_axis(const unsigned int c);

  /// Returns the constraints of @p supports, ordered by support, region and
  /// point: up to three per point for displacement components, one per point
  /// for a normal displacement, one per rigid motion of an isostatic support.
  /// They may be linearly dependent (RowReduction). Throws InputError for a
  /// region outside of a body or a normal displacement of a surface with
  /// corners.
  std::vector<PrescribedFunctional>
  prescribed_functionals(const std::vector<Support> &supports,
                         const Bodies               &bodies);

  /// Returns the constraint @p prescribed of @p body linearized at the
  /// displacement @p u (Body::rows()), and the displacement along its
  /// direction. If a RigidRotation is prescribed, the direction rotates with
  /// the section, so that independent constraints stay independent.
  std::pair<PrescribedFunctional, double>
  row_at(PrescribedFunctional prescribed, const Body &body, const Vector &u);

  /// Returns the rigid motions of @p body (with the index @p index) that the
  /// constraints @p rows leave free: the null space of the constraint matrix
  /// times the six rigid motions, by a singular value decomposition with the
  /// threshold 1e-8 of the largest singular value. Rigid motions that the body
  /// cannot perform (Body::omitted_rigid_motions()) count as constrained. For
  /// readable messages, the motions are in echelon form, rotations first.
  std::vector<FreeMotion>
  free_rigid_motions(const Body                              &body,
                     const unsigned int                       index,
                     const std::vector<PrescribedFunctional> &rows);
} // namespace lamella

#endif
