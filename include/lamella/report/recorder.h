// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_recorder_h
#define lamella_report_recorder_h

#include <lamella/report/requests.h>
#include <lamella/solve/checks.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Keeps what each load step leaves behind, and writes it in the end:
   * probes.csv, lines/NAME.csv, cuts/NAME.csv, history.csv, contact_NAME.csv.
   * Construction locates all requests, so that a probe outside of its body is
   * an error before anything is solved.
   */
  class Recorder
  {
  public:
    /// All are referred to. Throws InputError for places outside of a body.
    Recorder(const Structure                     &structure,
             const std::vector<ContactInterface> &contacts,
             const std::vector<std::string>      &support_names,
             const std::vector<Probe>            &probes,
             const std::vector<Line>             &lines,
             const std::vector<Cut>              &cuts);

    /// Adds the rows of load step @p step (from 1).
    void
    record(const unsigned int step,
           const double       factor,
           const State       &state,
           const Checks      &checks);

    /// Writes all files into the existing folder @p directory.
    void
    write(const std::string &directory) const;

    /// The value of each reference's quantity at the last step: of probe
    /// @p probe the one ply's, or of the first ply where there are several.
    double
    probe_value(const unsigned int probe, const std::string &quantity) const;

    /// What a line through ply interfaces meets there.
    struct InterfaceJump
    {
      std::string  line;
      unsigned int interfaces = 0;
      /// The largest jump of the traction sigma . d, d the line's direction,
      /// over the largest traction on the line. Equilibrium makes it zero where
      /// the line is normal to the plies; what is left is the section's mesh.
      double relative = 0.;
    };

    /// Of the last load step, for each line that crosses an interface.
    const std::vector<InterfaceJump> &
    interface_jumps() const
    {
      return jumps;
    }

    /// How many pairs of a contact began and ceased to touch in a load step.
    struct StatusChanges
    {
      unsigned int closed = 0, opened = 0;
    };

    /// Of each contact in each load step, the first against no contact.
    const std::vector<std::vector<StatusChanges>> &
    status_changes() const
    {
      return changes;
    }

  private:
    struct LineSample
    {
      double   s;
      Location location;
    };

    void
    locate_line(const Line &line);
    /// The recoveries of one load step, by body and kind.
    class Recoveries;

    void
    record_probes(const unsigned int step, Recoveries &recoveries);
    void
    record_line(const unsigned int step,
                const unsigned int l,
                Recoveries        &recoveries);
    void
    record_cut(const unsigned int step,
               const Cut         &cut,
               const BlockVector &u,
               Recoveries        &recoveries);
    void
    record_contacts(const unsigned int step,
                    const double       factor,
                    const State       &state);
    void
    record_history(const unsigned int step,
                   const double       factor,
                   const Checks      &checks);
    std::string
    history_header() const;

    const Structure                     &structure;
    const std::vector<ContactInterface> &contacts;
    const std::vector<std::string>      &support_names;
    const std::vector<Probe>            &probes;
    const std::vector<Line>             &lines;
    const std::vector<Cut>              &cuts;

    std::vector<std::vector<Location>>   probe_locations;
    std::vector<std::vector<LineSample>> line_samples;
    std::vector<FieldSample>             last_probe_samples;
    std::vector<InterfaceJump>           jumps;

    /// Of each gap row, whether it touched at the last step.
    std::vector<bool>                       touching;
    std::vector<std::vector<StatusChanges>> changes;

    /// Name of a file in the output folder -> its text so far.
    std::map<std::string, std::string> files;
  };
} // namespace lamella

#endif
