// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/parameters.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/beam.h>
#include <lamella/body/solid.h>
#include <lamella/body/solid_parameters.h>
#include <lamella/conditions/parameters.h>
#include <lamella/contact/parameters.h>
#include <lamella/material/parameters.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/size_check.h>
#include <lamella/shape/parameters.h>
#include <lamella/shape/properties.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    /// The lists of names that a scene begins with, and the subsection of each.
    const std::vector<std::pair<std::string, std::string>> &
    kinds()
    {
      static const std::vector<std::pair<std::string, std::string>> all{
        {"Materials", "Material"},
        {"Sections", "Section"},
        {"Bodies", "Body"},
        {"Supports", "Support"},
        {"Loads", "Load"},
        {"Obstacles", "Obstacle"},
        {"Contacts", "Contact"},
        {"Probes", "Probe"},
        {"Lines", "Line"},
        {"Cuts", "Cut"}};
      return all;
    }

    /// Names by list.
    using Names = std::map<std::string, std::vector<std::string>>;



    void
    declare_scene(ParameterHandler &prm)
    {
      prm.declare_entry("Title", "", Anything(), "Printed with the results.");
      prm.declare_entry("Units",
                        "none",
                        Anything(),
                        "m, N (stress in Pa) or mm, N (MPa) or none: labels "
                        "results and converts the built-in materials.");
      prm.declare_entry(
        "Theory",
        "LE-2",
        Anything(),
        "Of all bodies: EBBT, TBT (classical), TE-N (Taylor expansion of "
        "degree N over the whole section, N to 20), LE-N (layer-wise Lagrange "
        "expansion of degree N; LE-1, 2, 3 are L4, L9, L16), solid-N (no beams "
        "but hexahedra of degree N, 1 or 2, on the same meshes).");
      SolveParameters::declare(prm);
      prm.declare_entry(
        "Write VTU",
        "true",
        Anything(),
        "Whether to write the deformed bodies for ParaView: true "
        "or false.");
      for (const auto &[list, kind] : kinds())
        prm.declare_entry(list,
                          "",
                          Anything(),
                          "Names between commas; each has a subsection '" +
                            kind + " NAME'.");
    }



    void
    declare_body(ParameterHandler &prm)
    {
      prm.declare_entry("Section", "", Anything(), "A name of Sections.");
      prm.declare_entry("Origin",
                        "0, 0, 0",
                        Anything(),
                        "Scene position of the section's lower left corner (of "
                        "a mesh file: of its own origin) at the start of the "
                        "axis [length].");
      prm.declare_entry("Axis",
                        "0, 1, 0",
                        Anything(),
                        "Direction of the axis, the body's y.");
      prm.declare_entry("Up",
                        "0, 0, 1",
                        Anything(),
                        "Direction that the section's z leans towards.");
      prm.declare_entry("Length", "", Anything(), "Of the axis [length].");
      prm.declare_entry(
        "Stabilisation",
        "0",
        Anything(),
        "For a body that contact alone holds, e.g. a roller under a force: "
        "springs to the ground in its free rigid motions, of this share of its "
        "axial stiffness E A / L (1e-6, say), which are iterated out of the "
        "result. 0: none; a body that can move freely is an error.");
      prm.enter_subsection("Kinematics");
      TheoryParameters::declare(prm);
      AxisParameters::declare(prm);
      SolidParameters::declare(prm);
      prm.leave_subsection();
    }



    void
    declare_references(ParameterHandler &prm)
    {
      prm.declare_entry(
        "References",
        "",
        Anything(),
        "Values to print beside the resultant, quantity: value: "
        "source, between '|'. Quantities: fx, fy, fz.");
    }



    void
    declare_all(ParameterHandler &prm, const Names &names)
    {
      declare_scene(prm);
      for (const auto &[list, kind] : kinds())
        for (const std::string &name : names.at(list))
          {
            prm.enter_subsection(kind + " " + name);
            if (kind == "Material")
              MaterialParameters::declare(prm);
            else if (kind == "Section")
              SectionParameters::declare(prm);
            else if (kind == "Body")
              declare_body(prm);
            else if (kind == "Support")
              declare_support(prm);
            else if (kind == "Load")
              declare_load(prm);
            else if (kind == "Obstacle")
              declare_obstacle(prm);
            else if (kind == "Contact")
              declare_contact(prm);
            else if (kind == "Probe")
              declare_probe(prm);
            else if (kind == "Line")
              declare_line(prm);
            else if (kind == "Cut")
              declare_cut(prm);
            if (kind == "Support" || kind == "Contact")
              declare_references(prm);
            prm.leave_subsection();
          }
      prm.enter_subsection("Trade");
      TradeParameters::declare(prm);
      prm.leave_subsection();
    }



    /// The first pass.
    Names
    read_names(const SceneText &text)
    {
      static const std::regex form("[A-Za-z][A-Za-z0-9_-]*");
      ParameterHandler        prm;
      declare_scene(prm);
      text.check_declared(prm, /*top_level_only=*/true);
      text.fill(prm, /*top_level_only=*/true);
      Names names;
      for (const auto &[list, kind] : kinds())
        {
          names[list] = split(prm.get(list), ',');
          std::set<std::string> seen;
          for (const std::string &name : names[list])
            {
              const std::string entry = list + " = " + prm.get(list);
              if (!std::regex_match(name, form))
                throw InputError(
                  entry + ": '" + name +
                  "' is not a name. Names begin with a letter "
                  "and go on with letters, digits, '_' and '-'.");
              if (!seen.insert(name).second)
                throw InputError(entry + ": '" + name +
                                 "' stands there twice.");
            }
        }
      for (const std::string &name : names["Obstacles"])
        for (const std::string &body : names["Bodies"])
          if (name == body)
            throw InputError("Obstacles = " + prm.get("Obstacles") + ": '" +
                             name +
                             "' is the name of a body, too. Rename one of "
                             "the two.");
      for (const char *list : {"Materials", "Sections", "Bodies"})
        if (names[list].empty())
          throw InputError(std::string(list) +
                           " is empty: a scene needs at least one name there.");
      return names;
    }



    SectionShape
    parse_section(ParameterHandler               &prm,
                  const std::vector<std::string> &materials,
                  const std::string              &folder,
                  const std::string              &what)
    {
      const SectionShape shape =
        SectionParameters::parse(prm).shape(materials, folder, what);
      // The resolved scene must find the mesh from its own folder, too.
      if (const auto *file = std::get_if<SectionFile>(&shape))
        prm.set("File", std::filesystem::absolute(file->path).string());
      return shape;
    }



    BodyDescription
    parse_body(ParameterHandler               &prm,
               const std::string              &name,
               const std::string              &scene_theory,
               const std::vector<std::string> &sections)
    {
      const std::string what = "Body " + name;
      BodyDescription   body;
      body.name    = name;
      body.section = prm.get("Section");
      if (std::find(sections.begin(), sections.end(), body.section) ==
          sections.end())
        throw InputError(what + "/Section = " + body.section +
                         ": there is no such section. The nearest of Sections "
                         "is '" +
                         nearest_name(body.section, sections) + "'.");

      const std::string length = prm.get("Length");
      if (length.empty())
        throw InputError(what + "/Length is missing: give a positive length.");
      const double value = to_number(length, what + "/Length = " + length);
      if (!(value > 0.))
        throw InputError(what + "/Length = " + length + ": must be positive.");
      try
        {
          body.placement = Placement::from_directions(
            to_point(prm.get("Origin"), what + "/Origin"),
            to_point(prm.get("Axis"), what + "/Axis"),
            to_point(prm.get("Up"), what + "/Up"));
        }
      catch (const InputError &error)
        {
          const std::string message = error.what();
          throw InputError(message.compare(0, what.size(), what) == 0 ?
                             message :
                             what + ": " + message);
        }

      body.stabilisation.share =
        to_number(prm.get("Stabilisation"), what + "/Stabilisation");
      if (!(body.stabilisation.share >= 0. && body.stabilisation.share <= 1e-2))
        throw InputError(what + "/Stabilisation = " + prm.get("Stabilisation") +
                         ": must lie between 0 (none) and 0.01; 1e-6 holds a "
                         "body without changing the result.");

      prm.enter_subsection("Kinematics");
      body.theory = TheoryParameters::parse(prm).resolve(scene_theory,
                                                         what + "/Kinematics");
      body.axis = AxisParameters::parse(prm).mesh(value, what + "/Kinematics");
      if (body.theory.kind == Theory::Kind::EBBT && body.axis.degree != 3)
        throw InputError(what + "/Kinematics/Axis element = B" +
                         std::to_string(body.axis.degree + 1) +
                         ": EBBT needs B4, whose cubic deflections Kirchhoff's "
                         "constraint makes smooth from element to element. Use "
                         "B4, or TBT.");
      body.refinement =
        SolidParameters::parse(prm).refinement(body.placement,
                                               what + "/Kinematics");
      prm.leave_subsection();
      return body;
    }



    /// Throws InputError if the last of @p contacts pairs the same surfaces as
    /// another: their penalties would add up.
    void
    check_contact_is_new(const std::vector<ContactPair> &contacts)
    {
      const auto same = [](const Region &a, const Region &b) {
        return a.body == b.body && a.surface == b.surface;
      };
      const ContactPair &last = contacts.back();
      for (auto other = contacts.begin(); other + 1 != contacts.end(); ++other)
        if (other->obstacle == last.obstacle &&
            ((same(other->first, last.first) &&
              (last.obstacle != nullptr || same(other->second, last.second))) ||
             (last.obstacle == nullptr && same(other->first, last.second) &&
              same(other->second, last.first))))
          throw InputError("Contact " + last.name +
                           ": pairs the same surfaces as Contact " +
                           other->name + ". Keep one of the two.");
    }



    /// What low orders get wrong, in words.
    std::vector<std::string>
    warnings_of_orders(const std::vector<BodyDescription> &bodies)
    {
      std::vector<std::string> warnings;
      for (const BodyDescription &body : bodies)
        {
          if (body.theory.kind != Theory::Kind::solid && body.axis.degree < 3 &&
              !body.axis.assumed_shear)
            warnings.push_back(
              "body " + body.name + ": B" +
              std::to_string(body.axis.degree + 1) +
              " elements with full Shear strains are too stiff in bending "
              "where they are longer than the section is high (shear "
              "locking); use B4, or Shear strains = auto");
          if (body.theory.kind == Theory::Kind::LE && body.theory.order == 1)
            warnings.push_back("body " + body.name +
                               ": LE-1 (L4) cells cannot contract linearly "
                               "through their height and are too stiff in "
                               "bending (Poisson locking); use LE-2");
        }
      return warnings;
    }



    /// Where incompatible modes do not do what they are for, in words.
    std::vector<std::string>
    warnings_of_hexahedra(const Scene &scene)
    {
      std::vector<std::string> warnings;
      for (const BodyDescription &body : scene.bodies)
        {
          const SectionShape &shape = scene.sections.at(body.section);
          if (body.theory.kind == Theory::Kind::solid &&
              body.theory.order == 1 &&
              !std::holds_alternative<Laminate>(shape) &&
              !std::holds_alternative<ThinWalled>(shape))
            warnings.push_back(
              "body " + body.name +
              ": hexahedra of solid-1 have straight edges and are too stiff in "
              "bending where section cells are no rectangles and elements "
              "long, tens of per cent on a section of this shape (" +
              name_of(shape) + "); use solid-2");
        }
      return warnings;
    }



    /// What theories without free twist miss on off-axis plies, in words.
    std::vector<std::string>
    warnings_of_coupling(const Scene &scene)
    {
      std::vector<std::string> warnings;
      for (const BodyDescription &body : scene.bodies)
        {
          const Laminate *laminate =
            std::get_if<Laminate>(&scene.sections.at(body.section));
          if (laminate == nullptr || (!body.theory.is_classical() &&
                                      !(body.theory.kind == Theory::Kind::TE &&
                                        body.theory.order == 1)))
            continue;
          const LaminateStiffness stiffness =
            laminate_stiffness(laminate->plies(scene.materials),
                               laminate->width);
          const double ratio = stiffness.EI_untwisted / stiffness.EI;
          if (ratio > 1.01)
            warnings.push_back(
              "body " + body.name + ": the layup twists when it bends, which " +
              body.theory.name() +
              " cannot follow; by lamination theory it is " +
              to_text(ratio, 3) +
              " times too stiff in bending. Use TE-2 or more, or LE-N");
        }
      return warnings;
    }



    /// Probes, lines, cuts, and the trade of what these and the resultants
    /// give; @p in enters a subsection and parses it.
    template <typename In>
    void
    resolve_requests(ParameterHandler &prm,
                     const In         &in,
                     const Names      &names,
                     Scene            &scene)
    {
      const auto &bodies = names.at("Bodies");
      for (const std::string &name : names.at("Probes"))
        in("Probe " + name, [&](const std::string &) {
          scene.probes.push_back(parse_probe(prm, name, bodies));
        });
      for (const std::string &name : names.at("Lines"))
        in("Line " + name, [&](const std::string &) {
          scene.lines.push_back(parse_line(prm, name, bodies));
        });
      for (const std::string &name : names.at("Cuts"))
        in("Cut " + name, [&](const std::string &) {
          scene.cuts.push_back(parse_cut(prm, name, bodies));
        });
      prm.enter_subsection("Trade");
      scene.trade = TradeParameters::parse(prm,
                                           {bodies,
                                            scene.probes,
                                            scene.support_references,
                                            scene.contact_references});
      prm.leave_subsection();
    }



    /// The second pass, over what @p prm has parsed.
    Scene
    resolve(ParameterHandler &prm, const Names &names, const SceneText &text)
    {
      const auto in = [&](const std::string &subsection, const auto &parse) {
        if (!text.has_subsection(subsection))
          throw InputError("there is no 'subsection " + subsection +
                           "' for the name in the list. Add it, or remove the "
                           "name.");
        prm.enter_subsection(subsection);
        parse(subsection);
        prm.leave_subsection();
      };
      const std::vector<std::string> resultant{"fx", "fy", "fz"};

      Scene scene;
      scene.title              = prm.get("Title");
      scene.units              = Units::parse(prm.get("Units"));
      scene.solve              = SolveParameters::parse(prm);
      scene.write_vtu          = to_bool(prm.get("Write VTU"), "Write VTU");
      const std::string theory = prm.get("Theory");
      const auto       &bodies = names.at("Bodies");

      for (const std::string &name : names.at("Materials"))
        in("Material " + name, [&](const std::string &what) {
          scene.materials[name] =
            MaterialParameters::parse(prm).material(scene.units, what);
        });
      for (const std::string &name : names.at("Sections"))
        in("Section " + name, [&](const std::string &what) {
          scene.sections[name] =
            parse_section(prm, names.at("Materials"), text.folder(), what);
        });
      for (const std::string &name : bodies)
        in("Body " + name, [&](const std::string &) {
          scene.bodies.push_back(
            parse_body(prm, name, theory, names.at("Sections")));
        });
      scene.warnings = warnings_of_orders(scene.bodies);
      for (const std::string &warning : warnings_of_hexahedra(scene))
        scene.warnings.push_back(warning);
      for (const std::string &warning : warnings_of_coupling(scene))
        scene.warnings.push_back(warning);
      for (const std::string &name : names.at("Supports"))
        in("Support " + name, [&](const std::string &what) {
          scene.supports.push_back(parse_support(prm, name, bodies));
          scene.support_references[name] =
            parse_references(prm.get("References"), resultant, what);
        });
      for (const std::string &name : names.at("Loads"))
        in("Load " + name, [&](const std::string &) {
          scene.loads.push_back(parse_load(prm, name, bodies));
        });
      for (const std::string &name : names.at("Obstacles"))
        in("Obstacle " + name, [&](const std::string &) {
          scene.obstacles.push_back(parse_obstacle(prm, name));
        });
      for (const std::string &name : names.at("Contacts"))
        in("Contact " + name, [&](const std::string &what) {
          scene.contacts.push_back(
            parse_contact(prm, name, bodies, scene.obstacles));
          check_contact_is_new(scene.contacts);
          scene.contact_references[name] =
            parse_references(prm.get("References"), resultant, what);
        });
      resolve_requests(prm, in, names, scene);
      check_sizes(scene);
      return scene;
    }
  } // namespace



  namespace
  {
    /// @p text without what --set leaves out of a list, and the names.
    std::pair<SceneText, Names>
    listed(SceneText text)
    {
      Names names = read_names(text);
      for (const auto &[list, kind] : kinds())
        {
          text.drop_unlisted(list, kind, names.at(list));
          text.check_listed(list, kind, names.at(list));
        }
      return {std::move(text), std::move(names)};
    }
  } // namespace



  void
  check_entries(const SceneText &given)
  {
    const auto [text, names] = listed(given);
    ParameterHandler prm;
    declare_all(prm, names);
    text.check_declared(prm);
  }



  Scene
  read_scene(const SceneText &given)
  {
    SceneText text = given;
    try
      {
        Names names;
        std::tie(text, names) = listed(given);
        ParameterHandler prm;
        declare_all(prm, names);
        text.check_declared(prm);
        text.fill(prm);

        Scene scene    = resolve(prm, names, text);
        scene.resolved = SceneText::printed(prm);
        return scene;
      }
    catch (const InputError &error)
      {
        // Messages of the text itself know their place already.
        const std::string message = text.abbreviated(error.what());
        const bool        placed  = message.find(": ") < message.find(' ') ||
                            message.compare(0, 5, "--set") == 0;
        throw InputError(placed ? message : text.place_of(message) + message);
      }
  }



  std::string
  parameter_documentation()
  {
    Names names;
    for (const auto &[list, kind] : kinds())
      names[list] = {"NAME"};
    ParameterHandler prm;
    declare_all(prm, names);
    std::ostringstream text;
    prm.print_parameters(text,
                         ParameterHandler::Text |
                           ParameterHandler::KeepDeclarationOrder);
    return text.str();
  }



  SectionMeshes
  build_section_meshes(const Scene &scene)
  {
    SectionMeshes meshes;
    for (const auto &[name, shape] : scene.sections)
      {
        const auto mesh = make_section_mesh(shape, scene.materials);
        check_proportions(*mesh, "Section " + name);
        meshes[name] = mesh;
      }
    return meshes;
  }



  Bodies
  build_bodies(const Scene &scene, const SectionMeshes &meshes)
  {
    std::map<std::pair<std::string, Theory>, std::shared_ptr<const Section>>
           sections;
    Bodies bodies;
    for (const BodyDescription &description : scene.bodies)
      {
        const auto &mesh = meshes.at(description.section);
        check_slenderness(description, *mesh);
        if (description.theory.kind == Theory::Kind::solid)
          {
            SolidRefinement refinement = description.refinement;
            refinement.memory_limit    = scene.solve.memory_limit;
            bodies.push_back(std::make_unique<Solid>(description.name,
                                                     mesh,
                                                     description.axis,
                                                     description.placement,
                                                     description.theory.order,
                                                     refinement));
            continue;
          }
        auto &section = sections[{description.section, description.theory}];
        if (section == nullptr)
          section = make_section(mesh, description.theory);
        bodies.push_back(
          std::make_unique<Beam>(description.name,
                                 section,
                                 std::make_shared<Axis>(description.axis),
                                 description.placement));
      }
    return bodies;
  }
} // namespace lamella
