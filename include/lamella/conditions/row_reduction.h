// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_row_reduction_h
#define lamella_conditions_row_reduction_h

#include <lamella/conditions/row_elimination.h>
#include <lamella/conditions/support.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Elimination of the support constraints R u = d of one body, after its
  /// kinematic constraints: u = G v + u_p with the unconstrained DoFs v.
  /// Gauss-Jordan elimination with rank detection, in each group of constraints
  /// with common DoFs, eliminates one DoF (pivot) per independent constraint:
  ///   R u = P u_P + Q u_Q,   u_P = P^-1 d - P^-1 Q u_Q,   u_P the pivots,
  /// exact to rounding, without a penalty. Coarse DoFs are eliminated first,
  /// which keeps the basis hierarchical. A pivot is at least a tenth of the
  /// largest entry of its row of R. Among rows with pivots of similar size, the
  /// shortest is eliminated first, against fill-in. The result is reused for
  /// groups that differ by a shift along the axis.
  ///
  /// A row of R is linearly dependent if all entries that remain after
  /// elimination are below 1e-6 of its largest original entry, with DoFs scaled
  /// by DofInfo::scale. It is contradictory if its remaining right-hand
  /// side exceeds 1e-6 of the largest value. Keeps a reference to the body's
  /// kinematic constraints.
  class RowReduction
  {
  public:
    /// Eliminates the constraints in @p rows on @p body with the index @p
    /// index. A constraint must not contain a DoF twice. Throws InputError with
    /// names of supports (@p support_names) if constraints are contradictory.
    RowReduction(const Body                              &body,
                 const unsigned int                       index,
                 const std::vector<PrescribedFunctional> &rows,
                 const std::vector<std::string>          &support_names);

    /// Returns the homogeneous constraints on the DoFs due to supports and beam
    /// theory, with which the stiffness matrix is condensed.
    const Constraints &
    constraints() const
    {
      return homogeneous;
    }

    /// Returns u_p, which satisfies the supports with zero unconstrained DoFs.
    const Vector &
    particular() const
    {
      return particular_solution;
    }

    /// Returns the support reactions (Lagrange multipliers) of the linearly
    /// independent constraints, pairs (index of the constraint, force on the
    /// body). Of @p residual, internal minus external forces, only entries at
    /// eliminated DoFs are used, after condensation of kinematic constraints.
    /// Dependent constraints get no reaction; the total resultant is unique.
    std::vector<std::pair<unsigned int, double>>
    multipliers(const Vector &residual) const;

    /// Returns the displacement w, zero in unconstrained DoFs, whose work on a
    /// residual is the weighted sum of the reactions mu_k from multipliers():
    ///   w . residual = sum_k weight(k) mu_k,   k the index of the constraint.
    Vector
    influence(const std::function<double(const unsigned int)> &weight) const;

  private:
    /// Stores the result @p elimination of a group. Throws InputError if its
    /// constraints are contradictory.
    void
    keep(const RowElimination                    &elimination,
         const Body                              &body,
         const std::vector<PrescribedFunctional> &rows,
         const std::vector<std::string>          &support_names);

    /// Constraints of the theory alone; then together with those of supports.
    const Constraints           &kinematic;
    Constraints                  homogeneous;
    Vector                       particular_solution;
    std::vector<IndependentRows> groups;
  };
} // namespace lamella

#endif
