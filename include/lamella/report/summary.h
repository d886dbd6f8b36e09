// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_summary_h
#define lamella_report_summary_h

#include <lamella/base/units.h>
#include <lamella/report/recorder.h>
#include <lamella/solve/checks.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// What summary.json says of a run; results are those of the last load step.
  struct Summary
  {
    std::string                          title;
    Units                                units;
    const Structure                     *structure = nullptr;
    const std::vector<ContactInterface> *contacts  = nullptr;
    /// As the scene says them, in the order of contacts.
    const std::vector<ContactPair> *pairs = nullptr;
    std::vector<std::string>        support_names;

    /// Of each load step.
    std::vector<unsigned int> iterations;
    /// Of each contact, of each load step.
    std::vector<std::vector<Recorder::StatusChanges>> status_changes;
    Checks                                            checks;
    double                                            condition_estimate = 0.;
    /// Of the last step; empty if nothing was solved.
    std::vector<double> free_corrections, contact_corrections;
    /// Line -> largest relative jump of the traction at ply interfaces.
    std::map<std::string, double> interface_jumps;
    bool                          converged = false;
    std::vector<std::string>      warnings;
    /// Phase -> wall seconds.
    std::map<std::string, double> seconds;

    /// Body -> what solving it took; empty with the `full` strategy.
    std::map<std::string, SolverStatistics> solvers;
    unsigned int                            processes = 1;
    /// In bytes: of the process that took most, and of all.
    double peak_memory = 0., peak_memory_of_all = 0.;
  };

  /// As in a scene file: `node to node`, `penalty`, ...
  std::string
  name_of(const Discretisation discretisation);
  std::string
  name_of(const Enforcement enforcement);

  /// The diagonal of the box around all bodies: what lengths are compared with.
  double
  scene_size(const Structure &structure);

  /// Writes @p directory/summary.json, keys as fixed in doc/output.md.
  void
  write_summary(const Summary &summary, const std::string &directory);
} // namespace lamella

#endif
