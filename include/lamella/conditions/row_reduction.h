// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_row_reduction_h
#define lamella_conditions_row_reduction_h

#include <lamella/conditions/support.h>

#include <deal.II/lac/sparse_direct.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Displacement constraints that supports impose on one body. Each is a
  /// linear functional of its DoFs, a row of the constraint matrix.
  struct BodyConstraints
  {
    /// Selects from @p rows, the constraints of all bodies, those of @p body
    /// with the index @p index. Keeps references to @p body and @p rows.
    BodyConstraints(const Body                              &body,
                    const unsigned int                       index,
                    const std::vector<PrescribedFunctional> &rows);

    /// Returns the indices of the constraints of this body in groups. Different
    /// groups have no common DoF and can be eliminated independently.
    std::vector<std::vector<unsigned int>>
    groups() const;

    const Body                              &body;       ///< Constrained body.
    const std::vector<PrescribedFunctional> &prescribed; ///< All constraints.
    /// Functional of each constraint of the body after elimination of its
    /// kinematic constraints; empty for constraints of other bodies.
    std::vector<LinearFunctional> functionals;
  };

  /// Linearly independent constraints of a group with common DoFs, and the DoF
  /// that each of them eliminates.
  struct IndependentRows
  {
    /// Indices of these constraints among all support constraints.
    std::vector<unsigned int> rows;
    /// DoF that constraint rows[k] eliminates, for each k.
    std::vector<DofIndex> pivots;
    /// LU factors of the transpose of the square matrix whose rows are these
    /// constraints and whose columns are the eliminated DoFs.
    std::shared_ptr<const dealii::SparseDirectUMFPACK> transposed;
  };

  /// Linear constraint sum_i entries[i] v_i = value during Gauss-Jordan
  /// elimination. The unknowns v_i are DoFs times DofInfo::scale.
  struct FunctionalEquation
  {
    unsigned int               number;  ///< Index of the constraint.
    std::map<DofIndex, double> entries; ///< Nonzero coefficients.
    double                     value;   ///< Right-hand side [length].
    double largest = 0., ///< Largest magnitude of a coefficient at present.
      at_start     = 0.; ///< Largest magnitude before the elimination.
    /// DoF that this equation eliminates; invalid_dof_index until it is chosen.
    DofIndex pivot = dealii::numbers::invalid_dof_index;

    /// Returns true if the equation eliminates a DoF.
    bool
    has_pivot() const
    {
      return pivot != dealii::numbers::invalid_dof_index;
    }

    /// Returns true if the equation eliminates no DoF yet and its coefficients
    /// are not negligible relative to those before the elimination.
    bool
    is_open() const;

    void
    find_largest(); ///< Sets `largest` to the maximum of |entries|.

    double
    entry(const DofIndex dof) const; ///< Returns the coefficient, or 0.

    /// Subtracts @p factor times equation @p other from this one and removes
    /// DoF @p eliminated. Returns the DoFs with new coefficients (fill-in).
    std::vector<DofIndex>
    subtract(const FunctionalEquation &other,
             const DofIndex            eliminated,
             const double              factor);
  };

  /// Gauss-Jordan elimination of one group of support constraints with common
  /// DoFs. Afterwards, equations with a pivot have unscaled DoFs as unknowns.
  class RowElimination
  {
  public:
    /// Eliminates the constraints with the indices @p group in @p held, the
    /// support constraints of the body.
    RowElimination(const std::vector<unsigned int> &group,
                   const BodyConstraints           &held);

    /// Returns the s, if any, for which the constraints @p group equal the
    /// eliminated ones with each DoF i replaced by i + s (as at successive axis
    /// nodes).
    std::optional<DofIndex>
    find_shift(const std::vector<unsigned int> &group,
               const BodyConstraints           &held) const;

    /// Converts this to the elimination of the equal constraints @p group,
    /// whose DoF indices are larger by @p shift (find_shift()).
    void
    apply_shift_to(const std::vector<unsigned int> &group,
                   const DofIndex                   shift);

    std::vector<unsigned int>       rows;      ///< Indices of constraints.
    std::vector<FunctionalEquation> equations; ///< Eliminated constraints.
    /// Largest magnitude of the prescribed displacements [length].
    double          largest_value = 0.;
    IndependentRows independent; ///< Independent constraints, their DoFs.

  private:
    /// Factorizes the independent rows of @p functionals.
    void
    factorize(const std::vector<LinearFunctional> &functionals);
  };

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
