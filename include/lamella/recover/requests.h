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
  /// A value from elsewhere to print beside a result, as in `uz: -0.134357:
  /// C3D20R, converged`: quantity, value, source.
  struct Reference
  {
    /// A column of probes.csv, or fx, fy, fz of a contact or a support.
    std::string quantity;
    /// In the unit of the quantity. The source is any text.
    double      value = 0.;
    std::string source;
  };

  /// The references of @p entry, between '|', each QUANTITY: VALUE: SOURCE;
  /// further colons belong to the source. None where the entry is empty. Throws
  /// InputError if one has fewer than three parts, names none of @p quantities
  /// (the message has the nearest name) or gives no number.
  std::vector<Reference>
  parse_references(const Entry                    &entry,
                   const std::vector<std::string> &quantities);

  /// A point whose fields are reported, or a box whose mean fields are. On a
  /// ply interface a point is reported in each of the plies, and so is a box
  /// without thickness that lies in one; any other box is one.
  struct Probe
  {
    /// As in `subsection Probe NAME`; the body's number in Bodies.
    std::string  name;
    unsigned int body = 0;
    /// Of the undeformed body, scene axes [length].
    dealii::Point<3>       position;
    StressValues           stress = StressValues::undefined;
    std::vector<Reference> references;
    /// The edges of the box around the position, along the scene's axes
    /// [length]; none of them negative. All zero: the point.
    dealii::Tensor<1, 3> box = {};
  };

  /// A segment along which the fields are reported. From surface to surface
  /// through the plies it shows the stresses over the thickness, with both
  /// sides of each interface.
  struct Line
  {
    std::string  name;
    unsigned int body = 0;
    /// Two different points in the body, undeformed, scene axes [length].
    dealii::Point<3> from, to;
    StressValues     stress = StressValues::undefined;
    /// Points in each ply that the line crosses, both of its sides among them.
    /// From 2; equally spaced in each.
    unsigned int samples = 0;
  };

  /// A section of a body, normal to its axis, over which the fields are
  /// reported, for contours.
  struct Cut
  {
    std::string  name;
    unsigned int body = 0;
    /// Distance from the start of the axis. [length]
    double       position = 0.;
    StressValues stress   = StressValues::undefined;
    /// Intervals in each direction of a cell. From 1 to 100: (samples + 1)^2
    /// points a cell.
    unsigned int samples = 0;
  };

  /// The entries of a `subsection Probe NAME`: At, Box, Stress,
  /// References.
  struct ProbeParameters
  {
    /// Declares them with their defaults, patterns and what they mean.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The probe @p name of one of the bodies with the names @p bodies. Throws
    /// InputError, also for a box with negative edges; whether the place is in
    /// the body is checked on the body.
    static Probe
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// The entries of a `subsection Line NAME`: From, To, Stress, Samples.
  struct LineParameters
  {
    /// As that of a probe.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The line @p name. Throws InputError, also for ends that are the same
    /// point or on two bodies, and unless Samples is a whole number from 2 to
    /// 100,000. Whether the ends are in the body is checked by Sampler.
    static Line
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// The entries of a `subsection Cut NAME`: At, Stress, Samples.
  struct CutParameters
  {
    /// As that of a probe.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The cut @p name. Throws InputError, also unless Samples is a whole
    /// number from 1 to 100. Whether the axis reaches that far is checked by
    /// Sampler.
    static Cut
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
