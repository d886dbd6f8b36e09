// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_newton_h
#define lamella_solve_contact_newton_h

#include <lamella/solve/coulomb.h>
#include <lamella/solve/penalty_matrix.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Newton's method with Coulomb friction on the displacements and contact
  /// forces of the whole scene for the `full` strategy. For the gap g, the slip
  /// s in the load step, the force lambda and its estimate lambda_bar, the
  /// law_compliance() a and the numerical compliance d of a constraint, let
  ///   v = (g, s) + a lambda + (d - a) (lambda - lambda_bar).
  /// Newton's method solves equilibrium and lambda = P(lambda - rho v), with
  /// the projection P onto the friction cone and a parameter rho (Alart and
  /// Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375). With the
  /// trial force z = lambda - rho v, the unit vector e along z_t, b = mu max(0,
  /// z_n) and k = b / |z_t|, a constraint is in one of three states:
  ///   open    where z_n <= 0:     lambda = 0;
  ///   sticks  where |z_t| <= b:   v = 0, K^p = (B_n^T B_n + B_t^T B_t) / d;
  ///   slips   otherwise:          v_n = 0, lambda_t = mu lambda_n along e,
  ///           -w s across e with w = k rho / (1 - k + k rho d), and K^p =
  ///     B_n^T B_n / d + (mu / d) B_e^T B_n + w B_x^T B_x,
  /// where K^p is the contribution of the constraint to the stiffness, with the
  /// rows B_n of the gap, B_t of the slips, B_e along e and B_x across it.
  /// After the first eight steps, every fourth is shortened by a line search.
  /// The tangential rho is b / |v_t|. Keeps references to all arguments.
  class ContactNewton
  {
  public:
    /// Keeps references to all arguments, which must outlive this object.
    ContactNewton(const TangentOperator     &tangent_operator,
                  const GapConstraints      &rows,
                  const NumericalCompliance &compliance,
                  PenaltyMatrix             &matrix)
      : tangent_operator(tangent_operator)
      , rows(rows)
      , compliance(compliance)
      , matrix(matrix)
    {}

    /// Iterate of Newton's method, relative to the state of the problem.
    struct Iterate
    {
      BlockVector  du;     ///< Displacement increment.
      BlockVector  K_du;   ///< Forces K du, computed from strains.
      PointVectors force;  ///< Total force of each constraint as (n, t_1, t_2).
      double       change; ///< Largest change of du in the last step.
    };

    /// Returns the iterate with the forces `first_forces` of @p problem;
    /// without friction, with the estimates of its initial active set.
    Iterate
    begin(const ContactProblem &problem);

    /// Solves @p problem from the iterate @p at; returns nothing after @p
    /// max_steps factorizations. Throws NumericsError for a negative
    /// determinant (unstable solution).
    std::optional<ContactSolution>
    solve(const ContactProblem &problem,
          Iterate               at,
          const Monitor        &monitor,
          const unsigned int    max_steps);

  private:
    /// Gaps and slips v and trial forces z (ContactNewton) of all constraints.
    struct Trial
    {
      PointVectors v, z;
      /// Friction limit mu max(0, z_n), and tangential rho [force / length].
      std::vector<double>     bound, rho;
      std::vector<PointState> states;
    };

    /// Linearized contact law: the forces after a displacement increment are
    /// lambda + change - sum of weight times gap or slip increment.
    struct Law
    {
      PointVectors             change;
      std::vector<PenaltyTerm> terms;
    };

    /// Values below which quantities are rounding: `closed` for gaps of open
    /// constraints, `slip_rounding` for gaps and slips of closed ones, `small`
    /// for forces. rho is that of normals, and of tangents if same_rho is true.
    struct Scales
    {
      double closed = 0., slip_rounding = 0., small = 0., rho = 0.;
      bool   same_rho = false;
    };

    Scales
    scales(const ContactProblem &problem, const Iterate &at) const;
    Trial
    trial(const ContactProblem &problem,
          const Iterate        &at,
          const Scales         &scale) const;
    /// Adds the linearized law of constraint @p r, which is not open, to
    /// @p law.
    void
    linearize(const unsigned int r,
              const Iterate     &at,
              const Trial       &trial,
              Law               &law) const;
    /// Adds the linearized tangential law of a slipping constraint @p r.
    void
    linearize_slip(const unsigned int r,
                   const Iterate     &at,
                   const Trial       &trial,
                   Law               &law) const;
    Iterate
    step(const ContactProblem &problem, const Iterate &at, const Trial &trial);
    /// Returns the residual lambda - P(lambda - rho v) of a constraint.
    static dealii::Tensor<1, 3>
    missed(const unsigned int r, const Iterate &at, const Trial &trial);
    /// Line search: returns the iterate between @p from and @p to with the
    /// smallest residual |lambda - P(lambda - rho v)|.
    Iterate
    shortened(const ContactProblem &problem,
              const Iterate        &from,
              Iterate               to) const;
    Round
    violating_rows(const Iterate &at,
                   const Trial   &trial,
                   const Scales  &scale) const;
    ContactSolution
    solution(const ContactProblem &problem,
             Iterate               at,
             const Trial          &trial) const;

    const TangentOperator     &tangent_operator;
    const GapConstraints       rows;
    const NumericalCompliance &compliance;
    PenaltyMatrix             &matrix;
  };
} // namespace lamella

#endif
