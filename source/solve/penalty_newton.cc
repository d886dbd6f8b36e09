// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/linear/own_rows.h>
#include <lamella/solve/penalty_newton.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lamella
{
  using namespace dealii;

  PenaltyNewton::PenaltyNewton(std::shared_ptr<const Linearisation> about,
                               const GapRows                       &rows,
                               const SolverParameters              &parameters)
    : ContactSolver(std::move(about), rows, parameters)
  {
    assemble_stiffness();
  }



  PenaltyNewton::PenaltyNewton(const Structure        &structure,
                               const GapRows          &rows,
                               const SolverParameters &parameters)
    : PenaltyNewton(std::make_shared<const Linearisation>(structure,
                                                          structure.zero()),
                    rows,
                    parameters)
  {}



  // ---- Newton's method

  State
  PenaltyNewton::solve_contact(const State &free,
                               const double factor,
                               const State &previous)
  {
    // Relative to the displacements: what the law is fulfilled to, and what is
    // good enough where rounding allows no more.
    constexpr double accurate = 1e-12, acceptable = 1e-10;

    // Rows that would be open without any contact start open: in unloading they
    // pull, and pull others in.
    State                     state   = free;
    const std::vector<double> without = overlaps(free, factor);
    for (const unsigned int r : previous.active)
      if (without[r] > 0.)
        {
          state.active.push_back(r);
          state.force[r] = previous.force[r];
        }
    state.active = next_set(state, without, 0.);
    if (state.active.empty())
      return state;

    std::set<std::vector<unsigned int>> visited;
    double before     = std::numeric_limits<double>::max();
    State  before_set = state;
    while (true)
      {
        // The whole step on a set, for lowest_point(): corrections follow it.
        if (state.contact_corrections.empty())
          before_set = state;
        state.contact_corrections.push_back(correct(state, factor));

        const double size = size_of(state, factor);
        const double closed =
          size *
          std::max(1e-14, std::min(1e-10, state.contact_corrections.back()));
        const std::vector<double> overlap = overlaps(state, factor);
        const Round               round   = wrong_rows(state, overlap, closed);
        if (state.contact_corrections.size() == 1)
          watch(round, state.iterations);
        if (!round.changed.empty())
          {
            // Also where a set looks right until it is refined.
            check_iterations(state.iterations, round.changed);
            if (visited.insert(state.active).second)
              state.active = next_set(state, overlap, closed);
            else
              state = lowest_point(before_set, state, factor);
            for (unsigned int r = 0; r < rows.size(); ++r)
              if (!std::binary_search(state.active.begin(),
                                      state.active.end(),
                                      r))
                state.force[r] = 0.;
            state.contact_corrections.clear();
            continue;
          }
        if (!is_refined(state.contact_corrections, 1))
          continue;

        const double error = law_error(state, factor);
        const bool   slow  = error > 0.1 * before;
        if (error <= accurate * size || (slow && error <= acceptable * size))
          return state;
        if (slow)
          softness.stiffen();
        before = error;
        check_iterations(++state.iterations, {});
        state.contact_corrections.clear();
      }
  }



  std::vector<double>
  PenaltyNewton::overlaps(const State &state, const double factor) const
  {
    std::vector<double> overlap;
    for (unsigned int r = 0; r < rows.size(); ++r)
      overlap.push_back((softness(rows[r]) - law_softness(rows[r])) *
                          state.force[r] -
                        rows[r].gap(state.u, factor));
    return overlap;
  }



  bool
  PenaltyNewton::stays(const State &state, const unsigned int row) const
  {
    // Its own unknown tells the sign of the force to rounding; the gap of a
    // hard row, of which the law makes the same force, does not.
    return std::binary_search(state.active.begin(), state.active.end(), row) &&
           state.force[row] >= 0.;
  }



  Round
  PenaltyNewton::wrong_rows(const State               &state,
                            const std::vector<double> &overlap,
                            const double               closed) const
  {
    Round round{state.active.size(), {}, 0.};
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const bool is_active =
          std::binary_search(state.active.begin(), state.active.end(), r);
        if (is_active ? !stays(state, r) : overlap[r] > closed)
          {
            round.changed.push_back(r);
            round.violation = std::max(round.violation, std::abs(overlap[r]));
          }
      }
    return round;
  }



  std::vector<unsigned int>
  PenaltyNewton::next_set(const State               &state,
                          const std::vector<double> &overlap,
                          const double               closed) const
  {
    // The worst penetrations first settles soonest where few rows of many stay
    // active.
    constexpr std::size_t                        few = 8;
    std::vector<unsigned int>                    next;
    std::vector<std::pair<double, unsigned int>> closing;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (stays(state, r))
        next.push_back(r);
      else if (overlap[r] > closed &&
               !std::binary_search(state.active.begin(), state.active.end(), r))
        closing.emplace_back(overlap[r], r);
    std::sort(closing.rbegin(), closing.rend());
    closing.resize(
      std::min(closing.size(), std::max(few, state.active.size())));
    for (const auto &[over, r] : closing)
      next.push_back(r);
    std::sort(next.begin(), next.end());
    return next;
  }



  double
  PenaltyNewton::law_error(const State &state, const double factor) const
  {
    double error = 0.;
    for (const unsigned int r : state.active)
      error = std::max(error,
                       std::abs(rows[r].gap(state.u, factor) +
                                law_softness(rows[r]) * state.force[r]));
    return error;
  }



  State
  PenaltyNewton::part_of_the_way(const State       &from,
                                 const BlockVector &du,
                                 const double       t,
                                 const double       factor) const
  {
    State at = from;
    at.u.add(t, du);
    const std::vector<double> overlap = overlaps(at, factor);
    at.active.clear();
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        at.force[r] = std::max(0., overlap[r]) / softness(rows[r]);
        if (overlap[r] > 0.)
          at.active.push_back(r);
      }
    return at;
  }



  State
  PenaltyNewton::lowest_point(const State &from,
                              const State &to,
                              const double factor) const
  {
    constexpr unsigned int enough    = 40;
    constexpr double       good_rest = 1e-2;

    BlockVector du = to.u;
    du -= from.u;
    // What is out of balance does this work on the way, per unit of it: less
    // and less, and zero where the way leads no further down.
    const auto work = [&](const double t) {
      const State at = part_of_the_way(from, du, t, factor);
      BlockVector r  = structure.residual(at.u, factor, at.rest);
      for (const unsigned int k : at.active)
        rows[k].add_to(r, at.force[k]);
      return r * du;
    };
    double       low = 0., high = 1., t = 1.;
    const double at_start = work(0.);
    for (unsigned int k = 0; k < enough; ++k)
      {
        const double w = work(t);
        if (std::abs(w) <= good_rest * std::abs(at_start) ||
            (t == 1. && w > 0.))
          break;
        (w > 0. ? low : high) = t;
        t                     = 0.5 * (low + high);
      }
    State at      = part_of_the_way(from, du, t, factor);
    at.iterations = to.iterations;
    return at;
  }



  // ---- K + K^p

  Constraints
  PenaltyNewton::constraints_of_all() const
  {
    const auto &blocks = structure.load().get_block_indices();
    Constraints all;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      for (const auto &line : structure.reduction(b).constraints().get_lines())
        {
          const DofIndex dof = blocks.local_to_global(b, line.index);
          all.add_line(dof);
          for (const auto &[other, weight] : line.entries)
            all.add_entry(dof, blocks.local_to_global(b, other), weight);
        }
    all.close();
    return all;
  }



  namespace
  {
    using Dofs = std::vector<DofIndex>;

    /// Calls @p use(rows, columns, values) with block after block of the
    /// stiffness of all bodies and their springs, this process's share, in the
    /// numbering of the scene.
    template <typename Use>
    void
    for_each_block(const Linearisation &linearisation,
                   const bool           with_values,
                   const Use           &use)
    {
      const Structure &structure = linearisation.of();
      const auto      &blocks    = structure.load().get_block_indices();
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          const auto global = [&](Dofs dofs) {
            for (DofIndex &dof : dofs)
              dof = blocks.local_to_global(b, dof);
            return dofs;
          };
          const StiffnessTerms terms = linearisation.terms(b);
          terms.for_each_block(with_values, [&](const StiffnessBlock &block) {
            use(global(block.rows), global(block.columns), block.values);
          });
          // All processes know all springs.
          if (is_speaker())
            for (const auto &[row, stiffness] : terms.springs)
              {
                Dofs                dofs;
                std::vector<double> values;
                for (const auto &[dof, weight] : row.entries())
                  {
                    dofs.push_back(dof);
                    for (const auto &[other, other_weight] : row.entries())
                      values.push_back(stiffness * weight * other_weight);
                  }
                use(global(dofs), global(dofs), values);
              }
        }
    }



    /// The DoFs and weights of a gap row in the numbering of the scene.
    Row
    global_row(const Structure &structure, const GapRow &row)
    {
      const auto &blocks = structure.load().get_block_indices();
      Row         result;
      for (const BodyRow &part : row.parts)
        for (const auto &[dof, weight] : part.row.entries())
          result.add(blocks.local_to_global(part.body, dof), weight);
      result.compress();
      return result;
    }



    Dofs
    dofs_of(const Row &row)
    {
      Dofs dofs;
      for (const auto &[dof, weight] : row.entries())
        dofs.push_back(dof);
      return dofs;
    }
  } // namespace



  namespace
  {
    /// The DoFs that remain of @p dofs, flagged in @p written.
    void
    add_free(const Constraints &constraints,
             const Dofs        &dofs,
             std::vector<bool> &written)
    {
      for (const DofIndex dof : dofs)
        if (!constraints.is_constrained(dof))
          written[dof] = true;
        else
          for (const auto &[other, weight] :
               *constraints.get_constraint_entries(dof))
            written[other] = true;
    }



    /// Those of @p owned, and those that are flagged.
    IndexSet
    united(const IndexSet &owned, const std::vector<bool> &written)
    {
      Dofs others;
      for (DofIndex i = 0; i < written.size(); ++i)
        if (written[i] && !owned.is_element(i))
          others.push_back(i);
      IndexSet result = owned;
      result.add_indices(others.begin(), others.end());
      result.compress();
      return result;
    }
  } // namespace



  void
  PenaltyNewton::assemble_stiffness()
  {
    const DofIndex n        = structure.n_dofs();
    constraints             = constraints_of_all();
    owned                   = IndexSet(n);
    const std::uint64_t all = n;
    owned.add_range(all * this_process() / n_processes(),
                    all * (this_process() + 1) / n_processes());

    std::vector<bool> written(n, false);
    for_each_block(*linearisation,
                   false,
                   [&](const Dofs &rows, auto &&, auto &&) {
                     add_free(constraints, rows, written);
                   });
    DynamicSparsityPattern pattern(n, n, united(owned, written));
    for_each_block(*linearisation,
                   false,
                   [&](const Dofs &rows, const Dofs &columns, auto &&) {
                     constraints.add_entries_local_to_global(rows,
                                                             columns,
                                                             pattern,
                                                             false);
                   });
    for (const DofIndex i : owned)
      pattern.add(i, i);
    stiffness.reinit(owned, owned, pattern, communicator(), true);

    for_each_block(
      *linearisation,
      true,
      [&](const Dofs &rows, const Dofs &columns, const auto &values) {
        constraints.distribute_local_to_global(
          FullMatrix<double>(rows.size(), columns.size(), values.data()),
          rows,
          columns,
          stiffness);
      });
    stiffness.compress(VectorOperation::add);

    // Constrained DoFs get what others have at most.
    double greatest = 0.;
    for (const DofIndex i : owned)
      greatest = std::max(greatest, std::abs(stiffness.diag_element(i)));
    greatest = Utilities::MPI::max(greatest, communicator());
    diagonal.reinit(n);
    for (const DofIndex i : owned)
      {
        if (constraints.is_constrained(i))
          stiffness.set(i, i, greatest > 0. ? greatest : 1.);
        diagonal[i] =
          constraints.is_constrained(i) ? greatest : stiffness.diag_element(i);
      }
    stiffness.compress(VectorOperation::insert);
    sum_over_processes(diagonal);
  }



  void
  PenaltyNewton::make_room(const std::vector<unsigned int> &active)
  {
    const std::size_t before = known.size();
    known.insert(active.begin(), active.end());
    if (factor != nullptr && known.size() == before)
      return;
    std::vector<bool> written(structure.n_dofs(), false);
    std::vector<Dofs> dofs;
    if (is_speaker())
      for (const unsigned int r : known)
        {
          dofs.push_back(dofs_of(global_row(structure, rows[r])));
          add_free(constraints, dofs.back(), written);
        }
    DynamicSparsityPattern pattern(structure.n_dofs(),
                                   structure.n_dofs(),
                                   united(owned, written));
    for_each_own_row(stiffness,
                     [&](const DofIndex      row,
                         const Dofs         &columns,
                         const double *const values) {
                       Dofs places;
                       for (unsigned int k = 0; k < columns.size(); ++k)
                         if (values[k] != 0.)
                           places.push_back(columns[k]);
                       pattern.add_entries(row, places.begin(), places.end());
                     });
    for (const Dofs &of_row : dofs)
      constraints.add_entries_local_to_global(of_row, of_row, pattern, false);
    system.reinit(owned, owned, pattern, communicator(), true);
    factor.reset();
  }



  void
  PenaltyNewton::add_penalty(const GapRow &row, const double softness_of_row)
  {
    // k^p = eps n^T n (Eq. 23), with the row in place of n.
    const Row          whole = global_row(structure, row);
    const Dofs         dofs  = dofs_of(whole);
    FullMatrix<double> term(dofs.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      for (unsigned int j = 0; j < dofs.size(); ++j)
        term(i, j) = whole.entries()[i].second * whole.entries()[j].second /
                     softness_of_row;
    constraints.distribute_local_to_global(term, dofs, dofs, system);
  }



  UpperTriangle
  PenaltyNewton::upper_triangle() const
  {
    UpperTriangle entries;
    for_each_own_row(system,
                     [&](const DofIndex      row,
                         const Dofs         &columns,
                         const double *const values) {
                       for (unsigned int k = 0; k < columns.size(); ++k)
                         if (columns[k] >= row)
                           {
                             entries.rows.push_back(row + 1);
                             entries.columns.push_back(columns[k] + 1);
                             entries.values.push_back(values[k]);
                           }
                     });
    return entries;
  }



  void
  PenaltyNewton::factorise(const std::vector<unsigned int> &active)
  {
    if (is_factorised && factorised_for == active &&
        factorised_with == softness.stiffening)
      return;
    make_room(active);
    system = 0.;
    for_each_own_row(
      stiffness,
      [&](const DofIndex row, const Dofs &columns, const double *const values) {
        system.add(row, columns.size(), columns.data(), values, true);
      });
    if (is_speaker())
      for (const unsigned int r : active)
        add_penalty(rows[r], softness(rows[r]));
    system.compress(VectorOperation::add);

    UpperTriangle entries = upper_triangle();
    is_factorised         = false;
    if (factor == nullptr)
      factor = analyse_shared(structure.n_dofs(),
                              entries,
                              "the scene with its penalties");
    factor->factorise(std::move(entries.values));
    factorised_for  = active;
    factorised_with = softness.stiffening;
    is_factorised   = true;
    measure_hardness(active);
  }



  void
  PenaltyNewton::solve_linear(const std::vector<unsigned int> &active,
                              const BlockVector               &r_u,
                              const Vector                    &r_lambda,
                              BlockVector                     &du,
                              Vector                          &dlambda)
  {
    factorise(active);
    du = r_u;
    for (unsigned int k = 0; k < active.size(); ++k)
      rows[active[k]].add_to(du, r_lambda[k] / softness(rows[active[k]]));
    structure.condense(du);

    Vector x(du.size());
    std::copy(du.begin(), du.end(), x.begin());
    factor->solve(x);
    constraints.distribute(x);
    std::copy(x.begin(), x.end(), du.begin());

    dlambda.reinit(active.size());
    for (unsigned int k = 0; k < active.size(); ++k)
      dlambda[k] =
        (r_lambda[k] - rows[active[k]].opening(du)) / softness(rows[active[k]]);
  }



  // ---- what the arithmetic holds

  void
  PenaltyNewton::measure_hardness(const std::vector<unsigned int> &active)
  {
    for (const unsigned int r : active)
      {
        double    soft = 0.;
        const Row free = global_row(structure, rows[r]).reduced(constraints);
        for (const auto &[dof, weight] : free.entries())
          soft += weight * weight / diagonal[dof];
        const double penalty = 1. / softness(rows[r]);
        if (soft * penalty > hardest)
          {
            hardest         = soft * penalty;
            hardest_penalty = penalty;
          }
      }
  }



  std::vector<std::string>
  PenaltyNewton::warnings() const
  {
    // Rounding leaves an error of about N t eps / k (Nour-Omid and Wriggers,
    // 1987), least together with the penalty's own k / eps at k / sqrt(N t).
    const double t = std::numeric_limits<double>::epsilon(),
                 n = structure.n_dofs(), rounding = n * t * hardest;
    if (rounding < 1e-4)
      return {};
    return {"the penalty " + to_text(hardest_penalty, 3) + " is " +
            to_text(hardest, 2) +
            " times the stiffness of the DoFs it acts on; in K + K^p of " +
            std::to_string(structure.n_dofs()) +
            " DoFs double precision holds about " +
            to_text(hardest_penalty / hardest / std::sqrt(n * t), 2) +
            " best, and what was found may be off by " + to_text(rounding, 1) +
            ": take a softer Penalty or the condensed strategy"};
  }
} // namespace lamella
