// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/nonlinearity_estimate.h>
#include <lamella/solve/small_motions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Effects below that are not worth a word; loads over those that buckle:
    // not worth looking for, and worth a word even if nothing excites the mode.
    constexpr double effect_worth_saying = 1e-2, worth_solving = 1e-2,
                     near = 0.1;
    // Beyond these the linear result is no approximation of anything.
    constexpr double most_stiffening = 1., least_buckling_factor = 1.;
    // Share of the energy of all bodies: below it, bodies move rigidly.
    constexpr double share_that_counts = 1e-3;



    /// Sets the stiffening of @p found from the energies of linear and membrane
    /// stresses.
    void
    find_stiffening(const std::vector<double> &energies,
                    const std::vector<double> &stretched,
                    NonlinearityEstimate      &found)
    {
      const double all =
        std::accumulate(energies.begin(), energies.end(), 0.) +
        std::accumulate(stretched.begin(), stretched.end(), 0.);
      for (unsigned int b = 0; b < energies.size(); ++b)
        if (stretched[b] + energies[b] > share_that_counts * all &&
            energies[b] > 0.)
          if (const double r = 2. * stretched[b] / energies[b];
              r > found.stiffening)
            {
              found.stiffening = r;
              found.stiffened  = b;
            }
    }



    /// Returns the first buckling mode and the inverse mu of its factor, unless
    /// mu is below @p least. A search with springs finds whether there is one:
    /// 1
    /// + mu to 1 %. A second one, without springs, finds mu to 1 %, or 5 % far
    /// from buckling, and a second mode, as one alone may converge to that.
    std::optional<std::pair<double, BlockVector>>
    first_buckling_mode(LinearSystem             &solver,
                        const State              &state,
                        const GeometricStiffness &geometric,
                        const double              least)
    {
      constexpr unsigned int basis = 5, restarts = 20;
      const BlockVector      start = random_vector(state.u);
      using Found       = std::optional<std::pair<double, BlockVector>>;
      const auto search = [&](const bool               without_springs,
                              const unsigned int       n,
                              const LanczosParameters &parameters) -> Found {
        const SmallMotions motions(
          solver, state, [](const auto &v) { return v; }, {}, without_springs);
        if (motions.n_free_dofs() <= parameters.vectors)
          return {};
        const Eigenpairs pairs = largest_eigenpairs({[&](const BlockVector &v) {
                                                       BlockVector f =
                                                         geometric(v);
                                                       f *= -1.;
                                                       return f;
                                                     },
                                                     {},
                                                     [&](const BlockVector &f) {
                                                       return motions.solve(f);
                                                     }},
                                                    start,
                                                    n,
                                                    parameters);
        if (pairs.values.empty() || pairs.values[0] < least)
          return {};
        const BlockVector &v = pairs.vectors[0];
        const double       mu =
          -(geometric(v) * v) / (motions.times_stiffness(v) * v);
        return mu >= least ? Found({mu, v}) : Found();
      };
      const Found first = search(false, 1, {1e-2, basis, restarts, 1.});
      return !first ?
               Found() :
               search(solver.tangent().of().has_springs(),
                      2,
                      {first->first < near ? 5e-2 : 1e-2, 2 * basis, restarts});
    }



    /// Whose the buckling @p mode of @p found is, and how much of the state.
    void
    record_buckling_mode(const Structure           &structure,
                         const State               &state,
                         const std::vector<double> &energies,
                         const BlockVector         &mode,
                         NonlinearityEstimate      &found)
    {
      double most = 0., along = 0., of_mode = 0., of_state = 0.;
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          const Vector &v = mode.block(b);
          Vector        f(v.size());
          structure.bodies()[b]->add_internal_forces(v, f);
          const double energy = f * v;
          of_mode += energy;
          along += f * state.u.block(b);
          of_state += 2. * energies[b];
          if (energy > most)
            {
              most          = energy;
              found.buckled = b;
            }
        }
      if (*found.buckling_factor > 1. && of_state > 0. && of_mode > 0.)
        found.amplification = std::abs(along) / std::sqrt(of_mode * of_state) /
                              (*found.buckling_factor - 1.);
    }



    /// What stiffens, and how much.
    std::string
    describe_stiffening(const NonlinearityEstimate &found,
                        const Structure            &structure)
    {
      const std::string of_body =
        "body '" + structure.bodies()[found.stiffened]->name() + "'";
      const std::string what =
        of_body + " is stretched as it deflects, since supports restrain it: ";
      if (found.stiffening < 1.)
        return what + "this membrane force stiffens it by " +
               to_text(100. * found.stiffening, 2) + " % (stiffening " +
               to_text(found.stiffening, 2) + ")";
      return what + "forces at these displacements are about " +
             to_text(1. + found.stiffening, 2) +
             " times those of the linear model (stiffening " +
             to_text(found.stiffening, 2) + ")";
    }



    std::string
    describe_buckling(const NonlinearityEstimate &found,
                      const Structure            &structure)
    {
      if (!found.buckling_factor)
        return "displacements grow by about " +
               to_text(100. * found.amplification, 2) + " %";
      const double lambda = *found.buckling_factor;
      std::string  text = "body '" + structure.bodies()[found.buckled]->name() +
                         "' buckles at " + to_text(lambda, 4) +
                         " times these loads (buckling factor " +
                         to_text(lambda, 4) + ")";
      if (lambda >= least_buckling_factor &&
          found.amplification > effect_worth_saying)
        text += ", which amplifies the deflection in its buckling mode by " +
                to_text(100. / (lambda - 1.), 2) +
                " %, displacements by about " +
                to_text(100. * found.amplification, 2) + " %";
      return text;
    }
  } // namespace



  NonlinearityEstimate
  beyond_linear(const Structure           &structure,
                LinearSystem              &solver,
                const State               &state,
                const std::vector<double> &energies)
  {
    NonlinearityEstimate     found;
    const GeometricStiffness geometric(solver, state);
    find_stiffening(energies, geometric.membrane_energies(), found);

    // What is stretched that far buckles otherwise, if at all.
    if (found.stiffening > most_stiffening)
      return found;
    const double least =
      std::max(worth_solving, geometric.largest_short_wave_ratio());
    if (const auto buckling =
          first_buckling_mode(solver, state, geometric, least))
      {
        const auto &[mu, mode] = *buckling;
        found.buckling_factor  = 1. / mu;
        record_buckling_mode(structure, state, energies, mode, found);
      }
    else if (const double energy =
               std::accumulate(energies.begin(), energies.end(), 0.);
             energy > 0.)
      // No mode that was looked for grows by more than `least`.
      found.amplification =
        std::clamp(-0.5 * (geometric(state.u) * state.u) / energy, 0., least);
    return found;
  }



  std::vector<std::string>
  warnings_of(const NonlinearityEstimate &found, const Structure &structure)
  {
    std::vector<std::string> warnings;
    if (found.stiffening > effect_worth_saying)
      warnings.push_back(
        "solve.large-deflections: the deflections are so large that effects "
        "which the linear model neglects matter: " +
        describe_stiffening(found, structure));
    if (found.amplification > effect_worth_saying ||
        (found.buckling_factor && *found.buckling_factor * near < 1.))
      warnings.push_back(
        "solve.compression: compressive forces reduce the stiffness: " +
        describe_buckling(found, structure));
    return warnings;
  }



  void
  check_linear_range(const NonlinearityEstimate &found,
                     const Structure            &structure)
  {
    const std::string remedy =
      ". The linear result is no approximation here. Use Rotations = large, "
      "reduce the loads, or write Beyond linear range = accept.";
    if (found.stiffening > most_stiffening)
      throw NumericsError("solve.large-deflections: The deflections are too "
                          "large for the linear model: " +
                          describe_stiffening(found, structure) + remedy);
    if (found.buckling_factor && *found.buckling_factor < least_buckling_factor)
      throw NumericsError(
        "solve.beyond-buckling: The loads exceed the buckling load: " +
        describe_buckling(found, structure) + remedy);
  }
} // namespace lamella
