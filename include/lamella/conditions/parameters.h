// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_parameters_h
#define lamella_conditions_parameters_h

#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /// `BODY: rest` with the body's number among @p bodies. Throws InputError,
  /// beginning with @p what, for a name that is none of them.
  std::pair<unsigned int, std::string>
  parse_on_body(const std::string              &text,
                const std::vector<std::string> &bodies,
                const std::string              &what);

  /// The regions of the entries `On` and `At`; InputError beginning with
  /// @p what.
  std::vector<Region>
  parse_regions(const std::string              &on,
                const std::string              &at,
                const std::vector<std::string> &bodies,
                const std::string              &what);

  void
  declare_support(dealii::ParameterHandler &prm);

  /// The entries of a `subsection Support NAME`.
  Support
  parse_support(const dealii::ParameterHandler &prm,
                const std::string              &name,
                const std::vector<std::string> &bodies);

  void
  declare_load(dealii::ParameterHandler &prm);

  /// The entries of a `subsection Load NAME`.
  Load
  parse_load(const dealii::ParameterHandler &prm,
             const std::string              &name,
             const std::vector<std::string> &bodies);
} // namespace lamella

#endif
