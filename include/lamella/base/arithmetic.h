// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_arithmetic_h
#define lamella_base_arithmetic_h

namespace lamella
{
  /// Relative thresholds below which differences are negligible. Tolerances of
  /// methods and thresholds of warnings are defined where they are used.
  namespace arithmetic
  {
    /// Lower limit of a divisor or reference value, against division by zero.
    constexpr double smallest_divisor = 1e-300;

    // ---- rounding errors, relative to the terms that cancel

    /// Rounding error, relative to the terms, of a few operations on numbers of
    /// equal magnitude, such as a shape function where it vanishes.
    constexpr double rounding = 1e-14;
    /// Rounding error of long sums, relative to the terms, such as products
    /// with a matrix row or tensor components after a rotation.
    constexpr double rounding_of_sums = 1e-13;
    /// Rounding error of longer computations, relative to the terms: roots,
    /// iterates, projections, sums of forces in equilibrium.
    constexpr double rounding_of_results = 1e-12;
    /// Rounding error, relative to the terms, of solutions of linear equations
    /// and of energies computed from these solutions.
    constexpr double rounding_of_solutions = 1e-10;
    /// Numbers below this fraction of the largest in the same table or message
    /// are printed as zero. Computed values with a smaller relative difference
    /// are equal.
    constexpr double negligible = 1e-9;

    // ---- distances of points, relative to a length

    /// Points coincide if closer than this fraction of the size of the body,
    /// when computed from decimal input, rotations and inverse maps.
    constexpr double same_position = 1e-9;
    /// Points coincide if closer than this fraction of the axis length or
    /// section side. Sections and walls may be 100 times smaller.
    constexpr double same_position_along = 1e-10;
    /// Points coincide if closer than this fraction of the diagonal of the
    /// section, when computed from the inverse of a curved map.
    constexpr double same_position_across = 1e-8;
    /// Points coincide if closer than this fraction of the shortest element,
    /// cell or section side.
    constexpr double same_in_element = 1e-6;
    /// Difference below which reference coordinates in [0, 1] are equal.
    constexpr double same_unit = 1e-10;

    // ---- angles

    /// Sine of the angle below which directions from the input are parallel.
    constexpr double parallel_sine = 1e-6;
    /// A cell is degenerate if the sine of one of its corner angles is smaller.
    constexpr double degenerate_sine = 1e-8;

    // ---- numbers that are less accurate than rounding

    /// Relative difference below which two numbers from the input are equal,
    /// since users write six digits.
    constexpr double decimal_tolerance = 1e-6;
    /// Relative error, with respect to the integral of the absolute value, of
    /// integrals over cut or curved elements and of users' expressions.
    constexpr double quadrature_tolerance = 1e-6;
    /// A vector is linearly dependent on others if its remainder after
    /// orthogonalization is below this fraction of its initial length.
    constexpr double dependency_tolerance = 1e-6;
    /// Results of a mesh generator or a solver, such as two element lengths,
    /// are equal if their relative difference is smaller.
    constexpr double same_value = 1e-6;
  } // namespace arithmetic
} // namespace lamella

#endif
