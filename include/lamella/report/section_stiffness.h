// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_section_stiffness_h
#define lamella_report_section_stiffness_h

#include <lamella/base/units.h>
#include <lamella/section/saint_venant.h>

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace lamella
{
  /// Names of the section forces in the order of matrix rows.
  inline constexpr std::array<const char *, 6> section_force_names{
    {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"}};

  /// Properties of a cross-section as input of beam programs: 6 x 6 stiffness
  /// by Saint-Venant's solutions, constants derived from it, and mass. In each
  /// matrix m, entries |m_ij| < 1e-10 sqrt(m_ii m_jj) are rounding, set to 0.
  struct SectionStiffness
  {
    /// Expansion of the finite element solution, such as LE-3.
    std::string expansion;
    /// Reason (sentences) if the computation failed; otherwise empty.
    std::string fault;
    /// Centroid (x, z), the reference point of moments and velocities [length].
    dealii::Point<2> reference_point;
    SectionTensor    stiffness;  ///< Section forces per beam strain.
    SectionTensor    compliance; ///< Inverse of the stiffness.
    /// E A, E I, G J and centers; angles in (-90, 90] degrees.
    SectionConstants constants;
    /// Mass matrix of the rigid section per length of beam, int rho N^T N dA,
    /// for velocity v of the centroid (x_c, z_c) and angular velocity omega,
    ///   N (v, omega) = v + omega x (x - x_c, 0, z - z_c);
    /// empty if a density is unknown.
    std::optional<SectionTensor> mass;
  };

  /// Returns the polynomial degree of the expansion (LE-N) with which
  /// section_stiffness() computes @p mesh: 3 if the section then has at most
  /// 20,000 DoFs, 2 for up to 60,000, otherwise 1.
  unsigned int
  expansion_degree(const SectionMesh &mesh);

  /// Computes the stiffness (by Saint-Venant's solutions) and the mass of the
  /// section @p mesh. If this fails (cells too thin, more than 300,000 DoFs
  /// with linear elements), `fault` of the result is set. Not collective.
  SectionStiffness
  section_stiffness(std::shared_ptr<const SectionMesh> mesh);

  /// Returns the properties of the section @p name as JSON, with labels of
  /// @p units (doc/reference/section-properties.md).
  std::string
  section_json(const std::string      &name,
               const SectionStiffness &section,
               const Units            &units);

  /// Writes section_table() of @p mesh and section_json() to sections/NAME.csv
  /// and .json in the folder @p directory. Throws InputError on failure.
  void
  write_section(const std::string      &directory,
                const std::string      &name,
                const SectionMesh      &mesh,
                const SectionStiffness &section,
                const Units            &units);
} // namespace lamella

#endif
