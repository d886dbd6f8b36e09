// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_linear_functional_h
#define lamella_base_linear_functional_h

#include <lamella/base/linear_algebra.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * A sparse affine functional of the DoFs of one body,
   *   r(u) = c + sum_k w_k u_k,
   * such as a displacement component at a point (Eq. 7),
   *   u_c(X) = sum_tau,i F_tau(x, z) N_i(y) u_tau_i_c,
   * a gap, or a stress, with an initial stress as constant part.
   *
   * The work of a unit force along c at X is the row of u_c(X); read as a
   * column it is the load vector of that force (add_to()). Supports are
   * equations of rows, gaps differences of two (Eq. 16 without its constant),
   * springs and penalties rank-one terms k r^T r.
   *
   * The unit of r is a length for displacements and gaps, 1 for strains,
   * force/length^2 for stresses; weights have it over the unit of the DoFs. An
   * entry takes 16 bytes. A row does not know its body (see BodyFunctional).
   */
  class LinearFunctional
  {
  public:
    /// Number k of a DoF and its weight w_k.
    using Entry = std::pair<DofIndex, double>;

    /// Adds @p weight to the weight of @p dof, unless it is exactly zero.
    /// Entries are appended; a DoF may occur several times until compress().
    void
    add(const DofIndex dof, const double weight);

    /// Adds @p value to the constant part, which affects neither load vectors
    /// nor stiffnesses.
    void
    add_constant(const double value);

    /// Adds @p factor times @p other, a functional of the same body, including
    /// its constant part. Does not compress.
    void
    add(const LinearFunctional &other, const double factor);

    /// Sorts the entries by DoF and merges those of the same one, in n log n
    /// operations. Weights that cancel stay as zeros (see drop_below()).
    void
    compress();

    /// Removes entries below @p relative (such as 1e-13; zero removes nothing)
    /// times the largest magnitude: rounding errors of interpolation would
    /// couple rows that share no DoF. The constant part stays.
    void
    drop_below(const double relative);

    /// Returns r(u) for the body's whole vector @p u, constrained DoFs
    /// included.
    double
    operator()(const Vector &u) const;

    /// Adds @p factor times w to f, the load that does work @p factor on a unit
    /// of r (Eq. 8): @p factor is a force if r is a length. The constant part
    /// has no effect.
    void
    add_to(Vector &f, const double factor) const;

    /// Returns the functional of the unconstrained DoFs,
    ///   r(G v + u_p) = (r G) v + const., w_red = G^T w,
    /// with G the homogeneous part of @p constraints, which must be closed.
    /// Inhomogeneities are ignored: they belong to the particular solution. The
    /// constant part is kept, and the result is compressed.
    LinearFunctional
    reduced(const Constraints &constraints) const;

    /// Returns the entries in order of addition, or by DoF after compress().
    const std::vector<Entry> &
    entries() const
    {
      return row;
    }

    /// Returns the constant part c, zero for displacements.
    double
    constant() const
    {
      return constant_part;
    }

  private:
    std::vector<Entry> row;
    double             constant_part = 0.;
  };

  /// A row with the number of its body. Vectors of the scene have one block per
  /// body, in the order of its Bodies.
  struct BodyFunctional
  {
    /// Number of the body, and of its block in scene vectors.
    unsigned int     body = 0;
    LinearFunctional row;

    /// Returns r(u_b) for the block b of this body.
    double
    operator()(const BlockVector &u) const
    {
      return row(u.block(body));
    }

    /// Adds as LinearFunctional::add_to() to that block.
    void
    add_to(BlockVector &f, const double factor) const
    {
      row.add_to(f.block(body), factor);
    }
  };
} // namespace lamella

#endif
