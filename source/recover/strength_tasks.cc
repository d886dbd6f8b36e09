// SPDX-License-Identifier: LGPL-2.1-or-later

// What a sweep looks for: the criteria that each ply has to fear, and at which
// points of its elements.

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/patterns.h>
#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/recover/interlaminar.h>
#include <lamella/recover/strength_sweep.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Points of an element, 3 x 3 x 3, the third coordinate slowest, the second
    // along the axis. Of the four faces along the axis, at the beginning and
    // the end of the first and of the third coordinate: their middles.
    constexpr std::array<unsigned int, 4> middles{{12, 14, 4, 22}};



    /// Whether point @p k of an element is on the face @p f of those.
    bool
    is_on_face(const unsigned int k, const unsigned int f)
    {
      const unsigned int coordinate = f < 2 ? k % 3 : k / 9;
      return coordinate == (f % 2 == 0 ? 0 : 2);
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
    touched_faces(const Body &body, const unsigned int intervals)
    {
      const auto cells = output_cells(body, intervals, Vector(body.n_dofs()));
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
    , excluded_boxes(parameters.excluded_boxes)
    , stress(parameters.stress)
  {
    for (const unsigned int b : parameters.bodies)
      {
        if (stress == StressValues::equilibrium)
          laminate_box(*bodies[b], "Strength/Stress");
        SweptBody swept{b, tasks_of(*bodies[b]), {}};
        if (std::count(criteria.begin(),
                       criteria.end(),
                       Criterion::interlaminar) > 0)
          swept.touched = touched_faces(*bodies[b], intervals);
        all.push_back(std::move(swept));
      }
    for (const Criterion criterion : criteria)
      {
        const bool has_task =
          std::any_of(all.begin(), all.end(), [&](const SweptBody &swept) {
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
            "recover.criterion-unused: the criterion applies to no ply",
            "Core shear and core crushing need a material with Core strengths "
            "(a core), face wrinkling a ply on a core, others a ply that is no "
            "core. Remove the criterion, or write Core strengths.");
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
                       "recover.strength-missing: material '" + ply.material +
                         "' of body '" + body.name() + "' has no " + missing,
                       "Write " + missing + " in subsection Material " +
                         ply.material +
                         ", or remove the criterion or the body "
                         "(Strength/Bodies).");
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
          if (is_core(ply) != (criterion == Criterion::core_shear ||
                               criterion == Criterion::core_crushing))
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
  StrengthSweep::uses_point(const Task                &task,
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
  StrengthSweep::is_excluded(const Point<3> &x) const
  {
    return std::any_of(
      excluded_boxes.begin(), excluded_boxes.end(), [&x](const auto &box) {
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double rounding =
              arithmetic::same_position * (box[1] - box[0]).norm();
            if (x[c] < box[0][c] - rounding || x[c] > box[1][c] + rounding)
              return false;
          }
        return true;
      });
  }



  // Which rows of a sweep are nearest to failure, and what doubts there are.

  bool
  is_before(const Point<3> &a, const Point<3> &b, const double same)
  {
    for (unsigned int c = 0; c < 3; ++c)
      if (std::abs(a[c] - b[c]) > same)
        return a[c] < b[c];
    return false;
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
    return is_before(a.position,
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



  std::string
  worst_reserve_warning(const std::vector<PlyReserve> &rows,
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
        if (region.body == worst->body && region.has_point_at(x, near))
          why = "load " + load.name + " acts on a line or point there";
    for (const PrescribedFunctional &row :
         prescribed_functionals(supports, bodies))
      if (row.row.body == worst->body && !supports[row.support].isostatic &&
          row.position.distance(x) <= near)
        why = "support " + supports[row.support].name + " acts on that point";
    if (why.empty() && worst->stress_discrepancy > much)
      why = "the stress of the element and the recovered stress differ by " +
            to_text(100. * worst->stress_discrepancy, 2) + " % there";
    if (why.empty())
      return "";
    return "recover.stress-singular: the smallest reserve factor, " +
           to_text(*worst->reserve, 4) + " of ply " +
           std::to_string(worst->ply + 1) + " of body '" +
           bodies[worst->body]->name() + "' at " + to_text(x) +
           ", may belong to a stress singularity, where it decreases with each "
           "refinement without limit: " +
           why + ". Exclude it by Strength/Excluded boxes, or refine the mesh";
  }



  void
  StrengthParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Criteria",
                      "",
                      Patterns::Anything(),
                      "Failure criteria, with '|' between: " +
                        joined(criterion_names()) +
                        ". Empty: no reserve factors are computed.");
    prm.declare_entry("Bodies",
                      "",
                      Patterns::Anything(),
                      "Bodies to check, between commas. Empty: all.");
    prm.declare_entry("Excluded boxes",
                      "",
                      Patterns::Anything(),
                      "Boxes that are not checked, for stress singularities: "
                      "two opposite corners in scene coordinates, x, y, z: x, "
                      "y, z, with '|' between boxes.");
    prm.declare_entry("Stress",
                      name_of(StressValues::recovered),
                      selection<StressValues>(),
                      "Stresses at the most critical points: recovered, or "
                      "equilibrium (laminates only), as in a Probe.");
  }



  namespace
  {
    std::vector<Criterion>
    parse_criteria(const Entry &entry)
    {
      std::vector<Criterion> criteria;
      for (const std::string &item : entry.items('|'))
        {
          const auto criterion = named<Criterion>(item);
          if (!criterion)
            entry.refuse("recover.unknown-criterion: there is no criterion '" +
                           item + "'",
                         "Check the spelling: the most similar name is '" +
                           nearest_name(item, criterion_names()) +
                           "'; the criteria are " + joined(criterion_names()) +
                           ".");
          if (std::find(criteria.begin(), criteria.end(), *criterion) !=
              criteria.end())
            entry.refuse("recover.named-twice: '" + item +
                         "' is given twice; remove one of the two");
          criteria.push_back(*criterion);
        }
      return criteria;
    }



    std::vector<unsigned int>
    parse_bodies(const Entry &entry, const std::vector<std::string> &bodies)
    {
      std::vector<unsigned int> numbers;
      for (const std::string &item : entry.items())
        {
          Entry(entry.path(), item).among(bodies, "body", "Bodies");
          numbers.push_back(std::find(bodies.begin(), bodies.end(), item) -
                            bodies.begin());
        }
      if (numbers.empty())
        for (unsigned int b = 0; b < bodies.size(); ++b)
          numbers.push_back(b);
      std::sort(numbers.begin(), numbers.end());
      if (const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
          twice != numbers.end())
        entry.refuse("recover.named-twice: '" + bodies[*twice] +
                     "' is given twice; remove one of the two");
      return numbers;
    }



    std::array<Point<3>, 2>
    parse_box(const Entry &entry, const std::string &text)
    {
      const std::vector<std::string> corners = split(text, ':');
      if (corners.size() != 2)
        entry.refuse("recover.not-a-box: '" + text +
                       "' is no box; a box is given by two opposite corners",
                     "Write x, y, z: x, y, z, and '|' between boxes.");
      const std::array<Point<3>, 2> box = {
        {entry.point(corners[0]), entry.point(corners[1])}};
      for (unsigned int c = 0; c < 3; ++c)
        if (box[0][c] > box[1][c])
          entry.refuse("recover.not-a-box: the first corner of box '" + text +
                         "' has the larger coordinate " +
                         std::string(1, "xyz"[c]),
                       "Write the smaller coordinates in the first corner.");
      return box;
    }
  } // namespace



  StrengthParameters
  StrengthParameters::parse(const Entries                  &in,
                            const std::vector<std::string> &bodies)
  {
    StrengthParameters result;
    result.criteria = parse_criteria(in["Criteria"]);
    result.bodies   = parse_bodies(in["Bodies"], bodies);
    for (const std::string &item : in["Excluded boxes"].items('|'))
      result.excluded_boxes.push_back(parse_box(in["Excluded boxes"], item));
    result.stress = in["Stress"].choice<StressValues>();
    if (result.stress != StressValues::recovered &&
        result.stress != StressValues::equilibrium)
      in["Stress"].refuse(
        "recover.stress-not-accurate: reserve factors need more accurate "
        "stresses than Stress = element or nodal gives",
        "Write Stress = recovered or equilibrium.");
    if (result.criteria.empty())
      for (const char *name : {"Bodies", "Excluded boxes"})
        if (!in[name].is_empty())
          in[name].refuse("recover.no-criteria: this entry has no effect, "
                          "since Strength has no Criteria",
                          "Write Criteria, or remove this entry.");
    return result;
  }
} // namespace lamella
