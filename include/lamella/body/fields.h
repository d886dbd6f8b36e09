// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_fields_h
#define lamella_body_fields_h

#include <lamella/body/body.h>
#include <lamella/body/placement.h>
#include <lamella/material/material.h>
#include <lamella/section/finite_strain.h>

#include <vector>

namespace lamella
{
  // Conversion of strains in body axes to output, shared by beam and solid.

  /// An affine map from a strain epsilon, in the order of Voigt, to a strain or
  /// stress q in other axes,
  ///   q = matrix epsilon + constant.
  /// The constant is due to initial strains: stress is C (epsilon - epsilon_0).
  struct StrainMap
  {
    ElasticTensor matrix;
    Voigt         constant;
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
    SampleRotations(const Placement &placement, const Triad &ply);

    /// Returns the FieldSample of @p displacement, @p strain (order of Eq. 4,
    /// engineering shear strains) and @p stress, all in body axes.
    FieldSample
    sample(const dealii::Tensor<1, 3> &displacement,
           const Voigt                &strain,
           const Voigt                &stress) const;

  private:
    Triad         axes;
    ElasticTensor strain_to_scene, stress_to_scene, stress_to_ply;
  };

  /// Returns the FieldSample of a point from @p displacement and @p strain in
  /// body axes, with the stress of the elastic @p law.
  FieldSample
  sample_of(const dealii::Tensor<1, 3> &displacement,
            const Voigt                &strain,
            const Placement            &placement,
            const Triad                &ply,
            const ElasticLaw           &law);

  /// Returns the FieldSample of a point with finite rotations: displacement
  /// gradient @p H, Green's strain @p strain, and as stress R^T sigma R (Cauchy
  /// stress in axes that rotate by R with the material).
  FieldSample
  finite_strain_sample(const dealii::Tensor<1, 3> &displacement,
                       const Gradient             &H,
                       const Voigt                &strain,
                       const Placement            &placement,
                       const Triad                &ply,
                       const ElasticLaw           &law);

  /// Replaces the stress s of @p sample, given in axes rotated by R, by R s R^T
  /// in scene axes, and R by the identity.
  void
  to_scene_axes(FieldSample &sample);

  /// Returns over all processes the sum of Deformation::energy and the maximum
  /// of each other member of @p share. Collective.
  Deformation
  reduce_over_processes(Deformation share);

  /// Returns the mean of @p samples, one for each element a that contains a
  /// point, with the relative jump of their stresses sigma_a,
  ///   max over a, b of |sigma_a - sigma_b| / max over a of |sigma_a|,
  /// by Euclidean norms of six components; 0 without stress.
  FieldSample
  mean_sample(const std::vector<FieldSample> &samples);

  /// Returns the column names of fields in CSV files: ux ... uz, exx ... gyz,
  /// sxx ... syz, s11 ... s23, jump (VTU files have no jump).
  const std::vector<std::string> &
  field_names();

  /// Returns the values of @p sample in the order of field_names(): strains and
  /// stresses as in Eq. 4, in scene axes; s11 to s23 in ply axes.
  std::vector<double>
  field_values(const FieldSample &sample);
} // namespace lamella

#endif
