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

  /// An affine map of a strain epsilon to another quantity, in the order of Eq.
  /// 4,
  ///   q = matrix epsilon + constant.
  /// The constant comes from initial strains: stress is C (epsilon -
  /// epsilon_0). Weights and constant of a LinearFunctional follow from it.
  struct StrainMap
  {
    ElasticTensor matrix;
    Voigt         constant;
  };

  /// Returns the map from a strain in the axes of a body at @p placement to @p
  /// quantity in the axes of @p frame, where the ply has the axes @p ply and
  /// the law @p law in body axes. With T the strain rotation to the axes of @p
  /// frame,
  ///   epsilon' = T epsilon,   sigma' = T^-T C (epsilon - epsilon_0),
  /// since the energy sigma . epsilon is invariant. T^-1 is the strain rotation
  /// of the inverse rotation.
  StrainMap
  make_strain_map(const Quantity    quantity,
                  const Frame       frame,
                  const Placement  &placement,
                  const Triad      &ply,
                  const ElasticLaw &law);

  /// Rotations of samples from body axes to scene and ply axes, once per ply.
  class SampleRotations
  {
  public:
    SampleRotations(const Placement &placement, const Triad &ply);

    /// Returns the sample of displacement, strain (order of Eq. 4, engineering
    /// shear strains) and stress, all in body axes, with zero jump.
    FieldSample
    sample(const dealii::Tensor<1, 3> &displacement,
           const Voigt                &strain,
           const Voigt                &stress) const;

  private:
    Triad         axes;
    ElasticTensor strain_to_scene, stress_to_scene, stress_to_ply;
  };

  /// Returns SampleRotations::sample() of one point, with the stress of @p law.
  FieldSample
  sample_of(const dealii::Tensor<1, 3> &displacement,
            const Voigt                &strain,
            const Placement            &placement,
            const Triad                &ply,
            const ElasticLaw           &law);

  /// Returns a sample for finite rotations with the displacement gradient @p H:
  /// Green's strain @p strain, and the stress R^T sigma R.
  FieldSample
  finite_strain_sample(const dealii::Tensor<1, 3> &displacement,
                       const Gradient             &H,
                       const Voigt                &strain,
                       const Placement            &placement,
                       const Triad                &ply,
                       const ElasticLaw           &law);

  /// Changes the stress s of @p sample to scene axes, R s R^T, and R to 1.
  void
  to_scene_axes(FieldSample &sample);

  /// Returns summed energies and maxima of the rest of @p share. Collective.
  Deformation
  reduce_over_processes(Deformation share);

  /// Returns the mean of the @p samples at the places of a location, with their
  /// jump,
  ///   max over a, b of |sigma_a - sigma_b| / max over a of |sigma_a|,
  /// Euclidean norms of six components in scene axes; 0 without stress or for
  /// one sample.
  FieldSample
  mean_sample(const std::vector<FieldSample> &samples);

  /// Returns the names ux ... uz, exx ... gyz, sxx ... syz, s11 ... s23, jump
  /// of CSV columns (VTU has no jump).
  const std::vector<std::string> &
  field_names();

  /// Returns the values of @p sample in the order of field_names(): strains and
  /// stresses as in Eq. 4, in scene axes; s11 to s23 in ply axes.
  std::vector<double>
  field_values(const FieldSample &sample);
} // namespace lamella

#endif
