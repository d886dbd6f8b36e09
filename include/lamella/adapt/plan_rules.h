// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_rules_h
#define lamella_adapt_plan_rules_h

namespace lamella
{
  /// Constants of the choice of models (plan(), enriched()), judged from runs
  /// of `scripts/measure tolerances`: each avoids a run that takes several
  /// times the time or memory of another model with the same result.
  struct PlanRules
  {
    /// Number of DoFs of a body up to which LE-N is enriched directly.
    double max_layerwise_dofs = 60000.;
    /// Fields of a node of SV-10 near an interaction, and the factor by which a
    /// section must have more.
    double fields_of_responses = 200., min_gain = 2.;
    /// Number of DoFs up to which LE-2 is cheaper than computing responses.
    double cheap_dofs = 20000.;
    /// Share of a beam's length with possible contact above which its own
    /// fields are no fewer than those of LE, and slow to compute.
    double max_contact_share = 0.5;
    /// Wave numbers: substitute for others, increment, smallest, largest.
    unsigned int substitute_waves = 10, wave_increment = 4, min_waves = 6,
                 max_waves = 40;
    /// Initial degree of LE, the least with poorer levels for error estimates.
    unsigned int first_degree = 3;
    /// Degree from which section cells are divided instead.
    unsigned int highest_degree = 8;
    /// Highest degree of sections with corners, which get layers there instead.
    unsigned int corner_degree = 8;
    /// Largest number of corner layers, as in a scene (`Corner layers`).
    unsigned int max_corner_layers = 6;
    /// Initial number of elements, at most, of axes with contact everywhere.
    unsigned int equal_elements = 10;
    /// Mean share of fields above which, and number of nodes up to which, a
    /// body of SV-N keeps all fields.
    double       max_fields_share = 0.5;
    unsigned int min_nodes        = 15;
    /// Mean share of fields constrained by supports above which all are kept.
    double max_held_share = 0.05;
  };

  /// Cost constants of models that are not built, counted from the algorithms,
  /// accurate to a factor of two (doc/tolerances.md).
  struct CostRules
  {
    /// Nodes for error bars, in axes: two on halved elements, one on quarters.
    double axes = 8.;
    /// Multiplications for a node with m fields, over m^3: block and coupling.
    double of_block = 5.;
    /// Wave numbers, and multiplications for eigenvectors over their number^3.
    double waves = 10., of_eigenvectors = 10.;
    /// Nonzeros of a solid's factor over n^(4/3) (predicted_costs()), 12 to 13
    /// for cantilevers, and the most of LE, 14 to 23 for the largest.
    double of_solid = 13., of_layers = 19.;
  };
} // namespace lamella

#endif
