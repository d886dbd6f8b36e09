// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads of whole bodies: heat and weight (load.h).

#include <lamella/conditions/load.h>

#include <map>
#include <memory>

namespace lamella
{
  using namespace dealii;

  void
  apply_temperatures(const std::vector<Load> &loads, const Bodies &bodies)
  {
    std::map<unsigned int, std::string> heated;
    for (const Load &load : loads)
      if (!load.temperature.empty())
        {
          const Entry entry("Load " + load.name + "/Temperature",
                            load.temperature.text());
          const auto  change =
            std::make_shared<const Expression>(entry.text(), entry);
          const double value =
            change->is_constant() ? (*change)(Point<3>()) : 0.;
          const ScalarField field =
            change->is_constant() ?
              ScalarField([value](const Point<3> &) { return value; }) :
              ScalarField([change](const Point<3> &x) { return (*change)(x); });
          for (const Region &region : load.on)
            {
              const auto [other, is_new] =
                heated.emplace(region.body, load.name);
              if (!is_new)
                entry.refuse(
                  "conditions.two-temperatures: body '" +
                    bodies[region.body]->name() +
                    "' already has the Temperature of load " + other->second,
                  "Write one load with the sum of both temperatures.");
              bodies[region.body]->heat(field);
            }
        }
  }



  LoadResultant
  add_weight(const Tensor<1, 3> &acceleration,
             const Bodies       &bodies,
             BlockVector        &f)
  {
    LoadResultant result;
    result.name = weight_load_name;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Body &body = *bodies[b];
        Vector      own(body.n_dofs());
        body.add_weight(acceleration, own);
        f.block(b) += own;
        const std::vector<Vector> rigid = body.rigid_motions(undisplaced);
        Tensor<1, 3>              force, moment;
        for (unsigned int c = 0; c < 3; ++c)
          {
            force[c]  = own * rigid[c];
            moment[c] = own * rigid[3 + c];
          }
        result.force += force;
        result.moment += moment + cross_product_3d(body.center(), force);
      }
    return result;
  }
} // namespace lamella
