// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/frame_strains.h>
#include <lamella/conditions/isostatic_support.h>
#include <lamella/conditions/support.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  using namespace dealii;

  Tensor<1, 3>
  scene_axis(const unsigned int c)
  {
    Tensor<1, 3> axis;
    axis[c] = 1.;
    return axis;
  }



  namespace
  {
    /// @p place on @p region, if a row of @p support there follows rotation.
    std::optional<Location>
    follower_place(const Support  &support,
                   const Region   &region,
                   const Location &place)
    {
      if (support.rotation)
        return place;
      const bool is_section = region.surface == "start" ||
                              region.surface == "end" ||
                              region.surface == "ends";
      return is_section ? std::nullopt : std::make_optional(place);
    }



    /// The row of the component along @p n of what has the three rows @p u.
    LinearFunctional
    along(const std::vector<LinearFunctional> &u, const Tensor<1, 3> &n)
    {
      LinearFunctional row;
      for (unsigned int c = 0; c < 3; ++c)
        if (n[c] != 0.)
          row.add(u[c], n[c]);
      row.compress();
      row.drop_below(arithmetic::rounding_of_sums);
      return row;
    }



    /// The rows of n . u = value on the surface @p region of @p body.
    void
    add_normal_rows(const Body                        &body,
                    const Region                      &region,
                    const Support                     &support,
                    const unsigned int                 number,
                    std::vector<PrescribedFunctional> &rows)
    {
      const std::string path = "Support " + support.name;
      check_surface(body, region.surface, path + "/On");
      std::vector<Location>     places;
      std::vector<Tensor<1, 3>> normals;
      for (const SurfacePoint &point : body.surface_points(region.surface))
        {
          if (point.corner)
            throw InputError(
              path + "/Normal displacement",
              "",
              "conditions.normal-at-corner: surface '" + region.surface +
                "' of body '" + body.name() + "' has a corner at " +
                to_text(point.position) + ", where it has no normal",
              "Name surfaces without corners in On, or prescribe u instead.");
          places.push_back(point.location);
          normals.push_back(point.normal);
        }
      const auto all = body.rows(places, undisplaced);
      for (unsigned int i = 0; i < places.size(); ++i)
        rows.push_back({{region.body, along(all[i], normals[i])},
                        *support.normal,
                        number,
                        normals[i],
                        places[i].position,
                        {},
                        support.history,
                        follower_place(support, region, places[i])});
    }



    /// The places that @p support holds on @p region of @p body.
    std::vector<Location>
    constrained_points(const Body    &body,
                       const Region  &region,
                       const Support &support)
    {
      return region_locations(body,
                              region,
                              "Support " + support.name +
                                (region.at.empty() ? "/On" : "/At"));
    }



    /// The rows of the components of u that @p support, number @p number,
    /// prescribes on @p region, with its @p turn if it has one.
    void
    add_component_rows(const Body                         &body,
                       const Region                       &region,
                       const Support                      &support,
                       const std::optional<RigidRotation> &rotation,
                       const unsigned int                  number,
                       std::vector<PrescribedFunctional>  &rows)
    {
      const std::vector<Location> places =
        constrained_points(body, region, support);
      auto all = body.rows(places, undisplaced);
      // The location of a given point has rounding errors: without small
      // weights at other nodes, the rows of a node involve only its own DoFs.
      for (std::vector<LinearFunctional> &components : all)
        for (LinearFunctional &row : components)
          row.drop_below(arithmetic::rounding_of_sums);
      for (unsigned int i = 0; i < places.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          if (support.u[c])
            rows.push_back({{region.body, all[i][c]},
                            rotation ?
                              rotation->rate(0., places[i].position)[c] :
                              *support.u[c],
                            number,
                            scene_axis(c),
                            places[i].position,
                            {},
                            support.history,
                            follower_place(support, region, places[i]),
                            rotation});
    }



    /// Six rigid motions in words, without components below 1/100.
    std::string
    describe(const std::array<double, 6> &motion)
    {
      static const std::array<const char *, 6> names{{"translation along x",
                                                      "translation along y",
                                                      "translation along z",
                                                      "rotation about x",
                                                      "rotation about y",
                                                      "rotation about z"}};
      double                                   largest = 0.;
      for (const double m : motion)
        largest = std::max(largest, std::abs(m));
      std::vector<std::string> parts;
      for (unsigned int m = 0; m < 6; ++m)
        if (std::abs(motion[m]) > 0.01 * largest)
          parts.emplace_back(names[m]);
      return joined(parts, " with ");
    }



    /// Combines @p motions so that each has a rotation, or failing that a
    /// translation, that no other has: those are motions that a user can see.
    /// (At most six rows in echelon form, which no factorization is.)
    void
    reduce_to_echelon(std::vector<std::array<double, 6>> &motions)
    {
      unsigned int done = 0;
      for (const unsigned int m : {3, 4, 5, 0, 1, 2})
        {
          const auto largest =
            std::max_element(motions.begin() + done,
                             motions.end(),
                             [m](const auto &a, const auto &b) {
                               return std::abs(a[m]) < std::abs(b[m]);
                             });
          if (largest == motions.end() ||
              std::abs((*largest)[m]) < arithmetic::dependency_tolerance)
            continue;
          std::swap(*largest, motions[done]);
          const std::array<double, 6> pivot = motions[done];
          for (unsigned int k = 0; k < motions.size(); ++k)
            {
              const double factor = motions[k][m] / pivot[m];
              if (k != done)
                for (unsigned int c = 0; c < 6; ++c)
                  motions[k][c] -= factor * pivot[c];
            }
          ++done;
        }
    }



    /// Singular values of six columns, descending, and right singular vectors.
    struct Folded
    {
      std::array<double, 6>      singular_values;
      std::array<RigidMotion, 6> directions;
      std::vector<RigidMotion>   rows;
    };

    /// A Gram matrix would square the conditioning, and a decomposition of all
    /// rows at once costs their number squared; S V^T of some rows represents
    /// them.
    Folded
    folded(const std::vector<RigidMotion> &rows)
    {
      // Six zero rows make the matrix tall enough.
      LAPACKFullMatrix<double> matrix(rows.size() + 6, 6);
      for (unsigned int r = 0; r < rows.size(); ++r)
        for (unsigned int m = 0; m < 6; ++m)
          matrix(r, m) = rows[r][m];
      matrix.compute_svd();
      Folded result;
      for (unsigned int k = 0; k < 6; ++k)
        {
          result.singular_values[k] = matrix.singular_value(k);
          result.rows.emplace_back();
          for (unsigned int m = 0; m < 6; ++m)
            {
              result.directions[k][m] = matrix.get_svd_vt()(k, m);
              result.rows[k][m] =
                result.singular_values[k] * result.directions[k][m];
            }
        }
      return result;
    }
  } // namespace



  RigidRotation
  rigid_rotation(const Support &support, const Bodies &bodies)
  {
    RigidRotation rotation;
    for (unsigned int c = 0; c < 3; ++c)
      rotation.translation[c] = *support.u[c];
    rotation.rotation = *support.rotation;
    if (support.about)
      {
        rotation.about = *support.about;
        return rotation;
      }
    std::vector<Point<3>> points;
    for (const Region &region : support.on)
      if (!region.surface.empty())
        {
          // More than what it takes to hold it.
          check_surface(*bodies[region.body],
                        region.surface,
                        "Support " + support.name + "/On");
          for (const SurfacePoint &point :
               bodies[region.body]->surface_points(region.surface))
            points.push_back(point.position);
        }
      else
        for (const Location &place :
             constrained_points(*bodies[region.body], region, support))
          points.push_back(place.position);
    const BoundingBox<3> box(points);
    rotation.about     = box.center();
    const auto corners = box.get_boundary_points();
    if (corners.first.distance(corners.second) == 0.)
      throw InputError("Support " + support.name + "/Rotation",
                       to_text(rotation.rotation),
                       "conditions.rotation-of-point: a rotation of a single "
                       "point about itself has no effect",
                       "Write the center in About, or name a surface in On.");
    return rotation;
  }



  Tensor<1, 3>
  RigidRotation::displacement(const double s, const Point<3> &X) const
  {
    const Tensor<1, 3> arm = X - about;
    return s * translation + rotation_of(quaternion_of(s * rotation)) * arm -
           arm;
  }



  Tensor<1, 3>
  RigidRotation::rate(const double s, const Point<3> &X) const
  {
    return translation +
           cross_product_3d(rotation,
                            rotation_of(quaternion_of(s * rotation)) *
                              (X - about));
  }



  std::pair<PrescribedFunctional, double>
  row_at(PrescribedFunctional prescribed, const Body &body, const Vector &u)
  {
    if (!prescribed.location)
      return {prescribed, prescribed.row.row(u)};
    const std::vector<Location> at{*prescribed.location};
    if (prescribed.rotation)
      prescribed.direction = body.rotation_at(at[0], u) * prescribed.direction;
    prescribed.row.row = along(body.rows(at, u)[0], prescribed.direction);
    return {prescribed, prescribed.direction * body.displacements(at, u)[0]};
  }



  std::vector<PrescribedFunctional>
  prescribed_functionals(const std::vector<Support> &supports,
                         const Bodies               &bodies)
  {
    std::vector<PrescribedFunctional> rows;
    for (unsigned int s = 0; s < supports.size(); ++s)
      {
        const Support &support = supports[s];
        if (support.isostatic)
          for (const PrescribedFunctional &row :
               rows_of_isostatic_support(*support.isostatic, s, bodies))
            rows.push_back(row);
        std::optional<RigidRotation> rotation;
        if (support.rotation)
          rotation = rigid_rotation(support, bodies);
        for (const Region &region : support.on)
          if (support.normal)
            add_normal_rows(*bodies[region.body], region, support, s, rows);
          else
            add_component_rows(
              *bodies[region.body], region, support, rotation, s, rows);
      }
    return rows;
  }



  Tensor<1, 3>
  FreeMotion::at(const Point<3> &x, const Body &body) const
  {
    const Tensor<1, 3> rotation =
      Point<3>(motion[3], motion[4], motion[5]) / body.size();
    return Point<3>(motion[0], motion[1], motion[2]) +
           cross_product_3d(rotation, x - body.center());
  }



  std::vector<FreeMotion>
  free_rigid_motions(const Body                              &body,
                     const unsigned int                       index,
                     const std::vector<PrescribedFunctional> &rows)
  {
    const std::vector<Vector> motions = body.rigid_motions(undisplaced);
    std::vector<RigidMotion>  values  = body.omitted_rigid_motions();
    for (const PrescribedFunctional &prescribed : rows)
      if (prescribed.row.body == index)
        {
          values.emplace_back();
          for (unsigned int m = 0; m < 6; ++m)
            values.back()[m] =
              prescribed.row.row(motions[m]) / (m < 3 ? 1. : body.size());
          if (values.size() == 60)
            values = folded(values).rows;
        }

    const Folded             held = folded(values);
    std::vector<RigidMotion> null_space;
    for (unsigned int k = 0; k < 6; ++k)
      if (!(held.singular_values[k] > 1e-8 * held.singular_values[0]))
        null_space.push_back(held.directions[k]);
    reduce_to_echelon(null_space);
    std::vector<FreeMotion> free;
    for (const RigidMotion &motion : null_space)
      free.push_back({motion, describe(motion)});
    return free;
  }
} // namespace lamella
