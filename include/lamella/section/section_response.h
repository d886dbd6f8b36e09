// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_response_h
#define lamella_section_section_response_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// The response v exp(i k y) of an infinite prism to a section load f exp(i k
  /// y):
  ///   ( S_00 + i k (S_01 - S_10) + k^2 S_11 ) v = f,
  /// Hermitian and positive definite for real k > 0. Responses at a few wave
  /// numbers, a rational Krylov basis of the section's quadratic pencil, span
  /// the deformation near this load. Each wave number takes one Cholesky
  /// factorization for all loads (solve_hermitian()). Refers to the section.
  class SectionResponse
  {
  public:
    explicit SectionResponse(const Section &section)
      : section(section)
    {}

    /// Returns the real and the imaginary part of the response to each of
    /// @p loads at the wave number @p k > 0 [1 / length], without negligible
    /// parts. Throws NumericsError if the matrix is not positive definite.
    std::vector<std::vector<Vector>>
    at(const double k, const std::vector<Vector> &loads) const;

  private:
    const Section &section;
  };
} // namespace lamella

#endif
