// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_sampler_h
#define lamella_recover_sampler_h

#include <lamella/recover/requests.h>
#include <lamella/solve/results.h>

#include <map>
#include <vector>

namespace lamella
{
  /**
   * The fields of a state where the scene asks for them: at probes, along lines
   * and over cuts. Construction locates all of these, so that one outside of
   * its body is an error before anything is solved.
   */
  class Sampler
  {
  public:
    /// All are referred to. Throws InputError for places outside of a body.
    Sampler(const Bodies             &bodies,
            const std::vector<Probe> &probes,
            const std::vector<Line>  &lines,
            const std::vector<Cut>   &cuts);

    /// Fills the probes, lines, cuts and jumps of @p results for the
    /// displacements @p u.
    void
    sample(const BlockVector &u, StepResults &results) const;

  private:
    /// A sample of a line and its arc length.
    struct LinePlace
    {
      double   s;
      Location location;
    };

    std::vector<LinePlace>
    places_of(const Line &line) const;
    void
    check_cut(const Cut &cut) const;

    /// The recoveries of one state, by body and kind.
    class Recoveries;
    FieldRow
    row_at(const unsigned int body,
           const Location    &location,
           StressRecovery    &recovery) const;
    std::vector<LineRow>
    line_rows(const unsigned int line, Recoveries &recoveries) const;
    std::vector<CutRow>
    cut_rows(const Cut         &cut,
             const BlockVector &u,
             Recoveries        &recoveries) const;

    const Bodies             &bodies;
    const std::vector<Probe> &probes;
    const std::vector<Line>  &lines;
    const std::vector<Cut>   &cuts;

    std::vector<std::vector<Location>>  probe_locations;
    std::vector<std::vector<LinePlace>> line_places;
  };

  /// What @p rows, of a line in the direction @p d, meet at ply interfaces.
  InterfaceJump
  interface_jump(const std::vector<LineRow> &rows,
                 const dealii::Tensor<1, 3> &d);
} // namespace lamella

#endif
