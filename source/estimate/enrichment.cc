// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/beam.h>
#include <lamella/estimate/enrichment.h>

#include <algorithm>
#include <set>

namespace lamella
{
  namespace
  {
    /// Returns all theories along the axis of @p body.
    std::vector<Theory *>
    theories_of(BodyDescription &body)
    {
      std::vector<Theory *> theories{&body.theory};
      for (Theory &theory : body.pieces.theories)
        theories.push_back(&theory);
      return theories;
    }



    void
    enrich_fields(BodyDescription &body,
                  const BodySize  &size,
                  const PlanRules &rules)
    {
      const bool layers_are_cheap = size.nodes > 0 && body.pieces.empty() &&
                                    !reason_for_layerwise(size, rules).empty();
      // Pieces of plain SV beside LE are a choice of the user.
      for (Theory *theory : theories_of(body))
        if (theory->is_single_layer() ||
            (theory->is_saint_venant() && theory->order < rules.min_waves))
          {
            const unsigned int order = theory->section_order,
                               waves = theory->is_saint_venant() ?
                                         rules.min_waves :
                                         rules.substitute_waves;
            *theory                  = layers_are_cheap ?
                                         Theory::layerwise(2) :
                                         Theory::make_saint_venant(waves, order);
            theory->section_order    = order;
            // B2 and B3 with assumed shear strains are for theories that lock.
            body.axis.degree        = 3;
            body.axis.assumed_shear = false;
          }
        else if (theory->is_saint_venant())
          theory->order =
            std::min(theory->order + rules.wave_increment, rules.max_waves);
    }



    /// Replaces the theory of @p body by LE-@p degree.
    void
    make_layerwise(BodyDescription &body, const unsigned int degree)
    {
      const unsigned int order  = body.theory.section_order;
      body.theory               = Theory::layerwise(degree);
      body.theory.section_order = order;
    }



    /// Replaces LE-N of @p size by SV-10 with the same section functions if its
    /// DoFs, @p times as many as now, are too many, and may_have_responses().
    void
    limit_size(BodyDescription &body,
               const BodySize  &size,
               const double     times,
               const PlanRules &rules)
    {
      if (!may_have_responses(body, size, rules) ||
          times * size.dofs <= rules.max_layerwise_dofs)
        return;
      body.theory = body.theory.to_saint_venant(rules.substitute_waves);
    }



    /// Returns whether the section of @p body has corners to refine.
    bool
    may_have_layers(const Scene           &scene,
                    const BodyDescription &body,
                    const BodySize        &size,
                    const PlanRules       &rules)
    {
      const auto known = scene.corner_layers.find(body.section);
      return size.corners > 0 && (known == scene.corner_layers.end() ||
                                  known->second < rules.max_corner_layers);
    }



    /// Returns whether cells of @p body's section are divided at fixed degree.
    bool
    keeps_degree(const Scene           &scene,
                 const BodyDescription &body,
                 const BodySize        &size,
                 const PlanRules       &rules)
    {
      const unsigned int most   = may_have_layers(scene, body, size, rules) ?
                                    rules.corner_degree :
                                    rules.highest_degree;
      const Theory      &theory = body.theory;
      return (theory.is_layerwise() && theory.order >= most) ||
             (theory.is_saint_venant() && theory.section_order >= most);
    }



    void
    enrich_section(BodyDescription &body,
                   const BodySize  &size,
                   const bool       keeps_degree,
                   const PlanRules &rules)
    {
      if (body.theory.is_solid())
        {
          if (body.theory.order == 1)
            body.theory.order = 2;
          else
            ++body.refinement.everywhere;
          return;
        }
      const double growth =
        keeps_degree ? 2. : (body.theory.order + 1.) / body.theory.order;
      limit_size(body, size, growth * growth, rules);
      if (keeps_degree)
        return;
      const auto higher = [&rules](const unsigned int degree) {
        return std::max(degree, std::min(degree + 1, rules.highest_degree));
      };
      for (Theory *theory : theories_of(body))
        {
          if (theory->is_layerwise())
            theory->order = higher(theory->order);
          theory->section_order = higher(theory->section_order);
        }
    }



