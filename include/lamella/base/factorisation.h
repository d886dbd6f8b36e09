// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_factorisation_h
#define lamella_base_factorisation_h

#include <lamella/base/linear_solver.h>

namespace lamella
{
  /**
   * Factorises @p matrix, of which only the upper triangle is read, with
   * CHOLMOD's supernodal Cholesky factorisation A = P^T L L^T P (AMD or METIS
   * ordering, serial). Its condition estimate is the square of the ratio of the
   * largest to the smallest diagonal entry of L: cheap and rough, it tells
   * decades. Its solved rows are half solved (HalfSolvedRows).
   *
   * Throws NumericsError if a pivot is not positive; @p what then names the
   * matrix in the message.
   */
  std::unique_ptr<LinearSolver>
  factorise(const Matrix &matrix, const std::string &what);
} // namespace lamella

#endif
