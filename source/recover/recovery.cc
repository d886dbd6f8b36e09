// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/recover/recovery.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Unit coordinates closer than this are the same: those of neighbors come
    // out of an inverted map. Nodes on larger elements are further.
    constexpr double same_unit = 1e-4;



    /// The mean edges of the element @p cell, in columns.
    Tensor<2, 3>
    edges(const Body &body, const unsigned int cell)
    {
      Tensor<2, 3> result;
      for (unsigned int v = 0; v < 8; ++v)
        {
          const Point<3> unit = GeometryInfo<3>::unit_cell_vertex(v);
          const Point<3> x    = body.position({cell, unit});
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              result[c][d] += (unit[d] > 0. ? 0.25 : -0.25) * x[c];
        }
      return result;
    }



    /// Whether the columns of @p a and @p b have the same set of directions.
    bool
    same_directions(const Tensor<2, 3> &a, const Tensor<2, 3> &b)
    {
      const Tensor<2, 3> map = invert(a) * b;
      for (unsigned int d = 0; d < 3; ++d)
        {
          double       largest = 0.;
          unsigned int n       = 0;
          for (unsigned int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(map[c][d]));
          for (unsigned int c = 0; c < 3; ++c)
            n += std::abs(map[c][d]) > arithmetic::parallel_sine * largest;
          if (n > 1)
            return false;
        }
      return true;
    }
  } // namespace



  StressRecovery::StressRecovery(const Body        &body,
                                 const Vector      &u,
                                 const StressValues values)
    : body(body)
    , u(u)
    , kind(values)
    , degrees(body.cells().recovery_degrees)
  {
    Assert(kind != StressValues::undefined && kind != StressValues::equilibrium,
           ExcInternalError());
    for (unsigned int d = 0; d < 3; ++d)
      if (degrees[d] > 0)
        {
          const QGaussLobatto<1> points(
            kind == StressValues::recovered ? 2 : degrees[d] + 1);
          for (const Point<1> &point : points.get_points())
            node_coordinates[d].push_back(point[0]);
        }
  }



  FieldSample
  StressRecovery::sample(const Location &location)
  {
    FieldSample sample = body.sample(location, u);
    if (kind == StressValues::element)
      return sample;
    // Continuous, so that one of the places tells it.
    const FieldValues values = field(location.ply, location.places.front());
    unsigned int      k      = 0;
    for (Voigt *part : {&sample.strain, &sample.stress, &sample.ply_stress})
      for (unsigned int c = 0; c < 6; ++c)
        (*part)[c] = values[k++];
    return sample;
  }



  StressRecovery::Key
  StressRecovery::key_of(const Place &place)
  {
    Key key{place.cell, {}};
    for (unsigned int d = 0; d < 3; ++d)
      key.second[d] = std::lround(place.unit[d] * 1e9);
    return key;
  }



  FieldValues
  StressRecovery::element_values(const unsigned int ply,
                                 const Place       &place) const
  {
    const FieldSample sample =
      body.sample({body.position(place), ply, {place}}, u);
    FieldValues  values;
    unsigned int k = 0;
    for (const Voigt *part :
         {&sample.strain, &sample.stress, &sample.ply_stress})
      for (unsigned int c = 0; c < 6; ++c)
        values[k++] = (*part)[c];
    return values;
  }



  FieldValues
  StressRecovery::field(const unsigned int ply, const Place &place)
  {
    const Point<3> x = body.position(place);
    FieldValues    sum;
    for (const auto &[node, weight] : nodes(place))
      if (weight != 0.)
        for (const auto &[share, fit] : source(ply, node))
          sum += weight * share * (*fit)(x);
    return sum;
  }



  std::vector<std::pair<Location::Place, double>>
  StressRecovery::nodes(const Place &place) const
  {
    std::vector<std::pair<Place, double>> result{{place, 1.}};
    for (unsigned int d = 0; d < 3; ++d)
      {
        if (degrees[d] == 0)
          continue;
        std::vector<std::pair<Place, double>> finer;
        for (const auto &[node, weight] : result)
          for (unsigned int i = 0; i < node_coordinates[d].size(); ++i)
            {
              Place next   = node;
              next.unit[d] = node_coordinates[d][i];
              finer.emplace_back(
                next, weight * lagrange(node_coordinates[d], i, place.unit[d]));
            }
        result = std::move(finer);
      }
    return result;
  }



  bool
  StressRecovery::is_node(const Place &place) const
  {
    for (unsigned int d = 0; d < 3; ++d)
      if (degrees[d] > 0 && std::none_of(node_coordinates[d].begin(),
                                         node_coordinates[d].end(),
                                         [&](const double t) {
                                           return std::abs(t - place.unit[d]) <
                                                  same_unit;
                                         }))
        return false;
    return true;
  }



  const std::vector<Location::Place> &
  StressRecovery::meeting(const unsigned int ply, const Place &place)
  {
    std::vector<Place> &places = element_patches[key_of(place)];
    if (places.empty())
      {
        const auto here = body.locate({body.position(place)});
        for (const Location &location : here.front())
          if (location.ply == ply)
            places = location.places;
        // Whatever the search makes of the point, it is in its own element.
        if (std::none_of(places.begin(), places.end(), [&](const Place &other) {
              return other.cell == place.cell;
            }))
          places.push_back(place);
        std::sort(places.begin(),
                  places.end(),
                  [](const Place &a, const Place &b) {
                    return a.cell < b.cell;
                  });
      }
    return places;
  }



  const StressRecovery::Source &
  StressRecovery::source(const unsigned int ply, const Place &node)
  {
    const std::vector<Place> &places = meeting(ply, node);
    const Key                 key    = key_of(places.front());
    const auto                known  = sources.find(key);
    if (known != sources.end())
      return known->second;

    Source     result;
    const auto larger =
      std::find_if(places.begin(), places.end(), [this](const Place &place) {
        return !is_node(place);
      });
    if (larger != places.end())
      {
        for (const auto &[other, weight] : nodes(*larger))
          if (weight != 0.)
            for (const auto &[share, fit] : source(ply, other))
              result.emplace_back(weight * share, fit);
      }
    else if (kind == StressValues::recovered)
      result = best_fits(ply, node);
    else
      result = {{1., &own_fit(ply, node)}};
    return sources[key] = result;
  }



  const PatchFit &
  StressRecovery::own_fit(const unsigned int ply, const Place &node)
  {
    const std::vector<Place>        &places = meeting(ply, node);
    std::unique_ptr<const PatchFit> &fit    = fits[key_of(places.front())];
    if (fit == nullptr && kind == StressValues::recovered)
      fit = std::make_unique<PatchFit>(patch_points(ply, places),
                                       frames(places),
                                       degrees_of(places));
    else if (fit == nullptr)
      {
        FieldValues mean;
        for (const Place &place : places)
          mean += 1. / places.size() * element_values(ply, place);
        fit = std::make_unique<PatchFit>(mean);
      }
    return *fit;
  }



  std::array<unsigned int, 3>
  StressRecovery::degrees_of(const std::vector<Place> &elements) const
  {
    std::array<unsigned int, 3> least = degrees;
    for (const Place &element : elements)
      {
        const auto own = body.recovery_degrees_of(element.cell);
        for (unsigned int d = 0; d < 3; ++d)
          least[d] = std::min(least[d], own[d]);
      }
    return least;
  }



  StressRecovery::Source
  StressRecovery::best_fits(const unsigned int ply, const Place &node)
  {
    const PatchFit          &own    = own_fit(ply, node);
    const std::vector<Place> places = meeting(ply, node);
    const auto               terms  = degrees_of(places);
    if (own.rank() == (terms[0] + 1) * (terms[1] + 1) * (terms[2] + 1))
      return {{1., &own}};

    // By terms first, by shared elements second.
    std::pair<unsigned int, std::size_t> best{own.rank(), places.size()};
    std::vector<const PatchFit *>        chosen{&own};
    for (const Place &place : places)
      for (const auto &corner : nodes(place))
        {
          const PatchFit           &fit    = own_fit(ply, corner.first);
          const std::vector<Place> &others = meeting(ply, corner.first);
          const std::size_t         shared =
            std::count_if(others.begin(), others.end(), [&](const Place &o) {
              return std::any_of(places.begin(),
                                 places.end(),
                                 [&o](const Place &p) {
                                   return p.cell == o.cell;
                                 });
            });
          const std::pair<unsigned int, std::size_t> worth{fit.rank(), shared};
          if (worth.first > own.rank() && worth > best)
            {
              best = worth;
              chosen.clear();
            }
          if (worth == best && worth.first > own.rank() &&
              std::find(chosen.begin(), chosen.end(), &fit) == chosen.end())
            chosen.push_back(&fit);
        }
    Source result;
    for (const PatchFit *fit : chosen)
      result.emplace_back(1. / chosen.size(), fit);
    return result;
  }



  bool
  StressRecovery::is_one_linear_layer(const unsigned int ply,
                                      Place              element,
                                      const unsigned int d)
  {
    if (body.recovery_degrees_of(element.cell)[d] != 1)
      return false;
    for (unsigned int other = 0; other < 3; ++other)
      if (degrees[other] > 0)
        element.unit[other] = 0.5;
    for (const double end : {0., 1.})
      {
        element.unit[d] = end;
        if (meeting(ply, element).size() > 1)
          return false;
      }
    return true;
  }



  std::vector<PatchPoint>
  StressRecovery::patch_points(const unsigned int        ply,
                               const std::vector<Place> &elements)
  {
    std::vector<PatchPoint> result;
    for (const Place &element : elements)
      {
        const auto own_degrees = body.recovery_degrees_of(element.cell);
        // All places of an element share its Gauss points.
        Place corner = element;
        for (unsigned int d = 0; d < 3; ++d)
          if (degrees[d] > 0)
            corner.unit[d] = 0.;
        std::vector<PatchPoint> &points = gauss_points[key_of(corner)];
        if (points.empty())
          {
            std::vector<Place> places{element};
            for (unsigned int d = 0; d < 3; ++d)
              {
                if (degrees[d] == 0)
                  continue;
                std::vector<Place> finer;
                const QGauss<1>    gauss(
                  is_one_linear_layer(ply, element, d) ? 2 : own_degrees[d]);
                for (Place place : places)
                  for (const Point<1> &point : gauss.get_points())
                    {
                      place.unit[d] = point[0];
                      finer.push_back(place);
                    }
                places = std::move(finer);
              }
            for (const Place &place : places)
              points.push_back(
                {body.position(place), element_values(ply, place)});
          }
        result.insert(result.end(), points.begin(), points.end());
      }
    return result;
  }



  std::vector<Tensor<2, 3>>
  StressRecovery::frames(const std::vector<Place> &elements) const
  {
    std::vector<Tensor<2, 3>> result;
    for (const Place &element : elements)
      {
        const Tensor<2, 3> frame = edges(body, element.cell);
        if (std::none_of(result.begin(),
                         result.end(),
                         [&frame](const Tensor<2, 3> &other) {
                           return same_directions(other, frame);
                         }))
          result.push_back(frame);
      }
    return result;
  }
} // namespace lamella
