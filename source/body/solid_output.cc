// SPDX-License-Identifier: LGPL-2.1-or-later

// The fields of a solid at points, for probes, lines, contours and pictures.

#include <lamella/body/fields.h>
#include <lamella/body/solid.h>

namespace lamella
{
  using namespace dealii;

  FieldSample
  Solid::sample_at_element_point(const Location::Place &place,
                                 const Vector          &u) const
  {
    const Hexahedron::Nodes  nodes = nodes_of(place.cell);
    const HexahedronPoint    point = element.evaluate(nodes, place.unit);
    const std::vector<Voigt> B =
      element.strains(point, kinds[kind_of_cell[place.cell]].modes);
    const std::vector<double> v     = relative_displacements(place.cell, u);
    const DofIndex            first = 3 * mesh.cells()[place.cell].nodes[0];

    Tensor<1, 3> displacement;
    Voigt        strain;
    for (unsigned int c = 0; c < 3; ++c)
      displacement[c] = u[first + c];
    for (unsigned int d = 0; d < v.size(); ++d)
      {
        displacement[d % 3] += point.N[d / 3] * v[d];
        strain += v[d] * B[d];
      }

    return sample_of(displacement,
                     strain,
                     placement,
                     ply_axes(place.cell, point.position),
                     law_at(place.cell, place.unit, point.position));
  }



  FieldSample
  Solid::sample(const Location &location, const Vector &u) const
  {
    std::vector<FieldSample> samples;
    for (const Location::Place &place : location.places)
      samples.push_back(sample_at_element_point(place, u));
    return mean_sample(samples);
  }

} // namespace lamella
