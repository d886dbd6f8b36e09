// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/recover/interlaminar.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

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
  } // namespace



  void
  EquilibriumDefect::add(const EquilibriumDefect &other)
  {
    error    = std::max(error, other.error);
    largest  = std::max(largest, other.largest);
    in_plane = std::max(in_plane, other.in_plane);
  }



  double
  EquilibriumDefect::relative() const
  {
    constexpr double nothing = arithmetic::dependency_tolerance;
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
    make_nodes(degree);
    make_plies();
    for (const unsigned int side : {0, 1})
      is_free[side] = tractions.is_free(body, side_of(number, box, side));
    // The length over which torsional warping decays from a free side.
    double in_plane = 0., out_of_plane = 0.;
    for (const Layer &layer : layers_at(0.5 * box.size[0], 0.))
      {
        const double share = (layer.top - layer.bottom) / box.size[2];
        in_plane += share * plane_stiffness[layer.ply][0][0];
        out_of_plane += share * shear_compliance[layer.ply][1][1];
      }
    decay = box.size[2] / numbers::PI * std::sqrt(in_plane * out_of_plane);
  }



  void
  EquilibriumStress::make_nodes(const unsigned int degree)
  {
    const QGauss<1> through(degree + 1);
    samples        = points_of(through);
    sample_weights = through.get_weights();
    // The correction integrates three times; its polynomials are cut off here.
    const QGaussLobatto<1> rule(degree + 6);
    nodes        = points_of(rule);
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
  }



  void
  EquilibriumStress::make_plies()
  {
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
  }



  FieldSample
  EquilibriumStress::sample(const Location &location)
  {
    FieldSample    sample = recovery.sample(location);
    const Point<3> x      = box.frame.to_body(location.position);
    const Column  &column = column_at(x[0], x[1]);
    defect.add(column.defect);

    const Tensor<1, 3> found = transverse_stress(column, location.ply, x[2]);

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



  Tensor<1, 3>
  EquilibriumStress::transverse_stress(const Column      &column,
                                       const unsigned int ply,
                                       const double       z) const
  {
    // The layer of the ply that holds the point, or is nearest to it.
    unsigned int best    = 0;
    double       nearest = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < column.layers.size(); ++k)
      {
        const Layer &layer = column.layers[k];
        const double off   = std::max({0., layer.bottom - z, z - layer.top});
        if (layer.ply == ply && off < nearest)
          {
            best    = k;
            nearest = off;
          }
      }
    const Layer &layer = column.layers[best];
    const double t =
      std::clamp((z - layer.bottom) / (layer.top - layer.bottom), 0., 1.);
    const unsigned int n = nodes.size(), size = n * column.layers.size();
    Tensor<1, 3>       found;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double weight = lagrange(nodes, i, t);
        found[0] += weight * column.shear[best * n + i];
        found[1] += weight * column.shear[size + best * n + i];
        found[2] += weight * column.normal[best * n + i];
      }
    return found;
  }



  EquilibriumDefect
  EquilibriumStress::reset_defect()
  {
    return std::exchange(defect, EquilibriumDefect());
  }



  const EquilibriumStress::Column &
  EquilibriumStress::column_at(const double x, const double y)
  {
    const double unit = arithmetic::same_position * box.size.norm();
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
    distribute(missed, column);
    column.defect.error    = missed.norm();
    column.defect.largest  = std::max(column.defect.largest, missed.norm());
    column.defect.in_plane = source.in_plane;
    return column;
  }



  void
  EquilibriumStress::distribute(const Tensor<1, 3> &missed,
                                Column             &column) const
  {
    const unsigned int size = column.normal.size();
    for (unsigned int k = 0; k < column.layers.size(); ++k)
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const unsigned int of    = k * nodes.size() + i;
          const double       share = height(column.layers[k], i) / box.size[2];
          column.shear[of] -= share * missed[0];
          column.shear[size + of] -= share * missed[1];
          column.normal[of] -= share * missed[2];
          column.defect.largest = std::max(column.defect.largest,
                                           std::hypot(column.shear[of],
                                                      column.shear[size + of],
                                                      column.normal[of]));
        }
  }
} // namespace lamella
