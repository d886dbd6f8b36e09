// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/isostatic_support.h>
#include <lamella/conditions/stabilization.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The corners of the section half way along the axis of @p body.
    std::vector<Point<3>>
    farthest_section_points(const Body &body)
    {
      const Tensor<1, 3> half =
        0.5 * (centroid_of(body.surface_points("end")) -
               centroid_of(body.surface_points("start")));
      std::vector<Point<3>> corners;
      for (const SurfacePoint &point : farthest_points(body, "start"))
        corners.push_back(point.position + half);
      return corners;
    }



    /// The displacements of @p motion at @p points, the largest of them 1.
    std::vector<Tensor<1, 3>>
    displacements(const FreeMotion            &motion,
                  const Body                  &body,
                  const std::vector<Point<3>> &points)
    {
      std::vector<Tensor<1, 3>> all;
      double                    largest = 0.;
      for (const Point<3> &x : points)
        {
          all.push_back(motion.at(x, body));
          largest = std::max(largest, all.back().norm());
        }
      for (Tensor<1, 3> &displacement : all)
        displacement /= largest;
      return all;
    }
  } // namespace



  std::string
  name_of_isostatic_support(const std::string &name)
  {
    return "isostatic-" + name;
  }



  void
  clear_isostatic_motions(std::vector<Support> &supports)
  {
    for (Support &support : supports)
      if (support.isostatic)
        support.isostatic->motions.clear();
  }



  std::optional<BodyFunctional>
  row_of(const PotentialContact &place, const Bodies &bodies)
  {
    const Body &body  = *bodies[place.body];
    const auto  sides = body.locate({place.position});
    if (sides.front().empty())
      return {};
    const auto     u = body.rows({sides.front().front()}, undisplaced).front();
    BodyFunctional row;
    row.body = place.body;
    for (unsigned int c = 0; c < 3; ++c)
      row.row.add(u[c], place.normal[c]);
    row.row.compress();
    return row;
  }



  void
  find_isostatic_motions(std::vector<Support>                &supports,
                         const Bodies                        &bodies,
                         const std::vector<PotentialContact> &places)
  {
    clear_isostatic_motions(supports);
    std::vector<PrescribedFunctional> rows =
      prescribed_functionals(supports, bodies);
    for (const PotentialContact &place : places)
      if (const auto row = row_of(place, bodies))
        rows.emplace_back().row = *row;
    for (Support &support : supports)
      if (support.isostatic)
        support.isostatic->motions =
          free_rigid_motions(*bodies[support.isostatic->body],
                             support.isostatic->body,
                             rows);
  }



  std::vector<PrescribedFunctional>
  rows_of_isostatic_support(const IsostaticSupport &hold,
                            const unsigned int      support,
                            const Bodies           &bodies)
  {
    if (hold.motions.empty())
      return {};
    const Body                 &body   = *bodies[hold.body];
    const std::vector<Point<3>> points = farthest_section_points(body);
    const std::vector<Location> locations =
      locate_all(body, points, "Body " + body.name() + "/Isostatic support");
    const auto   u     = body.rows(locations, undisplaced);
    const double share = 1. / points.size();
    Point<3>     middle;
    for (const Point<3> &x : points)
      middle += share * x;
    std::vector<PrescribedFunctional> rows;
    for (const FreeMotion &motion : hold.motions)
      {
        PrescribedFunctional row;
        row.row.body = hold.body;
        row.support  = support;
        row.position = middle;
        const auto q = displacements(motion, body, points);
        for (unsigned int p = 0; p < points.size(); ++p)
          {
            for (unsigned int c = 0; c < 3; ++c)
              row.row.row.add(u[p][c], share * q[p][c]);
            row.direction += share * q[p];
            row.couple += share * cross_product_3d(points[p] - middle, q[p]);
          }
        row.row.row.compress();
        row.row.row.drop_below(arithmetic::rounding_of_sums);
        rows.push_back(row);
      }
    return rows;
  }



  void
  check_isostatic_balance(const std::vector<Support> &supports,
                          const Bodies               &bodies,
                          const BlockVector          &load)
  {
    for (const Support &support : supports)
      {
        if (!support.isostatic)
          continue;
        const Body               &body  = *bodies[support.isostatic->body];
        const Vector             &f     = load.block(support.isostatic->body);
        const std::vector<Vector> rigid = body.rigid_motions(undisplaced);
        for (const FreeMotion &motion : support.isostatic->motions)
          {
            Vector q(f.size());
            for (unsigned int m = 0; m < 6; ++m)
              q.add(motion.motion[m] / (m < 3 ? 1. : body.size()), rigid[m]);
            // Forces in the directions of the DoFs, and what cancels in one.
            double size = f.linfty_norm();
            for (DofIndex i = 0; i < f.size(); ++i)
              size += std::abs(f[i] * q[i]);
            if (std::abs(f * q) <= arithmetic::quadrature_tolerance * size)
              continue;
            Tensor<1, 3> force, moment;
            for (unsigned int c = 0; c < 3; ++c)
              {
                force[c]  = f * rigid[c];
                moment[c] = f * rigid[3 + c];
              }
            throw InputError(
              "Body " + body.name() + "/Isostatic support",
              "true",
              "conditions.loads-not-balanced: the loads on the body are not in "
              "equilibrium, and no support or contact prevents its " +
                motion.words + ": the resultant force of the loads is " +
                to_text(force) +
                ", their moment about the center of the body is " +
                to_text(moment),
              "Add a load that balances the others, a support, or a contact.");
          }
      }
  }
} // namespace lamella
