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

  /// Returns whether the support on @p region is a clamp at @p y of an axis of
  /// length @p length: it is on the start or end of the body or on all of it,
  /// and so constrains the whole section in at least one direction. Clamps have
  /// end fields instead of load vectors, and the shortest axis elements.
  bool
  is_clamp(const Region &region, const double y, const double length);

  /// Returns whether one of @p supports is on all of @p body (plane strain).
  bool
  is_constrained_along_axis(const std::vector<Support> &supports,
                            const unsigned int          body);

  /// Size of a body, for the choice of its model.
  struct BodySize
  {
    unsigned int dofs = 0;
    /// Nodes of the axis, and fields and cells of the section; 0 for solids.
    unsigned int nodes = 0, fields = 0, cells = 0;
    /// is_constrained_along_axis().
    bool constrained_along_axis = false;
    /// Share of the length along which contacts may touch.
    double loaded = 0.;
    /// Length of a beam over the largest extent of its section.
    double slenderness = 0.;
    /// Number of section corners with singular stresses (singular_corners()).
    unsigned int corners = 0;
  };

  /// Returns BodySize::corners of the section of @p beam.
  unsigned int
  n_corners(const Beam &beam);

  /// Facts about a body for the choice of its model.
  struct PlanInput
  {
    BodySize size;
    /// Requested or assumed theory.
    Theory theory;
    /// True if the theory is assumed, and a run to a tolerance may replace it.
    bool is_assumed = false;
    /// True if the scene has contacts; a graded axis; `Theories` by hand.
    bool has_contacts = false, is_graded_automatically = false,
         has_pieces = false;
    /// True if the scene could not be solved with fewer than all fields.
    bool is_unsolved = false;
    /// Mean number per node of load vectors that supports (without clamps)
    /// constrain, and of fields, if known.
    std::optional<double>       held;
    std::optional<unsigned int> wanted;
  };

  /// The model chosen for a body.
  struct BodyPlan
  {
    Theory theory;
    /// Number of equal elements in place of a graded axis; 0: as requested.
    unsigned int equal_elements = 0;
    /// True if all nodes carry all section fields.
    bool all_fields = true;
    /// Reasons for the theory, and for all fields; empty without a decision.
    std::string theory_reason, fields_reason;
  };

  /**
   * Returns the model of a body from its @p facts. Rules whose facts are
   * unknown are skipped. In this order:
   *   theory   as requested; an assumed one in a scene with contacts becomes
   *            LE-3 (first_degree) if contacts may cover more than
   *            max_contact_share of it, on equal elements: one if supports
   *            constrain it all along, else its length over the section's
   *            extent, from two to equal_elements; LE-3 also if LE-2 has at
   *            most cheap_dofs
   *   fields   all of the section if the theory has no others; chosen ones of
   *            SV and with `Theories`; of SV-N all if the scene could not be
   *            solved with fewer, the body is supported all along, has at most
   *            min_nodes nodes, or more than max_held_share of a node's fields
   *            constrained or max_fields_share of them requested
   */
  BodyPlan
  plan(const PlanInput &facts, const PlanRules &rules = {});

  /// Returns the reason for the fields of @p planned for a body with @p facts.
  std::string
  describe_fields(const PlanInput &facts, const BodyPlan &planned);

  /// Returns the approximate number of DoFs of LE-@p degree for @p size: three
  /// per point of a square grid.
  double
  layerwise_dofs(const BodySize &size, const unsigned int degree);

  /// Returns why LE of a low degree costs less for a body of @p size than its
  /// own fields; empty if it does not.
  std::string
  reason_for_layerwise(const BodySize &size, const PlanRules &rules = {});

  /// Predicted cost of a model.
  struct Cost
  {
    /// Nonzeros of the stiffness factor, 8 bytes each, and multiplications to
    /// compute it: at least z^2 / n for n columns and z nonzeros.
    double non_zeros = 0., operations = 0.;
  };

  /**
   * Returns the cost of each of @p bodies, predicted from its DoFs. A beam with
   * axis degree p has z = sum_i m_i b_i over its nodes, with m_i the fields of
   * node i, and b_i half of them plus those of nodes coupled to it when it is
   * eliminated: inner nodes of an element first, each with its remaining nodes
   * and the two ends, then the ends along the axis, each with the next. Blocks
   * count as full. LE has at most of_layers n^(4/3) nonzeros, and a solid
   * of_solid n^(4/3), as for nested dissection of a cube (George and Liu,
   * Computer Solution of Large Sparse Positive Definite Systems, 1981, ch. 8).
   */
  std::vector<Cost>
  predicted_costs(const Bodies &bodies, const CostRules &rules = {});
} // namespace lamella

#endif
