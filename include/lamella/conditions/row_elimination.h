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
  /// The prescribed rows of a body as RowReduction takes them.
  struct BodyRows
  {
    /// Those of @p rows, which may be of all bodies, that belong to @p body,
    /// number @p index. Refers to both.
    BodyRows(const Body                       &body,
             const unsigned int                index,
             const std::vector<PrescribedRow> &rows);

    /// Those that have entries, in groups that share DoFs.
    std::vector<std::vector<unsigned int>>
    groups() const;

    const Body                       &body;
    const std::vector<PrescribedRow> &prescribed;
    /// Of each row the functional, in the DoFs that the body's theory leaves
    /// independent; those of other bodies empty.
    std::vector<Row> functionals;
    /// Body::dof_sizes().
    std::vector<double> sizes;
  };

  /// The independent rows of a group and the DoFs that they eliminate. Groups
  /// share no DoF, so each is solved for by itself.
  struct IndependentRows
  {
    /// Numbers in the list of all.
    std::vector<unsigned int> rows;
    /// The DoF that rows[k] eliminates.
    std::vector<DofIndex> pivots;
    /// The factorised transpose of the rows in the pivots' columns; groups that
    /// are the same but for a shift share it.
    std::shared_ptr<const dealii::SparseDirectUMFPACK> transposed;
  };

  /// A row under elimination: what is left of it and of its right-hand side.
  /// Its entries are those of displacements, DoFs times their sizes.
  struct RowEquation
  {
    unsigned int               number;
    std::map<DofIndex, double> entries;
    double                     value;
    double                     largest = 0., at_start = 0.;
    /// The DoF that it eliminates, if any.
    DofIndex pivot = dealii::numbers::invalid_dof_index;

    bool
    has_pivot() const
    {
      return pivot != dealii::numbers::invalid_dof_index;
    }

    /// Whether there is enough of it left to eliminate a DoF with.
    bool
    is_open() const;

    void
    find_largest();

    double
    entry(const DofIndex dof) const;

    /// Takes @p factor times @p other off, and with it @p eliminated. Returns
    /// the DoFs that come in.
    std::vector<DofIndex>
    subtract(const RowEquation &other,
             const DofIndex     eliminated,
             const double       factor);
  };

  /// The rows of a group with what their elimination, Gauss' and Jordan's,
  /// leaves (RowReduction): equations whose entries are those of DoFs again
  /// where they have a pivot.
  class RowElimination
  {
  public:
    /// Of @p group, numbers in the list of @p held.
    RowElimination(const std::vector<unsigned int> &group,
                   const BodyRows                  &held);

    /// Whether the rows @p group are these but for a shift of all DoFs, which
    /// it returns: the supports of a body along its axis are, node by node.
    std::optional<DofIndex>
    shift_to(const std::vector<unsigned int> &group,
             const BodyRows                  &held) const;

    /// Makes this the elimination of @p group, shifted by @p shift.
    void
    move_to(const std::vector<unsigned int> &group, const DofIndex shift);

    std::vector<unsigned int> rows;
    std::vector<RowEquation>  equations;
    /// Of the prescribed values.
    double          largest_value = 0.;
    IndependentRows independent;

  private:
    /// Factorises the independent ones of the rows @p functionals.
    void
    factorise(const std::vector<Row> &functionals);
  };
} // namespace lamella

#endif
