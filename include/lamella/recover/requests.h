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
  /// A reference value beside a result, `uz: -0.134357: C3D20R, converged`.
  struct Reference
  {
    /// Column of probes.csv, or fx, fy, fz of a contact or a support.
    std::string quantity;
    /// Value in the unit of the quantity; the source is any text.
    double      value = 0.;
    std::string source;
  };

  /// Returns the references of @p entry, separated by '|', each QUANTITY:
  /// VALUE: SOURCE. Throws InputError if one has fewer than three parts, names
  /// none of @p quantities (the message suggests the nearest) or has no number.
  std::vector<Reference>
  parse_references(const Entry                    &entry,
                   const std::vector<std::string> &quantities);

  /// A point whose fields are reported, or a box whose mean fields are. On a
  /// ply interface a point, or a flat box in it, is reported in each ply.
  struct Probe
  {
    /// Name in `subsection Probe NAME`; number of the body in Bodies.
    std::string  name;
    unsigned int body = 0;
    /// Position in the undeformed body, scene axes [length].
    dealii::Point<3>       position;
    StressValues           stress = StressValues::undefined;
    std::vector<Reference> references;
    /// Edges of the box around the position [length]; zero: a point.
    dealii::Tensor<1, 3> box = {};
  };

  /// A segment along which fields are reported, on both sides of interfaces.
  struct Line
  {
    std::string  name;
    unsigned int body = 0;
    /// Two different points in the undeformed body, scene axes [length].
    dealii::Point<3> from, to;
    StressValues     stress = StressValues::undefined;
    /// Number of equally spaced points, ends included, in each ply; 2 or more.
    unsigned int samples = 0;
  };

  /// A section of a body, normal to its axis, with fields for contours.
  struct Cut
  {
    std::string  name;
    unsigned int body = 0;
    /// Distance from the start of the axis [length].
    double       position = 0.;
    StressValues stress   = StressValues::undefined;
    /// Intervals in each direction of a cell, 1 to 100.
    unsigned int samples = 0;
  };

  /// The entries of a `subsection Probe NAME`: At, Box, Stress, References.
  struct ProbeParameters
  {
    /// Declares the entries with defaults, patterns and descriptions.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the probe @p name on one of @p bodies. Throws InputError, also
    /// for a box with negative edges.
    static Probe
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// The entries of a `subsection Line NAME`: From, To, Stress, Samples.
  struct LineParameters
  {
    /// Declares the entries, as ProbeParameters::declare().
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the line @p name. Throws InputError, also for coincident ends or
    /// ends on two bodies, and unless Samples is 2 to 100,000.
    static Line
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// The entries of a `subsection Cut NAME`: At, Stress, Samples.
  struct CutParameters
  {
    /// Declares the entries, as ProbeParameters::declare().
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the cut @p name. Throws InputError; Samples is 1 to 100.
    static Cut
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
