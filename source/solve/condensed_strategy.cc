// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/linear/dense_factors.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/dense_interface_system.h>
#include <lamella/solve/interface_solver.h>

#include <algorithm>
#include <optional>
#include <set>

// Static condensation of the bodies onto the contact forces, a dual active-set
// method. Row generation in solve(), round by round:
// 1. solve the contact problem of the working set on its
//    compliance C = B K^-1 B^T;
// 2. evaluate all gaps g = g_state + B du;
// 3. add the deepest penetrations outside the set, remove idle rows;
// until no gap outside the set is closed. This is the cutting-plane view of the
// quadratic program min 1/2 lambda^T C lambda + g^T lambda, lambda >= 0.
//
// With the compliance, a displacement of a body needs one back substitution per
// round; costs per round are n^3 / 3 for n working rows.
namespace lamella
{
  using dealii::Tensor;

  namespace
  {
    // Lower bounds of d: over the row's compliance, and over 1 / penalty for a
    // row between supported points, which has no compliance.
    constexpr double smallest_compliance = 1e-10, smallest_of_given = 1e-8;
    // Least number of rows that join per round.
    constexpr std::size_t first_rows = 8;
    // Numbers of rows, and of idle rows per active one, that are kept.
    constexpr std::size_t few_rows = 64, idle_for_each = 3;



    bool
    are_idle(const std::size_t n_rows, const std::size_t n_active)
    {
      return n_rows > few_rows && n_rows > (1 + idle_for_each) * n_active;
    }



    /// Penetrations and indices of constraints, the deepest penetration first.
    using Violations = std::vector<std::pair<double, unsigned int>>;



    /// The rows with gaps @p g below @p limit that are not among @p part.
    /// Deepest penetration first, so that few rows join per round.
    Violations
    rows_below(const double                     limit,
               const std::vector<unsigned int> &part,
               const std::vector<double>       &g)
    {
      Violations found;
      for (unsigned int r = 0; r < g.size(); ++r)
        if (g[r] < limit && !std::binary_search(part.begin(), part.end(), r))
          found.emplace_back(-g[r], r);
      std::sort(found.rbegin(), found.rend());
      return found;
    }



    Round
    round_of(const ContactSolution &solution, const Violations &wrong)
    {
      Round round{solution.active.size(),
                  {},
                  wrong.empty() ? 0. : wrong.front().first};
      for (const auto &[violation, r] : wrong)
        round.changed.push_back(r);
      return round;
    }



    /// Contact solver by static condensation onto the contact forces, the dual
    /// form of the problem. The stiffness K is factorized once per body.
    /// Contact is solved with the compliance C (Compliance) of a working set of
    /// constraints. A linear system with active constraints is solved in three
    /// steps: a solution with K, a small dense system
    ///   (C + d) dlambda = r_lambda - B K^-1 r_u,
    /// and one backward substitution K^-1 B^T dlambda, with constraint rows B
    /// and the residuals r_u of equilibrium and r_lambda of the contact law.
    /// The penalty enters as a compliance d, so a hard penalty loses no digits.
    ///
    /// The active set is found by constraint generation. Each round solves the
    /// contact problem of the working set exactly (solve_interface(),
    /// solve_coulomb()) and evaluates the gaps of all other constraints.
    /// Constraints that penetrate most are added: at most eight, or as many as
    /// the set has if it has more. Constraints without penalty whose gap closes
    /// without a force are added once, at the end. If most of the working set
    /// is open, open constraints are removed, each at most once. Dependent
    /// constraints (more contact points than surface DoFs) share the force as
    /// in the least-squares solution.
    class CondensedStrategy : public ContactStrategy
    {
    public:
      /// Keeps references; @p tangent_operator must have factorizations.
      CondensedStrategy(const TangentOperator &tangent_operator,
                        const GapConstraints  &rows)
        : ContactStrategy(tangent_operator, rows)
        , compliance(tangent_operator, rows)
      {}

