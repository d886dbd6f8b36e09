// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/processes.h>
#include <lamella/linear/factorization.h>
#include <lamella/solve/tangent_operator.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <tuple>

// Tangent stiffness K(u) of all bodies with prescribed displacements by exact
// elimination: K_c = G^T (K + springs) G (RowReduction). For rotating rows, the
// reduction is formed anew at the state, from the rows that are independent in
// the undeformed body. Follower loads contribute their symmetric part to the
// factor and their skew part by GMRES.
//
// Displacements are u = G v + u_p. The condensed residual G^T r vanishes in
// equilibrium, while r in eliminated DoFs holds the reactions. Products K w are
// evaluated from strains, solutions by the factor of the assembled matrix.
// Bodies are factorized one by one, as K is block diagonal: contact couples
// them through rows only. Callbacks report assembly and the size of a factor
// before its memory is allocated.
namespace lamella
{
  using dealii::Tensor;

  TangentOperator::TangentOperator(
    const Structure                            &structure,
    const BlockVector                          &u,
    const LoadFactor                           &factor,
    const BlockVector                          &correction,
    const std::vector<std::vector<SpringTerm>> &more)
    : structure(structure)
    , state(u)
    , factor(factor)
    , correction(correction)
    , more(more)
  {
    move_supports();
  }



  // Linearizes the prescribed rows at the state: row_at() gives the row r(u)
  // and its current value, from which support_increment() takes the increment.
  void
  TangentOperator::move_supports()
  {
    const Bodies                  &bodies = structure.bodies();
    const std::vector<std::string> names(structure.prescribed().size());
    moved_reductions.resize(bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        if (!bodies[b]->constraints_rotate())
          continue;
        if (moved_rows.empty())
          {
            moved_rows = structure.prescribed();
            measured.assign(moved_rows.size(), 0.);
          }
        // Rows that depend on others in the undeformed body stay omitted: their
        // small second-order remainder would constrain warpings.
        std::vector<PrescribedFunctional> held = moved_rows;
        for (PrescribedFunctional &row : held)
          row.row.body = dealii::numbers::invalid_unsigned_int;
        for (const auto &[k, force] :
             structure.reduction(b).multipliers(Vector(bodies[b]->n_dofs())))
          {
            std::tie(moved_rows[k], measured[k]) =
              row_at(moved_rows[k], *bodies[b], state.block(b));
            held[k] = moved_rows[k];
            // support_increment() sets the values.
            held[k].value = 0.;
          }
        // Elimination of rows at the state; values of 0 have no contradictions.
        moved_reductions[b] =
          std::make_unique<RowReduction>(*bodies[b], b, held, names);
      }
  }



