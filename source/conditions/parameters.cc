// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/parameters.h>

#include <algorithm>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  std::pair<unsigned int, std::string>
  parse_on_body(const std::string              &text,
                const std::vector<std::string> &bodies,
                const std::string              &what)
  {
    const auto colon = text.find(':');
    if (colon == std::string::npos)
      throw InputError(what + " = " + text +
                       ": write the body, a colon and the place on it, as in "
                       "upper: ends.");
    const std::string name  = trimmed(text.substr(0, colon));
    const auto        found = std::find(bodies.begin(), bodies.end(), name);
    if (found == bodies.end())
      throw InputError(what + " = " + text + ": there is no body '" + name +
                       "'. The nearest of Bodies is '" +
                       nearest_name(name, bodies) + "'.");
    return {found - bodies.begin(), trimmed(text.substr(colon + 1))};
  }



  std::vector<Region>
  parse_regions(const std::string              &on,
                const std::string              &at,
                const std::vector<std::string> &bodies,
                const std::string              &what)
  {
    std::vector<dealii::Point<3>> points;
    for (const std::string &point : split(at, ';'))
      points.push_back(to_point(point, what + "/At"));

    std::vector<Region> regions;
    for (const std::string &piece : split(on, ';'))
      {
        // A semicolon at the end is no fault.
        if (piece.empty())
          continue;
        const auto [body, word] = parse_on_body(piece, bodies, what + "/On");
        Region region;
        region.body = body;
        if (word == "point" || word == "line")
          {
            region.kind =
              word == "point" ? Region::Kind::point : Region::Kind::line;
            region.at = points;
            if (word == "point" ? points.empty() : points.size() != 2)
              throw InputError(
                what + "/At = " + at + ": a " + word +
                (word == "point" ? " needs at least one point" :
                                   " needs its two ends") +
                ", three numbers each, with ';' between points.");
            if (word == "line" && points[0].distance(points[1]) == 0.)
              throw InputError(what + "/At = " + at +
                               ": the two ends of the line are the same "
                               "point. Use On = BODY: point.");
          }
        else if (word == "body")
          region.kind = Region::Kind::body;
        else
          {
            region.kind    = Region::Kind::surface;
            region.surface = word;
          }
        const bool known =
          std::any_of(regions.begin(), regions.end(), [&](const Region &r) {
            return r.body == region.body && r.kind == region.kind &&
                   r.surface == region.surface;
          });
        if (known)
          throw InputError(what + "/On = " + on + ": names '" +
                           bodies[region.body] + ": " + word + "' twice. " +
                           (region.kind == Region::Kind::line ?
                              "At has the two ends of one line; write a second "
                              "subsection for a second line." :
                              "Keep one of the two."));
        regions.push_back(region);
      }
    if (regions.empty())
      throw InputError(what +
                       "/On is missing: write BODY: point, line, body or "
                       "the name of a surface such as ends or top.");
    const bool uses_points =
      std::any_of(regions.begin(), regions.end(), [](const Region &r) {
        return !r.at.empty();
      });
    if (!points.empty() && !uses_points)
      throw InputError(what + "/At = " + at +
                       ": nothing in On uses it. Only a point and a line have "
                       "positions; remove At or change On.");
    return regions;
  }



  void
  declare_support(ParameterHandler &prm)
  {
    prm.declare_entry("On",
                      "",
                      Anything(),
                      "Where: BODY: point, line, start, end, ends, body or a "
                      "surface (left, right, bottom, top); several between "
                      "semicolons.");
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "Scene positions x, y, z; of a point (several between "
                      "semicolons) or of the two ends of a line [length].");
    prm.declare_entry("u",
                      "",
                      Anything(),
                      "Scene components of the displacement, times the load "
                      "factor of the step, imposed exactly; 'free' leaves one "
                      "free. Empty: 0, 0, 0 [length].");
    prm.declare_entry("Normal displacement",
                      "",
                      Anything(),
                      "On surfaces, instead of u: the displacement along the "
                      "outward normal, the rest free; 0 is symmetry, whichever "
                      "way the body is turned [length].");
  }



  namespace
  {
    double
    parse_normal(const ParameterHandler    &prm,
                 const std::vector<Region> &regions,
                 const std::string         &what)
    {
      const std::string entry =
        what + "/Normal displacement = " + prm.get("Normal displacement");
      if (!prm.get("u").empty())
        throw InputError(entry + ": u is given, too. Keep one of the two.");
      for (const Region &region : regions)
        if (region.kind != Region::Kind::surface)
          throw InputError(entry +
                           ": only surfaces have a normal. Name surfaces in "
                           "On, or prescribe u.");
      return to_number(prm.get("Normal displacement"), entry);
    }
  } // namespace



  Support
  parse_support(const ParameterHandler         &prm,
                const std::string              &name,
                const std::vector<std::string> &bodies)
  {
    const std::string what = "Support " + name;
    Support           support;
    support.name = name;
    support.on   = parse_regions(prm.get("On"), prm.get("At"), bodies, what);
    if (!prm.get("Normal displacement").empty())
      {
        support.normal = parse_normal(prm, support.on, what);
        return support;
      }
    const std::string u = prm.get("u").empty() ? "0, 0, 0" : prm.get("u");
    const auto        components = split(u, ',');
    if (components.size() != 3)
      throw InputError(what + "/u = " + u +
                       ": must be three values between commas, each a number "
                       "or 'free'.");
    for (unsigned int c = 0; c < 3; ++c)
      if (components[c] != "free")
        support.u[c] = to_number(components[c], what + "/u");
    if (!support.u[0] && !support.u[1] && !support.u[2])
      throw InputError(what + "/u = " + u +
                       ": all components are free, so this is no support. "
                       "Remove it or prescribe one.");
    return support;
  }



  namespace
  {
    /// Throws InputError if two of @p regions are parts of each other: the load
    /// would act twice there.
    void
    check_no_overlap(const std::vector<Region>      &regions,
                     const std::vector<std::string> &bodies,
                     const std::string              &what)
    {
      const auto contains = [](const std::string &whole,
                               const std::string &part) {
        return whole == "all" ||
               (whole == "ends" && (part == "start" || part == "end"));
      };
      for (const Region &a : regions)
        for (const Region &b : regions)
          if (&a != &b && a.body == b.body && a.kind == Region::Kind::surface &&
              b.kind == a.kind && contains(a.surface, b.surface))
            throw InputError(what + ": '" + b.surface + "' of body '" +
                             bodies[b.body] + "' is part of '" + a.surface +
                             "', so the load would act twice there. Keep one "
                             "of the two.");
    }
  } // namespace



  void
  declare_load(ParameterHandler &prm)
  {
    prm.declare_entry("On",
                      "",
                      Anything(),
                      "Where: BODY: point, line or a surface (left, right, "
                      "bottom, top, start, end, ends); several between "
                      "semicolons.");
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "Scene positions x, y, z, as for a support [length].");
    prm.declare_entry(
      "Force",
      "",
      Anything(),
      "Three scene components, expressions of x, y, z (muParser) "
      "between commas: a force at a point [force], along a line "
      "[force/length], on a surface [force/length^2].");
    prm.declare_entry("Pressure",
                      "",
                      Anything(),
                      "On a surface, against its outward normal, an expression "
                      "of x, y, z [force/length^2].");
  }



  Load
  parse_load(const ParameterHandler         &prm,
             const std::string              &name,
             const std::vector<std::string> &bodies)
  {
    const std::string what = "Load " + name;
    Load              load;
    load.name     = name;
    load.on       = parse_regions(prm.get("On"), prm.get("At"), bodies, what);
    load.pressure = trimmed(prm.get("Pressure"));
    const std::vector<std::string> force = split(prm.get("Force"), ',');
    if (load.pressure.empty() == force.empty())
      throw InputError(what + ": give either Force or Pressure.");
    if (!force.empty() && force.size() != 3)
      throw InputError(what + "/Force = " + prm.get("Force") +
                       ": must be three expressions between commas.");
    std::copy(force.begin(), force.end(), load.force.begin());
    check_no_overlap(load.on, bodies, what + "/On = " + prm.get("On"));
    for (const Region &region : load.on)
      {
        if (region.kind == Region::Kind::body)
          throw InputError(what + "/On: a load acts on a point, a line or a "
                                  "surface, not on a whole body.");
        if (!load.pressure.empty() && region.kind != Region::Kind::surface)
          throw InputError(what + "/Pressure acts on a surface only; use Force "
                                  "at a point or along a line.");
      }
    return load;
  }
} // namespace lamella
