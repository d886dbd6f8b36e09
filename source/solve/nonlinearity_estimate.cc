// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/small_motions.h>

#include <deal.II/lac/lapack_full_matrix.h>

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



    /// Lanczos' iteration for the largest mu of -K_G v = mu K v, K the
    /// stiffness that @p solver solves with the active rows of a state. In the
    /// inner product of K the operator -K^-1 K_G is symmetric, and no product
    /// with K is needed: with every vector q comes the load K q that made it.
    class BucklingModes
    {
    public:
      BucklingModes(const Structure          &structure,
                    LinearSystem             &solver,
                    const ActiveConstraints  &closed,
                    const GeometricStiffness &geometric)
        : structure(structure)
        , solver(solver)
        , closed(closed)
        , geometric(geometric)
      {}

      /// Iterates until the largest mu that is no mode of stabilizing springs
      /// is known to a part in a million or certainly below @p least. Returns
      /// it with its mode, or none that is at least that. What springs hold of
      /// the mode is taken off its energy, as Rayleigh's quotient has it.
      std::optional<std::pair<double, BlockVector>>
      largest(const double least);

    private:
      /// K^-1 @p load with the active rows closed.
      BlockVector
      solve(const BlockVector &load);
      /// Subtracts the parts along all q from @p v, of @p load; returns them.
      std::vector<double>
      orthogonalize(BlockVector &v, BlockVector &load) const;
      /// Makes @p v and its load the next q, unless it has no length.
      bool
      append(BlockVector v, BlockVector load);
      /// Share of stabilizing springs in the (unit) energy of @p mode.
      double
      share_of_springs(const BlockVector &mode) const;

      const Structure          &structure;
      LinearSystem             &solver;
      const ActiveConstraints   closed;
      const GeometricStiffness &geometric;
      /// Lanczos vectors q with q . K q = 1, and their products K q.
      std::vector<BlockVector> q, Kq;
      /// Norm of the remainder of the last step, orthogonal to q.
      double beta = 0.;
    };



    BlockVector
    BucklingModes::solve(const BlockVector &load)
    {
      BlockVector du;
      Vector      gaps(closed.numbers.size()), forces;
      solver.solve_linear(closed, load, gaps, du, forces);
      return du;
    }



    std::vector<double>
    BucklingModes::orthogonalize(BlockVector &v, BlockVector &load) const
    {
      std::vector<double> parts(q.size(), 0.);
      for (unsigned int pass = 0; pass < 2; ++pass)
        for (unsigned int i = 0; i < q.size(); ++i)
          {
            const double part = v * Kq[i];
            v.add(-part, q[i]);
            load.add(-part, Kq[i]);
            parts[i] += part;
          }
      return parts;
    }



    bool
    BucklingModes::append(BlockVector v, BlockVector load)
    {
      const double energy = v * load;
      if (!(energy > 0.))
        return false;
      beta = std::sqrt(energy);
      v /= beta;
      load /= beta;
      q.push_back(std::move(v));
      Kq.push_back(std::move(load));
      return true;
    }



    double
    BucklingModes::share_of_springs(const BlockVector &mode) const
    {
      double energy = 0.;
      for (unsigned int b = 0; b < mode.n_blocks(); ++b)
        for (const Spring &spring : structure.springs(b))
          {
            const double length = spring.row(mode.block(b));
            energy += spring.stiffness * length * length;
          }
      return energy;
    }



    std::optional<std::pair<double, BlockVector>>
    BucklingModes::largest(const double least)
    {
      constexpr unsigned int first_look = 4, most_steps = 30;
      // Of mu; its error is of the square of the residual. What is far away
      // need not be known as well as what is near.
      constexpr double settled = 1e-2, settled_far = 0.05;
      constexpr double of_springs = 0.5,
                       rounding   = arithmetic::rounding_of_solutions;

      // Forces anywhere excite all modes.
      const BlockVector load = random_vector(structure.zero());
      if (!append(solve(load), load))
        return {};

      std::vector<std::vector<double>> columns;
      while (true)
        {
          BlockVector next_load = geometric(q.back());
          next_load *= -1.;
          BlockVector next = solve(next_load);
          columns.push_back(orthogonalize(next, next_load));
          const unsigned int n = columns.size();
          const bool         is_exhausted =
            !append(std::move(next), std::move(next_load)) ||
            beta < rounding * std::abs(columns[0][0]);

          LAPACKFullMatrix<double> T(n, n);
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i <= j; ++i)
              T(i, j) = T(j, i) = columns[j][i];
          Vector             mu;
          FullMatrix<double> s;
          T.compute_eigenvalues_symmetric(
            -T.frobenius_norm() - 1., T.frobenius_norm() + 1., 0., mu, s);
          // Ascending: the largest first that is the bodies' own.
          for (unsigned int k = n; k-- > 0;)
            {
              const double residual =
                is_exhausted ? 0. : std::abs(beta * s(n - 1, k));
              const bool is_settled =
                residual <=
                (mu[k] < near ? settled_far : settled) * std::abs(mu[k]);
              if (n >= first_look && mu[k] + residual < least)
                return {};
              if (is_exhausted && mu[k] < least)
                return {};
              if (!is_settled && n < most_steps)
                break;
              BlockVector mode = structure.zero();
              for (unsigned int i = 0; i < n; ++i)
                mode.add(s(i, k), q[i]);
              if (const double held = share_of_springs(mode); held < of_springs)
                {
                  if (mu[k] < least)
                    return {};
                  return std::make_pair(mu[k] / (1. - held), mode);
                }
            }
          if (is_exhausted || n == most_steps)
            return {};
        }
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
    BucklingModes modes(structure,
                        solver,
                        solver.sticking_equations(state),
                        geometric);
    if (const auto buckling = modes.largest(least))
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
