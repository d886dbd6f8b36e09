// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/body/fields.h>

namespace lamella
{
  using namespace dealii;

  StrainMap
  make_strain_map(const Quantity    quantity,
                  const Frame       frame,
                  const Placement  &placement,
                  const Triad      &ply,
                  const ElasticLaw &law)
  {
    const Triad to_axes =
      frame == Frame::scene ? transpose(placement.axes) : ply;
    if (quantity == Quantity::strain)
      return {strain_rotation(to_axes), Voigt()};
    // sigma' = T^-T sigma, and T^-1 is the strain rotation of the way back.
    const ElasticTensor back = transpose(strain_rotation(transpose(to_axes)));
    return {back * law.stiffness(), back * law.stress(Voigt())};
  }



  SampleRotations::SampleRotations(const Placement &placement, const Triad &ply)
    : axes(transpose(placement.axes))
    , strain_to_scene(placement.strain_to_scene())
    , stress_to_scene(transpose(strain_rotation(placement.axes)))
    , stress_to_ply(transpose(strain_rotation(transpose(ply))))
  {}



  FieldSample
  SampleRotations::sample(const Tensor<1, 3> &displacement,
                          const Voigt        &strain,
                          const Voigt        &stress) const
  {
    FieldSample sample;
    sample.displacement = axes * displacement;
    sample.strain       = strain_to_scene * strain;
    sample.stress       = stress_to_scene * stress;
    sample.ply_stress   = stress_to_ply * stress;
    return sample;
  }



  FieldSample
  sample_of(const Tensor<1, 3> &displacement,
            const Voigt        &strain,
            const Placement    &placement,
            const Triad        &ply,
            const ElasticLaw   &law)
  {
    return SampleRotations(placement, ply)
      .sample(displacement, strain, law.stress(strain));
  }



  FieldSample
  finite_strain_sample(const Tensor<1, 3> &displacement,
                       const Gradient     &H,
                       const Voigt        &strain,
                       const Placement    &placement,
                       const Triad        &ply,
                       const ElasticLaw   &law)
  {
    const PolarDecomposition F(H);
    FieldSample              sample =
      SampleRotations(placement, ply)
        .sample(displacement, strain, F.corotated_stress(law.stress(strain)));
    sample.rotation = placement.rotation_in_scene(F.rotation());
    return sample;
  }



  void
  to_scene_axes(FieldSample &sample)
  {
    // Stresses turn with the transpose of what turns strains back.
    sample.stress =
      transpose(strain_rotation(transpose(sample.rotation))) * sample.stress;
    sample.rotation = unit_symmetric_tensor<3>();
  }



  Deformation
  reduce_over_processes(Deformation share)
  {
    share.energy = Utilities::MPI::sum(share.energy, communicator());
    for (double *largest : {&share.max_rotation,
                            &share.max_strain,
                            &share.max_rms_strain,
                            &share.shape_change,
                            &share.max_element_rotation})
      *largest = Utilities::MPI::max(*largest, communicator());
    return share;
  }



  FieldSample
  mean_sample(const std::vector<FieldSample> &samples)
  {
    FieldSample mean;
    double      largest = 0.;
    mean.rotation       = Triad();
    const double share  = 1. / samples.size();
    for (const FieldSample &one : samples)
      {
        mean.displacement += share * one.displacement;
        mean.strain += share * one.strain;
        mean.stress += share * one.stress;
        mean.ply_stress += share * one.ply_stress;
        mean.rotation += share * one.rotation;
        largest = std::max(largest, one.stress.norm());
      }
    if (largest > 0.)
      for (const FieldSample &a : samples)
        for (const FieldSample &b : samples)
          mean.jump =
            std::max(mean.jump, (a.stress - b.stress).norm() / largest);
    return mean;
  }



  const std::vector<std::string> &
  field_names()
  {
    static const std::vector<std::string> names{"ux",  "uy",  "uz",  "exx",
                                                "eyy", "ezz", "gxy", "gxz",
                                                "gyz", "sxx", "syy", "szz",
                                                "sxy", "sxz", "syz", "s11",
                                                "s22", "s33", "s12", "s13",
                                                "s23", "jump"};
    return names;
  }



  std::vector<double>
  field_values(const FieldSample &sample)
  {
    std::vector<double> values;
    for (unsigned int c = 0; c < 3; ++c)
      values.push_back(sample.displacement[c]);
    for (const Voigt *part :
         {&sample.strain, &sample.stress, &sample.ply_stress})
      for (unsigned int c = 0; c < 6; ++c)
        values.push_back((*part)[c]);
    values.push_back(sample.jump);
    return values;
  }
} // namespace lamella
