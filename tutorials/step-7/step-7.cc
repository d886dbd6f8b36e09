// SPDX-License-Identifier: LGPL-2.1-or-later

// step-7: which model for this test? A decision out of a trade.
//
// A carbon strip is bent between two bearings and a nose. Three numbers are
// wanted of it, each as exact as it has to be, with as little work as will do.
// `lamella trade` says for one number at a time which theory and mesh is the
// cheapest; a design has to be right in all of them at once. The program climbs
// the hierarchy of the scene by itself and then asks what the command does
// not: the cheapest variant that meets all tolerances, and the best one
// within a budget. See README.md in this folder.

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>
#include <lamella/trade/trade.h>

#include <deal.II/base/table_handler.h>
#include <deal.II/base/timer.h>

#include <iostream>

using namespace lamella;

/// Cost and values of a variant.
struct Run
{
  std::string         name, failure; // Empty if the variant succeeded.
  double              seconds = 0.;
  unsigned int        dofs    = 0;
  std::vector<double> values; // In the order of Trade/Quantities.
};



class BendingTest
{
public:
  BendingTest();
  void
  run();

private:
  Run
  climb(const TradeVariant &entry);
  bool
  has_error(const unsigned int k) const;
  double
  error(const unsigned int k, const unsigned int q) const;
  double
  utilization(const unsigned int k) const;
  template <typename Number>
  int
  cheapest(Number Run::*const cost) const;
  int
  best_within_budget() const;
  void
  print_utilizations() const;
  void
  decide() const;
  void
  check() const;

  static constexpr const char *file = STEP_7_SCENE;

  // What the numbers are for, in the order of Trade/Quantities. The force
  // gives the modulus of the strip: 2 %. The two stresses are held against
  // strengths, which scatter more: 3 %.
  const std::vector<double>    tolerances{0.02, 0.03, 0.03};
  static constexpr const char *purposes[] = {"force", "bending", "shear"};

  // DoFs that an optimizer, which runs the strip some thousand times, affords.
  static constexpr double budget = 1000;

  const Scene scene;
  double      largest_imbalance = 0.;

  // All variants of the hierarchy, and the number of the finest that has
  // succeeded.
  std::vector<Run> variants;
  unsigned int     reference = 0;
};



// The scene is read as `lamella` reads it. What its `subsection Trade` says
// comes parsed, in scene.trade.
BendingTest::BendingTest()
  : scene(read_scene(SceneText::read(file, {})))
{}



// A variant is the same text with a few entries replaced, which overrides_of()
// names: its theory, its elements, its cells. Whatever goes wrong with one (no
// memory, no convergence) is a result as well, and no reason not to try the
// others.
//
// The seconds are those of the whole way, from the text to the numbers, as long
// as nothing else is at work in the process. Simulation::solve() returns all
// that the run has found out; ResultNumbers evaluates the quantities that the
// scene names. No file is written on the way.
Run
BendingTest::climb(const TradeVariant &entry)
{
  Run result;
  result.name = entry.name;
  try
    {
      dealii::Timer wall;
      std::ostream  quiet(nullptr);
      const Scene   changed =
        read_scene(SceneText::read(file, overrides_of(entry, scene)));
      Simulation     simulation(changed, quiet);
      const Results &results = simulation.solve();
      result.seconds         = wall.wall_time();

      result.dofs = results.n_dofs();
      const ResultNumbers values(results);
      for (const NamedQuantity &quantity : scene.trade.quantities)
        result.values.push_back(values.value(quantity));

      // What presses on the nose has come from the bearing.
      const double nose    = result.values[0],
                   bearing = results.support("bearing").force[2];
      largest_imbalance =
        std::max(largest_imbalance, std::abs(bearing / nose - 1.));
    }
  catch (const std::exception &error)
    {
      result.failure = error.what();
    }
  return result;
}



// Errors are relative to the finest variant, which has none itself.
bool
BendingTest::has_error(const unsigned int k) const
{
  return variants[k].failure.empty() && k != reference;
}



double
BendingTest::error(const unsigned int k, const unsigned int q) const
{
  return std::abs(variants[k].values[q] / variants[reference].values[q] - 1.);
}



// The idea of this step, one number for a variant: how much it uses of what it
// may be off, in the quantity where that is most. Engineers know it from proofs
// of strength: up to 1 all is well, and 1.2 is not mended by a 0.1 elsewhere.
double
BendingTest::utilization(const unsigned int k) const
{
  double most = 0.;
  for (unsigned int q = 0; q < tolerances.size(); ++q)
    most = std::max(most, error(k, q) / tolerances[q]);
  return most;
}



