// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_goal_result_h
#define lamella_recover_goal_result_h

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Contribution of one element along a beam's axis to the error of a goal.
  struct ElementError
  {
    /// Number of the body, and axial coordinates of the element [length].
    unsigned int body  = 0;
    double       begin = 0., end = 0.;
    /// Signed contribution to the error, in the unit of the goal.
    double error = 0.;
    /// Number of DoFs of the element's nodes, including shared nodes.
    unsigned int dofs = 0;
  };

  /// Difference of the value of a goal between a model and a model with finer
  /// axis elements, as a sum of contributions of elements and of contact.
  struct LocalErrors
  {
    std::vector<ElementError> elements;
    /// True if the run is the finer model. An element then has half of the
    /// contribution of the coarser element that contains it.
    bool of_pairs = false;
    /// Contribution of contact: gaps of the finer model's active constraints at
    /// coarser displacements, and differences of contact forces.
    double contact = 0.;
    /// Rest of the difference; only rounding if the models are nested.
    double remainder = 0.;
  };

  /// Error tolerance of a goal, as given in a scene.
  struct Tolerance
  {
    /// Largest error: a fraction of GoalResult::scale, or if `is_absolute` a
    /// value in the unit of the goal.
    double size        = 0.;
    bool   is_absolute = false;
  };

  /// A goal of a run with its error estimate, in the unit of the quantity.
  struct GoalResult
  {
    /// Name in the scene, for example `tip: uz`.
    std::string name;
    double      value = 0.;
    /// Unit for output (NamedQuantity::unit()); empty if there is none.
    std::string unit = {};
    /// Signed error estimate, to be added to the value, and bound of |error|.
    double estimate = 0., bar = 0.;
    /// Lower limit of the bar, even if refinement passes converge fast.
    double least = 0.;
    /// True if the bar is reliable; otherwise `why` gives the reason.
    bool        trusted = false;
    std::string why;
    /// True if the value converges under refinement (singularity_reason()).
    bool has_limit = true;
    /// Reference of relative errors, |value| or RunGoals::scale_of().
    double scale = 0.;
    /// Tolerance, if the scene gives one.
    std::optional<Tolerance> tolerance;
    /// Signed contributions of sources to bar (Estimation: `estimate`).
    std::vector<std::pair<std::string, double>> shares;
    /// Contribution of the axis by elements; empty if unknown.
    std::optional<LocalErrors> local;

    /// Returns true if the value is near zero, so that `scale` is not |value|.
    bool
    is_near_zero() const
    {
      return scale != std::abs(value);
    }

    /// Returns the largest permitted error; the goal must have a tolerance.
    double
    allowed_error() const
    {
      return tolerance->size * (tolerance->is_absolute ? 1. : scale);
    }

    /// Returns true if the bar is reliable and within the tolerance.
    bool
    met() const
    {
      return trusted && tolerance && bar <= allowed_error();
    }
  };
} // namespace lamella

#endif
