// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_requests_h
#define lamella_recover_requests_h

#include <lamella/base/entry.h>
#include <lamella/recover/recovery.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A reference value of a result in a scene, such as `uz: -0.134: C3D20R`.
  struct Reference
  {
    /// Column of probes.csv, or force fx, fy, fz of a contact or support.
    std::string quantity;
    /// Value in the unit of the quantity; the source is any text.
    double      value = 0.;
    std::string source;
  };

  /// Returns the references in @p entry, separated by '|', each of the form
  /// QUANTITY: VALUE: SOURCE. Throws InputError if one has fewer than three
  /// parts, no name of @p quantities (the message suggests one) or no number.
  std::vector<Reference>
  parse_references(const Entry                    &entry,
                   const std::vector<std::string> &quantities);

  /// A point at which fields are output, or a box over which their mean is
  /// output. On a ply interface, a point or a flat box has values in each ply.
  struct Probe
  {
    /// Name in `subsection Probe NAME`; number of the body in Bodies.
    std::string  name;
    unsigned int body = 0;
    /// Position in the undeformed body, scene axes [length].
    dealii::Point<3>       position;
    StressValues           stress = StressValues::undefined;
    std::vector<Reference> references;
    /// Edges of the box around the position [length]; zero for a point.
    dealii::Tensor<1, 3> box = {};
  };

  /// A line segment along which fields are output, on both sides of interfaces.
  struct Line
  {
    std::string  name;
    unsigned int body = 0;
    /// Two different points in the undeformed body, scene axes [length].
    dealii::Point<3> from, to;
    StressValues     stress = StressValues::undefined;
    /// Number of equally spaced points, ends included, in each ply; at least 2.
    unsigned int samples = 0;
  };

  /// A cross section of a body at which fields are output, for contour plots.
  struct Cut
  {
    std::string  name;
    unsigned int body = 0;
    /// Distance from the start of the axis [length].
    double       position = 0.;
    StressValues stress   = StressValues::undefined;
    /// Number of intervals in each direction of a cell, 1 to 100.
    unsigned int samples = 0;
  };

  /// Entries of a `subsection Probe NAME`: At, Box, Stress, References.
  struct ProbeParameters
  {
    /// Declares the entries with defaults, patterns and descriptions.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the probe @p name on one of @p bodies. Throws InputError for an
    /// unknown body and for a box with negative edges.
    static Probe
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// Entries of a `subsection Line NAME`: From, To, Stress, Samples.
  struct LineParameters
  {
    /// Declares the entries, as ProbeParameters::declare().
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the line @p name. Throws InputError for coincident ends, for ends
    /// on two bodies, and unless Samples is 2 to 100,000.
    static Line
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// Entries of a `subsection Cut NAME`: At, Stress, Samples.
  struct CutParameters
  {
    /// Declares the entries, as ProbeParameters::declare().
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the cut @p name. Throws InputError unless Samples is 1 to 100.
    static Cut
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
