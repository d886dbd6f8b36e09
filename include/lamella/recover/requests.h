// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_requests_h
#define lamella_recover_requests_h

#include <lamella/recover/recovery.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A value to print beside a result: `uz: -0.134357: C3D20R, converged`.
  struct Reference
  {
    /// A column of probes.csv, or fx, fy, fz of a contact or a support.
    std::string quantity;
    double      value = 0.;
    std::string source;
  };

  /// References between '|'. Throws InputError, beginning with @p what, if one
  /// has not three parts or names none of @p quantities.
  std::vector<Reference>
  parse_references(const std::string              &text,
                   const std::vector<std::string> &quantities,
                   const std::string              &what);

  /// A point whose fields are reported.
  struct Probe
  {
    std::string            name;
    unsigned int           body = 0;
    dealii::Point<3>       position;
    StressValues           stress = StressValues::undefined;
    std::vector<Reference> references;
  };

  /// A segment along which the fields are reported.
  struct Line
  {
    std::string      name;
    unsigned int     body = 0;
    dealii::Point<3> from, to;
    StressValues     stress = StressValues::undefined;
    /// Points in each ply that the line crosses, both of its sides among them.
    unsigned int samples = 0;
  };

  /// A section of a body over which the fields are reported.
  struct Cut
  {
    std::string  name;
    unsigned int body = 0;
    /// Distance from the start of the axis.
    double       position = 0.;
    StressValues stress   = StressValues::undefined;
    /// Intervals in each direction of a cell.
    unsigned int samples = 0;
  };

  void
  declare_probe(dealii::ParameterHandler &prm);
  Probe
  parse_probe(const dealii::ParameterHandler &prm,
              const std::string              &name,
              const std::vector<std::string> &bodies);

  void
  declare_line(dealii::ParameterHandler &prm);
  Line
  parse_line(const dealii::ParameterHandler &prm,
             const std::string              &name,
             const std::vector<std::string> &bodies);

  void
  declare_cut(dealii::ParameterHandler &prm);
  Cut
  parse_cut(const dealii::ParameterHandler &prm,
            const std::string              &name,
            const std::vector<std::string> &bodies);
} // namespace lamella

#endif
