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
  /// Elimination of the linear constraints R u = d of one body, after its
  /// kinematic constraints: u = G v + u_p with the unconstrained DoFs v.
  /// Gauss-Jordan elimination with rank detection, in each group of rows that
  /// share DoFs, eliminates one DoF (pivot) per independent row:
  ///   R u = P u_P + Q u_Q,   u_P = P^-1 d - P^-1 Q u_Q,   u_P the pivots,
  /// exact to rounding, without a penalty. Coarse DoFs are eliminated first,
  /// which keeps the basis hierarchical. A pivot is at least a tenth of the
  /// largest entry of its row; among rows with pivots of similar size, the
  /// shortest is eliminated first, which limits fill-in. The result of a group
  /// is reused for a group that differs by a shift along the axis only.
  ///
  /// A row counts as linearly dependent if all entries that remain after
  /// elimination are below 1e-6 of its largest original entry, with DoFs scaled
  /// by Body::dof_scales(). Its remaining right-hand side must be below 1e-6 of
  /// the largest prescribed value. Keeps a reference to the kinematic
  /// constraints of the body.
  class RowReduction
  {
  public:
    /// Eliminates those of @p rows that belong to @p body, which has the index
    /// @p index. A row must not contain a DoF twice. Throws InputError, which
    /// names supports by @p support_names, if rows contradict each other.
    RowReduction(const Body                              &body,
                 const unsigned int                       index,
                 const std::vector<PrescribedFunctional> &rows,
                 const std::vector<std::string>          &support_names);

    /// Returns the homogeneous constraints u = G v of supports and theory, with
    /// which the stiffness is condensed.
    const Constraints &
    constraints() const
    {
      return homogeneous;
    }

    /// Returns the particular solution u_p, zero in unconstrained DoFs.
    const Vector &
    particular() const
    {
      return particular_solution;
    }

    /// Returns the Lagrange multipliers mu (reactions) of the independent rows,
    /// pairs (index of the row, force on the body), from R^T mu = @p residual,
    /// internal minus external forces. Only the equations P^T mu = residual_P
    /// of the pivots are solved, after condensation of kinematic constraints.
    /// Dependent rows have no multiplier; resultants are still unique.
    std::vector<std::pair<unsigned int, double>>
    multipliers(const Vector &residual) const;

    /// Returns the displacement w, zero except in pivots, whose work on a
    /// residual is the weighted sum of its multipliers() mu:
    ///   w . residual = sum_k weight(k) mu_k,   k the index of the row.
    Vector
    influence(const std::function<double(const unsigned int)> &weight) const;

  private:
    /// Stores the result of @p elimination, one group of rows. Throws
    /// InputError if rows contradict each other.
    void
    keep(const RowElimination                    &elimination,
         const Body                              &body,
         const std::vector<PrescribedFunctional> &rows,
         const std::vector<std::string>          &support_names);

    /// Constraints of the theory alone, and together with supports; u_p.
    const Constraints           &kinematic;
    Constraints                  homogeneous;
    Vector                       particular_solution;
    std::vector<IndependentRows> groups;
  };
} // namespace lamella

#endif
