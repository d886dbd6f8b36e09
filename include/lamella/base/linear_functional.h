// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_linear_functional_h
#define lamella_base_linear_functional_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// A sparse affine functional of the DoFs of one body,
  ///   r(u) = c + sum_k w_k u_k,
  /// with constant c and weights w_k, such as a gap, a stress or the
  /// displacement component at a point X = (x, y, z),
  ///   u(X) = sum_tau,i F_tau(x, z) N_i(y) u_tau_i
  /// with section functions F_tau and axis shape functions N_i. The weights of
  /// u(X) are also the load vector of a unit force at X (add_to()). A support
  /// is an equation r(u) = 0, a gap the difference of two functionals, a spring
  /// a rank-one stiffness k w w^T. The unit of r is a length for displacements
  /// and gaps, 1 for strains, force/length^2 for stresses.
  class LinearFunctional
  {
  public:
    /// Index k of a DoF and its weight w_k.
    using Entry = std::pair<DofIndex, double>;

    /// Adds @p weight to the weight of @p dof. Zero is skipped. Until
    /// compress() is called, several entries may have the same DoF.
    void
    add(const DofIndex dof, const double weight);

    /// Adds @p value to the constant part c.
    void
    add_constant(const double value);

    /// Adds @p factor times the functional @p other of the same body, including
    /// its constant part.
    void
    add(const LinearFunctional &other, const double factor);

    /// Sorts the entries by DoF and sums entries of the same DoF. Entries whose
    /// sum is zero remain (see drop_below()).
    void
    compress();

    /// Removes weights whose magnitude is below @p relative times the largest
    /// weight, such as rounding errors, which would couple unrelated DoFs.
    void
    drop_below(const double relative);

    /// Returns the value r(u) for @p u, which includes constrained DoFs.
    double
    operator()(const Vector &u) const;

    /// Adds @p factor times the weights w to the load vector @p f. @p factor is
    /// work-conjugate to the value r, e.g. a force if r is a length.
    void
    add_to(Vector &f, const double factor) const;

    /// Returns this functional r(u) = w . u + c restricted to the unconstrained
    /// DoFs v of closed @p constraints u = G v + u_p: weights G^T w, sorted by
    /// DoF, and the constant c. The contribution w . u_p is not added.
    LinearFunctional
    reduced(const Constraints &constraints) const;

    /// Returns DoFs and weights as added; sorted by DoF after compress().
    const std::vector<Entry> &
    entries() const
    {
      return row;
    }

    /// Returns the constant c, which is zero for displacements.
    double
    constant() const
    {
      return constant_part;
    }

  private:
    std::vector<Entry> row;
    double             constant_part = 0.;
  };

  /// A linear functional of the displacements of one body, with its index.
  struct BodyFunctional
  {
    unsigned int     body = 0; ///< Index of the body, and of its block.
    LinearFunctional row;      ///< Functional of the DoFs of this body.

    /// Returns the value of the functional for displacements @p u of all
    /// bodies.
    double
    operator()(const BlockVector &u) const
    {
      return row(u.block(body));
    }

    /// Adds @p factor times the weights to the block of this body in @p f.
    void
    add_to(BlockVector &f, const double factor) const
    {
      row.add_to(f.block(body), factor);
    }
  };

  /// Returns the indices of a maximal set of linearly independent rows of @p A,
  /// by pivoted Cholesky factorization of A A^T (like LAPACK's dgeqp3 of A^T).
  /// Each step selects the row with the longest component orthogonal to the
  /// selected rows, until it is below @p relative times the longest row.
  std::vector<unsigned int>
  select_independent_rows(const dealii::LAPACKFullMatrix<double> &A,
                          const double relative = 0.);

  /// Makes @p v orthogonal to the vectors b_j of @p basis with j >= @p first by
  /// the Gram-Schmidt method, applied twice to reduce rounding errors,
  ///   c_j = (v, b_j), v <- v - sum_j c_j b_j.
  /// @p basis must be orthonormal in the inner product @p product. @p v is not
  /// normalized. Returns the coefficients c_j of the original v, from number @p
  /// first on. T is a number or a tensor.
  template <typename T, typename Product>
  std::vector<double>
  make_orthogonal(std::vector<T>                    &v,
                  const std::vector<std::vector<T>> &basis,
                  const Product                     &product,
                  const unsigned int                 first = 0)
  {
    std::vector<double> parts(basis.size() - first, 0.);
    for (unsigned int pass = 0; pass < 2; ++pass)
      for (unsigned int j = first; j < basis.size(); ++j)
        {
          const double part = product(v, basis[j]);
          parts[j - first] += part;
          for (unsigned int i = 0; i < v.size(); ++i)
            v[i] -= part * basis[j][i];
        }
    return parts;
  }
} // namespace lamella

#endif
