// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/conditions/isostatic_support.h>
#include <lamella/conditions/parameters.h>
#include <lamella/contact/parameters.h>
#include <lamella/material/parameters.h>
#include <lamella/scene/subsection_kinds.h>
#include <lamella/scene/theory_notes.h>
#include <lamella/shape/parameters.h>

#include <filesystem>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    // ---- materials, sections and bodies

    void
    resolve_material(SceneReading      &reading,
                     const std::string &name,
                     const Entries     &in)
    {
      Scene &scene          = reading.scene;
      scene.materials[name] = MaterialParameters::parse(in, scene.units);
      // The half-cylinders of the Hertz paper have no unit.
      if (in["Library"].text() != "hertz-200")
        for (const std::string &warning :
             material_warnings(name, scene.materials[name], scene.units))
          scene.warnings.push_back(warning);
    }



    void
    resolve_section(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in)
    {
      const SectionShape shape =
        SectionParameters::parse(in,
                                 reading.names.at("Materials"),
                                 reading.folder);
      // The resolved scene has to find the mesh from its own folder.
      if (const auto *file = std::get_if<SectionFile>(&shape))
        reading.prm.set("File", std::filesystem::absolute(file->path).string());
      reading.scene.sections[name] = shape;
      reading.scene.divisions[name] =
        in["Cells divided"].whole(0, SectionParameters::max_divisions);
      reading.scene.corner_layers[name] =
        in["Corner layers"].whole(0, SectionParameters::max_corner_layers);
    }



    void
    resolve_body(SceneReading      &reading,
                 const std::string &name,
                 const Entries &)
    {
      reading.scene.bodies.push_back(BodyParameters::parse(
        reading.prm, name, reading.theory, reading.names.at("Sections")));
    }



    void
    add_notes_on_choices(Scene &scene)
    {
      const std::vector<std::string> notes = notes_on_choices(scene);
      scene.warnings.insert(scene.warnings.end(), notes.begin(), notes.end());
    }



    // ---- supports, loads, obstacles and contacts

    /// Declares the entries of @p Parameters, and References.
    template <typename Parameters>
    void
    declare_with_references(ParameterHandler &prm)
    {
      Parameters::declare(prm);
      prm.declare_entry("References",
                        "",
                        Anything(),
                        "Reference values to print, quantity: value: source, "
                        "with '|' between. Quantities: fx, fy, fz.");
    }



    std::vector<Reference>
    references_of_resultant(const Entries &in)
    {
      return parse_references(in["References"], {"fx", "fy", "fz"});
    }



    void
    resolve_support(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in)
    {
      Support support =
        SupportParameters::parse(in, name, reading.names.at("Bodies"));
      support.history =
        HistoryParameters::parse(in, reading.scene.solve.load_factors);
      reading.scene.supports.push_back(support);
      reading.scene.support_references[name] = references_of_resultant(in);
    }



    /// Adds the supports of `Isostatic support` of bodies.
    void
    add_isostatic_supports(Scene &scene)
    {
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          if (!scene.bodies[b].is_held)
            continue;
          Support support;
          support.name      = name_of_isostatic_support(scene.bodies[b].name);
          support.isostatic = IsostaticSupport{b};
          if (!scene.support_references
                 .emplace(support.name, std::vector<Reference>())
                 .second)
            throw InputError("Support " + support.name,
                             "",
                             "scene.name-of-isostatic-support: the isostatic "
                             "support of body '" +
                               scene.bodies[b].name + "' already has this name",
                             "Rename this support.");
          scene.supports.push_back(support);
        }
    }



    void
    resolve_load(SceneReading      &reading,
                 const std::string &name,
                 const Entries     &in)
    {
      Load load = LoadParameters::parse(in, name, reading.names.at("Bodies"));
      load.history =
        HistoryParameters::parse(in, reading.scene.solve.load_factors);
      if (load.history > 0 && !load.temperature.empty())
        in["Factors"].refuse("scene.temperature-with-factors: a Temperature "
                             "acts fully in each load step and has no factors",
                             "Remove Factors.");
      reading.scene.loads.push_back(load);
      if (name == weight_load_name && reading.scene.gravity.norm() > 0.)
        in.refuse("scene.load-named-gravity: the name Gravity is that of the "
                  "load by the weight of the bodies",
                  "Rename this load.");
    }



    void
    resolve_obstacle(SceneReading      &reading,
                     const std::string &name,
                     const Entries     &in)
    {
      // Obstacles under a Force are bodies after those of the scene.
      unsigned int body = reading.names.at("Bodies").size();
      for (const auto &before : reading.scene.obstacles)
        body += before->body.has_value();
      const auto obstacle = ObstacleParameters::parse(in, name, body);
      obstacle->history =
        HistoryParameters::parse(in, reading.scene.solve.load_factors);
      reading.scene.obstacles.push_back(obstacle);
    }



    /// Returns whether @p one and @p other, of the same surfaces, may have rows
    /// at the same places. Edges and faces differ, as do the two sides.
    bool
    share_rows(const ContactPair &one, const ContactPair &other)
    {
      const auto body_of_edges = [](const ContactPair &contact) {
        if (contact.discretization != Discretization::edge_to_surface)
          return dealii::numbers::invalid_unsigned_int;
        return contact.slave_side == SlaveSide::second ? contact.second.body :
                                                         contact.first.body;
      };
      return body_of_edges(one) == body_of_edges(other);
    }



    /// Throws InputError if two @p contacts pair the same surfaces.
    void
    check_contact_is_new(const std::vector<ContactPair> &contacts)
    {
      const auto same = [](const Region &a, const Region &b) {
        return a.body == b.body && a.surface == b.surface;
      };
      const ContactPair &last = contacts.back();
      for (auto other = contacts.begin(); other + 1 != contacts.end(); ++other)
        if (other->obstacle == last.obstacle && share_rows(*other, last) &&
            ((same(other->first, last.first) &&
              (last.obstacle != nullptr || same(other->second, last.second))) ||
             (last.obstacle == nullptr && same(other->first, last.second) &&
              same(other->second, last.first))))
          throw InputError(
            "Contact " + last.name,
            "",
            "scene.repeated-contact: this contact repeats Contact " +
              other->name,
            "Remove one of the two contacts.");
    }



    void
    resolve_contact(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in)
    {
      Scene &scene = reading.scene;
      scene.contacts.push_back(ContactParameters::parse(
        in, name, reading.names.at("Bodies"), scene.obstacles));
      check_contact_is_new(scene.contacts);
      scene.contact_references[name] = references_of_resultant(in);
    }



    // ---- probes, lines, cuts and measures

    /// Appends what @p Parameters read to the @p list of the scene.
    template <typename Parameters, auto list>
    void
    resolve_on_bodies(SceneReading      &reading,
                      const std::string &name,
                      const Entries     &in)
    {
      (reading.scene.*list)
        .push_back(Parameters::parse(in, name, reading.names.at("Bodies")));
    }



    void
    resolve_measure(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in)
    {
      reading.scene.measures.push_back(
        MeasureParameters::parse(in, name, reading.scene.probes));
    }
  } // namespace



  const std::vector<SubsectionKind> &
  subsection_kinds()
  {
    static const std::vector<SubsectionKind> all{
      {"Materials", "Material", MaterialParameters::declare, resolve_material},
      {"Sections", "Section", SectionParameters::declare, resolve_section},
      {"Bodies",
       "Body",
       BodyParameters::declare,
       resolve_body,
       add_notes_on_choices},
      {"Supports",
       "Support",
       declare_with_references<SupportParameters>,
       resolve_support,
       add_isostatic_supports},
      {"Loads", "Load", LoadParameters::declare, resolve_load},
      {"Obstacles", "Obstacle", ObstacleParameters::declare, resolve_obstacle},
      {"Contacts",
       "Contact",
       declare_with_references<ContactParameters>,
       resolve_contact},
      {"Probes",
       "Probe",
       ProbeParameters::declare,
       resolve_on_bodies<ProbeParameters, &Scene::probes>},
      {"Lines",
       "Line",
       LineParameters::declare,
       resolve_on_bodies<LineParameters, &Scene::lines>},
      {"Cuts",
       "Cut",
       CutParameters::declare,
       resolve_on_bodies<CutParameters, &Scene::cuts>},
      {"Measures", "Measure", MeasureParameters::declare, resolve_measure}};
    return all;
  }
} // namespace lamella
