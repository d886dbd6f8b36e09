// SPDX-License-Identifier: LGPL-2.1-or-later

// The runs of variants, each in a process of its own, and their records.

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/mpi_session.h>
#include <lamella/base/text.h>
#include <lamella/base/version.h>
#include <lamella/estimate/goal_bars.h>
#include <lamella/estimate/tolerance_run.h>
#include <lamella/run/run_scene.h>
#include <lamella/trade/trade.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace lamella
{
  using nlohmann::json;
  namespace fs = std::filesystem;

  namespace
  {
    /// The record of a variant that has ended, in its folder.
    constexpr const char *record_name = "variant.json";
    /// Below that folder: the results of the run that counts.
    constexpr const char *kept_run = "/run";

    /// Runs below `short_run` seconds are timed `tries` times.
    constexpr double       short_run = 1.;
    constexpr unsigned int tries     = 3;



    /// @p resolved without its `subsection Trade`, which no variant looks at.
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
    file_stamp(const std::string &path)
    {
      std::error_code error;
      const auto      size = fs::file_size(path, error);
      const auto      time = fs::last_write_time(path, error);
      return std::to_string(size) + " bytes, " +
             std::to_string(time.time_since_epoch().count());
    }



    std::string
    read_file(const std::string &path)
    {
      std::ostringstream text;
      text << std::ifstream(path).rdbuf();
      return text.str();
    }



    /// Returns why a run has no results; empty if it has.
    std::string
    failure_of(const ProcessEnd  &end,
               const std::string &errors,
               const double       time_limit)
    {
      if (end.time_limit_reached)
        return "took more than the time limit of " + to_text(time_limit) +
               " s.";
      if (end.signal != 0)
        return "was ended by signal " + std::to_string(end.signal) +
               (end.signal == 9 ? ", perhaps because memory ran out." : ".");
      if (end.status == 0)
        return json::accept(end.result) ? "" : "ended without its numbers.";
      const std::string message = trimmed(read_file(errors));
      return message.empty() ?
               "ended with exit status " + std::to_string(end.status) + "." :
               message;
    }



    /// Writes @p record into @p folder, completely or not at all.
    void
    write_record(const json &record, const std::string &folder)
    {
      const std::string path = folder + "/" + record_name;
      std::ofstream     file(path + ".new");
      file << record.dump(2) << "\n";
      file.close();
      std::error_code error;
      fs::rename(path + ".new", path, error);
      if (!file || error)
        throw InputError("base.cannot-write: cannot write " + path +
                         ". Check that the disk is not full.");
    }



    /// The record in @p folder if it has @p fingerprint and no failure, else
    /// null: causes of failures (a time limit, other programs) may be gone.
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



    /// Replaces costs in @p values by those of @p other, the same scene.
    void
    record_costs_of(json &values, const json &other)
    {
      for (const char *cost : {"peak_memory_mb", "seconds"})
        values[cost] = other.at(cost);
    }



    /// What is known of a variant before it is run.
    VariantResult
    result_of(const TradeVariant &entry)
    {
      VariantResult result;
      result.name       = entry.name;
      result.theory     = entry.theory;
      result.axis       = entry.axis;
      result.section    = entry.section;
      result.overridden = !entry.overrides.empty();
      result.tolerance  = entry.tolerance;
      return result;
    }
  } // namespace



  std::string
  Trade::fingerprint(const std::vector<std::string> &variant_overrides) const
  {
    std::string text;
    try
      {
        const Scene variant =
          read_scene(SceneText::read(scene_file, variant_overrides));
        text = without_trade(variant.resolved);
        for (const auto &[name, shape] : variant.sections)
          if (const auto *file = std::get_if<SectionFile>(&shape))
            text += "mesh " + file_stamp(file->path) + "\n";
      }
    catch (const InputError &error)
      {
        // The run of the variant reports it.
        for (const std::string &assignment : variant_overrides)
          if (assignment.compare(0, 6, "Trade/") != 0)
            text += assignment + "\n";
        text += error.what() + std::string("\n");
      }
    return text + "program " + version() + ", " +
           file_stamp(executable_path()) + ", threads " +
           std::to_string(threads);
  }



  std::string
  Trade::fingerprint(const TradeVariant             &entry,
                     const std::vector<std::string> &all) const
  {
    // The scene may have the same goals itself.
    return fingerprint(all) + (entry.tolerance        ? ", to a tolerance" :
                               scene.trade.error_bars ? ", with error bars" :
                                                        "");
  }



  json
  Trade::run_job(const Job &job, const std::string &output) const
  {
    std::vector<std::string> entries{"Write VTU=false"};
    entries.insert(entries.end(), job.overrides.begin(), job.overrides.end());
    const SceneText text    = SceneText::read(scene_file, entries);
    const Scene     variant = read_scene(text);
    if (job.entry.tolerance)
      try
        {
          ToleranceRun passes(variant, std::cout);
          passes.run(output);
          return {{"values", VariantValues(passes.results()).to_json()},
                  {"seconds_of_bars", 0.}};
        }
      catch (const InputError &error)
        {
          throw text.placed(error);
        }
    const auto simulation      = make_simulation(variant, text, std::cout);
    double     seconds_of_bars = 0.;
    lamella::run_scene(*simulation, output, false, [&] {
      if (!job.bars)
        return;
      const dealii::Timer wall;
      ModelCache          cache;
      simulation->set_goals(error_bars_of(*simulation, std::cout, cache).goals);
      seconds_of_bars = wall.wall_time();
    });
    return {{"values", VariantValues(simulation->results()).to_json()},
            {"seconds_of_bars", seconds_of_bars}};
  }



  ProcessEnd
  Trade::run_scene(const Job &job, const std::string &output) const
  {
    return run_in_process([&] { return run_job(job, output); },
                          job.folder + "/output.txt",
                          job.folder + "/errors.txt",
                          scene.trade.time_limit);
  }



  ProcessEnd
  Trade::run_in_process(const std::function<json()> &work,
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



  void
  Trade::repeat_short_run(const Job &job, json &result, double &seconds) const
  {
    const std::string kept  = job.folder + kept_run,
                      other = job.folder + "/again";
    Job again               = job;
    again.bars              = false;
    for (unsigned int k = 1; k < tries && seconds < short_run; ++k)
      {
        const ProcessEnd end = run_scene(again, other);
        if (end.status == 0 && end.seconds < seconds)
          {
            seconds = end.seconds;
            record_costs_of(result.at("values"),
                            json::parse(end.result).at("values"));
            if (!job.bars)
              {
                fs::remove_all(kept);
                fs::rename(other, kept);
              }
          }
        fs::remove_all(other);
      }
  }



  json
  Trade::new_record(const Job &job) const
  {
    fs::remove_all(job.folder);
    fs::create_directories(job.folder);
    const ProcessEnd  first = run_scene(job, job.folder + kept_run);
    const std::string failure =
      failure_of(first, job.folder + "/errors.txt", scene.trade.time_limit);
    json   result  = failure.empty() ? json::parse(first.result) : json();
    double seconds = first.seconds;
    if (failure.empty())
      seconds -= result.at("seconds_of_bars").get<double>();
    if (failure.empty())
      repeat_short_run(job, result, seconds);
    // Each run reads the scene afresh.
    if (fingerprint(job.entry, job.overrides) != job.fingerprint ||
        fingerprint(overrides) != base)
      throw InputError(
        "trade.scene-changed: the scene, a mesh file or the program was "
        "changed while the variants were running. Start the trade again.")
        .at(scene_file + ": ");
    json record{{"of", job.fingerprint},
                {"seconds", seconds},
                {"failure", failure}};
    if (failure.empty())
      record["values"] = result.at("values");
    return record;
  }



  void
  Trade::run_variant(const Job &job)
  {
    json       record = record_in(job.folder, job.fingerprint);
    const bool had    = !record.is_null();
    if (!had)
      {
        record = new_record(job);
        write_record(record, job.folder);
      }
    VariantResult result = result_of(job.entry);
    VariantValues values;
    result.seconds = record.at("seconds");
    result.failure = record.at("failure");
    if (result.failure.empty())
      {
        values = VariantValues(record.at("values"));
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
  Trade::fail(const TradeVariant &entry, const std::string &why)
  {
    out << "failed: " << why << std::endl;
    results.push_back(result_of(entry));
    results.back().failure = why;
    numbers.emplace_back();
  }
} // namespace lamella
