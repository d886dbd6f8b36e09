// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/memory.h>
#include <lamella/trade/variant_result.h>

namespace lamella
{
  VariantValues::VariantValues(const Results &results)
    : ResultNumbers(results)
    , dofs(results.n_dofs())
    , memory(results.peak_memory / megabyte)
    , seconds(results.seconds)
    , stiffening(results.worst_nonlinearity().stiffening)
    , buckling_factor(results.worst_nonlinearity().buckling_factor)
  {
    for (const GoalResult &goal : results.goals)
      bars[goal.name] = {goal.estimate, goal.bar, goal.trusted};
  }



  VariantValues::VariantValues(const nlohmann::json &json)
    : ResultNumbers(json)
  {
    json.at("dofs").get_to(dofs);
    json.at("peak_memory_mb").get_to(memory);
    json.at("seconds").get_to(seconds);
    json.at("stiffening").get_to(stiffening);
    if (const auto &factor = json.at("buckling_factor"); !factor.is_null())
      buckling_factor = factor.get<double>();
    for (const auto &[label, bar] : json.at("bars").items())
      bars[label] = {bar.at("estimate"), bar.at("bar"), bar.at("trusted")};
  }



  nlohmann::json
  VariantValues::to_json() const
  {
    nlohmann::json json    = ResultNumbers::to_json();
    json["dofs"]           = dofs;
    json["peak_memory_mb"] = memory;
    json["seconds"]        = seconds;
    json["stiffening"]     = stiffening;
    json["buckling_factor"] =
      buckling_factor ? nlohmann::json(*buckling_factor) : nlohmann::json();
    json["bars"] = nlohmann::json::object();
    for (const auto &[label, bar] : bars)
      json["bars"][label] = {{"estimate", bar.estimate},
                             {"bar", bar.bar},
                             {"trusted", bar.trusted}};
    return json;
  }



  void
  VariantValues::tell(VariantResult &result) const
  {
    result.dofs            = dofs;
    result.memory          = memory;
    result.phases          = seconds;
    result.stiffening      = stiffening;
    result.buckling_factor = buckling_factor;
  }



  std::optional<RunErrorBar>
  VariantValues::bar(const NamedQuantity &quantity) const
  {
    const auto place = bars.find(quantity.label());
    return place == bars.end() ? std::nullopt :
                                 std::make_optional(place->second);
  }
} // namespace lamella
