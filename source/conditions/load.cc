// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/load.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/function_parser.h>

#include <cmath>
#include <deque>
#include <iostream>
#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The value of @p expression at @p x.
    class Expression
    {
    public:
      Expression(const std::string &expression, const std::string &what)
        : text(expression)
        , what(what)
      {
        const auto fail = [&](const std::string &why) {
          throw InputError(what + ": '" + expression +
                           "' is not an expression of x, y, z" + why +
                           ". Write it as for muParser, as in "
                           "-1000*sin(pi*y/2).");
        };
        // A comma outside of a function would make muParser take what follows.
        if (split(expression, ',').size() != 1)
          fail(" (a decimal point is '.')");
        // deal.II prints what muParser says before it throws; one message is
        // enough.
        std::ostringstream    discarded;
        std::streambuf *const standard_error =
          std::cerr.rdbuf(discarded.rdbuf());
        bool parses = true;
        try
          {
            parser.initialize("x,y,z",
                              expression,
                              {{"pi", numbers::PI}},
                              false);
            // deal.II parses at the first evaluation.
            parser.value(Point<3>());
          }
        catch (const ExceptionBase &)
          {
            parses = false;
          }
        std::cerr.rdbuf(standard_error);
        if (!parses)
          fail("");
      }

      double
      operator()(const Point<3> &x) const
      {
        const double value = parser.value(x);
        if (!std::isfinite(value))
          throw InputError(what + ": '" + text +
                           "' is not a finite number at " + to_text(x) +
                           ". Change the expression or where it applies.");
        return value;
      }

    private:
      FunctionParser<3> parser;
      std::string       text, what;
    };



    /// f . v += force . v(x) for the points of one body.
    void
    add_point_forces(const Body                      &body,
                     const std::vector<Location>     &locations,
                     const std::vector<Tensor<1, 3>> &forces,
                     Vector                          &f)
    {
      const auto rows = body.rows(locations, Quantity::displacement);
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          rows[i][c].add_to(f, forces[i][c]);
    }



    /// The expressions of a load.
    class LoadValues
    {
    public:
      explicit LoadValues(const Load &load)
        : what("Load " + load.name)
        , is_pressure(!load.pressure.empty())
      {
        if (is_pressure)
          expressions.emplace_back(load.pressure, what + ", Pressure");
        else
          for (const std::string &component : load.force)
            expressions.emplace_back(component, what + ", Force");
      }

      /// The load on @p region of @p body, integrated.
      PointForces
      on(const Region &region, const Body &body) const;

    private:
      Tensor<1, 3>
      force_at(const Point<3> &x) const
      {
        return Point<3>(expressions[0](x),
                        expressions[1](x),
                        expressions[2](x));
      }

      const std::string      what;
      const bool             is_pressure;
      std::deque<Expression> expressions;
    };



    PointForces
    LoadValues::on(const Region &region, const Body &body) const
    {
      PointForces result;
      switch (region.kind)
        {
          case Region::Kind::point:
            result.locations = locate_all(body, region.at, what);
            for (const Point<3> &x : region.at)
              result.forces.push_back(force_at(x));
            break;
          case Region::Kind::line:
            {
              locate_all(body, region.at, what);
              std::vector<Point<3>> points;
              for (const auto &[x, weight] :
                   body.line_quadrature(region.at[0], region.at[1]))
                {
                  points.push_back(x);
                  result.forces.push_back(weight * force_at(x));
                }
              result.locations = locate_all(body, points, what);
              break;
            }
          case Region::Kind::surface:
            check_surface(body, region.surface, what);
            for (const SurfacePoint &p :
                 body.surface_quadrature(region.surface))
              {
                result.locations.push_back(p.location);
                result.forces.push_back(
                  p.area * (is_pressure ?
                              -expressions[0](p.position) * p.normal :
                              force_at(p.position)));
              }
            break;
          default:
            Assert(false, ExcMessage("A load has no such region."));
        }
      return result;
    }
  } // namespace



  PointForces
  point_forces(const Load &load, const Region &region, const Body &body)
  {
    return LoadValues(load).on(region, body);
  }



  void
  add_load(const Load &load, const Bodies &bodies, BlockVector &f)
  {
    const LoadValues values(load);
    for (const Region &region : load.on)
      {
        const PointForces at = values.on(region, *bodies[region.body]);
        add_point_forces(*bodies[region.body],
                         at.locations,
                         at.forces,
                         f.block(region.body));
      }
  }



  std::vector<std::string>
  torques_left_out(const std::vector<Load> &loads, const Bodies &bodies)
  {
    std::vector<std::string> warnings;
    for (const Load &load : loads)
      for (const Region &region : load.on)
        for (const RigidMotion &missing :
             bodies[region.body]->missing_motions())
          {
            const Body       &body = *bodies[region.body];
            const PointForces at   = point_forces(load, region, body);
            const Point<3>    axis(missing[3], missing[4], missing[5]);
            double            torque = 0., size = 0.;
            for (unsigned int i = 0; i < at.forces.size(); ++i)
              {
                Tensor<1, 3> arm = at.locations[i].position - body.centre();
                arm -= (arm * axis) * axis;
                torque += cross_product_3d(arm, at.forces[i]) * axis;
                size += arm.norm() * at.forces[i].norm();
              }
            if (std::abs(torque) > 1e-6 * size)
              warnings.push_back(
                "load " + load.name + " twists body " + body.name() +
                " by a torque of " + to_text(torque) +
                " (force times length) about its axis; sections of its theory "
                "cannot turn, and the torque is left out. Use TE-N or LE-N to "
                "see what it does");
          }
    return warnings;
  }
} // namespace lamella
