// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/beam.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/start.h>

#include <algorithm>
#include <ostream>
#include <set>

namespace lamella
{
  namespace
  {
    const Beam *
    beam(const Simulation &model, const unsigned int body)
    {
      return dynamic_cast<const Beam *>(
        model.solved_structure().bodies()[body].get());
    }



    /// The share of the length of the beam @p body that gap rows see.
    double
    touched_share(const Simulation &model, const unsigned int body)
    {
      const Beam            &whole = *beam(model, body);
      std::set<unsigned int> nodes;
      for (const ContactInterface &contact : model.interfaces())
        for (const GapRow &row : contact.rows)
          for (const BodyRow &part : row.parts)
            if (part.body == body)
              for (const auto &entry : part.row.entries())
                nodes.insert(whole.dofs().node_of(entry.first));
      const std::vector<double> weights = whole.axis().node_weights();
      double                    length  = 0.;
      for (const unsigned int node : nodes)
        length += weights[node];
      return length / whole.axis().length();
    }



    void
    make_lower(BodyDescription &body)
    {
      body.theory       = Theory();
      body.theory.kind  = Theory::Kind::LE;
      body.theory.order = 1;
    }



    bool
    is_assumed(const Scene &scene, const unsigned int body)
    {
      return scene.goals.theory_is_assumed &&
             scene.bodies[body].theory.kind == Theory::Kind::SV &&
             scene.bodies[body].theory.order > 0 &&
             scene.bodies[body].pieces.empty();
    }
  } // namespace



  Scene
  start_of(Scene scene)
  {
    if (!scene.goals.theory_is_assumed || scene.contacts.empty())
      return scene;
    Scene plain = scene;
    for (unsigned int b = 0; b < plain.bodies.size(); ++b)
      if (is_assumed(scene, b))
        {
          plain.bodies[b].theory       = Theory();
          plain.bodies[b].theory.kind  = Theory::Kind::TE;
          plain.bodies[b].theory.order = 1;
        }
    std::ostream                nowhere(nullptr);
    const Simulation            model(plain, nowhere);
    const std::vector<BodySize> sizes = sizes_of(model);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (is_assumed(scene, b) && (dofs_of_layers(sizes[b], 2) <= cheap_dofs ||
                                   touched_share(model, b) > long_contact))
        make_lower(scene.bodies[b]);
    return scene;
  }



  bool
  begin_lower(Scene &scene, const Simulation &model)
  {
    bool any = false;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (is_assumed(scene, b))
        {
          const Beam &body = *beam(model, b);
          if (body.n_dofs() < body.axis().n_nodes() * body.section().n_fields())
            continue;
          make_lower(scene.bodies[b]);
          any = true;
        }
    return any;
  }
} // namespace lamella
