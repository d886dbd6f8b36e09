// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `adapt`: what of a theory a scene wants where. It owns the choice of
// the fields that each node of a beam carries, made from what touches the
// bodies: it asks conditions and contacts and makes bodies anew. What it solves
// are sections (their states and responses) and short pieces of a beam at an
// end (end_fields()); it never solves the scene and never looks at a solution
// of it.

#ifndef lamella_adapt_node_fields_h
#define lamella_adapt_node_fields_h

#include <lamella/adapt/known_end_fields.h>
#include <lamella/adapt/plan_rules.h>
#include <lamella/body/parameters.h>
#include <lamella/recover/requests.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The numbers behind the choice of fields, all measured
   * (doc/saint-venant-fields.md). H is the smaller extent of the section, h_e
   * the shortest axis element that something touches.
   */
  struct FieldRules
  {
    /// The smallest wave number, over the larger extent of the section, and
    /// that of thin walls, which deform their section over long distances: they
    /// have as many more wave numbers as it takes to reach it in equal ratios
    /// that are no larger than without.
    double lowest_wave = 0.25, lowest_wave_of_walls = 0.05;
    /// Walls are thin where the section fills less than this of the box around
    /// it: a box or a double-T does, and no solid section.
    double thin_walls = 0.5;
    /// The largest one near what touches, over h_e, and far from it, over H.
    double highest_wave = 10., highest_wave_afar = 4.;
    /// The largest one is at least this many times the smallest, however long
    /// the elements are.
    double least_range_of_waves = 2.;
    /// What is cut of responses, near and far (Warping::basis()). Near times
    /// (6 / N)^2 where N is more than 6 = cut_of_waves: more wave numbers are
    /// wanted for more digits.
    double       near_tolerance = 3e-2, far_tolerance = 1e-2;
    unsigned int cut_of_waves = 6;
    /// The heat of a node is that of others where no more than this is left of
    /// it beside theirs, of a unit vector.
    double same_heat = 1e-3;
    /// What touches count as.
    TouchRules touches = {};
    /// Responses reach this many H beyond the elements that are touched, and
    /// those to tractions of a clamp this many times the larger extent.
    double reach = 2., reach_of_clamp = 1.5;
    /// Who makes what stands in for a support that holds a section as a whole:
    /// end fields, each up to where its zone ends (EndFieldRules); where there
    /// are none, the tractions S_10 w and S_11 w of the six warpings w as load
    /// vectors. Models of one scene that share it have them made once.
    std::shared_ptr<EndFields> ends = std::make_shared<EndFields>();
    /// Which bodies have fields of their own.
    PlanRules plan = {};
    /// The names of bodies that keep all fields whatever they would win: with
    /// fewer their scene was not to be solved in double precision.
    std::vector<std::string> unsolved = {};
  };

  /// Where stresses of a body are asked for: a probe or its box, a line, a cut.
  struct StressPlace
  {
    /// Its number in Bodies.
    unsigned int body = 0;
    /// From where to where along the body's axis [length].
    double begin = 0., end = 0.;
  };

  /// Those of @p probes, @p lines and @p cuts in @p bodies.
  std::vector<StressPlace>
  stress_places(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts);

  /**
   * Gives the bodies of SV-N, and those with `Theories`, the fields that their
   * scene excites, and leaves all others as they are. @p bodies are those of
   * make_bodies() for @p descriptions, whose nodes carry all fields of their
   * section; they are replaced by bodies of the same names, sections, axes and
   * places, so that conditions and contacts have to be made anew.
   *
   * Each node carries the six rigid fields, the Saint-Venant warpings, and
   * - near what touches the body the responses at N wave numbers to its section
   *   load vectors (SectionResponse), from lowest_wave over the section to
   *   highest_wave / h_e in equal ratios;
   * - elsewhere the responses to the mean and the linear part of all that
   *   touches it, also to what is constant along the axis.
   * All nodes of a body that is heated, or under @p gravity (scene axes,
   * length / s^2), carry how the section answers that where it is constant
   * along the axis; heat that varies along it is a load where it does. Beside
   * what holds the section as a whole, and beside free ends of heated bodies,
   * nodes carry end fields (end_fields()).
   * Fields are cut to what is independent. In `Theories` pieces of SV have none
   * of these, and nodes of LE-q carry the section's fields of degree q and less
   * (Section::field_degree()): at the end of such a piece those of the higher
   * degree, and where it ends at SV all of them.
   *
   * The stress in an element is as poor as the poorest of its nodes, so where
   * one of @p asked lies in an element some of whose nodes are near something,
   * all of its nodes carry what these do.
   *
   * Bodies of the same section and theory share their fields. @p contacts are
   * made of @p bodies. Returns what the user should know, a sentence each; and
   * in @p why, a string a body if it is not null, why the nodes of those of
   * SV-N carry the fields that they do.
   * Throws NumericsError if the section's matrices cannot be factorised.
   * Collective where Beam is.
   */
  std::vector<std::string>
  choose_fields(Bodies                              &bodies,
                const std::vector<BodyDescription>  &descriptions,
                const std::vector<Support>          &supports,
                const std::vector<Load>             &loads,
                const std::vector<ContactInterface> &contacts,
                const std::vector<StressPlace>      &asked   = {},
                const FieldRules                    &rules   = {},
                const dealii::Tensor<1, 3>          &gravity = {},
                std::vector<std::string>            *why     = nullptr);

  /// Whether choose_fields() would change any of the bodies.
  bool
  has_fields_to_choose(const std::vector<BodyDescription> &descriptions);
} // namespace lamella

#endif
