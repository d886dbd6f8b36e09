// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_response_h
#define lamella_section_section_response_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// Computes section functions from harmonic loads. Under a section load f
  /// exp(i k y), an infinite prismatic beam has the displacement v exp(i k y),
  ///   ( S_00 + i k (S_01 - S_10) + k^2 S_11 ) v = f,
  /// with the matrices S_pq of Section. The matrix is Hermitian and positive
  /// definite for wave numbers k > 0. Solutions v at a few k approximate the
  /// deformation near a load f on a short length (rational Krylov space). Each
  /// k takes one factorization for all loads. Keeps a reference to the section.
  class SectionResponse
  {
  public:
    /// Constructs the solver for @p section, without a factorization yet.
    explicit SectionResponse(const Section &section)
      : section(section)
    {}

    /// Returns, for each load in @p loads, the displacement v at the wave
    /// number @p k > 0 [1 / length]: its real and imaginary parts, unless
    /// negligible. Throws NumericsError if the matrix is not positive definite.
    std::vector<std::vector<Vector>>
    at(const double k, const std::vector<Vector> &loads) const;

  private:
    const Section &section;
  };
} // namespace lamella

#endif
