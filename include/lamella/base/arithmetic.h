// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_arithmetic_h
#define lamella_base_arithmetic_h

namespace lamella
{
  /// What is meant by small: below which share of what a difference is
  /// nothing. Each number is relative, and says to what; where the next one up
  /// or down would decide otherwise, the place that uses it says why.
  ///
  /// Not here are the tolerances of a method, which stand with it, and the
  /// shares that are a judgement (from which a run says something), which are
  /// no arithmetic.
  namespace arithmetic
  {
    /// Of nothing: what a size is kept above that may be zero and is divided by
    /// or compared with.
    constexpr double above_zero = 1e-300;

    // ---- what rounding leaves of zero, relative to the terms that cancel

    /// Of the terms: a few operations on numbers of one order, as a shape
    /// function at the nodes of the others. Some fifty times a double's
    /// epsilon.
    constexpr double rounding = 1e-14;
    /// Of the terms: sums over many of them, as rows over the nodes of a body,
    /// the components of what was rotated, rows of a law.
    constexpr double rounding_of_sums = 1e-13;
    /// Of the terms: results of longer ways, reached on two of them (roots,
    /// iterates, projections, forces that balance).
    constexpr double rounding_of_results = 1e-12;
    /// Of the terms: solutions of linear equations and what is quadratic in
    /// them, as energies.
    constexpr double rounding_of_solutions = 1e-10;
    /// Of the largest number beside it: what tables and messages show as zero,
    /// and values of a run that are one value.
    constexpr double negligible = 1e-9;

    // ---- places, relative to a length

    /// Of the size of a body: places that come out of decimal texts, rotations
    /// and inverted maps, and are the same.
    constexpr double same_place = 1e-9;
    /// Of the length of an axis, or of the sides of a section: likewise, where
    /// a section or a wall may be a hundredth of it.
    constexpr double same_place_along = 1e-10;
    /// Of the diagonal of a section: likewise, through the inverse of a map
    /// that may be curved.
    constexpr double same_place_across = 1e-8;
    /// Of the length of an element, a cell or a side: likewise, where nothing
    /// shorter than it can be meant.
    constexpr double same_in_element = 1e-6;
    /// Unit coordinates that are known, as those of an element's nodes.
    constexpr double same_unit = 1e-10;

    // ---- angles

    /// The sine between directions that are parallel, if users gave them.
    constexpr double parallel = 1e-6;
    /// The sine of a corner that is none: a cell with it has no inside.
    constexpr double flat = 1e-8;

    // ---- numbers that are less sure than rounding makes them

    /// Of a number: what users write as equal, with six digits.
    constexpr double as_written = 1e-6;
    /// Of the integral of the magnitude: what integrals over cut or curved
    /// elements, and of a user's expressions, are good to.
    constexpr double integrated = 1e-6;
    /// Of its length at the start: what is left of a vector, a row or a motion
    /// that depends on those before. Less would be divided by later.
    constexpr double dependent = 1e-6;
    /// Of the larger one: what a mesh or a solver gives twice for what is one
    /// thing, as the answers to one load, or lengths of equal elements.
    constexpr double alike = 1e-6;
  } // namespace arithmetic
} // namespace lamella

#endif
