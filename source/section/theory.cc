// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/section/theory.h>

#include <algorithm>
#include <regex>
#include <set>
#include <tuple>
#include <utility>

namespace lamella
{
  std::string
  Theory::name() const
  {
    if (kind == Kind::undefined)
      return "undefined";
    std::string name     = name_of(kind);
    const bool  plain_sv = kind == Kind::SV && order == 0;
    if (!is_classical() && !plain_sv)
      name += "-" + std::to_string(order);
    if (kind == Kind::SV)
      name += " (of LE-" + std::to_string(section_order) + ")";
    // L9 is how the literature calls the element of degree 2.
    if (kind == Kind::LE)
      name += " (L" + std::to_string((order + 1) * (order + 1)) + ")";
    return name;
  }



  Theory
  Theory::of_section() const
  {
    Theory theory = *this;
    if (kind == Kind::SV)
      {
        theory.kind  = Kind::LE;
        theory.order = section_order;
      }
    theory.section_order = default_section_order;
    return theory;
  }



  namespace
  {
    /// The family of a theory and its rank in it.
    std::pair<Theory::Kind, double>
    rank_of(const Theory &theory)
    {
      if (theory.keeps_sections_normal())
        return {Theory::Kind::TE, 0.};
      if (theory.is_classical())
        return {Theory::Kind::TE, 0.5};
      return {theory.kind, theory.order};
    }



    Theory
    theory_of(const Theory::Kind kind, const unsigned int order)
    {
      Theory theory;
      theory.kind  = kind;
      theory.order = order;
      return theory;
    }



    unsigned int
    section_order_of(const Entry &entry)
    {
      return entry.text() == "auto" ? Theory::default_section_order :
                                      entry.whole(1, 8);
    }



    /// The theory @p word of the list @p all.
    Theory
    parse_piece(const Entry &all, const std::string &word)
    {
      const Theory theory = Theory::parse({all.path(), word});
      if (theory.is_classical())
        all.refuse(
          "section.classical-theory-in-pieces: " + word +
            " uses a reduced material law and cannot be part of Theories",
          "Write SV instead.");
      if (theory.kind == Theory::Kind::TE)
        all.refuse("section.taylor-theory-in-pieces: " + word +
                     " has section functions that LE-N and SV-N do not "
                     "contain, so they cannot be joined",
                   "Use LE-N and SV-N in Theories, or TE-N as Theory.");
      if (theory.kind == Theory::Kind::solid)
        all.refuse(
          "section.solid-in-pieces: " + word +
            " is no beam theory, but Theories accepts beam theories only",
          "Write only LE-N and SV-N in Theories, or use a separate "
          "body with the solid theory.");
      return theory;
    }



    /// Gives all the section space of the highest LE-N, or of @p order.
    void
    set_section_orders(std::vector<Theory> &theories,
                       const Entry         &order,
                       const Entry         &all)
    {
      std::set<unsigned int> degrees, waves;
      bool                   only_LE = true;
      for (const Theory &theory : theories)
        if (theory.kind == Theory::Kind::LE)
          degrees.insert(theory.order);
        else
          {
            only_LE = false;
            if (theory.order > 0)
              waves.insert(theory.order);
          }
      if (waves.size() > 1)
        all.refuse("section.different-orders-of-sv: SV-" +
                     std::to_string(*waves.begin()) + " and SV-" +
                     std::to_string(*waves.rbegin()) +
                     " have different wave numbers",
                   "Write the same N for each SV-N in Theories, or SV.");
      const unsigned int highest = degrees.empty() ? 0 : *degrees.rbegin();
      const unsigned int space   = order.text() == "auto" && highest > 0 ?
                                     highest :
                                     section_order_of(order);
      if (space < highest)
        order.refuse("section.section-order-too-low: Theories has LE-" +
                       std::to_string(highest) + ", with a higher degree",
                     "Write Section order = auto, or " +
                       std::to_string(highest) + " or more.");
      if (only_LE && space > highest)
        order.refuse("section.section-order-unused: only SV-N has it",
                     "Theories has no SV-N: write Section order = auto.");
      for (Theory &theory : theories)
        {
          theory.section_order = space;
          theory.hierarchical  = !degrees.empty() && *degrees.begin() < space;
        }
    }
  } // namespace



  Theory
  Theory::to_saint_venant(const unsigned int waves) const
  {
    Theory theory        = *this;
    theory.kind          = Kind::SV;
    theory.section_order = order;
    theory.order         = waves;
    return theory;
  }



  bool
  Theory::holds(const Theory &other) const
  {
    const auto [family, rank]     = rank_of(*this);
    const auto [of_other, lowest] = rank_of(other);
    return family == of_other && rank >= lowest;
  }



  Theory
  Theory::layerwise(const unsigned int order)
  {
    return theory_of(Kind::LE, order);
  }



  Theory
  Theory::make_saint_venant(const unsigned int waves, const unsigned int degree)
  {
    Theory theory        = theory_of(Kind::SV, waves);
    theory.section_order = degree;
    return theory;
  }



  Theory
  Theory::taylor(const unsigned int order)
  {
    return theory_of(Kind::TE, order);
  }



  Theory
  Theory::solid(const unsigned int order)
  {
    return theory_of(Kind::solid, order);
  }



