// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/output_file.h>
#include <lamella/report/summary.h>

#include <nlohmann/json.hpp>

namespace lamella
{
  using Json = nlohmann::ordered_json;

  std::string
  name_of(const Discretisation discretisation)
  {
    switch (discretisation)
      {
        case Discretisation::node_to_node:
          return "node to node";
        case Discretisation::node_to_surface:
          return "node to surface";
        case Discretisation::surface_to_surface:
          return "surface to surface";
        case Discretisation::undefined:
          break;
      }
    return "undefined";
  }



  std::string
  name_of(const Enforcement enforcement)
  {
    switch (enforcement)
      {
        case Enforcement::penalty:
          return "penalty";
        case Enforcement::augmented_lagrangian:
          return "augmented lagrangian";
        case Enforcement::exact:
          return "exact";
        case Enforcement::undefined:
          break;
      }
    return "undefined";
  }



  double
  scene_size(const Structure &structure)
  {
    dealii::BoundingBox<3> box = structure.bodies().front()->bounding_box();
    for (const auto &body : structure.bodies())
      box.merge_with(body->bounding_box());
    const auto corners = box.get_boundary_points();
    return corners.first.distance(corners.second);
  }



  namespace
  {
    Json
    to_json(const dealii::Tensor<1, 3> &v)
    {
      return Json::array({v[0], v[1], v[2]});
    }



    Json
    contact_json(const Summary &summary, const unsigned int k)
    {
      const ContactInterface &contact = (*summary.contacts)[k];
      const KuhnTucker       &kkt     = summary.checks.contacts[k];
      double smallest = contact.rows.front().initial_gap, largest = smallest;
      for (const GapRow &row : contact.rows)
        {
          smallest = std::min(smallest, row.initial_gap);
          largest  = std::max(largest, row.initial_gap);
        }
      std::vector<unsigned int> closed, opened;
      for (const auto &change : summary.status_changes[k])
        {
          closed.push_back(change.closed);
          opened.push_back(change.opened);
        }
      return {{"discretisation", name_of(contact.discretisation)},
              {"enforcement", name_of((*summary.pairs)[k].enforcement)},
              {"rows", contact.rows.size()},
              {"unpaired", contact.unpaired},
              {"unpaired_second", contact.unpaired_second},
              {"active", kkt.active},
              {"closed", closed},
              {"opened", opened},
              {"force", to_json(kkt.force)},
              {"max_penetration", kkt.max_penetration},
              {"max_penetration_relative",
               kkt.max_penetration / scene_size(*summary.structure)},
              {"min_force", kkt.min_force},
              {"complementarity", kkt.complementarity},
              {"law_error", kkt.law_error},
              {"initial_gap_min", smallest},
              {"initial_gap_max", largest}};
    }



    Json
    solver_json(const SolverStatistics &solver)
    {
      Json json{{"name", name_of(solver.kind)},
                {"solutions", solver.solutions}};
      if (solver.kind == SolverKind::cg)
        {
          json["iterations"]      = solver.iterations;
          json["most_iterations"] = solver.most_iterations;
        }
      else
        json["factor_non_zeros"] = solver.non_zeros;
      return json;
    }
  } // namespace



  void
  write_summary(const Summary &summary, const std::string &directory)
  {
    constexpr double megabyte = 1024. * 1024.;
    Json             json;
    json["version"] = LAMELLA_VERSION;
    json["title"]   = summary.title;
    json["units"]   = {{"length", summary.units.length},
                       {"force", summary.units.force},
                       {"stress", summary.units.stress}};
    for (const auto &body : summary.structure->bodies())
      json["theory"][body->name()] = body->theory();
    json["dofs"] = summary.structure->n_dofs();
    for (const auto &body : summary.structure->bodies())
      json["bodies"][body->name()]["dofs"] = body->n_dofs();
    for (const auto &[phase, seconds] : summary.seconds)
      json["seconds"][phase] = seconds;
    for (const auto &[body, solver] : summary.solvers)
      json["bodies"][body]["solver"] = solver_json(solver);
    json["processes"]             = summary.processes;
    json["peak_memory_mb"]        = summary.peak_memory / megabyte;
    json["peak_memory_of_all_mb"] = summary.peak_memory_of_all / megabyte;
    json["load_steps"]            = summary.iterations.size();
    json["iterations"]            = summary.iterations;
    json["contacts"]              = Json::object();
    json["supports"]              = Json::object();
    const bool solved =
      summary.checks.contacts.size() == summary.contacts->size();
    for (unsigned int k = 0; solved && k < summary.contacts->size(); ++k)
      json["contacts"][(*summary.contacts)[k].name] = contact_json(summary, k);
    for (unsigned int s = 0; s < summary.checks.reactions.size(); ++s)
      json["supports"][summary.support_names[s]]["reaction"] =
        to_json(summary.checks.reactions[s]);
    json["loads"] = Json::object();
    for (const LoadResultant &load : summary.structure->load_resultants())
      json["loads"][load.name] = {{"force", to_json(load.force)},
                                  {"moment", to_json(load.moment)}};
    json["force_balance"]        = summary.checks.force_balance;
    json["residual"]             = summary.checks.residual;
    json["max_rotation"]         = summary.checks.max_rotation;
    json["energy"]               = summary.checks.energy;
    json["external_work"]        = summary.checks.external_work;
    json["energy_balance"]       = summary.checks.energy_balance;
    json["stabilisation_energy"] = summary.checks.stabilisation_energy;
    json["condition_estimate"]   = summary.condition_estimate;
    json["free_corrections"]     = summary.free_corrections;
    json["contact_corrections"]  = summary.contact_corrections;
    json["interface_jumps"]      = summary.interface_jumps;
    json["converged"]            = summary.converged;
    json["warnings"]             = summary.warnings;

    write_file(directory + "/summary.json",
               json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  }
} // namespace lamella
