// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_parameters_h
#define lamella_contact_parameters_h

#include <lamella/contact/gap_rows.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  void
  declare_contact(dealii::ParameterHandler &prm);

  /// Obstacles in the order of the scene's list.
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// The entries of a `subsection Contact NAME`. Throws InputError.
  ContactPair
  parse_contact(const dealii::ParameterHandler &prm,
                const std::string              &name,
                const std::vector<std::string> &bodies,
                const Obstacles                &obstacles);

  void
  declare_obstacle(dealii::ParameterHandler &prm);

  /// The entries of a `subsection Obstacle NAME`. Throws InputError.
  std::shared_ptr<const Obstacle>
  parse_obstacle(const dealii::ParameterHandler &prm, const std::string &name);
} // namespace lamella

#endif
