// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_rules_h
#define lamella_adapt_plan_rules_h

namespace lamella
{
  /// Constants of the choice of models, of a run to a tolerance and of those it
  /// is compared with (plan(), enriched()). Judged from runs of
  /// `scripts/measure tolerances`, not optimized: each avoids a run that takes
  /// several times the time or memory of another model with the same result.
  struct PlanRules
  {
    /// Number of DoFs of a body up to which LE-N is enriched directly; beyond,
    /// the section's own fields are used.
    double max_layerwise_dofs = 60000.;
    /// Number of fields of a node of SV-10 near a touch, and the factor by
    /// which a section must have more for an advantage.
    double fields_of_responses = 200., min_gain = 2.;
    /// Number of DoFs up to which LE-2 is cheaper than computing responses.
    double cheap_dofs = 20000.;
    /// Share of a beam's length with possible contact above which its own
    /// fields are no fewer than those of LE, and slow to compute: one response
    /// per contact row.
    double max_contact_share = 0.5;
    /// Wave numbers: substitute for theories without responses, increment of
    /// SV-N, smallest useful number, largest number.
    unsigned int substitute_waves = 10, wave_increment = 4, min_waves = 6,
                 max_waves = 40;
    /// Initial degree of LE: the least that has poorer levels for error
    /// estimates.
    unsigned int first_degree = 3;
    /// Degree from which section cells are divided instead.
    unsigned int highest_degree = 8;
    /// Highest degree of sections with corners, which get layers there
    /// (graded_to_corners()); lower in runs whose degrees do not converge.
    unsigned int corner_degree = 8;
    /// Largest number of corner layers, as in a scene (`Corner layers`).
    unsigned int max_corner_layers = 6;
    /// Initial number of elements, at most, of axes graded to a contact that is
    /// everywhere: the default of scenes.
    unsigned int equal_elements = 10;
    /// Mean share of fields above which, and number of axis nodes up to which,
    /// a body of SV-N keeps all fields of its section.
    double       max_fields_share = 0.5;
    unsigned int min_nodes        = 15;
    /// Mean share of fields held by supports without clamps above which a body
    /// keeps all: few others are left to eliminate, which is slow and loses
    /// digits.
    double max_held_share = 0.05;
  };

  /// Cost constants of models that are not built, counted from the algorithms.
  /// Accuracy within a factor of two suffices; doc/tolerances.md compares them
  /// with seconds.
  struct CostRules
  {
    /// Nodes for error bars, in axes: two models on halved elements, one on
    /// quarters.
    double axes = 8.;
    /// Multiplications for a node with m fields, over m^3: factors of its block
    /// and of the coupling to the next.
    double of_block = 5.;
    /// Wave numbers of responses, and multiplications for their eigenvectors
    /// over the cube of their number.
    double waves = 10., of_eigenvectors = 10.;
    /// Nonzeros of a solid's factor over n^(4/3) (predicted_costs()): 12 to 13
    /// for cantilevers of 135 to 4,875 DoFs; and the most of LE: 14 to 23 for
    /// the large ones of prm/.
    double of_solid = 13., of_layers = 19.;
  };
} // namespace lamella

#endif
