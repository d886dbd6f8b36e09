// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/section/theory.h>

#include <regex>
#include <tuple>

namespace lamella
{
  std::string
  Theory::name() const
  {
    switch (kind)
      {
        case Kind::EBBT:
          return "EBBT";
        case Kind::TBT:
          return "TBT";
        case Kind::TE:
          return "TE-" + std::to_string(order);
        case Kind::LE:
          // L9 is how the literature calls the element of degree 2.
          return "LE-" + std::to_string(order) + " (L" +
                 std::to_string((order + 1) * (order + 1)) + ")";
        case Kind::solid:
          return "solid-" + std::to_string(order);
        default:
          return "undefined";
      }
  }



  Theory
  Theory::parse(const std::string &text, const std::string &what)
  {
    static const std::regex form("(TE|LE|solid)-([0-9]{1,4})");
    const std::string       rule =
      "Use EBBT, TBT, TE-N with N from 1 to 20, LE-N with N from 1 to 8 "
      "(LE-2 is L9), or solid-1 or solid-2.";

    Theory theory;
    theory.order = 1;
    std::smatch match;
    if (text == "EBBT" || text == "TBT")
      theory.kind = text == "EBBT" ? Kind::EBBT : Kind::TBT;
    else if (std::regex_match(text, match, form))
      {
        theory.kind              = match[1] == "TE" ? Kind::TE :
                                   match[1] == "LE" ? Kind::LE :
                                                      Kind::solid;
        theory.order             = std::stoi(match[2]);
        const unsigned int limit = theory.kind == Kind::TE ? 20 :
                                   theory.kind == Kind::LE ? 8 :
                                                             2;
        if (theory.order < 1 || theory.order > limit)
          throw InputError(what + " = " + text + ": N is out of range. " +
                           rule);
      }
    else
      throw InputError(what + " = " + text + ": no such theory. " + rule);
    return theory;
  }



  void
  TheoryParameters::declare(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    prm.declare_entry("Theory",
                      "",
                      Anything(),
                      "Overrides the scene's Theory for this body.");
    prm.declare_entry("Poisson correction",
                      "true",
                      Anything(),
                      "Whether sections of EBBT, TBT and TE-1 contract freely; "
                      "without it they are too stiff (Poisson locking: a "
                      "deflection about 26 % too small at nu = 0.3). Other "
                      "theories contract by themselves.");
    prm.declare_entry("Shear factor",
                      "1",
                      Anything(),
                      "Of TBT: the shear correction factor k of k G A, 5/6 for "
                      "rectangles of one material; 1 as in the paper. Other "
                      "theories have none and ignore it.");
  }



  TheoryParameters
  TheoryParameters::parse(const dealii::ParameterHandler &prm)
  {
    return {prm.get("Theory"),
            prm.get("Poisson correction"),
            prm.get("Shear factor")};
  }



  Theory
  TheoryParameters::resolve(const std::string &scene_theory,
                            const std::string &what) const
  {
    Theory result = theory.empty() ? Theory::parse(scene_theory, "Theory") :
                                     Theory::parse(theory, what + "/Theory");
    result.poisson_correction =
      to_bool(poisson_correction, what + "/Poisson correction");
    const std::string entry = what + "/Shear factor = " + shear_factor;
    result.shear_factor     = to_number(shear_factor, entry);
    if (!(result.shear_factor > 0. && result.shear_factor <= 1.))
      throw InputError(entry + ": must be above 0 and at most 1.");
    return result;
  }



  bool
  operator<(const Theory &a, const Theory &b)
  {
    const auto key = [](const Theory &t) {
      return std::make_tuple(t.kind,
                             t.order,
                             t.poisson_correction,
                             t.shear_factor);
    };
    return key(a) < key(b);
  }
} // namespace lamella
