// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/run/factor_progress.h>

#include <cmath>

namespace lamella
{
  namespace
  {
    /// What the factor of @p body is likely to take, as measured: that of a
    /// beam, a chain of blocks, has 0.7 of its matrix's non-zeros; that of a
    /// solid nine times the n^(4/3) of nested dissection in space.
    double
    predicted(const Body &body)
    {
      constexpr double of_beam = 0.7, of_solid = 9.;
      const double     n = body.n_dofs();
      return operations_of_factor(body.is_nodal() ?
                                    of_solid * n * std::cbrt(n) :
                                    of_beam * body.stiffness_entries(),
                                  n);
    }



    double
    predicted(const Structure &structure)
    {
      double sum = 0.;
      for (const auto &body : structure.bodies())
        sum += predicted(*body);
      return sum;
    }
  } // namespace



  FactorProgress::FactorProgress(std::ostream &out, const Structure &structure)
    : out(out)
    , all(out, "", predicted(structure))
  {}



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
    Progress::expect(out, operations - predicted(body));
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
      Progress::expect(out, -predicted(body));
    else
      Progress::done(out, (1. - told) * operations);
    operations = told = 0.;
  }
} // namespace lamella
