// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/fields.h>
#include <lamella/conditions/couple.h>
#include <lamella/conditions/follower_pressure.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Forces that keep their direction on a body whose rows turn.
    class DeadForces : public FollowerLoad
    {
    public:
      DeadForces(const Body               &body,
                 std::vector<Location>     locations,
                 std::vector<Tensor<1, 3>> forces)
        : points(body, std::move(locations))
        , forces(std::move(forces))
      {}

      bool
      is_unsymmetric() const override
      {
        return false;
      }

      void
      add_forces(const double factor, const Vector &u, Vector &f) const override
      {
        points.add_forces(forces, factor, u, f);
      }

      void
      add_derivative(const double  factor,
                     const Vector &u,
                     const Vector &w,
                     Vector       &f) const override
      {
        points.add_rotated_forces(forces, factor, u, w, f);
      }

      void
      for_each_stiffness_block(const double         factor,
                               const Vector        &u,
                               const bool           with_values,
                               const BlockCallback &use) const override
      {
        // Within elements, whose tangent has the pattern.
        if (with_values)
          points.for_each_rotation_block(forces, -factor, u, use);
      }

    private:
      const CurrentPoints             points;
      const std::vector<Tensor<1, 3>> forces;
    };



    class Heat : public FollowerLoad
    {
    public:
      explicit Heat(const Body &body)
        : body(body)
      {}

      bool
      is_unsymmetric() const override
      {
        return false;
      }

      void
      add_forces(const double factor, const Vector &u, Vector &f) const override
      {
        Vector full(f.size());
        body.add_thermal_load(u, full);
        f.add(factor, full);
      }

      void
      add_derivative(const double  factor,
                     const Vector &u,
                     const Vector &w,
                     Vector       &f) const override
      {
        Vector full(f.size());
        body.for_each_thermal_block(u, [&](const StiffnessBlock &block) {
          block.add_product(w, full);
        });
        f.add(factor, full);
      }

      void
      for_each_stiffness_block(const double         factor,
                               const Vector        &u,
                               const bool           with_values,
                               const BlockCallback &use) const override
      {
        // Within elements, whose tangent has the pattern.
        if (with_values)
          body.for_each_thermal_block(u, [&](StiffnessBlock block) {
            for (double &value : block.values)
              value *= -factor;
            use(block);
          });
      }

    private:
      const Body &body;
    };



    std::vector<Location>
    locations_of(const std::vector<SurfacePoint> &points)
    {
      std::vector<Location> locations;
      for (const SurfacePoint &point : points)
        locations.push_back(point.location);
      return locations;
    }



    class FollowerCouple : public FollowerLoad
    {
    public:
      FollowerCouple(const Load &load, const Region &region, const Body &body)
        : couple(load, region, body)
        , points(body, locations_of(couple.points()))
      {}
      void
      add_forces(const double factor, const Vector &u, Vector &f) const override
      {
        points.add_forces(couple.forces(moved(u)), factor, u, f);
      }

      void
      add_derivative(const double  factor,
                     const Vector &u,
                     const Vector &w,
                     Vector       &f) const override
      {
        const std::vector<Point<3>> x = moved(u);
        const auto forces             = couple.change(x, points.changes(u, w));
        if (is_root_process())
          points.add_forces(forces, factor, u, f);
        points.add_rotated_forces(couple.forces(x), factor, u, w, f);
      }

      void
      for_each_stiffness_block(const double         factor,
                               const Vector        &u,
                               const bool           with_values,
                               const BlockCallback &use) const override
      {
        const RowTransformation to_dofs(points.rows(u));
        if (!with_values)
          return is_root_process() ? use(to_dofs.pattern()) : void();
        const std::vector<Point<3>>  x        = moved(u);
        const Couple::CoupleRotation rotation = couple.rotation_of(x);
        StiffnessBlock               block    = to_dofs.pattern();
        const unsigned int           n        = block.rows.size();
        block.values.assign(n * n, 0.);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const auto spin    = to_dofs.form(rotation.spin[k]),
                       stretch = to_dofs.form(rotation.stretch[k]);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                block.values[i * n + j] +=
                  0.5 * factor * (spin[i] * stretch[j] + stretch[i] * spin[j]);
          }
        if (is_root_process())
          use(block);
        points.for_each_rotation_block(couple.forces(x), -factor, u, use);
      }

    private:
      /// Where @p u moves the points to.
      std::vector<Point<3>>
      moved(const Vector &u) const
      {
        const std::vector<Tensor<1, 3>> by = points.displacements(u);
        std::vector<Point<3>>           x;
        for (unsigned int k = 0; k < by.size(); ++k)
          x.push_back(couple.points()[k].position + by[k]);
        return x;
      }

      const Couple        couple;
      const CurrentPoints points;
    };



    /// Throws InputError unless the forces of @p turning at the start are those
    /// that @p load has on @p region of @p body where it is dead, whose
    /// integration adapts to what varies.
    void
    check_start(const FollowerLoad &rotation,
                const Load         &load,
                const Region       &region,
                const Body         &body)
    {
      Vector rest(body.n_dofs()), start(body.n_dofs()),
        dead_load(body.n_dofs());
      rotation.add_forces(1., rest, start);
      add_point_forces(body, point_forces(load, region, body), dead_load);
      start -= dead_load;
      if (start.l2_norm() > arithmetic::same_value * dead_load.l2_norm())
        throw InputError("Load " + load.name + "/Pressure",
                         load.pressure.text() + ", follows",
                         "conditions.follower-not-smooth: a follower pressure "
                         "must be smooth within each axis element",
                         "Use shorter elements where the pressure varies (Axis "
                         "breaks), or remove 'follows'.");
    }
  } // namespace



  bool
  is_follower_load(const Load &load)
  {
    return load.couple || load.is_follower;
  }



  bool
  depends_on_state(const Load &load, const Body &body)
  {
    // Heat is one of the body (turning_heat()).
    return load.temperature.empty() &&
           (body.constraints_rotate() ||
            (body.has_finite_rotations() && is_follower_load(load)));
  }



  std::unique_ptr<FollowerLoad>
  follower_load(const Load &load, const Region &region, const Body &body)
  {
    if (load.couple)
      return std::make_unique<FollowerCouple>(load, region, body);
    if (!load.is_follower)
      {
        const PointForces at = point_forces(load, region, body);
        return std::make_unique<DeadForces>(body, at.locations, at.forces);
      }
    auto pressure = make_follower_pressure(load, region, body);
    check_start(*pressure, load, region, body);
    return pressure;
  }



  std::unique_ptr<FollowerLoad>
  turning_heat(const Body &body)
  {
    return body.has_finite_rotations() && body.is_heated() ?
             std::make_unique<Heat>(body) :
             nullptr;
  }



  std::unique_ptr<FollowerLoad>
  follower_weight(const Tensor<1, 3> &acceleration, const Body &body)
  {
    if (!body.constraints_rotate())
      return nullptr;
    std::vector<Location>     locations;
    std::vector<Tensor<1, 3>> forces;
    for_each_cell_by_weight(
      body,
      acceleration,
      [&](const std::vector<Location>     &of_cell,
          const std::vector<Tensor<1, 3>> &of_forces) {
        locations.insert(locations.end(), of_cell.begin(), of_cell.end());
        forces.insert(forces.end(), of_forces.begin(), of_forces.end());
      },
      true);
    return std::make_unique<DeadForces>(body, locations, forces);
  }
} // namespace lamella
