// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/section/theory.h>

#include <regex>
#include <tuple>

namespace lamella
{
  std::string
  Theory::name() const
  {
    if (kind == Kind::undefined)
      return "undefined";
    std::string name = name_of(kind);
    if (!is_classical())
      name += "-" + std::to_string(order);
    // L9 is how the literature calls the element of degree 2.
    if (kind == Kind::LE)
      name += " (L" + std::to_string((order + 1) * (order + 1)) + ")";
    return name;
  }



  Theory
  Theory::parse(const Entry &entry)
  {
    static const std::regex of_order("(TE|LE|solid)-([0-9]{1,4})");
    const std::string       remedy =
      "Use EBBT, TBT, TE-N with N from 1 to 20, LE-N with N from 1 to 8 "
      "(LE-2 is L9), or solid-1 or solid-2.";

    Theory theory;
    theory.kind  = named<Kind>(entry.text()).value_or(Kind::undefined);
    theory.order = 1;
    if (theory.is_classical())
      return theory;

    std::smatch match;
    if (!std::regex_match(entry.text(), match, of_order))
      entry.refuse("no such theory", remedy);
    theory.kind              = *named<Kind>(match[1]);
    theory.order             = std::stoi(match[2]);
    const unsigned int limit = theory.kind == Kind::TE ? 20 :
                               theory.kind == Kind::LE ? 8 :
                                                         2;
    if (theory.order < 1 || theory.order > limit)
      entry.refuse("N is out of range", remedy);
    return theory;
  }



  void
  TheoryParameters::declare(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Theory",
                      "",
                      dealii::Patterns::Anything(),
                      "Overrides the scene's Theory for this body.");
    prm.declare_entry("Poisson correction",
                      "true",
                      dealii::Patterns::Bool(),
                      "Whether sections of EBBT, TBT and TE-1 contract freely; "
                      "without it they are too stiff (Poisson locking: a "
                      "deflection about 26 % too small at nu = 0.3). Other "
                      "theories contract by themselves.");
    prm.declare_entry("Shear factor",
                      "1",
                      patterns::positive(),
                      "Of TBT: the shear correction factor k of k G A, 5/6 for "
                      "rectangles of one material; 1 as in the paper. Other "
                      "theories have none and ignore it.");
  }



  Theory
  TheoryParameters::parse(const Entries &in, const Entry &scene_theory)
  {
    const Entry own = in["Theory"], factor = in["Shear factor"];
    Theory      theory = Theory::parse(own.is_empty() ? scene_theory : own);
    theory.poisson_correction = in["Poisson correction"].truth();
    theory.shear_factor       = factor.positive();
    if (theory.shear_factor > 1.)
      factor.refuse("must be above 0 and at most 1");
    return theory;
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
