// SPDX-License-Identifier: LGPL-2.1-or-later

// Natural and buckling modes by the Lanczos method with the inverse of the
// stiffness: A v = mu K v with A = M and mu = 1 / omega^2 (shift-invert at
// zero), or A = -K_G and mu = 1 / lambda.

#include <lamella/base/arithmetic.h>
#include <lamella/base/entry.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/modes.h>
#include <lamella/solve/small_motions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns the number of modes for which a model with @p n_free DoFs has a
    /// basis of the Lanczos method: 2 n + 10 vectors, and a residual.
    unsigned int
    largest_number(const unsigned int n_free)
    {
      return n_free < 13 ? 0 : (n_free - 11) / 2;
    }



    void
    check_number(const unsigned int n, const unsigned int n_free)
    {
      const unsigned int most = largest_number(n_free);
      if (n > most)
        throw InputError("Modes",
                         std::to_string(n),
                         "solve.too-many-modes: the model has only " +
                           std::to_string(n_free) + " free DoFs, enough for " +
                           std::to_string(most) + " modes",
                         "Request fewer modes, or use more elements.");
    }



    /// Returns the @p n largest eigenpairs of @p problem, none missing, on a
    /// space of @p n_free dimensions.
    Eigenpairs
    all_eigenpairs(const Eigenproblem &problem,
                   const BlockVector  &like,
                   const unsigned int  n,
                   const unsigned int  n_free)
    {
      check_number(n, n_free);
      const BlockVector start = random_vector(like);
      Eigenpairs        pairs = largest_eigenpairs(problem, start, n);
      if (!pairs.values.empty())
        add_missing_eigenpairs(problem, start, {}, pairs);
      return pairs;
    }



    /// Frequency [Hz] of the eigenvalue 1 / omega^2.
    double
    frequency(const double mu)
    {
      return 1. / (2. * numbers::PI * std::sqrt(mu));
    }



    /// Sets the motion of each of @p modes, whose bodies are known. Motions of
    /// buckling modes have equal densities as weights.
    void
    describe(const Structure   &structure,
             const BlockVector &u,
             const bool         is_buckling,
             std::vector<Mode> &modes)
    {
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          std::vector<const Vector *> shapes;
          std::vector<Mode *>         own;
          for (Mode &mode : modes)
            if (mode.body == b)
              {
                own.push_back(&mode);
                shapes.push_back(&mode.shape.block(b));
              }
          if (own.empty())
            continue;
          const Body &body = *structure.bodies()[b];
          const auto  rho =
            is_buckling ? std::vector<double>() : densities(body);
          const auto motions = motions_of(body, rho, u.block(b), shapes);
          for (unsigned int k = 0; k < own.size(); ++k)
            own[k]->motion = motions[k];
        }
    }



    unsigned int
    index_of_largest(const std::vector<double> &energies)
    {
      return std::max_element(energies.begin(), energies.end()) -
             energies.begin();
    }



    /// Returns the pairs with frequencies up to more than @p upper. Refuses
    /// @p entry if the model has too few DoFs.
    Eigenpairs
    pairs_beyond(const double        upper,
                 const Eigenproblem &problem,
                 const BlockVector  &like,
                 const unsigned int  n_free,
                 const Entry        &entry)
    {
      const unsigned int most = largest_number(n_free);
      for (unsigned int n = 10;; n *= 2)
        {
          Eigenpairs pairs =
            all_eigenpairs(problem, like, std::min(n, most), n_free);
          if (!pairs.values.empty() && frequency(pairs.values.back()) > upper)
            return pairs;
          if (pairs.values.empty() || n >= most)
            entry.refuse("solve.range-of-modes-too-high: the model has only " +
                           std::to_string(n_free) +
                           " free DoFs, too few for all modes of this range",
                         "Use more elements, or a lower limit.");
        }
    }



    /// Returns the pairs of @p problem that @p request wants, and the number
    /// @p n_below of those with lower frequencies.
    Eigenpairs
    requested_pairs(const Eigenproblem &problem,
                    const BlockVector  &like,
                    const ModeRequest  &request,
                    const unsigned int  n_free,
                    unsigned int       &n_below)
    {
      n_below = 0;
      if (!request.range)
        return all_eigenpairs(problem,
                              like,
                              request.is_limit ?
                                std::clamp(largest_number(n_free),
                                           1u,
                                           request.number) :
                                request.number,
                              n_free);
      const double lower = request.range->first, upper = request.range->second;
      const Entry  entry("Modes", to_text(lower) + " to " + to_text(upper));
      const Eigenpairs all = pairs_beyond(upper, problem, like, n_free, entry);
      Eigenpairs       inside;
      double           nearest = 0.;
      for (unsigned int k = 0; k < all.values.size(); ++k)
        {
          const double f = frequency(all.values[k]);
          if (k == 0 || std::abs(f - std::clamp(f, lower, upper)) <
                          std::abs(nearest - std::clamp(nearest, lower, upper)))
            nearest = f;
          n_below += f < lower;
          if (f < lower || f > upper)
            continue;
          inside.values.push_back(all.values[k]);
          inside.vectors.push_back(all.vectors[k]);
        }
      if (inside.values.empty())
        entry.refuse("solve.no-mode-in-range: no natural frequency is in this "
                     "range; the nearest one is " +
                       to_text(nearest, 6) + " Hz",
                     "Write a range that contains it.");
      return inside;
    }



    /// Returns the problem A v = mu K v with the stiffness of @p motions.
    Eigenproblem
    eigenproblem(const Operator &times_A, const SmallMotions &motions)
    {
      return {times_A,
              [&](const BlockVector &v) { return motions.times_stiffness(v); },
              [&](const BlockVector &f) { return motions.solve(f); }};
    }



    /// Throws NumericsError if the stresses of @p prestress give a rigid motion
    /// a stiffness that is considerable beside the lowest omega^2, @p lowest.
    void
    check_rigid_motions(const SmallMotions       &motions,
                        const GeometricStiffness *prestress,
                        const Eigenpairs         &pairs)
    {
      for (const BlockVector &r : motions.rigid_motions())
        if (prestress != nullptr && !pairs.values.empty() &&
            std::abs((*prestress)(r)*r) * pairs.values.front() >
              arithmetic::dependency_tolerance)
          throw NumericsError(
            "solve.prestressed-rigid-motion: The stresses of the last load step "
            "give a free rigid motion a stiffness, as in a pendulum. Linear "
            "kinematics cannot represent that. Use Rotations = large.");
    }



    /// Returns the mode with the eigenvalue @p mu = 1 / omega^2 and the shape
    /// @p v, with its participation factors of the motions @p whole.
    Mode
    natural_mode(const double                    mu,
                 BlockVector                     v,
                 const MassMatrix               &mass,
                 const std::vector<BlockVector> &whole)
    {
      if (!(mu > 0.))
        throw NumericsError(
          "solve.unstable-state: The state after the last load step is not "
          "stable: a small motion has negative stiffness. Natural frequencies "
          "exist for stable states only; reduce the loads.");
      Mode mode;
      mode.value              = frequency(mu);
      mode.shape              = std::move(v);
      const BlockVector Mv    = mass(mode.shape);
      const double      scale = 1. / std::sqrt(mode.shape * Mv);
      mode.shape *= scale;
      for (unsigned int d = 0; d < whole.size(); ++d)
        mode.participation[d] = scale * (whole[d] * Mv);
      return mode;
    }
  } // namespace



  double
  Mode::similarity(const Mode &other) const
  {
    if (body != other.body ||
        motion.momenta.size() != other.motion.momenta.size())
      return 0.;
    double ab = 0., aa = 0., bb = 0.;
    for (unsigned int k = 0; k < motion.momenta.size(); ++k)
      {
        const double a = motion.momenta[k], b = other.motion.momenta[k];
        ab += a * b;
        aa += a * a;
        bb += b * b;
      }
    return aa * bb > 0. ? ab * ab / (aa * bb) : 0.;
  }



  std::string
  Mode::kind() const
  {
    const MotionShares &shares = motion.shares;
    return motion_names[std::max_element(shares.begin(), shares.end()) -
                        shares.begin()];
  }



  NaturalModes
  natural_modes(const VibrationEquations &equations,
                const Point<3>           &center,
                const ModeRequest        &request)
  {
    const Structure    &structure = equations.system.tangent().of();
    const MassMatrix   &mass      = equations.mass;
    const SmallMotions &motions   = equations.motions;
    NaturalModes        found;
    found.n_rigid = motions.rigid_motions().size();
    Eigenproblem problem =
      eigenproblem([&](const BlockVector &v) { return mass(v); }, motions);
    problem.in_product_of_A = true;
    unsigned int n_below    = 0;
    Eigenpairs   pairs      = requested_pairs(
      problem, structure.zero(), request, motions.n_free_dofs(), n_below);
    check_rigid_motions(motions, equations.prestress, pairs);
    const BlockVector &u     = equations.state.u;
    const auto         whole = rigid_motions_about(structure, u, center);
    for (unsigned int k = 0; k < pairs.values.size(); ++k)
      {
        Mode mode   = natural_mode(pairs.values[k],
                                 std::move(pairs.vectors[k]),
                                 mass,
                                 whole);
        mode.number = n_below + k + 1;
        mode.body   = index_of_largest(mass.energies(mode.shape));
        found.modes.push_back(std::move(mode));
      }
    describe(structure, u, false, found.modes);
    return found;
  }



  std::vector<Mode>
  buckling_modes(LinearSystem             &system,
                 const State              &state,
                 const GeometricStiffness &geometric,
                 const unsigned int        number)
  {
    const Structure   &structure = system.tangent().of();
    const SmallMotions motions(system, state, [](const BlockVector &v) {
      return v;
    });
    const Eigenproblem problem = eigenproblem(
      [&](const BlockVector &v) {
        BlockVector f = geometric(v);
        f *= -1.;
        return f;
      },
      motions);
    Eigenpairs pairs =
      all_eigenpairs(problem, structure.zero(), number, motions.n_free_dofs());
    std::vector<Mode> modes;
    for (unsigned int k = 0; k < pairs.values.size(); ++k)
      if (pairs.values[k] > 0.)
        {
          Mode mode;
          mode.number = modes.size() + 1;
          mode.value  = 1. / pairs.values[k];
          mode.shape  = std::move(pairs.vectors[k]);
          mode.shape /= mode.shape.linfty_norm();
          const BlockVector   f = motions.times_stiffness(mode.shape);
          std::vector<double> energies;
          for (unsigned int b = 0; b < f.n_blocks(); ++b)
            energies.push_back(f.block(b) * mode.shape.block(b));
          mode.body = index_of_largest(energies);
          modes.push_back(std::move(mode));
        }
    describe(structure, state.u, true, modes);
    return modes;
  }
} // namespace lamella
