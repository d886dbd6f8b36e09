// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_h
#define lamella_adapt_plan_h

#include <lamella/body/body.h>
#include <lamella/conditions/support.h>
#include <lamella/section/theory.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Thresholds for the choice of models by plan() and of refined models by
  /// enriched(), from `scripts/measure tolerances`. Each avoids a model that
  /// takes several times the time or memory of another with the same result.
  struct PlanRules
  {
    /// Number of DoFs above which SV-10 replaces LE-N in refined models.
    double max_layerwise_dofs = 60000.;
    /// Typical number of section functions per node near a load for SV-10.
    double fields_of_responses = 200.;
    /// SV-10 can replace LE-N if the section has more functions than this
    /// multiple of fields_of_responses.
    double min_gain = 2.;
    /// Number of DoFs up to which LE-2 is used, since it costs less than SV-N.
    double cheap_dofs = 20000.;
    /// Fraction of a beam's length with possible contact above which LE is
    /// used, since SV-N then is slow and does not have fewer section functions.
    double max_contact_share = 0.5;
    /// Number N of wave numbers if SV-N replaces another theory.
    unsigned int substitute_waves = 10;
    unsigned int wave_increment   = 4;  ///< Increase of N per refinement.
    unsigned int min_waves        = 6;  ///< Smallest N of a refined SV-N.
    unsigned int max_waves        = 40; ///< Largest N of a refined SV-N.
    /// Initial degree of LE, the smallest with an error estimate.
    unsigned int first_degree = 3;
    /// Largest degree of LE. Beyond, refinement divides the section cells.
    unsigned int highest_degree = 8;
    /// Largest degree of LE (Lagrange expansion) if the section mesh can also
    /// be refined by layers of cells at singular corners.
    unsigned int corner_degree = 8;
    /// Largest number of cell layers at singular corners (`Corner layers`).
    unsigned int max_corner_layers = 6;
    /// Largest number of equal elements for an axis with contact everywhere.
    unsigned int equal_elements = 10;
    /// Fraction of section functions needed by a node above which SV-N has all.
    double max_fields_share = 0.5;
    /// Number of axis nodes up to which SV-N has all section functions.
    unsigned int min_nodes = 15;
    /// Fraction of constrained section functions above which SV-N has all.
    double max_held_share = 0.05;
  };

  /// Parameters of the cost prediction for models that are not built, from
  /// counts of operations (doc/verification/model-costs.md).
  struct CostRules
  {
    /// Axis nodes of all models for an error estimate, over those of the model:
    /// two models with bisected elements and one with quartered ones.
    double axes = 8.;
    /// Multiplications to factorize one node of m section functions, over m^3.
    double of_block = 5.;
    double waves    = 10.; ///< Number of wave numbers of harmonic loads.
    /// Multiplications for the eigenvectors of n section functions, over n^3.
    double of_eigenvectors = 10.;
    /// Nonzeros of a solid's factorized stiffness with n DoFs, over n^(4/3).
    double of_solid = 13.;
    /// Nonzeros of the factorized stiffness of LE with n DoFs, over n^(4/3).
    double of_layers = 19.;
  };

  class Beam;

  /// Returns true if a support on @p region is a clamp at @p y of an axis of
  /// length @p length: it acts on the start or end surface there or on the
  /// whole body, and so constrains the whole section in at least one direction.
  bool
  is_clamp(const Region &region, const double y, const double length);

  /// Returns true if a support acts on the whole @p body (plane strain).
  bool
  is_constrained_along_axis(const std::vector<Support> &supports,
                            const unsigned int          body);

  /// Size of a body, from which plan() chooses its model.
  struct BodySize
  {
    unsigned int dofs   = 0; ///< Number of DoFs.
    unsigned int nodes  = 0; ///< Number of axis nodes; 0 for solids.
    unsigned int fields = 0; ///< Number of section functions; 0 for solids.
    unsigned int cells  = 0; ///< Number of section cells; 0 for solids.
    /// True if a support acts on the whole body, as for plane strain.
    bool constrained_along_axis = false;
    /// Fraction of the length along which contacts may be active.
    double loaded = 0.;
    /// Length of a beam over the largest extent of its section.
    double slenderness = 0.;
    /// Number of section corners with singular stresses (singular_corners()).
    unsigned int corners = 0;
    /// True if a support acts on a side of a beam: each node of SV-N would then
    /// have most section functions.
    bool is_held_at_side = false;
  };

  /// Returns the number of section corners of @p beam with singular stresses.
  unsigned int
  n_corners(const Beam &beam);

  /// Data on a body for the choice of its model by plan().
  struct PlanInput
  {
    BodySize size;   ///< Size of the body.
    Theory   theory; ///< Theory from the scene, or the default theory.
    /// True if the theory is a default, which plan() may replace.
    bool is_assumed              = false;
    bool has_contacts            = false; ///< True if the scene has contacts.
    bool is_graded_automatically = false; ///< True if the axis is `auto`.
    bool has_pieces              = false; ///< True if `Theories` are given.
    /// True if a model of this body with fewer section functions failed.
    bool is_unsolved = false;
    /// Number of load vectors of supports, mean per node; empty if unknown.
    std::optional<double> held;
    /// Mean number of section functions per node for SV-N; empty if unknown.
    std::optional<unsigned int> wanted;
  };

  /// The model chosen for a body.
  struct BodyPlan
  {
    Theory theory; ///< Theory of the body.
    /// Number of equal elements that replace a graded axis; 0: no replacement.
    unsigned int equal_elements = 0;
    /// True if all nodes have all section functions; else see choose_fields().
    bool all_fields = true;
    /// Reason for replacing the default theory; empty if it is not replaced.
    std::string theory_reason;
    /// Reason why a body of SV-N has all section functions; empty for others.
    std::string fields_reason;
  };

  /// Returns the model of a body from its data @p facts, by the thresholds @p
  /// rules (PlanRules). Criteria with unknown data are skipped.
  /// - Theory: as requested. In a scene with contacts, LE-3 replaces a default
  ///   theory if LE-2 has at most cheap_dofs DoFs, or if contacts may be active
  ///   along more than max_contact_share of the body. In the latter case, equal
  ///   elements replace a graded axis: one if a support acts on the whole body,
  ///   else BodySize::slenderness, from 2 to equal_elements.
  /// - Section functions: those of choose_fields() for SV, SV-N and `Theories`,
  ///   else all. But SV-N has all functions if a model with fewer could not be
  ///   solved, if a support acts on the whole body, if the axis has at most
  ///   min_nodes nodes, or if supports constrain more than the fraction
  ///   max_held_share, or nodes need more than max_fields_share, of the
  ///   functions.
  BodyPlan
  plan(const PlanInput &facts, const PlanRules &rules = {});

  /// Returns a text for the user on the section functions of the model @p
  /// planned, which plan() has chosen from @p facts.
  std::string
  describe_fields(const PlanInput &facts, const BodyPlan &planned);

  /// Returns the approximate number of DoFs of a body of @p size with the
  /// theory LE-@p degree: three per point of a square grid on the section.
  double
  layerwise_dofs(const BodySize &size, const unsigned int degree);

  /// Returns the reason why LE of a low degree costs less for a body of @p size
  /// than SV-N; empty if it does not.
  std::string
  reason_for_layerwise(const BodySize &size, const PlanRules &rules = {});

  /// Predicted cost of solving the equations of one body.
  struct Cost
  {
    /// Number of nonzeros of the factorized stiffness matrix, 8 bytes each.
    double non_zeros  = 0.;
    double operations = 0.; ///< Number of multiplications to factorize.
  };

  /// Returns the cost of each of @p bodies, predicted from its DoFs
  /// (doc/verification/model-costs.md). A beam's factor has sum_i m_i b_i
  /// nonzeros. Here m_i is the number of section functions of node i, and b_i
  /// is m_i / 2 plus the functions of the nodes coupled to node i when it is
  /// eliminated. Inner nodes are eliminated first (coupled to the remaining
  /// nodes of their element), then element ends (coupled to the next end). For
  /// n DoFs, LE has at most of_layers n^(4/3) nonzeros and a solid of_solid
  /// n^(4/3), as for nested dissection of a cube (George and Liu, Computer
  /// Solution of Large Sparse Positive Definite Systems, 1981, ch. 8).
  std::vector<Cost>
  predicted_costs(const Bodies &bodies, const CostRules &rules = {});
} // namespace lamella

#endif
