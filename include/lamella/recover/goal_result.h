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
  /// Contribution of an element along a beam to the error of a goal.
  struct ElementError
  {
    /// Number of the body, and the element's ends along the axis [length].
    unsigned int body  = 0;
    double       begin = 0., end = 0.;
    /// Signed contribution, in the unit of the goal.
    double error = 0.;
    /// DoFs of the element's nodes, shared nodes included.
    unsigned int dofs = 0;
  };

  /// Change of a goal to a finer model: elements, contact and remainder.
  struct LocalErrors
  {
    std::vector<ElementError> elements;
    /// True if the run is the finer model: elements have half of their pair's.
    bool of_pairs = false;
    /// Contribution of contact: gaps of the finer model's active rows at
    /// coarser displacements, and the difference of contact forces.
    double contact = 0.;
    /// Rest of the change, rounding if the models are nested.
    double remainder = 0.;
  };

  /// The tolerance of a number in a scene.
  struct Tolerance
  {
    /// Positive: a share of the scale of the number, or a value in its unit.
    double size        = 0.;
    bool   is_absolute = false;
  };

  /// A goal of a run with its error estimate, in the unit of the quantity.
  struct GoalResult
  {
    /// Name in the scene: `tip: uz`.
    std::string name;
    double      value = 0.;
    /// Label of the unit (NamedQuantity::unit()); empty if it has none.
    std::string unit = {};
    /// Estimated error, to be added to the value, and the error bound.
    double estimate = 0., bar = 0.;
    /// Lower limit of the bar, however fast passes converge.
    double least = 0.;
    /// True if the bar is reliable; if not, `why` is the reason.
    bool        trusted = false;
    std::string why;
    /// True if refinement converges to a limit (singularity_reason()).
    bool has_limit = true;
    /// Reference of percentages: |value|, or if near zero RunGoals::scale_of().
    double scale = 0.;
    /// Tolerance, if the scene has one.
    std::optional<Tolerance> tolerance;
    /// Signed shares of the bar by source; of richer models, of the estimate.
    std::vector<std::pair<std::string, double>> shares;
    /// Share of the axis, by elements; none if it is not known.
    std::optional<LocalErrors> local;

    /// Returns whether percentages refer to something else than the value.
    bool
    is_near_zero() const
    {
      return scale != std::abs(value);
    }

    /// Returns the largest admissible error by the tolerance, which must exist.
    double
    allowed_error() const
    {
      return tolerance->size * (tolerance->is_absolute ? 1. : scale);
    }

    /// Returns whether the bar is reliable and within the tolerance.
    bool
    met() const
    {
      return trusted && tolerance && bar <= allowed_error();
    }
  };
} // namespace lamella

#endif
