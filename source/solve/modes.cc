// SPDX-License-Identifier: LGPL-2.1-or-later

// Natural and buckling modes by the Lanczos method with the inverse of the
// stiffness: A v = mu K v with A = M and mu = 1 / omega^2 (shift-invert at
// zero), or A = -K_G and mu = 1 / lambda.

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/mass_matrix.h>
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
    /// Throws InputError if a model with @p n_free DoFs has no basis of the
    /// Lanczos method for @p n modes.
    void
    check_number(const unsigned int n, const unsigned int n_free)
    {
      // 2 n + 10 vectors, and one more for the residual.
      const unsigned int most = n_free < 13 ? 0 : (n_free - 11) / 2;
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



    /// Sets body and motion of @p mode, whose energies are @p energies. Motions
    /// of buckling modes have equal densities as weights.
    void
    describe(const Structure           &structure,
             const BlockVector         &u,
             const std::vector<double> &energies,
             const bool                 is_buckling,
             Mode                      &mode)
    {
      mode.body =
        std::max_element(energies.begin(), energies.end()) - energies.begin();
      const Body &body = *structure.bodies()[mode.body];
      mode.motion =
        motion_shares(body,
                      is_buckling ? std::vector<double>() : densities(body),
                      u.block(mode.body),
                      mode.shape.block(mode.body));
    }



    /// Returns the rigid motions of all bodies together: translations along the
    /// scene axes, and rotations about @p center.
    std::vector<BlockVector>
    rigid_motions_about(const Structure   &structure,
                        const BlockVector &u,
                        const Point<3>    &center)
    {
      std::vector<BlockVector> motions(6, structure.zero());
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          const Body               &body = *structure.bodies()[b];
          const std::vector<Vector> own  = body.rigid_motions(u.block(b));
          const Tensor<1, 3>        arm  = body.center() - center;
          for (unsigned int m = 0; m < 3; ++m)
            {
              motions[m].block(b)     = own[m];
              motions[3 + m].block(b) = own[3 + m];
              // e_m x arm.
              const unsigned int i = (m + 1) % 3, j = (m + 2) % 3;
              motions[3 + m].block(b).add(-arm[j], own[i]);
              motions[3 + m].block(b).add(arm[i], own[j]);
            }
        }
      return motions;
    }



    /// Returns the pairs of @p problem that @p request wants.
    Eigenpairs
    requested_pairs(const Eigenproblem &problem,
                    const BlockVector  &like,
                    const ModeRequest  &request,
                    const unsigned int  n_free)
    {
      if (!request.range)
        return all_eigenpairs(problem, like, request.number, n_free);
      const auto [lower, upper] = *request.range;
      Eigenpairs pairs;
      for (unsigned int n = 10;; n *= 2)
        {
          pairs = all_eigenpairs(problem, like, n, n_free);
          if (pairs.values.empty() || frequency(pairs.values.back()) > upper)
            break;
        }
      double     nearest = 0.;
      Eigenpairs inside;
      for (unsigned int k = 0; k < pairs.values.size(); ++k)
        {
          const double f    = frequency(pairs.values[k]);
          const auto   away = [&](const double of) {
            return std::max(lower - of, of - upper);
          };
          if (k == 0 || away(f) < away(nearest))
            nearest = f;
          if (f < lower || f > upper)
            continue;
          inside.values.push_back(pairs.values[k]);
          inside.vectors.push_back(pairs.vectors[k]);
        }
      if (inside.values.empty())
        throw InputError("Modes",
                         to_text(lower) + " to " + to_text(upper),
                         "solve.no-mode-in-range: no natural frequency is in "
                         "this range; the nearest one is " +
                           to_text(nearest, 6) + " Hz",
                         "Write a range that contains it.");
      return inside;
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



  std::string
  Mode::kind() const
  {
    return motion_names[std::max_element(motion.begin(), motion.end()) -
                        motion.begin()];
  }



  NaturalModes
  natural_modes(LinearSystem             &system,
                const State              &state,
                const GeometricStiffness *prestress,
                const ModeRequest        &request)
  {
    const Structure &structure = system.tangent().of();
    NaturalModes     found;
    found.inertia = inertia_of(structure.bodies());
    const MassMatrix   mass(structure, state.u);
    const SmallMotions motions(
      system,
      state,
      [&](const BlockVector &v) { return mass(v); },
      prestress == nullptr ?
        Operator() :
        [&](const BlockVector &v) { return (*prestress)(v); });
    found.n_rigid = motions.rigid_motions().size();
    const Eigenproblem problem{
      [&](const BlockVector &v) { return mass(v); },
      [&](const BlockVector &v) { return motions.times_stiffness(v); },
      [&](const BlockVector &f) { return motions.solve(f); },
      true};
    Eigenpairs pairs = requested_pairs(problem,
                                       structure.zero(),
                                       request,
                                       motions.n_free_dofs());
    const auto whole =
      rigid_motions_about(structure, state.u, found.inertia.center());
    for (unsigned int k = 0; k < pairs.values.size(); ++k)
      {
        found.modes.push_back(natural_mode(
          pairs.values[k], std::move(pairs.vectors[k]), mass, whole));
        describe(structure,
                 state.u,
                 mass.energies(found.modes.back().shape),
                 false,
                 found.modes.back());
      }
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
    const Eigenproblem problem{
      [&](const BlockVector &v) {
        BlockVector f = geometric(v);
        f *= -1.;
        return f;
      },
      [&](const BlockVector &v) { return motions.times_stiffness(v); },
      [&](const BlockVector &f) { return motions.solve(f); }};
    Eigenpairs pairs =
      all_eigenpairs(problem, structure.zero(), number, motions.n_free_dofs());
    std::vector<Mode> modes;
    for (unsigned int k = 0; k < pairs.values.size(); ++k)
      if (pairs.values[k] > 0.)
        {
          Mode mode;
          mode.value = 1. / pairs.values[k];
          mode.shape = std::move(pairs.vectors[k]);
          mode.shape /= mode.shape.linfty_norm();
          const BlockVector   f = motions.times_stiffness(mode.shape);
          std::vector<double> energies;
          for (unsigned int b = 0; b < f.n_blocks(); ++b)
            energies.push_back(f.block(b) * mode.shape.block(b));
          describe(structure, state.u, energies, true, mode);
          modes.push_back(std::move(mode));
        }
    return modes;
  }
} // namespace lamella
