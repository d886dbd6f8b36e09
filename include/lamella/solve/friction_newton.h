// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_newton_h
#define lamella_solve_friction_newton_h

#include <lamella/solve/coulomb.h>
#include <lamella/solve/penalty_matrix.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// Newton's method with Coulomb friction on the displacements and contact
  /// forces of the whole scene for the `full` strategy. For each constraint,
  /// with the gap g, the slip s - s_0 in the load step, the force lambda and
  /// its estimate lambda_bar, the compliance a of the contact law and the
  /// numerical compliance d, let
  ///   v = (g, s - s_0) + a lambda + (d - a) (lambda - lambda_bar),
  /// The method is that of Alart and Curnier (Comput. Methods Appl. Mech. Eng.
  /// 92 (1991) 353-375) for equilibrium and lambda = P(lambda - rho v), with
  /// the projection P onto the friction cone and a parameter rho. With the
  /// trial force z = lambda - rho v, its tangential direction e, b = mu max(0,
  /// z_n) and k = b / |z_t|, a constraint is in one of three states:
  ///   open    where z_n <= 0:     lambda = 0;
  ///   sticks  where |z_t| <= b:   v = 0, in K^p (B_n^T B_n + B_t^T B_t) / d;
  ///   slips   otherwise:          v_n = 0, lambda_t along e mu lambda_n, and
  ///                               across it w (-s), w = k rho / (1 - k + k rho
  ///                               d):
  ///     B_n^T B_n / d + (mu / d) B_e^T B_n + w B_x^T B_x,
  /// where the last line is the contribution of a slip to the stiffness, with
  /// the rows B_n of the gap, B_t of the slips, B_e along e and B_x across it.
  /// After some steps, every fourth step is shortened if that reduces |lambda -
  /// P(lambda - rho v)|. The tangential rho is b / |v_t| for a slip v_t. Keeps
  /// references to all arguments.
  class FrictionNewton
  {
  public:
    FrictionNewton(const TangentOperator     &tangent_operator,
                   const GapConstraints      &rows,
                   const NumericalCompliance &compliance,
                   PenaltyMatrix             &matrix)
      : tangent_operator(tangent_operator)
      , rows(rows)
      , compliance(compliance)
      , matrix(matrix)
    {}

    /// Solves a problem with slips as ContactStrategy::solve() does. Throws
    /// NumericsError for a negative determinant (unstable solution).
    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor);

  private:
    /// An iterate of Newton's method, relative to the state of the problem.
    struct Iterate
    {
      /// Displacement increment du, and K du computed from strains.
      BlockVector du, K_du;
      /// Total force of each constraint as (n, t_1, t_2).
      PointVectors force;
      /// Largest change of du in the last step.
      double change;
    };

    /// Trial values v and z (class documentation) of all constraints.
    struct Trial
    {
      PointVectors v, z;
      /// Friction bound mu max(0, z_n), and rho for tangents [force / length].
      std::vector<double>     bound, rho;
      std::vector<PointState> states;
    };

    /// Linearized contact law: the forces after the displacement increment du
    /// are lambda + change - sum of weight B_on du over all terms.
    struct Law
    {
      PointVectors             change;
      std::vector<PenaltyTerm> terms;
    };

    /// Values below which quantities are rounding: `closed` for gaps of open
    /// constraints, `slip_rounding` for gaps and slips of closed ones, `small`
    /// for forces. rho for normals; also for tangents if same_rho.
    struct Scales
    {
      double closed = 0., slip_rounding = 0., small = 0., rho = 0.;
      bool   same_rho = false;
    };

    /// Returns the initial iterate: zero increment, forces of the state.
    Iterate
    begin(const ContactProblem &problem);
    Scales
    scales(const ContactProblem &problem, const Iterate &at) const;
    PointVectors
    lengths(const ContactProblem &problem, const Iterate &at) const;
    Trial
    trial(const ContactProblem &problem,
          const Iterate        &at,
          const Scales         &scale) const;
    /// Adds the linearized law of the closed constraint @p r to @p law.
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
    /// Returns lambda - P(lambda - rho v) of constraint @p r [force].
    static dealii::Tensor<1, 3>
    missed(const unsigned int r, const Iterate &at, const Trial &trial);
    /// Returns the iterate on the way from @p from to @p to with the smallest
    /// |lambda - P(lambda - rho v)|.
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
