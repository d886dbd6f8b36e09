// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/version.h>
#include <lamella/body/fields.h>
#include <lamella/contact/contact_patch.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/recover/sampler.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/report/summary.h>

#include <nlohmann/json.hpp>

namespace lamella
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    Json
    to_json(const dealii::Tensor<1, 3> &v)
    {
      return Json::array({v[0], v[1], v[2]});
    }



    Json
    contact_json(const Results &results, const unsigned int k)
    {
      const ContactSummary     &contact = results.contacts[k];
      const KktResidual        &kkt = results.steps.back().checks.contacts[k];
      std::vector<unsigned int> closed, opened;
      for (const StepResults &step : results.steps)
        {
          closed.push_back(step.changes[k].closed);
          opened.push_back(step.changes[k].opened);
        }
      Json json{{"discretization", name_of(contact.discretization)},
                {"enforcement", name_of(contact.enforcement)},
                {"rows", contact.rows},
                {"unpaired", contact.unpaired},
                {"unpaired_second", contact.unpaired_second},
                {"active", kkt.active},
                {"closed", closed},
                {"opened", opened},
                {"force", to_json(kkt.force)},
                {"moment", to_json(kkt.moment)},
                {"center_of_pressure", to_json(kkt.center_of_pressure)},
                {"max_penetration", kkt.max_penetration},
                {"max_penetration_relative",
                 kkt.max_penetration / results.size},
                {"min_force", kkt.min_force},
                {"complementarity", kkt.complementarity},
                {"law_error", kkt.law_error},
                {"initial_gap_min", contact.initial_gap_min},
                {"initial_gap_max", contact.initial_gap_max}};
      if (kkt.obstacle_displacement)
        json["obstacle_displacement"] = to_json(*kkt.obstacle_displacement);
      if (contact.friction > 0.)
        json["friction"] = {{"coefficient", contact.friction},
                            {"force", to_json(kkt.shear)},
                            {"sticking_area", kkt.sticking},
                            {"slipping_area", kkt.slipping},
                            {"dissipated", kkt.dissipated}};
      // A step that another run solved has no points.
      if (const auto &points = results.steps.back().contacts; k < points.size())
        {
          const ContactTraction traction = traction_of(contact, points[k]);
          const ContactPatch    patch(traction);
          if (contact.is_tied())
            {
              json["peel"]  = patch.peel();
              json["shear"] = patch.shear();
              return json;
            }
          json["pressure"] = patch.pressure();
          json["width"]    = patch.width();
        }
      return json;
    }



    /// What friction makes of the load steps; empty without it.
    Json
    path_json(const Results &results)
    {
      Json json;
      if (results.steps.empty() || !has_friction(results))
        return json;
      const FrictionState &friction = results.last().state.friction;
      for (const StepResults &step : results.steps)
        {
          json["substeps"].push_back(step.substeps);
          json["changes"].push_back(step.change ? Json(*step.change) : Json());
        }
      json["dissipated"] = friction.all_dissipated();
      // Half the work is a matter of linear theory.
      if (!results.last().checks.is_large)
        json["gap"] = friction.path_gap;
      return json;
    }



    Json
    solver_json(const SolverStatistics &solver)
    {
      Json json{{"name", name_of(solver.kind)},
                {"solutions", solver.solutions}};
      if (solver.kind == SolverKind::cg)
        {
          json["iterations"]      = solver.iterations;
          json["most_iterations"] = solver.max_iterations_per_solve;
        }
      else
        json["factor_non_zeros"] = solver.non_zeros;
      return json;
    }



    /// What is known before a step is solved, and what the run cost.
    Json
    run_json(const Results &results)
    {
      Json json;
      json["version"] = version();
      json["title"]   = results.title;
      json["units"]   = {{"length", results.units.length},
                         {"force", results.units.force},
                         {"stress", results.units.stress}};
      for (const BodySummary &body : results.bodies)
        json["theory"][body.name] = body.theory;
      json["dofs"] = results.n_dofs();
      for (const BodySummary &body : results.bodies)
        {
          json["bodies"][body.name]["dofs"] = body.dofs;
          if (body.solver)
            json["bodies"][body.name]["solver"] = solver_json(*body.solver);
        }
      for (const auto &[phase, seconds] : results.seconds)
        json["seconds"][phase] = seconds;
      json["processes"]             = results.processes;
      json["peak_memory_mb"]        = results.peak_memory / megabyte;
      json["peak_memory_of_all_mb"] = results.peak_memory_of_all / megabyte;
      json["load_steps"]            = results.steps.size();
      json["load_steps_of_scene"]   = results.load_steps;
      return json;
    }



    Json
    goal_json(const GoalResult &goal)
    {
      Json json{{"value", goal.value},
                {"estimate", goal.estimate},
                {"corrected", goal.value + goal.estimate},
                {"trusted", goal.trusted},
                {"scale", goal.scale}};
      if (goal.trusted)
        json["bar"] = goal.bar;
      else
        json["why"] = goal.why;
      for (const auto &[source, share] : goal.shares)
        json["shares"][source] = share;
      if (goal.tolerance)
        {
          json["tolerance"] = goal.allowed_error();
          json["met"]       = goal.met();
        }
      return json;
    }



    /// A row of plies.csv.
    Json
    reserve_json(const Results &results, const PlyReserve &row)
    {
      Json json = {{"body", results.bodies[row.body].name},
                   {"ply", row.ply + 1},
                   {"criterion", row.criterion},
                   {"mode", row.mode},
                   {"index", row.index},
                   {"place", to_json(row.position)}};
      if (row.reserve)
        json["reserve_factor"] = *row.reserve;
      if (row.angle)
        json["angle"] = *row.angle;
      return json;
    }



    Json
    support_json(const Resultant &reaction)
    {
      Json json{{"reaction", to_json(reaction.force)},
                {"moment", to_json(reaction.moment)},
                {"about", to_json(reaction.about)}};
      if (reaction.center_of_pressure)
        json["center_of_pressure"] = to_json(*reaction.center_of_pressure);
      return json;
    }



    /// By kind and name; nothing where no stress is by equilibrium.
    void
    add_defects(const Results            &results,
                const EquilibriumDefects &defects,
                Json                     &json)
    {
      for_each_defect(results,
                      defects,
                      [&json](const std::string &kind,
                              const std::string &name,
                              const double       share) {
                        json["equilibrium_closure"][kind + "s"][name] = share;
                      });
    }



    Json
    buckling_json(const std::optional<double> &factor)
    {
      return factor ? Json(*factor) : Json();
    }



    /// What large deflections would change: of each step, and the worst.
    Json
    beyond_json(const Results &results)
    {
      const NonlinearityEstimate worst = results.worst_nonlinearity();
      Json                       json{{"stiffening", worst.stiffening},
                {"buckling_factor", buckling_json(worst.buckling_factor)},
                {"steps", Json::array()}};
      if (worst.stiffening > 0.)
        json["stiffened"] = results.bodies[worst.stiffened].name;
      if (worst.buckling_factor)
        json["buckled"] = results.bodies[worst.buckled].name;
      for (const StepResults &step : results.steps)
        json["steps"].push_back(
          {{"stiffening", step.checks.beyond.stiffening},
           {"buckling_factor",
            buckling_json(step.checks.beyond.buckling_factor)}});
      return json;
    }



    /// Of each probe a row a ply, by the columns of probes.csv.
    Json
    probes_json(const Results &results)
    {
      Json        json   = Json::object();
      const auto &probes = results.steps.back().probes;
      for (unsigned int p = 0; p < probes.size(); ++p)
        for (const FieldRow &row : probes[p])
          {
            Json of_row{{"body", row.body}, {"ply", row.ply + 1}};
            for (unsigned int c = 0; c < 3; ++c)
              of_row[std::string(1, "xyz"[c])] = row.position[c];
            const std::vector<double> values = field_values(row.sample);
            for (unsigned int k = 0; k < values.size(); ++k)
              of_row[field_names()[k]] = values[k];
            json[results.probes[p]].push_back(of_row);
          }
      return json;
    }



    /// How stresses and tractions jump at the ply interfaces of lines.
    void
    add_jumps(const Results &results, const StepResults &last, Json &json)
    {
      json["interface_jumps"]              = Json::object();
      json["interface_jumps_of_tractions"] = Json::object();
      for (unsigned int l = 0; l < results.lines.size(); ++l)
        if (last.jumps[l].interfaces > 0)
          {
            const auto &[name, jump] =
              std::tie(results.lines[l], last.jumps[l]);
            json["interface_jumps"][name]              = jump.of_stress;
            json["interface_jumps_of_tractions"][name] = jump.of_traction;
          }
    }



    void
    add_checks(const Results &results, const Checks &checks, Json &json)
    {
      json["force_balance"]        = checks.force_balance;
      json["moment_balance"]       = checks.moment_balance;
      json["residual"]             = checks.residual;
      json["max_rotation"]         = checks.max_rotation;
      json["energy"]               = checks.energy;
      json["stabilization_energy"] = checks.stabilization_energy;
      json["rotations"]            = checks.is_large ? "large" : "linear";
      if (checks.is_large)
        {
          json["max_strain"]           = checks.max_strain;
          json["max_rms_strain"]       = checks.max_rms_strain;
          json["max_element_rotation"] = checks.max_element_rotation;
          json["shape_change"]         = checks.shape_change;
          return;
        }
      json["beyond_linear"]  = beyond_json(results);
      json["external_work"]  = checks.external_work;
      json["energy_balance"] = checks.energy_balance;
    }



    /// Resultants and checks of the last load step.
    void
    add_last_step(const Results &results, Json &json)
    {
      const StepResults &last   = results.steps.back();
      const Checks      &checks = last.checks;
      for (unsigned int k = 0; k < results.contacts.size(); ++k)
        json["contacts"][results.contacts[k].name] = contact_json(results, k);
      for (unsigned int s = 0; s < results.supports.size(); ++s)
        json["supports"][results.supports[s]] =
          support_json(checks.reactions[s]);
      json["probes"] = probes_json(results);
      for (unsigned int m = 0; m < results.measures.size(); ++m)
        json["measures"][results.measures[m]] = last.measures[m];
      add_checks(results, checks, json);
      json["condition_estimate"]  = results.condition_estimate;
      json["free_corrections"]    = last.state.free_corrections;
      json["contact_corrections"] = last.state.contact_corrections;
      if (const PlyReserve *worst = worst_of(last.plies))
        json["strength"] = reserve_json(results, *worst);
      if (const auto &first = results.first_failure; first && first->where)
        {
          json["first_failure"] = reserve_json(results, *first->where);
          json["first_failure"]["load_factor"] = first->failing;
          json["first_failure"]["safe"]        = first->safe;
        }
      add_jumps(results, last, json);
      add_defects(results, last.defects, json);
    }



    /// Returns the numbers of solutions of the contact laws by each method.
    Json
    methods_json(const Results &results)
    {
      MethodCounts sums{};
      for (const StepResults &step : results.steps)
        for (unsigned int m = 0; m < sums.size(); ++m)
          sums[m] += step.state.solved_by[m];
      return {{"Newton", sums[0]},
              {"interior point", sums[1]},
              {"compliance", sums[2]}};
    }
  } // namespace



  std::string
  summary_text(const Results &results)
  {
    Json json = run_json(results);
    for (const char *const kind : {"contacts", "supports", "loads", "measures"})
      json[kind] = Json::object();
    json["iterations"] = Json::array();
    for (const StepResults &step : results.steps)
      json["iterations"].push_back(step.state.iterations);
    json["contact_problems"] = methods_json(results);
    if (const Json path = path_json(results); !path.empty())
      json["path"] = path;
    for (const LoadResultant &load : results.loads)
      json["loads"][load.name] = {{"force", to_json(load.force)},
                                  {"moment", to_json(load.moment)}};
    if (!results.steps.empty())
      add_last_step(results, json);
    add_modes(results, json);
    json["quantities"] = results.quantities;
    for (const GoalResult &goal : results.goals)
      json["goals"][goal.name] = goal_json(goal);
    if (!results.goals.empty())
      json["seconds_of_error_bars"] = results.seconds_of_goals;
    if (!results.no_goals_reason.empty())
      json["no_error_bars"] = results.no_goals_reason;
    json["converged"] = results.converged;
    json["warnings"]  = Json::array();
    for (const std::string &warning : results.all_warnings())
      {
        const Message message(warning);
        json["warnings"].push_back(
          {{"identifier", message.identifier}, {"text", message.text}});
      }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }
} // namespace lamella
