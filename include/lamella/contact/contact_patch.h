// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_patch_h
#define lamella_contact_contact_patch_h

#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_constraints.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Returns the scene axis of the largest component of sum A n over @p points.
  unsigned int
  facing_axis(const std::vector<ContactInterface::Point> &points);

  /// Returns the range of @p points along the scene axis @p axis [length].
  std::pair<double, double>
  search_radius_along(const std::vector<ContactInterface::Point> &points,
                      const unsigned int                          axis);

  /**
   * Loaded area of a contact: mean pressure and width of all of it or a strip,
   * from its ContactTraction, whose points are the rows with their forces
   * lambda_i and tributary areas A_i.
   *
   * *Lines.* Normal to the facing axis, points are grouped into lines along one
   * of the other two axes: chains of neighbors on the grid of the slave surface
   * (SlaveSurface::lines()). Runs of points with a force on a line are loaded,
   * up to an edge on either side:
   * - the last point, where the contact itself ends there;
   * - else the zero s* of the pressure, by its moments over points s_b in the
   *   run. The forces of a line are integrals of the pressure with functions
   *   that sum up to linear ones, so
   *     M_b = sum lambda_i max(0, s_i - s_b) = int p max(0, s - s_b) ds,
   *   and where p falls as the root of s* - s, as it does at the edge of smooth
   *   surfaces, M_b grows as (s* - s_b)^(5/2). Two of them, two and four points
   *   inside the edge (a fourth and half of the run if it is shorter), give
   *     s* = (r s_2 - s_4) / (r - 1),   r = (M_4 / M_2)^(2/5),
   *   at least the last loaded point but one and at most the first open one;
   * - halfway from the last loaded to the first open point if the run has fewer
   *   than four points or the pressure does not fall towards its edge.
   *
   * If points are not on lines (on average fewer than three per line), widths
   * are the extent of the loaded points, each with the root of its area.
   */
  class ContactPatch
  {
  public:
    /// Refers to @p traction.
    ContactPatch(const ContactTraction             &traction,
                 const std::optional<ContactStrip> &strip = {});

    /// Returns the largest extent of the loaded part along @p axis [length]:
    /// the runs of a line in the strip. 0 along the facing axis.
    double
    width(const unsigned int axis) const;

    /// Returns the smaller width along the two axes normal to the facing axis.
    double
    width() const;

    /// Returns the mean pressure over the loaded area,
    ///   sum w_i lambda_i / sum w_i v_i A_i    [force / length^2],
    /// with the share w_i of the row in the strip (ContactTraction::shares()),
    /// and the share v_i in a run of the point's interval, halfway to its
    /// neighbors on the line along the axis of width(). 0 without load.
    double
    pressure() const;

  private:
    /// Interval of a line, in the coordinate along it [length].
    struct Interval
    {
      double begin, end;

      double
      overlap(const Interval &other) const
      {
        return std::max(0.,
                        std::min(end, other.end) -
                          std::max(begin, other.begin));
      }
    };

    /// Points of a line by coordinate, those at one node combined: force,
    /// tributary area, share of the strip; and all loaded runs.
    struct Line
    {
      std::vector<double>   s, force, area, share;
      std::vector<Interval> runs;
    };

    /// Returns the lines along @p axis.
    std::vector<Line>
    lines_along(const unsigned int axis) const;
    /// Returns the runs of @p line up to their edges.
    static std::vector<Interval>
    loaded_intervals(const Line &line);
    /// Returns the loaded area of @p line in the strip.
    static double
    loaded_area(const Line &line);
    /// Returns the pressure's edge beyond the last of the ascending coordinates
    /// @p s with positive @p force; @p next is the first open point.
    static double
    edge(const std::vector<double> &s,
         const std::vector<double> &force,
         const std::vector<double> &area,
         const double               next);
    /// Returns true if the points lie on lines along @p axis.
    static bool
    are_lines(const std::vector<Line> &lines);
    /// Returns the extent along @p axis of points that lie on no lines.
    double
    extent(const unsigned int axis) const;
    /// Returns the strip, or everything, as an interval along @p axis.
    Interval
    limits(const unsigned int axis) const;

    double
    coordinate(const unsigned int row, const unsigned int axis) const
    {
      return traction.rows()[row].place[axis];
    }

    const ContactTraction            &traction;
    const std::optional<ContactStrip> strip;
    unsigned int                      facing = 2;
    /// Shares w_i of the rows.
    std::vector<double> shares;
  };
} // namespace lamella

#endif
