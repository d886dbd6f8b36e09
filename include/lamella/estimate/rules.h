// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_rules_h
#define lamella_estimate_rules_h

namespace lamella
{
  /// All numbers that decide on error bars and on refinement to a tolerance.
  /// doc/verification/error-bar-rules.md has error bars without those that
  /// decide in many scenes (`scripts/measure ablation`). The scale is
  /// GoalResult::scale.
  struct EstimateRules
  {
    // Error bars.

    /// Factor in the bar of a change of the goal by a comparison model.
    double safety = 2.;
    /// Largest ratio of successive changes of a value with a trusted bar.
    double max_remaining_share = 2. / 3.;
    /// Largest such ratio for models on coarser axes: the change by a finer
    /// section over the change by the increase of the degree before.
    double max_section_ratio = 0.8;
    /// A bar is also trusted if all changes are below this share of the scale.
    double small = 1e-2;
    /// Differences below this share of the scale are rounding errors.
    double digits = 1e-8;
    /// Ratio of successive changes above which a value is reported to diverge,
    /// and section cells are not divided for it (Passes).
    double growth = 0.9;
    /// Lower limit of a bar, as a fraction of the change one refinement before:
    /// the last change may be small by accident.
    double min_share_of_previous = 1. / 8.;
    /// Smallest degree N of LE-N with bars from models of lower degree: the
    /// change from LE-1 to LE-2 does not bound the error of LE-2.
    unsigned int min_degree = 3;
    /// Number of wave numbers that the coarser model of SV-N omits.
    unsigned int fewer_waves = 3;
    /// Smallest section order of SV-N that a run to a tolerance compares with a
    /// lower order; smaller orders are compared with a higher order.
    unsigned int min_order = 3;
    /// Factor in the bar of SV-N of its change by a halved axis.
    double of_axis = 1.;
    /// Largest sum of changes of SV-N with a trusted bar, share of the scale.
    double max_change_share = 0.1;
    /// Factor in the bar of the change by twice as many substeps: the error is
    /// 1 (first order) to 3.4 times (order 1/2, growing contact) this change.
    double of_path = 4.;
    /// Largest length of an axis element at a support, as a multiple of the
    /// larger section side. Longer ones miss the local disturbance.
    double longest_at_support = 0.5;
    /// Largest cost of `auto` bars, as a fraction of the run's multiplications.
    double max_share_of_run = 0.5;
    /// Number of multiplications that `auto` bars may always take, about a
    /// second: passes of fewer are predicted to take the same time.
    double free_operations = 5e9;
    /// Smallest change of a goal by an error source that is refined once more
    /// (Estimation), as a fraction of the tolerance.
    double min_tolerance_share = 0.1;
    /// Smallest such change without a tolerance, as a fraction of all changes.
    double min_total_share = 0.02;
    /// Factor of the sum of changes by all sources in a bar of Estimation.
    double of_shares = 0.5;

    // Refinement to a tolerance.

    /// Error sources (mesh, theory, ...) are refined, the largest first, until
    /// the others sum to less than this fraction of the tolerance.
    double max_unrefined_share = 0.5;
    /// A goal is dropped (not refined any further) if it has no bar in this
    /// many passes and changes by more than its tolerance in the last of them.
    unsigned int patience = 2;
    /// A goal is dropped if its bar is above the fraction min_progress of the
    /// largest bar of this many passes before.
    unsigned int slow_passes = 2;
    /// Fraction of an earlier bar above which progress is slow (slow_passes).
    double min_progress = 2. / 3.;
    /// Largest ratio of the section error of a degree to that of the degree
    /// before for which the degree is raised again; above it, corners or large
    /// cells limit convergence.
    double max_degree_ratio = 0.5;
    /// Largest number of refinement passes.
    unsigned int max_passes = 8;
    /// Largest error of elements that are not bisected, share of the tolerance.
    double max_axis_remainder = 0.25;
    /// Smallest fraction of the error along the axis in bisected elements.
    double min_bisected_share = 0.65;
    /// SV-N replaces LE only if it has at most this fraction of the DoFs: SV-N
    /// takes two finer models for its bars, LE two coarser ones.
    double max_surrogate_share = 0.5;
    /// Relative tolerance of the resultant loads on refined meshes.
    double loads_agree = 1e-7;
  };
} // namespace lamella

#endif
