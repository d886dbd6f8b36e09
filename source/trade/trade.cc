// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/interruption.h>
#include <lamella/base/mpi_session.h>
#include <lamella/base/text.h>
#include <lamella/base/version.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/tolerance_run.h>
#include <lamella/run/run_scene.h>
#include <lamella/trade/trade.h>
#include <lamella/trade/trade_picture.h>

#include <boost/interprocess/sync/file_lock.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <ostream>
#include <set>
#include <sstream>

namespace lamella
{
  using nlohmann::json;
  namespace fs = std::filesystem;

  namespace
  {
    /// The record of a rung that has ended, in its folder.
    constexpr const char *record_name = "rung.json";

    /// Runs that take less than `short_run` seconds are made `tries` times, and
    /// the fastest counts.
    constexpr double       short_run = 1.;
    constexpr unsigned int tries     = 3;

    std::vector<std::string>
    operator+(std::vector<std::string> a, const std::vector<std::string> &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }



    /// @p resolved without its `subsection Trade`, which no rung looks at.
    std::string
    without_trade(const std::string &resolved)
    {
      const std::string begin = "subsection Trade\n", end = "\nend\n";
      const auto        first = resolved.find(begin);
      const auto        last  = resolved.find(end, first);
      if (first == std::string::npos || last == std::string::npos)
        return resolved;
      return resolved.substr(0, first) + resolved.substr(last + end.size());
    }



    /// Of a file: its size and when it was last written.
    std::string
    state_of_file(const std::string &path)
    {
      std::error_code error;
      const auto      size = fs::file_size(path, error);
      const auto      time = fs::last_write_time(path, error);
      return std::to_string(size) + " bytes, " +
             std::to_string(time.time_since_epoch().count());
    }



    /// A folder's name for the rung @p name: letters, digits, '-' and '.'.
    std::string
    folder_name(const unsigned int number, const std::string &name)
    {
      std::ostringstream text;
      text << std::setw(2) << std::setfill('0') << number << '_';
      for (const char c : name)
        text << (std::isalnum(static_cast<unsigned char>(c)) || c == '.' ||
                     c == '-' ?
                   c :
                   '_');
      // File systems end names at 255 bytes.
      return text.str().substr(0, 100);
    }



    std::string
    whole_file(const std::string &path)
    {
      std::ostringstream text;
      text << std::ifstream(path).rdbuf();
      return text.str();
    }



    /// Why a run that ended so has no results; empty if it has.
    std::string
    failure_of(const ProcessEnd  &end,
               const std::string &errors,
               const double       time_limit)
    {
      if (end.out_of_time)
        return "took more than the time limit of " + to_text(time_limit) +
               " s.";
      if (end.signal != 0)
        return "was ended by signal " + std::to_string(end.signal) +
               (end.signal == 9 ? ", perhaps because memory ran out." : ".");
      if (end.status == 0)
        return json::accept(end.answer) ? "" : "ended without its numbers.";
      const std::string message = trimmed(whole_file(errors));
      return message.empty() ?
               "ended with exit status " + std::to_string(end.status) + "." :
               message;
    }



    /// Puts @p record into @p folder, all of it or nothing.
    void
    keep_record(const json &record, const std::string &folder)
    {
      const std::string path = folder + "/" + record_name;
      std::ofstream     file(path + ".new");
      file << record.dump(2) << "\n";
      file.close();
      std::error_code error;
      fs::rename(path + ".new", path, error);
      if (!file || error)
        throw InputError("Cannot write " + path + ". Is the disk full?");
    }



    /// The record in @p folder if it says @p fingerprint and the rung
    /// succeeded, null otherwise: what made one fail (a time limit, other
    /// programs' memory) may have passed.
    json
    record_in(const std::string &folder, const std::string &fingerprint)
    {
      std::ifstream file(folder + "/" + record_name);
      const json    record = json::parse(file, nullptr, false);
      return record.is_object() && record.value("of", "") == fingerprint &&
                 record.value("failure", "?").empty() &&
                 record.contains("values") ?
               record :
               json();
    }



