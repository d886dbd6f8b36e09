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

  /// Returns true if the support on @p region is a clamp at @p y of an axis of
  /// length @p length: it acts on the start or end surface or on the whole
  /// body, and so constrains the whole section in at least one direction.
  /// Clamps have boundary-layer modes and short axis elements.
  bool
  is_clamp(const Region &region, const double y, const double length);

  /// Returns true if a support acts on the whole @p body (plane strain).
  bool
  is_constrained_along_axis(const std::vector<Support> &supports,
                            const unsigned int          body);

  /// Size of a body, for the choice of its model.
  struct BodySize
  {
    unsigned int dofs = 0;
    /// Axis nodes, and fields and cells of the section; 0 for solids.
    unsigned int nodes = 0, fields = 0, cells = 0;
    /// True if a support acts on the whole body.
    bool constrained_along_axis = false;
    /// Fraction of the length along which contacts may be active.
    double loaded = 0.;
    /// Length of a beam over the largest extent of its section.
    double slenderness = 0.;
    /// Number of section corners with singular stresses (singular_corners()).
    unsigned int corners = 0;
  };

  /// Returns BodySize::corners of the section of @p beam.
  unsigned int
  n_corners(const Beam &beam);

  /// Data on a body for the choice of its model by plan().
  struct PlanInput
  {
    BodySize size;
    /// Requested or default theory.
    Theory theory;
    /// True if the theory is a default, which a run to a tolerance may replace.
    bool is_assumed = false;
    /// True if the scene has contacts; an `auto` axis; given `Theories`.
    bool has_contacts = false, is_graded_automatically = false,
         has_pieces = false;
    /// True if the scene could not be solved without all fields.
    bool is_unsolved = false;
    /// Mean number per node of load vectors constrained by supports (no
    /// clamps), and number of fields that SV-N needs; empty if unknown.
    std::optional<double>       held;
    std::optional<unsigned int> wanted;
  };

  /// The model chosen for a body.
  struct BodyPlan
  {
    Theory theory;
    /// Number of equal elements that replace a graded axis; 0 for none.
    unsigned int equal_elements = 0;
    /// True if all nodes have all section fields.
    bool all_fields = true;
    /// Reasons for the theory, and for all fields; empty if undecided.
    std::string theory_reason, fields_reason;
  };

  /// Returns the model of a body from the data @p facts, by the thresholds @p
  /// rules. Criteria with unknown data are skipped.
  /// - Theory: as requested. In a scene with contacts, LE-3 replaces a default
  ///   theory if LE-2 has at most cheap_dofs DoFs, or if contacts may be active
  ///   along more than max_contact_share of the body. In the latter case the
  ///   axis has equal elements: one if the whole body is supported, else length
  ///   over section extent, from 2 to equal_elements.
  /// - Fields: chosen fields for SV and `Theories`, else all section fields.
  ///   SV-N has chosen fields unless these could not be solved, the whole body
  ///   is supported, the body has at most min_nodes nodes, or, as a fraction of
  ///   all fields, more than max_held_share are constrained or more than
  ///   max_fields_share are needed.
  BodyPlan
  plan(const PlanInput &facts, const PlanRules &rules = {});

  /// Returns the reason for the fields of @p planned, chosen from @p facts.
  std::string
  describe_fields(const PlanInput &facts, const BodyPlan &planned);

  /// Returns the approximate number of DoFs of LE-@p degree for @p size: three
  /// per point of a square grid on the section.
  double
  layerwise_dofs(const BodySize &size, const unsigned int degree);

  /// Returns why LE of a low degree costs less for a body of @p size than
  /// chosen fields (SV-N); empty if it does not.
  std::string
  reason_for_layerwise(const BodySize &size, const PlanRules &rules = {});

  /// Predicted cost of a model.
  struct Cost
  {
    /// Nonzeros of the stiffness factor (8 bytes each), and multiplications to
    /// compute it: at least z^2 / n for n columns, z nonzeros.
    double non_zeros = 0., operations = 0.;
  };

  /// Returns the cost of each of @p bodies, predicted from its DoFs. A beam has
  /// z = sum_i m_i b_i nonzeros, with m_i the fields of node i, and b_i half of
  /// m_i plus the fields of the nodes to which node i is coupled when it is
  /// eliminated: first inner nodes of an element (with its remaining nodes and
  /// both ends), then element ends along the axis (with the next end). Blocks
  /// are full. LE has at most of_layers n^(4/3) nonzeros, and a solid of_solid
  /// n^(4/3), as for nested dissection of a cube (George and Liu, Computer
  /// Solution of Large Sparse Positive Definite Systems, 1981, ch. 8).
  std::vector<Cost>
  predicted_costs(const Bodies &bodies, const CostRules &rules = {});
} // namespace lamella

#endif
