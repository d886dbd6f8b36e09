// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_rules_h
#define lamella_adapt_plan_rules_h

namespace lamella
{
  /// Parameters of the choice of models (plan(), enriched()), found from runs
  /// of `scripts/measure tolerances`. Each avoids a model that takes several
  /// times the time or memory of another model with the same result.
  struct PlanRules
  {
    /// A larger LE-N body is refined by SV-N instead, if SV-N has fewer fields.
    double max_layerwise_dofs = 60000.;
    /// Typical number of fields of a node of SV-10 near an interaction; SV-N
    /// replaces LE if a section has more than `min_gain` times this number.
    double fields_of_responses = 200., min_gain = 2.;
    /// Up to this number of DoFs, LE-2 is used since it costs less than SV-N.
    double cheap_dofs = 20000.;
    /// Fraction of a beam's length with possible contact above which SV-N does
    /// not have fewer fields than LE, and is slow to compute.
    double max_contact_share = 0.5;
    /// Wave numbers N of SV-N: initial N if SV-N replaces another theory,
    /// increment per refinement, smallest and largest N.
    unsigned int substitute_waves = 10, wave_increment = 4, min_waves = 6,
                 max_waves = 40;
    /// Initial degree of LE, the smallest with error bars by coarser models.
    unsigned int first_degree = 3;
    /// Degree at which section cells are divided instead of raising the degree.
    unsigned int highest_degree = 8;
    /// Degree at which sections with corners get cell layers there instead.
    unsigned int corner_degree = 8;
    /// Largest number of cell layers at corners (scene: `Corner layers`).
    unsigned int max_corner_layers = 6;
    /// Largest initial number of elements of axes with contact everywhere.
    unsigned int equal_elements = 10;
    /// A body of SV-N has all fields if the mean fraction of needed fields is
    /// larger, or if it has at most this number of nodes.
    double       max_fields_share = 0.5;
    unsigned int min_nodes        = 15;
    /// A body has all fields if supports constrain a larger mean fraction.
    double max_held_share = 0.05;
  };

  /// Cost parameters of models that are not built, from counts of operations,
  /// accurate to a factor of two (doc/tolerances.md).
  struct CostRules
  {
    /// Nodes of all models solved for error bars over nodes of the run: two
    /// models on bisected elements, one on quarters.
    double axes = 8.;
    /// Multiplications per node with m fields, divided by m^3.
    double of_block = 5.;
    /// Number of wave numbers; multiplications for the eigenvectors of n
    /// section functions, divided by n^3.
    double waves = 10., of_eigenvectors = 10.;
    /// Nonzeros of the factor over n^(4/3) (predicted_costs()) of a solid, 12
    /// to 13 for cantilevers, and of LE, 14 to 23 for the largest.
    double of_solid = 13., of_layers = 19.;
  };
} // namespace lamella

#endif
