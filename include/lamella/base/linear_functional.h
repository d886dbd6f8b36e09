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
   * such as a gap, a stress, or a displacement component at a point (Eq. 7),
   *   u_c(X) = sum_tau,i F_tau(x, z) N_i(y) u_tau_i_c.
   *
   * The weights of u_c(X) are also the load vector of a unit force along c at X
   * (add_to()). Supports are equations of functionals, gaps differences of two
   * (Eq. 16), springs and penalties rank-one terms k r^T r. The unit of r is a
   * length for displacements and gaps, 1 for strains, force/length^2 for
   * stresses. An entry takes 16 bytes. BodyFunctional adds the body.
   */
  class LinearFunctional
  {
  public:
    /// Number k of a DoF and its weight w_k.
    using Entry = std::pair<DofIndex, double>;

    /// Adds @p weight to the weight of @p dof. Zeros are skipped; a DoF may
    /// occur several times until compress().
    void
    add(const DofIndex dof, const double weight);

    /// Adds @p value to the constant part.
    void
    add_constant(const double value);

    /// Adds @p factor times @p other, of the same body, with its constant part.
    void
    add(const LinearFunctional &other, const double factor);

    /// Sorts the entries by DoF and merges equal ones. Weights that cancel stay
    /// as zeros (drop_below()).
    void
    compress();

    /// Removes entries below @p relative times the largest magnitude. Rounding
    /// errors of interpolation would otherwise couple unrelated DoFs.
    void
    drop_below(const double relative);

    /// Returns r(u) for the whole vector @p u, constrained DoFs included.
    double
    operator()(const Vector &u) const;

    /// Adds @p factor times w to f, the load that does work @p factor on a unit
    /// of r (Eq. 8): a force if r is a length.
    void
    add_to(Vector &f, const double factor) const;

    /// Returns the functional of the unconstrained DoFs,
    ///   r(G v + u_p) = (r G) v + const., w_red = G^T w,
    /// with G the homogeneous part of the closed @p constraints. The constant
    /// part is kept, without inhomogeneities; the result is compressed.
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

  /// A linear functional with the number of its body.
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

    /// Adds to that block as LinearFunctional::add_to() does.
    void
    add_to(BlockVector &f, const double factor) const
    {
      row.add_to(f.block(body), factor);
    }
  };
} // namespace lamella

#endif
