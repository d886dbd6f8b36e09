// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/conditions/current_points.h>

namespace lamella
{
  using namespace dealii;

  CurrentPoints::CurrentPoints(const Body           &body,
                               std::vector<Location> locations)
    : body(body)
    , locations(std::move(locations))
  {
    if (!body.constraints_rotate())
      fixed = body.rows(this->locations, undisplaced);
  }



  std::vector<std::vector<LinearFunctional>>
  CurrentPoints::rows(const Vector &u) const
  {
    return fixed.empty() ? body.rows(locations, u) : fixed;
  }



  std::vector<Tensor<1, 3>>
  CurrentPoints::displacements(const Vector &u) const
  {
    return fixed.empty() ? body.displacements(locations, u) : changes(u, u);
  }



  void
  CurrentPoints::add_forces(const std::vector<Tensor<1, 3>> &forces,
                            const Vector                    &u,
                            Vector                          &f) const
  {
    const auto at = rows(u);
    for (unsigned int k = 0; k < at.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        at[k][c].add_to(f, forces[k][c]);
  }



  std::vector<Tensor<1, 3>>
  CurrentPoints::changes(const Vector &u, const Vector &w) const
  {
    const auto                at = rows(u);
    std::vector<Tensor<1, 3>> by(at.size());
    for (unsigned int k = 0; k < at.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        by[k][c] = at[k][c](w);
    return by;
  }



  void
  CurrentPoints::add_rotated_forces(const std::vector<Tensor<1, 3>> &forces,
                                    const double                     factor,
                                    const Vector                    &u,
                                    const Vector                    &w,
                                    Vector                          &f) const
  {
    for_each_rotation_block(forces,
                            factor,
                            u,
                            [&](const StiffnessBlock &block) {
                              block.add_product(w, f);
                            });
  }



  void
  CurrentPoints::for_each_rotation_block(
    const std::vector<Tensor<1, 3>> &forces,
    const double                     factor,
    const Vector                    &u,
    const BlockCallback             &use) const
  {
    body.for_each_block_of_forces(locations,
                                  forces,
                                  u,
                                  [&](const StiffnessBlock &block) {
                                    StiffnessBlock scaled = block;
                                    for (double &value : scaled.values)
                                      value *= factor;
                                    use(scaled);
                                  });
  }
} // namespace lamella
