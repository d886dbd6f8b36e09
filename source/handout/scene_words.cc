// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/handout/chapters.h>
#include <lamella/handout/html.h>
#include <lamella/material/library.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace lamella
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    std::string
    strong(const std::string &name)
    {
      return "<b>" + escaped(name) + "</b>";
    }



    std::string
    code(const std::string &text)
    {
      return "<code>" + escaped(text) + "</code>";
    }



    /// `a`, `a and b`, `a, b and c`.
    std::string
    enumerated(const std::vector<std::string> &items)
    {
      std::string text;
      for (unsigned int k = 0; k < items.size(); ++k)
        text += (k == 0               ? "" :
                 k + 1 < items.size() ? ", " :
                                        " and ") +
                items[k];
      return text;
    }



    bool
    is_zero(const std::string &number)
    {
      return fault_of_number(number).rule.empty() && to_number(number) == 0.;
    }



    /// The numbers of a list as the scene writes them, `(0, 0, 1)`.
    std::string
    point(const std::string &text)
    {
      std::vector<std::string> parts = split(text, ',');
      for (std::string &part : parts)
        part = number(part);
      return "(" + joined(parts) + ")";
    }



    /// `along y`, for directions along an axis of the scene; `along (1, 1, 0)`.
    std::string
    direction(const std::string &text)
    {
      const std::vector<std::string> parts = split(text, ',');
      std::string                    axis;
      for (unsigned int c = 0; c < parts.size() && c < 3; ++c)
        if (!is_zero(parts[c]))
          axis += std::string(to_number(parts[c]) < 0. ? "−" : "") + "xyz"[c];
      const bool is_single = axis.size() == 1 || axis.compare(0, 3, "−") == 0;
      return "along " + (is_single && axis.size() <= 4 ? "<i>" + axis + "</i>" :
                                                         point(text));
    }



    /// What the theory @p theory, as `LE-2`, stands for.
    std::string
    meaning_of_theory(const std::string &theory)
    {
      const auto        dash   = theory.find('-');
      const std::string family = theory.substr(0, dash);
      const std::string order =
        dash == std::string::npos ? "" : escaped(theory.substr(dash + 1));
      if (family == "EBBT")
        return "sections stay plane and normal to the axis: Euler-Bernoulli";
      if (family == "TBT")
        return "sections stay plane but shear: Timoshenko";
      if (family == "TE")
        return "polynomials of degree " + order + " over the whole section";
      if (family == "LE")
        return "polynomials of degree " + order +
               " in each cell of the section, ply by ply";
      if (family == "SV" && order.empty())
        return "the section's own fields: rigid motions and Saint-Venant's "
               "warpings";
      if (family == "SV")
        return "the section's own fields: rigid motions, Saint-Venant's "
               "warpings, and its responses to what touches it at " +
               order + " wave numbers";
      if (family == "solid")
        return "three-dimensional hexahedra of degree " + order;
      return "";
    }



    /// How the displacements of the body @p name are approximated.
    std::string
    theory_words(const RunFolder &run, const std::string &name)
    {
      const std::string kinematics = "Body " + name + "/Kinematics/";
      const std::string several    = run.says(kinematics + "Theories");
      const std::string own        = run.says(kinematics + "Theory");
      const std::string theory     = own.empty() ? run.says("Theory") : own;
      const std::string meaning    = meaning_of_theory(theory);
      std::string       text =
        "Displacements: " + strong(several.empty() ? theory : several);
      if (!several.empty())
        text += " one after the other along the axis";
      else if (!meaning.empty())
        text += " (" + meaning + ")";
      text += "; elements along the axis: " +
              escaped(run.says(kinematics + "Axis elements"));
      if (theory.compare(0, 5, "solid") != 0)
        text += " of type " + escaped(run.says(kinematics + "Axis element"));
      const auto &body = member(member(run.summary, "bodies"), name);
      if (body.contains("dofs"))
        text +=
          "; " + number(body["dofs"], 0., 12) + " degrees of freedom (DoFs)";
      return text + ".";
    }



    /// Where @p on, `BODY: PLACE; BODY: PLACE`, is: `both ends of BODY`.
    std::string
    places(const RunFolder &run, const std::string &subsection)
    {
      std::vector<std::string> all;
      bool                     has_position = false;
      for (const std::string &region : split(run.says(subsection + "/On"), ';'))
        {
          const std::vector<std::string> parts = split(region, ':');
          const std::string body  = parts.empty() ? "" : strong(parts[0]);
          const std::string place = parts.size() < 2 ? "" : parts[1];
          if (place == "ends")
            all.push_back("both ends of " + body);
          else if (place == "start" || place == "end")
            all.push_back("the " + place + " of " + body);
          else if (place == "body")
            all.push_back("the whole of " + body);
          else if (place == "point" || place == "line")
            all.push_back((place == "point" ? "points of " : "a line on ") +
                          body);
          else
            all.push_back("the surface " + code(place) + " of " + body);
          has_position = has_position || place == "point" || place == "line";
        }
      std::string text = enumerated(all);
      if (has_position)
        {
          std::vector<std::string> at;
          for (const std::string &position :
               split(run.says(subsection + "/At"), ';'))
            at.push_back(point(position));
          if (at.size() == 1)
            text = replaced(text, "points of ", "a point of ");
          text += ", at " + joined(at, " to ") + run.unit_behind("length");
        }
      return text;
    }



    std::string
    body_words(const RunFolder &run, const std::string &name)
    {
      const std::string where   = "Body " + name + "/";
      const std::string section = run.says(where + "Section");
      const std::string theory =
        member(run.summary, "theory").value(name, std::string());
      const bool        is_solid = theory.compare(0, 5, "solid") == 0;
      const std::string length   = run.unit_behind("length");
      std::string       text =
        strong(name) + " is a " + (is_solid ? "solid body" : "beam") +
        " of length " + escaped(run.says(where + "Length")) + length + " " +
        direction(run.says(where + "Axis")) + ", of section " + strong(section);
      const std::string layup = run.says("Section " + section + "/Layup");
      if (run.says("Section " + section + "/Shape") == "laminate")
        text += ", a laminate " +
                code(layup.find('[') == 0 ? layup : "[" + layup + "]");
      text += ". The section's lower left corner stands at " +
              point(run.says(where + "Origin")) + length +
              " where the body begins. " + theory_words(run, name);
      if (!run.says(where + "Hold").empty())
        text += " Where no support and no contact acts against a rigid motion, "
                "its middle stays where it is: loads are in equilibrium.";
      else if (!is_zero(run.says(where + "Stabilisation")) &&
               !run.says(where + "Stabilisation").empty())
        text +=
          " Contact alone holds it; soft springs, taken out of the result "
          "again, keep the equations solvable.";
      return text;
    }



    std::string
    support_words(const RunFolder &run, const std::string &name)
    {
      const std::string where  = "Support " + name + "/";
      const std::string normal = run.says(where + "Normal displacement");
      std::string       text =
        strong(name) + " holds " + places(run, "Support " + name) + ": ";
      if (!normal.empty())
        return text +
               (is_zero(normal) ?
                  "no displacement along the outward normal (symmetry)." :
                  "the displacement along the outward normal is " +
                    escaped(normal) + run.unit_behind("length") + ".");
      const std::vector<std::string> u = split(run.says(where + "u"), ',');
      if (std::all_of(u.begin(), u.end(), is_zero))
        return text + "no displacement in any direction (clamped).";
      std::vector<std::string> parts;
      for (unsigned int c = 0; c < u.size() && c < 3; ++c)
        {
          const std::string component = symbol(std::string("u") + "xyz"[c]);
          parts.push_back(u[c] == "free" ?
                            component + " is free" :
                            component + " = " + escaped(u[c]) +
                              (is_zero(u[c]) ? "" : run.unit_behind("length")));
        }
      return text + enumerated(parts) + ".";
    }



    /// `[force/length²]` in the scene's units: what a load is in on a surface,
    /// along a line or at a point.
    std::string
    unit_of_load(const RunFolder &run, const std::string &on)
    {
      const std::string force  = run.unit("force").empty() ? "force" :
                                                             run.unit("force"),
                        length = run.unit("length").empty() ?
                                   "length" :
                                   run.unit("length");
      if (on.find(": point") != std::string::npos)
        return in_brackets(force, "");
      if (on.find(": line") != std::string::npos)
        return in_brackets(force + "/" + length, "");
      return in_brackets(force + "/" + length + "²", "");
    }



    double
    size_of(const Json &components)
    {
      double size = 0.;
      for (const Json &component : components)
        if (component.is_number())
          size = std::max(size, std::abs(component.get<double>()));
      return size;
    }



    /// `, in all FORCE, a moment of MOMENT about the origin` of the load
    /// @p name, without what is rounding beside the other.
    std::string
    resultant_words(const RunFolder &run, const std::string &name)
    {
      constexpr double rounding = 1e-12;
      const Json      &load     = member(member(run.summary, "loads"), name);
      const Json      &force    = member(load, "force"),
                 &moment        = member(load, "moment");
      std::string text;
      if (size_of(force) > rounding * size_of(moment))
        text += ", in all " + components(force) + run.unit_behind("force");
      if (size_of(moment) > rounding * size_of(force))
        text += std::string(text.empty() ? ", in all" : ",") + " a moment of " +
                components(moment) + " " + run.moment_unit_in_brackets() +
                " about the scene's origin";
      return text;
    }



    std::string
    load_words(const RunFolder &run, const std::string &name)
    {
      const std::string where       = "Load " + name + "/";
      const std::string pressure    = run.says(where + "Pressure"),
                        couple      = run.says(where + "Couple"),
                        total       = run.says(where + "Total force"),
                        temperature = run.says(where + "Temperature");
      if (!temperature.empty())
        return strong(name) + " makes " + places(run, "Load " + name) +
               " warmer than without stress by " + code(temperature) +
               " K, in full at every load step.";
      std::string text =
        strong(name) + " acts on " + places(run, "Load " + name) + ": ";
      if (!pressure.empty())
        text += "pressure " + code(pressure) + " against the outward normal " +
                unit_of_load(run, "");
      else if (!couple.empty())
        text += "a couple of " + point(couple) + " " +
                run.moment_unit_in_brackets() +
                ", as tractions without a resultant force";
      else if (!total.empty())
        text += "a force of " + point(total) + run.unit_behind("force") +
                ", spread evenly over it";
      else
        text += "force " + code("(" + run.says(where + "Force") + ")") + " " +
                unit_of_load(run, run.says(where + "On"));
      return text + resultant_words(run, name) + ".";
    }



    /// The weight of all bodies; empty without.
    std::string
    weight_words(const RunFolder &run)
    {
      const std::string              gravity = run.says("Gravity");
      const std::vector<std::string> g       = split(gravity, ',');
      if (std::all_of(g.begin(), g.end(), is_zero))
        return "";
      const std::string length = run.unit("length");
      return "All bodies have " + strong("weight") +
             ": the acceleration of gravity is " + point(gravity) + " [" +
             escaped(length.empty() ? "length" : length) + "/s²]" +
             resultant_words(run, "Gravity") + ".";
    }



    /// What loads the scene, a sentence each.
    std::string
    loads(const RunFolder &run)
    {
      std::vector<std::string> items;
      for (const std::string &name : run.names("Loads"))
        items.push_back(load_words(run, name));
      if (const std::string weight = weight_words(run); !weight.empty())
        items.push_back(weight);
      return "<h3>What loads it</h3>\n" +
             (items.empty() ?
                paragraph(
                  "No loads act; what moves the bodies is prescribed.") :
                list(items));
    }



    std::string
    obstacle_words(const RunFolder &run, const std::string &name)
    {
      const std::string where  = "Obstacle " + name + "/";
      const std::string length = run.unit_behind("length");
      const std::string u      = run.says(where + "u");
      std::string       text   = strong(name) + " is a rigid ";
      if (run.says(where + "Shape") == "plane")
        text += "plane through " + point(run.says(where + "Through")) + length +
                " that faces " + direction(run.says(where + "Normal"));
      else
        text += "cylinder of radius " + escaped(run.says(where + "Radius")) +
                length + " whose axis passes through " +
                point(run.says(where + "Through")) + length + " " +
                direction(run.says(where + "Axis"));
      const std::vector<std::string> parts = split(u, ',');
      return text + (std::all_of(parts.begin(), parts.end(), is_zero) ?
                       "; it stays where it is." :
                       "; it is moved by " + point(u) + length + ".");
    }



    std::string
    contact_words(const RunFolder &run, const std::string &name)
    {
      const std::string where = "Contact " + name + "/";
      const auto        side  = [&run, &where](const std::string &entry) {
        const std::vector<std::string> parts =
          split(run.says(where + entry), ':');
        return parts.size() < 2 ?
                         "the obstacle " + strong(run.says(where + entry)) :
                         "the surface " + code(parts[1]) + " of " + strong(parts[0]);
      };
      return strong(name) + ": " + side("First") + " may touch " +
             side("Second") + ", without friction (" +
             escaped(run.says(where + "Discretisation")) + ", " +
             escaped(run.says(where + "Enforcement")) + ").";
    }



    /// What kind of material @p name is, and its constants; none if they cannot
    /// be read.
    std::pair<std::string, std::optional<Material>>
    material_of(const RunFolder &run, const std::string &name)
    {
      const std::string where   = "Material " + name + "/";
      const std::string library = run.says(where + "Library");
      if (!library.empty())
        {
          const std::string kind = "the program's own " + code(library);
          try
            {
              Units units;
              units.pascal = run.unit("stress") == "MPa" ? 1e-6 : 1.;
              return {kind, library_material(library, units)};
            }
          catch (const InputError &) // of a library that had it
            {
              return {kind, std::nullopt};
            }
        }
      std::vector<double> e;
      for (const char *entry : {"Isotropic", "Engineering constants"})
        for (const std::string &text : split(run.says(where + entry), ','))
          e.push_back(to_number(text));
      if (e.size() == 2)
        return {"isotropic",
                Material(EngineeringConstants::isotropic(e[0], e[1]))};
      if (e.size() != 9)
        return {"", std::nullopt};
      EngineeringConstants elastic;
      elastic.E1   = e[0];
      elastic.E2   = e[1];
      elastic.E3   = e[2];
      elastic.G12  = e[3];
      elastic.G13  = e[4];
      elastic.G23  = e[5];
      elastic.nu12 = e[6];
      elastic.nu13 = e[7];
      elastic.nu23 = e[8];
      return {"orthotropic", Material(elastic)};
    }



    /// `[force s²/length⁴]` in the scene's units: kg/m³, t/mm³.
    std::string
    unit_of_density(const RunFolder &run)
    {
      const std::string length = run.unit("length");
      return length == "m"  ? "[kg/m³]" :
             length == "mm" ? "[t/mm³]" :
                              "[force s²/length⁴]";
    }



    /// Density, expansion, strengths and the like of the material @p name, a
    /// sentence each.
    std::vector<std::string>
    limits_of(const RunFolder               &run,
              const std::string             &name,
              const std::optional<Material> &material)
    {
      const std::string stress = run.unit_in_brackets("stress");
      const std::string strengths =
        "strengths X<sub>t</sub>, X<sub>c</sub>, Y<sub>t</sub>, Y<sub>c</sub>, "
        "Z<sub>t</sub>, Z<sub>c</sub>, S₁₂, S₁₃, S₂₃ " +
        stress;
      std::vector<std::string> items;
      const auto add = [&](const std::string &entry, const std::string &words) {
        const std::string value = run.says("Material " + name + "/" + entry);
        if (!value.empty())
          items.push_back(strong(name) + ": " + words + " = " + point(value));
        return !value.empty();
      };
      add("Density", "density " + unit_of_density(run));
      add("Thermal expansion",
          "thermal expansion along 1, 2, 3 (one number: along all) [1/K]");
      if (!add("Strengths", strengths) && material && material->strengths)
        {
          const Strengths         &s = *material->strengths;
          std::vector<std::string> values;
          for (const double value :
               {s.Xt, s.Xc, s.Yt, s.Yc, s.Zt, s.Zc, s.S12, s.S13, s.S23})
            values.push_back(number(value));
          items.push_back(strong(name) + ": " + strengths + " = (" +
                          joined(values) + "), the program's own");
        }
      add("Ultimate strains", "ultimate strains in the order of strengths");
      add("Yield", "yield stress " + stress);
      add("Core strengths",
          "crushing, shear 13 and shear 23 of a core " + stress);
      return items;
    }



    std::string
    materials(const RunFolder &run)
    {
      const std::string        stress = run.unit_in_brackets("stress");
      std::vector<std::string> limits;
      HtmlTable                table;
      table.id      = "materials";
      table.caption = "Elastic constants: 1 along the fibre, 2 across it, 3 "
                      "normal to the ply";
      table.header  = {"material",
                       "kind",
                       "<i>E</i>₁ " + stress,
                       "<i>E</i>₂ " + stress,
                       "<i>E</i>₃ " + stress,
                       "<i>G</i>₁₂ " + stress,
                       "<i>G</i>₁₃ " + stress,
                       "<i>G</i>₂₃ " + stress,
                       "ν₁₂",
                       "ν₁₃",
                       "ν₂₃"};
      for (const std::string &name : run.names("Materials"))
        {
          const auto [kind, material] = material_of(run, name);
          table.rows.push_back({strong(name), kind});
          EngineeringConstants e;
          if (material)
            e = material->elastic;
          for (const double value :
               {e.E1, e.E2, e.E3, e.G12, e.G13, e.G23, e.nu12, e.nu13, e.nu23})
            table.rows.back().push_back(material ? number(value) : "–");
          for (const std::string &item : limits_of(run, name, material))
            limits.push_back(item);
        }
      return "<h3>Materials</h3>\n" + to_html(table) + list(limits);
    }



    /// A paragraph @p lead with a sentence for each name in the list @p entry.
    std::string
    sentences(const RunFolder   &run,
              const std::string &entry,
              const std::string &lead,
              const std::string &none,
              std::string (*words)(const RunFolder &, const std::string &))
    {
      std::vector<std::string> items;
      for (const std::string &name : run.names(entry))
        items.push_back(words(run, name));
      if (items.empty() && none.empty())
        return "";
      return "<h3>" + lead + "</h3>\n" +
             (items.empty() ? paragraph(none) : list(items));
    }



    /// What load factors multiply, and what they do not.
    std::string
    multiplied_words(const RunFolder &run)
    {
      bool has_heat = false;
      for (const std::string &name : run.names("Loads"))
        has_heat =
          has_heat || !run.says("Load " + name + "/Temperature").empty();
      return has_heat ? "all forces and all prescribed displacements. "
                        "Temperatures act in full at every load step" :
                        "all loads and all prescribed displacements";
    }



    std::string
    load_steps(const RunFolder &run)
    {
      const std::vector<std::string> factors = run.names("Load factors");
      std::string                    text =
        factors.size() == 1 ?
                             "There is one load step" :
                             "There are " + std::to_string(factors.size()) + " load steps";
      text += ", with load factor" +
              std::string(factors.size() == 1 ? " " : "s ") +
              enumerated(factors) + ": what multiplies " +
              multiplied_words(run) + ".";
      if (run.says("Find") == "first failure")
        text += " After them the load factor is sought at which the first ply "
                "fails.";
      return text;
    }
  } // namespace



  namespace
  {
    /// What small rotations leave out, in this run's own numbers.
    std::string
    what_that_leaves_out(const RunFolder &run)
    {
      constexpr double              little = 0.01;
      const nlohmann::ordered_json &beyond =
        member(run.summary, "beyond_linear");
      const nlohmann::ordered_json &factor = member(beyond, "buckling_factor");
      const double                  r      = beyond.value("stiffening", 0.);
      std::string                   text;
      if (r > little)
        text = "That leaves out that large deflections stretch the body '" +
               escaped(beyond.value("stiffened", "?")) +
               "', which makes it stiffer by " + number(100. * r) + " %. ";
      if (factor.is_number())
        text += "The body '" + escaped(beyond.value("buckled", "?")) +
                "' buckles at " + number(factor) + " times the loads. ";
      if (text.empty())
        return "Of what that leaves out, stretching at large deflections is "
               "below 1 % here, and nothing buckles below 100 times the loads.";
      return text;
    }
  } // namespace



  Chapter
  scene_chapter(const RunFolder &run)
  {
    const std::string length = run.unit("length");
    std::string       html   = paragraph(
      (length.empty() ?
                 "The scene names no units: all numbers are in one consistent system "
                 "of the user's." :
                 "Lengths are in " + escaped(length) + ", forces in " +
           escaped(run.unit("force")) + ", stresses in " +
           escaped(run.unit("stress")) + ".") +
      std::string(
        " The axes are <i>x</i>, <i>y</i> and <i>z</i>, usually across, along "
                "and up. Stresses are positive in tension, contact forces and "
                "pressures in compression. Everything is linear elastic, "
                "contact has no friction, and displacements and rotations are "
                "taken as small. ") +
      what_that_leaves_out(run));
    html += sentences(run, "Bodies", "Bodies", "", body_words);
    html += materials(run);
    html += sentences(run, "Supports", "What holds it", "", support_words);
    html += loads(run);
    html += sentences(run, "Obstacles", "Rigid obstacles", "", obstacle_words);
    html += sentences(run,
                      "Contacts",
                      "What may touch",
                      "Nothing may touch: the scene has no contact.",
                      contact_words);
    html += "<h3>Load steps</h3>\n" + paragraph(load_steps(run));
    return {"scene", "The scene in words", html};
  }
} // namespace lamella
