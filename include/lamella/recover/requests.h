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
    double      value = 0.; ///< Reference value in the unit of the quantity.
    std::string source;     ///< Origin of the value as any text.
  };

  /// Returns the reference values in @p entry, separated by '|', each of the
  /// form QUANTITY: VALUE: SOURCE. Throws InputError if one of the three is
  /// missing, if VALUE is no number, or if QUANTITY is not in @p quantities.
  std::vector<Reference>
  parse_references(const Entry                    &entry,
                   const std::vector<std::string> &quantities);

  /// A point at which fields are output, or a box over which their mean is
  /// output. On a ply interface, a point or a flat box has values in each ply.
  struct Probe
  {
    std::string  name;     ///< Name in `subsection Probe NAME`.
    unsigned int body = 0; ///< Index of the body in Bodies.
    /// Position in the undeformed body, scene axes [length].
    dealii::Point<3> position;
    /// Method by which strains and stresses are computed.
    StressValues           stress = StressValues::undefined;
    std::vector<Reference> references; ///< Reference values of the results.
    /// Edge lengths of the box around the position [length]; zero for a point.
    dealii::Tensor<1, 3> box = {};
  };

  /// A line segment along which fields are output, at interfaces in both plies.
  struct Line
  {
    std::string      name;     ///< Name in `subsection Line NAME`.
    unsigned int     body = 0; ///< Index of the body in Bodies.
    dealii::Point<3> from;     ///< Start in the undeformed body, scene axes.
    dealii::Point<3> to;       ///< End in the undeformed body, scene axes.
    /// Method by which strains and stresses are computed.
    StressValues stress = StressValues::undefined;
    /// Number of equally spaced points, ends included, in each ply; at least 2.
    unsigned int samples = 0;
  };

  /// A cross section of a body at which fields are output, for contour plots.
  struct Cut
  {
    std::string  name;      ///< Name in `subsection Cut NAME`.
    unsigned int body = 0;  ///< Index of the body in Bodies.
    double position   = 0.; ///< Distance from the start of the axis [length].
    /// Method by which strains and stresses are computed.
    StressValues stress = StressValues::undefined;
    /// Number of grid intervals along each side of a section cell, 1 to 100.
    unsigned int samples = 0;
  };

  /// Entries of `subsection Probe NAME`: At, Box, Stress, References.
  struct ProbeParameters
  {
    /// Declares the entries with defaults, patterns and descriptions.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the probe @p name. Throws InputError if its body is not one of the
    /// names @p bodies, and for a box with negative edges.
    static Probe
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// Entries of `subsection Line NAME`: From, To, Stress, Samples.
  struct LineParameters
  {
    /// Declares the entries of a line in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the line @p name on one of the bodies named @p bodies. Throws
    /// InputError for coincident ends, for ends on two bodies, and unless
    /// Samples is 2 to 100,000.
    static Line
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// Entries of `subsection Cut NAME`: At, Stress, Samples.
  struct CutParameters
  {
    /// Declares the entries of a cut in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the cut @p name on one of the bodies named @p bodies. Throws
    /// InputError unless Samples is 1 to 100.
    static Cut
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