    /// Puts what the run with the numbers @p other cost into @p values of
    /// another run of the same scene.
    void
    take_costs(json &values, const json &other)
    {
      for (const char *cost : {"peak_memory_mb", "seconds"})
        values[cost] = other.at(cost);
    }



    /// What is known of a rung before it is run.
    RungResult
    result_of(const LadderEntry &entry)
    {
      RungResult result;
      result.name       = entry.name;
      result.theory     = entry.theory;
      result.axis       = entry.axis;
      result.section    = entry.section;
      result.overridden = !entry.overrides.empty();
      result.tolerance  = entry.tolerance;
      return result;
    }



    void
    prepare_directory(const std::string &directory)
    {
      std::error_code error;
      fs::create_directories(directory + "/rungs", error);
      // The lock needs a file; it is not emptied, should another have it.
      if (error || !std::ofstream(directory + "/trade.lock", std::ios::app))
        throw InputError("results cannot be written there. Name a folder that "
                         "can be created and written.")
          .at("--output " + directory + ": ");
    }
  } // namespace



  Trade::Trade(const std::string              &scene_file,
               const std::vector<std::string> &overrides,
               const Scene                    &scene,
               const unsigned int              threads,
               std::ostream                   &out)
    : scene_file(scene_file)
    , overrides(overrides)
    , scene(scene)
    , threads(threads)
    , out(out)
    , base(fingerprint(overrides))
    , quantities(scene.trade.quantities)
  {
    if (quantities.empty() && scene.trade.whole_probes.empty())
      throw InputError("Trade/Quantities",
                       "",
                       "there is nothing to compare, since the scene has "
                       "neither probes nor References of supports and contacts",
                       "Add a probe.");
    for (const LadderEntry &entry : scene.trade.ladder)
      try
        {
          check_entries(
            SceneText::read(scene_file, overrides + entry.overrides));
        }
      catch (const InputError &error)
        {
          throw InputError("Trade/Ladder",
                           entry.name,
                           "the scene cannot be read with this rung's entries",
                           error.what());
        }
  }



  std::string
  Trade::fingerprint(const std::vector<std::string> &rung_overrides) const
  {
    std::string text;
    try
      {
        const Scene rung =
          read_scene(SceneText::read(scene_file, rung_overrides));
        text = without_trade(rung.resolved);
        for (const auto &[name, shape] : rung.sections)
          if (const auto *file = std::get_if<SectionFile>(&shape))
            text += "mesh " + state_of_file(file->path) + "\n";
      }
    catch (const InputError &error)
      {
        // The rung will say so itself.
        for (const std::string &assignment : rung_overrides)
          if (assignment.compare(0, 6, "Trade/") != 0)
            text += assignment + "\n";
        text += error.what() + std::string("\n");
      }
    return text + "program " + version() + ", " + state_of_file(own_program()) +
           ", threads " + std::to_string(threads);
  }



  std::string
  Trade::fingerprint(const LadderEntry              &entry,
                     const std::vector<std::string> &all) const
  {
    // The goals of a scene do not tell: it may have the same ones itself.
    return fingerprint(all) + (entry.tolerance        ? ", to a tolerance" :
                               scene.trade.error_bars ? ", with error bars" :
                                                        "");
  }



  json
  Trade::answer_of(const Job &job, const std::string &output) const
  {
    const SceneText text = SceneText::read(
      scene_file, std::vector<std::string>{"Write VTU=false"} + job.overrides);
    const Scene rung = read_scene(text);
    if (job.entry.tolerance)
      try
        {
          ToleranceRun passes(rung, std::cout);
          passes.run(output);
          return {{"values", RungValues(passes.results()).to_json()},
                  {"seconds_of_bars", 0.}};
        }
      catch (const InputError &error)
        {
          throw text.placed(error);
        }
    const auto simulation      = make_simulation(rung, text, std::cout);
    double     seconds_of_bars = 0.;
    lamella::run_scene(*simulation, output, false, [&] {
      if (!job.bars)
        return;
      const dealii::Timer wall;
      ModelCache          cache;
      simulation->set_goals(Estimation(*simulation, std::cout, cache).goals());
      seconds_of_bars = wall.wall_time();
    });
    return {{"values", RungValues(simulation->results()).to_json()},
            {"seconds_of_bars", seconds_of_bars}};
  }