  Theory
  Theory::parse(const Entry &entry)
  {
    static const std::regex of_order("(TE|LE|SV|solid)-([0-9]{1,4})");
    const std::string       remedy =
      "Use SV or SV-N with N from 0 to 40, LE-N with N from 1 to 8 (LE-2 is "
      "L9), TE-N with N from 1 to 20, EBBT, TBT, or solid-1 or solid-2.";

    Theory theory;
    theory.kind  = named<Kind>(entry.text()).value_or(Kind::undefined);
    theory.order = theory.kind == Kind::SV ? 0 : 1;
    if (theory.is_classical() || theory.kind == Kind::SV)
      return theory;

    std::smatch match;
    if (!std::regex_match(entry.text(), match, of_order))
      entry.refuse("section.unknown-theory: there is no theory of this name",
                   remedy);
    theory.kind              = *named<Kind>(match[1]);
    theory.order             = std::stoi(match[2]);
    const unsigned int least = theory.kind == Kind::SV ? 0 : 1,
                       limit = theory.kind == Kind::TE ? 20 :
                               theory.kind == Kind::LE ? 8 :
                               theory.kind == Kind::SV ? 40 :
                                                         2;
    if (theory.order < least || theory.order > limit)
      entry.refuse("section.order-out-of-range: the number N is out of range",
                   remedy);
    return theory;
  }



  void
  TheoryParameters::declare(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Theory",
                      "",
                      dealii::Patterns::Anything(),
                      "Theory of this body, instead of that of the scene.");
    prm.declare_entry(
      "Theories",
      "",
      dealii::Patterns::Anything(),
      "Instead of Theory: one theory for each part of the axis between Theory "
      "breaks, as in LE-2, SV-6, LE-3; LE-N and SV-N only.");
    prm.declare_entry("Theory breaks",
                      "",
                      patterns::numbers(),
                      "Ascending distances from the start of the axis at which "
                      "one of Theories ends and the next begins [length].");
    prm.declare_entry(
      "Section order",
      "auto",
      patterns::WordOrPattern("auto", patterns::Whole(1, 8)),
      "For SV and SV-N: degree of the layer-wise functions that approximate "
      "their section functions. It adds section problems but no DoFs. auto: 3, "
      "or the highest N of LE-N in Theories.");
    prm.declare_entry(
      "Poisson correction",
      "true",
      dealii::Patterns::Bool(),
      "Whether sections of EBBT, TBT and TE-1 contract freely; else Poisson "
      "locking makes deflections 26 % too small at nu = 0.3.");
    prm.declare_entry("Shear factor",
                      "1",
                      patterns::positive(),
                      "For TBT only: shear correction factor k of k G A, 5/6 "
                      "for rectangles of one material, 1 in the paper.");
  }



  Theory
  TheoryParameters::parse(const Entries &in, const Entry &scene_theory)
  {
    const Entry own = in["Theory"], factor = in["Shear factor"];
    Theory      theory   = Theory::parse(own.is_empty() ? scene_theory : own);
    theory.section_order = section_order_of(in["Section order"]);
    theory.poisson_correction = in["Poisson correction"].boolean();
    theory.shear_factor       = factor.positive();
    if (theory.shear_factor > 1.)
      factor.refuse(
        "section.shear-factor-above-one: the shear correction factor must be "
        "more than 0 and at most 1, for example 5/6 = 0.8333");
    return theory;
  }



  TheoryPieces
  TheoryParameters::parse_pieces(const Entries &in, const double length)
  {
    const Entry  all = in["Theories"], breaks = in["Theory breaks"];
    TheoryPieces pieces;
    pieces.breaks = breaks.ascending(length, "the length");
    if (all.is_empty())
      {
        if (!pieces.breaks.empty())
          breaks.refuse(
            "section.breaks-without-theories: Theory breaks divides the axis "
            "into parts, but there are no Theories for these parts",
            "Write one of Theories for each part, or remove Theory breaks.");
        return {};
      }
    for (const std::string &word : all.items())
      pieces.theories.push_back(parse_piece(all, word));
    if (pieces.theories.size() != pieces.breaks.size() + 1)
      all.refuse("section.count-of-theories: Theory breaks make " +
                   std::to_string(pieces.breaks.size() + 1) +
                   " parts, but the number of theories is " +
                   std::to_string(pieces.theories.size()),
                 "Write one theory for each part, as in LE-2, SV-6, LE-2.");
    if (!in["Theory"].is_empty())
      all.refuse("section.theory-and-theories: Theory = " +
                   in["Theory"].text() + " is also given for this body",
                 "Remove Theory or Theories.");
    set_section_orders(pieces.theories, in["Section order"], all);
    return pieces;
  }



  Theory
  TheoryPieces::leading() const
  {
    return *std::max_element(theories.begin(),
                             theories.end(),
                             [](const Theory &a, const Theory &b) {
                               return std::make_tuple(a.kind, a.order) <
                                      std::make_tuple(b.kind, b.order);
                             });
  }



  bool
  operator<(const Theory &a, const Theory &b)
  {
    const auto key = [](const Theory &t) {
      return std::make_tuple(t.kind,
                             t.order,
                             t.section_order,
                             t.hierarchical,
                             t.poisson_correction,
                             t.shear_factor,
                             t.twists);
    };
    return key(a) < key(b);
  }
} // namespace lamella
