// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_factor_progress_h
#define lamella_run_factor_progress_h

#include <lamella/adapt/plan.h>
#include <lamella/base/progress.h>
#include <lamella/solve/structure.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Tells a Progress how far the factors of the bodies of a structure are, in
   * operations (operations_of_factor()): of z non-zeros where the symbolic
   * analysis has said them, and before that of as many as are foreseen
   * (foreseen_costs()). Factors of dense blocks are told as they go, others
   * when they are done; `cg`, which has none, counts nothing.
   */
  class FactorProgress
  {
  public:
    /// Both are referred to.
    FactorProgress(std::ostream &out, const Structure &structure);

    /// Work on @p body is now its @p phase.
    void
    begins(const std::string &phase, const Body &body);
    /// Its factor has @p non_zeros.
    void
    sized(const Body &body, const double non_zeros);
    /// A @p share of it more is done.
    void
    advanced(const double share);
    /// All that there is to do for @p body is done.
    void
    ends(const Body &body);

  private:
    double
    foreseen_of(const Body &body) const;

    std::ostream                 &out;
    const Bodies                 &bodies;
    std::vector<Cost>             foreseen;
    Progress::Part                all;
    std::optional<Progress::Part> part;
    /// Of the present body: its operations, where they are known, and the share
    /// that is told.
    double operations = 0., told = 0.;
  };
} // namespace lamella

#endif
