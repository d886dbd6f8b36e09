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
  } // namespace



  void
  add_load(const Load &load, const Bodies &bodies, BlockVector &f)
  {
    const std::string      what = "Load " + load.name;
    std::deque<Expression> force;
    const bool             is_pressure = !load.pressure.empty();
    if (is_pressure)
      force.emplace_back(load.pressure, what + ", Pressure");
    else
      for (const std::string &component : load.force)
        force.emplace_back(component, what + ", Force");
    const auto force_at = [&force](const Point<3> &x) {
      return Point<3>(force[0](x), force[1](x), force[2](x));
    };

    for (const Region &region : load.on)
      {
        const Body               &body = *bodies[region.body];
        std::vector<Location>     locations;
        std::vector<Tensor<1, 3>> forces;
        switch (region.kind)
          {
            case Region::Kind::point:
              locations = locate_all(body, region.at, what);
              for (const Point<3> &x : region.at)
                forces.push_back(force_at(x));
              break;
            case Region::Kind::line:
              {
                locate_all(body, region.at, what);
                std::vector<Point<3>> points;
                for (const auto &[x, weight] :
                     body.line_quadrature(region.at[0], region.at[1]))
                  {
                    points.push_back(x);
                    forces.push_back(weight * force_at(x));
                  }
                locations = locate_all(body, points, what);
                break;
              }
            case Region::Kind::surface:
              check_surface(body, region.surface, what);
              for (const SurfacePoint &p :
                   body.surface_quadrature(region.surface))
                {
                  locations.push_back(p.location);
                  forces.push_back(p.area *
                                   (is_pressure ?
                                      -force[0](p.position) * p.normal :
                                      Tensor<1, 3>(force_at(p.position))));
                }
              break;
            default:
              Assert(false, ExcMessage("A load has no such region."));
          }
        add_point_forces(body, locations, forces, f.block(region.body));
      }
  }
} // namespace lamella
