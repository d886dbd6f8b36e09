// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_theory_h
#define lamella_section_theory_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace lamella
{
  /**
   * A structural theory: which cross-section expansion a beam has, and what its
   * strains are completed with (the paper's Sec. 2).
   *
   * - EBBT, Euler-Bernoulli: u_x, u_y, u_z of the axis, sections stay plane and
   *   normal to the axis (Kirchhoff's constraint, exact, needs B4).
   * - TBT, Timoshenko: sections stay plane, u_y is linear over the section.
   *   Neither can twist.
   * - TE-N: all polynomials of degree N for each component (Eq. 2).
   * - LE-N: layer-wise Lagrange elements of degree N (Eq. 3), L4, L9, L16 for
   *   N = 1, 2, 3.
   * - solid-N: no beam at all, but hexahedra of degree N, 1 or 2.
   */
  struct Theory
  {
    enum class Kind
    {
      undefined,
      EBBT,
      TBT,
      TE,
      LE,
      solid
    };
    Kind kind = Kind::undefined;
    /// N of TE-N, LE-N and solid-N; 1 for the classical theories.
    unsigned int order = 0;

    /**
     * Whether sections of EBBT, TBT and TE-1, whose own functions cannot
     * follow the contraction under bending, contract freely (Poisson locking
     * otherwise). EBBT and TBT condense sigma_xx = sigma_zz = sigma_xz = 0 out
     * of the law of each ply; TE-1, which has stiffness in xx and zz of its
     * own, condenses quadratic contraction modes of the section.
     */
    bool poisson_correction = true;
    /// Of TBT: multiplies the shear stiffness of sections, G A -> k G A.
    double shear_factor = 1.;

    /// As a user writes it.
    std::string
    name() const;

    /// Classical theories: 1, x, z for u_y alone.
    bool
    is_classical() const
    {
      return kind == Kind::EBBT || kind == Kind::TBT;
    }

    /// The theory that @p text spells, with defaults for the rest. Throws
    /// InputError, beginning with @p what, for anything else.
    static Theory
    parse(const std::string &text, const std::string &what);
  };

  /// The entries of a body's `subsection Kinematics` that speak of its theory.
  struct TheoryParameters
  {
    std::string theory, poisson_correction, shear_factor;

    static void
    declare(dealii::ParameterHandler &prm);

    static TheoryParameters
    parse(const dealii::ParameterHandler &prm);

    /// The theory, or the scene's where the body names none. Throws InputError,
    /// beginning with @p what (`Body NAME/Kinematics`).
    Theory
    resolve(const std::string &scene_theory, const std::string &what) const;
  };

  /// For use as a key: theories that share the section's fields and matrices.
  bool
  operator<(const Theory &a, const Theory &b);
} // namespace lamella

#endif
