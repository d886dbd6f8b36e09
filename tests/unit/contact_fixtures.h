// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_contact_fixtures_h
#define lamella_tests_unit_contact_fixtures_h

#include "fixtures.h"

#include <lamella/contact/gap_constraints.h>
#include <lamella/shape/shapes.h>

#include <random>
#include <string>
#include <vector>

namespace lamella
{
  const EngineeringConstants soft = EngineeringConstants::isotropic(10., 0.25);
  const OrientedMaterial     oriented_material{"material", 0.};

  /// As the scene's axes, and turned anyhow.
  const std::vector<Placement> placements{
    Placement(),
    Placement::from_directions({0.3, -2., 0.1},
                               dealii::Point<3>(1., 2., 0.5),
                               dealii::Point<3>(0., 0.2, 1.))};

  inline Theory
  taylor(const unsigned int degree)
  {
    Theory theory;
    theory.kind  = Theory::Kind::TE;
    theory.order = degree;
    return theory;
  }

  inline std::unique_ptr<Body>
  make_beam(const std::string  &name,
            const SectionShape &shape,
            const Theory       &theory,
            const double        length,
            const unsigned int  elements,
            const Placement    &placement = Placement(),
            const Material     &material  = soft)
  {
    return std::make_unique<Beam>(
      name,
      make_section(make_section_mesh(shape, {{"material", material}}), theory),
      make_axis(length, elements),
      placement);
  }

  /// Upside down, its origin at @p origin: x and z change their signs.
  inline Placement
  upside_down(const Placement &placement, const dealii::Point<3> &origin)
  {
    return Placement::from_directions(placement.to_scene(origin),
                                      placement.axes[1],
                                      -placement.axes[2]);
  }

  /// Any displacement field of @p body.
  inline Vector
  any_displacement(const Body &body, const unsigned int seed = 7)
  {
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> number(-1., 1.);
    Vector                                 u(body.n_dofs());
    for (double &value : u)
      value = number(random);
    return u;
  }

  inline dealii::Tensor<1, 3>
  displacement(const Body &body, const Location &location, const Vector &u)
  {
    const auto           rows = body.rows({location}, undisplaced)[0];
    dealii::Tensor<1, 3> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = rows[c](u);
    return result;
  }

  inline ContactPair
  pair_of(const std::string   &first,
          const std::string   &second,
          const Discretization discretization)
  {
    ContactPair contact;
    contact.name           = "middle";
    contact.first          = {0, Region::Kind::surface, first, {}};
    contact.second         = {1, Region::Kind::surface, second, {}};
    contact.discretization = discretization;
    contact.enforcement    = Enforcement::penalty;
    contact.penalty        = {PenaltyKind::per_area, 1.};
    return contact;
  }

  inline BlockVector
  zero(const Bodies &bodies)
  {
    std::vector<dealii::types::global_dof_index> sizes;
    for (const auto &body : bodies)
      sizes.push_back(body->n_dofs());
    return BlockVector(sizes);
  }

  /// For two blocks, the first above: walls at left and start, a floor, and a
  /// press that moves down by @p distance.
  inline std::vector<Support>
  walls_and_press(const double distance)
  {
    using Kind = Region::Kind;
    std::vector<Region> still{{1, Kind::surface, "bottom", {}}};
    for (const unsigned int body : {0, 1})
      for (const char *surface : {"left", "start"})
        still.push_back({body, Kind::surface, surface, {}});
    return {{"walls", still, {}, 0.},
            {"press", {{0, Kind::surface, "top", {}}}, {}, -distance}};
  }
} // namespace lamella

#endif
