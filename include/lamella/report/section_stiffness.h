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
  /// Names of the section forces in the order of SaintVenant::Force.
  inline constexpr std::array<const char *, 6> section_force_names{
    {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"}};

  /// Section properties for beam programs: SaintVenant's 6 x 6 stiffness,
  /// constants derived from it, and the mass. They are independent of theories.
  /// Couplings m_ij below 1e-10 sqrt(m_ii m_jj) and coordinates below 1e-10 of
  /// the section's size are 0.
  struct SectionStiffness
  {
    /// Expansion in which the states were computed: `LE-3`.
    std::string expansion;
    /// Reason if all other members are invalid, whole sentences; else empty.
    std::string fault;
    /// Center of area, the reference of moments and velocities (x, z) [length].
    dealii::Point<2> reference_point;
    /// Section forces per strain [force, force length, force length^2],
    /// inverse.
    SectionTensor stiffness, compliance;
    /// Section constants; angles in (-90, 90] degrees.
    SectionConstants constants;
    /// Momenta per velocity of the rigid section, per length of beam,
    ///   int rho N^T N dA,  N (v, omega) = v + omega x (x - x_c, 0, z - z_c),
    /// [density length^2, length^3, length^4]. Empty unless all parts of the
    /// section have a density.
    std::optional<SectionTensor> mass;
  };

  /// Returns the degree N of LE-N for section_stiffness() of @p mesh: 3 for up
  /// to 20,000 DoFs of the section, 2 for up to 60,000, else 1.
  unsigned int
  expansion_degree(const SectionMesh &mesh);

  /// Returns stiffness, by SaintVenant in LE-N with N of expansion_degree(),
  /// and mass of the section @p mesh. Costs one Cholesky factorization of the
  /// section. Numerical failure (cells too thin, more than 300,000 DoFs in
  /// LE-1) sets the result's `fault`. Not collective.
  SectionStiffness
  section_stiffness(std::shared_ptr<const SectionMesh> mesh);

  /// Returns sections/NAME.json for @p section called @p name, with labels from
  /// @p units (doc/reference/section-properties.md).
  std::string
  section_json(const std::string      &name,
               const SectionStiffness &section,
               const Units            &units);

  /// Writes section_json() into sections/@p name.json of the existing folder
  /// @p directory. Throws InputError on failure.
  void
  write_section_stiffness(const std::string      &directory,
                          const std::string      &name,
                          const SectionStiffness &section,
                          const Units            &units);
} // namespace lamella

#endif
