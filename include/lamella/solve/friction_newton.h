// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_newton_h
#define lamella_solve_friction_newton_h

#include <lamella/solve/coulomb.h>
#include <lamella/solve/penalty_matrix.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The paper's Newton step (Eq. 22) with Coulomb's law: one on the
   * displacements and contact forces of the whole scene, for the `full`
   * strategy. With the gap and the slip of a row in the step, and its law's
   * softness a raised to d about an estimate lambda_bar of its force,
   *   v = (g, s - s_0) + a lambda + (d - a) (lambda - lambda_bar),
   * it is that of Alart and Curnier (Comput. Methods Appl. Mech. Eng. 92 (1991)
   * 353-375) for lambda = P(lambda - rho v) and equilibrium. Of the trial force
   * z = lambda - rho v, e = z_t / |z_t|, b = mu max(0, z_n) and k = b / |z_t|:
   *   open    where z_n <= 0:     lambda = 0;
   *   sticks  where |z_t| <= b:   v = 0, in K^p (B_n^T B_n + B_t^T B_t) / d;
   *   slips   otherwise:          v_n = 0, lambda_t along e mu lambda_n, and
   *                               across it w (-s), w = k rho / (1 - k + k rho
   *                               d):
   *     B_n^T B_n / d + (mu / d) B_e^T B_n + w B_x^T B_x,
   * which is not symmetric. After some steps each fourth is shortened where
   * that leaves less of the natural map.
   *
   * Where a slip v_t is there, rho = b / |v_t| of its tangents: for one that
   * goes the wrong way to its force the trial force is zero, and the row sticks
   * before it slips the other way. Refers to all that it is made of.
   */
  class FrictionNewton
  {
  public:
    FrictionNewton(const Linearisation     &linearisation,
                   const GapRows           &rows,
                   const NumericalSoftness &softness,
                   PenaltyMatrix           &matrix)
      : linearisation(linearisation)
      , rows(rows)
      , softness(softness)
      , matrix(matrix)
    {}

    /// As ContactStrategy::settle() of a problem with slips. Throws
    /// NumericsError where the tangent that it ends with has a negative
    /// determinant: an answer that no load path leads to.
    ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor);

  private:
    /// About the state of the problem.
    struct Iterate
    {
      /// And K du from strains.
      BlockVector du, K_du;
      /// Whole forces, as all that follows: of each row (n, t_1, t_2).
      PointVectors force;
      /// What the last step changed du by at most.
      double change;
    };

    /// What the natural map says of the rows.
    struct Trial
    {
      PointVectors v, z;
      /// mu max(0, z_n), and rho of the tangents.
      std::vector<double>     bound, rho;
      std::vector<PointState> states;
    };

    /// What a step does to forces: lambda + change - sum of the terms, weight
    /// times what the displacements open B_on by.
    struct Law
    {
      PointVectors             change;
      std::vector<PenaltyTerm> terms;
    };

    /// What is rounding: gaps of open rows; gaps and slips of pressed ones,
    /// which are solved for; forces. And rho, forces over lengths, of the
    /// normals, of the tangents where they have not slipped and, for a measure
    /// of how good an iterate is, of all.
    struct Scales
    {
      double closed = 0., slid = 0., small = 0., rho = 0.;
      bool   same_rho = false;
    };

    /// The forces of the step before and what they do without a contact that
    /// answers.
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
    /// What the law asks of row @p r, which is not open.
    void
    linearise(const unsigned int r,
              const Iterate     &at,
              const Trial       &trial,
              Law               &law) const;
    /// The same of the tangents of a row that slips.
    void
    linearise_slip(const unsigned int r,
                   const Iterate     &at,
                   const Trial       &trial,
                   Law               &law) const;
    Iterate
    step(const ContactProblem &problem, const Iterate &at, const Trial &trial);
    /// The natural map of row @p r, a force.
    static dealii::Tensor<1, 3>
    missed(const unsigned int r, const Iterate &at, const Trial &trial);
    /// Of @p from and what a step led to, @p to: the best of some shares of the
    /// way.
    Iterate
    shortened(const ContactProblem &problem,
              const Iterate        &from,
              Iterate               to) const;
    Round
    wrong_rows(const Iterate &at,
               const Trial   &trial,
               const Scales  &scale) const;
    ContactSolution
    solution(const ContactProblem &problem,
             Iterate               at,
             const Trial          &trial) const;

    const Linearisation     &linearisation;
    const GapRows            rows;
    const NumericalSoftness &softness;
    PenaltyMatrix           &matrix;
  };
} // namespace lamella

#endif
