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
  /// What an element along a beam does to the error of a goal.
  struct ElementError
  {
    /// Its number in the scene, and the element from the start of its axis
    /// [length].
    unsigned int body  = 0;
    double       begin = 0., end = 0.;
    /// In the unit of the goal, signed.
    double error = 0.;
    /// Of the nodes of the element, those that it shares among them.
    unsigned int dofs = 0;
  };

  /// The change of a goal from one model to a finer one, by where it comes
  /// from: elements, contact and remainder sum to it.
  struct LocalErrors
  {
    std::vector<ElementError> elements;
    /// Whether the run is the finer one: what pairs of its elements would do as
    /// one, half of that to each.
    bool of_pairs = false;
    /// What the gap rows of the finer model find between the surfaces of the
    /// coarser one, and its forces that they do not have.
    double contact = 0.;
    /// What neither says: zero to rounding where all displacements of the
    /// coarser model are among those of the finer one, under one law.
    double remainder = 0.;
  };

  /// What a number may be off by, as a scene says it.
  struct Tolerance
  {
    /// Above 0: a share of the scale of the number, or in its unit.
    double size        = 0.;
    bool   is_absolute = false;
  };

  /// A number that a run was made for, and what is held of its error. In the
  /// unit of the quantity.
  struct GoalResult
  {
    /// As the scene says it: `tip: uz`.
    std::string name;
    double      value = 0.;
    /// NamedQuantity::unit(): a label, empty where it has none.
    std::string unit = {};
    /// The estimated error, to be added to the value, and what bounds it.
    double estimate = 0., bar = 0.;
    /// What the bar is not to be taken below, however passes contract.
    double least = 0.;
    /// Whether the bar can be held to; if not, why.
    bool        trusted = false;
    std::string why;
    /// Whether richer models could come to one: not so of stresses at an edge
    /// of a clamp, say (reason_for_no_limit()).
    bool has_limit = true;
    /// What per cent are of: |value|, or where that is near zero the largest
    /// of its kind (RunGoals::scale_of()).
    double scale = 0.;
    /// If one was asked for.
    std::optional<Tolerance> tolerance;
    /// By the source of the error: what each has of the bar, with the sign of
    /// the change that it is made of; of bars from richer models what the
    /// estimate is the sum of.
    std::vector<std::pair<std::string, double>> shares;
    /// The share of the axis, by elements; none where that is not known.
    std::optional<LocalErrors> local;

    /// Whether per cent are of something else than the value.
    bool
    is_near_zero() const
    {
      return scale != std::abs(value);
    }

    /// What it may be off by, in its unit. There must be a tolerance.
    double
    most_error() const
    {
      return tolerance->size * (tolerance->is_absolute ? 1. : scale);
    }

    /// Whether the bar can be held to and is within the tolerance.
    bool
    met() const
    {
      return trusted && tolerance && bar <= most_error();
    }
  };
} // namespace lamella

#endif
