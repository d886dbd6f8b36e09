// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/lagrange.h>
#include <lamella/recover/interlaminar.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Order of Eq. 4.
    constexpr unsigned int xx = 0, yy = 1, zz = 2, xy = 3, xz = 4, yz = 5;

    // Of lengths, what is rounding.
    constexpr double rounding = arithmetic::same_place_across;



    [[noreturn]] void
    refuse(const Body &body, const std::string &path, const std::string &why)
    {
      throw InputError(
        path,
        name_of(StressValues::equilibrium),
        "is of beams whose section is a laminate or a rectangle, "
        "but body '" +
          body.name() + "' " + why,
        "Take recovered, nodal or element.");
    }



    /// The one outward normal of @p surface.
    Tensor<1, 3>
    plane_normal(const Body        &body,
                 const std::string &surface,
                 const std::string &path)
    {
      Tensor<1, 3> normal;
      for (const SurfaceFacet &facet : body.surface_facets(surface))
        for (const double s : {0., 0.5, 1.})
          {
            const Tensor<1, 3> n =
              body.surface_point(facet, Point<2>(s, 0.5)).normal;
            if (normal.norm() == 0.)
              normal = n;
            if ((n - normal).norm() > rounding)
              refuse(body, path, "has a " + surface + " that is not plane");
          }
      if (normal.norm() == 0.)
        refuse(body, path, "has no surface '" + surface + "'");
      return normal;
    }



    /// The cells of the section at the start, as ranges of x and z in
    /// @p frame; refuses what is no rectangle along its axes.
    std::vector<BoundingBox<2>>
    rectangles(const Body        &body,
               const Placement   &frame,
               const std::string &path)
    {
      std::vector<BoundingBox<2>> cells;
      for (const SurfaceFacet &facet : body.surface_facets("start"))
        {
          std::vector<Point<2>> corners;
          for (const Point<3> &corner : facet.corners)
            {
              const Point<3> x = frame.to_body(corner);
              corners.emplace_back(x[0], x[2]);
            }
          const BoundingBox<2> cell(corners);
          const auto           place = [&](const double s, const double t) {
            const Point<3> x =
              frame.to_body(body.surface_point(facet, Point<2>(s, t)).position);
            return Point<2>(x[0], x[2]);
          };
          const auto [low, high] = cell.get_boundary_points();
          const double near      = rounding * low.distance(high);
          bool         is_one    = true;
          for (const Point<2> &corner : corners)
            for (unsigned int d = 0; d < 2; ++d)
              is_one &=
                std::min(corner[d] - low[d], high[d] - corner[d]) < near;
          for (const double s : {0., 0.5, 1.})
            for (const double t : {0., 0.5, 1.})
              {
                Point<2> straight;
                for (unsigned int k = 0; k < 4; ++k)
                  straight += (k % 2 == 0 ? 1. - s : s) *
                              (k / 2 == 0 ? 1. - t : t) * corners[k];
                is_one &= straight.distance(place(s, t)) < near;
              }
          if (!is_one)
            refuse(body, path, "has cells in its section that are none");
          cells.push_back(cell);
        }
      return cells;
    }



    /// Refuses a section, with the cells @p cells in @p frame, that has
    /// different plies at one height.
    void
    refuse_side_by_side(const Body                        &body,
                        const Placement                   &frame,
                        const std::vector<BoundingBox<2>> &cells,
                        const std::string                 &path)
    {
      const double y =
        frame.to_body(body.surface_facets("start")[0].corners[0])[1];
      std::vector<Point<3>> middles;
      for (const BoundingBox<2> &cell : cells)
        middles.push_back(
          frame.to_scene({cell.center()[0], y, cell.center()[1]}));
      const auto found = body.locate(middles);
      for (unsigned int a = 0; a < cells.size(); ++a)
        for (unsigned int b = 0; b < a; ++b)
          {
            const double overlap =
              std::min(cells[a].upper_bound(1), cells[b].upper_bound(1)) -
              std::max(cells[a].lower_bound(1), cells[b].lower_bound(1));
            if (overlap > rounding * cells[a].side_length(1) &&
                found[a].front().ply != found[b].front().ply)
              refuse(body, path, "has plies side by side");
          }
    }
  } // namespace



  LaminateBox
  laminate_box(const Body &body, const std::string &path)
  {
    if (body.is_nodal())
      refuse(body, path, "is a solid");
    for (const Ply &ply : body.plies())
      if (ply.plane.normal_at || ply.plane.normal != Point<2>(0., 1.))
        refuse(body, path, "has plies that do not lie level");
    if (body.is_heated())
      throw InputError(path,
                       name_of(StressValues::equilibrium),
                       "does not know of heat, and body '" + body.name() +
                         "' has a Temperature",
                       "Take recovered, nodal or element.");
    const Tensor<1, 3> up    = plane_normal(body, "top", path),
                       along = plane_normal(body, "end", path);
    if ((plane_normal(body, "bottom", path) + up).norm() > rounding)
      refuse(body, path, "has a bottom and a top that are not parallel");
    LaminateBox box;
    box.frame        = Placement::from_directions(Point<3>(), along, up);
    const auto cells = rectangles(body, box.frame, path);

    refuse_side_by_side(body, box.frame, cells, path);
    std::vector<Point<2>> corners;
    double                area = 0.;
    for (const BoundingBox<2> &cell : cells)
      {
        corners.push_back(cell.get_boundary_points().first);
        corners.push_back(cell.get_boundary_points().second);
        area += cell.volume();
      }
    const BoundingBox<2> all(corners);
    if (std::abs(all.volume() - area) > rounding * area)
      refuse(body, path, "has a section with gaps or corners that turn in");
    const auto [low, high] = all.get_boundary_points();
    const double y0 =
      box.frame.to_body(body.surface_facets("start")[0].corners[0])[1];
    const double y1 =
      box.frame.to_body(body.surface_facets("end")[0].corners[0])[1];
    box.frame.origin = box.frame.to_scene({low[0], y0, low[1]});
    box.size         = Point<3>(high[0] - low[0], y1 - y0, high[1] - low[1]);
    return box;
  }



  namespace
  {
    /// That of the lower or the upper face of @p box.
    FaceTractions::Face
    face_of(const unsigned int number, const LaminateBox &box, const bool upper)
    {
      const Triad        &axes = box.frame.axes;
      FaceTractions::Face face;
      face.body      = number;
      face.surface   = upper ? "top" : "bottom";
      face.origin    = box.frame.to_scene({0., 0., upper ? box.size[2] : 0.});
      face.normal    = upper ? axes[2] : -axes[2];
      face.tolerance = arithmetic::same_in_element * box.size[2];
      return face;
    }



    /// That of the side x = 0 or x = W.
    FaceTractions::Face
    side_of(const unsigned int number,
            const LaminateBox &box,
            const unsigned int side)
    {
      const Triad        &axes = box.frame.axes;
      FaceTractions::Face face;
      face.body      = number;
      face.origin    = box.frame.to_scene({side * box.size[0], 0., 0.});
      face.normal    = side == 1 ? axes[0] : -axes[0];
      face.tolerance = arithmetic::same_in_element * box.size[2];
      return face;
    }



    std::vector<double>
    coordinates(const Quadrature<1> &rule)
    {
      std::vector<double> result;
      for (const Point<1> &point : rule.get_points())
        result.push_back(point[0]);
      return result;
    }



    /// The weights of the values at @p points that make derivatives at @p at,
    /// the 0th to the @p most-th, of the polynomial of @p degree that is
    /// fitted to them by least squares.
    std::vector<std::vector<double>>
    derivative_weights(const std::vector<double> &points,
                       const unsigned int         degree,
                       const double               at,
                       const unsigned int         most)
    {
      // Of the interval from the first to the last point Legendre polynomials
      // are nearly orthogonal over Gauss points, so the normal equations lose
      // no digits.
      const auto [low, high] =
        std::minmax_element(points.begin(), points.end());
      const double origin = *low,
                   length = std::max(*high - *low, arithmetic::above_zero);
      const unsigned int               n = degree + 1;
      std::vector<std::vector<double>> values(points.size());
      std::vector<std::vector<double>> here(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          const Polynomials::Legendre polynomial(k);
          for (unsigned int i = 0; i < points.size(); ++i)
            values[i].push_back(
              polynomial.value((points[i] - origin) / length));
          here[k].resize(most + 1);
          polynomial.value((at - origin) / length, most, here[k].data());
        }
      FullMatrix<double> normal(n, n);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          for (const auto &row : values)
            normal(k, l) += row[k] * row[l];
      normal.gauss_jordan();
      std::vector<std::vector<double>> weights(
        most + 1, std::vector<double>(points.size(), 0.));
      for (unsigned int m = 0; m <= most; ++m)
        for (unsigned int i = 0; i < points.size(); ++i)
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int l = 0; l < n; ++l)
              weights[m][i] +=
                values[i][k] * normal(k, l) * here[l][m] / std::pow(length, m);
      return weights;
    }
  } // namespace



  void
  ClosureError::add(const ClosureError &other)
  {
    error    = std::max(error, other.error);
    largest  = std::max(largest, other.largest);
    in_plane = std::max(in_plane, other.in_plane);
  }



  double
  ClosureError::relative() const
  {
    constexpr double nothing = arithmetic::dependent;
    return error > nothing * in_plane ? error / largest : 0.;
  }



  EquilibriumStress::EquilibriumStress(const Body          &body,
                                       const unsigned int   number,
                                       const Vector        &u,
                                       const FaceTractions &tractions,
                                       const std::string   &path)
    : body(body)
    , u(u)
    , box(laminate_box(body, path))
    , recovery(body, u, StressValues::recovered)
    , to_body(strain_rotation(box.frame.axes))
    , to_scene(box.frame.strain_to_scene())
  {
    for (const bool upper : {false, true})
      faces.emplace_back(tractions, face_of(number, box, upper));
    const unsigned int degree =
      body.line_degree(box.frame.to_scene(Point<3>()),
                       box.frame.to_scene({0., 0., box.size[2]}));
    const QGauss<1> through(degree + 1);
    samples        = coordinates(through);
    sample_weights = through.get_weights();
    // The correction integrates three times; its polynomials are cut off here.
    const QGaussLobatto<1> rule(degree + 6);
    nodes        = coordinates(rule);
    node_weights = rule.get_weights();

    const unsigned int n = nodes.size();
    to_nodes.reinit(n, samples.size());
    integrate.reinit(n, n);
    const QGauss<1> gauss(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < samples.size(); ++j)
          to_nodes(i, j) = lagrange(samples, j, nodes[i]);
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int q = 0; q < gauss.size(); ++q)
            integrate(i, j) += nodes[i] * gauss.weight(q) *
                               lagrange(nodes, j, nodes[i] * gauss.point(q)[0]);
      }
    for (const Ply &ply : body.plies())
      {
        const ElasticTensor C = ply.stiffness();
        Tensor<2, 2>        G, Q;
        const unsigned int  shears[] = {xz, yz}, plane[] = {xy, yy};
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int j = 0; j < 2; ++j)
            {
              G[i][j] = C[shears[i]][shears[j]];
              Q[i][j] = C[plane[i]][plane[j]] -
                        C[plane[i]][zz] * C[zz][plane[j]] / C[zz][zz];
            }
        shear_compliance.push_back(invert(G));
        plane_stiffness.push_back(Q);
        ply_frames.push_back(ply.axes(Point<2>()));
      }
    for (const unsigned int side : {0, 1})
      is_free[side] = tractions.is_free(body, side_of(number, box, side));
    double in_plane = 0., out_of_plane = 0.;
    for (const Layer &layer : layers_at(0.5 * box.size[0], 0.))
      {
        const double share = (layer.top - layer.bottom) / box.size[2];
        in_plane += share * plane_stiffness[layer.ply][0][0];
        out_of_plane += share * shear_compliance[layer.ply][1][1];
      }
    decay = box.size[2] / numbers::PI * std::sqrt(in_plane * out_of_plane);
  }



  FieldSample
  EquilibriumStress::sample(const Location &location)
  {
    FieldSample    sample = recovery.sample(location);
    const Point<3> x      = box.frame.to_body(location.position);
    const Column  &column = column_at(x[0], x[1]);
    closure.add(column.closure);

    // The layer of the ply that holds the point, or is nearest to it.
    unsigned int best    = 0;
    double       nearest = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < column.layers.size(); ++k)
      {
        const Layer &layer = column.layers[k];
        const double off =
          std::max({0., layer.bottom - x[2], x[2] - layer.top});
        if (layer.ply == location.ply && off < nearest)
          {
            best    = k;
            nearest = off;
          }
      }
    const Layer &layer = column.layers[best];
    const double t =
      std::clamp((x[2] - layer.bottom) / (layer.top - layer.bottom), 0., 1.);
    const unsigned int n = nodes.size(), size = n * column.layers.size();
    Tensor<1, 3>       found;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double weight = lagrange(nodes, i, t);
        found[0] += weight * column.shear[best * n + i];
        found[1] += weight * column.shear[size + best * n + i];
        found[2] += weight * column.normal[best * n + i];
      }

    // Stresses turn with T^-T, T^-1 being the strains' way back.
    Voigt stress  = transpose(to_scene) * sample.stress;
    stress[xz]    = found[0];
    stress[yz]    = found[1];
    stress[zz]    = found[2];
    sample.stress = transpose(to_body) * stress;
    sample.ply_stress =
      transpose(strain_rotation(transpose(ply_frames[location.ply]))) * stress;
    return sample;
  }



  ClosureError
  EquilibriumStress::take_closure()
  {
    return std::exchange(closure, ClosureError());
  }



  const EquilibriumStress::Column &
  EquilibriumStress::column_at(const double x, const double y)
  {
    const double              unit = arithmetic::same_place * box.size.norm();
    const std::array<long, 2> key{
      {std::lround(x / unit), std::lround(y / unit)}};
    const auto known = columns.find(key);
    return known != columns.end() ? known->second :
                                    columns[key] = make_column(x, y);
  }



  std::vector<EquilibriumStress::Layer>
  EquilibriumStress::layers_at(const double x, const double y) const
  {
    const double   H                 = box.size[2];
    const Point<3> bottom            = box.frame.to_scene({x, y, 0.}),
                   top               = box.frame.to_scene({x, y, H});
    const std::vector<double> breaks = body.line_breaks(bottom, top);
    std::vector<Point<3>>     middles;
    for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
      middles.push_back(bottom +
                        0.5 * (breaks[k] + breaks[k + 1]) * (top - bottom));
    const auto         found = body.locate(middles);
    std::vector<Layer> layers;
    for (unsigned int k = 0; k < middles.size(); ++k)
      {
        AssertThrow(!found[k].empty(), ExcInternalError());
        layers.push_back(
          {H * breaks[k], H * breaks[k + 1], found[k].front().ply});
      }
    return layers;
  }



  EquilibriumStress::Stencil
  EquilibriumStress::stencil(const unsigned int d,
                             const Point<3>    &through) const
  {
    // Of the ratio to an element's length.
    constexpr double       same  = arithmetic::same_in_element;
    constexpr unsigned int least = 3, most_derivatives = 4;

    Point<3> begin = through, end = through;
    begin[d]         = 0.;
    end[d]           = box.size[d];
    const Point<3> a = box.frame.to_scene(begin), b = box.frame.to_scene(end);
    const std::vector<double> breaks = body.line_breaks(a, b);
    const unsigned int        n      = breaks.size() - 1;
    const double              at     = through[d] / box.size[d];
    unsigned int              first = n, last = 0;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double near = same * (breaks[k + 1] - breaks[k]);
        if (at >= breaks[k] - near && at <= breaks[k + 1] + near)
          {
            first = std::min(first, k);
            last  = std::max(last, k);
          }
      }
    const unsigned int p         = body.recovery_degrees()[d];
    const bool         is_smooth = p == 0;
    unsigned int       degree    = body.line_degree(a, b);
    if (!is_smooth)
      {
        // Neighbours, and at ends as many elements as elsewhere.
        first  = first == 0 ? 0 : first - 1;
        last   = std::min(last + 1, n - 1);
        first  = std::min(first, last + 1 - std::min(last + 1, least));
        last   = std::max(last, std::min(n, first + least) - 1);
        degree = d == 1 ? p + 1 : p;
      }
    const QGauss<1> gauss(is_smooth ? degree + 1 : p);
    Stencil         result;
    result.at = through[d];
    for (unsigned int k = first; k <= last; ++k)
      for (const double t : coordinates(gauss))
        result.points.push_back(box.size[d] *
                                (breaks[k] + t * (breaks[k + 1] - breaks[k])));
    degree = std::min<unsigned int>(degree, result.points.size() - 1);
    result.weights =
      derivative_weights(result.points, degree, through[d], most_derivatives);
    return result;
  }



  EquilibriumStress::Sources
  EquilibriumStress::sources(const std::vector<Layer> &layers,
                             const double              x,
                             const double              y)
  {
    const unsigned int size = layers.size() * nodes.size();
    Sources            all;
    for (Profile &profile : all.shear)
      profile.reinit(2 * size);
    for (Profile &profile : all.strain)
      profile.reinit(2 * size);
    all.normal.reinit(size);
    const std::vector<EdgeShare> edges_here = edge_shares(layers, x, y);
    for (unsigned int k = 0; k < layers.size(); ++k)
      {
        const Point<3> middle(x, y, 0.5 * (layers[k].bottom + layers[k].top));
        add_sources(k,
                    layers[k],
                    edges_here,
                    stencil(0, middle),
                    stencil(1, middle),
                    all);
      }
    return all;
  }



  const EquilibriumStress::Sampled &
  EquilibriumStress::sampled_at(const Point<3> &x, const unsigned int ply)
  {
    const double        unit = arithmetic::same_place * box.size.norm();
    std::array<long, 3> key;
    for (unsigned int d = 0; d < 3; ++d)
      key[d] = std::lround(x[d] / unit);
    const auto [known, is_new] = sampled.try_emplace(key);
    if (is_new)
      {
        const auto here = body.locate({box.frame.to_scene(x)}).front();
        const auto location =
          std::find_if(here.begin(), here.end(), [ply](const Location &l) {
            return l.ply == ply;
          });
        AssertThrow(location != here.end(), ExcInternalError());
        const FieldSample sample = body.sample(*location, u);
        const Voigt       stress = transpose(to_scene) * sample.stress,
                    strain       = to_body * sample.strain;
        known->second            = {
                     {stress[xx], stress[yy], stress[xy], strain[xz], strain[yz]}};
      }
    return known->second;
  }



  EquilibriumStress::EdgeShape
  EquilibriumStress::edge_shape(const unsigned int side, const double x) const
  {
    // sinh((W - d) / l) / sinh(W / l), d from the side, without overflow.
    const double W    = box.size[0] / decay,
                 d    = (side == 0 ? x : box.size[0] - x) / decay,
                 size = std::exp(-d) / -std::expm1(-2. * W),
                 back = std::exp(-2. * (W - d));
    return {size * (1. - back),
            (side == 0 ? -1. : 1.) * size * (1. + back) / decay};
  }



  const std::vector<Tensor<1, 5>> &
  EquilibriumStress::edge_stress(const unsigned int        side,
                                 const std::vector<Layer> &layers,
                                 const double              y)
  {
    const double unit = arithmetic::same_place * box.size.norm();
    const auto [known, is_new] =
      edges.try_emplace({{long(side), std::lround(y / unit)}});
    if (!is_new)
      return known->second;
    Tensor<1, 5> mean;
    for (const Layer &layer : layers)
      {
        const double   thickness = layer.top - layer.bottom;
        const Point<3> edge(side * box.size[0],
                            y,
                            0.5 * (layer.bottom + layer.top));
        const Stencil  along_x = stencil(0, edge), along_y = stencil(1, edge);
        for (unsigned int q = 0; q < samples.size(); ++q)
          {
            const double z = layer.bottom + samples[q] * thickness;
            Tensor<1, 5> stress;
            for (unsigned int i = 0; i < along_x.points.size(); ++i)
              for (unsigned int j = 0; j < along_y.points.size(); ++j)
                for (unsigned int b = 0; b < 5; ++b)
                  stress[b] +=
                    along_x.weights[0][i] * along_y.weights[b][j] *
                    sampled_at({along_x.points[i], along_y.points[j], z},
                               layer.ply)[2];
            known->second.push_back(stress);
            mean += thickness / box.size[2] * sample_weights[q] * stress;
          }
      }
    for (Tensor<1, 5> &stress : known->second)
      stress -= mean;
    return known->second;
  }



  std::vector<EquilibriumStress::EdgeShare>
  EquilibriumStress::edge_shares(const std::vector<Layer> &layers,
                                 const double              x,
                                 const double              y)
  {
    constexpr double       nothing = arithmetic::rounding_of_results;
    std::vector<EdgeShare> shares(layers.size() * samples.size());
    for (const unsigned int side : {0, 1})
      {
        const EdgeShape shape = edge_shape(side, x);
        if (!is_free[side] || std::abs(shape.slope) * decay < nothing)
          continue;
        const auto &stress = edge_stress(side, layers, y);
        for (unsigned int k = 0; k < shares.size(); ++k)
          {
            shares[k].of_value += shape.value * stress[k];
            shares[k].of_slope += shape.slope * stress[k];
          }
      }
    return shares;
  }



  void
  EquilibriumStress::add_sources(const unsigned int            k,
                                 const Layer                  &layer,
                                 const std::vector<EdgeShare> &edges_here,
                                 const Stencil                &along_x,
                                 const Stencil                &along_y,
                                 Sources                      &all)
  {
    // Of Sampled.
    constexpr unsigned int s_xx = 0, s_yy = 1, s_xy = 2, g_xz = 3, g_yz = 4;
    const unsigned int     n = nodes.size(), size = all.normal.size();
    for (unsigned int q = 0; q < samples.size(); ++q)
      {
        const double z = layer.bottom + samples[q] * (layer.top - layer.bottom);
        // d[a][b] is the derivative a times along x and b times along y.
        Tensor<1, 5> d[3][5];
        for (unsigned int i = 0; i < along_x.points.size(); ++i)
          for (unsigned int j = 0; j < along_y.points.size(); ++j)
            {
              const Sampled &values =
                sampled_at({along_x.points[i], along_y.points[j], z},
                           layer.ply);
              for (const unsigned int c : {s_xx, s_yy, s_xy})
                all.in_plane = std::max(all.in_plane, std::abs(values[c]));
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 5; ++b)
                  for (unsigned int c = 0; c < 5; ++c)
                    d[a][b][c] +=
                      along_x.weights[a][i] * along_y.weights[b][j] * values[c];
            }
        const EdgeShare &edge = edges_here[k * samples.size() + q];
        for (unsigned int b = 0; b < 5; ++b)
          {
            d[0][b][s_xy] -= edge.of_value[b];
            d[1][b][s_xy] -= edge.of_slope[b];
          }
        for (unsigned int i = 0; i < n; ++i)
          {
            const double       w  = to_nodes(i, q);
            const unsigned int of = k * n + i;
            for (unsigned int m = 0; m < 4; ++m)
              {
                all.shear[m][of] -= w * (d[1][m][s_xx] + d[0][m + 1][s_xy]);
                all.shear[m][size + of] -=
                  w * (d[1][m][s_xy] + d[0][m + 1][s_yy]);
              }
            all.normal[of] -=
              w * (d[2][0][s_xx] + 2. * d[1][1][s_xy] + d[0][2][s_yy]);
            for (unsigned int m = 0; m < 2; ++m)
              {
                all.strain[m][of] += w * d[0][m + 2][g_xz];
                all.strain[m][size + of] += w * d[0][m + 2][g_yz];
              }
          }
      }
  }



  EquilibriumStress::Profile
  EquilibriumStress::integral(const std::vector<Layer>  &layers,
                              const Profile             &f,
                              const std::vector<double> &start) const
  {
    const unsigned int n = nodes.size();
    Profile            result(f.size());
    unsigned int       at = 0;
    for (double value : start)
      for (const Layer &layer : layers)
        {
          for (unsigned int i = 0; i < n; ++i)
            {
              result[at + i] = value;
              for (unsigned int j = 0; j < n; ++j)
                result[at + i] +=
                  (layer.top - layer.bottom) * integrate(i, j) * f[at + j];
            }
          value = result[at + n - 1];
          at += n;
        }
    return result;
  }



  EquilibriumStress::Profile
  EquilibriumStress::plane_stress(const std::vector<Layer> &layers,
                                  const Profile            &displacement) const
  {
    const unsigned int n = nodes.size(), size = n * layers.size();
    Profile            stress(2 * size);
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = k * n; i < (k + 1) * n; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          for (unsigned int b = 0; b < 2; ++b)
            stress[c * size + i] +=
              plane_stiffness[layers[k].ply][c][b] * displacement[b * size + i];
    return stress;
  }



  std::array<double, 4>
  EquilibriumStress::resultants(const std::vector<Layer> &layers,
                                const Profile            &stress) const
  {
    const unsigned int    n = nodes.size(), size = n * layers.size();
    std::array<double, 4> all{};
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const double force = (layers[k].top - layers[k].bottom) *
                                 node_weights[i] * stress[c * size + k * n + i];
            all[c] += force;
            all[2 + c] += force * height(layers[k], i) / box.size[2];
          }
    return all;
  }



  EquilibriumStress::Profile
  EquilibriumStress::warped(const std::vector<Layer> &layers,
                            const Profile            &shear,
                            const Profile            &strain) const
  {
    const unsigned int n = nodes.size(), size = n * layers.size();
    Profile            rate(2 * size);
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = k * n; i < (k + 1) * n; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const Tensor<1, 2> S = shear_compliance[layers[k].ply][c];
            rate[c * size + i] =
              S[0] * shear[i] + S[1] * shear[size + i] - strain[c * size + i];
          }
    Profile stress = plane_stress(layers, integral(layers, rate, {0., 0.}));

    // What is linear in z takes the resultants away.
    std::vector<Profile>   linear;
    FullMatrix<double>     system(4, 4);
    dealii::Vector<double> wanted(4), amounts(4);
    const auto             of_e = resultants(layers, stress);
    for (unsigned int m = 0; m < 4; ++m)
      {
        Profile motion(2 * size);
        for (unsigned int k = 0; k < layers.size(); ++k)
          for (unsigned int i = 0; i < n; ++i)
            motion[m % 2 * size + k * n + i] =
              m < 2 ? 1. : height(layers[k], i) / box.size[2];
        linear.push_back(plane_stress(layers, motion));
        const auto own = resultants(layers, linear[m]);
        for (unsigned int r = 0; r < 4; ++r)
          system(r, m) = own[r];
        wanted[m] = -of_e[m];
      }
    system.gauss_jordan();
    system.vmult(amounts, wanted);
    for (unsigned int m = 0; m < 4; ++m)
      stress.add(amounts[m], linear[m]);
    stress *= -1.;
    return integral(layers, stress, {0., 0.});
  }



  namespace
  {
    /// delta - c P delta, for a solver.
    struct ShearWarping
    {
      std::function<Vector(const Vector &)> of;
      double                                ratio;

      void
      vmult(Vector &to, const Vector &from) const
      {
        to = of(from);
        to.sadd(-ratio, 1., from);
      }
    };
  } // namespace



  std::array<EquilibriumStress::Profile, 2>
  EquilibriumStress::correction(const std::vector<Layer>     &layers,
                                const std::array<Profile, 4> &shear,
                                const std::array<Profile, 2> &strain) const
  {
    constexpr double       largest_share = 0.5, tolerance = 1e-8;
    constexpr unsigned int most_steps = 60;

    const Profile          none(shear[0].size());
    std::array<Profile, 2> result{{none, none}};
    // tau and tau' alike, in one unit.
    const double H     = box.size[2];
    const double scale = shear[0] * shear[0] + H * H * (shear[1] * shear[1]);
    if (scale == 0.)
      return result;
    const double ratio =
      (shear[2] * shear[0] + H * H * (shear[3] * shear[1])) / scale;
    const ShearWarping operation{[&](const Vector &of) {
                                   return warped(layers, of, none);
                                 },
                                 ratio};
    double             share = 0.;
    for (unsigned int m = 0; m < 2; ++m)
      {
        const Profile       right = warped(layers, shear[m + 2], strain[m]);
        SolverControl       control(most_steps, tolerance * right.l2_norm());
        SolverGMRES<Vector> solver(control);
        result[m] = right;
        try
          {
            if (right.l2_norm() > 0.)
              solver.solve(operation, result[m], right, PreconditionIdentity());
          }
        catch (const SolverControl::NoConvergence &)
          {
            return {{none, none}};
          }
        share += std::pow(H, 2. * m) * (result[m] * result[m]) / scale;
      }
    if (!(share <= largest_share * largest_share))
      return {{none, none}};
    return result;
  }



  Tensor<1, 3>
  EquilibriumStress::face_stress(const unsigned int face,
                                 const double       x,
                                 const double       y) const
  {
    const Tensor<1, 3> t = box.frame.vector_to_body(
      faces[face](box.frame.to_scene({x, y, face == 0 ? 0. : box.size[2]})));
    // t = sigma . n with n = -z below.
    return face == 0 ? -t : t;
  }



  EquilibriumStress::Column
  EquilibriumStress::make_column(const double x, const double y)
  {
    Column column;
    column.layers        = layers_at(x, y);
    const auto   &layers = column.layers;
    const Sources source = sources(layers, x, y);
    const auto    below = face_stress(0, x, y), above = face_stress(1, x, y);
    std::array<Profile, 4> shear;
    for (unsigned int m = 0; m < 4; ++m)
      shear[m] = integral(layers,
                          source.shear[m],
                          m == 0 ? std::vector<double>{below[0], below[1]} :
                                   std::vector<double>{0., 0.});
    const auto added = correction(layers, shear, source.strain);
    column.shear     = shear[0];
    column.shear += added[0];

    Profile            slope = integral(layers, source.normal, {0.});
    const unsigned int size  = slope.size();
    for (unsigned int i = 0; i < size; ++i)
      slope[i] = -slope[i] - added[1][size + i];
    column.normal = integral(layers, slope, {below[2]});

    const Tensor<1, 3> missed = Point<3>(column.shear[size - 1],
                                         column.shear[2 * size - 1],
                                         column.normal[size - 1]) -
                                above;
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const unsigned int of    = k * nodes.size() + i;
          const double       share = height(layers[k], i) / box.size[2];
          column.shear[of] -= share * missed[0];
          column.shear[size + of] -= share * missed[1];
          column.normal[of] -= share * missed[2];
          column.closure.largest = std::max(column.closure.largest,
                                            std::hypot(column.shear[of],
                                                       column.shear[size + of],
                                                       column.normal[of]));
        }
    column.closure.error    = missed.norm();
    column.closure.largest  = std::max(column.closure.largest, missed.norm());
    column.closure.in_plane = source.in_plane;
    return column;
  }
} // namespace lamella
