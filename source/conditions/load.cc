// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/facet_map.h>
#include <lamella/body/surface_topology.h>
#include <lamella/conditions/couple.h>
#include <lamella/conditions/expression.h>
#include <lamella/conditions/load.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // The displacements of an element follow a load if its Gauss rule has an
    // error below this multiple of the negligible error.
    constexpr double followed = 10.;



    /// Adds @p force, constant per unit of the square of an affine @p facet, at
    /// as few points as integrate its trace functions exactly.
    void
    add_constant(const Body         &body,
                 const SurfaceFacet &facet,
                 const Tensor<1, 3> &force,
                 PointForces        &result)
    {
      const QGauss<1> s(facet.trace_degree_s / 2 + 1),
        t(facet.trace_degree_t / 2 + 1);
      for (unsigned int j = 0; j < t.size(); ++j)
        for (unsigned int i = 0; i < s.size(); ++i)
          {
            const Point<2> st(s.point(i)[0], t.point(j)[0]);
            result.locations.push_back(body.surface_point(facet, st).location);
            result.forces.push_back(s.weight(i) * t.weight(j) * force);
          }
    }



    /// What is to be said of one region of the load @p name.
    void
    add_notes(const std::string        &name,
              const PointForces        &at,
              std::vector<std::string> &notes)
    {
      const LoadMoments &integral = at.integral;
      const double       negligible =
        arithmetic::quadrature_tolerance * integral.size;
      if (integral.error > negligible)
        notes.push_back("conditions.integral-uncertain: load " + name +
                        ": its numerical integral has a relative error of " +
                        to_text(integral.error / integral.size, 2) +
                        ". Put element boundaries where the load begins and "
                        "ends (Axis breaks), or write a smoother expression");
      if (!integral.of_cells.empty() && integral.size == 0.)
        notes.push_back(
          "conditions.load-zero: load " + name +
          " is zero at all sampled points of its region (On). If this is a "
          "mistake, correct position or width of the load in its expression");
      if (integral.unresolved > followed * negligible)
        notes.push_back(
          "conditions.load-within-element: load " + name +
          " varies within the axis element at " + to_text(at.place) +
          " faster than the displacements of this element. Its resultant and "
          "work are correct, but stresses near it are those of a load spread "
          "over the element. Use shorter elements there (Axis breaks)");
    }



    /// A torque about the axis of a body whose theory has no rotation about it
    /// (EBBT, TBT) does no work on its displacements and is lost.
    void
    add_torque_note(const std::string        &name,
                    const PointForces        &at,
                    const Body               &body,
                    std::vector<std::string> &notes)
    {
      for (const RigidMotion &missing : body.omitted_rigid_motions())
        {
          const Point<3> axis(missing[3], missing[4], missing[5]);
          double         torque = 0., size = 0.;
          for (unsigned int i = 0; i < at.forces.size(); ++i)
            {
              Tensor<1, 3> arm = at.locations[i].position - body.center();
              arm -= (arm * axis) * axis;
              torque += cross_product_3d(arm, at.forces[i]) * axis;
              size += arm.norm() * at.forces[i].norm();
            }
          if (std::abs(torque) > arithmetic::quadrature_tolerance * size)
            notes.push_back(
              "conditions.torque-omitted: load " + name + " twists body " +
              body.name() + " by a torque of " + to_text(torque) +
              " (force times length) about its axis. The theory of "
              "the body has no torsion, so this torque is omitted. "
              "Use Theory = TE-N or LE-N to include the torque");
        }
    }
  } // namespace



  /// Adds @p moments, of the trace functions of @p facet, at their nodes.
  void
  add_moments(const Body                      &body,
              const SurfaceFacet              &facet,
              const std::vector<Tensor<1, 3>> &moments,
              PointForces                     &result)
  {
    const QGaussLobatto<1> s(facet.trace_degree_s + 1),
      t(facet.trace_degree_t + 1);
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        {
          const Point<2> st(s.point(i)[0], t.point(j)[0]);
          result.locations.push_back(body.surface_point(facet, st).location);
          result.forces.push_back(moments[j * s.size() + i]);
        }
  }



  /// A load that is integrated.
  class LoadValues
  {
  public:
    explicit LoadValues(const Load &load)
      : path("Load " + load.name)
      , traction(load)
      , is_constant(traction.is_constant())
    {}

    /// The load on @p region of @p body, integrated.
    PointForces
    on(const Region &region, const Body &body) const
    {
      PointForces result;
      switch (region.kind)
        {
          case Region::Kind::point:
            at_points(region, body, result);
            break;
          case Region::Kind::line:
            along_line(region, body, result);
            break;
          case Region::Kind::surface:
            on_surface(region, body, result);
            break;
          default:
            Assert(false, ExcMessage("A load has no such region."));
        }
      if (is_constant)
        result.integral = {};
      return result;
    }

  private:
    /// Of a line or a point, which have no normal.
    Tensor<1, 3>
    force_at(const Point<3> &x) const
    {
      return traction(x, Tensor<1, 3>());
    }

    void
    at_points(const Region &region, const Body &body, PointForces &result) const
    {
      result.locations = locate_all(body, region.at, path + "/At");
      for (const Point<3> &x : region.at)
        result.forces.push_back(force_at(x));
    }

    void
    along_line(const Region &region,
               const Body   &body,
               PointForces  &result) const
    {
      const Point<3> &a = region.at[0], &b = region.at[1];
      locate_all(body, region.at, path + "/At");
      const std::vector<double> breaks = body.line_breaks(a, b);
      const unsigned int        degree = body.line_degree(a, b);
      const auto position = [&](const unsigned int piece, const double s) {
        return a + (breaks[piece] + s * (breaks[piece + 1] - breaks[piece])) *
                     (b - a);
      };
      std::vector<LoadCell> cells;
      for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
        {
          const double length = (breaks[k + 1] - breaks[k]) * a.distance(b);
          cells.push_back({[this, position, k, length](const Point<2> &s) {
                             return length * force_at(position(k, s[0]));
                           },
                           {{degree, 0}},
                           {{length, 0.}}});
        }
      result.integral = load_moments(cells);
      const QGaussLobatto<1> nodes(degree + 1);
      std::vector<Point<3>>  points;
      for (unsigned int k = 0; k < cells.size(); ++k)
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            points.push_back(position(k, nodes.point(i)[0]));
            result.forces.push_back(result.integral.of_cells[k][i]);
          }
      result.locations = locate_all(body, points, path);
      result.place     = position(result.integral.cell, 0.5);
    }

    void
    on_surface(const Region &region,
               const Body   &body,
               PointForces  &result) const
    {
      check_surface(body, region.surface, path + "/On");
      const std::vector<SurfaceFacet> all =
        surface_facets(body, region.surface);
      std::vector<const SurfaceFacet *> facets;
      std::vector<LoadCell>             cells;
      for (const SurfaceFacet &facet : all)
        {
          const FacetMap map(body, facet);
          // Force per unit of the square: |n| is the area per unit.
          const auto force = [this, map](const Point<2> &st) {
            const FacetMap::Place place = map(st);
            const Tensor<1, 3>    n     = map.outward(place);
            const double          area  = n.norm();
            return area * traction(place.position, n / area);
          };
          if (is_constant && map.is_affine())
            {
              add_constant(body, facet, force(Point<2>()), result);
              continue;
            }
          facets.push_back(&facet);
          cells.push_back({force,
                           {{facet.trace_degree_s, facet.trace_degree_t}},
                           {{facet.corners[0].distance(facet.corners[1]),
                             facet.corners[0].distance(facet.corners[2])}}});
        }
      result.integral = load_moments(cells);
      for (unsigned int k = 0; k < facets.size(); ++k)
        add_moments(body, *facets[k], result.integral.of_cells[k], result);
      if (!facets.empty())
        result.place =
          body.surface_point(*facets[result.integral.cell], {0.5, 0.5})
            .position;
    }

    const std::string path;
    const Traction    traction;
    const bool        is_constant;
  };



  PointForces
  point_forces(const Load &load, const Region &region, const Body &body)
  {
    PointForces at = load.couple ? Couple(load, region, body).dead_load() :
                                   LoadValues(load).on(region, body);
    for (unsigned int k = 0; k < at.forces.size(); ++k)
      {
        at.force += at.forces[k];
        at.moment += cross_product_3d(at.locations[k].position, at.forces[k]);
      }
    return at;
  }



  void
  add_point_forces(const Body &body, const PointForces &at, Vector &f)
  {
    const auto rows = body.rows(at.locations, undisplaced);
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        rows[i][c].add_to(f, at.forces[i][c]);
  }



  LoadResultant
  add_load(const Load &load, const Bodies &bodies, BlockVector &f)
  {
    LoadResultant result;
    result.name = load.name;
    // Bodies that are heated have no force of it.
    result.is_temperature = !load.temperature.empty();
    if (result.is_temperature)
      return result;
    for (const Region &region : load.on)
      {
        const Body       &body = *bodies[region.body];
        const PointForces at   = point_forces(load, region, body);
        add_point_forces(body, at, f.block(region.body));
        result.force += at.force;
        result.moment += at.moment;
        add_torque_note(load.name, at, body, result.notes);
        add_notes(load.name, at, result.notes);
      }
    return result;
  }



  void
  distribute_total_forces(std::vector<Load> &loads, const Bodies &bodies)
  {
    for (Load &load : loads)
      {
        if (!load.total)
          continue;
        Load unit   = load;
        unit.force  = {{1., 0., 0.}};
        double size = 0.;
        for (const Region &region : load.on)
          size += point_forces(unit, region, *bodies[region.body]).force[0];
        for (unsigned int c = 0; c < 3; ++c)
          load.force[c] = (*load.total)[c] / size;
      }
  }



  struct Traction::Values
  {
    bool is_pressure = false;
    /// One of a pressure, three of a force; a deque, for they do not move.
    std::deque<Expression> expressions;
  };



  Traction::Traction(const Load &load)
    : values(std::make_unique<Values>())
  {
    const std::string path = "Load " + load.name;
    values->is_pressure    = !load.pressure.empty();
    if (values->is_pressure)
      {
        const Entry entry(path + "/Pressure", load.pressure.text());
        values->expressions.emplace_back(entry.text(), entry);
        return;
      }
    const auto &[fx, fy, fz] = load.force;
    const Entry entry(path + "/Force",
                      joined({fx.text(), fy.text(), fz.text()}));
    for (const Formula &component : load.force)
      values->expressions.emplace_back(component.text(), entry);
  }



  Traction::~Traction() = default;



  Traction::Traction(Traction &&) noexcept = default;



  Tensor<1, 3>
  Traction::operator()(const Point<3> &x, const Tensor<1, 3> &normal) const
  {
    const auto &value = values->expressions;
    if (values->is_pressure)
      return -value[0](x) * normal;
    return Point<3>(value[0](x), value[1](x), value[2](x));
  }



  bool
  Traction::is_constant() const
  {
    return std::all_of(values->expressions.begin(),
                       values->expressions.end(),
                       [](const Expression &e) { return e.is_constant(); });
  }



  // Loads of whole bodies: heat and weight (load.h).

  void
  apply_temperatures(const std::vector<Load> &loads, const Bodies &bodies)
  {
    std::map<unsigned int, std::string> heated;
    for (const Load &load : loads)
      if (!load.temperature.empty())
        {
          const Entry entry("Load " + load.name + "/Temperature",
                            load.temperature.text());
          const auto  change =
            std::make_shared<const Expression>(entry.text(), entry);
          const double value =
            change->is_constant() ? (*change)(Point<3>()) : 0.;
          const ScalarField field =
            change->is_constant() ?
              ScalarField([value](const Point<3> &) { return value; }) :
              ScalarField([change](const Point<3> &x) { return (*change)(x); });
          for (const Region &region : load.on)
            {
              const auto [other, is_new] =
                heated.emplace(region.body, load.name);
              if (!is_new)
                entry.refuse(
                  "conditions.two-temperatures: body '" +
                    bodies[region.body]->name() +
                    "' already has the Temperature of load " + other->second,
                  "Write one load with the sum of both temperatures.");
              bodies[region.body]->heat(field);
            }
        }
  }



  LoadResultant
  add_weight(const Tensor<1, 3> &acceleration,
             const Bodies       &bodies,
             BlockVector        &f)
  {
    LoadResultant result;
    result.name = weight_load_name;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Body &body = *bodies[b];
        Vector      own(body.n_dofs());
        body.add_weight(acceleration, own);
        f.block(b) += own;
        const std::vector<Vector> rigid = body.rigid_motions(undisplaced);
        Tensor<1, 3>              force, moment;
        for (unsigned int c = 0; c < 3; ++c)
          {
            force[c]  = own * rigid[c];
            moment[c] = own * rigid[3 + c];
          }
        result.force += force;
        result.moment += moment + cross_product_3d(body.center(), force);
      }
    return result;
  }
} // namespace lamella
