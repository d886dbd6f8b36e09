// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/recover/interlaminar.h>
#include <lamella/recover/strength_sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Points of an element, 3 x 3 x 3, the third coordinate slowest, the second
    // along the axis. Of the four faces along the axis, at the beginning and
    // the end of the first and of the third coordinate: their middles.
    constexpr std::array<unsigned int, 4> middles{{12, 14, 4, 22}};
    constexpr unsigned int                intervals = 2;



    /// Whether point @p k of an element is on the face @p f of those.
    bool
    is_on_face(const unsigned int k, const unsigned int f)
    {
      const unsigned int coordinate = f < 2 ? k % 3 : k / 9;
      return coordinate == (f % 2 == 0 ? 0 : 2);
    }

    // Of the largest 1/R of a ply, what makes a point worth recovering.
    constexpr double near = 0.8;



    bool
    is_of_core(const Criterion criterion)
    {
      return criterion == Criterion::core_shear ||
             criterion == Criterion::core_crushing;
    }



    bool
    is_core(const Ply &ply)
    {
      return ply.properties.core.has_value();
    }



    /// The core that ply @p k of a laminate lies on; null if it is on none.
    const Ply *
    core_below_or_above(const std::vector<Ply> &plies, const unsigned int k)
    {
      if (is_core(plies[k]))
        return nullptr;
      const auto is_core_of_wall = [&](const unsigned int other) {
        return is_core(plies[other]) &&
               plies[other].plane.wall == plies[k].plane.wall;
      };
      if (k > 0 && is_core_of_wall(k - 1))
        return &plies[k - 1];
      return k + 1 < plies.size() && is_core_of_wall(k + 1) ? &plies[k + 1] :
                                                              nullptr;
    }



    double
    nearness(const Assessment &assessment)
    {
      if (!assessment.reserve)
        return 0.;
      constexpr double nothing_left = 1e-6;
      return 1. / std::max(*assessment.reserve, nothing_left);
    }



    /// Whether the face @p f of @p cell lies in the plane of the cell's ply,
    /// and not across it: a ply that ends there shares no interface.
    bool
    is_in_ply_plane(const OutputCell &cell, const unsigned int f)
    {
      constexpr double cosine = 0.7;
      // A step along the face in the section, and one along the axis.
      const unsigned int m      = middles[f];
      const unsigned int across = f < 2 ? 9 : 1;
      const Tensor<1, 3> normal =
        cross_product_3d(cell.positions[m + across] -
                           cell.positions[m - across],
                         cell.positions[m + 3] - cell.positions[m - 3]);
      return std::abs(normal * cell.ply_normal) > cosine * normal.norm();
    }



    /// Of each element of this process, whether another ply touches its faces.
    std::vector<std::array<bool, 4>>
    touched_faces(const Body &body)
    {
      const auto cells = body.output_cells(intervals, Vector(body.n_dofs()));
      std::vector<Point<3>> points;
      for (const OutputCell &cell : cells)
        for (const unsigned int k : middles)
          points.push_back(cell.positions[k]);
      const auto                       found = body.locate(points);
      std::vector<std::array<bool, 4>> touched(cells.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (unsigned int f = 0; f < 4; ++f)
          touched[c][f] =
            found[4 * c + f].size() > 1 && is_in_ply_plane(cells[c], f);
      return touched;
    }
  } // namespace



  StrengthSweep::StrengthSweep(const Bodies             &bodies,
                               const StrengthParameters &parameters)
    : bodies(bodies)
    , criteria(parameters.criteria)
    , leave_out(parameters.leave_out)
    , stress(parameters.stress)
  {
    for (const unsigned int b : parameters.bodies)
      {
        if (stress == StressValues::equilibrium)
          laminate_box(*bodies[b], "Strength/Stress");
        Swept swept{b, tasks_of(*bodies[b]), {}};
        if (std::count(criteria.begin(),
                       criteria.end(),
                       Criterion::interlaminar) > 0)
          swept.touched = touched_faces(*bodies[b]);
        all.push_back(std::move(swept));
      }
    for (const Criterion criterion : criteria)
      {
        const bool has_task =
          std::any_of(all.begin(), all.end(), [&](const Swept &swept) {
            return std::any_of(swept.tasks.begin(),
                               swept.tasks.end(),
                               [&](const Task &task) {
                                 return task.criterion == criterion;
                               });
          });
        if (!has_task)
          throw InputError(
            "Strength/Criteria",
            name_of(criterion),
            "no ply that is looked at has it to fear",
            "It is of cores, whose material has Core strengths, and of the "
            "plies upon them; others are of plies that are no cores.");
      }
  }



  void
  StrengthSweep::require(const Criterion criterion,
                         const Ply      &ply,
                         const Body     &body) const
  {
    const std::string missing = missing_entry(criterion, ply.properties);
    if (!missing.empty())
      throw InputError("Strength/Criteria",
                       name_of(criterion),
                       "material '" + ply.material + "' of body '" +
                         body.name() + "' has no " + missing,
                       "Give it " + missing + " in subsection Material " +
                         ply.material +
                         ", or leave out the criterion, or the body from "
                         "Strength/Bodies.");
  }



  std::vector<StrengthSweep::Task>
  StrengthSweep::tasks_of(const Body &body) const
  {
    const std::vector<Ply> &plies = body.plies();
    std::vector<Task>       tasks;
    for (unsigned int k = 0; k < plies.size(); ++k)
      for (const Criterion criterion : criteria)
        {
          const Ply        &ply = plies[k];
          WrinklingStresses wrinkling;
          if (is_core(ply) != is_of_core(criterion))
            continue;
          if (criterion == Criterion::face_wrinkling)
            {
              const Ply *core = core_below_or_above(plies, k);
              if (core == nullptr)
                continue;
              wrinkling = wrinkling_stresses(ply.properties.elastic,
                                             core->properties.elastic,
                                             ply.angle,
                                             core->angle);
            }
          require(criterion, ply, body);
          tasks.push_back(
            {k,
             criterion,
             FailureSurface(criterion, ply.properties, wrinkling)});
        }
    return tasks;
  }



  bool
  StrengthSweep::looks_at(const Task                &task,
                          const std::array<bool, 4> &touched,
                          const unsigned int         k)
  {
    if (task.criterion != Criterion::interlaminar)
      return true;
    for (unsigned int f = 0; f < 4; ++f)
      if (touched[f] && is_on_face(k, f))
        return true;
    return false;
  }



  bool
  StrengthSweep::is_left_out(const Point<3> &x) const
  {
    return std::any_of(
      leave_out.begin(), leave_out.end(), [&x](const auto &box) {
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double rounding =
              arithmetic::same_place * (box[1] - box[0]).norm();
            if (x[c] < box[0][c] - rounding || x[c] > box[1][c] + rounding)
              return false;
          }
        return true;
      });
  }



  namespace
  {
    /// Whether @p a comes before @p b, coordinates closer than @p same being
    /// equal.
    bool
    before(const Point<3> &a, const Point<3> &b, const double same)
    {
      for (unsigned int c = 0; c < 3; ++c)
        if (std::abs(a[c] - b[c]) > same)
          return a[c] < b[c];
      return false;
    }



    /// The points of elements that share corners come several times.
    std::vector<Point<3>>
    without_repetitions(std::vector<Point<3>> points, const double same)
    {
      std::sort(points.begin(),
                points.end(),
                [=](const auto &a, const auto &b) {
                  return before(a, b, same);
                });
      points.erase(std::unique(points.begin(),
                               points.end(),
                               [=](const auto &a, const auto &b) {
                                 return a.distance(b) <= same;
                               }),
                   points.end());
      return points;
    }
  } // namespace



  class StrengthSweep::Along
  {
  public:
    explicit Along(const Body &body)
    {
      if (body.is_nodal())
        return;
      start        = body.dof_position(0);
      Point<3> end = start;
      for (DofIndex dof = 0; dof < body.n_dofs(); ++dof)
        if (body.dof_position(dof).distance(start) > end.distance(start))
          end = body.dof_position(dof);
      const double length = end.distance(start);
      direction           = (end - start) / length;
      same                = arithmetic::same_place * length;
    }

    void
    add(const unsigned int ply, const Point<3> &x, const double value)
    {
      if (same == 0.)
        return;
      const Key key{ply, std::llround((x - start) * direction / same)};
      double   &largest = stations.emplace(key, value).first->second;
      largest           = std::max(largest, value);
    }

    void
    leave_out(const unsigned int ply, const Point<3> &x)
    {
      add(ply, x, -1.);
    }

    /// Of all processes, as rows of body @p body. Collective.
    std::vector<ReserveAlong>
    rows(const unsigned int body) const
    {
      std::map<Key, double> all;
      for (const auto &of_process :
           Utilities::MPI::all_gather(communicator(), stations))
        for (const auto &[key, value] : of_process)
          {
            double &largest = all.emplace(key, value).first->second;
            largest         = std::max(largest, value);
          }
      std::vector<ReserveAlong> result;
      for (const auto &[key, value] : all)
        {
          const double s = same * key.second;
          result.push_back(
            {body,
             key.first,
             s,
             start + s * direction,
             value < 0. ? std::nullopt : std::make_optional(value)});
        }
      return result;
    }

  private:
    /// A ply, and the station in units of `same`.
    using Key = std::pair<unsigned int, long long>;

    Point<3>              start;
    Tensor<1, 3>          direction;
    double                same = 0.;
    std::map<Key, double> stations;
  };



  std::vector<std::vector<Point<3>>>
  StrengthSweep::near_failure(const Swept         &swept,
                              const Displacements &at,
                              Along               &along) const
  {
    struct Candidate
    {
      Point<3> x;
      double   nearness;
    };
    const Body         &body  = *bodies[swept.body];
    const auto          cells = body.output_cells(intervals, at.u);
    const auto          cured = at.cured == nullptr ?
                                  std::vector<OutputCell>() :
                                  body.output_cells(intervals, *at.cured);
    const auto         &tasks = swept.tasks;
    std::vector<double> largest(tasks.size(), 0.);
    std::vector<std::vector<Candidate>> points(tasks.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int t = 0; t < tasks.size(); ++t)
        {
          if (tasks[t].ply != cells[c].ply)
            continue;
          const std::array<bool, 4> touched =
            swept.touched.empty() ? std::array<bool, 4>{} : swept.touched[c];
          for (unsigned int k = 0; k < cells[c].samples.size(); ++k)
            {
              const Point<3> &x = cells[c].positions[k];
              if (!looks_at(tasks[t], touched, k))
                continue;
              if (is_left_out(x))
                {
                  along.leave_out(tasks[t].ply, x);
                  continue;
                }
              const Voigt &stress = cells[c].samples[k].ply_stress;
              const Voigt  stays =
                cured.empty() ? Voigt() : cured[c].samples[k].ply_stress;
              const double value =
                nearness(tasks[t].surface.assess(stress - stays, stays));
              along.add(tasks[t].ply, x, value);
              if (value < near * largest[t])
                continue;
              largest[t] = std::max(largest[t], value);
              points[t].push_back({x, value});
            }
        }
    Utilities::MPI::max(largest, communicator(), largest);

    std::vector<std::vector<Point<3>>> result(tasks.size());
    for (unsigned int t = 0; t < tasks.size(); ++t)
      {
        for (const Candidate &point : points[t])
          if (point.nearness >= near * largest[t])
            result[t].push_back(point.x);
        // Unstressed, all points are alike.
        if (largest[t] == 0. && result[t].size() > 1)
          result[t].resize(1);
        result[t] = without_repetitions(std::move(result[t]),
                                        arithmetic::same_place * body.size());
      }
    return result;
  }



  std::optional<PlyReserve>
  StrengthSweep::worst_row(const Swept                 &swept,
                           const Task                  &task,
                           const std::vector<Point<3>> &points,
                           const Vector                &u,
                           const Fields                &recovered,
                           StressRecovery              *cure) const
  {
    const Body               &body = *bodies[swept.body];
    std::optional<PlyReserve> worst;
    for (const std::vector<Location> &here : body.locate(points))
      for (const Location &location : here)
        {
          if (location.ply != task.ply)
            continue;
          const Voigt stress  = recovered(location).ply_stress;
          const Voigt element = body.sample(location, u).ply_stress;
          const Voigt stays =
            cure == nullptr ? Voigt() : cure->sample(location).ply_stress;
          const auto       found = task.surface.assess(stress - stays, stays);
          const PlyReserve row{swept.body,
                               task.ply,
                               name_of(task.criterion),
                               std::string(found.mode),
                               found.reserve,
                               found.index,
                               location.position,
                               found.angle,
                               stress.norm() > 0. ?
                                 (element - stress).norm() / stress.norm() :
                                 0.};
          if (!worst || is_worse(row, *worst))
            worst = row;
        }
    return worst;
  }



  namespace
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();



    /// The worst of each of @p rows over all processes.
    std::vector<std::optional<PlyReserve>>
    worst_of_processes(const std::vector<std::optional<PlyReserve>> &rows)
    {
      if (n_processes() == 1)
        return rows;
      constexpr unsigned int n = 7;
      std::vector<double>    numbers;
      std::string            modes;
      for (const auto &row : rows)
        {
          const PlyReserve r = row.value_or(PlyReserve());
          for (const double value : {row ? 1. : 0.,
                                     r.reserve.value_or(none),
                                     r.index,
                                     r.position[0],
                                     r.position[1],
                                     r.position[2],
                                     r.angle.value_or(none)})
            numbers.push_back(value);
          numbers.push_back(r.doubt);
          modes += r.mode + "|";
        }
      const auto all_numbers =
        Utilities::MPI::all_gather(communicator(), numbers);
      const auto all_modes = Utilities::MPI::all_gather(communicator(), modes);

      const auto optional = [](const double value) {
        return std::isnan(value) ? std::nullopt : std::make_optional(value);
      };
      std::vector<std::optional<PlyReserve>> result(rows.size());
      for (unsigned int process = 0; process < all_numbers.size(); ++process)
        {
          const auto names = split(all_modes[process] + "-", '|');
          for (unsigned int t = 0; t < rows.size(); ++t)
            {
              const double *v = &all_numbers[process][(n + 1) * t];
              if (v[0] == 0.)
                continue;
              PlyReserve row;
              row.mode     = names[t];
              row.reserve  = optional(v[1]);
              row.index    = v[2];
              row.position = Point<3>(v[3], v[4], v[5]);
              row.angle    = optional(v[6]);
              row.doubt    = v[7];
              if (!result[t] || is_worse(row, *result[t]))
                result[t] = row;
            }
        }
      return result;
    }
  } // namespace



  StrengthSweep::Found
  StrengthSweep::sweep(const BlockVector   &u,
                       const FaceTractions &tractions,
                       const BlockVector   *cured) const
  {
    Found found;
    for (const Swept &swept : all)
      {
        const Vector                    &displacement = u.block(swept.body);
        const Body                      &body         = *bodies[swept.body];
        std::optional<EquilibriumStress> columns;
        if (stress == StressValues::equilibrium)
          columns.emplace(
            body, swept.body, displacement, tractions, "Strength/Stress");
        StressRecovery patches(body, displacement, StressValues::recovered);
        const auto     recovered = [&](const Location &location) {
          return columns ? columns->sample(location) : patches.sample(location);
        };
        const Vector *const of_heat =
          cured == nullptr ? nullptr : &cured->block(swept.body);
        std::unique_ptr<StressRecovery> cure;
        if (of_heat != nullptr)
          cure = std::make_unique<StressRecovery>(body,
                                                  *of_heat,
                                                  StressValues::recovered);
        Along      along(body);
        const auto points = near_failure(swept, {displacement, of_heat}, along);
        for (const ReserveAlong &row : along.rows(swept.body))
          found.along.push_back(row);
        std::vector<std::optional<PlyReserve>> own;
        for (unsigned int t = 0; t < swept.tasks.size(); ++t)
          own.push_back(worst_row(swept,
                                  swept.tasks[t],
                                  points[t],
                                  displacement,
                                  recovered,
                                  cure.get()));
        const auto worst = worst_of_processes(own);
        for (unsigned int t = 0; t < swept.tasks.size(); ++t)
          if (worst[t])
            {
              found.plies.push_back(*worst[t]);
              PlyReserve &row = found.plies.back();
              row.body        = swept.body;
              row.ply         = swept.tasks[t].ply;
              row.criterion   = name_of(swept.tasks[t].criterion);
            }
      }
    return found;
  }



  double
  StrengthSweep::inverse_reserve(const unsigned int body,
                                 const unsigned int ply,
                                 const Voigt       &ply_stress) const
  {
    double largest = 0.;
    for (const Swept &swept : all)
      for (const Task &task : swept.tasks)
        if (swept.body == body && task.ply == ply &&
            task.criterion != Criterion::interlaminar)
          largest =
            std::max(largest, nearness(task.surface.assess(ply_stress)));
    return largest;
  }



  bool
  is_worse(const PlyReserve &a, const PlyReserve &b)
  {
    // Above what solvers leave of symmetric places.
    constexpr double same = 1e-7;
    if (a.reserve.has_value() != b.reserve.has_value())
      return a.reserve.has_value();
    const double of_a = a.reserve ? *a.reserve : -a.index,
                 of_b = b.reserve ? *b.reserve : -b.index;
    if (std::abs(of_a - of_b) > same * std::max(std::abs(of_a), std::abs(of_b)))
      return of_a < of_b;
    return before(a.position,
                  b.position,
                  same * (a.position.norm() + b.position.norm()));
  }



  const PlyReserve *
  worst_of(const std::vector<PlyReserve> &rows)
  {
    const PlyReserve *worst = nullptr;
    for (const PlyReserve &row : rows)
      if (worst == nullptr || is_worse(row, *worst))
        worst = &row;
    return worst;
  }



  namespace
  {
    /// Whether @p x is on the segment from @p a to @p b.
    bool
    is_on(const Point<3> &x,
          const Point<3> &a,
          const Point<3> &b,
          const double    near)
    {
      const Tensor<1, 3> along = b - a;
      const double       t =
        along.norm() > 0. ?
                std::clamp(((x - a) * along) / along.norm_square(), 0., 1.) :
                0.;
      return x.distance(a + t * along) <= near;
    }



    bool
    is_on_line_or_point(const Region   &region,
                        const Point<3> &x,
                        const double    near)
    {
      if (region.kind == Region::Kind::line)
        return is_on(x, region.at.front(), region.at.back(), near);
      return region.kind == Region::Kind::point &&
             std::any_of(region.at.begin(),
                         region.at.end(),
                         [&](const auto &at) {
                           return x.distance(at) <= near;
                         });
    }
  } // namespace



  std::string
  doubt_of_worst(const std::vector<PlyReserve> &rows,
                 const std::vector<Support>    &supports,
                 const std::vector<Load>       &loads,
                 const Bodies                  &bodies)
  {
    constexpr double  much  = 0.1;
    const PlyReserve *worst = worst_of(rows);
    if (worst == nullptr || !worst->reserve)
      return "";
    const Point<3> &x = worst->position;
    const double    near =
      arithmetic::same_in_element * bodies[worst->body]->size();

    std::string why;
    for (const Load &load : loads)
      for (const Region &region : load.on)
        if (region.body == worst->body && is_on_line_or_point(region, x, near))
          why = "load " + load.name + " acts on a line or point there";
    for (const PrescribedRow &row : prescribed_rows(supports, bodies))
      if (row.row.body == worst->body && !supports[row.support].hold &&
          row.position.distance(x) <= near)
        why = "support " + supports[row.support].name + " holds that point";
    if (why.empty() && worst->doubt > much)
      why = "the element's stress and the recovered one differ by " +
            to_text(100. * worst->doubt, 2) + " % there";
    if (why.empty())
      return "";
    return "the smallest reserve factor, " + to_text(*worst->reserve, 4) +
           " of ply " + std::to_string(worst->ply + 1) + " of body '" +
           bodies[worst->body]->name() + "' at " + to_text(x) +
           ", may be of a singular stress and fall with each refinement: " +
           why +
           "; leave the place out (Strength/Leave out), or refine and see";
  }
} // namespace lamella
