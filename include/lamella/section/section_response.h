// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_response_h
#define lamella_section_section_response_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// Computes section functions from harmonic loads: the displacement v exp(i k
  /// y) of an infinite prismatic beam under a section load f exp(i k y) solves
  ///   ( S_00 + i k (S_01 - S_10) + k^2 S_11 ) v = f,
  /// with the matrices S_pq of Section. The matrix is Hermitian and positive
  /// definite for real k > 0. The solutions v at a few wave numbers k
  /// approximate the deformation near this load (rational Krylov space). Each
  /// wave number takes one factorization for all loads (see solve_hermitian()).
  /// Keeps a reference to the section.
  class SectionResponse
  {
  public:
    explicit SectionResponse(const Section &section)
      : section(section)
    {}

    /// Returns the real and the imaginary part of v, unless negligible, for
    /// each load f of @p loads at the wave number @p k > 0 [1 / length]. Throws
    /// NumericsError if the matrix is not positive definite.
    std::vector<std::vector<Vector>>
    at(const double k, const std::vector<Vector> &loads) const;

  private:
    const Section &section;
  };
} // namespace lamella

#endif
