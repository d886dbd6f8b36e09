// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/base/text.h>
#include <lamella/conditions/parameters.h>

#include <algorithm>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  std::pair<unsigned int, std::string>
  parse_on_body(const Entry &entry, const std::vector<std::string> &bodies)
  {
    const std::string &text  = entry.text();
    const auto         colon = text.find(':');
    if (colon == std::string::npos)
      entry.refuse("conditions.invalid-region: write the name of a body, a "
                   "colon, and a part of the body, as in upper: ends");
    const std::string name  = trimmed(text.substr(0, colon));
    const auto        found = std::find(bodies.begin(), bodies.end(), name);
    if (found == bodies.end())
      entry.refuse("conditions.unknown-body: there is no body '" + name + "'",
                   "Check the spelling: the most similar name in Bodies is '" +
                     nearest_name(name, bodies) + "'.");
    return {found - bodies.begin(), trimmed(text.substr(colon + 1))};
  }



  namespace
  {
    /// Throws InputError unless @p points of entry @p at suit @p kind.
    void
    check_positions(const Entry                         &at,
                    const std::vector<dealii::Point<3>> &points,
                    const Region::Kind                   kind)
    {
      const bool is_point = kind == Region::Kind::point;
      if (is_point ? points.empty() : points.size() != 2)
        at.refuse("conditions.count-of-points: a " + name_of(kind) +
                    " in On needs " +
                    (is_point ? "at least one point" : "its two end points") +
                    " here",
                  "Write x, y, z for each point, as in 0, 1, 0; 0, 2, 0.");
      if (!is_point && points[0].distance(points[1]) == 0.)
        at.refuse("conditions.line-without-length: the line has no length",
                  "Write two different points, or On = BODY: point.");
    }



    /// `BODY: point`, `line`, `body` or the name of a surface.
    Region
    parse_region(const Entry                         &piece,
                 const Entry                         &at,
                 const std::vector<dealii::Point<3>> &points,
                 const std::vector<std::string>      &bodies)
    {
      const auto [body, word] = parse_on_body(piece, bodies);
      Region region;
      region.body = body;
      region.kind = named<Region::Kind>(word).value_or(Region::Kind::surface);
      if (region.kind == Region::Kind::surface)
        region.surface = word;
      else if (region.kind != Region::Kind::body)
        {
          check_positions(at, points, region.kind);
          region.at = points;
        }
      return region;
    }



    /// Throws InputError if @p region is one of @p others.
    void
    check_is_new(const Region                   &region,
                 const std::vector<Region>      &others,
                 const Entry                    &on,
                 const std::vector<std::string> &bodies)
    {
      for (const Region &other : others)
        if (other.body == region.body && other.kind == region.kind &&
            other.surface == region.surface)
          on.refuse("conditions.repeated-region: the region '" +
                      bodies[region.body] + ": " +
                      (region.kind == Region::Kind::surface ?
                         region.surface :
                         name_of(region.kind)) +
                      "' is given twice",
                    region.kind == Region::Kind::line ?
                      "At holds the two ends of one line; for a second line "
                      "write a second subsection." :
                      "Remove one of the two.");
    }



    /// The scene components of a displacement, each a number or free.
    std::array<std::optional<double>, 3>
    parse_components(const Entry &entry)
    {
      std::array<std::optional<double>, 3> u{{0., 0., 0.}};
      if (entry.is_empty())
        return u;
      const std::vector<std::string> components = entry.items();
      if (components.size() != 3)
        entry.refuse("conditions.count-of-components: write three values, each "
                     "a number or 'free', as in 0, free, 0");
      for (unsigned int c = 0; c < 3; ++c)
        u[c] = components[c] == "free" ?
                 std::optional<double>() :
                 std::optional<double>(entry.number(components[c]));
      if (!u[0] && !u[1] && !u[2])
        entry.refuse("conditions.all-components-free: all three components are "
                     "free, so this support constrains nothing",
                     "Remove the support, or prescribe a component.");
      return u;
    }



    double
    parse_normal(const Entry               &entry,
                 const Entry               &components,
                 const std::vector<Region> &regions)
    {
      if (!components.is_empty())
        entry.refuse("conditions.normal-and-u: Normal displacement and u "
                     "cannot both be prescribed",
                     "Remove one of the two.");
      for (const Region &region : regions)
        if (region.kind != Region::Kind::surface)
          entry.refuse(
            "conditions.normal-without-surface: On names a point, a line or a "
            "body, and only surfaces have a normal",
            "Name surfaces in On, as in upper: start, or prescribe u instead.");
      return entry.number();
    }



    /// The rotation and its center of @p support, all else of which is there.
    void
    parse_rotation(const Entries &in, Support &support)
    {
      const Entry entry = in["Rotation"], about = in["About"];
      if (entry.is_empty())
        {
          if (!about.is_empty())
            about.refuse(
              "conditions.about-without-rotation: About is the center of a "
              "Rotation, but the support has no Rotation",
              "Remove About, or write Rotation.");
          return;
        }
      if (support.normal)
        entry.refuse(
          "conditions.normal-and-rotation: Rotation and Normal displacement "
          "cannot both be prescribed",
          "Remove one of the two.");
      if (!support.u[0] || !support.u[1] || !support.u[2])
        entry.refuse("conditions.rotation-with-free-u: a Rotation prescribes "
                     "all displacement components, but some of u are free",
                     "Write three numbers in u, or remove u.");
      support.rotation = entry.point();
      if (!about.is_empty())
        support.about = about.point();
    }



    /// Throws InputError if two of the @p regions of the entry @p on are parts
    /// of each other: the load would act twice there.
    void
    check_no_overlap(const Entry                    &on,
                     const std::vector<Region>      &regions,
                     const std::vector<std::string> &bodies)
    {
      for (const Region &a : regions)
        for (const Region &b : regions)
          if (&a != &b && a.body == b.body && b.kind == Region::Kind::surface &&
              a.covers(b.surface))
            on.refuse("conditions.overlapping-surfaces: '" + b.surface +
                        "' of body '" + bodies[b.body] + "' is part of '" +
                        a.surface + "', so the load would act twice there",
                      "Remove one of the two surfaces from On.");
    }



    void
    declare_place_of_load(ParameterHandler &prm)
    {
      prm.declare_entry(
        "On",
        "",
        Anything(),
        "Region that is loaded: BODY: point, line, body (Temperature only) or "
        "a surface (left, right, bottom, top, start, end, ends), as in upper: "
        "top; several with semicolons between.");
      prm.declare_entry("At",
                        "",
                        Anything(),
                        "Scene coordinates x, y, z of points or of the two "
                        "ends of a line, as for a support [length].");
    }



    void
    declare_forces(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Force",
        "",
        Anything(),
        "Three components in scene coordinates, expressions of x, y, z "
        "(muParser) with commas between: a force at a point [force], along a "
        "line [force/length], on a surface [force/length^2].");
      prm.declare_entry("Total force",
                        "",
                        patterns::numbers(),
                        "Total force on all surfaces or lines of On, three "
                        "components in scene coordinates, spread evenly over "
                        "their area or length [force].");
      prm.declare_entry(
        "Pressure",
        "",
        Anything(),
        "Pressure on a surface, against its outward normal: an expression of "
        "x, y, z [force/length^2]. With Rotations = large, `12, follows` is a "
        "follower load, normal to the rotated surface and per deformed area; "
        "without follows it is a dead load.");
      prm.declare_entry(
        "Couple",
        "",
        patterns::numbers(),
        "Moment on a surface such as start or end: three components in scene "
        "coordinates [force x length], applied as tractions that vary linearly "
        "over the surface and have no resultant force. With Rotations = large "
        "the tractions rotate, the moment keeps its direction.");
    }



    /// Throws InputError unless the regions of @p load, which the entry @p on
    /// gives, suit what the entry @p what puts there.
    void
    check_regions(const Entry &on, const Entry &what, const Load &load)
    {
      const bool heats         = !load.temperature.empty(),
                 needs_surface = load.couple || !load.pressure.empty();
      for (const Region &region : load.on)
        {
          const bool is_body = region.kind == Region::Kind::body;
          if (heats && !is_body)
            on.refuse("conditions.temperature-of-part: Temperature acts on "
                      "whole bodies",
                      "Write On = NAME: body, with the name of the body. A "
                      "temperature that varies is an expression, for example "
                      "50*z.");
          if (!heats && is_body)
            on.refuse("conditions.load-on-body: a load other than a "
                      "Temperature acts on a point, a line or a surface",
                      "Name a surface in On; for weight use Gravity.");
          if (needs_surface && region.kind != Region::Kind::surface)
            what.refuse(
              "conditions.needs-surface: Pressure and Couple need a surface",
              "Name a surface in On, or use Force for points and lines.");
          if (load.couple && region.is_several_surfaces())
            on.refuse("conditions.couple-on-surfaces: '" + region.surface +
                        "' names several surfaces, but a Couple acts on one",
                      "Name one surface: start, end, or a side such as top.");
        }
    }



    const std::string is_follower = "follows";



    /// Whether @p pressure ends with `, follows`, which is taken off.
    bool
    parse_follower(Formula &pressure)
    {
      const std::string text  = pressure.text();
      const std::size_t comma = text.rfind(',');
      if (comma == std::string::npos ||
          trimmed(text.substr(comma + 1)) != is_follower)
        return false;
      pressure = Formula(trimmed(text.substr(0, comma)));
      return true;
    }



    /// The three components of a moment or a force, @p names.
    dealii::Tensor<1, 3>
    parse_vector(const Entry &entry, const std::string &names)
    {
      const std::vector<double> n = entry.numbers();
      if (n.size() != 3)
        entry.refuse(
          "conditions.count-of-components: there must be three numbers, " +
          names + ", but there are " + std::to_string(n.size()) + " here");
      return dealii::Point<3>(n[0], n[1], n[2]);
    }



    /// Throws InputError unless the total @p what can be spread over the
    /// regions of @p load: there is one measure for all of them.
    void
    check_total(const Entry &what, const Load &load)
    {
      for (const Region &region : load.on)
        if (region.kind == Region::Kind::point)
          what.refuse("conditions.total-force-at-point: a Total force is "
                      "spread over surfaces or lines, but On names a point",
                      "Use Force for a point.");
        else if (region.kind != load.on.front().kind)
          what.refuse("conditions.mixed-regions: a Total force cannot be "
                      "spread over both surfaces and lines",
                      "Write one load for the surfaces and one for the lines.");
    }
  } // namespace



  std::vector<Region>
  parse_regions(const Entry                    &on,
                const Entry                    &at,
                const std::vector<std::string> &bodies)
  {
    std::vector<dealii::Point<3>> points;
    for (const std::string &point : at.items(';'))
      points.push_back(at.point(point));

    std::vector<Region> regions;
    for (const std::string &piece : on.items(';'))
      {
        // A semicolon at the end is no fault.
        if (piece.empty())
          continue;
        const Region region =
          parse_region(Entry(on.path(), piece), at, points, bodies);
        check_is_new(region, regions, on, bodies);
        regions.push_back(region);
      }
    if (regions.empty())
      on.refuse_missing("conditions.no-region: write BODY: point, BODY: line, "
                        "BODY: body or BODY: SURFACE, as in upper: top.");
    const bool uses_points =
      std::any_of(regions.begin(), regions.end(), [](const Region &r) {
        return !r.at.empty();
      });
    if (!points.empty() && !uses_points)
      at.refuse("conditions.positions-unused: On needs no positions",
                "Remove At, or write BODY: point or BODY: line in On.");
    return regions;
  }



  void
  HistoryParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Factors",
                      "",
                      Anything(),
                      "One factor for each load step, instead of Load factors. "
                      "Empty: Load factors apply. harmonic: the value is the "
                      "amplitude of an oscillation (Find = response), and has "
                      "no part in the load steps.");
  }



  unsigned int
  HistoryParameters::parse(const Entries &in, std::vector<LoadFactor> &steps)
  {
    const Entry entry = in["Factors"];
    if (entry.is_empty())
      return 0;
    const bool                oscillates = entry.text() == "harmonic";
    const std::vector<double> factors =
      oscillates ? std::vector<double>(steps.size(), 0.) : entry.numbers();
    if (factors.size() != steps.size())
      entry.refuse("conditions.count-of-factors: there are " +
                     std::to_string(factors.size()) +
                     " factors, but the scene has " +
                     std::to_string(steps.size()) + " Load factors",
                   "Write one factor for each load step.");
    unsigned int number = 0;
    for (unsigned int k = 0; k < steps.size(); ++k)
      number = steps[k].add(factors[k], oscillates);
    return number;
  }



  void
  SupportParameters::declare(ParameterHandler &prm)
  {
    HistoryParameters::declare(prm);
    prm.declare_entry(
      "On",
      "",
      Anything(),
      "Supported region, BODY: point, line, start, end, ends, body or a "
      "surface (left, right, bottom, top), several between semicolons.");
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "Scene coordinates x, y, z of points, with semicolons "
                      "between, or of the two ends of a line [length].");
    prm.declare_entry("u",
                      "",
                      Anything(),
                      "Prescribed displacement, three components in scene "
                      "coordinates, multiplied by the load factor; 'free' "
                      "leaves a component free. Empty: 0, 0, 0 [length].");
    prm.declare_entry("Normal displacement",
                      "",
                      patterns::optional(patterns::number()),
                      "On surfaces, instead of u: displacement along the "
                      "outward normal; 0: symmetry [length].");
    prm.declare_entry(
      "Rotation",
      "",
      Anything(),
      "Rotation of the supported region as a rigid body, multiplied by the "
      "load factor: a vector along the axis of rotation, its length the angle "
      "[rad]. u, if given, is the displacement of the center of rotation "
      "(About) and has no free component.");
    prm.declare_entry("About",
                      "",
                      Anything(),
                      "Center of Rotation in scene coordinates [length]. "
                      "Empty: the center of On.");
  }



  Support
  SupportParameters::parse(const Entries                  &in,
                           const std::string              &name,
                           const std::vector<std::string> &bodies)
  {
    Support support;
    support.name       = name;
    support.on         = parse_regions(in["On"], in["At"], bodies);
    const Entry normal = in["Normal displacement"];
    if (normal.is_empty())
      support.u = parse_components(in["u"]);
    else
      support.normal = parse_normal(normal, in["u"], support.on);
    parse_rotation(in, support);
    return support;
  }



  void
  LoadParameters::declare(ParameterHandler &prm)
  {
    declare_place_of_load(prm);
    HistoryParameters::declare(prm);
    declare_forces(prm);
    prm.declare_entry(
      "Temperature",
      "",
      Anything(),
      "Temperature of whole bodies (On = BODY: body) above the stress-free "
      "temperature: an expression of x, y, z [K]. It acts in full in each load "
      "step, whatever the load factor.");
  }



  Load
  LoadParameters::parse(const Entries                  &in,
                        const std::string              &name,
                        const std::vector<std::string> &bodies)
  {
    const std::vector<std::string> kinds{
      "Force", "Total force", "Pressure", "Couple", "Temperature"};
    std::vector<std::string> given;
    for (const std::string &kind : kinds)
      if (!in[kind].is_empty())
        given.push_back(kind);
    if (given.size() != 1)
      in.refuse("conditions.not-one-load: a load has exactly one of Force, "
                "Total force, Pressure, Couple and Temperature, but " +
                (given.empty() ? "none is" : joined(given, " and ") + " are") +
                " given");
    const Entry on = in["On"], what = in[given.front()];
    Load        load;
    load.name        = name;
    load.on          = parse_regions(on, in["At"], bodies);
    load.pressure    = in["Pressure"].text();
    load.is_follower = parse_follower(load.pressure);
    if (load.is_follower && load.pressure.empty())
      what.refuse(
        "conditions.follows-without-pressure: `follows` needs a pressure",
        "Write a number or an expression first, as in `12, follows`.");
    load.temperature = in["Temperature"].text();
    if (given.front() == "Couple")
      load.couple = parse_vector(what, "mx, my, mz");
    if (given.front() == "Total force")
      load.total = parse_vector(what, "fx, fy, fz");
    if (given.front() == "Force")
      {
        const std::vector<std::string> components = what.items();
        if (components.back() == is_follower)
          what.refuse("conditions.follows-not-pressure: a Force keeps its "
                      "direction and cannot follow rotations",
                      "Remove 'follows', or use a Pressure.");
        if (components.size() != 3)
          what.refuse("conditions.count-of-components: write three expressions "
                      "with commas between, as in 0, 0, -100*y");
        std::copy(components.begin(), components.end(), load.force.begin());
      }
    check_no_overlap(on, load.on, bodies);
    check_regions(on, what, load);
    if (load.total)
      check_total(what, load);
    return load;
  }
} // namespace lamella
