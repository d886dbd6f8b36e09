// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/base/version.h>
#include <lamella/report/goals_table.h>
#include <lamella/report/results_writer.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/report/summary.h>

#include <filesystem>

namespace lamella
{
  ResultsWriter::ResultsWriter(
    const std::string                    &directory,
    const std::function<OutputSources()> &output_sources)
    : output_sources(output_sources)
    , place(directory)
  {}



  std::vector<StepResults>
  ResultsWriter::resume()
  {
    standing = read_restart(place.path(), output_sources().resolved);
    if (is_root_process())
      for (const auto &[name, size] : standing.sizes)
        {
          // Rows of a step that did not come to its end.
          std::error_code   error;
          const std::string path = place.path() + "/" + name;
          if (std::filesystem::file_size(path, error) < size || error)
            throw InputError(
              "report.file-truncated: " + name +
              " is shorter than the interrupted run left it. Run the scene "
              "from the start, without --resume.")
              .at("--resume --output " + place.path() + ": ");
          std::filesystem::resize_file(path, size);
        }
    place.keep();
    return standing.steps;
  }



  void
  ResultsWriter::write_step(const Results &results)
  {
    place.make_room();
    const OutputSources of    = output_sources();
    const bool          first = results.steps.size() == 1;
    // Results of a run that has started again are removed.
    if (first)
      standing = {};
    standing.version = version();
    standing.scene   = of.resolved;
    if (of.write_vtu)
      write_vtu_files(results.last());
    if (!is_root_process())
      return;
    if (first)
      {
        write_file(place.path() + "/scene.prm", of.resolved);
        write_file(place.path() + "/fields.csv",
                   fields_of_nodes(of.structure.bodies()));
        for (const auto &[name, section] : of.sections)
          write_section(place.path(),
                        name,
                        *section,
                        section_stiffness(section),
                        results.units);
      }
    write_tables(results);
    write_progress(results);
  }



  void
  ResultsWriter::write_tables(const Results &results)
  {
    const bool first = results.steps.size() == 1;
    FileTexts  texts = table_rows(results, results.last());
    if (first)
      for (auto &[name, header] : table_headers(results))
        texts[name] = header + texts[name];
    for (const auto &[name, text] : texts)
      {
        const std::string path = place.path() + "/" + name;
        if (first)
          write_file(path, text);
        else
          append_to_file(path, text);
        standing.sizes[name] += text.size();
      }
  }



  void
  ResultsWriter::write_vtu_files(const StepResults &step)
  {
    const OutputSources of = output_sources();
    standing.vtu_files["solution"].emplace_back(
      step.step,
      write_vtu(place.path(),
                "solution",
                step.step,
                step.load_factor.of_scene(),
                of.structure,
                step.state.u,
                of.strength));
    if (!is_root_process())
      return;
    // Of bodies that turn who faces whom is another matter in each step.
    if (surfaces.empty() || step.step == 1 ||
        of.structure.has_finite_rotations())
      {
        surfaces.clear();
        for (const ContactInterface &contact : of.contacts)
          surfaces.emplace_back(contact, of.structure);
      }
    for (unsigned int k = 0; k < surfaces.size(); ++k)
      {
        const std::string name = "contact_" + of.contacts[k].name;
        standing.vtu_files[name].emplace_back(
          step.step,
          surfaces[k].write_vtu(
            place.path(), step.step, step.state.u, step.contacts[k]));
      }
    for (const auto &[name, files] : standing.vtu_files)
      write_pvd(place.path(), name, files);
  }



  void
  ResultsWriter::write_progress(const Results &results)
  {
    const StepResults &last = results.last();
    if (!standing.steps.empty())
      standing.steps.back().drop_fields();
    StepResults kept;
    kept.step        = last.step;
    kept.load_factor = last.load_factor;
    kept.state       = last.state;
    kept.memory      = last.memory;
    kept.changes     = last.changes;
    kept.substeps    = last.substeps;
    kept.change      = last.change;
    kept.plies       = last.plies;
    kept.warnings    = last.warnings;
    standing.steps.push_back(std::move(kept));
    write_file(place.path() + "/summary.json", summary_text(results));
    write_restart(standing, place.path());
  }



  void
  ResultsWriter::write_modes(const std::string       &name,
                             const std::vector<Mode> &modes)
  {
    // Large enough to see, small beside the bodies.
    constexpr double    of_size = 0.05;
    const OutputSources of      = output_sources();
    if (modes.empty() || !of.write_vtu)
      return;
    std::vector<std::pair<double, std::string>> files;
    for (unsigned int k = 0; k < modes.size(); ++k)
      {
        BlockVector shape = modes[k].shape;
        shape *= of_size * of.structure.size() / modes[k].shape.linfty_norm();
        files.emplace_back(modes[k].number,
                           write_vtu(place.path(),
                                     name,
                                     modes[k].number,
                                     modes[k].value,
                                     of.structure,
                                     shape));
      }
    if (is_root_process())
      write_pvd(place.path(), name, files);
  }



  void
  ResultsWriter::write_outcome(const Results &results)
  {
    if (results.steps.empty())
      return;
    place.make_room();
    if (results.natural_modes)
      write_modes("mode", results.natural_modes->modes);
    write_modes("buckling", results.buckling_modes);
    if (!is_root_process())
      return;
    write_file(place.path() + "/summary.json", summary_text(results));
    if (!results.goals.empty())
      {
        write_file(place.path() + "/goals.csv", goals_csv(results));
        write_file(place.path() + "/indicators.csv", indicators_csv(results));
      }
    if (results.first_failure)
      write_file(place.path() + "/failure.csv", failure_table(results));
    if (results.natural_modes || !results.buckling_modes.empty())
      write_file(place.path() + "/modes.csv", modes_csv(results));
    if (!results.response.empty())
      write_file(place.path() + "/response.csv", response_csv(results));
  }



  void
  ResultsWriter::write_end(const Results &results)
  {
    write_outcome(results);
    if (results.steps.empty() || !results.converged || !is_root_process())
      return;
    // Nothing to go on with: a word that says so.
    Restart end;
    end.version  = standing.version;
    end.scene    = standing.scene;
    end.finished = true;
    write_restart(end, place.path());
  }
} // namespace lamella
