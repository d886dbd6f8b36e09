// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_arithmetic_h
#define lamella_base_arithmetic_h

namespace lamella
{
  /// Relative thresholds below which differences are negligible. Tolerances of
  /// methods and thresholds of warnings are defined where they are used.
  namespace arithmetic
  {
    /// Lower limit of a divisor or reference size that may be zero.
    constexpr double smallest_divisor = 1e-300;

    // ---- what rounding leaves of zero, relative to the terms that cancel

    /// Relative to the terms: a few operations on numbers of one order, such as
    /// a shape function at the other nodes. About fifty double epsilons.
    constexpr double rounding = 1e-14;
    /// Relative to the terms: long sums, as rows over the nodes of a body,
    /// components after rotations, rows of a law.
    constexpr double rounding_of_sums = 1e-13;
    /// Relative to the terms: results of longer computations computed in two
    /// ways (roots, iterates, projections, forces that balance).
    constexpr double rounding_of_results = 1e-12;
    /// Relative to the terms: solutions of linear equations and quantities
    /// quadratic in them, as energies.
    constexpr double rounding_of_solutions = 1e-10;
    /// Relative to the largest number beside it: shown as zero in tables and
    /// messages; also the difference of equal values of a run.
    constexpr double negligible = 1e-9;

    // ---- places, relative to a length

    /// Relative to the size of a body: distance of equal places computed from
    /// decimal texts, rotations and inverse maps.
    constexpr double same_position = 1e-9;
    /// Relative to the length of an axis or the sides of a section: distance of
    /// equal places if a section or a wall may be a hundredth of it.
    constexpr double same_position_along = 1e-10;
    /// Relative to the diagonal of a section: distance of equal places through
    /// the inverse of a possibly curved map.
    constexpr double same_position_across = 1e-8;
    /// Relative to the length of an element, a cell or a side: distance of
    /// equal places if no part is shorter.
    constexpr double same_in_element = 1e-6;
    /// Tolerance of known unit coordinates, as those of an element's nodes.
    constexpr double same_unit = 1e-10;

    // ---- angles

    /// Sine between parallel directions that the user gives.
    constexpr double parallel_sine = 1e-6;
    /// Sine of a degenerate corner: a cell with it has no interior.
    constexpr double degenerate_sine = 1e-8;

    // ---- numbers that are less accurate than rounding

    /// Relative difference of equal numbers that users write with six digits.
    constexpr double decimal_tolerance = 1e-6;
    /// Relative to the integral of the magnitude: accuracy of integrals over
    /// cut or curved elements and of users' expressions.
    constexpr double quadrature_tolerance = 1e-6;
    /// Relative to the initial length: the remainder of a vector, a row or a
    /// motion that depends on earlier ones, and so must not be a divisor.
    constexpr double dependency_tolerance = 1e-6;
    /// Relative to the larger one: difference of a quantity that a mesh or a
    /// solver gives twice, such as lengths of equal elements.
    constexpr double same_value = 1e-6;
  } // namespace arithmetic
} // namespace lamella

#endif
