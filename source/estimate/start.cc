// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/beam.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/start.h>

#include <algorithm>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// Ten equal elements, as where a scene says nothing of the axis, for
    /// bodies that are @p touched_all_along and would grade themselves: graded
    /// to a contact that is everywhere they would be fine everywhere. Bodies
    /// whose nodes a contact pairs go together.
    void
    begin_with_equal_elements(Scene            &scene,
                              std::vector<bool> touched_all_along,
                              const PlanRules  &rules)
    {
      for (const ContactPair &contact : scene.contacts)
        if (may_pair_nodes(contact))
          {
            const unsigned int one   = contact.first.body,
                               other = contact.second.body;
            const bool both          = touched_all_along[one] &&
                              touched_all_along[other] &&
                              scene.bodies[one].axis.fineness > 0. &&
                              scene.bodies[other].axis.fineness > 0.;
            touched_all_along[one] = touched_all_along[other] = both;
          }
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (AxisMesh &axis = scene.bodies[b].axis;
            touched_all_along[b] && axis.fineness > 0.)
          {
            axis.fineness = 0.;
            axis.elements = {rules.equal_elements};
            axis.breaks.clear();
          }
    }



    bool
    is_assumed(const Scene &scene, const unsigned int body)
    {
      return scene.goals.theory_is_assumed &&
             scene.bodies[body].theory.is_of_solutions() &&
             scene.bodies[body].theory.order > 0 &&
             scene.bodies[body].pieces.empty();
    }
  } // namespace



  Scene
  start_of(Scene scene, const PlanRules &rules)
  {
    if (!scene.goals.theory_is_assumed || scene.contacts.empty())
      return scene;
    Scene plain = scene;
    for (unsigned int b = 0; b < plain.bodies.size(); ++b)
      if (is_assumed(scene, b))
        plain.bodies[b].theory = Theory::taylor(1);
    std::ostream                nowhere(nullptr);
    const Simulation            model(plain, nowhere);
    const std::vector<BodySize> sizes = sizes_of(model.model());
    std::vector<bool>           touched_all_along(scene.bodies.size(), false);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (is_assumed(scene, b))
        {
          touched_all_along[b] = sizes[b].touched > rules.long_contact;
          if (touched_all_along[b] ||
              dofs_of_layers(sizes[b], 2) <= rules.cheap_dofs)
            scene.bodies[b].theory = Theory::layerwise(1);
        }
    begin_with_equal_elements(scene, touched_all_along, rules);
    return scene;
  }



  bool
  begin_lower(Scene &scene, const BuiltScene &model)
  {
    const std::vector<const Beam *> beams =
      beams_of(model.structure().bodies());
    bool any = false;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (is_assumed(scene, b))
        {
          const Beam &body = *beams[b];
          if (body.n_dofs() < body.axis().n_nodes() * body.section().n_fields())
            continue;
          scene.bodies[b].theory = Theory::layerwise(1);
          any                    = true;
        }
    return any;
  }
} // namespace lamella