// The first question: all tolerances are fixed, what is the least work? The
// answer is -1 if no variant is enough.
template <typename Number>
int
BendingTest::cheapest(Number Run::*const cost) const
{
  int best = -1;
  for (unsigned int k = 0; k < variants.size(); ++k)
    if (has_error(k) && utilization(k) <= 1. &&
        (best < 0 || variants[k].*cost < variants[best].*cost))
      best = k;
  return best;
}



// The second one turns it round: the work is fixed, what is the best to be had
// for it?
int
BendingTest::best_within_budget() const
{
  int best = -1;
  for (unsigned int k = 0; k < variants.size(); ++k)
    if (has_error(k) && variants[k].dofs <= budget &&
        (best < 0 || utilization(k) < utilization(best)))
      best = k;
  return best;
}



void
BendingTest::print_utilizations() const
{
  dealii::TableHandler table;
  for (unsigned int k = 0; k < variants.size(); ++k)
    if (has_error(k))
      {
        table.add_value("variant", variants[k].name);
        table.add_value("DoFs", variants[k].dofs);
        for (unsigned int q = 0; q < tolerances.size(); ++q)
          {
            table.add_value(purposes[q], error(k, q) / tolerances[q]);
            table.set_precision(purposes[q], 3);
          }
        table.add_value("all", utilization(k));
        table.set_precision("all", 3);
      }
  std::cout << "\nErrors over tolerances\n";
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// The two answers, as the DoFs of a variant, its name and what it uses. Seconds
// of variants this small are within what a machine lets two equal runs differ,
// DoFs are the same everywhere.
void
BendingTest::decide() const
{
  const auto say = [&](const std::string &question, const int k) {
    std::cout << question << ": ";
    if (k < 0)
      std::cout << "none\n";
    else
      std::cout << variants[k].dofs << "\n  (" << variants[k].name << ", "
                << variants[k].seconds << " s, uses " << utilization(k)
                << " of the tolerances)\n";
  };
  std::cout.precision(3);
  std::cout << "\nAll at once, DoFs of the variant\n";
  say("all tolerances, fewest DoFs", cheapest(&Run::dofs));
  say("all tolerances, fewest seconds", cheapest(&Run::seconds));
  say("best within the budget", best_within_budget());
}



// Two things are known without any of this. The force of the first variant,
// EBBT: the half of the strip is a cantilever upside down, 3 EI u / L^3, with
// the EI of fibers alone, since EBBT couples nothing across the plies. And the
// shear stress in the interface, from the equilibrium of ply 1 (its area A_1
// and its distance z_1 from the middle) in a beam with that EI, as a mean over
// the width,
//
//   F E_1 A_1 z_1 / (b EI).
void
BendingTest::check() const
{
  constexpr double            way = 0.5, length = 24., width = 6., ply = 1.;
  const EngineeringConstants &carbon = scene.materials.at("carbon").elastic;

  const double EI =
                 width * ply * ply * ply / 12. * (26. * carbon.E1 + carbon.E2),
               force = 3. * EI * way / std::pow(length, 3),
               shear =
                 variants[reference].values[0] * carbon.E1 * ply * ply / EI;
  std::cout.precision(8);
  std::cout << "\nforce of EBBT over 3 EI u / L^3: "
            << variants.front().values.at(0) / force
            << "\nshear stress of the reference over its mean: "
            << std::abs(variants[reference].values[2]) / shear
            << "\nlargest imbalance of nose and bearing: " << largest_imbalance
            << std::endl;
}



// `lamella trade` prints errors and costs of the same variants, and says in a
// sentence what is the cheapest for each quantity; plot.py in this folder draws
// the decision from its table.
void
BendingTest::run()
{
  // The first run waits for libraries to be read from disk; it does not count.
  climb(scene.trade.variants.front());
  for (const TradeVariant &entry : scene.trade.variants)
    {
      std::cout << entry.name << ": " << std::flush;
      variants.push_back(climb(entry));
      if (variants.back().failure.empty())
        {
          reference = variants.size() - 1;
          std::cout << variants.back().dofs << " DoFs" << std::endl;
        }
      else
        std::cout << "failed: " << variants.back().failure << std::endl;
    }

  print_utilizations();
  decide();
  check();
}



int
main(int argc, char **argv)
{
  // The axis is shared among processes, so there is MPI, for one, too.
  MpiSession mpi(argc, argv);
  return run_and_report([] { BendingTest().run(); });
}
