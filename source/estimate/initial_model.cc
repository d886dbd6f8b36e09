// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/beam.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/tolerance_run.h>

#include <algorithm>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// Sets equal elements, as by default, for bodies whose plan has them:
    /// graded to a contact along the whole body, they would be fine everywhere.
    /// Bodies at a roller are excluded: equal elements miss its one contact
    /// place. Bodies whose nodes a contact pairs are treated alike.
    void
    begin_with_equal_elements(Scene &scene, std::vector<unsigned int> elements)
    {
      for (const ContactPair &contact : scene.contacts)
        if (may_pair_nodes(contact))
          {
            const unsigned int one   = contact.first.body,
                               other = contact.second.body;
            const unsigned int most  = std::max(elements[one], elements[other]);
            elements[one]            = elements[other] =
              elements[one] > 0 && elements[other] > 0 ? most : 0;
          }
        else if (contact.obstacle != nullptr &&
                 contact.obstacle->shape == Obstacle::Shape::cylinder)
          elements[contact.first.body] = 0;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (AxisMesh &axis = scene.bodies[b].axis; elements[b] > 0)
          {
            axis.refinement_factor = 0.;
            axis.elements          = {elements[b]};
            axis.breaks.clear();
          }
    }



    bool
    is_assumed(const Scene &scene, const unsigned int body)
    {
      return scene.goals.theory_is_default &&
             scene.bodies[body].theory.has_responses() &&
             scene.bodies[body].pieces.empty();
    }
  } // namespace



  Scene
  initial_model(Scene                     scene,
                std::vector<std::string> *why,
                const PlanRules          &rules)
  {
    if (!scene.goals.theory_is_default || scene.contacts.empty())
      return scene;
    Scene plain = scene;
    for (unsigned int b = 0; b < plain.bodies.size(); ++b)
      if (is_assumed(scene, b))
        plain.bodies[b].theory = Theory::taylor(1);
    std::ostream                nowhere(nullptr);
    const Simulation            model(plain, nowhere);
    const std::vector<BodySize> sizes = sizes_of(model.model());
    std::vector<unsigned int>   elements;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        PlanInput facts;
        facts.size         = sizes[b];
        facts.theory       = scene.bodies[b].theory;
        facts.is_assumed   = is_assumed(scene, b);
        facts.has_contacts = true;
        facts.is_graded_automatically =
          scene.goals.axes_are_default.count(scene.bodies[b].name) > 0;
        facts.has_pieces       = !scene.bodies[b].pieces.empty();
        const BodyPlan start   = plan(facts, rules);
        scene.bodies[b].theory = start.theory;
        if (why != nullptr && !start.theory_reason.empty())
          why->push_back("Body " + scene.bodies[b].name + " begins with " +
                         start.theory.name() + ": " + start.theory_reason);
        elements.push_back(start.equal_elements);
      }
    begin_with_equal_elements(scene, elements);
    return scene;
  }



  bool
  start_with_layerwise(Scene            &scene,
                       const BuiltScene &model,
                       const PlanRules  &rules)
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
          scene.bodies[b].theory = Theory::layerwise(rules.first_degree);
          any                    = true;
        }
    return any;
  }



  Scene
  with_min_degree(Scene scene, const PlanRules &rules)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.is_layerwise() && body.pieces.empty())
        body.theory.order = std::max(body.theory.order, rules.first_degree);
    return scene;
  }
} // namespace lamella
