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
  // Where strains in the axes of a body become what users read. Beam and solid
  // share these functions, so that no stress is made in two ways.

  /**
   * What takes a strain epsilon into another quantity: the affine map
   *   q = matrix epsilon + constant,
   * all of them six numbers in the order of Eq. 4. Affine and not linear for
   * the sake of initial strains: a law's stress is C (epsilon - epsilon_0). Its
   * parts go into the weights and the constant of a Row.
   */
  struct FromStrain
  {
    ElasticTensor matrix;
    Voigt         constant;
  };

  /**
   * What takes a strain in the axes of a body at @p placement into @p quantity
   * (strain or stress) in the axes of @p frame, where the ply has the axes
   * @p ply and the law @p law in those of the body. The constant is the stress
   * at no strain, -C epsilon_0 in the axes of @p frame, and zero for strains.
   *
   * With T the strain rotation from the body's axes into those of @p frame,
   *   epsilon' = T epsilon,   sigma' = T^-T C (epsilon - epsilon_0),
   * since the energy sigma . epsilon is the same in all axes. T^-1 is the
   * strain rotation of the way back.
   */
  FromStrain
  from_strain(const Quantity    quantity,
              const Frame       frame,
              const Placement  &placement,
              const Triad      &ply,
              const ElasticLaw &law);

  /// The turns of samples out of the axes of a body at a placement, into those
  /// of the scene and of a ply: made once, they serve all points of one ply.
  class SampleTurns
  {
  public:
    SampleTurns(const Placement &placement, const Triad &ply);

    /// All fields of a displacement (a length), a strain (order of Eq. 4,
    /// engineering shear strains) and the stress that a law makes of it, all in
    /// the axes of the body. The jump is left at zero: one sample has none.
    FieldSample
    sample(const dealii::Tensor<1, 3> &displacement,
           const Voigt                &strain,
           const Voigt                &stress) const;

  private:
    Triad         axes;
    ElasticTensor strain_to_scene, stress_to_scene, stress_to_ply;
  };

  /// SampleTurns::sample() of one point, with the stress of @p law; the other
  /// arguments as above.
  FieldSample
  sample_of(const dealii::Tensor<1, 3> &displacement,
            const Voigt                &strain,
            const Placement            &placement,
            const Triad                &ply,
            const ElasticLaw           &law);

  /// The same of a body that turns by any angle, where the gradient of the
  /// displacement is @p H: Green's strain @p strain, and the stress R^T sigma
  /// R.
  FieldSample
  turned_sample_of(const dealii::Tensor<1, 3> &displacement,
                   const Gradient             &H,
                   const Voigt                &strain,
                   const Placement            &placement,
                   const Triad                &ply,
                   const ElasticLaw           &law);

  /// Makes the stress of @p sample, in axes that turn with the material, that
  /// in the scene's: sigma = R s R^T. What is done is not done twice.
  void
  to_scene_axes(FieldSample &sample);

  /// What all processes make of their shares of a body: the sum of the energies
  /// and the largest of all else. Collective.
  Deformation
  over_processes(Deformation share);

  /**
   * The mean of the @p samples at the places of a location, with their jump,
   *   max over a, b of |sigma_a - sigma_b| / max over a of |sigma_a|,
   * Euclidean norms of the six components in the scene's axes; 0 where there is
   * no stress, or one sample.
   */
  FieldSample
  mean_of(const std::vector<FieldSample> &samples);

  /// ux ... uz, exx ... gyz, sxx ... syz, s11 ... s23, jump: 22 names, the
  /// columns of CSV files. VTU has them all but for the jump.
  const std::vector<std::string> &
  field_names();

  /// The values of @p sample in the order of field_names(). Strains and
  /// stresses are printed in the order of the CSV files, exx, eyy, ezz, gxy,
  /// gxz, gyz, which is that of Eq. 4: displacements and the first twelve in
  /// the scene's axes, s11 to s23 in those of the ply.
  std::vector<double>
  field_values(const FieldSample &sample);
} // namespace lamella

#endif
