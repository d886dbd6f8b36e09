// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/patterns.h>
#include <lamella/scene/rotation_rules.h>
#include <lamella/scene/scene_checks.h>
#include <lamella/scene/subsection_kinds.h>
#include <lamella/shape/properties.h>
#include <lamella/shape/section_mesh.h>

#include <algorithm>
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
    /// Declares the entries of the model outside subsections.
    void
    declare_model(ParameterHandler &prm)
    {
      prm.declare_entry("Title", "", Anything(), "Printed with the results.");
      prm.declare_entry("Units",
                        "none",
                        Anything(),
                        "Units: m, N (stresses in Pa) or mm, N (stresses in "
                        "MPa), for the labels of results and the built-in "
                        "materials; none: no labels.");
      prm.declare_entry(
        "Theory",
        "LE-2",
        Anything(),
        "Theory of all bodies. EBBT, TBT: classical beams; TE-N: Taylor "
        "expansion of degree N (1 to 20) over the whole section; LE-N: "
        "layer-wise Lagrange expansion of degree N (LE-1, 2, 3 are L4, L9, "
        "L16); SV-N: Saint-Venant solutions of the section and its deformation "
        "near loads, supports and contacts at N wave numbers (SV: none); "
        "solid-N: hexahedra of degree N (1 or 2) instead of a beam.");
      prm.declare_entry(
        "Gravity",
        "0, 0, 0",
        patterns::numbers(3),
        "Acceleration of gravity along x, y and z of the scene [length/s^2], "
        "as in 0, 0, -9.81 (m). It loads all bodies by their weight, times the "
        "load factor; their materials need a Density.");
    }



    void
    declare_lists(ParameterHandler &prm)
    {
      for (const SubsectionKind &kind : subsection_kinds())
        prm.declare_entry(kind.list,
                          "",
                          Anything(),
                          "Names with commas between; each has a subsection '" +
                            kind.kind + " NAME'.");
    }



    void
    declare_scene(ParameterHandler &prm)
    {
      declare_model(prm);
      SolveParameters::declare(prm);
      prm.declare_entry(
        "Write VTU",
        "true",
        Bool(),
        "Whether to write the deformed bodies for ParaView: true or false.");
      FindRequest::declare(prm);
      declare_lists(prm);
    }



    void
    declare_all(ParameterHandler &prm, const NameLists &names)
    {
      declare_scene(prm);
      for (const SubsectionKind &kind : subsection_kinds())
        for (const std::string &name : names.at(kind.list))
          {
            prm.enter_subsection(kind.kind + " " + name);
            kind.declare(prm);
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



    /// Returns the names in @p text (first pass).
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
      for (const SubsectionKind &kind : subsection_kinds())
        {
          const Entry entry = in[kind.list];
          names[kind.list]  = entry.items();
          std::set<std::string> seen;
          for (const std::string &name : names[kind.list])
            {
              if (!std::regex_match(name, form))
                entry.refuse("scene.invalid-name: '" + name +
                               "' is not a valid name",
                             "Write a letter, then letters, digits, '_', '-'.");
              if (!seen.insert(name).second)
                entry.refuse("scene.repeated-name: '" + name +
                             "' is in the list twice; remove one of the two");
            }
        }
      for (const std::string &name : names["Obstacles"])
        for (const std::string &body : names["Bodies"])
          if (name == body)
            in["Obstacles"].refuse("scene.obstacle-named-as-body: '" + name +
                                     "' is also the name of a body",
                                   "Rename the obstacle or the body.");
      for (const char *list : {"Materials", "Sections", "Bodies"})
        if (names[list].empty())
          in[list].refuse_missing("scene.empty-list: write at least one name, "
                                  "as in Bodies = upper, lower.");
      return names;
    }



    /// Reads subsections of @p kind; throws InputError if one is missing.
    void
    resolve_kind(const SubsectionKind &kind,
                 const SceneText      &text,
                 SceneReading         &reading)
    {
      const std::vector<std::string> &names = reading.names.at(kind.list);
      for (const std::string &name : names)
        {
          const std::string path = kind.kind + " " + name;
          if (!text.has_subsection(path))
            throw InputError(
              kind.list,
              joined(names),
              "scene.name-without-subsection: there is no 'subsection " + path +
                "' for this name in the list",
              "Add the subsection, or remove the name from the list.");
          reading.prm.enter_subsection(path);
          kind.resolve(reading, name, Entries(reading.prm, path));
          reading.prm.leave_subsection();
        }
      if (kind.finish != nullptr)
        kind.finish(reading.scene);
    }



    /// Reads failure criteria, goals, and the trade, which refers to all these.
    void
    resolve_requests(ParameterHandler               &prm,
                     const std::vector<std::string> &bodies,
                     Scene                          &scene)
    {
      prm.enter_subsection("Strength");
      scene.strength =
        StrengthParameters::parse(Entries(prm, "Strength"), bodies);
      prm.leave_subsection();
      scene.find = FindRequest::parse(prm, !scene.strength.criteria.empty());
      check_response(scene);
      const QuantityNames names{scene.probes,
                                scene.support_references,
                                scene.contact_references,
                                scene.measures,
                                scene.find.names_of_modes()};
      check_names_of_measures(names);
      prm.enter_subsection("Goals");
      const std::vector<NamedQuantity> of_goals =
        parse_quantities(Entries(prm, "Goals")["Quantities"], names);
      prm.leave_subsection();
      prm.enter_subsection("Trade");
      scene.trade = TradeParameters::parse(Entries(prm, "Trade"),
                                           {bodies, names, of_goals});
      // Default quantities of a trade are those of the goals already.
      const bool named = !Entries(prm, "Trade")["Quantities"].is_empty();
      prm.leave_subsection();
      prm.enter_subsection("Goals");
      scene.goals = GoalParameters::parse(Entries(prm, "Goals"),
                                          names,
                                          named ? scene.trade.quantities :
                                                  std::vector<NamedQuantity>(),
                                          scene.units);
      prm.leave_subsection();
    }



    /// Throws InputError for weight with stresses by equilibrium, whose
    /// integration through the thickness has no volume force.
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
        gravity.refuse("scene.equilibrium-with-gravity: stresses by Stress = "
                       "equilibrium do not include the weight of bodies",
                       "Write Stress = recovered, or remove Gravity.");
    }



    /// Throws InputError for several load histories with a search along one.
    void
    check_histories(const Scene &scene, const Entries &in)
    {
      const std::string path = first_with_factors(scene);
      if (scene.find.first_failure && !path.empty())
        in["Find"].refuse("scene.find-with-factors: " + path +
                            " has its own Factors, but Find = first failure "
                            "raises one load factor until a ply fails",
                          "Remove these Factors, or Find.");
    }



    /// Returns the scene that @p prm has parsed (second pass).
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
      scene.write_vtu = in["Write VTU"].boolean();

      SceneReading reading{prm, names, text.folder(), in["Theory"], scene};
      for (const SubsectionKind &kind : subsection_kinds())
        resolve_kind(kind, text, reading);
      resolve_requests(prm, names.at("Bodies"), scene);
      for (BodyDescription &body : scene.bodies)
        if (body.has_inertia = scene.find.modes.has_value();
            body.has_inertia && body.is_held)
          in["Find"].refuse("scene.modes-with-isostatic-support: body '" +
                              body.name +
                              "' has Isostatic support = true, which would "
                              "hold it in its modes",
                            "Remove that entry: bodies of modes may be free.");
      check_sizes(scene);
      check_equilibrium(scene, in["Gravity"]);
      check_friction(scene, in);
      check_histories(scene, in);
      apply_rotations(scene);
      return scene;
    }



    /// Returns @p text without items that --set removed from a list; and names.
    std::pair<SceneText, NameLists>
    listed(SceneText text)
    {
      NameLists names = read_names(text);
      for (const SubsectionKind &kind : subsection_kinds())
        {
          text.drop_unlisted(kind.list, kind.kind, names.at(kind.list));
          text.check_listed(kind.list, kind.kind, names.at(kind.list));
        }
      return {std::move(text), std::move(names)};
    }



    /// Returns whether @p text sets the Theory @p path to `auto`. Throws
    /// InputError for `auto` without a Tolerance.
    bool
    is_theory_automatic(const SceneText   &text,
                        const std::string &path,
                        const bool         has_tolerance)
    {
      if (trimmed(text.says(path).value_or("")) != "auto")
        return false;
      if (!has_tolerance)
        throw InputError(
          path,
          "auto",
          "scene.auto-theory-without-tolerance: Theory = auto is possible only "
          "in a run with a Tolerance, which chooses the theory",
          "Write a theory such as LE-2, or Tolerance in subsection Goals.");
      return true;
    }



    /// Sets defaults of a run to a tolerance where @p text has none or `auto`:
    /// section fields with responses at contacts, and graded axes. Returns
    /// whether it sets the Theory; adds bodies with changed axes to @p axes.
    bool
    set_tolerance_defaults(SceneText             &text,
                           const NameLists       &names,
                           std::set<std::string> &axes)
    {
      const bool has_tolerance =
        !trimmed(text.says("Goals/Tolerance").value_or("")).empty();
      const bool any = is_theory_automatic(text, "Theory", has_tolerance);
      const bool is_assumed   = any || !text.says("Theory");
      const std::string start = names.at("Contacts").empty() ? "SV" : "SV-6";
      if (any)
        text.replace("Theory", start);
      for (const std::string &body : names.at("Bodies"))
        {
          const std::string kinematics = "Body " + body + "/Kinematics/";
          if (is_theory_automatic(text, kinematics + "Theory", has_tolerance))
            text.replace(kinematics + "Theory", start);
          const std::string elements = kinematics + "Axis elements";
          if (has_tolerance && !text.says(kinematics + "Axis breaks") &&
              trimmed(text.says(elements).value_or("")).empty())
            {
              text.replace(elements, "auto");
              axes.insert(body);
            }
        }
      if (!has_tolerance)
        return false;
      text.set_default("Theory", start);
      return is_assumed;
    }
  } // namespace



  void
  check_entries(const SceneText &given)
  {
    SceneText whole = given;
    expand_stacks(whole);
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
        expand_stacks(text);
        std::tie(text, names) = listed(text);
        std::set<std::string> assumed;
        const bool            theory_is_default =
          set_tolerance_defaults(text, names, assumed);
        ParameterHandler prm;
        declare_all(prm, names);
        text.check_declared(prm);
        text.fill(prm);

        Scene scene                   = resolve(prm, names, text);
        scene.goals.theory_is_default = theory_is_default;
        scene.goals.axes_are_default  = assumed;
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
    for (const SubsectionKind &kind : subsection_kinds())
      names[kind.list] = {"NAME"};
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
        if (const auto layers = scene.corner_layers.find(name);
            layers != scene.corner_layers.end() && layers->second > 0)
          mesh = graded_to_corners(*mesh, layers->second, "Section " + name);
        check_proportions(*mesh, "Section " + name);
        meshes[name] = mesh;
      }
    return meshes;
  }



  std::string
  first_with_factors(const Scene &scene)
  {
    const auto has_factors = [&](const unsigned int history) {
      return history > 0 &&
             !scene.solve.load_factors.front().oscillates(history);
    };
    for (const Support &support : scene.supports)
      if (has_factors(support.history))
        return "Support " + support.name;
    for (const Load &load : scene.loads)
      if (has_factors(load.history))
        return "Load " + load.name;
    for (const auto &obstacle : scene.obstacles)
      if (has_factors(obstacle->history))
        return "Obstacle " + obstacle->name;
    return "";
  }



  const ContactPair *
  first_with_friction(const Scene &scene)
  {
    for (const ContactPair &contact : scene.contacts)
      if (contact.friction > 0.)
        return &contact;
    return nullptr;
  }
} // namespace lamella
