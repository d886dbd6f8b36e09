// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/friction_state.h>
#include <lamella/solve/sparse_interface_system.h>

// Newton step of the bodies with all contact forces eliminated:
//   (K + B^T D B) du = r + B^T (lambda - lambda_state) - K du_k.
// The right-hand side is a residual at the iterate, K du from strains, so that
// rounding of the factors does not accumulate. In Newton's method for large
// rotations, which corrects rounding errors, K du is from the matrix.
namespace lamella
{
  using namespace dealii;

  namespace
  {
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
  } // namespace



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



  SparseInterfaceSystem::SparseInterfaceSystem(
    const TangentOperator     &tangent_operator,
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



  InterfacePoints
  SparseInterfaceSystem::points() const
  {
    // Bodies are softer in bending than at a point, by the square of the
    // slenderness. Stacks of EBBT need stiffer springs at the start.
    constexpr double slender = 1e-4, spring = 1e-3;
    InterfacePoints  points;
    points.about  = problem.forces();
    points.closed = problem.closed;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double d        = compliance(rows[r]),
                     proximal = d - law_compliance(rows[r]),
                     local    = 1. / (matrix.local_compliance(r) + d),
                     soft     = slender * local;
        points.n_slips.push_back(rows[r].slips.size());
        points.law.push_back(law_of(rows[r]));
        points.compliance.push_back(d);
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
  } // namespace



  void
  SparseInterfaceSystem::factorize(const PointStiffness &D)
  {
    if (!symmetric)
      symmetric = std::make_unique<PenaltyMatrix>(tangent_operator,
                                                  rows,
                                                  Symmetry::definite);
    symmetric->factorize(penalty_terms(rows, D));
  }



  // dlambda = A^-1 (r - B dv), so D = A^-1 B.
  InterfaceStep
  SparseInterfaceSystem::solve(const std::vector<LinearizedLaw> &laws,
                               const PointVectors               &force)
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
  SparseInterfaceSystem::move_to(const PointVectors &force)
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



  PointVectors
  SparseInterfaceSystem::solve(const PointVectors &force)
  {
    BlockVector f = problem.residual.size() > 0 ? problem.residual :
                                                  tangent_operator.of().zero();
    f -= K_du;
    add_contact_forces(rows, problem, force, f);
    step = (symmetric ? *symmetric : matrix).solve(std::move(f));
    return jumps(rows, step);
  }



  void
  SparseInterfaceSystem::advance(const double t)
  {
    du.add(t, step);
    K_du = tangent_operator.applies_terms() ? tangent_operator.apply(du) :
                                              matrix.apply(du);
  }



  PointVectors
  SparseInterfaceSystem::lengths() const
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
} // namespace lamella
