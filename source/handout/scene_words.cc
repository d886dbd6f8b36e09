// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/handout/chapters.h>
#include <lamella/handout/html.h>

#include <algorithm>

namespace lamella
{
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
      return "(" + escaped(joined(split(text, ','))) + ")";
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



    /// What the name of a theory, as `LE-2`, stands for.
    std::string
    meaning_of_theory(const std::string &theory)
    {
      const auto        dash   = theory.find('-');
      const std::string family = theory.substr(0, dash);
      const std::string order =
        dash == std::string::npos ? "" : escaped(theory.substr(dash + 1));
      if (theory.find(',') != std::string::npos)
        return "different kinds in different pieces of the axis";
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
              " where the body begins. Displacements: " + strong(theory);
      const std::string meaning = meaning_of_theory(theory);
      if (!meaning.empty())
        text += " (" + meaning + ")";
      const std::string kinematics = where + "Kinematics/";
      const std::string elements   = run.says(kinematics + "Axis elements");
      if (!elements.empty())
        text += "; elements along the axis: " + code(elements);
      if (!is_solid && !elements.empty())
        text += " of type " + escaped(run.says(kinematics + "Axis element"));
      const auto &body = member(member(run.summary, "bodies"), name);
      if (body.contains("dofs"))
        text += "; " + number(body["dofs"].dump(), 0., 12) +
                " degrees of freedom (DoFs)";
      text += ".";
      if (!is_zero(run.says(where + "Stabilisation")) &&
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



    std::string
    load_words(const RunFolder &run, const std::string &name)
    {
      const std::string where    = "Load " + name + "/";
      const std::string pressure = run.says(where + "Pressure");
      const std::string on       = run.says(where + "On");
      const std::string force    = run.unit("force").empty() ? "force" :
                                                               run.unit("force"),
                        length   = run.unit("length").empty() ?
                                     "length" :
                                     run.unit("length");
      const bool has_point       = on.find(": point") != std::string::npos,
                 has_line        = on.find(": line") != std::string::npos;
      std::string text =
        strong(name) + " acts on " + places(run, "Load " + name) + ": ";
      if (!pressure.empty())
        text += "pressure " + code(pressure) + " against the outward normal [" +
                escaped(force + "/" + length) + "²]";
      else
        text += "force " + code("(" + run.says(where + "Force") + ")") + " [" +
                escaped(has_point ? force : force + "/" + length) +
                (has_point || has_line ? "" : "²") + "]";
      const auto &load = member(member(run.summary, "loads"), name);
      if (load.contains("force"))
        text +=
          ", in all " + components(load["force"]) + run.unit_behind("force");
      return text + ".";
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



    std::string
    material_words(const RunFolder &run, const std::string &name)
    {
      const std::string        where     = "Material " + name + "/";
      const std::string        stress    = run.unit_behind("stress");
      const std::string        in_stress = stress.empty() ? "" : " in" + stress;
      std::vector<std::string> parts;
      const auto add = [&](const std::string &entry, const std::string &words) {
        const std::string value = run.says(where + entry);
        if (!value.empty())
          parts.push_back(words + " " + escaped(value));
      };
      add("Library", "built into the program as");
      add("Isotropic",
          "isotropic, <i>E</i>" + in_stress + " and Poisson's ratio ν =");
      add("Engineering constants",
          "orthotropic (1 along the fibre, 3 normal to the ply); <i>E</i>₁, "
          "<i>E</i>₂, <i>E</i>₃, <i>G</i>₁₂, <i>G</i>₁₃, <i>G</i>₂₃" +
            in_stress + ", ν₁₂, ν₁₃, ν₂₃ =");
      add("Strengths",
          "strengths X<sub>t</sub>, X<sub>c</sub>, Y<sub>t</sub>, "
          "Y<sub>c</sub>, Z<sub>t</sub>, Z<sub>c</sub>, S₁₂, S₁₃, S₂₃" +
            in_stress + " =");
      add("Ultimate strains", "ultimate strains, in the same order,");
      add("Yield", "yield stress" + in_stress);
      add("Core strengths",
          "core strengths (crushing, shear 13, shear 23)" + in_stress);
      return strong(name) + ": " + joined(parts, "; ") + ".";
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
      if (items.empty())
        return none.empty() ? "" : paragraph(none);
      return "<h3>" + lead + "</h3>\n" + list(items);
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
              enumerated(factors) +
              ": what multiplies all loads and all prescribed displacements.";
      if (run.says("Find") == "first failure")
        text += " After them the load factor is sought at which the first ply "
                "fails.";
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
                "displacements and rotations are small, contact has no friction."));
    html += sentences(run, "Bodies", "Bodies", "", body_words);
    html += sentences(run, "Materials", "Materials", "", material_words);
    html += sentences(run, "Supports", "What holds it", "", support_words);
    html += sentences(run,
                      "Loads",
                      "What loads it",
                      "No loads act; what moves the bodies is prescribed.",
                      load_words);
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
