// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/linear/linear_solver.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace lamella
{
  using namespace dealii;

  std::string
  to_text(const SolverStatistics &statistics)
  {
    const std::string shared =
      n_processes() == 1 ?
        "" :
        " on " + std::to_string(n_processes()) + " processes";
    if (statistics.kind != SolverKind::cg)
      return (statistics.kind == SolverKind::mumps ? "MUMPS" : "CHOLMOD") +
             shared + ", factor of " + to_text(statistics.non_zeros, 3) +
             " non-zeros";
    const double n = statistics.solutions;
    return "conjugate gradients with algebraic multigrid" + shared + ", " +
           std::to_string(statistics.solutions) + " solutions" +
           (n == 0 ? "" :
                     " of " + to_text(statistics.iterations / n, 3) +
                       " iterations on average, " +
                       std::to_string(statistics.max_iterations_per_solve) +
                       " at most");
  }



  RowProducts::RowProducts(const LinearSolver &solver,
                           const DofIndex      n_dofs,
                           Solve               solve)
    : solver(solver)
    , n_dofs(n_dofs)
    , solve(std::move(solve))
  {}



  void
  RowProducts::append(const std::vector<LinearFunctional> &added)
  {
    if (added.empty())
      return;
    const unsigned int first = rows.size();
    rows.insert(rows.end(), added.begin(), added.end());
    const std::vector<double> values = solve(rows, first);
    for (unsigned int i = 0; i < added.size(); ++i)
      kept.emplace_back(values.begin() + i * rows.size(),
                        values.begin() + (i + 1) * rows.size());
  }



  std::vector<double>
  RowProducts::products(const unsigned int first) const
  {
    const std::size_t   n = size() - first;
    std::vector<double> result(n * size());
    for (unsigned int j = 0; j < size(); ++j)
      for (unsigned int i = first; i < size(); ++i)
        result[j * n + i - first] = kept[std::max(i, j)][std::min(i, j)];
    return result;
  }



  Vector
  RowProducts::displacement(const std::vector<double> &lambda) const
  {
    Vector x(n_dofs);
    for (unsigned int k = 0; k < rows.size(); ++k)
      if (lambda[k] != 0.)
        rows[k].add_to(x, lambda[k]);
    solver.solve(x);
    return x;
  }



  namespace
  {
    // Of the right-hand side. Refinement against the strain-first residual does
    // the rest, in one or two rounds; compliances are used as they come.
    constexpr double       tolerance      = 1e-11;
    constexpr unsigned int max_iterations = 2000;



    class ConjugateGradients : public LinearSolver
    {
    public:
      ConjugateGradients(std::shared_ptr<const SharedMatrix> whole,
                         const std::vector<Vector>          &near_null_space,
                         const std::string                  &what)
        : kept(std::move(whole))
        , matrix(*kept)
        , what(what)
      {
        taken.kind = SolverKind::cg;
        for (const Vector &v : near_null_space)
          for (const DofIndex i : matrix.locally_owned_range_indices())
            null_space.push_back(v[i]);
        // A process without rows still hands over an address.
        null_space.resize(std::max<std::size_t>(1, null_space.size()));

        Teuchos::ParameterList list;
        ML_Epetra::SetDefaults("SA", list);
        list.set("ML output", 0);
        list.set("aggregation: type", "Uncoupled");
        list.set("aggregation: threshold", 1e-4);
        list.set("smoother: type", "Chebyshev");
        list.set("smoother: sweeps", 3);
        list.set("coarse: type", "Amesos-KLU");
        list.set("coarse: max size", 300);
        if (!near_null_space.empty())
          {
            // Six are rigid motions: three rows of a node stay together.
            list.set("PDE equations", near_null_space.size() == 6 ? 3 : 1);
            list.set("null space: type", "pre-computed");
            list.set("null space: dimension", int(near_null_space.size()));
            list.set("null space: vectors", null_space.data());
            list.set("null space: add default vectors", false);
          }
        multigrid.initialize(matrix, list);
      }

      void
      solve(Vector &x) const override
      {
        const IndexSet owned = matrix.locally_owned_range_indices();
        SharedVector   b(owned, communicator()), y(owned, communicator());
        for (const DofIndex i : owned)
          b[i] = x[i];
        b.compress(VectorOperation::insert);
        const double size = b.l2_norm();
        ++taken.solutions;
        if (size > 0.)
          {
            SolverControl          control(max_iterations, tolerance * size);
            SolverCG<SharedVector> cg(control);
            try
              {
                cg.solve(matrix, y, b, multigrid);
              }
            catch (const SolverControl::NoConvergence &)
              {
                throw NumericsError(
                  "linear.cg-not-converged: the conjugate gradient solver for " +
                  what + " still has a relative residual of " +
                  lamella::to_text(control.last_value() / size, 2) + " after " +
                  std::to_string(control.last_step()) +
                  " iterations. Long elements and very different stiffnesses "
                  "slow it down. Write Linear solver = mumps (a direct solver), "
                  "or use elements of more equal lengths.");
              }
            taken.iterations += control.last_step();
            taken.max_iterations_per_solve =
              std::max(taken.max_iterations_per_solve, control.last_step());
          }
        x = 0.;
        for (const DofIndex i : owned)
          x[i] = y[i];
        sum_over_processes(x);
      }

      std::unique_ptr<SolvedRows>
      solved_rows() const override
      {
        return std::make_unique<RowProducts>(
          *this,
          matrix.m(),
          [this](const std::vector<LinearFunctional> &rows,
                 const unsigned int first) { return products(rows, first); });
      }

      double
      largest_diagonal() const override
      {
        double greatest = 0.;
        for (const DofIndex i : matrix.locally_owned_range_indices())
          greatest = std::max(greatest, std::abs(matrix.diag_element(i)));
        return Utilities::MPI::max(greatest, communicator());
      }

      SolverStatistics
      statistics() const override
      {
        return taken;
      }

    private:
      std::vector<double>
      products(const std::vector<LinearFunctional> &rows,
               const unsigned int                   first) const
      {
        std::vector<double> result;
        for (unsigned int i = first; i < rows.size(); ++i)
          {
            Vector x(matrix.m());
            rows[i].add_to(x, 1.);
            solve(x);
            for (const LinearFunctional &row : rows)
              result.push_back(row(x) - row.constant());
          }
        return result;
      }

      const std::shared_ptr<const SharedMatrix> kept;
      const SharedMatrix                       &matrix;
      const std::string                         what;
      /// Vectors of the near-null space, own rows only; ML refers to them.
      std::vector<double>               null_space;
      TrilinosWrappers::PreconditionAMG multigrid;
      mutable SolverStatistics          taken;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  make_conjugate_gradients(std::shared_ptr<const SharedMatrix> matrix,
                           const std::vector<Vector>          &near_null_space,
                           const std::string                  &what)
  {
    return std::make_unique<ConjugateGradients>(std::move(matrix),
                                                near_null_space,
                                                what);
  }
} // namespace lamella
