// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_goal_result_h
#define lamella_recover_goal_result_h

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
    /// What the gap rows of the finer model find between the surfaces of the
    /// coarser one, and its forces that they do not have.
    double contact = 0.;
    /// What neither says: zero to rounding where all displacements of the
    /// coarser model are among those of the finer one, under one law.
    double remainder = 0.;
  };

  /// A number that a run was made for, and what is held of its error. In the
  /// unit of the quantity.
  struct GoalResult
  {
    /// As the scene says it: `tip: uz`.
    std::string name;
    double      value = 0.;
    /// The estimated error, to be added to the value, and what bounds it.
    double estimate = 0., bar = 0.;
    /// Whether the bar can be held to; if not, why.
    bool        trusted = false;
    std::string why;
    /// What tolerances are shares of: |value|, or the largest of its kind in
    /// the scene where that is near zero.
    double scale = 0.;
    /// As a share of the scale, if one was asked for.
    std::optional<double> tolerance;
    /// What the estimate is the sum of, by the source of the error.
    std::vector<std::pair<std::string, double>> shares;
    /// The share of the axis, by elements; none where that is not known.
    std::optional<LocalErrors> local;

    /// Whether the bar can be held to and is within the tolerance.
    bool
    met() const
    {
      return trusted && tolerance && bar <= *tolerance * scale;
    }
  };
} // namespace lamella

#endif
