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
  /// Names of the section forces in the order of SaintVenant::Force, which is
  /// that of all matrices below.
  inline constexpr std::array<const char *, 6> section_force_names{
    {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"}};

  /**
   * What a section amounts to for a program of beams: SaintVenant's 6 x 6
   * stiffness with what is read off it, and the mass, as data. Whatever the
   * theory of the bodies that have the section.
   *
   * Rounding is taken out: a coupling m_ij below 1e-10 sqrt(m_ii m_jj) is 0, as
   * is a coordinate below 1e-10 of the section's size. So a section without
   * coupling has none.
   */
  struct SectionStiffness
  {
    /// Whose space the states were sought in: `LE-3`.
    std::string expansion;
    /// Why there are no numbers, in whole sentences; empty where there are.
    /// With it nothing below means anything.
    std::string fault;
    /// The centre of area, which moments and velocities are about: section
    /// coordinates (x, z) [length].
    dealii::Point<2> reference_point;
    /// Section forces per section strain [force, force length, force length^2],
    /// and the inverse.
    SectionTensor stiffness, compliance;
    /// The angle from above -90 to 90 degrees.
    SectionConstants constants;
    /**
     * Momenta per velocity of the rigid section, in a length of the beam of 1:
     *   int rho N^T N dA,  N (v, omega) = v + omega x (x - x_c, 0, z - z_c),
     * [density length^2, length^3, length^4]. None unless all parts of the
     * section have a density.
     */
    std::optional<SectionTensor> mass;
  };

  /// The degree N of LE-N that section_stiffness() chooses for @p mesh: 3 for
  /// up to 20,000 DoFs of the section, or 2 for up to 60,000, or 1. What fine
  /// meshes lose in degree they have in cells.
  unsigned int
  expansion_degree(const SectionMesh &mesh);

  /**
   * The stiffness of the section @p mesh by SaintVenant in LE-N, with N of
   * expansion_degree(), and its mass. One Cholesky factorisation of the
   * section. Shares @p mesh for the time of the call; other processes need not
   * take part.
   *
   * Throws nothing for what the numerics cannot do (cells too thin, a section
   * with more than 300,000 DoFs in LE-1): no run should end for it, so it
   * becomes the result's fault.
   */
  SectionStiffness
  section_stiffness(std::shared_ptr<const SectionMesh> mesh);

  /// What sections/NAME.json says of @p section called @p name, keys as fixed
  /// in doc/section-properties.md. @p units label it. Ends with a line feed.
  std::string
  section_json(const std::string      &name,
               const SectionStiffness &section,
               const Units            &units);

  /// Writes section_json() into sections/@p name.json of the existing folder
  /// @p directory. Throws InputError if it cannot.
  void
  write_section_stiffness(const std::string      &directory,
                          const std::string      &name,
                          const SectionStiffness &section,
                          const Units            &units);
} // namespace lamella

#endif
