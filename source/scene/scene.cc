// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/patterns.h>
#include <lamella/conditions/hold.h>
#include <lamella/conditions/parameters.h>
#include <lamella/contact/parameters.h>
#include <lamella/material/parameters.h>
#include <lamella/material/plausibility.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/size_check.h>
#include <lamella/scene/stacks.h>
#include <lamella/scene/theory_notes.h>
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
  using dealii::Patterns::Bool;

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
        {"Cuts", "Cut"},
        {"Measures", "Measure"}};
      return all;
    }

    /// The names in each of these lists.
    using NameLists = std::map<std::string, std::vector<std::string>>;



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
        "expansion of degree N; LE-1, 2, 3 are L4, L9, L16), SV-N (the "
        "section's own Saint-Venant fields and its responses to what touches "
        "it at N wave numbers; SV is SV-0), solid-N (no beams but hexahedra of "
        "degree N, 1 or 2, on the same meshes).");
      prm.declare_entry("Gravity",
                        "0, 0, 0",
                        patterns::numbers(3),
                        "Acceleration along the scene's x, y and z "
                        "[length/s^2], 0, 0, -9.81 in m: the weight of all "
                        "bodies, whose materials then need a Density. A load, "
                        "times the load factor.");
      SolveParameters::declare(prm);
      prm.declare_entry(
        "Write VTU",
        "true",
        Bool(),
        "Whether to write the deformed bodies for ParaView: true "
        "or false.");
      prm.declare_entry(
        "Find",
        "",
        Anything(),
        "What is sought after the load factors: `first failure`, the load "
        "factor at which the smallest reserve factor of subsection Strength is "
        "1, to 0.1 %, contact solved anew at each trial.");
      for (const auto &[list, kind] : kinds())
        prm.declare_entry(list,
                          "",
                          Anything(),
                          "Names between commas; each has a subsection '" +
                            kind + " NAME'.");
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
    declare_all(ParameterHandler &prm, const NameLists &names)
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
              BodyParameters::declare(prm);
            else if (kind == "Support")
              SupportParameters::declare(prm);
            else if (kind == "Load")
              LoadParameters::declare(prm);
            else if (kind == "Obstacle")
              ObstacleParameters::declare(prm);
            else if (kind == "Contact")
              ContactParameters::declare(prm);
            else if (kind == "Probe")
              ProbeParameters::declare(prm);
            else if (kind == "Line")
              LineParameters::declare(prm);
            else if (kind == "Cut")
              CutParameters::declare(prm);
            else if (kind == "Measure")
              MeasureParameters::declare(prm);
            if (kind == "Support" || kind == "Contact")
              declare_references(prm);
            prm.leave_subsection();
          }
      prm.enter_subsection("Goals");
      GoalParameters::declare(prm);
      prm.leave_subsection();
      prm.enter_subsection("Strength");
      StrengthParameters::declare(prm);
      prm.leave_subsection();
      prm.enter_subsection("Trade");
      TradeParameters::declare(prm);
      prm.leave_subsection();
    }



    /// The first pass.
    NameLists
    read_names(const SceneText &text)
    {
      static const std::regex form("[A-Za-z][A-Za-z0-9_-]*");
      ParameterHandler        prm;
      declare_scene(prm);
      text.check_declared(prm, /*top_level_only=*/true);
      text.fill(prm, /*top_level_only=*/true);
      const Entries in(prm, "");
      NameLists     names;
      for (const auto &[list, kind] : kinds())
        {
          const Entry entry = in[list];
          names[list]       = entry.items();
          std::set<std::string> seen;
          for (const std::string &name : names[list])
            {
              if (!std::regex_match(name, form))
                entry.refuse("'" + name + "' is not a name",
                             "Names begin with a letter and go on with "
                             "letters, digits, '_' and '-'.");
              if (!seen.insert(name).second)
                entry.refuse("'" + name + "' stands there twice");
            }
        }
      for (const std::string &name : names["Obstacles"])
        for (const std::string &body : names["Bodies"])
          if (name == body)
            in["Obstacles"].refuse("'" + name + "' is the name of a body, too",
                                   "Rename one of the two.");
      for (const char *list : {"Materials", "Sections", "Bodies"})
        if (names[list].empty())
          in[list].is_missing("a scene needs at least one name there.");
      return names;
    }



    SectionShape
    parse_section(ParameterHandler               &prm,
                  const Entries                  &in,
                  const std::vector<std::string> &materials,
                  const std::string              &folder)
    {
      const SectionShape shape =
        SectionParameters::parse(in, materials, folder);
      // The resolved scene must find the mesh from its own folder, too.
      if (const auto *file = std::get_if<SectionFile>(&shape))
        prm.set("File", std::filesystem::absolute(file->path).string());
      return shape;
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
          throw InputError("Contact " + last.name,
                           "",
                           "pairs the same surfaces as Contact " + other->name,
                           "Keep one of the two.");
    }



    /// Enters the subsections of a scene one after the other.
    class Subsections
    {
    public:
      Subsections(ParameterHandler &prm,
                  const NameLists  &names,
                  const SceneText  &text)
        : prm(prm)
        , names(names)
        , text(text)
      {}

      /// Calls @p parse with each name of @p list and the entries of its
      /// subsection `KIND NAME`. Throws InputError if a name has none.
      template <typename Parse>
      void
      each(const std::string &list, const std::string &kind, const Parse &parse)
      {
        for (const std::string &name : names.at(list))
          {
            const std::string path = kind + " " + name;
            if (!text.has_subsection(path))
              throw InputError(list,
                               joined(names.at(list)),
                               "there is no 'subsection " + path +
                                 "' for the name in the list",
                               "Add it, or remove the name.");
            prm.enter_subsection(path);
            parse(name, Entries(prm, path));
            prm.leave_subsection();
          }
      }

    private:
      ParameterHandler &prm;
      const NameLists  &names;
      const SceneText  &text;
    };



    /// Materials, sections and bodies.
    void
    resolve_bodies(ParameterHandler &prm,
                   Subsections      &subsections,
                   const NameLists  &names,
                   const SceneText  &text,
                   Scene            &scene)
    {
      const Entry theory = Entries(prm, "")["Theory"];
      subsections.each("Materials", "Material", [&](const auto &name, auto in) {
        scene.materials[name] = MaterialParameters::parse(in, scene.units);
        // That of the paper's half-cylinders has no unit.
        if (in["Library"].text() != "hertz-200")
          if (const std::string doubt =
                doubt_of_moduli(name, scene.materials[name], scene.units);
              !doubt.empty())
            scene.warnings.push_back(doubt);
      });
      subsections.each("Sections", "Section", [&](const auto &name, auto in) {
        scene.sections[name] =
          parse_section(prm, in, names.at("Materials"), text.folder());
        scene.divisions[name] =
          in["Cells divided"].whole(0, SectionParameters::most_divisions);
      });
      subsections.each("Bodies", "Body", [&](const auto &name, auto) {
        scene.bodies.push_back(
          BodyParameters::parse(prm, name, theory, names.at("Sections")));
      });
      const std::vector<std::string> notes = notes_on_choices(scene);
      scene.warnings.insert(scene.warnings.end(), notes.begin(), notes.end());
    }



    /// The supports that `Hold` of bodies stands for.
    void
    add_holds(Scene &scene)
    {
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          if (!scene.bodies[b].is_held)
            continue;
          Support support;
          support.name = name_of_hold(scene.bodies[b].name);
          support.hold = Hold{b};
          if (!scene.support_references
                 .emplace(support.name, std::vector<Reference>())
                 .second)
            throw InputError("Support " + support.name,
                             "",
                             "that is what Hold of the body '" +
                               scene.bodies[b].name +
                               "' is called among the supports",
                             "Rename the support.");
          scene.supports.push_back(support);
        }
    }



    /// Supports, loads, obstacles and contacts.
    void
    resolve_conditions(Subsections                    &subsections,
                       const std::vector<std::string> &bodies,
                       Scene                          &scene)
    {
      const std::vector<std::string> resultant{"fx", "fy", "fz"};
      subsections.each("Supports", "Support", [&](const auto &name, auto in) {
        scene.supports.push_back(SupportParameters::parse(in, name, bodies));
        scene.support_references[name] =
          parse_references(in["References"], resultant);
      });
      add_holds(scene);
      subsections.each("Loads", "Load", [&](const auto &name, auto in) {
        scene.loads.push_back(LoadParameters::parse(in, name, bodies));
        if (name == name_of_weight && scene.gravity.norm() > 0.)
          in.refuse("Gravity is what the weight of the bodies is called among "
                    "the loads",
                    "Rename the load.");
      });
      subsections.each("Obstacles", "Obstacle", [&](const auto &name, auto in) {
        scene.obstacles.push_back(ObstacleParameters::parse(in, name));
      });
      subsections.each("Contacts", "Contact", [&](const auto &name, auto in) {
        scene.contacts.push_back(
          ContactParameters::parse(in, name, bodies, scene.obstacles));
        check_contact_is_new(scene.contacts);
        scene.contact_references[name] =
          parse_references(in["References"], resultant);
      });
    }



    /// Whether @p entry, Find, asks for the load at first failure.
    bool
    finds_first_failure(const Entry &entry, const StrengthParameters &strength)
    {
      if (entry.is_empty())
        return false;
      if (entry.text() != "first failure")
        entry.refuse("must be `first failure`, or empty");
      if (strength.criteria.empty())
        entry.refuse("there are no criteria to fail by",
                     "Give Criteria in subsection Strength, and Strengths of "
                     "the materials.");
      return true;
    }



    /// Probes, lines, cuts, what is looked at for failure, and the trade of
    /// what these and the resultants give.
    void
    resolve_requests(ParameterHandler               &prm,
                     Subsections                    &subsections,
                     const std::vector<std::string> &bodies,
                     Scene                          &scene)
    {
      subsections.each("Probes", "Probe", [&](const auto &name, auto in) {
        scene.probes.push_back(ProbeParameters::parse(in, name, bodies));
      });
      subsections.each("Lines", "Line", [&](const auto &name, auto in) {
        scene.lines.push_back(LineParameters::parse(in, name, bodies));
      });
      subsections.each("Cuts", "Cut", [&](const auto &name, auto in) {
        scene.cuts.push_back(CutParameters::parse(in, name, bodies));
      });
      subsections.each("Measures", "Measure", [&](const auto &name, auto in) {
        scene.measures.push_back(
          MeasureParameters::parse(in, name, scene.probes));
      });
      prm.enter_subsection("Strength");
      scene.strength =
        StrengthParameters::parse(Entries(prm, "Strength"), bodies);
      prm.leave_subsection();
      const QuantityNames names{scene.probes,
                                scene.support_references,
                                scene.contact_references,
                                scene.measures};
      check_names_of_measures(names);
      prm.enter_subsection("Goals");
      const std::vector<NamedQuantity> of_goals =
        parse_quantities(Entries(prm, "Goals")["Quantities"], names);
      prm.leave_subsection();
      prm.enter_subsection("Trade");
      scene.trade = TradeParameters::parse(Entries(prm, "Trade"),
                                           {bodies, names, of_goals});
      // What it has by itself the goals have by themselves.
      const bool named = !Entries(prm, "Trade")["Quantities"].is_empty();
      prm.leave_subsection();
      prm.enter_subsection("Goals");
      scene.goals = GoalParameters::parse(Entries(prm, "Goals"),
                                          names,
                                          named ? scene.trade.quantities :
                                                  std::vector<NamedQuantity>());
      prm.leave_subsection();
    }



    /// The second pass, over what @p prm has parsed.
    /// Weight is a force in the volume, of which the integration of
    /// equilibrium through the thickness does not know.
    void
    check_equilibrium(const Scene &scene, const Entry &gravity)
    {
      if (scene.gravity.norm() == 0.)
        return;
      const auto by_equilibrium = [](const auto &request) {
        return request.stress == StressValues::equilibrium;
      };
      const auto any = [&](const auto &requests) {
        return std::any_of(requests.begin(), requests.end(), by_equilibrium);
      };
      if (any(scene.probes) || any(scene.lines) || any(scene.cuts) ||
          (by_equilibrium(scene.strength) && !scene.strength.criteria.empty()))
        gravity.refuse("Stress = equilibrium does not know of weight",
                       "Take recovered stresses, or leave out Gravity.");
    }



    Scene
    resolve(ParameterHandler &prm,
            const NameLists  &names,
            const SceneText  &text)
    {
      const Entries in(prm, "");
      Scene         scene;
      scene.title     = in["Title"].text();
      scene.units     = Units::parse(in["Units"]);
      scene.gravity   = in["Gravity"].point();
      scene.solve     = SolveParameters::parse(in);
      scene.write_vtu = in["Write VTU"].truth();

      Subsections subsections(prm, names, text);
      resolve_bodies(prm, subsections, names, text, scene);
      resolve_conditions(subsections, names.at("Bodies"), scene);
      resolve_requests(prm, subsections, names.at("Bodies"), scene);
      scene.find_first_failure =
        finds_first_failure(in["Find"], scene.strength);
      check_sizes(scene);
      check_equilibrium(scene, in["Gravity"]);
      return scene;
    }
  } // namespace



  namespace
  {
    /// @p text without what --set leaves out of a list, and the names.
    std::pair<SceneText, NameLists>
    listed(SceneText text)
    {
      NameLists names = read_names(text);
      for (const auto &[list, kind] : kinds())
        {
          text.drop_unlisted(list, kind, names.at(list));
          text.check_listed(list, kind, names.at(list));
        }
      return {std::move(text), std::move(names)};
    }
  } // namespace



  namespace
  {
    /// Whether @p text says `auto` of the Theory @p path. Throws InputError if
    /// it says so without a Tolerance.
    bool
    wants_any_theory(const SceneText   &text,
                     const std::string &path,
                     const bool         has_tolerance)
    {
      if (trimmed(text.says(path).value_or("")) != "auto")
        return false;
      if (!has_tolerance)
        throw InputError(path,
                         "auto",
                         "only a run to a tolerance chooses its theory",
                         "Name a theory, or give a Tolerance in subsection "
                         "Goals.");
      return true;
    }



    /// What a run to a tolerance begins with where @p text does not say, or
    /// says `auto`: the section's own fields, with responses where contacts
    /// press, and axes that grade themselves. Whether that is so of the scene's
    /// Theory.
    bool
    assume_start(SceneText &text, const NameLists &names)
    {
      const bool has_tolerance =
        !trimmed(text.says("Goals/Tolerance").value_or("")).empty();
      const bool        any = wants_any_theory(text, "Theory", has_tolerance);
      const bool        is_assumed = any || !text.says("Theory");
      const std::string start = names.at("Contacts").empty() ? "SV" : "SV-6";
      if (any)
        text.replace("Theory", start);
      for (const std::string &body : names.at("Bodies"))
        {
          const std::string kinematics = "Body " + body + "/Kinematics/";
          if (wants_any_theory(text, kinematics + "Theory", has_tolerance))
            text.replace(kinematics + "Theory", start);
          if (has_tolerance && !text.says(kinematics + "Axis breaks"))
            text.assume(kinematics + "Axis elements", "auto");
        }
      if (!has_tolerance)
        return false;
      text.assume("Theory", start);
      return is_assumed;
    }
  } // namespace



  void
  check_entries(const SceneText &given)
  {
    SceneText whole = given;
    write_out_stacks(whole);
    const auto [text, names] = listed(whole);
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
        NameLists names;
        write_out_stacks(text);
        std::tie(text, names)              = listed(text);
        const bool       theory_is_assumed = assume_start(text, names);
        ParameterHandler prm;
        declare_all(prm, names);
        text.check_declared(prm);
        text.fill(prm);

        Scene scene                   = resolve(prm, names, text);
        scene.goals.theory_is_assumed = theory_is_assumed;
        scene.resolved                = SceneText::printed(prm);
        return scene;
      }
    catch (const InputError &error)
      {
        throw text.placed(error);
      }
  }



  std::string
  parameter_documentation()
  {
    NameLists names;
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
        auto mesh = make_section_mesh(shape, scene.materials);
        if (const unsigned int times = scene.divisions_of(name); times > 0)
          mesh = divided(*mesh, times, "Section " + name);
        check_proportions(*mesh, "Section " + name);
        meshes[name] = mesh;
      }
    return meshes;
  }

} // namespace lamella
