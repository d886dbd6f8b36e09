// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/conditions/parameters.h>
#include <lamella/recover/requests.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  std::vector<Reference>
  parse_references(const std::string              &text,
                   const std::vector<std::string> &quantities,
                   const std::string              &what)
  {
    std::vector<Reference> references;
    for (const std::string &piece : split(text, '|'))
      {
        const auto parts = split(piece, ':');
        if (parts.size() < 3)
          throw InputError(what + "/References: '" + piece +
                           "' must be quantity: value: source, with '|' "
                           "between references.");
        if (std::find(quantities.begin(), quantities.end(), parts[0]) ==
            quantities.end())
          throw InputError(what + "/References: there is no quantity '" +
                           parts[0] + "'. The nearest is '" +
                           nearest_name(parts[0], quantities) +
                           "'; all of them: " + joined(quantities) + ".");
        references.push_back({parts[0],
                              to_number(parts[1], what + "/References"),
                              joined({parts.begin() + 2, parts.end()}, ": ")});
      }
    return references;
  }



  namespace
  {
    std::pair<unsigned int, dealii::Point<3>>
    parse_place(const ParameterHandler         &prm,
                const std::string              &entry,
                const std::vector<std::string> &bodies,
                const std::string              &what)
    {
      const std::string name = what + "/" + entry;
      if (trimmed(prm.get(entry)).empty())
        throw InputError(name + " is missing: write BODY: x, y, z.");
      const auto [body, rest] = parse_on_body(prm.get(entry), bodies, name);
      return {body, to_point(rest, name)};
    }



    unsigned int
    parse_samples(const ParameterHandler &prm,
                  const unsigned int      least,
                  const unsigned int      most,
                  const std::string      &what)
    {
      const double n = to_number(prm.get("Samples"), what + "/Samples");
      if (!(n >= least && n <= most && n == std::floor(n)))
        throw InputError(what + "/Samples = " + prm.get("Samples") +
                         ": must be a whole number from " +
                         std::to_string(least) + " to " + std::to_string(most) +
                         ".");
      return static_cast<unsigned int>(n);
    }
  } // namespace



  namespace
  {
    void
    declare_stress(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Stress",
        "element",
        Anything(),
        "Strains and stresses where elements of one ply meet. element: their "
        "mean, elsewhere the element's own. nodal: means at nodes, "
        "interpolated. recovered: superconvergent patch recovery, an order "
        "more accurate on smooth fields. All within a ply, never across an "
        "interface.");
    }



    StressValues
    parse_stress(const ParameterHandler &prm, const std::string &what)
    {
      return parse_stress_values(prm.get("Stress"), what + "/Stress");
    }
  } // namespace



  void
  declare_probe(ParameterHandler &prm)
  {
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "BODY: x, y, z, a scene position in the body [length].");
    declare_stress(prm);
    prm.declare_entry("References",
                      "",
                      Anything(),
                      "Values to print beside the results, quantity: value: "
                      "source, between '|'. Quantities are the columns of "
                      "probes.csv.");
  }



  Probe
  parse_probe(const ParameterHandler         &prm,
              const std::string              &name,
              const std::vector<std::string> &bodies)
  {
    const std::string what      = "Probe " + name;
    const auto [body, position] = parse_place(prm, "At", bodies, what);
    return {name,
            body,
            position,
            parse_stress(prm, what),
            parse_references(prm.get("References"), field_names(), what)};
  }



  void
  declare_line(ParameterHandler &prm)
  {
    prm.declare_entry("From", "", Anything(), "BODY: x, y, z [length].");
    prm.declare_entry("To", "", Anything(), "The same body: x, y, z [length].");
    declare_stress(prm);
    prm.declare_entry("Samples",
                      "10",
                      Anything(),
                      "Points in each ply that the line crosses, both sides of "
                      "each interface among them.");
  }



  Line
  parse_line(const ParameterHandler         &prm,
             const std::string              &name,
             const std::vector<std::string> &bodies)
  {
    const std::string what   = "Line " + name;
    const auto [first, from] = parse_place(prm, "From", bodies, what);
    const auto [second, to]  = parse_place(prm, "To", bodies, what);
    if (first != second)
      throw InputError(what + ": From and To must be on the same body.");
    if (from.distance(to) == 0.)
      throw InputError(what +
                       ": From and To are the same point. Move one of them.");
    return {name,
            first,
            from,
            to,
            parse_stress(prm, what),
            parse_samples(prm, 2, 100000, what)};
  }



  void
  declare_cut(ParameterHandler &prm)
  {
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "BODY: distance from the start of its axis [length].");
    declare_stress(prm);
    prm.declare_entry("Samples",
                      "8",
                      Anything(),
                      "Intervals in each direction of a section cell.");
  }



  Cut
  parse_cut(const ParameterHandler         &prm,
            const std::string              &name,
            const std::vector<std::string> &bodies)
  {
    const std::string what = "Cut " + name;
    const auto [body, text] =
      parse_on_body(prm.get("At"), bodies, what + "/At");
    return {name,
            body,
            to_number(text, what + "/At"),
            parse_stress(prm, what),
            parse_samples(prm, 1, 100, what)};
  }
} // namespace lamella
