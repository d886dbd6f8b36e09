// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_fields_h
#define lamella_body_fields_h

#include <lamella/body/body.h>
#include <lamella/material/material.h>
#include <lamella/section/finite_strain.h>

#include <vector>

#include <array>

namespace lamella
{
  // Conversion of strains in body axes to output, shared by beam and solid.

  /// An affine map from a strain epsilon, in the order of Voigt, to a strain or
  /// stress q in other axes:
  ///   q = matrix epsilon + constant
  struct StrainMap
  {
    ElasticTensor matrix; ///< Rotation of strain, or elasticity and rotation.
    /// Stress -C epsilon_0 of the initial strain epsilon_0, rotated, or zero.
    Voigt constant;
  };

  /// Returns the map from a strain in body axes to the strain or stress
  /// @p quantity in the axes @p frame. The body is at @p placement; @p ply and
  /// @p law are the ply axes and the elastic law in body axes. With the matrix
  /// T that rotates strains to @p frame,
  ///   epsilon' = T epsilon,   sigma' = T^-T C (epsilon - epsilon_0),
  /// since sigma . epsilon is invariant.
  StrainMap
  make_strain_map(const Quantity    quantity,
                  const Frame       frame,
                  const Placement  &placement,
                  const Triad      &ply,
                  const ElasticLaw &law);

  /// Rotates strains and stresses from body axes to scene and ply axes.
  class SampleRotations
  {
  public:
    /// Constructs the rotations for the body's @p placement and ply axes
    /// @p ply.
    SampleRotations(const Placement &placement, const Triad &ply);

    /// Returns the fields in scene axes, and the stress also in ply axes. The
    /// arguments are in body axes (engineering shear strains, order of Voigt).
    FieldSample
    sample(const dealii::Tensor<1, 3> &displacement,
           const Voigt                &strain,
           const Voigt                &stress) const;

  private:
    Triad         axes;
    ElasticTensor strain_to_scene, stress_to_scene, stress_to_ply;
  };

  /// Returns the fields of a point with @p displacement and @p strain in body
  /// axes, with the stress of the elastic @p law. @p ply are the ply axes.
  FieldSample
  sample_of(const dealii::Tensor<1, 3> &displacement,
            const Voigt                &strain,
            const Placement            &placement,
            const Triad                &ply,
            const ElasticLaw           &law);

  /// Returns the fields of a point with finite rotations: displacement gradient
  /// @p H, Green's strain @p strain, and as stress R^T sigma R (Cauchy stress
  /// in axes that rotate by R with the material).
  FieldSample
  finite_strain_sample(const dealii::Tensor<1, 3> &displacement,
                       const Gradient             &H,
                       const Voigt                &strain,
                       const Placement            &placement,
                       const Triad                &ply,
                       const ElasticLaw           &law);

  /// Rotates the stress s of @p sample, given in axes rotated with the material
  /// by R, to R s R^T in scene axes, and sets R to the identity.
  void
  to_scene_axes(FieldSample &sample);

  /// Combines the values @p share of all processes: the sum of
  /// Deformation::energy and the maximum of each other member. Collective.
  Deformation
  reduce_over_processes(Deformation share);

  /// Returns the mean of @p samples, the fields of all elements that contain a
  /// point, with the relative jump of the stresses sigma_a of elements a,
  ///   max over a, b of |sigma_a - sigma_b| / max over a of |sigma_a|,
  /// in Euclidean norms of the six components; 0 without stress.
  FieldSample
  mean_sample(const std::vector<FieldSample> &samples);

  /// Returns the column names in CSV files: displacements ux ... uz, strains
  /// exx
  /// ... gyz, stresses sxx ... syz and s11 ... s23 (ply axes), and `jump`, the
  /// relative difference of the stresses of adjacent elements (mean_sample()).
  const std::vector<std::string> &
  field_names();

