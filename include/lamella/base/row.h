// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_row_h
#define lamella_base_row_h

#include <lamella/base/linear_algebra.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * A sparse affine functional of the DoFs of one body,
   *   r(u) = c + sum_k w_k u_k.
   * Whatever touches a body is one: a displacement component at a point,
   * u_c(X) = sum F_tau(X) N_i(X) u_tau_i_c, a gap, a stress, whose constant
   * part is that of an initial strain.
   */
  class Row
  {
  public:
    using Entry = std::pair<DofIndex, double>;

    /// Adds @p weight to the weight of @p dof.
    void
    add(const DofIndex dof, const double weight);

    /// Adds @p value to the constant part.
    void
    add_constant(const double value);

    /// Adds @p factor times the functional @p other of the same body.
    void
    add(const Row &other, const double factor);

    /// Sorts the entries by DoF and merges those that name the same one.
    void
    compress();

    /// Removes the entries below @p relative times the largest, in size.
    void
    drop_below(const double relative);

    /// The value r(u).
    double
    operator()(const Vector &u) const;

    /// f += factor * w: the load that does work @p factor on a unit of r.
    void
    add_to(Vector &f, const double factor) const;

    /**
     * The functional of the unconstrained DoFs: a constrained DoF is replaced
     * by its combination in @p constraints. Inhomogeneities are left out; they
     * belong to the particular solution.
     */
    Row
    reduced(const Constraints &constraints) const;

    /// The linear part.
    const std::vector<Entry> &
    entries() const
    {
      return row;
    }

    double
    constant() const
    {
      return constant_part;
    }

  private:
    std::vector<Entry> row;
    double             constant_part = 0.;
  };

  /// A row together with the number of the body whose DoFs it names.
  struct BodyRow
  {
    unsigned int body = 0;
    Row          row;

    double
    operator()(const BlockVector &u) const
    {
      return row(u.block(body));
    }

    void
    add_to(BlockVector &f, const double factor) const
    {
      row.add_to(f.block(body), factor);
    }
  };
} // namespace lamella

#endif
