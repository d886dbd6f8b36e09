// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/processes.h>
#include <lamella/body/fields.h>
#include <lamella/recover/interlaminar.h>
#include <lamella/recover/strength_sweep.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of the largest 1/R of a ply, what makes a point worth recovering.
    constexpr double near = 0.8;



    double
    nearness(const Assessment &assessment)
    {
      if (!assessment.reserve)
        return 0.;
      constexpr double nothing_left = 1e-6;
      return 1. / std::max(*assessment.reserve, nothing_left);
    }



    /// The points of elements that share corners come several times.
    std::vector<Point<3>>
    without_duplicates(std::vector<Point<3>> points, const double same)
    {
      std::sort(points.begin(),
                points.end(),
                [=](const auto &a, const auto &b) {
                  return is_before(a, b, same);
                });
      points.erase(std::unique(points.begin(),
                               points.end(),
                               [=](const auto &a, const auto &b) {
                                 return a.distance(b) <= same;
                               }),
                   points.end());
      return points;
    }



    /// The worst of each of @p rows over all processes.
    std::vector<std::optional<PlyReserve>>
    worst_of_processes(const std::vector<std::optional<PlyReserve>> &rows)
    {
      if (n_processes() == 1)
        return rows;
      std::map<unsigned int, PlyReserve> own;
      for (unsigned int t = 0; t < rows.size(); ++t)
        if (rows[t])
          own[t] = *rows[t];
      std::vector<std::optional<PlyReserve>> result(rows.size());
      for (const auto &of_process :
           Utilities::MPI::all_gather(communicator(), own))
        for (const auto &[t, row] : of_process)
          if (!result[t] || is_worse(row, *result[t]))
            result[t] = row;
      return result;
    }
  } // namespace



  class StrengthSweep::Along
  {
  public:
    explicit Along(const Body &body)
    {
      if (body.is_nodal())
        return;
      start        = body.dof(0).position;
      Point<3> end = start;
      for (DofIndex dof = 0; dof < body.n_dofs(); ++dof)
        if (body.dof(dof).position.distance(start) > end.distance(start))
          end = body.dof(dof).position;
      const double length = end.distance(start);
      direction           = (end - start) / length;
      same                = arithmetic::same_position * length;
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



  /// Sampled points of a task, those near the largest 1/R so far, and it.
  class StrengthSweep::Candidates
  {
  public:
    void
    add(const Point<3> &x, const double nearness)
    {
      if (nearness < near * largest)
        return;
      largest = std::max(largest, nearness);
      points.push_back({x, nearness});
    }

    /// Returns those near @p most, the largest of all processes, by @p same.
    std::vector<Point<3>>
    nearest(const double most, const double same) const
    {
      std::vector<Point<3>> result;
      for (const Candidate &point : points)
        if (point.nearness >= near * most)
          result.push_back(point.x);
      // Unstressed, all points are alike.
      if (most == 0. && result.size() > 1)
        result.resize(1);
      return without_duplicates(std::move(result), same);
    }

    double largest = 0.;

  private:
    struct Candidate
    {
      Point<3> x;
      double   nearness;
    };
    std::vector<Candidate> points;
  };



  void
  StrengthSweep::evaluate_cell(const SweptCell &cell,
                               const Task      &task,
                               Along           &along,
                               Candidates      &candidates) const
  {
    for (unsigned int k = 0; k < cell.loaded.samples.size(); ++k)
      {
        const Point<3> &x = cell.loaded.positions[k];
        if (!uses_point(task, cell.touched, k))
          continue;
        if (is_excluded(x))
          {
            along.add(task.ply, x, -1.);
            continue;
          }
        const Voigt &stress = cell.loaded.samples[k].ply_stress;
        const Voigt  stays  = cell.thermal_part == nullptr ?
                                Voigt() :
                                cell.thermal_part->samples[k].ply_stress;
        const double value =
          nearness(task.surface.assess(stress - stays, stays));
        along.add(task.ply, x, value);
        candidates.add(x, value);
      }
  }



  std::vector<std::vector<Point<3>>>
  StrengthSweep::find_candidates(const SweptBody     &swept,
                                 const Displacements &at,
                                 Along               &along) const
  {
    const Body             &body         = *bodies[swept.body];
    const auto              cells        = output_cells(body, intervals, at.u);
    const auto              thermal_part = at.thermal_part == nullptr ?
                                             std::vector<OutputCell>() :
                                             output_cells(body, intervals, *at.thermal_part);
    const auto             &tasks        = swept.tasks;
    std::vector<Candidates> candidates(tasks.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int t = 0; t < tasks.size(); ++t)
        if (tasks[t].ply == cells[c].ply)
          evaluate_cell({cells[c],
                         thermal_part.empty() ? nullptr : &thermal_part[c],
                         swept.touched.empty() ? std::array<bool, 4>{} :
                                                 swept.touched[c]},
                        tasks[t],
                        along,
                        candidates[t]);
    std::vector<double> largest;
    for (const Candidates &of_task : candidates)
      largest.push_back(of_task.largest);
    Utilities::MPI::max(largest, communicator(), largest);

    std::vector<std::vector<Point<3>>> result;
    for (unsigned int t = 0; t < tasks.size(); ++t)
      result.push_back(
        candidates[t].nearest(largest[t],
                              arithmetic::same_position * body.size()));
    return result;
  }



  std::optional<PlyReserve>
  StrengthSweep::worst_row(const SweptBody             &swept,
                           const Task                  &task,
                           const std::vector<Point<3>> &points,
                           const Stresses              &stresses) const
  {
    const Body               &body = *bodies[swept.body];
    std::optional<PlyReserve> worst;
    for (const std::vector<Location> &here : body.locate(points))
      for (const Location &location : here)
        {
          if (location.ply != task.ply)
            continue;
          const Voigt stress  = stresses.recovered(location).ply_stress;
          const Voigt element = body.sample(location, stresses.u).ply_stress;
          const Voigt stays =
            stresses.thermal_recovery == nullptr ?
              Voigt() :
              stresses.thermal_recovery->sample(location).ply_stress;
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



  void
  StrengthSweep::add_worst_rows(
    const SweptBody                          &swept,
    const std::vector<std::vector<Point<3>>> &points,
    const Stresses                           &stresses,
    std::vector<PlyReserve>                  &plies) const
  {
    std::vector<std::optional<PlyReserve>> own;
    for (unsigned int t = 0; t < swept.tasks.size(); ++t)
      own.push_back(worst_row(swept, swept.tasks[t], points[t], stresses));
    const auto worst = worst_of_processes(own);
    for (unsigned int t = 0; t < swept.tasks.size(); ++t)
      if (worst[t])
        plies.push_back(*worst[t]);
  }



  StrengthSweep::Found
  StrengthSweep::sweep(const BlockVector   &u,
                       const FaceTractions &tractions,
                       const BlockVector   *thermal_part) const
  {
    Found found;
    for (const SweptBody &swept : all)
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
        const Vector *const thermal_factor =
          thermal_part == nullptr ? nullptr : &thermal_part->block(swept.body);
        std::unique_ptr<StressRecovery> thermal_recovery;
        if (thermal_factor != nullptr)
          thermal_recovery =
            std::make_unique<StressRecovery>(body,
                                             *thermal_factor,
                                             StressValues::recovered);
        Along      along(body);
        const auto points =
          find_candidates(swept, {displacement, thermal_factor}, along);
        for (const ReserveAlong &row : along.rows(swept.body))
          found.along.push_back(row);
        add_worst_rows(swept,
                       points,
                       {displacement, recovered, thermal_recovery.get()},
                       found.plies);
      }
    return found;
  }



  double
  StrengthSweep::inverse_reserve(const unsigned int body,
                                 const unsigned int ply,
                                 const Voigt       &ply_stress) const
  {
    double largest = 0.;
    for (const SweptBody &swept : all)
      for (const Task &task : swept.tasks)
        if (swept.body == body && task.ply == ply &&
            task.criterion != Criterion::interlaminar)
          largest =
            std::max(largest, nearness(task.surface.assess(ply_stress)));
    return largest;
  }
} // namespace lamella
