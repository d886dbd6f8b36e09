// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/enrichment.h>

#include <algorithm>

namespace lamella
{
  namespace
  {
    using Kind = Theory::Kind;

    /// Wave numbers of what stands in for theories without responses, and what
    /// SV-N gets more; the least that is worth while.
    constexpr unsigned int many_waves = 10, more_waves = 4, least_waves = 6;
    constexpr unsigned int highest_degree = 8, most_waves = 40;

    bool
    is_solid(const BodyDescription &body)
    {
      return body.theory.kind == Kind::solid;
    }



    /// All theories along the axis of @p body.
    std::vector<Theory *>
    theories_of(BodyDescription &body)
    {
      std::vector<Theory *> theories{&body.theory};
      for (Theory &theory : body.pieces.theories)
        theories.push_back(&theory);
      return theories;
    }



    void
    halve_elements(AxisMesh &axis)
    {
      for (unsigned int &n : axis.elements)
        n *= 2;
    }



    bool
    is_poorer_than_sv(const Theory &theory)
    {
      return theory.kind == Kind::EBBT || theory.kind == Kind::TBT ||
             theory.kind == Kind::TE;
    }



    void
    enrich_fields(BodyDescription &body)
    {
      // Pieces of plain SV beside LE say by hand where responses are wanted.
      for (Theory *theory : theories_of(body))
        if (is_poorer_than_sv(*theory))
          {
            const unsigned int order = theory->section_order;
            *theory                  = Theory();
            theory->kind             = Kind::SV;
            theory->order            = many_waves;
            theory->section_order    = order;
            // B2 and B3 with assumed shear strains are for theories that lock.
            body.axis.degree        = 3;
            body.axis.assumed_shear = false;
          }
        else if (theory->kind == Kind::SV)
          theory->order = theory->order < least_waves ?
                            least_waves :
                            std::min(theory->order + more_waves, most_waves);
    }



    /// Makes SV-10 of the LE-N that would have @p dofs DoFs, if these are more
    /// than @p most: the same fields of the section, those that the scene
    /// wants.
    void
    keep_small(BodyDescription &body, const double dofs, const double most)
    {
      if (body.theory.kind != Kind::LE || !body.pieces.empty() || dofs <= most)
        return;
      body.theory.kind          = Kind::SV;
      body.theory.section_order = body.theory.order;
      body.theory.order         = many_waves;
    }



    void
    enrich_section(BodyDescription &body, const double dofs, const double most)
    {
      if (is_solid(body))
        {
          if (body.theory.order == 1)
            body.theory.order = 2;
          else
            ++body.refinement.everywhere;
          return;
        }
      const double growth = (body.theory.order + 1.) / body.theory.order;
      keep_small(body, dofs * growth * growth, most);
      for (Theory *theory : theories_of(body))
        {
          if (theory->kind == Kind::LE)
            theory->order = std::min(theory->order + 1, highest_degree);
          theory->section_order =
            std::min(theory->section_order + 1, highest_degree);
        }
    }
  } // namespace



  bool
  has_source(const Scene &scene, const Source source)
  {
    const auto any = [&scene](const auto &is) {
      return std::any_of(scene.bodies.begin(), scene.bodies.end(), is);
    };
    switch (source)
      {
        case Source::axis:
          return any([](const auto &body) { return !is_solid(body); });
        case Source::fields:
          return any([](const BodyDescription &body) {
            return is_poorer_than_sv(body.theory) ||
                   body.theory.kind == Kind::SV;
          });
        case Source::section:
          return any(
            [](const auto &body) { return !is_poorer_than_sv(body.theory); });
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
  enriched(const Scene                     &scene,
           const Source                     source,
           const std::vector<unsigned int> &dofs,
           const double                     most_dofs)
  {
    Scene result = scene;
    for (unsigned int b = 0; b < result.bodies.size(); ++b)
      {
        BodyDescription &body = result.bodies[b];
        if (source == Source::axis && !is_solid(body))
          {
            keep_small(body, 2. * dofs[b], most_dofs);
            halve_elements(body.axis);
          }
        else if (source == Source::fields && !is_solid(body))
          enrich_fields(body);
        else if (source == Source::section)
          enrich_section(body, dofs[b], most_dofs);
      }
    if (source == Source::contact)
      for (ContactPair &contact : result.contacts)
        contact.enforcement = Enforcement::exact;
    return result;
  }



  Scene
  for_estimates(Scene scene)
  {
    scene.solve.load_factors = {scene.solve.load_factors.back()};
    scene.solve.strategy     = Strategy::condensed;
    scene.lines.clear();
    scene.cuts.clear();
    scene.write_vtu = false;
    return scene;
  }
} // namespace lamella
