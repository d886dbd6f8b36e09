// SPDX-License-Identifier: LGPL-2.1-or-later

// step-15: how many responses.
//
// step-8 gave the nodes near a load a few fields with which the section answers
// it, at six wave numbers. Why six? The program makes such bases with fewer and
// more of them, for a load that is known and for one that may press anywhere on
// a line, and asks them for responses that they were not made of. See README.md
// in this folder.

#include "../coupon.h"

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>

#include <deal.II/base/table_handler.h>

#include <fstream>
#include <iostream>
#include <sstream>

using namespace lamella;

namespace
{
  // The shortest element of the axis under the nose.
  constexpr double element = 0.5;

  /// The norm of what no combination of @p fields gives of a response, both
  /// @p parts together. The fields are orthonormal in the norm's matrix M,
  /// @p metrics are M times the fields.
  double
  norm_without(const std::vector<Vector> &parts,
               const FieldColumns        &fields,
               const FieldColumns        &metrics,
               const Warping             &warping)
  {
    double square = 0.;
    for (Vector v : parts)
      {
        warping.remove_rigid(v);
        for (unsigned int j = 0; j < fields.n(); ++j)
          v.add(-(column_of(metrics, j) * v), column_of(fields, j));
        FieldColumns column(v.size(), 1);
        std::copy(v.begin(), v.end(), &column(0, 0));
        square += v * column_of(warping.metric(column), 0);
      }
    return std::sqrt(square);
  }
} // namespace



class BasesOfResponses
{
public:
  BasesOfResponses();
  void
  run();

private:
  // A response each, its real and its imaginary part.
  using Responses = std::vector<std::vector<Vector>>;

  double
  worst_miss(const Responses &others, const FieldColumns &basis) const;
  void
  add_basis(const std::string &name,
            const Responses   &of,
            const double       tolerance,
            const Responses   &others);

  const Coupon         coupon;
  const SaintVenant    states;
  const Warping        warping;
  const FieldColumns   warpings;
  dealii::TableHandler table;
};



// The section of step-8 and its Saint-Venant warpings, which every node has.
BasesOfResponses::BasesOfResponses()
  : states(*coupon.section)
  , warping(*coupon.section)
  , warpings(saint_venant_warpings(states, warping))
{}



// How good are they? Responses at wave numbers that were not asked for: what no
// combination of the fields gives of them, over what SV alone leaves, the
// largest over all loads and wave numbers.
double
BasesOfResponses::worst_miss(const Responses    &others,
                             const FieldColumns &basis) const
{
  constexpr double   independent = 1e-7;
  const FieldColumns sv =
    orthonormal(warpings, warping.metric(warpings), independent);
  // The basis is orthonormal and free of the warpings.
  const FieldColumns all = beside(sv, basis), all_metrics = warping.metric(all),
                     sv_metrics = warping.metric(sv);
  double worst                  = 0.;
  for (const std::vector<Vector> &parts : others)
    worst = std::max(worst,
                     norm_without(parts, all, all_metrics, warping) /
                       norm_without(parts, sv, sv_metrics, warping));
  return worst;
}



void
BasesOfResponses::add_basis(const std::string &name,
                            const Responses   &of,
                            const double       tolerance,
                            const Responses   &others)
{
  const FieldColumns fields = basis_of(of, warping, warpings, tolerance);
  std::ostringstream words;
  words << name << ", " << tolerance;
  table.add_value("responses, tolerance", words.str());
  table.add_value("snapshots", 2 * unsigned(of.size()));
  table.add_value("fields kept", fields.n());
  table.add_value("worst miss", worst_miss(others, fields));
}



// The wave numbers go from long waves, 0.25 over the width, to the shortest
// that the axis can show, 10 over its shortest element; those that test lie in
// between. A load that is known, the nose along all of its line, is one load
// vector. Where contact decides what presses there are thirteen, the hats.
void
BasesOfResponses::run()
{
  const auto of_the_axis = [](const unsigned int n) {
    return wave_numbers(0.25 / Coupon::width, 10. / element, n);
  };
  const auto in_between = wave_numbers(0.3 / Coupon::width, 9. / element, 9);
  const std::vector<Vector> hats    = coupon.hats(), line{sum_of(hats)};
  const Section            &section = *coupon.section;

  const Responses others = responses(section, line, in_between);
  for (const unsigned int n : {2, 4, 6, 8, 12})
    add_basis("line, " + std::to_string(n) + " waves",
              responses(section, line, of_the_axis(n)),
              1e-4,
              others);
  const Responses six            = responses(section, hats, of_the_axis(6)),
                  others_of_hats = responses(section, hats, in_between);
  for (const double tolerance : {0.3, 0.1, 0.03, 0.01, 0.001})
    add_basis("hats, 6 waves", six, tolerance, others_of_hats);
  table.set_precision("worst miss", 3);
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);

  std::ofstream csv("step-15.csv");
  csv << "field,x,z,ux,uy,uz\n";
  coupon.draw_responses(csv, "line", line[0], warping);
  coupon.draw_responses(csv, "hat", hats[hats.size() / 2], warping);
}



int
main(int argc, char **argv)
{
  MpiSession mpi(argc, argv);
  return run_and_report([] { BasesOfResponses().run(); });
}