    /// Divides the sections of bodies that keep their degrees: at their corners
    /// if there are any, else all cells.
    void
    divide_sections(Scene                       &result,
                    const Scene                 &scene,
                    const std::vector<BodySize> &sizes,
                    const PlanRules             &rules)
    {
      std::set<std::string> at_corners, everywhere;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (const BodyDescription &body = scene.bodies[b];
            keeps_degree(scene, body, sizes[b], rules))
          (may_have_layers(scene, body, sizes[b], rules) ? at_corners :
                                                           everywhere)
            .insert(body.section);
      for (const std::string &section : at_corners)
        ++result.corner_layers[section];
      for (const std::string &section : everywhere)
        ++result.divisions[section];
    }



    /// Returns whether a support acts on a side of body number @p body.
    bool
    is_held_at_side(const std::vector<Support> &supports,
                    const unsigned int          body)
    {
      for (const Support &support : supports)
        for (const Region &region : support.on)
          if (region.body == body && !region.surface.empty() &&
              region.surface != "start" && region.surface != "end" &&
              region.surface != "ends")
            return true;
      return false;
    }



    /// Returns the share of the length of the beam @p body with gap rows.
    double
    loaded_share(const BuiltScene  &model,
                 const Beam        &whole,
                 const unsigned int body)
    {
      std::set<unsigned int> nodes;
      for (const ContactInterface &contact : model.interfaces())
        for (const GapConstraint &row : contact.rows)
          for (const BodyFunctional &part : row.parts)
            if (part.body == body)
              for (const auto &entry : part.row.entries())
                nodes.insert(whole.dofs().node_of(entry.first));
      const std::vector<double> weights = whole.axis().node_weights();
      double                    length  = 0.;
      for (const unsigned int node : nodes)
        length += weights[node];
      return length / whole.axis().length();
    }
  } // namespace



  std::vector<BodySize>
  sizes_of(const BuiltScene &model)
  {
    const Bodies                   &bodies = model.structure().bodies();
    const std::vector<const Beam *> beams  = beams_of(bodies);
    std::vector<BodySize>           sizes;
    for (unsigned int b = 0; b < model.scene().bodies.size(); ++b)
      {
        BodySize &size = sizes.emplace_back();
        size.dofs      = bodies[b]->n_dofs();
        size.constrained_along_axis =
          is_constrained_along_axis(model.scene().supports, b);
        if (const Beam *const beam = beams[b])
          {
            size.nodes           = beam->axis().n_nodes();
            size.fields          = beam->section().n_fields();
            size.cells           = beam->section().n_cells();
            size.corners         = n_corners(*beam);
            size.loaded          = loaded_share(model, *beam, b);
            size.is_held_at_side = is_held_at_side(model.scene().supports, b);
            size.slenderness =
              beam->axis().length() / beam->section().extents().second;
          }
      }
    return sizes;
  }



  bool
  may_have_responses(const BodyDescription &body,
                     const BodySize        &size,
                     const PlanRules       &rules)
  {
    return body.theory.is_layerwise() && body.pieces.empty() &&
           !size.constrained_along_axis && !size.is_held_at_side &&
           size.loaded <= rules.max_contact_share &&
           size.fields > rules.min_gain * rules.fields_of_responses;
  }



  bool
  has_source(const Scene &scene, const Source source)
  {
    const auto any = [&scene](const auto &is) {
      return std::any_of(scene.bodies.begin(), scene.bodies.end(), is);
    };
    switch (source)
      {
        case Source::axis:
          return any([](const auto &body) { return !body.theory.is_solid(); });
        case Source::fields:
          return any([](const BodyDescription &body) {
            return body.theory.is_single_layer() ||
                   body.theory.is_saint_venant();
          });
        case Source::section:
          return any(
            [](const auto &body) { return !body.theory.is_single_layer(); });
        case Source::path:
          return first_with_friction(scene) != nullptr;
        default:
          return std::any_of(scene.contacts.begin(),
                             scene.contacts.end(),
                             [](const ContactPair &contact) {
                               return contact.enforcement ==
                                      Enforcement::penalty;
                             });
      }
  }



