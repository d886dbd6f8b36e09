// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_row_elimination_h
#define lamella_conditions_row_elimination_h

#include <lamella/conditions/support.h>

#include <deal.II/lac/sparse_direct.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// The support constraints of one body, each a linear functional (row) of its
  /// DoFs, as input of RowReduction.
  struct BodyConstraints
  {
    /// Selects those of @p rows that belong to @p body, which has the index @p
    /// index. Keeps references to @p body and @p rows.
    BodyConstraints(const Body                              &body,
                    const unsigned int                       index,
                    const std::vector<PrescribedFunctional> &rows);

    /// Returns the indices of the nonempty rows, in groups that have no common
    /// DoFs and can be eliminated independently.
    std::vector<std::vector<unsigned int>>
    groups() const;

    const Body                              &body;
    const std::vector<PrescribedFunctional> &prescribed;
    /// Each row in terms of the DoFs that kinematic constraints of the body do
    /// not eliminate; empty for rows of other bodies.
    std::vector<LinearFunctional> functionals;
    /// Displacement per unit of each DoF (Body::dof_scales()).
    std::vector<double> sizes;
  };

  /// The linearly independent constraint rows of a group, and the DoF that each
  /// of them eliminates.
  struct IndependentRows
  {
    /// Indices of the rows in the list of all rows.
    std::vector<unsigned int> rows;
    /// DoF that rows[k] eliminates.
    std::vector<DofIndex> pivots;
    /// LU factors of the transpose of the matrix of rows and pivot columns.
    std::shared_ptr<const dealii::SparseDirectUMFPACK> transposed;
  };

  /// A constraint row during Gauss-Jordan elimination: its remaining entries,
  /// in terms of displacements (DoFs times Body::dof_scales()), and its
  /// right-hand side `value`.
  struct FunctionalEquation
  {
    unsigned int               number;
    std::map<DofIndex, double> entries;
    double                     value;
    double                     largest = 0., at_start = 0.;
    /// DoF that the row eliminates, if any.
    DofIndex pivot = dealii::numbers::invalid_dof_index;

    bool
    has_pivot() const
    {
      return pivot != dealii::numbers::invalid_dof_index;
    }

    /// Returns whether the row has no pivot but an entry that is not
    /// negligible.
    bool
    is_open() const;

    void
    find_largest();

    double
    entry(const DofIndex dof) const;

    /// Subtracts @p factor times @p other from this row and removes the DoF
    /// @p eliminated. Returns the DoFs of new entries (fill-in).
    std::vector<DofIndex>
    subtract(const FunctionalEquation &other,
             const DofIndex            eliminated,
             const double              factor);
  };

  /// Gauss-Jordan elimination of one group of constraint rows (RowReduction).
  /// Entries of equations with a pivot are in terms of unscaled DoFs.
  class RowElimination
  {
  public:
    /// Eliminates the rows with indices @p group among those of @p held.
    RowElimination(const std::vector<unsigned int> &group,
                   const BodyConstraints           &held);

    /// Returns s if the rows @p group equal the rows of this object with each
    /// DoF i replaced by i + s, as for equal supports of successive axis nodes.
    std::optional<DofIndex>
    find_shift(const std::vector<unsigned int> &group,
               const BodyConstraints           &held) const;

    /// Converts this to the elimination of the rows @p group, whose DoFs are
    /// shifted by @p shift.
    void
    apply_shift_to(const std::vector<unsigned int> &group,
                   const DofIndex                   shift);

    std::vector<unsigned int>       rows;
    std::vector<FunctionalEquation> equations;
    /// Largest prescribed value.
    double          largest_value = 0.;
    IndependentRows independent;

  private:
    /// Factorizes the independent rows of @p functionals.
    void
    factorize(const std::vector<LinearFunctional> &functionals);
  };
} // namespace lamella

#endif
