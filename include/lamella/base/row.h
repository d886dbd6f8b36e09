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
   * Whatever touches a body is one: a displacement component at a point (Eq.
   * 7),
   *   u_c(X) = sum_tau,i F_tau(x, z) N_i(y) u_tau_i_c,
   * a gap, a stress, whose constant part is that of an initial strain.
   *
   * Functionals are what the variational form is made of: the work of a unit
   * force along c at X is the row of u_c(X), and the load vector of that force
   * is the same row read as a column (add_to()). Supports are equations between
   * rows, gaps the difference of two (Eq. 16 of the paper without its
   * constant), springs and penalties rank-one terms k r^T r.
   *
   * The unit of r is that of what it measures: a length for displacements and
   * gaps, 1 for strains, force/length^2 for stresses. The weights carry it over
   * the unit of the DoFs. Memory is 16 bytes an entry; nothing is shared, and a
   * row refers to no body: who keeps it keeps the body's number, too (BodyRow).
   */
  class Row
  {
  public:
    /// The number k of a DoF and its weight w_k.
    using Entry = std::pair<DofIndex, double>;

    /// Adds @p weight to the weight of @p dof. A weight of exactly zero is not
    /// kept. Entries are appended as they come: a DoF may stand there several
    /// times until compress().
    void
    add(const DofIndex dof, const double weight);

    /// Adds @p value to the constant part. It is part of the value and of
    /// nothing else: neither load vectors nor stiffnesses know it.
    void
    add_constant(const double value);

    /// Adds @p factor times the functional @p other of the same body. The
    /// constant part is scaled, too. Not compressed afterwards.
    void
    add(const Row &other, const double factor);

    /// Sorts the entries by DoF and merges those that name the same one. n log
    /// n in the number of entries. Weights that cancel stay as zeros;
    /// drop_below() removes them.
    void
    compress();

    /// Removes the entries below @p relative times the largest, in size. What
    /// interpolation at a node leaves in other nodes is rounding, and would
    /// couple rows that share no DoF. @p relative is a number such as 1e-13;
    /// zero removes nothing. The constant part stays.
    void
    drop_below(const double relative);

    /// The value r(u). @p u is the whole vector of the body, with the values of
    /// its constrained DoFs.
    double
    operator()(const Vector &u) const;

    /// f += factor * w: the load that does work @p factor on a unit of r.
    /// @p factor is a force where r is a length: then f gets the DoFs' share of
    /// it, by the principle of virtual displacements (Eq. 8). The constant part
    /// does not enter.
    void
    add_to(Vector &f, const double factor) const;

    /**
     * The functional of the unconstrained DoFs: a constrained DoF is replaced
     * by its combination in @p constraints. Inhomogeneities are left out; they
     * belong to the particular solution.
     *
     *   r(G v + u_p) = (r G) v + const., w_red = G^T w,
     *
     * with G the homogeneous part of @p constraints, which must be closed. The
     * constant part is kept as it is, and the result is compressed.
     */
    Row
    reduced(const Constraints &constraints) const;

    /// The linear part. In the order in which they came, or ascending by DoF
    /// after compress().
    const std::vector<Entry> &
    entries() const
    {
      return row;
    }

    /// The constant part c: the value for u = 0, zero for displacements.
    double
    constant() const
    {
      return constant_part;
    }

  private:
    std::vector<Entry> row;
    double             constant_part = 0.;
  };

  /// A row together with the number of the body whose DoFs it names. Vectors of
  /// the scene have one block per body, in the order of its Bodies.
  struct BodyRow
  {
    /// The block of scene vectors that the row reads and writes.
    unsigned int body = 0;
    Row          row;

    /// The value r(u_b) with the block b of this body.
    double
    operator()(const BlockVector &u) const
    {
      return row(u.block(body));
    }

    /// Row::add_to() in that block; the others stay.
    void
    add_to(BlockVector &f, const double factor) const
    {
      row.add_to(f.block(body), factor);
    }
  };
} // namespace lamella

#endif
