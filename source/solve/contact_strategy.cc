// SPDX-License-Identifier: LGPL-2.1-or-later

// The strategy `full`: Newton's method on displacements and forces of the whole
// scene with the penalty matrix K + K^p (Eqs. 22 and 23 of the paper), the
// semi-smooth Newton or primal-dual active set method (Hintermueller, Ito and
// Kunisch, SIAM J. Optim. 13 (2002) 865-888). The complementarity conditions
// are written as
//   lambda = max(0, lambda - rho (g + a lambda)),   rho > 0,
// with a generalized derivative of 1 on the active set, 0 elsewhere.
//
// The laws and both stages are those of solve_interface(). Each Newton step
// factorizes K + K^p with the linearized laws (SparseInterfaceSystem),
//   (K + B^T D B) du = r + B^T (lambda - lambda_state) - K du_k.
// The right-hand side is a residual at the iterate, K du from strains, so that
// rounding of the factors does not accumulate. In Newton's method for large
// rotations, which corrects rounding errors, K du is from the matrix.

#include <lamella/base/arithmetic.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/interface_solver.h>
#include <lamella/solve/interface_system.h>
#include <lamella/solve/penalty_matrix.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns the terms of B^T D B, without those of the zeros in @p D.
    template <typename PointMatrices>
    std::vector<PenaltyTerm>
    penalty_terms(const GapConstraints &rows, const PointMatrices &D)
    {
      std::vector<PenaltyTerm> terms;
      for (unsigned int r = 0; r < rows.size(); ++r)
        for (unsigned int a = 0; a <= rows[r].slips.size(); ++a)
          for (unsigned int b = 0; b <= rows[r].slips.size(); ++b)
            if (D[r][a][b] != 0.)
              terms.push_back({a == 0 ? r : rows.slip(r, a - 1),
                               b == 0 ? r : rows.slip(r, b - 1),
                               D[r][a][b]});
      return terms;
    }



    /// Adds the nodal forces B^T (@p force - those of the state of @p problem)
    /// of all constraints to @p f.
    void
    add_contact_forces(const GapConstraints &rows,
                       const ContactProblem &problem,
                       const PointVectors   &force,
                       BlockVector          &f)
    {
      const PointVectors before = problem.forces();
      for (unsigned int r = 0; r < rows.size(); ++r)
        if (const Tensor<1, 3> change = force[r] - before[r];
            change != Tensor<1, 3>())
          add_force(rows[r],
                    change[0],
                    in_scene(rows[r], Tensor<1, 2>({change[1], change[2]})),
                    f);
    }



    /// Returns the change of gap and slips of each constraint for @p du.
    PointVectors
    jumps(const GapConstraints &rows, const BlockVector &du)
    {
      PointVectors w(rows.size());
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          w[r][0] = rows[r].jump(du);
          for (unsigned int t = 0; t < rows[r].slips.size(); ++t)
            w[r][1 + t] = rows[r].slips[t].jump(du);
        }
      return w;
    }



    /// Equilibrium of the bodies by the sparse matrix K + K^p, K^p = B^T D B,
    /// of all DoFs, for many contact points. Keeps references to all arguments.
    /// Collective.
    class SparseInterfaceSystem : public InterfaceSystem
    {
    public:
      /// Creates the system for the increments of @p problem; @p matrix has the
      /// stiffness of @p tangent_operator.
      SparseInterfaceSystem(const TangentOperator     &tangent_operator,
                            const GapConstraints      &rows,
                            const NumericalCompliance &compliance,
                            const ContactProblem      &problem,
                            PenaltyMatrix             &matrix)
        : tangent_operator(tangent_operator)
        , rows(rows)
        , compliance(compliance)
        , problem(problem)
        , matrix(matrix)
        , du(tangent_operator.of().zero())
        , K_du(du)
      {}

      /// Returns the contact points of the constraints.
      InterfacePoints
      points() const
      {
        // Bodies are softer in bending than at a point, by the square of the
        // slenderness. Stacks of EBBT need stiffer springs at the start.
        constexpr double slender = 1e-4, spring = 1e-3;
        InterfacePoints  points;
        points.about  = problem.forces();
        points.closed = problem.closed;
        for (unsigned int r = 0; r < rows.size(); ++r)
          {
            const double proximal = compliance.proximal(rows[r]),
                         local    = 1. / (matrix.local_compliance(r) +
                                       compliance(rows, r)),
                         soft     = slender * local;
            points.n_slips.push_back(rows[r].slips.size());
            points.law.push_back(law_of(rows[r]));
            points.compliance.emplace_back();
            for (unsigned int c = 0; c < 3; ++c)
              points.compliance[r][c] =
                proximal + law_compliance(rows[r], c > 0);
            points.stiffness.push_back({{soft, soft}});
            points.spring.push_back(spring * local);
            Tensor<1, 3> estimate;
            estimate[0] = problem.estimate[r];
            for (unsigned int t = 0; t < rows[r].slips.size(); ++t)
              estimate[1 + t] = problem.shear[r][t];
            points.shift.push_back(proximal * estimate);
          }
        return points;
      }

      void
      factorize(const PointStiffness &D) override
      {
        if (!symmetric)
          symmetric = std::make_unique<PenaltyMatrix>(tangent_operator,
                                                      rows,
                                                      Symmetry::definite);
        symmetric->factorize(penalty_terms(rows, D));
      }

      PointVectors
      solve(const PointVectors &force) override
      {
        BlockVector f = problem.residual.size() > 0 ?
                          problem.residual :
                          tangent_operator.of().zero();
        f -= K_du;
        add_contact_forces(rows, problem, force, f);
        step = (symmetric ? *symmetric : matrix).solve(std::move(f));
        return jumps(rows, step);
      }

      // dlambda = A^-1 (r - B dv), so D = A^-1 B.
      InterfaceStep
      solve(const std::vector<LinearizedLaw> &laws,
            const PointVectors               &force) override
      {
        symmetric.reset();
        std::vector<Tensor<2, 3>> D;
        InterfaceStep             result;
        result.force = force;
        for (unsigned int r = 0; r < rows.size(); ++r)
          {
            const Tensor<2, 3> inverse = invert(laws[r].A);
            D.push_back(inverse * laws[r].B);
            result.force[r] += inverse * laws[r].residual;
          }
        matrix.factorize(penalty_terms(rows, D));
        result.change = solve(result.force);
        for (unsigned int r = 0; r < rows.size(); ++r)
          result.force[r] -= D[r] * result.change[r];
        result.sign      = matrix.sign_of_determinant();
        result.is_solved = true;
        return result;
      }

      bool
      move_to(const PointVectors &force) override
      {
        du   = 0.;
        K_du = 0.;
        if (force == problem.forces())
          return problem.residual.size() == 0;
        matrix.factorize({});
        solve(force);
        advance(1.);
        return true;
      }

      void
      advance(const double t) override
      {
        du.add(t, step);
        K_du = tangent_operator.applies_terms() ? tangent_operator.apply(du) :
                                                  matrix.apply(du);
      }

      PointVectors
      lengths() const override
      {
        PointVectors v = jumps(rows, du);
        for (unsigned int r = 0; r < rows.size(); ++r)
          {
            v[r][0] += problem.gap[r];
            for (unsigned int t = 0; t < rows[r].slips.size(); ++t)
              v[r][1 + t] += problem.slip[r][t];
          }
        return v;
      }

      /// Returns the displacement increment of the iterate.
      const BlockVector &
      displacement() const
      {
        return du;
      }

    private:
      const TangentOperator     &tangent_operator;
      const GapConstraints      &rows;
      const NumericalCompliance &compliance;
      const ContactProblem      &problem;
      PenaltyMatrix             &matrix;
      /// Symmetric matrix of factorize(); released by the next linearized laws.
      std::unique_ptr<PenaltyMatrix> symmetric;
      BlockVector                    du; ///< Displacement increment.
      BlockVector K_du; ///< Forces K du, computed from strains.
      BlockVector step; ///< Change of du by the last solution.
    };



    /// Returns the solution of @p problem with the forces @p found and the
    /// displacement increment @p du.
    ContactSolution
    solution_of(const ContactProblem    &problem,
                const GapConstraints    &rows,
                const InterfaceSolution &found,
                const BlockVector       &du)
    {
      const PointVectors before = problem.forces();
      ContactSolution    result;
      std::vector<bool>  moved(du.n_blocks(), problem.residual.size() > 0);
      result.force.assign(rows.size(), 0.);
      result.shear.assign(rows.size(), {});
      result.direction.assign(rows.size(), {});
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          result.store(r, rows[r].is_tied(), found.states[r], found.force[r]);
          if (found.force[r] != before[r])
            for (const BodyFunctional &part : rows[r].parts)
              moved[part.body] = true;
        }
      result.is_unstable = found.stability < 0;
      result.du          = du;
      // Bodies without a change of forces have only rounding in du.
      for (unsigned int b = 0; b < moved.size(); ++b)
        if (!moved[b])
          result.du.block(b) = 0.;
      return result;
    }



    /// Newton's method on the displacements u and contact forces lambda of the
    /// whole scene, a semi-smooth Newton method (solve_interface()) whose steps
    /// factorize the matrix of the whole scene (PenaltyMatrix). Without
    /// friction a constraint with the lengths v, the gap and all compliances
    /// included, is active if lambda - D v > 0, and the Newton step is
    ///   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
    ///   dlambda      = (r_lambda - B_A du) / d
    /// with the tangent stiffness K, gradients B_A of active gaps, numerical
    /// compliance d, unbalanced forces r_u, and r_lambda = -v.
    class FullStrategy : public ContactStrategy
    {
    public:
      /// Assembles the stiffness of @p tangent_operator, which needs no linear
      /// solvers, for the contact constraints @p rows.
      FullStrategy(const TangentOperator &tangent_operator,
                   const GapConstraints  &rows)
        : ContactStrategy(tangent_operator, rows)
        , matrix(tangent_operator,
                 rows,
                 rows.has_friction() ? Symmetry::none : Symmetry::definite)
      {}

      // Newton's method from the forces of the previous load step; without
      // them, or if it does not converge soon, from the result of the interior
      // point.
      ContactSolution
      solve(const ContactProblem &problem, const Monitor &monitor) override
      {
        PointVectors start(rows.size());
        if (!problem.first_forces.empty())
          start = problem.first_forces;
        else
          for (const unsigned int r : problem.start)
            start[r][0] = problem.estimate[r];
        InterfaceRules rules;
        rules.tolerance        = arithmetic::rounding_of_solutions;
        rules.extra_iterations = 0;
        if (largest_component(start) == 0.)
          rules.first_iterations =
            problem.residual.size() > 0 ||
                rows.with_ties({}).size() == rows.size() ?
              1 :
              0;

        SparseInterfaceSystem system(
          tangent_operator, rows, numerical_compliance, problem, matrix);
        const InterfaceSolution found =
          solve_interface(system, system.points(), start, monitor, rules);
        check_law(found, rows.has_friction());
        if (!(found.error < rules.tolerance))
          system.move_to(found.force);
        ContactSolution solution =
          solution_of(problem, rows, found, system.displacement());
        ++solution.solved_by[static_cast<unsigned int>(found.by)];
        return solution;
      }

      /// Solves one linear Newton system with the active constraints @p closed,
      /// for unbalanced forces @p r_u and gap residuals @p r_lambda.
      // (K + K^p) du = r_u + B^T D^-1 r_lambda, dlambda = D^-1 (r_lambda - B
      // du), with D = diag(d) and, for slipping rows, the term mu e B_t^T D^-1
      // B_n.
      void
      solve(const ActiveConstraints &closed,
            const BlockVector       &r_u,
            const Vector            &r_lambda,
            BlockVector             &du,
            Vector                  &dlambda) override
      {
        const std::vector<unsigned int> &numbers = closed.numbers;
        const auto compliance = [&](const unsigned int number) {
          return numerical_compliance(rows, number);
        };
        std::vector<PenaltyTerm> terms;
        for (const unsigned int number : numbers)
          terms.push_back({number, number, 1. / compliance(number)});
        for (const auto &[r, along] : closed.sliding)
          for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
            terms.push_back({rows.slip(r, a), r, along[a] / compliance(r)});
        matrix.factorize(terms);

        du = r_u;
        std::vector<double> pushed(rows.size(), 0.);
        for (unsigned int k = 0; k < numbers.size(); ++k)
          {
            const double force = r_lambda[k] / compliance(numbers[k]);
            rows.constraint(numbers[k]).add_to(du, force);
            if (numbers[k] < rows.size())
              pushed[numbers[k]] = force;
          }
        for (const auto &[r, along] : closed.sliding)
          add_force(rows[r], 0., in_scene(rows[r], pushed[r] * along), du);
        du = matrix.solve(std::move(du));
        dlambda.reinit(numbers.size());
        for (unsigned int k = 0; k < numbers.size(); ++k)
          dlambda[k] = (r_lambda[k] - rows.constraint(numbers[k]).jump(du)) /
                       compliance(numbers[k]);
      }

      /// Returns the penalty factor, and the constraints in the matrix pattern.
      StrategyHistory
      memory() const override
      {
        return {numerical_compliance.stiffening, {matrix.known_rows()}};
      }

      void
      restore(const StrategyHistory &memory) override
      {
        numerical_compliance.stiffening = memory.stiffening;
        for (const std::vector<unsigned int> &known : memory.rows)
          matrix.restore(known);
      }

      bool
      forces_are_accurate() const override
      {
        return false;
      }

      std::string
      remedy() const override
      {
        return rows.has_friction() ? "the condensed strategy" :
                                     "a softer penalty, the condensed strategy";
      }

      /// Returns a warning if a large penalty causes rounding errors.
      std::vector<std::string>
      warnings() const override
      {
        return matrix.warnings();
      }

    private:
      PenaltyMatrix matrix;
    };
  } // namespace



  ContactStrategy::~ContactStrategy() = default;



  Strategy
  choose_strategy(const Strategy   which,
                  const Structure &structure,
                  const double     n)
  {
    if (which != Strategy::automatic)
      return which;
    // Up to here a factor of the compliance takes less than a second.
    constexpr double few_operations = 1e9;

    double of_bodies = 0.;
    for (const auto &body : structure.bodies())
      of_bodies +=
        std::pow(body->stiffness_entries(), 2) / double(body->n_dofs());
    return std::pow(n, 3) / 3. > std::max(of_bodies, few_operations) ?
             Strategy::full :
             Strategy::condensed;
  }



  Strategy
  choose_strategy(const Strategy        which,
                  const Structure      &structure,
                  const GapConstraints &rows)
  {
    double n = 0.;
    for (const GapConstraint &row : rows)
      if (!row.slips.empty() && row.initial_gap <= 0.)
        n += 1. + row.slips.size();
    return choose_strategy(which, structure, n);
  }



  std::unique_ptr<ContactStrategy>
  make_strategy(const Strategy         which,
                const TangentOperator &tangent_operator,
                const GapConstraints  &rows)
  {
    if (which == Strategy::full)
      return std::make_unique<FullStrategy>(tangent_operator, rows);
    return make_condensed_strategy(tangent_operator, rows);
  }
} // namespace lamella
