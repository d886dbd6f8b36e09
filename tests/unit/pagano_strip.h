// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_pagano_strip_h
#define lamella_tests_unit_pagano_strip_h

#include "fixtures.h"
#include "pagano.h"

#include <lamella/solve/checks.h>
#include <lamella/solve/linear_system.h>

#include <vector>

namespace lamella
{
  constexpr double pi = dealii::numbers::PI;

  // Pagano's graphite-epoxy. Height and traction are 1 throughout, so that the
  // length is the slenderness S = L / h.
  const EngineeringConstants
    graphite_epoxy{25., 1., 1., 0.5, 0.5, 0.2, 0.25, 0.25, 0.25};



  /// Plies of equal thickness, height 1.
  inline PaganoSolution
  exact_solution(const std::vector<double> &angles, const double slenderness)
  {
    return PaganoSolution(graphite_epoxy,
                          angles,
                          std::vector<double>(angles.size(),
                                              1. / angles.size()),
                          slenderness);
  }



  /// Pagano's load on the top of body 0, the strip of slenderness @p length.
  inline Load
  pagano_load(const double length)
  {
    return {"top",
            {{0, Region::Kind::surface, "top", {}}},
            {},
            "-sin(pi*y/" + digits(length) + ")"};
  }



  /// Half of the strip, to mid-span, with @p section and @p elements B4, held
  /// and loaded as PaganoSolution says: u_y, antisymmetric, vanishes at
  /// mid-span.
  inline Structure
  half_strip(std::shared_ptr<const Section> section,
             const double                   length,
             const unsigned int             elements,
             const unsigned int             degree = 3)
  {
    Bodies bodies;
    bodies.push_back(
      std::make_unique<Beam>("strip",
                             std::move(section),
                             make_axis(0.5 * length, elements, degree),
                             Placement()));
    const std::nullopt_t       free_ = std::nullopt;
    const std::vector<Support> supports{
      {"plane strain", {{0, Region::Kind::body, "", {}}}, {{0., free_, free_}}},
      {"support",
       {{0, Region::Kind::surface, "start", {}}},
       {{free_, free_, 0.}}},
      {"mid-span",
       {{0, Region::Kind::surface, "end", {}}},
       {{free_, 0., free_}}}};
    return Structure(std::move(bodies), supports, {pagano_load(length)});
  }



  inline Vector
  solution(Structure &structure)
  {
    const std::vector<GapConstraint> no_rows;
    LinearSystem                     system(linearized(structure), no_rows);
    const State                      state = system.solve_free(1.);
    check_solution(state, check_state(system.tangent(), {}, 3, state, 1.), 1e9);
    return state.u.block(0);
  }
} // namespace lamella

#endif
