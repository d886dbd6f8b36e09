// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_rules_h
#define lamella_adapt_plan_rules_h

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
} // namespace lamella

#endif
