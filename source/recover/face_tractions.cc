// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/recover/face_tractions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  FaceTractions::FaceTractions(const std::vector<Load>    &given,
                               const double                factor,
                               const std::vector<Support> &supports)
    : factor(factor)
  {
    for (const Support &support : supports)
      held.insert(held.end(), support.on.begin(), support.on.end());
    // Couples act on ends, temperatures on no face.
    for (const Load &load : given)
      if (!load.couple && load.temperature.empty())
        for (const Region &region : load.on)
          if (region.kind == Region::Kind::surface)
            loads.push_back({region, std::make_shared<const Traction>(load)});
  }



  void
  FaceTractions::add_contact(const unsigned int                          first,
                             const std::optional<unsigned int>           second,
                             const std::vector<ContactInterface::Point> &points,
                             const ArrayView<const double>              &forces)
  {
    std::vector<Pressed> pressed;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const auto &point = points[k];
        if (point.area <= 0. || point.normal.norm() == 0.)
          continue;
        const Tensor<1, 3> n        = point.normal / point.normal.norm();
        const double       pressure = forces[k] / point.area;
        pressed.push_back({first, point.first, n, pressure, point.spacing});
        if (second)
          pressed.push_back(
            {*second, point.second, -n, pressure, point.spacing});
      }
    contacts.push_back(std::move(pressed));
  }



  bool
  FaceTractions::is_free(const Body &body, const Face &face) const
  {
    constexpr double same_way = 0.9;
    const auto       is_on    = [&](const Region &region) {
      if (region.body != face.body)
        return false;
      if (region.kind != Region::Kind::surface)
        return region.kind == Region::Kind::body;
      const auto facets = body.surface_facets(region.surface);
      return std::any_of(
        facets.begin(), facets.end(), [&](const SurfaceFacet &facet) {
          const auto middle = body.surface_point(facet, Point<2>(0.5, 0.5));
          return middle.normal * face.normal > same_way &&
                 std::abs((middle.position - face.origin) * face.normal) <
                   face.tolerance;
        });
    };
    return std::none_of(held.begin(), held.end(), is_on) &&
           std::none_of(loads.begin(),
                        loads.end(),
                        [&](const SurfaceLoad &load) {
                          return is_on(load.region);
                        }) &&
           !OnFace(*this, face).has_contacts();
  }



  FaceTractions::OnFace::OnFace(const FaceTractions &all, const Face &face)
    : all(all)
    , face(face)
  {
    // Of the angle between the normals of a contact and a face.
    constexpr double same_way = 0.9;
    for (const auto &points : all.contacts)
      {
        Pressures here;
        for (const Pressed &point : points)
          {
            const Tensor<1, 3> d = point.position - face.origin;
            if (point.body != face.body ||
                std::abs(d * face.normal) > face.tolerance ||
                point.normal * face.normal < same_way)
              continue;
            here.places.push_back({{d * face.along_s, d * face.along_t}});
            here.values.push_back(point.pressure);
            here.spacings.push_back(point.spacing);
          }
        if (here.places.empty())
          continue;
        make_grid(here, face.tolerance);
        contacts.push_back(std::move(here));
      }
  }



  void
  FaceTractions::OnFace::make_grid(Pressures &pressures, const double same)
  {
    // A grid may lack that many times the points that it has.
    constexpr double sparse = 4.;
    for (unsigned int d = 0; d < 2; ++d)
      {
        std::vector<double> all;
        for (const auto &place : pressures.places)
          all.push_back(place[d]);
        std::sort(all.begin(), all.end());
        for (const double s : all)
          if (pressures.grid[d].empty() || s - pressures.grid[d].back() > same)
            pressures.grid[d].push_back(s);
      }
    const std::size_t n = pressures.grid[0].size(),
                      m = pressures.grid[1].size();
    if (n * m > sparse * pressures.places.size())
      {
        pressures.grid = {};
        return;
      }
    pressures.on_grid.assign(n * m, 0.);
    const auto number = [&](const unsigned int d, const double s) {
      const auto &line = pressures.grid[d];
      return std::lower_bound(line.begin(), line.end(), s - same) -
             line.begin();
    };
    for (unsigned int k = 0; k < pressures.places.size(); ++k)
      pressures.on_grid[number(1, pressures.places[k][1]) * n +
                        number(0, pressures.places[k][0])] =
        pressures.values[k];
  }



  namespace
  {
    /// The weights of the values at the places @p line, ascending, that make
    /// the linear interpolation at @p s; none beyond its ends. A single place
    /// reaches as far as @p spacing / 2.
    std::vector<std::pair<unsigned int, double>>
    linear_weights(const std::vector<double> &line,
                   const double               s,
                   const double               spacing)
    {
      const unsigned int last = line.size() - 1;
      if (last == 0 && std::abs(s - line[0]) > 0.5 * spacing)
        return {};
      if (last == 0)
        return {{0, 1.}};
      const double before = 0.5 * (line[1] - line[0]),
                   after  = 0.5 * (line[last] - line[last - 1]);
      if (s < line[0] - before || s > line[last] + after)
        return {};
      if (s <= line[0])
        return {{0, 1.}};
      if (s >= line[last])
        return {{last, 1.}};
      const unsigned int k =
        std::upper_bound(line.begin(), line.end(), s) - line.begin() - 1;
      const double t = (s - line[k]) / (line[k + 1] - line[k]);
      return {{k, 1. - t}, {k + 1, t}};
    }
  } // namespace



  double
  FaceTractions::OnFace::pressure(const Pressures             &pressures,
                                  const std::array<double, 2> &st)
  {
    const unsigned int n = pressures.grid[0].size();
    double             p = 0.;
    if (n > 0)
      {
        const double spacing = *std::max_element(pressures.spacings.begin(),
                                                 pressures.spacings.end());
        for (const auto &[i, w] :
             linear_weights(pressures.grid[0], st[0], spacing))
          for (const auto &[j, v] :
               linear_weights(pressures.grid[1], st[1], spacing))
            p += w * v * pressures.on_grid[j * n + i];
        return p;
      }
    double nearest = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < pressures.places.size(); ++k)
      {
        const double distance = std::hypot(pressures.places[k][0] - st[0],
                                           pressures.places[k][1] - st[1]);
        if (distance < nearest)
          {
            nearest = distance;
            p = distance <= 0.5 * pressures.spacings[k] ? pressures.values[k] :
                                                          0.;
          }
      }
    return p;
  }



  Tensor<1, 3>
  FaceTractions::OnFace::operator()(const Point<3> &x) const
  {
    Tensor<1, 3> t;
    for (const SurfaceLoad &load : all.loads)
      if (load.region.body == face.body && load.region.covers(face.surface))
        t += all.factor * (*load.traction)(x, face.normal);
    const Tensor<1, 3>          d = x - face.origin;
    const std::array<double, 2> st{{d * face.along_s, d * face.along_t}};
    for (const Pressures &contact : contacts)
      t -= pressure(contact, st) * face.normal;
    return t;
  }
} // namespace lamella