      /// Finds the active set and the increment of @p problem. Also throws the
      /// exceptions of check_law().
      ContactSolution
      solve(const ContactProblem &problem, const Monitor &monitor) override
      {
        if (problem.residual.size() > 0)
          return solve_balanced(problem, monitor);
        ContactSolution solution;
        solution.du     = tangent_operator.of().zero();
        solution.force  = problem.force;
        solution.active = problem.start;
        solution.shear  = problem.shear;

        std::vector<unsigned int> part = initial_working_set(problem);
        Violations joining = rows_below(-problem.closed, part, problem.gap);
        if (part.empty() && joining.empty())
          return solution;
        joining.resize(std::min(joining.size(), first_rows));

        // Cutting planes (Kelley, J. SIAM 8 (1960) 703-712): the most violated
        // rows join, at most as many as the set has (or first_rows). Rows that
        // close because others have closed join once at the end.
        std::set<unsigned int> left;
        bool                   all_interactions = false;
        while (true)
          {
            for (const auto &[violation, r] : joining)
              for (std::vector<unsigned int> *set : {&part, &solution.active})
                set->insert(std::upper_bound(set->begin(), set->end(), r), r);
            compliance.include(with_slips(part));
            solve_working_set(problem, part, solution);

            std::vector<double> g = problem.gap;
            for (unsigned int r = 0; r < rows.size(); ++r)
              g[r] += rows[r].jump(solution.du);
            joining = rows_below(-problem.closed, part, g);
            monitor(round_of(solution, joining));
            if (joining.empty() && !all_interactions &&
                !solution.active.empty())
              {
                joining          = touching_rows(problem, part, g);
                all_interactions = true;
              }
            else
              joining.resize(
                std::min(joining.size(), std::max(first_rows, part.size())));
            if (joining.empty())
              break;
            remove_idle_rows(problem, solution, part, left);
          }
        return solution;
      }

