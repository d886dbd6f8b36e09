// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/memory.h>
#include <lamella/trade/rung_result.h>

namespace lamella
{
  RungValues::RungValues(const Results &results)
    : ResultNumbers(results)
    , dofs(results.n_dofs())
    , memory(results.peak_memory / megabyte)
    , seconds(results.seconds)
  {}



  RungValues::RungValues(const nlohmann::json &json)
    : ResultNumbers(json)
  {
    json.at("dofs").get_to(dofs);
    json.at("peak_memory_mb").get_to(memory);
    json.at("seconds").get_to(seconds);
  }



  nlohmann::json
  RungValues::to_json() const
  {
    nlohmann::json json    = ResultNumbers::to_json();
    json["dofs"]           = dofs;
    json["peak_memory_mb"] = memory;
    json["seconds"]        = seconds;
    return json;
  }



  void
  RungValues::tell_cost(RungResult &result) const
  {
    result.dofs   = dofs;
    result.memory = memory;
    result.phases = seconds;
  }
} // namespace lamella
