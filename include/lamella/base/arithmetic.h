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

    // ---- what rounding leaves of zero, relative to the terms that cancel

    /// Rounding error, relative to the terms, of a few operations on numbers of
    /// one order, such as a shape function where it vanishes. About 50 eps.
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
    /// are printed as zero. Two values of a run that differ less are equal.
    constexpr double negligible = 1e-9;

    // ---- distances of points, relative to a length

    /// Points closer than this fraction of the body's size coincide, if
    /// computed from decimal input, rotations and inverse maps.
    constexpr double same_position = 1e-9;
    /// Points closer than this fraction of the axis length or section side
    /// coincide, where a section or wall may be 100 times smaller.
    constexpr double same_position_along = 1e-10;
    /// Points of a section closer than this fraction of its diagonal coincide,
    /// if computed by inverting a curved map.
    constexpr double same_position_across = 1e-8;
    /// Points closer than this fraction of an element, cell or side coincide,
    /// if the length of that element, cell or side is the smallest one.
    constexpr double same_in_element = 1e-6;
    /// Tolerance for reference coordinates in [0, 1], such as those of nodes.
    constexpr double same_unit = 1e-10;

    // ---- angles

    /// Input directions are parallel if the sine of their angle is less.
    constexpr double parallel_sine = 1e-6;
    /// A cell is degenerate if the sine of a corner angle is less.
    constexpr double degenerate_sine = 1e-8;

    // ---- numbers that are less accurate than rounding

    /// Relative difference below which two numbers of the input are equal;
    /// users write six digits.
    constexpr double decimal_tolerance = 1e-6;
    /// Relative to the integral of the magnitude: accuracy of integrals over
    /// cut or curved elements and of users' expressions.
    constexpr double quadrature_tolerance = 1e-6;
    /// A vector is linearly dependent on others if its remainder after
    /// orthogonalization is below this fraction of its initial length.
    constexpr double dependency_tolerance = 1e-6;
    /// Relative difference below which two results of a mesh or a solver are
    /// equal, such as the lengths of two elements.
    constexpr double same_value = 1e-6;
  } // namespace arithmetic
} // namespace lamella

#endif
