// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/conditions/couple.h>
#include <lamella/conditions/following_pressure.h>
#include <lamella/conditions/rows_to_dofs.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    class TurningCouple : public TurningLoad
    {
    public:
      TurningCouple(const Load &load, const Region &region, const Body &body);
      void
      add_forces(const double  factor,
                 const Vector &u,
                 Vector       &f) const override;
      void
      add_derivative(const double  factor,
                     const Vector &u,
                     const Vector &w,
                     Vector       &f) const override;
      void
      for_each_stiffness_block(
        const double                                       factor,
        const Vector                                      &u,
        const bool                                         with_values,
        const std::function<void(const StiffnessBlock &)> &use) const override;

    private:
      /// Where @p u moves the points to.
      std::vector<Point<3>>
      moved(const Vector &u) const;

      const Couple                  couple;
      std::vector<std::vector<Row>> rows;
    };



    TurningCouple::TurningCouple(const Load   &load,
                                 const Region &region,
                                 const Body   &body)
      : couple(load, region, body)
    {
      std::vector<Location> locations;
      for (const SurfacePoint &point : couple.points())
        locations.push_back(point.location);
      rows = body.rows(locations, Quantity::displacement);
    }



    std::vector<Point<3>>
    TurningCouple::moved(const Vector &u) const
    {
      std::vector<Point<3>> x;
      for (unsigned int k = 0; k < rows.size(); ++k)
        {
          x.push_back(couple.points()[k].position);
          for (unsigned int c = 0; c < 3; ++c)
            x.back()[c] += rows[k][c](u);
        }
      return x;
    }



    void
    TurningCouple::add_forces(const double  factor,
                              const Vector &u,
                              Vector       &f) const
    {
      const std::vector<Tensor<1, 3>> forces = couple.forces(moved(u));
      for (unsigned int k = 0; k < rows.size(); ++k)
        for (unsigned int c = 0; c < 3; ++c)
          rows[k][c].add_to(f, factor * forces[k][c]);
    }



    void
    TurningCouple::add_derivative(const double  factor,
                                  const Vector &u,
                                  const Vector &w,
                                  Vector       &f) const
    {
      std::vector<Tensor<1, 3>> by(rows.size());
      for (unsigned int k = 0; k < rows.size(); ++k)
        for (unsigned int c = 0; c < 3; ++c)
          by[k][c] = rows[k][c](w);
      const std::vector<Tensor<1, 3>> forces = couple.change(moved(u), by);
      for (unsigned int k = 0; k < rows.size(); ++k)
        for (unsigned int c = 0; c < 3; ++c)
          rows[k][c].add_to(f, factor * forces[k][c]);
    }



    void
    TurningCouple::for_each_stiffness_block(
      const double                                       factor,
      const Vector                                      &u,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const
    {
      const RowsToDofs to_dofs(rows);
      if (!with_values)
        return use(to_dofs.pattern());
      const Couple::Turning turning = couple.turning(moved(u));
      StiffnessBlock        block   = to_dofs.pattern();
      const unsigned int    n       = block.rows.size();
      block.values.assign(n * n, 0.);
      for (unsigned int k = 0; k < 3; ++k)
        {
          const auto spin    = to_dofs.form(turning.spin[k]),
                     stretch = to_dofs.form(turning.stretch[k]);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              block.values[i * n + j] +=
                0.5 * factor * (spin[i] * stretch[j] + stretch[i] * spin[j]);
        }
      use(block);
    }



    /// Throws InputError unless the forces of @p turning at the start are those
    /// that @p load has on @p region of @p body where it is dead, whose
    /// integration adapts to what varies.
    void
    check_start(const TurningLoad &turning,
                const Load        &load,
                const Region      &region,
                const Body        &body)
    {
      Vector rest(body.n_dofs()), start(body.n_dofs()), dead(body.n_dofs());
      turning.add_forces(1., rest, start);
      add_point_forces(body, point_forces(load, region, body), dead);
      start -= dead;
      if (start.l2_norm() > arithmetic::alike * dead.l2_norm())
        throw InputError("Load " + load.name + "/Pressure",
                         load.pressure.text() + ", follows",
                         "a pressure that follows must be smooth within "
                         "elements",
                         "Put shorter elements where it varies (Axis breaks), "
                         "or leave out 'follows'.");
    }
  } // namespace



  bool
  turns_along(const Load &load)
  {
    return load.couple || load.follows;
  }



  std::unique_ptr<TurningLoad>
  turning_load(const Load &load, const Region &region, const Body &body)
  {
    if (load.couple)
      return std::make_unique<TurningCouple>(load, region, body);
    auto pressure = std::make_unique<FollowingPressure>(load, region, body);
    check_start(*pressure, load, region, body);
    return pressure;
  }
} // namespace lamella