  Scene
  enriched(const Scene                 &scene,
           const Source                 source,
           const std::vector<BodySize> &sizes,
           const PlanRules             &rules)
  {
    Scene result = scene;
    for (unsigned int b = 0; b < result.bodies.size(); ++b)
      {
        BodyDescription &body = result.bodies[b];
        if (source == Source::axis && !body.theory.is_solid())
          {
            limit_size(body, sizes[b], 2., rules);
            for (unsigned int &n : body.axis.elements)
              n *= 2;
          }
        else if (source == Source::fields && !body.theory.is_solid())
          enrich_fields(body, sizes[b], rules);
        else if (source == Source::section)
          enrich_section(body,
                         sizes[b],
                         keeps_degree(scene, body, sizes[b], rules),
                         rules);
      }
    if (source == Source::section)
      divide_sections(result, scene, sizes, rules);
    if (source == Source::path)
      for (unsigned int &n : result.solve.substeps.each)
        n *= 2;
    if (source == Source::contact)
      for (ContactPair &contact : result.contacts)
        contact.enforcement = Enforcement::exact;
    return result;
  }



  Scene
  with_enriched_section(Scene scene, const unsigned int degree)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.is_layerwise() && body.pieces.empty())
        ++body.theory.order;
      else
        {
          make_layerwise(body, degree);
          // B2 and B3 with assumed shear strains are for theories that lock.
          body.axis.degree        = 3;
          body.axis.assumed_shear = false;
        }
    return scene;
  }



  Scene
  with_first_degree(Scene scene)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.describes_contraction() && !body.theory.is_solid())
        make_layerwise(body, 1);
    return scene;
  }



  namespace
  {
    /// Returns the number of modes among which mode @p number of another model
    /// is found, since modes of close frequencies may have another order.
    unsigned int
    number_for_order(const unsigned int number)
    {
      return number == 0 ? 0 : number + std::max(2u, number / 2);
    }



    /// Returns the request of the modes that are goals of @p run, the lowest
    /// ones also for a range, and with the stresses if the run has them.
    FindRequest
    modes_of_goals(const Simulation &run)
    {
      const GoalParameters &goals     = run.model().scene().goals;
      const auto            all       = goals.modes_as_goals ?
                                          ResultNumbers(run.results()).of_modes() :
                                          goals.quantities;
      unsigned int          n_natural = 0, n_buckling = 0;
      for (const NamedQuantity &goal : all)
        {
          unsigned int &n = goal.column == "factor" ? n_buckling : n_natural;
          n = std::max(n, number_for_order(goal.number_of_mode()));
        }
      FindRequest find;
      if (n_natural > 0)
        find.modes = {n_natural,
                      {},
                      run.results().last().checks.beyond.is_in_range(),
                      true};
      find.n_buckling_modes = n_buckling;
      return find;
    }
  } // namespace



  Scene
  for_estimates(const Simulation &run)
  {
    Scene scene          = run.model().with_automatic_contacts();
    scene.solve.strategy = Strategy::condensed;
    // With large rotations each load step starts from the one before.
    const bool is_large = scene.solve.rotations == Rotations::large;
    if (!is_large && first_with_friction(scene) == nullptr)
      scene.solve.load_factors = {scene.solve.load_factors.back()};
    else if (!is_large)
      for (const StepResults &step : run.results().steps)
        scene.solve.substeps.each.push_back(step.substeps);
    scene.lines.clear();
    scene.cuts.clear();
    scene.strength.criteria.clear();
    scene.find      = modes_of_goals(run);
    scene.write_vtu = false;
    return scene;
  }
} // namespace lamella
