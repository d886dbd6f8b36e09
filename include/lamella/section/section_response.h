// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_response_h
#define lamella_section_section_response_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /**
   * How a section answers a load that varies along the axis as exp(i k y): with
   * the section load vector f the response v exp(i k y) of an infinite prism
   * fulfils
   *   ( S_00 + i k (S_01 - S_10) + k^2 S_11 ) v = f,
   * which is Hermitian and positive definite for real k > 0. The responses at a
   * few wave numbers span, as a rational Krylov basis of the section's
   * quadratic pencil, what the section does near this load. One Cholesky
   * factorisation a wave number serves all loads (solve_hermitian()). Refers to
   * the section.
   */
  class SectionResponse
  {
  public:
    explicit SectionResponse(const Section &section)
      : section(section)
    {}

    /// For each of @p loads the real and the imaginary part of its response at
    /// the wave number @p k > 0 [1 / length]; a part that is nothing beside the
    /// other is left out. Throws NumericsError if the matrix is not positive
    /// definite in doubles.
    std::vector<std::vector<Vector>>
    at(const double k, const std::vector<Vector> &loads) const;

  private:
    const Section &section;
  };
} // namespace lamella

#endif
