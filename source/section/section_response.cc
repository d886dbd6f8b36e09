// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/section/section_response.h>

#include <cholmod.h>

#include <complex>
#include <memory>
#include <new>

namespace lamella
{
  namespace
  {
    /// CHOLMOD's workspace.
    struct Workspace
    {
      Workspace()
      {
        cholmod_l_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.final_ll   = true;
        common.print      = 0;
      }
      Workspace(const Workspace &) = delete;
      ~Workspace()
      {
        cholmod_l_finish(&common);
      }
      cholmod_common common;
    };



    /// Object of CHOLMOD, freed by its function @p free.
    template <typename T, typename Free>
    auto
    owned(T *object, cholmod_common &common, const Free &free)
    {
      if (object == nullptr)
        throw std::bad_alloc();
      const auto release = [&common, free](T *one) { free(&one, &common); };
      return std::unique_ptr<T, decltype(release)>(object, release);
    }



    /// The lower triangle of P + i Q by columns: of the upper one by rows the
    /// complex conjugate. Exact zeros are left out.
    cholmod_sparse *
    lower_triangle(const Matrix   &real,
                   const Matrix   &imaginary,
                   cholmod_common &common)
    {
      const std::size_t n = real.m();
      const auto        is_kept =
        [](const auto &p, const auto &q, const std::size_t row) {
          return p->column() >= row && (p->value() != 0. || q->value() != 0.);
        };
      std::size_t count = 0;
      for (std::size_t row = 0; row < n; ++row)
        {
          auto q = imaginary.begin(row);
          for (auto p = real.begin(row); p != real.end(row); ++p, ++q)
            count += is_kept(p, q, row);
        }
      cholmod_sparse *A = cholmod_l_allocate_sparse(
        n, n, count, true, true, -1, CHOLMOD_COMPLEX, &common);
      if (A == nullptr)
        return nullptr;
      auto *const start = static_cast<SuiteSparse_long *>(A->p);
      auto *const rows  = static_cast<SuiteSparse_long *>(A->i);
      auto *const x     = static_cast<std::complex<double> *>(A->x);
      std::size_t next  = 0;
      for (std::size_t row = 0; row < n; ++row)
        {
          start[row] = next;
          auto q     = imaginary.begin(row);
          for (auto p = real.begin(row); p != real.end(row); ++p, ++q)
            if (is_kept(p, q, row))
              {
                rows[next] = p->column();
                x[next++]  = {p->value(), -q->value()};
              }
        }
      start[n] = next;
      return A;
    }



    /// The right-hand sides as columns.
    cholmod_dense *
    columns(const std::vector<Vector> &vectors, cholmod_common &common)
    {
      const std::size_t n = vectors[0].size();
      cholmod_dense    *B = cholmod_l_allocate_dense(
        n, vectors.size(), n, CHOLMOD_COMPLEX, &common);
      if (B == nullptr)
        return nullptr;
      auto *x = static_cast<std::complex<double> *>(B->x);
      for (const Vector &vector : vectors)
        x = std::copy(vector.begin(), vector.end(), x);
      return B;
    }



    /// The real and the imaginary part of each column of @p X, in turns.
    std::vector<Vector>
    parts_of(const cholmod_dense &X)
    {
      std::vector<Vector> parts;
      const auto         *x = static_cast<const std::complex<double> *>(X.x);
      for (std::size_t k = 0; k < X.ncol; ++k, x += X.nrow)
        {
          Vector re(X.nrow), im(X.nrow);
          for (std::size_t i = 0; i < X.nrow; ++i)
            {
              re[i] = x[i].real();
              im[i] = x[i].imag();
            }
          parts.push_back(std::move(re));
          parts.push_back(std::move(im));
        }
      return parts;
    }



    /// Solves (P + i Q) (x + i y) = f for each real right-hand side f with
    /// CHOLMOD's complex Cholesky factorization. P + i Q must be Hermitian and
    /// positive definite: P = @p real is symmetric, Q = @p imaginary
    /// antisymmetric. Only their upper triangles, of the same pattern, are
    /// read.
    ///
    /// Returns x and y of the first right-hand side, then of the second, and so
    /// on. Throws NumericsError, with @p what as name of the matrix, if a pivot
    /// is not positive. Serial.
    std::vector<Vector>
    solve_hermitian(const Matrix              &real,
                    const Matrix              &imaginary,
                    const std::vector<Vector> &right_hand_sides,
                    const std::string         &what)
    {
      if (right_hand_sides.empty())
        return {};
      Workspace       workspace;
      cholmod_common &common = workspace.common;
      const auto      A      = owned(lower_triangle(real, imaginary, common),
                           common,
                           cholmod_l_free_sparse);
      const auto      L      = owned(cholmod_l_analyze(A.get(), &common),
                           common,
                           cholmod_l_free_factor);
      cholmod_l_factorize(A.get(), L.get(), &common);
      if (common.status == CHOLMOD_OUT_OF_MEMORY)
        throw std::bad_alloc();
      if (common.status != CHOLMOD_OK || L->minor != real.m() ||
          !(cholmod_l_rcond(L.get(), &common) > 0.))
        throw NumericsError(
          "linear.not-positive-definite: The matrix of " + what +
          " is not positive definite: stiffnesses or lengths differ too much for "
          "double precision. Make them less different.");
      const auto B =
        owned(columns(right_hand_sides, common), common, cholmod_l_free_dense);
      const auto X =
        owned(cholmod_l_solve(CHOLMOD_A, L.get(), B.get(), &common),
              common,
              cholmod_l_free_dense);
      return parts_of(*X);
    }
  } // namespace



  std::vector<std::vector<Vector>>
  SectionResponse::at(const double k, const std::vector<Vector> &loads) const
  {
    // Of the larger part.
    constexpr double nothing = arithmetic::rounding_of_solutions;
    Matrix           P(section.S(0, 0).get_sparsity_pattern()),
      Q(P.get_sparsity_pattern());
    P.copy_from(section.S(0, 0));
    P.add(k * k, section.S(1, 1));
    Q.copy_from(section.S(0, 1));
    Q.add(-1., section.S(1, 0));
    Q *= k;
    const std::vector<Vector> parts =
      solve_hermitian(P, Q, loads, "a section at the wave number");
    std::vector<std::vector<Vector>> fields(loads.size());
    for (unsigned int i = 0; i < loads.size(); ++i)
      {
        const double largest =
          std::max(parts[2 * i].linfty_norm(), parts[2 * i + 1].linfty_norm());
        for (const unsigned int part : {2 * i, 2 * i + 1})
          if (parts[part].linfty_norm() > nothing * largest)
            fields[i].push_back(parts[part]);
      }
    return fields;
  }
} // namespace lamella
