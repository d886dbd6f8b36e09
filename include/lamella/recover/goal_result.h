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
  /// Contribution of one element along a beam's axis to the error of a goal
  /// (quantity of interest).
  struct ElementError
  {
    unsigned int body  = 0;  ///< Index of the beam in Bodies.
    double       begin = 0.; ///< Axial coordinate of the first end [length].
    double       end   = 0.; ///< Axial coordinate of the second end [length].
    /// Signed contribution to the error, in the unit of the goal.
    double error = 0.;
    /// Number of DoFs of the element's nodes, including shared nodes.
    unsigned int dofs = 0;
  };

  /// Difference of a goal (quantity of interest) between a model and a model
  /// with finer axis elements, as a sum of contributions of elements and of
  /// contact, in the unit of the goal.
  struct LocalErrors
  {
    std::vector<ElementError> elements; ///< Contributions of axis elements.
    double contact = 0.; ///< Contribution of gap and contact force errors.
    /// Difference that is assigned neither to elements nor to contact; only
    /// rounding if the finer elements subdivide the coarser ones.
    double remainder = 0.;
  };

  /// Error tolerance of a goal (quantity of interest), as given in a scene.
  struct Tolerance
  {
    /// Largest permitted error: in the unit of the goal if `is_absolute`, else
    /// as a fraction of GoalResult::scale.
    double size        = 0.;
    bool   is_absolute = false; ///< True: `size` has a unit; false: relative.
  };

  /// Value and error estimate of a goal (quantity of interest), in its unit.
  struct GoalResult
  {
    std::string name;       ///< Name in the scene, for example `tip: uz`.
    double      value = 0.; ///< Computed value in the last load step.
    /// Label of the unit; empty for dimensionless goals and without units.
    std::string unit     = {};
    double      estimate = 0.; ///< Estimate of exact minus computed value.
    double      bar      = 0.; ///< Estimated bound of |exact - computed value|.
    /// Lower limit of the bar: twice the change of the value by mesh refinement
    /// near supports; 0 if this was not computed.
    double least = 0.;
    /// True if the bar is reliable; false if not, for the reason in `why`.
    bool        trusted = false;
    std::string why; ///< Reason why the bar is unreliable; else empty.
    /// True if the value converges; false at a stress singularity.
    bool has_limit = true;
    /// Reference value of relative errors: |value|, or the largest value of the
    /// same kind if the value is near zero (RunGoals::scale_of()).
    double scale = 0.;
    /// Error tolerance; empty if the scene does not give one.
    std::optional<Tolerance> tolerance;
    /// Signed contributions of error sources (`axis`, `fields`, `section`,
    /// `contact`, ...) to the bar; if computed by Estimation, to `estimate`.
    std::vector<std::pair<std::string, double>> shares;
    /// Estimated discretization error of each axis element; empty if unknown.
    std::optional<LocalErrors> local;

    /// Returns true if the value is near zero, so that relative errors refer to
    /// the largest value of its kind (`scale`) instead of |value|.
    bool
    is_near_zero() const
    {
      return scale != std::abs(value);
    }

    /// Returns the largest permitted error. The goal must have a tolerance.
    double
    allowed_error() const
    {
      return tolerance->size * (tolerance->is_absolute ? 1. : scale);
    }

    /// Returns true if the goal has a tolerance and a reliable bar within it.
    bool
    met() const
    {
      return trusted && tolerance && bar <= allowed_error();
    }
  };
} // namespace lamella

#endif