  ProcessEnd
  Trade::run_scene(const Job &job, const std::string &output) const
  {
    return run_in_child([&] { return answer_of(job, output); },
                        job.folder + "/output.txt",
                        job.folder + "/errors.txt",
                        scene.trade.time_limit);
  }



  ProcessEnd
  Trade::run_in_child(const std::function<json()> &work,
                      const std::string           &output,
                      const std::string           &errors,
                      const double                 time_limit) const
  {
    const auto with_mpi = [&] {
      int                 argc = 1;
      std::string         name = "lamella";
      std::vector<char *> words{name.data(), nullptr};
      char              **argv = words.data();
      const MpiSession    mpi(argc, argv);
      limit_threads(threads);
      return work().dump();
    };
    return run_forked(with_mpi, output, errors, time_limit);
  }



  json
  Trade::new_record(const Job &job) const
  {
    fs::remove_all(job.folder);
    fs::create_directories(job.folder);
    const std::string kept = job.folder + "/run", other = job.folder + "/again";
    const ProcessEnd  first = run_scene(job, kept);
    const std::string failure =
      failure_of(first, job.folder + "/errors.txt", scene.trade.time_limit);
    json   answer  = failure.empty() ? json::parse(first.answer) : json();
    double seconds = first.seconds;
    if (failure.empty())
      seconds -= answer.at("seconds_of_bars").get<double>();
    // What else the machine does weighs most where a run is short.
    Job again  = job;
    again.bars = false;
    for (unsigned int k = 1;
         failure.empty() && k < tries && seconds < short_run;
         ++k)
      {
        const ProcessEnd end = run_scene(again, other);
        if (end.status == 0 && end.seconds < seconds)
          {
            seconds = end.seconds;
            take_costs(answer.at("values"),
                       json::parse(end.answer).at("values"));
            if (!job.bars)
              {
                fs::remove_all(kept);
                fs::rename(other, kept);
              }
          }
        fs::remove_all(other);
      }
    // Each run reads the scene afresh.
    if (fingerprint(job.entry, job.overrides) != job.fingerprint ||
        fingerprint(overrides) != base)
      throw InputError("the scene, a mesh file or the program changed while "
                       "rungs of it were run. Start the trade again.")
        .at(scene_file + ": ");
    json record{{"of", job.fingerprint},
                {"seconds", seconds},
                {"failure", failure}};
    if (failure.empty())
      record["values"] = answer.at("values");
    return record;
  }



  void
  Trade::run_rung(const Job &job)
  {
    json       record = record_in(job.folder, job.fingerprint);
    const bool had    = !record.is_null();
    if (!had)
      {
        record = new_record(job);
        keep_record(record, job.folder);
      }
    RungResult result = result_of(job.entry);
    RungValues values;
    result.seconds = record.at("seconds");
    result.failure = record.at("failure");
    if (result.failure.empty())
      {
        values = RungValues(record.at("values"));
        values.tell(result);
      }
    out << (result.failure.empty() ? std::to_string(result.dofs) + " DoFs, " +
                                       to_text(result.seconds, 3) + " s" :
                                     "failed: " + result.failure)
        << (had ? " (of an earlier trade)" : "") << std::endl;
    results.push_back(result);
    numbers.push_back(values);
  }



