// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/pointwise_section_operator.h>
#include <lamella/section/product_section_operator.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations)
  {
    FieldParts parts;
    for (LAPACKFullMatrix<double> &part : parts)
      part.reinit(n_fields, n_stations);
    return parts;
  }



  SectionForces
  on_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces)
  {
    SectionForces result;
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      result.work[p] = space.on_list(list, forces.work[p]);
    result.energy = forces.energy;
    return result;
  }



  double
  SectionOperator::largest_rotation(const FieldParts &q) const
  {
    FieldParts all;
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      all[p] = space.in_section(list, q[p]);
    const auto &points  = space.section().integration_points();
    double      largest = 0.;
    for (unsigned int s = 0; s < points.size(); s += stride)
      for (unsigned int k = 0; k < all[FieldPart::value].n(); ++k)
        {
          const SectionPoint &point = points[s];
          Tensor<1, 3>        slope;
          double              twist = 0., strain_xy = 0., strain_yz = 0.;
          for (unsigned int a = 0; a < point.fields->size(); ++a)
            {
              const unsigned int alpha = (*point.fields)[a];
              const double       shear = all[FieldPart::shear_value](alpha, k),
                           along       = all[FieldPart::derivative](alpha, k);
              slope += along * point.value[a];
              twist += all[FieldPart::value](alpha, k) * point.twist[a];
              strain_xy +=
                shear * point.in_plane[a][3] + along * point.along[a][3];
              strain_yz +=
                shear * point.in_plane[a][5] + along * point.along[a][5];
            }
          // curl u / 2 with d u_y / dz = gamma_yz - d u_z / dy and so on.
          const Point<3> rotation(slope[2] - 0.5 * strain_yz,
                                  twist,
                                  0.5 * strain_xy - slope[0]);
          largest = std::max(largest, rotation.norm());
        }
    return largest;
  }



  std::unique_ptr<const SectionOperator>
  make_section_operator(const SectionSpace       &space,
                        std::vector<unsigned int> list,
                        const bool                assumed_shear)
  {
    if (ProductSectionOperator::is_possible(space, list, assumed_shear))
      return std::make_unique<ProductSectionOperator>(space,
                                                      std::move(list),
                                                      assumed_shear);
    return std::make_unique<PointwiseSectionOperator>(space, std::move(list));
  }
} // namespace lamella
