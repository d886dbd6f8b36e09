// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/report/console.h>
#include <lamella/report/goals_table.h>
#include <lamella/report/summary.h>
#include <lamella/report/tables.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <ostream>

namespace lamella
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// Returns the goal that is the value of @p mode and has a bar, or null.
    const GoalResult *
    goal_of(const char *const kind, const Mode &mode, const Results &results)
    {
      const std::string name = kind + std::to_string(mode.number) + ": ";
      for (const GoalResult &goal : results.goals)
        if (goal.trusted && goal.name.rfind(name, 0) == 0)
          return &goal;
      return nullptr;
    }



    /// Returns the bar of @p mode for the table; empty if there is none.
    std::string
    bar_text(const char *const kind, const Mode &mode, const Results &results)
    {
      const GoalResult *const goal = goal_of(kind, mode, results);
      return goal == nullptr ? "" : "+- " + share_text(*goal, goal->bar);
    }



    std::string
    line_of(const char *const analysis,
            const char *const kind,
            const Mode       &mode,
            const Results    &results)
    {
      CsvLine           line;
      const GoalResult *goal = goal_of(kind, mode, results);
      line << analysis << mode.number << mode.value
           << (goal == nullptr ? "" : csv(goal->bar)) << mode.kind()
           << results.bodies[mode.body].name;
      for (const double factor : mode.participation)
        line << factor;
      for (const double share : mode.motion.shares)
        line << share;
      return line.text();
    }



    /// The motion with the largest share, and its share unless nearly all.
    std::string
    describe_motion(const Mode &mode)
    {
      constexpr double nearly_all = 0.99;
      const double     largest =
        *std::max_element(mode.motion.shares.begin(), mode.motion.shares.end());
      return mode.kind() + (largest < nearly_all ?
                              " " + to_text(100. * largest, 2) + " %" :
                              "");
    }



    Json
    mode_json(const Mode &mode, const Results &results, const char *const value)
    {
      Json json{{"number", mode.number},
                {value, mode.value},
                {"kind", mode.kind()},
                {"body", results.bodies[mode.body].name}};
      for (unsigned int k = 0; k < mode.motion.shares.size(); ++k)
        json["motion"][motion_names[k]] = mode.motion.shares[k];
      return json;
    }



    /// Returns an effective mass in percent of the mass of @p inertia; what
    /// symmetry makes zero without its rounding.
    std::string
    effective_mass(const double effective, const Inertia &inertia)
    {
      return effective < arithmetic::negligible * inertia.mass ?
               "0" :
               to_text(100. * effective / inertia.mass, 3);
    }



    /// Returns the columns that are linear in the displacements.
    std::vector<unsigned int>
    columns_of_response()
    {
      std::vector<unsigned int> columns;
      for (unsigned int c = 0; c < field_names().size(); ++c)
        if (kind_of_column(field_names()[c]) != 'j')
          columns.push_back(c);
      return columns;
    }



    /// Returns the phase angle of @p value in degrees.
    double
    degrees(const std::complex<double> &value)
    {
      return std::arg(value) * 180. / dealii::numbers::PI;
    }



    /// Prints the largest amplitude of each displacement component at probes.
    void
    print_response(std::ostream &out, const Results &results)
    {
      out << "\nHarmonic response, largest amplitudes:\n";
      TextTable table{{"probe", "column", "amplitude", "at Hz", "phase, deg"}};
      for (unsigned int p = 0; p < results.probes.size(); ++p)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const HarmonicRow *peak = nullptr;
            for (const HarmonicRow &row : results.response)
              if (row.probe == p &&
                  (peak == nullptr ||
                   std::abs(row.values[c]) > std::abs(peak->values[c])))
                peak = &row;
            table.push_back({results.probes[p],
                             field_names()[c],
                             to_text(std::abs(peak->values[c]), 5),
                             to_text(peak->frequency, 6),
                             to_text(degrees(peak->values[c]), 3)});
          }
      print_table(out, table);
    }



    void
    print_natural_modes(std::ostream &out, const Results &results)
    {
      const NaturalModes &found = *results.natural_modes;
      out << "\nNatural modes:\n";
      print_inertia(out, *results.inertia);
      if (found.n_rigid > 0)
        out << found.n_rigid
            << (found.n_rigid == 1 ? " rigid motion" : " rigid motions")
            << " at 0 Hz\n";
      TextTable             table{{"mode",
                                   "Hz",
                                   "bar",
                                   "kind",
                                   "body",
                                   "mass x %",
                                   "mass y %",
                                   "mass z %"}};
      std::array<double, 3> sums{};
      for (const Mode &mode : found.modes)
        {
          table.push_back({std::to_string(mode.number),
                           to_text(mode.value, 6),
                           bar_text("mode-", mode, results),
                           describe_motion(mode),
                           results.bodies[mode.body].name});
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double p = mode.participation[d];
              table.back().push_back(effective_mass(p * p, *results.inertia));
              sums[d] += p * p;
            }
        }
      table.push_back({"sum", "", "", "", ""});
      for (const double sum : sums)
        table.back().push_back(effective_mass(sum, *results.inertia));
      print_table(out, table);
    }
  } // namespace



  void
  print_inertia(std::ostream &out, const Inertia &inertia)
  {
    const dealii::SymmetricTensor<2, 3> moments = inertia.about_center();
    out << "Mass " << to_text(inertia.mass, 6) << " at "
        << to_text(inertia.center()) << ", moments of inertia about it "
        << to_text(dealii::Tensor<1, 3>(
             {moments[0][0], moments[1][1], moments[2][2]}))
        << "\n";
  }



  std::string
  modes_csv(const Results &results)
  {
    CsvLine header;
    for (const char *const name : {"analysis",
                                   "number",
                                   "value",
                                   "bar",
                                   "kind",
                                   "body",
                                   "px",
                                   "py",
                                   "pz",
                                   "rx",
                                   "ry",
                                   "rz"})
      header << name;
    for (const char *const name : motion_names)
      header << name;
    std::string text = header.text();
    if (results.natural_modes)
      for (const Mode &mode : results.natural_modes->modes)
        text += line_of("modes", "mode-", mode, results);
    for (const Mode &mode : results.buckling_modes)
      text += line_of("buckling", "buckling-", mode, results);
    return text;
  }



  std::string
  response_csv(const Results &results)
  {
    const std::vector<unsigned int> columns = columns_of_response();
    CsvLine                         header;
    header << "frequency"
           << "probe"
           << "ply";
    for (const unsigned int c : columns)
      header << field_names()[c] << field_names()[c] + " phase";
    std::string text = header.text();
    for (const HarmonicRow &row : results.response)
      {
        CsvLine line;
        line << row.frequency << results.probes[row.probe]
             << (row.ply == several_plies ? 0 : row.ply + 1);
        for (const unsigned int c : columns)
          line << std::abs(row.values[c]) << degrees(row.values[c]);
        text += line.text();
      }
    return text;
  }



  void
  print_modes(std::ostream &out, const Results &results)
  {
    if (results.natural_modes)
      print_natural_modes(out, results);
    if (!results.response.empty())
      print_response(out, results);
    if (results.buckling_modes.empty())
      return;
    out << "\nBuckling modes, factors of the loads of the last load step:\n";
    TextTable table{{"mode", "factor", "bar", "kind", "body"}};
    for (const Mode &mode : results.buckling_modes)
      table.push_back({std::to_string(mode.number),
                       to_text(mode.value, 6),
                       bar_text("buckling-", mode, results),
                       describe_motion(mode),
                       results.bodies[mode.body].name});
    print_table(out, table);
  }



  void
  add_modes(const Results &results, Json &json)
  {
    if (results.inertia)
      {
        const auto list = [](const auto &tensor) {
          return Json::array({tensor[0], tensor[1], tensor[2]});
        };
        const auto moments = results.inertia->about_center();
        json["inertia"]    = {{"mass", results.inertia->mass},
                              {"center", list(results.inertia->center())},
                              {"moments", Json::array()}};
        for (unsigned int i = 0; i < 3; ++i)
          json["inertia"]["moments"].push_back(list(moments[i]));
      }
    if (results.natural_modes)
      {
        const NaturalModes &found = *results.natural_modes;
        json["rigid_modes"]       = found.n_rigid;
        json["modes"]             = Json::array();
        for (const Mode &mode : found.modes)
          {
            Json one              = mode_json(mode, results, "frequency");
            one["effective_mass"] = Json::array();
            for (const double factor : mode.participation)
              one["effective_mass"].push_back(factor * factor);
            json["modes"].push_back(one);
          }
      }
    for (const Mode &mode : results.buckling_modes)
      json["buckling_modes"].push_back(mode_json(mode, results, "factor"));
  }
} // namespace lamella