  void
  Trade::check_quantities(const std::string &directory)
  {
    const auto check = [&]() -> json {
      std::ostream                      nowhere(nullptr);
      std::unique_ptr<const Simulation> model;
      // Goals, by default these very quantities, would be looked at, too.
      Scene plain = scene;
      plain.goals = GoalParameters();
      // Whether the scene can be built at all is for the rungs to say.
      if (outcome_of([&] {
            model = std::make_unique<const Simulation>(plain, nowhere);
          }).status != 0)
        return json();
      json answer{{"plies", json::array()}};
      try
        {
          for (const NamedQuantity &quantity :
               model->model().in_plies(quantities))
            answer["plies"].push_back(quantity.ply);
        }
      catch (const InputError &error)
        {
          answer["fault"] = {error.path(),
                             error.value(),
                             error.rule(),
                             error.remedy()};
        }
      return answer;
    };
    const std::string said   = directory + "/rungs/check.txt",
                      errors = directory + "/rungs/check_errors.txt";
    const ProcessEnd end =
      run_in_child(check, said, errors, scene.trade.time_limit);
    fs::remove(said);
    fs::remove(errors);
    const json answer = end.answer.empty() ? json() : json::parse(end.answer);
    if (answer.is_null())
      return;
    if (answer.contains("fault"))
      {
        const std::vector<std::string> fault = answer["fault"];
        throw InputError(fault[0], fault[1], fault[2], fault[3]);
      }
    for (unsigned int q = 0; q < quantities.size(); ++q)
      quantities[q].ply = answer["plies"][q];
  }



  void
  Trade::climb(const std::string &directory)
  {
    std::map<std::string, std::string> seen;
    unsigned int                       number = 0;
    for (const LadderEntry &entry : scene.trade.ladder)
      {
        ++number;
        out << "Rung " << number << " of " << scene.trade.ladder.size() << ", "
            << entry.name << ": " << std::flush;
        std::vector<std::string> all;
        try
          {
            all = overrides + make_rung(entry, scene).overrides;
          }
        catch (const InputError &error)
          {
            out << "failed: " << error.what() << std::endl;
            results.push_back(result_of(entry));
            results.back().failure = error.what();
            numbers.emplace_back();
            continue;
          }
        say_if_interrupted("interrupted. " + directory +
                           "/rungs has the rungs before this one. The same "
                           "command goes on with it.");
        const std::string of      = fingerprint(entry, all);
        const auto [same, is_new] = seen.emplace(of, entry.name);
        if (!is_new)
          {
            out << "the same as " << same->second << ", left out" << std::endl;
            if (reference == entry.name)
              reference = same->second;
            continue;
          }
        run_rung({entry,
                  all,
                  of,
                  scene.trade.error_bars && !entry.tolerance,
                  directory + "/rungs/" + folder_name(number, entry.name)});
      }
  }



  void
  Trade::complete_quantities()
  {
    for (unsigned int k = results.size(); k-- > 0;)
      if (results[k].failure.empty())
        {
          for (const std::string &probe : scene.trade.whole_probes)
            for (const NamedQuantity &quantity : numbers[k].largest_at(probe))
              quantities.push_back(quantity);
          return;
        }
  }



  void
  Trade::take_values()
  {
    for (unsigned int k = 0; k < results.size(); ++k)
      if (results[k].failure.empty())
        for (const NamedQuantity &quantity : quantities)
          {
            results[k].values.push_back(numbers[k].value(quantity));
            if (numbers[k].has_bars())
              results[k].bars.push_back(numbers[k].bar(quantity));
          }
  }



  void
  Trade::run(const std::string &directory)
  {
    prepare_directory(directory);
    boost::interprocess::file_lock lock((directory + "/trade.lock").c_str());
    if (!lock.try_lock())
      throw InputError("another trade is at work there. Wait for it, or name "
                       "another folder.")
        .at("--output " + directory + ": ");
    // Those of an earlier trade would look like this one's.
    for (const char *name : {"trade.csv", "trade.py", "trade.png", "trade.svg"})
      fs::remove(directory + "/" + name);
    results.clear();
    numbers.clear();
    reference = scene.trade.reference;
    check_quantities(directory);
    climb(directory);
    say_if_interrupted("");
    complete_quantities();
    take_values();
    const TradeTable table(results,
                           quantities,
                           reference,
                           scene.trade.tolerances);
    write_trade_csv(table, directory + "/trade.csv");
    print_trade(out, table);
    const std::string no_picture = draw_trade(table, scene.title, directory);
    if (!no_picture.empty())
      out << "\nNo pictures: " << no_picture << ".";
    out << "\nThe trade is in " << directory << " (trade.csv"
        << (no_picture.empty() ? ", trade.png, trade.svg" : "")
        << "; the runs in rungs/)" << std::endl;
  }
} // namespace lamella