  /// Returns the values of @p sample in the order of field_names():
  /// displacements, strains and stresses in scene axes, stresses s11 to s23 in
  /// ply axes, stress jump.
  std::vector<double>
  field_values(const FieldSample &sample);

  /// Returns the fields of @p u in all elements of @p body of this process, at
  /// (n + 1)^3 points each.
  std::vector<OutputCell>
  output_cells(const Body &body, const unsigned int n, const Vector &u);

  /// Returns the density of each ply of @p body. Throws InputError if a ply has
  /// none.
  std::vector<double>
  densities(const Body &body);

  /// Mass, first and second moments of bodies about the scene origin.
  struct Inertia
  {
    double               mass = 0.;       ///< int rho dV [force s^2 / length].
    dealii::Tensor<1, 3> first;           ///< int rho x dV.
    dealii::SymmetricTensor<2, 3> second; ///< int rho x x^T dV.

    /// Returns the center of mass; the origin without mass.
    dealii::Point<3>
    center() const;
    /// Returns the moments of inertia about the center of mass,
    /// int rho (|r|^2 1 - r r^T) dV with r = x - center().
    dealii::SymmetricTensor<2, 3>
    about_center() const;
  };

  /// Returns true if the densities of all plies of @p bodies are known.
  bool
  have_densities(const Bodies &bodies);

  /// Returns the inertia of @p bodies. Throws as densities() does. Collective.
  Inertia
  inertia_of(const Bodies &bodies);

  /// A callback with the Gauss points of an element and a force at each.
  using ForcesCallback =
    std::function<void(const std::vector<Location> &,
                       const std::vector<dealii::Tensor<1, 3>> &)>;

  /// Calls @p use for each element of this process, or @p of_all_processes,
  /// with its Gauss points and their weights (forces, scene axes) under the
  /// @p acceleration [length / s^2]. Throws as densities() does.
  void
  for_each_cell_by_weight(const Body                 &body,
                          const dealii::Tensor<1, 3> &acceleration,
                          const ForcesCallback       &use,
                          const bool                  of_all_processes = false);

  /// Kinds of motion of a beam, in axes of the body. The first four are rigid
  /// motions of cross-sections, the others deform them.
  enum class Motion : unsigned int
  {
    bending_x, ///< u_z and rotation about x of cross-sections.
    bending_z, ///< u_x and rotation about z.
    axial,     ///< u_y.
    torsion,   ///< Rotation about y.
    width,     ///< Remaining u_x: change of the section's width.
    warping,   ///< Remaining u_y: warping of cross-sections.
    thickness  ///< Remaining u_z: change of the section's thickness.
  };

  /// Names of the kinds of motion in tables, in their order.
  inline constexpr std::array<const char *, 7> motion_names{{"bending about x",
                                                             "bending about z",
                                                             "axial",
                                                             "torsion",
                                                             "width",
                                                             "warping",
                                                             "thickness"}};

  /// Shares of each Motion in the kinetic energy of a mode; their sum is 1.
  using MotionShares = std::array<double, motion_names.size()>;

  /// Motion of a body in a mode.
  struct BodyMotion
  {
    MotionShares shares{}; ///< Shares of the kinds of motion.
    /// Momenta and angular momenta of cross-sections, times Legendre
    /// polynomials along the body, for comparisons with other meshes: 6 numbers
    /// for each polynomial; angular momenta divided by the radius of gyration.
    std::vector<double> momenta;
  };

  /// Returns the motion of @p body with each of the velocities @p v (DoFs) at
  /// the DoFs @p u, and a density @p rho of each ply (equal if empty). Shares
  /// are those of the kinetic energy int rho |v|^2 / 2 dV. In each
  /// cross-section v is projected onto the rigid motions. Eight Gauss points
  /// along each element, two across.
  std::vector<BodyMotion>
  motions_of(const Body                        &body,
             const std::vector<double>         &rho,
             const Vector                      &u,
             const std::vector<const Vector *> &v);
} // namespace lamella

#endif
