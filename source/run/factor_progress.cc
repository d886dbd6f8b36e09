// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/run/factor_progress.h>

namespace lamella
{
  namespace
  {
    double
    sum_of(const std::vector<Cost> &costs)
    {
      double sum = 0.;
      for (const Cost &cost : costs)
        sum += cost.operations;
      return sum;
    }
  } // namespace



  FactorProgress::FactorProgress(std::ostream &out, const Structure &structure)
    : out(out)
    , bodies(structure.bodies())
    , foreseen(foreseen_costs(bodies))
    , all(out, "", sum_of(foreseen))
  {}



  double
  FactorProgress::foreseen_of(const Body &body) const
  {
    unsigned int b = 0;
    while (bodies[b].get() != &body)
      ++b;
    return foreseen[b].operations;
  }



  void
  FactorProgress::begins(const std::string &phase, const Body &body)
  {
    part.reset();
    part.emplace(out, phase + " of " + body.name());
  }



  void
  FactorProgress::sized(const Body &body, const double non_zeros)
  {
    operations = operations_of_factor(non_zeros, body.n_dofs());
    Progress::expect(out, operations - foreseen_of(body));
  }



  void
  FactorProgress::advanced(const double share)
  {
    told += share;
    Progress::done(out, share * operations);
  }



  void
  FactorProgress::ends(const Body &body)
  {
    part.reset();
    if (operations == 0.)
      Progress::expect(out, -foreseen_of(body));
    else
      Progress::done(out, (1. - told) * operations);
    operations = told = 0.;
  }
} // namespace lamella
