// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/entry.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/text.h>
#include <lamella/section/theory.h>
#include <lamella/trade/trade_findings.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace lamella
{
  using nlohmann::json;

  namespace
  {
    Theory
    theory_of(const VariantResult &variant)
    {
      return Theory::parse(Entry("Theory", variant.theory));
    }



    /// Whether the theory of @p one holds that of @p other. Runs to a tolerance
    /// hold those to a larger one, and no others.
    bool
    holds(const VariantResult &one, const VariantResult &other)
    {
      if (one.tolerance || other.tolerance)
        return one.tolerance && other.tolerance &&
               *one.tolerance <= *other.tolerance;
      return theory_of(one).holds(theory_of(other));
    }



    json
    number(const std::optional<double> &value)
    {
      return value ? json(*value) : json();
    }



    json
    to_json(const VariantResult &variant, const std::vector<VariantResult> &all)
    {
      json held = json::array(), bars = json::array();
      for (unsigned int k = 0; k < all.size(); ++k)
        if (holds(variant, all[k]))
          held.push_back(k);
      for (const std::optional<RunErrorBar> &own : variant.bars)
        bars.push_back(
          own ? json{{"bar", own->bar}, {"trusted", own->trusted}} : json());
      return {{"name", variant.name},
              {"theory", variant.theory},
              {"is_solid", !variant.tolerance && theory_of(variant).is_solid()},
              {"holds", held},
              {"failure", variant.failure},
              {"seconds", variant.seconds},
              {"phases", variant.phases},
              {"dofs", variant.dofs},
              {"memory", variant.memory},
              {"values", variant.values},
              {"bars", bars},
              {"axis", variant.axis},
              {"section", variant.section},
              {"overridden", variant.overridden},
              {"stiffening", variant.stiffening},
              {"buckling_factor", number(variant.buckling_factor)}};
    }
  } // namespace



  void
  present_trade(const TradeFindings &findings, const std::string &directory)
  {
    json trade{{"title", findings.title},
               {"remark", findings.remark},
               {"phases", phase_names()},
               {"reference", findings.reference},
               {"tolerances", findings.tolerances},
               {"variants", json::array()},
               {"quantities", json::array()}};
    for (const VariantResult &variant : findings.variants)
      trade["variants"].push_back(to_json(variant, findings.variants));
    for (const NamedQuantity &quantity : findings.quantities)
      trade["quantities"].push_back(
        {{"label", quantity.label()}, {"given", number(quantity.given)}});
    write_file(directory + "/trade.json", trade.dump(1) + "\n");

    const std::string python = python_with("json");
    if (python.empty())
      throw InputError(
        "trade.no-python: the tables need python3. Install it and start the "
        "trade again; finished variants are not repeated.");
    const std::string errors = directory + "/trade_errors.txt";
    const ProcessEnd  end =
      run_process(python,
                  {"-X", "utf8", path_of_script("trade.py"), directory},
                  "",
                  errors);
    std::ostringstream message;
    message << std::ifstream(errors).rdbuf();
    std::filesystem::remove(errors);
    if (end.status == 2)
      throw NumericsError("trade.no-reference: The reference solution of the "
                          "trade is missing, so there are no errors. Cause: " +
                          trimmed(message.str()));
    if (end.status != 0)
      throw InputError("trade.tables-failed: the tables of the trade could not "
                       "be written. Correct the cause and start the trade "
                       "again; finished variants are not repeated. Cause: " +
                       trimmed(message.str()));
  }
} // namespace lamella
