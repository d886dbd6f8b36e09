// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/twist_stretch.h>

#include <array>

namespace lamella
{
  using namespace dealii;

  Voigt
  stretch_of_fiber(const Section &section, const SectionPoint &point)
  {
    const double square =
      point.position.distance_square(section.element().center());
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      if ((*point.fields)[k] == RigidField::translation_y)
        return square * point.along[k];
    return Voigt();
  }



  TwistStretch::TwistStretch(const SaintVenant &states)
    : section(states.of_section())
    , relaxation(section.n_fields())
    , on_derivatives(section.n_fields(), 0.)
  {
    Vector on_values(section.n_fields());
    section.for_each_point([&](const SectionPoint &point, const double weight) {
      const Voigt fiber = stretch_of_fiber(section, point);
      const Voigt stress =
        weight * section.law(point.cell, point.position).stress(fiber);
      square += fiber * stress;
      for (unsigned int k = 0; k < point.fields->size(); ++k)
        {
          const unsigned int alpha = (*point.fields)[k];
          on_values[alpha] -= point.in_plane[k] * stress;
          on_derivatives[alpha] += point.along[k] * stress;
        }
    });
    relaxation = states.constrained_response(on_values);
    square -= on_values * relaxation;
    Vector of_relaxation(section.n_fields());
    section.S(1, 0).vmult(of_relaxation, relaxation);
    for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
      on_derivatives[alpha] += of_relaxation[alpha];

    c = stiffening_of(states);
  }



  double
  TwistStretch::stiffening_of(const SaintVenant &states) const
  {
    using Force              = SaintVenant::Force;
    constexpr Force shears[] = {Force::F_x, Force::F_z},
                    axial[]  = {Force::F_y, Force::M_x, Force::M_z};
    const SectionTensor &C = states.compliance(), &D = states.stiffness();
    const double         h = section.element().reference_length();
    // The shears that go with a twist of 1 about the torsion center, and what
    // these make of the stretch and the curvatures, of k^2 / 2.
    const double G_x = C[shears[0]][Force::M_y] / C[Force::M_y][Force::M_y],
                 G_z = C[shears[1]][Force::M_y] / C[Force::M_y][Force::M_y];
    const std::array<double, 3> q{
      {G_x * G_x + G_z * G_z, -2. * G_x, -2. * G_z}};
    // The work of r^2 on each of these.
    const std::array<double, 3> work{{on_derivatives[RigidField::translation_y],
                                      -h * on_derivatives[RigidField::slope_z],
                                      h * on_derivatives[RigidField::slope_x]}};
    double                      energy = square, on_axis = work[0];
    for (unsigned int i = 0; i < 3; ++i)
      {
        energy += 2. * q[i] * work[i];
        on_axis += D[Force::F_y][axial[i]] * q[i];
        for (unsigned int j = 0; j < 3; ++j)
          energy += q[i] * D[axial[i]][axial[j]] * q[j];
      }
    return (energy - on_axis * on_axis / D[Force::F_y][Force::F_y]) / 2. *
           C[Force::M_y][Force::M_y];
  }



  Voigt
  TwistStretch::strain(const SectionPoint &point) const
  {
    Voigt sum = stretch_of_fiber(section, point);
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      sum += relaxation[(*point.fields)[k]] * point.in_plane[k];
    return sum;
  }
} // namespace lamella