  // G^T r: adds the entries of eliminated DoFs to those that they depend on.
  void
  TangentOperator::condense(BlockVector &r) const
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        reduction(b).constraints().condense(r.block(b));
        reduction(b).constraints().set_zero(r.block(b));
      }
  }



  // First-order increment of the supports, value(s) - current value + (t - s) d
  // value/ds, in the eliminated DoFs (RowReduction::influence()).
  BlockVector
  TangentOperator::support_increment(const LoadFactor &from,
                                     const LoadFactor &to) const
  {
    BlockVector u = structure.particular(to);
    u -= structure.particular(from);
    const std::vector<PrescribedFunctional> &rows = prescribed();
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        const bool moves = moved_reductions[b] != nullptr;
        if (moves || structure.has_prescribed_rotation(b))
          u.block(b) = reduction(b).influence([&](const unsigned int k) {
            const double s  = from.of(rows[k].history),
                         is = moves ? measured[k] :
                                      rows[k].row.row(state.block(b));
            return rows[k].value_at(s) - is +
                   (to.of(rows[k].history) - s) * rows[k].rate_at(s);
          });
      }
    return u;
  }



  namespace
  {
    /// Returns the part of @p u in DoFs without rigid motions: warpings.
    Vector
    warpings_in(const Body &body, const Vector &u)
    {
      Vector warpings = u;
      for (const Vector &motion : body.rigid_motions(u))
        for (DofIndex dof = 0; dof < u.size(); ++dof)
          if (motion[dof] != 0.)
            warpings[dof] = 0.;
      return warpings;
    }



    /// Returns |(R - 1) Phi a|, the effect of the section's rotation on the
    /// displacement of @p warpings of @p u at @p location.
    double
    rotated_warping_error(const Body     &body,
                          const Location &location,
                          const Vector   &u,
                          const Vector   &warpings)
    {
      Tensor<1, 3>                        turned;
      const std::vector<LinearFunctional> rows = body.rows({location}, u)[0];
      for (unsigned int c = 0; c < 3; ++c)
        turned[c] = rows[c](warpings);
      return (turned - transpose(body.rotation_at(location, u)) * turned)
        .norm();
    }



    /// Returns largest_support_error() of the body number @p b in the state @p
    /// u, in a structure of the size @p size.
    /// Largest deviation from prescribed positions over the tolerance, ten
    /// times the effect of rotated warping (plus the tolerance of positions).
    TangentOperator::SupportError
    support_error_of(const Body                              &body,
                     const unsigned int                       b,
                     const Vector                            &u,
                     const std::vector<PrescribedFunctional> &rows,
                     const std::vector<bool>                 &is_followed,
                     const LoadFactor                        &at,
                     const double                             size)
    {
      // Dependent rows are combinations of others, with factors of order ten.
      constexpr double combined     = 10.;
      const Vector     warpings     = warpings_in(body, u);
      double           second_order = 0., off = 0.;
      dealii::Point<3> place;
      for (unsigned int k = 0; k < rows.size(); ++k)
        if (rows[k].row.body == b && rows[k].location)
          {
            second_order = std::max(
              second_order,
              rotated_warping_error(body, *rows[k].location, u, warpings));
            const auto [row, is] = row_at(rows[k], body, u);
            const double by = std::abs(is - row.value_at(at.of(row.history)));
            if (!is_followed[k] && by > off)
              {
                off   = by;
                place = row.position;
              }
          }
      return {place,
              off /
                (combined * (second_order + arithmetic::same_position * size))};
    }



    /// Returns the callbacks of @p monitor for the solver of @p body.
    SolverMonitor
    of_body(const Body &body, const TangentOperator::BodyMonitor &monitor)
    {
      SolverMonitor result;
      if (monitor.assembled)
        result.assembled = [&] { monitor.assembled(body); };
      if (monitor.factor_sized)
        result.factor_sized = [&](const FactorSize &size) {
          monitor.factor_sized(body, size);
        };
      return result;
    }
  } // namespace



  // Rows that the reduction has omitted as dependent are checked, not enforced.
  TangentOperator::SupportError
  TangentOperator::largest_support_error(const LoadFactor &at) const
  {
    SupportError                             worst;
    const std::vector<PrescribedFunctional> &rows = structure.prescribed();
    for (unsigned int b = 0; b < moved_reductions.size(); ++b)
      {
        if (moved_reductions[b] == nullptr)
          continue;
        const Body       &body = *structure.bodies()[b];
        std::vector<bool> is_followed(rows.size(), false);
        for (const auto &[k, force] :
             structure.reduction(b).multipliers(Vector(body.n_dofs())))
          is_followed[k] = true;
        const SupportError here = support_error_of(
          body, b, state.block(b), rows, is_followed, at, structure.size());
        if (here.share > worst.share)
          worst = here;
      }
    return worst;
  }



  TangentOperator::TangentOperator(
    const Structure                            &structure,
    const BlockVector                          &u,
    const SolverKind                            requested,
    const BodyMonitor                          &monitor,
    const BlockVector                          &correction,
    const LoadFactor                           &factor,
    const std::vector<std::vector<SpringTerm>> &more,
    const MatrixPatterns                       &matrix_patterns)
    : TangentOperator(structure, u, factor, correction, more)
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        const Body &body = *structure.bodies()[b];
        if (monitor.begins)
          monitor.begins(body);
        try
          {
            StiffnessTerms all = terms(b);
            if (!matrix_patterns.empty())
              all.shared = matrix_patterns[b];
            solvers.push_back(body.solver_of(all,
                                             reduction(b).constraints(),
                                             requested,
                                             of_body(body, monitor)));
          }
        catch (const NotPositiveDefinite &error)
          {
            throw IllConditioned(error.what());
          }
        if (monitor.ends)
          monitor.ends(body);
      }
  }



  // Terms of internal forces, springs and follower loads in one matrix.
  StiffnessTerms
  TangentOperator::terms(const unsigned int body) const
  {
    auto springs = structure.spring_terms(body);
    if (!more.empty())
      springs.insert(springs.end(), more[body].begin(), more[body].end());
    StiffnessTerms terms =
      stiffness_terms(*structure.bodies()[body],
                      state.block(body),
                      correction.n_blocks() > 0 ? correction.block(body) :
                                                  undisplaced,
                      springs);
    terms.has_loads = structure.has_follower_loads(body);
    if (terms.has_loads)
      terms.for_each_block =
        [this, body, of_stresses = terms.for_each_block](const bool with_values,
                                                         const auto &use) {
          of_stresses(with_values, use);
          structure.for_each_block_of_loads(
            body, factor, state.block(body), with_values, use);
        };
    return terms;
  }



  // K w from the derivative of the strains at the quadrature points, which
  // keeps the digits that an assembled matrix loses for slender bodies.
  BlockVector
  TangentOperator::apply(const BlockVector &w) const
  {
    BlockVector f = structure.zero();
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        structure.bodies()[b]->add_tangent_forces(state.block(b),
                                                  w.block(b),
                                                  f.block(b));
        for (const Spring &spring : structure.springs(b))
          spring.row.add_to(f.block(b),
                            spring.stiffness * spring.row(w.block(b)));
      }
    return f;
  }



  // Solvers exist for the condensed strategy and for Newton's method.
  const LinearSolver &
  TangentOperator::solver(const unsigned int body) const
  {
    Assert(body < solvers.size(), dealii::ExcMessage("It has no solvers."));
    return *solvers[body];
  }



  // A w = -(df/du w) - (symmetric part) w of the follower loads.
  BlockVector
  TangentOperator::unsymmetric_part(const BlockVector &w) const
  {
    BlockVector f = structure.zero();
    structure.add_derivative_of_loads(factor, state, w, f);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        structure.for_each_block_of_loads(
          b, factor, state.block(b), true, [&](const StiffnessBlock &block) {
            block.add_product(w.block(b), f.block(b));
          });
        sum_over_processes(f.block(b));
      }
    f *= -1.;
    return f;
  }



  // Left-preconditioned GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7
  // (1986) 856-869) for (1 + K^-1 A) x = K^-1 r. Without convergence, the
  // solution of the symmetric part is returned.
  BlockVector
  TangentOperator::solve(BlockVector r) const
  {
    r = solve_symmetric(std::move(r));
    if (!structure.has_unsymmetric_loads())
      return r;
    struct
    {
      const TangentOperator &K;
      void
      vmult(BlockVector &to, const BlockVector &from) const
      {
        to = K.solve_symmetric(K.unsymmetric_part(from));
        to += from;
      }
    } whole{*this};
    constexpr unsigned int most = 30;
    dealii::SolverControl  control(
      most, arithmetic::rounding_of_solutions * r.l2_norm(), false, false);
    BlockVector x = r;
    try
      {
        dealii::SolverGMRES<BlockVector>(control).solve(
          whole, x, r, dealii::PreconditionIdentity());
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return r;
      }
    return x;
  }



  // u = G (G^T K G)^-1 G^T r, body by body.
  BlockVector
  TangentOperator::solve_symmetric(BlockVector r) const
  {
    condense(r);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        solver(b).solve(r.block(b));
        reduction(b).constraints().distribute(r.block(b));
      }
    return r;
  }



  // Bound of the rounding of forces for given displacements (Newton, checks).
  double
  TangentOperator::largest_stiffness(const unsigned int body) const
  {
    if (body < solvers.size())
      return solvers[body]->largest_diagonal();
    return structure.largest_stiffness(body);
  }



  // Lower bound of the largest condition number (CHOLMOD only).
  double
  TangentOperator::condition_estimate() const
  {
    double largest = 0.;
    for (const auto &one : solvers)
      largest = std::max(largest, one->condition_estimate());
    return largest;
  }



  std::shared_ptr<const TangentOperator>
  linearized(const Structure                    &structure,
             const SolverKind                    requested,
             const TangentOperator::BodyMonitor &monitor)
  {
    return std::make_shared<const TangentOperator>(structure,
                                                   structure.zero(),
                                                   requested,
                                                   monitor);
  }



  std::shared_ptr<const TangentOperator>
  linearized_without_solvers(const Structure &structure)
  {
    return std::make_shared<const TangentOperator>(structure, structure.zero());
  }
} // namespace lamella
