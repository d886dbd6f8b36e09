// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/linear/factorization.h>
#include <lamella/linear/linear_solver.h>

#include <dmumps_c.h>

#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Rows @p begin to @p end as sparse right-hand sides, counted from 1.
    struct SparseColumns
    {
      std::vector<int>    starts{1}, dofs;
      std::vector<double> weights;

      SparseColumns(const std::vector<LinearFunctional> &rows,
                    const unsigned int                   begin,
                    const unsigned int                   end)
      {
        for (unsigned int k = begin; k < end; ++k)
          {
            for (const auto &[dof, weight] : rows[k].entries())
              {
                dofs.push_back(dof + 1);
                weights.push_back(weight);
              }
            starts.push_back(dofs.size() + 1);
          }
      }
    };



    /// The workspace of MUMPS and the factor, both freed with the object.
    class MumpsFactorization : public LinearSolver
    {
    public:
      /// Analyses the places of @p matrix. Makes it ready for factorize().
      MumpsFactorization(const DofIndex     n,
                         MatrixEntries      all,
                         const Symmetry     symmetry,
                         const std::string &what)
        : matrix(std::move(all))
        , what(what)
      {
        initialize(symmetry);
        mumps.n       = n;
        mumps.nnz_loc = matrix.rows.size();
        mumps.irn_loc = matrix.rows.data();
        mumps.jcn_loc = matrix.columns.data();
        mumps.a_loc   = matrix.values.data();
        try
          {
            analyze();
          }
        catch (...)
          {
            run(-2);
            throw;
          }
      }

      MumpsFactorization(const MumpsFactorization &) = delete;
      ~MumpsFactorization() override
      {
        run(-2);
      }

      /// What the factor will take.
      FactorSize
      size() const
      {
        return {count(20), 1e6 * mumps.info[15 - 1]};
      }

      /// Factorizes the values in `matrix`, with more workspace if requested.
      void
      factorize()
      {
        // What is needed is not known exactly beforehand.
        constexpr int workspace_too_small_1 = -8, workspace_too_small_2 = -9,
                      most_percent = 1000;
        // It has no opinion on what is no number.
        const bool finite =
          std::all_of(matrix.values.begin(),
                      matrix.values.end(),
                      [](const double x) { return std::isfinite(x); });
        if (Utilities::MPI::min(int(finite), communicator()) == 0)
          throw NumericsError("linear.not-finite: The stiffness matrix of " +
                              what +
                              " has entries that are infinite or no numbers. "
                              "Check the lengths and materials of the scene.");
        greatest = 0.;
        for (std::size_t k = 0; k < matrix.values.size(); ++k)
          if (matrix.rows[k] == matrix.columns[k])
            greatest = std::max(greatest, std::abs(matrix.values[k]));
        greatest    = Utilities::MPI::max(greatest, communicator());
        mumps.a_loc = matrix.values.data();
        run(2);
        while ((info(1) == workspace_too_small_1 ||
                info(1) == workspace_too_small_2) &&
               control(14) < most_percent)
          {
            control(14) *= 2;
            run(2);
          }
        check(what);
      }

      /// Solving takes the factor alone.
      void
      drop_matrix()
      {
        matrix        = MatrixEntries();
        mumps.nnz_loc = 0;
        mumps.irn_loc = nullptr;
        mumps.jcn_loc = nullptr;
        mumps.a_loc   = nullptr;
      }

      /// The values in their places.
      std::vector<double> &
      values()
      {
        return matrix.values;
      }

      void
      solve(Vector &x) const override
      {
        control(20) = 0; // the whole right-hand side on the first process,
        control(21) = 0; // and so the solution
        mumps.nrhs  = 1;
        mumps.lrhs  = mumps.n;
        mumps.rhs   = is_root_process() ? x.begin() : nullptr;
        run(3);
        check("the matrix, to solve with its factor");
        ++n_solutions;
        if (n_processes() > 1)
          MPI_Bcast(x.begin(), x.size(), MPI_DOUBLE, 0, communicator());
      }

      /// As in RepeatedFactorization; MUMPS has a mantissa beside an exponent.
      int
      sign_of_determinant() const
      {
        return mumps.sym == definite || mumps.rinfog[12 - 1] >= 0. ? 1 : -1;
      }

      std::unique_ptr<SolvedRows>
      solved_rows() const override
      {
        return std::make_unique<RowProducts>(
          *this, mumps.n, [this](const auto &rows, const unsigned int first) {
            return products(rows, first);
          });
      }

      double
      largest_diagonal() const override
      {
        return greatest;
      }

      SolverStatistics
      statistics() const override
      {
        return {SolverKind::mumps, count(29), n_solutions};
      }

    private:
      /// What MUMPS calls them.
      static constexpr int unsymmetric = 0, definite = 1;

      void
      initialize(const Symmetry symmetry)
      {
        mumps.comm_fortran = MPI_Comm_c2f(communicator());
        mumps.par          = 1; // the first process computes, too
        mumps.sym = symmetry == Symmetry::definite ? definite : unsymmetric;
        run(-1);
        for (const unsigned int stream : {1, 2, 3, 4})
          control(stream) = 0;
        control(18) = 3; // each process has entries of its own
        control(14) = 40;
        control(33) = symmetry == Symmetry::definite ? 0 : 1; // the determinant
      }

      /// Runs @p job of MUMPS.
      void
      run(const int job) const
      {
        mumps.job = job;
        dmumps_c(&mumps);
      }

      /// MUMPS counts its arrays from 1, and so does its manual.
      int &
      control(const unsigned int i) const
      {
        return mumps.icntl[i - 1];
      }
      int
      info(const unsigned int i) const
      {
        return mumps.infog[i - 1];
      }

      /// A count of its global information: a negative one is in millions.
      double
      count(const unsigned int i) const
      {
        return info(i) < 0 ? -1e6 * info(i) : info(i);
      }

      /// The symbolic analysis.
      void
      analyze()
      {
        // CHOLMOD's rule: minimum degree is fast and good for beams, whose
        // matrices have long rows and little fill (nested dissection takes
        // longer than the factorization); for much fill, nested dissection is
        // better.
        constexpr int minimum_degree = 0, nested_dissection = 5;
        control(7) = minimum_degree;
        run(1);
        check(what);
        const double entries    = Utilities::MPI::sum(double(mumps.nnz_loc),
                                                   communicator()),
                     operations = mumps.rinfog[0];
        if (count(20) > 5. * entries && operations > 500. * count(20))
          {
            control(7) = nested_dissection;
            run(1);
            check(what);
          }
      }

      /// Throws NumericsError if the last job failed.
      void
      check(const std::string &what) const
      {
        constexpr int singular = -10, not_positive = -40, no_memory = -13;
        // Of an unsymmetric matrix it counts there what it exchanged.
        const int error           = info(1),
                  negative_pivots = mumps.sym == definite ? info(12) : 0;
        if (error == no_memory)
          throw NumericsError("linear.out-of-memory: The factorization of " +
                              what +
                              " does not fit in memory. Use a coarser mesh, a "
                              "theory of lower order, or more machines.");
        const bool factorized = mumps.job == 2;
        if (error == singular && mumps.sym == unsymmetric)
          throw NumericsError(
            "linear.singular-matrix: The tangent stiffness matrix of " + what +
            " is numerically singular. Check supports and loads.");
        if (error == singular || error == not_positive ||
            (factorized && error >= 0 && negative_pivots > 0))
          throw NotPositiveDefinite(
            "linear.not-positive-definite: The stiffness matrix of " + what +
              " is not positive definite (" +
              (error < 0 ? std::string("singular to rounding") :
                           std::to_string(negative_pivots) +
                             " negative pivots of " + std::to_string(mumps.n)) +
              "). Either a rigid-body motion is free (add a Support), or the body "
              "is too slender or too heterogeneous for double precision.",
            numbers::invalid_dof_index);
        if (error < 0)
          throw NumericsError(
            "linear.mumps-failed: the solver MUMPS could not factorize " +
            what + " (MUMPS error " + std::to_string(error) + ", " +
            std::to_string(info(2)) + "; see the MUMPS manual).");
      }

      /// As RowProducts asks for.
      std::vector<double>
      products(const std::vector<LinearFunctional> &rows,
               const unsigned int                   first) const
      {
        // Enough at a time for the BLAS, at most 200 MB of solutions per
        // process.
        const unsigned int at_once =
          std::min(128., std::max(16., 25e6 * n_processes() / mumps.n));
        std::vector<double> result((rows.size() - first) * rows.size());
        for (unsigned int begin = first; begin < rows.size(); begin += at_once)
          add_products(rows,
                       begin,
                       std::min<unsigned int>(begin + at_once, rows.size()),
                       result.data() + (begin - first) * rows.size());
        if (n_processes() > 1)
          Utilities::MPI::sum(result, communicator(), result);
        return result;
      }

      /// Solves for @p rows from @p begin to @p end and adds this process's
      /// share of their products with all rows to @p result.
      void
      add_products(const std::vector<LinearFunctional> &rows,
                   const unsigned int                   begin,
                   const unsigned int                   end,
                   double *const                        result) const
      {
        SparseColumns columns(rows, begin, end);
        mumps.rhs    = nullptr;
        mumps.nrhs   = end - begin;
        mumps.nz_rhs = columns.dofs.size();
        // Only the first process may point to them.
        mumps.irhs_ptr    = is_root_process() ? columns.starts.data() : nullptr;
        mumps.irhs_sparse = is_root_process() ? columns.dofs.data() : nullptr;
        mumps.rhs_sparse = is_root_process() ? columns.weights.data() : nullptr;

        const int           n_local = mumps.info[23 - 1];
        std::vector<int>    local_dofs(std::max(1, n_local));
        std::vector<double> x(local_dofs.size() * mumps.nrhs);
        mumps.lsol_loc = local_dofs.size();
        mumps.isol_loc = local_dofs.data();
        mumps.sol_loc  = x.data();
        control(20)    = 3; // sparse right-hand sides, which saves work,
        control(21)    = 1; // solutions where they come about
        run(3);
        check("the matrix, to solve with its factor");
        n_solutions += mumps.nrhs;

        std::vector<int> place(mumps.n, -1);
        for (int i = 0; i < n_local; ++i)
          place[local_dofs[i] - 1] = i;
        for (unsigned int j = 0; j < rows.size(); ++j)
          for (const auto &[dof, weight] : rows[j].entries())
            if (place[dof] >= 0)
              for (int k = 0; k < mumps.nrhs; ++k)
                result[k * rows.size() + j] +=
                  weight * x[std::size_t(k) * mumps.lsol_loc + place[dof]];
      }

      /// MUMPS refers to it while it factorizes.
      MatrixEntries     matrix;
      const std::string what;
      double            greatest = 0.;
      // MUMPS writes into its workspace while solving.
      mutable DMUMPS_STRUC_C mumps{};
      mutable unsigned int   n_solutions = 0;
    };



    class RepeatedMumps : public RepeatedFactorization
    {
    public:
      RepeatedMumps(const DofIndex     n,
                    MatrixEntries      pattern,
                    const Symmetry     symmetry,
                    const std::string &what)
        : solver(n, std::move(pattern), symmetry, what)
      {}

      void
      factorize(std::vector<double> values) override
      {
        AssertDimension(values.size(), solver.values().size());
        solver.values() = std::move(values);
        solver.factorize();
      }

      void
      solve(Vector &x) const override
      {
        solver.solve(x);
      }

      int
      sign_of_determinant() const override
      {
        return solver.sign_of_determinant();
      }

    private:
      MumpsFactorization solver;
    };
  } // namespace



  std::unique_ptr<RepeatedFactorization>
  analyze_shared(const DofIndex     n,
                 MatrixEntries      pattern,
                 const Symmetry     symmetry,
                 const std::string &what)
  {
    return std::make_unique<RepeatedMumps>(n,
                                           std::move(pattern),
                                           symmetry,
                                           what);
  }



  std::unique_ptr<LinearSolver>
  factorize_shared(const DofIndex       n,
                   UpperTriangle        matrix,
                   const std::string   &what,
                   const FactorMonitor &monitor)
  {
    auto solver = std::make_unique<MumpsFactorization>(n,
                                                       std::move(matrix),
                                                       Symmetry::definite,
                                                       what);
    if (monitor)
      monitor(solver->size());
    solver->factorize();
    solver->drop_matrix();
    return solver;
  }
} // namespace lamella
