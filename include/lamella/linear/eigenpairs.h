// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_eigenpairs_h
#define lamella_linear_eigenpairs_h

#include <lamella/base/arithmetic.h>
#include <lamella/base/linear_algebra.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// A product or a solution.
  using Operator = std::function<BlockVector(const BlockVector &)>;

  /// The symmetric eigenvalue problem A v = mu B v with a positive
  /// definite matrix B, by its operators. solve_B may be restricted to a
  /// subspace, on which B must be positive definite: the eigenvectors are in
  /// its range.
  struct Eigenproblem
  {
    Operator times_A, ///< Returns A v.
      times_B,        ///< Returns B v.
      solve_B;        ///< Returns B^-1 f.
    /// True if A is positive definite and its product is the cheaper one: the
    /// Lanczos method then uses the inner product of A, otherwise that of B.
    bool in_product_of_A = false;
  };

  /// Eigenvalues and eigenvectors.
  struct Eigenpairs
  {
    std::vector<double>      values;  ///< Eigenvalues mu, descending.
    std::vector<BlockVector> vectors; ///< Eigenvectors.
  };

  /// Parameters of the Lanczos method.
  struct LanczosParameters
  {
    /// Largest residual of B^-1 A v = mu v divided by |mu|.
    double       tolerance = arithmetic::quadrature_tolerance;
    unsigned int vectors   = 0;   ///< Size of the basis; 0: 2 n + 10.
    unsigned int restarts  = 100; ///< Largest number of restarts.
  };

  /// Returns the @p n eigenpairs of @p problem with the largest eigenvalues, or
  /// fewer, if only these converge; none if A @p start is zero. Lanczos method
  /// with implicit restarts (ARPACK's dsaupd in its modes 2 and 3: Lehoucq,
  /// Sorensen and Yang, ARPACK Users' Guide, SIAM 1998, 3.2). Start vector is
  /// B^-1 A @p start. Multiple eigenvalues may be found once only, see
  /// add_missing_eigenpairs(). The dimension of the subspace of solve_B must
  /// not be below the size of the basis. Throws NumericsError if B is not
  /// positive definite. Deterministic: equal on all processes.
  Eigenpairs
  largest_eigenpairs(const Eigenproblem      &problem,
                     const BlockVector       &start,
                     const unsigned int       n,
                     const LanczosParameters &parameters = {});

  /// Adds to @p found the eigenpairs of @p problem that are missing between its
  /// eigenvalues, such as further vectors of multiple ones: the largest
  /// eigenvalues in the space that is orthogonal to the eigenvectors found,
  /// until one is below all of these. The number of eigenpairs is kept.
  void
  add_missing_eigenpairs(const Eigenproblem      &problem,
                         const BlockVector       &start,
                         const LanczosParameters &parameters,
                         Eigenpairs              &found);

  /// Replaces the eigenpairs @p pairs of @p problem by the Ritz pairs in the
  /// space of their vectors, with eigenvalues from the products A v and B v:
  /// errors of solve_B then enter squared. Values descend.
  void
  refine_by_rayleigh_ritz(const Eigenproblem &problem, Eigenpairs &pairs);

  /// Returns equally distributed pseudorandom numbers in [-1, 1], the same for
  /// each @p seed, in blocks as of @p like: they excite all eigenvectors.
  BlockVector
  random_vector(const BlockVector &like, const unsigned int seed = 1);
} // namespace lamella

#endif
