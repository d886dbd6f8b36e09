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
  /// The prescribed rows of a body, as RowReduction uses them.
  struct BodyConstraints
  {
    /// Selects the @p rows that belong to @p body, number @p index; keeps both.
    BodyConstraints(const Body                              &body,
                    const unsigned int                       index,
                    const std::vector<PrescribedFunctional> &rows);

    /// Returns the nonempty rows in groups that share DoFs.
    std::vector<std::vector<unsigned int>>
    groups() const;

    const Body                              &body;
    const std::vector<PrescribedFunctional> &prescribed;
    /// Functionals of the rows in independent DoFs; empty for other bodies.
    std::vector<LinearFunctional> functionals;
    /// Body::dof_scales().
    std::vector<double> sizes;
  };

  /// The independent rows of a group, which shares no DoF with another one, and
  /// the DoFs that they eliminate.
  struct IndependentRows
  {
    /// Numbers of the rows in the list of all.
    std::vector<unsigned int> rows;
    /// DoF that rows[k] eliminates.
    std::vector<DofIndex> pivots;
    /// Factorized transpose of the rows in the pivots' columns.
    std::shared_ptr<const dealii::SparseDirectUMFPACK> transposed;
  };

  /// A row during elimination: the rest of its entries, in displacements (DoFs
  /// times sizes), and of its right-hand side.
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

    /// Returns whether the rest of the row is large enough for a pivot.
    bool
    is_open() const;

    void
    find_largest();

    double
    entry(const DofIndex dof) const;

    /// Subtracts @p factor times @p other, removes @p eliminated, and returns
    /// the DoFs that are new in the row.
    std::vector<DofIndex>
    subtract(const FunctionalEquation &other,
             const DofIndex            eliminated,
             const double              factor);
  };

  /// Gauss-Jordan elimination of a group (RowReduction). Entries of equations
  /// with a pivot belong to DoFs.
  class RowElimination
  {
  public:
    /// Eliminates @p group, numbers in the list of @p held.
    RowElimination(const std::vector<unsigned int> &group,
                   const BodyConstraints           &held);

    /// Returns the shift of all DoFs, if any, that makes the rows @p group
    /// equal to these, as for supports along an axis node by node.
    std::optional<DofIndex>
    find_shift(const std::vector<unsigned int> &group,
               const BodyConstraints           &held) const;

    /// Makes this the elimination of @p group, shifted by @p shift.
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
