// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/friction_state.h>
#include <lamella/solve/sparse_interface_system.h>

// Newton step of the bodies with all contact forces eliminated:
//   (K + B^T D B) du = B^T (lambda - lambda_state) - K du_k.
// The right-hand side is a residual at the iterate, K du from strains, so that
// rounding of the factors does not accumulate.
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



  PointVectors
  proximal_lengths(const GapConstraints      &rows,
                   const NumericalCompliance &compliance,
                   const ContactProblem      &problem,
                   const BlockVector         &du)
  {
    PointVectors v = jumps(rows, du);
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double proximal = compliance(rows[r]) - law_compliance(rows[r]);
        v[r][0] += problem.gap[r] - proximal * problem.estimate[r];
        for (unsigned int t = 0; t < rows[r].slips.size(); ++t)
          v[r][1 + t] += problem.slip[r][t] - proximal * problem.shear[r][t];
      }
    return v;
  }



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
    const ContactProblem      &problem)
    : du(tangent_operator.of().zero())
    , K_du(du)
    , tangent_operator(tangent_operator)
    , rows(rows)
    , compliance(compliance)
    , problem(problem)
    , matrix(tangent_operator, rows, Symmetry::definite)
  {}



  InterfacePoints
  SparseInterfaceSystem::points() const
  {
    // Bodies are softer in bending than at a point, by the square of the
    // slenderness.
    constexpr double soft = 1e-4;
    InterfacePoints  points;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        points.n_slips.push_back(rows[r].slips.size());
        points.friction.push_back(rows[r].friction);
        points.compliance.push_back(compliance(rows[r]));
        points.spring.push_back(
          soft / (matrix.local_compliance(r) + points.compliance.back()));
      }
    return points;
  }



  void
  SparseInterfaceSystem::factorize(const PointStiffness &D)
  {
    std::vector<PenaltyTerm> terms;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        terms.push_back({r, r, D[r][0][0]});
        for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
          for (unsigned int b = 0; b < rows[r].slips.size(); ++b)
            if (const double stiffness = D[r][1 + a][1 + b]; stiffness != 0.)
              terms.push_back({rows.slip(r, a), rows.slip(r, b), stiffness});
      }
    matrix.factorize(terms);
  }



  PointVectors
  SparseInterfaceSystem::solve(const PointVectors &force)
  {
    BlockVector f = tangent_operator.of().zero();
    f -= K_du;
    add_contact_forces(rows, problem, force, f);
    step = matrix.solve(std::move(f));
    return jumps(rows, step);
  }



  void
  SparseInterfaceSystem::advance(const double t)
  {
    du.add(t, step);
    K_du = tangent_operator.apply(du);
  }



  PointVectors
  SparseInterfaceSystem::lengths() const
  {
    return proximal_lengths(rows, compliance, problem, du);
  }
} // namespace lamella
