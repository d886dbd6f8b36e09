// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_fields_h
#define lamella_body_fields_h

#include <lamella/body/body.h>
#include <lamella/body/placement.h>
#include <lamella/material/material.h>

#include <vector>

namespace lamella
{
  /// What takes a strain epsilon into another quantity: the affine map
  /// matrix epsilon + constant.
  struct FromStrain
  {
    ElasticTensor matrix;
    Voigt         constant;
  };

  /**
   * What takes a strain in the axes of a body at @p placement into @p quantity
   * (strain or stress) in the axes of @p frame, where the ply has the axes
   * @p ply and the law @p law in those of the body. The constant is the stress
   * at no strain, -C epsilon_0.
   */
  FromStrain
  from_strain(const Quantity    quantity,
              const Frame       frame,
              const Placement  &placement,
              const Triad      &ply,
              const ElasticLaw &law);

  /// All fields of a displacement and a strain in the axes of a body; the other
  /// arguments as above.
  FieldSample
  sample_of(const dealii::Tensor<1, 3> &displacement,
            const Voigt                &strain,
            const Placement            &placement,
            const Triad                &ply,
            const ElasticLaw           &law);

  /// The mean of the @p samples at the places of a location, with their jump.
  FieldSample
  mean_of(const std::vector<FieldSample> &samples);

  /// ux ... uz, exx ... gyz, sxx ... syz, s11 ... s23, jump.
  const std::vector<std::string> &
  field_names();

  /// The values of @p sample in the order of field_names(). Strains and
  /// stresses are printed in the order of the CSV files, exx, eyy, ezz, gxy,
  /// gxz, gyz, which is that of Eq. 4.
  std::vector<double>
  field_values(const FieldSample &sample);
} // namespace lamella

#endif
