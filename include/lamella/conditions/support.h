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
  /// An unconstrained rigid motion of a body. Such a body needs a
  /// Stabilization, otherwise the scene is rejected.
  struct FreeMotion
  {
    /// Translations, and rotations about the center times the size [length].
    RigidMotion motion;
    /// Description for messages, such as "translation along x with rotation
    /// about y", without components below 1 %.
    std::string words;

    /// Returns the displacement at @p x, for small rotations of its @p body,
    ///   u(x) = t + w x (x - center), w = rotations / size.
    dealii::Tensor<1, 3>
    at(const dealii::Point<3> &x, const Body &body) const;
  };

  /// Isostatic support of a body, which constrains the rigid motions that
  /// neither other supports nor contacts resist (isostatic_support.h).
  struct IsostaticSupport
  {
    /// Index of the body in the scene.
    unsigned int body = 0;
    /// Constrained rigid motions, set by find_isostatic_motions().
    std::vector<FreeMotion> motions = {};
  };

  /// Prescribed rigid motion of a surface: at load factor s, point X moves by
  ///   u(X) = s d + (R(s theta) - 1) (X - c), R the rotation by s theta about
  ///   c.
  struct RigidRotation
  {
    /// Translation d [length] and rotation vector theta [rad], scene axes.
    dealii::Tensor<1, 3> translation, rotation;
    dealii::Point<3>     about;

    /// Returns u(X) at load factor @p s.
    dealii::Tensor<1, 3>
    displacement(const double s, const dealii::Point<3> &X) const;
    /// Returns du/ds = d + theta x R(s theta) (X - c).
    dealii::Tensor<1, 3>
    rate(const double s, const dealii::Point<3> &X) const;
  };

  /// Prescribed displacements (Dirichlet conditions),
  ///   u_c(X) = s d_c for all X of its regions, or n(X) . u(X) = s d,
  /// with the load factor s, or the displacements of a RigidRotation,
  /// linearized for bodies with small rotations. Either `u` or `normal` is
  /// used. RowReduction eliminates the constraints exactly.
  struct Support
  {
    /// Name in `subsection Support NAME`.
    std::string name;
    /// Regions, possibly of several bodies.
    std::vector<Region> on;
    /// Components of d in scene axes [length]; free if without value.
    std::array<std::optional<double>, 3> u;
    /// Displacement d along the outward normal n [length]; 0 for symmetry.
    std::optional<double> normal = std::nullopt;
    /// Rotation vector theta of a RigidRotation [rad], which has u as d.
    std::optional<dealii::Tensor<1, 3>> rotation = std::nullopt;
    /// Center c of a RigidRotation; by default that of the bounding box of the
    /// constrained points.
    std::optional<dealii::Point<3>> about = std::nullopt;
    /// Set for an isostatic support, which has no regions and no values.
    std::optional<IsostaticSupport> isostatic = std::nullopt;
    /// Index of the history of load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /// A linear constraint row(u) = value on the DoFs u of a body. row(u) is the
  /// displacement of a point along a direction or, for an isostatic support, a
  /// mean over points. Its multiplier is the reaction along the direction.
  struct PrescribedFunctional
  {
    /// Linear functional of the DoFs, without constant part.
    BodyFunctional row;
    /// Value at load factor 1 if rotations are small [length].
    double value = 0.;
    /// Index of the support in the scene.
    unsigned int support = 0;
    /// Direction of the reaction or its resultant (unit vector, scene axes).
    dealii::Tensor<1, 3> direction;
    /// Position of the reaction in the scene.
    dealii::Point<3> position;
    /// Moment of a unit reaction about the position; zero unless isostatic.
    dealii::Tensor<1, 3> couple = {};
    /// Support::history.
    unsigned int history = 0;
    /// Location in the body; none for isostatic supports and where section DoFs
    /// are prescribed (ends of bodies without finite rotations).
    std::optional<Location> location = {};
    /// Prescribed rigid motion of the point, if its support has a rotation.
    std::optional<RigidRotation> rotation = {};

    /// Returns the value at load factor @p s with finite rotations [length].
    double
    value_at(const double s) const
    {
      return rotation ? direction * rotation->displacement(s, position) :
                        s * value;
    }
    /// Returns the derivative of value_at() with respect to s.
    double
    rate_at(const double s) const
    {
      return rotation ? direction * rotation->rate(s, position) : value;
    }
  };

  /// Returns the rigid motion that @p support with a rotation prescribes.
  RigidRotation
  rigid_rotation(const Support &support, const Bodies &bodies);

  /// Returns the unit vector along scene axis @p c, 0, 1 or 2 for x, y, z.
  dealii::Tensor<1, 3>
  scene_axis(const unsigned int c);

  /// Returns the constraints of @p supports, ordered by support, region and
  /// point: up to three per point for displacement components, one per point
  /// for a normal displacement, one per rigid motion of an isostatic support.
  /// They may be linearly dependent (RowReduction). Throws InputError for
  /// regions outside of a body, and normal displacements on surfaces with
  /// corners.
  std::vector<PrescribedFunctional>
  prescribed_functionals(const std::vector<Support> &supports,
                         const Bodies               &bodies);

  /// Returns the constraint @p prescribed of @p body linearized at the
  /// displacement @p u (Body::rows_at()), and the displacement along its
  /// direction. The direction of a constraint with a RigidRotation rotates with
  /// the section, so that independent constraints stay independent.
  std::pair<PrescribedFunctional, double>
  row_at(PrescribedFunctional prescribed, const Body &body, const Vector &u);

  /// Returns the rigid motions of @p body (which has the index @p index) that
  /// the constraints @p rows leave free: the null space of R E, with R the
  /// matrix of the rows and E the rigid motions, by a singular value
  /// decomposition with a threshold of 1e-8 of the largest singular value.
  /// Body::omitted_rigid_motions() count as constrained.
  ///
  /// The motions are in echelon form, rotations first, for readable messages.
  std::vector<FreeMotion>
  free_rigid_motions(const Body                              &body,
                     const unsigned int                       index,
                     const std::vector<PrescribedFunctional> &rows);
} // namespace lamella

#endif