      // Block elimination of the saddle point problem (Eq. 22):
      //   u_0 = K^-1 r_u,  (R K^-1 C + d) dlambda = r_lambda - R u_0,
      //   du = u_0 + K^-1 C dlambda.
      void
      solve(const ActiveConstraints &closed,
            const BlockVector       &r_u,
            const Vector            &r_lambda,
            BlockVector             &du,
            Vector                  &dlambda) override
      {
        const std::vector<unsigned int> &numbers = closed.numbers;
        du                                       = tangent_operator.solve(r_u);
        dlambda.reinit(numbers.size());
        if (numbers.empty())
          return;

        std::vector<double> lambda(numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
          lambda[i] = r_lambda[i] - rows.constraint(numbers[i]).jump(du);
        solve_on_active_set(closed, lambda);
        std::copy(lambda.begin(), lambda.end(), dlambda.begin());
        std::vector<unsigned int> of = numbers;
        for (const auto &[row, along] : closed.sliding)
          {
            const std::size_t k =
              std::find(numbers.begin(), numbers.end(), row) - numbers.begin();
            for (unsigned int a = 0; a < rows[row].slips.size(); ++a)
              {
                of.push_back(rows.slip(row, a));
                lambda.push_back(along[a] * dlambda[k]);
              }
          }
        du += compliance.displacement(of, lambda);
      }

      /// Returns the penalty factor and the indices of all constraints in the
      /// compliance, which a restarted run needs.
      StrategyHistory
      memory() const override
      {
        return {numerical_compliance.stiffening, compliance.row_groups()};
      }

      /// Restores the penalty factor and the compliance from @p memory.
      // The same groups of rows reproduce the compliance bit for bit.
      void
      restore(const StrategyHistory &memory) override
      {
        numerical_compliance.stiffening = memory.stiffening;
        for (const std::vector<unsigned int> &batch : memory.rows)
          compliance.include(batch);
      }

      bool
      forces_are_accurate() const override
      {
        return true;
      }

      std::string
      remedy() const override
      {
        return "a softer penalty";
      }

    private:
      /// Returns the solution of @p problem, which has a residual.
      // The problem about the displacements that balance the residual.
      ContactSolution
      solve_balanced(ContactProblem problem, const Monitor &monitor)
      {
        const BlockVector du = tangent_operator.solve(problem.residual);
        problem.residual.reinit(0);
        for (unsigned int r = 0; r < rows.size(); ++r)
          {
            problem.gap[r] += rows[r].jump(du);
            for (unsigned int t = 0; t < rows[r].slips.size(); ++t)
              problem.slip[r][t] += rows[r].slips[t].jump(du);
          }
        ContactSolution solution = solve(problem, monitor);
        solution.du += du;
        return solution;
      }

      /// Returns the regularization d of gap or slip @p number [length /
      /// force]: NumericalCompliance, or 1e-8 of it for the method `exact`; at
      /// least 1e-10 of the diagonal entry of C, so that C + d is positive
      /// definite.
      // d is at least a share of the row's compliance, so C + d is definite.
      double
      compliance_of_law(const unsigned int number) const
      {
        const GapConstraint &row   = rows[rows.row_of(number)];
        const double         given = numerical_compliance(rows, number),
                     least         = std::max(smallest_compliance *
                                        compliance.diagonal(number),
                                      smallest_of_given * given);
        if (row.is_tied())
          return law_compliance(rows, number) + least;
        return row.enforcement == Enforcement::exact ? least :
                                                       std::max(given, least);
      }

      /// Returns the gaps @p part, each followed by the indices of its slips.
      // Numbers of gaps and slips of a working set, point by point.
      std::vector<unsigned int>
      with_slips(const std::vector<unsigned int> &part) const
      {
        std::vector<unsigned int> numbers;
        for (const unsigned int r : part)
          {
            numbers.push_back(r);
            for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
              numbers.push_back(rows.slip(r, a));
          }
        return numbers;
      }

      /// Returns the matrix R K^-1 F + d of the active constraints @p closed,
      /// column by column, with rows R, and nodal forces F due to unit contact
      /// forces.
      // Column j of R K^-1 C + d: the compliance of row j, for a slipping row
      // that of B_n^T + mu e_a B_t,a^T, since its shear force follows its
      // normal force. Slip makes it nonsymmetric, as Coulomb's slip rule is
      // nonassociated (Wriggers, Computational Contact Mechanics, Springer
      // 2006).
      std::vector<double>
      contact_system(const ActiveConstraints &closed)
      {
        const std::vector<unsigned int> &numbers = closed.numbers;
        const std::size_t                n       = numbers.size();
        std::vector<unsigned int>        all     = numbers;
        for (const auto &[row, along] : closed.sliding)
          for (unsigned int a = 0; a < rows[row].slips.size(); ++a)
            all.push_back(rows.slip(row, a));
        compliance.include(all);
        const std::vector<double> C = compliance.among(all);
        std::vector<double>       system(n * n);
        for (std::size_t j = 0; j < n; ++j)
          std::copy_n(C.begin() + j * all.size(), n, system.begin() + j * n);
        std::size_t slip = n;
        for (const auto &[row, along] : closed.sliding)
          {
            const std::size_t j =
              std::find(numbers.begin(), numbers.end(), row) - numbers.begin();
            for (unsigned int a = 0; a < rows[row].slips.size(); ++a, ++slip)
              for (std::size_t i = 0; i < n; ++i)
                system[j * n + i] += along[a] * C[slip * all.size() + i];
          }
        for (std::size_t i = 0; i < n; ++i)
          system[i * n + i] += compliance_of_law(numbers[i]);
        return system;
      }

      /// Replaces @p lambda by the solution of contact_system() with the
      /// right-hand side @p lambda. The Cholesky factor is kept if no point
      /// slips. Throws NumericsError if the matrix is singular.
      // Cholesky factor of C + d without slip (symmetric), else LU with rank
      // detection. The factor is kept while active set and d stay.
      void
      solve_on_active_set(const ActiveConstraints &closed,
                          std::vector<double>     &lambda)
      {
        const std::size_t n = closed.numbers.size();
        if (!closed.sliding.empty())
          {
            // Dependent rows may share a force in any way, with different shear
            // forces: the null space of the system must not amplify rounding.
            constexpr double          dependent = 10. * smallest_compliance;
            std::vector<double>       sizes;
            const std::vector<double> system = contact_system(closed);
            for (const unsigned int number : closed.numbers)
              sizes.push_back(compliance.diagonal(number) +
                              compliance_of_law(number));
            lambda = solve_dependent(system, sizes, lambda, dependent);
            return;
          }
        compliance.include(closed.numbers);
        std::vector<double> d;
        for (const unsigned int number : closed.numbers)
          d.push_back(compliance_of_law(number));
        if (!factor || factorized_for != closed.numbers || factorized_with != d)
          {
            factor.emplace(contact_system(closed),
                           n,
                           "The compliance of contact");
            factorized_for  = closed.numbers;
            factorized_with = d;
          }
        factor->solve(lambda);
      }

      /// Returns the initial working set: constraints that are active or have a
      /// force, and those with known compliance unless most would be open.
      // Warm start: previously active rows, and the rows already included if
      // most of them would not be idle.
      std::vector<unsigned int>
      initial_working_set(const ContactProblem &problem) const
      {
        std::set<unsigned int> part(problem.start.begin(), problem.start.end());
        for (unsigned int r = 0; r < rows.size(); ++r)
          if (problem.force[r] != 0. || problem.estimate[r] != 0. ||
              (!problem.first_forces.empty() &&
               problem.first_forces[r][0] != 0.))
            part.insert(r);
        if (part.empty() &&
            rows_below(-problem.closed, {}, problem.gap).empty())
          return {};
        std::vector<unsigned int> known;
        for (unsigned int r = 0; r < rows.size(); ++r)
          if (compliance.is_included(r))
            known.push_back(r);
        if (!are_idle(known.size(), part.size()))
          part.insert(known.begin(), known.end());
        return {part.begin(), part.end()};
      }

      /// Returns the constraints without penalty, outside @p part, whose gaps
      /// @p g are below a hundred times ContactProblem::closed.
      // Rows of multipliers that close without force share that of dependent
      // rows.
      Violations
      touching_rows(const ContactProblem            &problem,
                    const std::vector<unsigned int> &part,
                    const std::vector<double>       &g) const
      {
        constexpr double closed_by_others = 100.;
        Violations       touching =
          rows_below(closed_by_others * problem.closed, part, g);
        touching.erase(std::remove_if(touching.begin(),
                                      touching.end(),
                                      [this](const auto &found) {
                                        return law_compliance(
                                                 rows[found.second]) > 0.;
                                      }),
                       touching.end());
        return touching;
      }

      /// Solves @p problem on the constraints @p part (ascending), starting
      /// from their active set in @p solution. Other constraints keep their
      /// forces. Sets du, the forces of @p part and the active set of @p
      /// solution. With friction, there is no numerical compliance.
      // The laws are solved on the compliance of all points of the working set;
      // du then follows from the change of all normal and shear forces.
      void
      solve_working_set(const ContactProblem            &problem,
                        const std::vector<unsigned int> &part,
                        ContactSolution                 &solution)
      {
        const bool          has_friction = !problem.slip.empty();
        std::vector<double> before;
        PointVectors        start;
        for (const unsigned int r : part)
          {
            before.push_back(problem.force[r]);
            for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
              before.push_back(problem.shear[r][a]);
            Tensor<1, 3> force;
            force[0] = solution.force[r];
            start.push_back(has_friction ? problem.first_forces[r] : force);
          }
        const CoulombProblem    small = coulomb_problem(problem, part, before);
        const InterfaceSolution found =
          has_friction ? solve_coulomb(small, start) :
                         frictionless(problem, part, small, start);
        check_law(found, has_friction);

        ++solution.solved_by[static_cast<unsigned int>(found.by)];
        solution.is_unstable = found.stability < 0;
        solution.active.clear();
        if (has_friction)
          solution.direction.assign(rows.size(), {});
        for (std::size_t i = 0; i < part.size(); ++i)
          solution.store(part[i],
                         rows[part[i]].is_tied(),
                         found.states[i],
                         found.force[i]);
        std::vector<double> change = small.compliance.by_rows(found.force);
        for (std::size_t k = 0; k < change.size(); ++k)
          change[k] -= before[k];
        solution.du = compliance.displacement(with_slips(part), change);
      }

      /// Returns the solution of @p small, the problem of the frictionless
      /// constraints @p part, with the numerical compliance d, from the forces
      /// @p start.
      // Proximal point about lambda_bar with the metric d - a (Rockafellar,
      // 1976):
      //   s = g_state + C (lambda - lambda_state) + a lambda +
      //       (d - a) (lambda - lambda_bar).
      InterfaceSolution
      frictionless(const ContactProblem            &problem,
                   const std::vector<unsigned int> &part,
                   const CoulombProblem            &small,
                   const PointVectors              &start) const
      {
        DenseInterfaceSystem system(small.compliance, small.q, small.about);
        InterfacePoints      points = system.points(small.law);
        for (std::size_t i = 0; i < part.size(); ++i)
          {
            points.compliance[i][0] =
              compliance_of_law(part[i]) - law_compliance(rows[part[i]]);
            points.shift[i][0] =
              points.compliance[i][0] * problem.estimate[part[i]];
          }
        points.closed = problem.closed;
        return solve_interface(system, points, start, {});
      }

      /// Returns the problem of the constraints @p part, with gaps and slips at
      /// the contact forces @p forces.
      // Velocities of all points under the forces of the state, by components.
      CoulombProblem
      coulomb_problem(const ContactProblem            &problem,
                      const std::vector<unsigned int> &part,
                      const std::vector<double>       &forces) const
      {
        // v = [g_state; s_state - s_0] + C (lambda - lambda_state) + a lambda
        // = q + W (lambda - lambda_state), with W = C + a and
        // q = [g_state; s_state - s_0] + a lambda_state.
        CoulombProblem                  small;
        PointCompliance                &W       = small.compliance;
        const std::vector<unsigned int> numbers = with_slips(part);
        for (const unsigned int r : part)
          {
            W.first.push_back(W.first.back() + 1 + rows[r].slips.size());
            small.law.push_back(law_of(rows[r]));
          }
        W.matrix    = compliance.among(numbers);
        small.about = W.by_points(forces);
        for (std::size_t i = 0; i < part.size(); ++i)
          {
            small.q.emplace_back();
            for (unsigned int k = W.first[i]; k < W.first[i + 1]; ++k)
              {
                const unsigned int c = k - W.first[i];
                const double       a = law_compliance(rows, numbers[k]);
                small.q[i][c]        = a * small.about[i][c];
                W(k, k) += a;
              }
            small.q[i][0] += problem.gap[part[i]];
            for (unsigned int t = 0; t < rows[part[i]].slips.size(); ++t)
              small.q[i][1 + t] += problem.slip[part[i]][t];
          }
        return small;
      }

      /// Moves open constraints from @p part to @p left if most of @p part are
      /// open; those already in @p left stay, since none is removed twice.
      // Each row is removed at most once, which ensures termination.
      void
      remove_idle_rows(const ContactProblem      &problem,
                       const ContactSolution     &solution,
                       std::vector<unsigned int> &part,
                       std::set<unsigned int>    &left) const
      {
        if (!are_idle(part.size(), solution.active.size()))
          return;
        const auto leaves = [&](const unsigned int r) {
          // A row with a force in the state changes du when it opens, so it
          // stays.
          return !rows[r].is_tied() && solution.force[r] == 0. &&
                 problem.force[r] == 0. && problem.estimate[r] == 0. &&
                 left.insert(r).second;
        };
        part.erase(std::remove_if(part.begin(), part.end(), leaves),
                   part.end());
      }

      /// Compliance of all constraints that were ever in the working set.
      Compliance compliance;
      /// Last Cholesky factor of C + d, its constraints, and their d.
      std::optional<DenseCholesky> factor;
      std::vector<unsigned int>    factorized_for;
      std::vector<double>          factorized_with;
    };
  } // namespace



  std::unique_ptr<ContactStrategy>
  make_condensed_strategy(const TangentOperator &tangent_operator,
                          const GapConstraints  &rows)
  {
    return std::make_unique<CondensedStrategy>(tangent_operator, rows);
  }
} // namespace lamella
