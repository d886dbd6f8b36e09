// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_h
#define lamella_adapt_plan_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/body/body.h>
#include <lamella/conditions/support.h>
#include <lamella/section/theory.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class Beam;

  /**
   * Whether the support on @p region is a clamp at @p y of a body's axis of the
   * length @p length: it holds the section there as a whole, in one direction
   * at least, since it is on the start or the end of the body, or on all of it.
   * The section answers to a clamp by end fields and not by load vectors, and
   * axes have their shortest elements there. Everywhere in this program what is
   * called a clamp is that.
   */
  bool
  is_clamp(const Region &region, const double y, const double length);

  /// Whether one of @p supports is on all of the body number @p body, as in
  /// plane strain: each of its sections is clamped, and nothing is far from a
  /// clamp.
  bool
  is_held_all_along(const std::vector<Support> &supports,
                    const unsigned int          body);

  /// How large a body is, as far as its models are chosen by it.
  struct BodySize
  {
    unsigned int dofs = 0;
    /// Of its axis, and fields and cells of its section; 0 of solids.
    unsigned int nodes = 0, fields = 0, cells = 0;
    /// is_held_all_along().
    bool held_all_along = false;
    /// The share of its length along which others may touch it.
    double touched = 0.;
    /// Of a beam its length over the largest extent of its section.
    double slenderness = 0.;
    /// Of its section, at which stresses have no limit (singular_corners()).
    unsigned int corners = 0;
  };

  /// Of the section of @p beam, for BodySize::corners.
  unsigned int
  n_corners(const Beam &beam);

  /// All that is known of a body when its model is chosen.
  struct PlanFacts
  {
    BodySize size;
    /// As it is asked for, or assumed.
    Theory theory;
    /// Whether no one asked: a run to a tolerance may begin with another one.
    bool is_assumed = false;
    /// Whether it is of a scene with contacts, and whether its axis grades
    /// itself; whether its nodes have their theories by hand (`Theories`).
    bool has_contacts = false, grades_itself = false, has_pieces = false;
    /// Whether its scene was not to be solved with fewer fields than all.
    bool is_unsolved = false;
    /// Of its nodes, on average, what supports hold of them but clamps, and the
    /// fields that they would carry, when that is known.
    std::optional<double>       held;
    std::optional<unsigned int> wanted;
  };

  /// A body's model.
  struct BodyPlan
  {
    Theory theory;
    /// How many equal elements its axis has, though it would grade itself; 0
    /// where it has those that are asked for.
    unsigned int equal_elements = 0;
    /// Whether all nodes carry all fields of its section: chosen ones are no
    /// gain, or there is nothing to choose.
    bool all_fields = true;
    /// Why this theory, and why all fields though the theory could do with
    /// fewer; empty where nothing was to be decided. Words for the middle of a
    /// sentence.
    std::string why_theory, why_fields;
  };

  /**
   * The model of a body of which @p facts are known; a rule that waits for a
   * fact that is not known does not speak. In this order:
   *
   *   theory   as asked for; of an assumed one in a scene with contacts LE-3
   *            (first_degree) where contacts may touch more than long_contact
   *            of it, on equal elements, one where supports hold it all along,
   *            else two or as many as its section fits into its length, up to
   *            equal_elements; and LE-3 where LE-2 has cheap_dofs or less
   *   fields   all of the section where the theory has no others; chosen ones
   *            of SV and where `Theories` say so; of SV-N all if the scene was
   *            not to be solved with fewer, the body is held all along, has
   *            least_nodes or less, most_held of a node's fields or more are
   *            held, or most_fields or more of them wanted
   *
   * A pure function: it looks at nothing else.
   */
  BodyPlan
  plan(const PlanFacts &facts, const PlanRules &rules = {});

  /// Why the nodes of a body with @p facts carry the fields that @p planned
  /// says.
  std::string
  words_of_fields(const PlanFacts &facts, const BodyPlan &planned);

  /// About how many DoFs LE-@p degree has with the nodes and cells of @p size:
  /// three for each point of a square grid.
  double
  dofs_of_layers(const BodySize &size, const unsigned int degree);

  /// Why LE of a low degree is less work for a body of @p size than making
  /// fields of its own is; empty if it is not.
  std::string
  why_layers(const BodySize &size, const PlanRules &rules = {});

  /// What a model costs of which nothing was solved yet.
  struct Cost
  {
    /// Numbers in the factor of the stiffness, 8 bytes each, and the
    /// multiplications that make it: of a factor with n columns and z non-zeros
    /// at least z^2 / n, the sum of the squares of its columns where these are
    /// alike.
    double non_zeros = 0., operations = 0.;
  };

  /**
   * The cost of each of @p bodies, foreseen from its DoFs alone. Of a beam
   * whose axis has the degree p, z = sum_i m_i b_i over its nodes, m_i the
   * fields of node i and b_i half of them and those of the nodes that it is
   * coupled to when it is eliminated: the nodes inside an element first, each
   * with those after it there and the two ends, then the ends along the axis,
   * each with the next. Blocks count as full, which those of chosen fields are;
   * LE, whose cells are coupled to their neighbours only, has at most of_layers
   * n^(4/3), and a solid of_solid n^(4/3), as nested dissection leaves of a
   * cube (George and Liu, Computer Solution of Large Sparse Positive Definite
   * Systems, 1981, ch. 8).
   */
  std::vector<Cost>
  foreseen_costs(const Bodies &bodies, const CostRules &rules = {});
} // namespace lamella

#endif
