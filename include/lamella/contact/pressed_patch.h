// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pressed_patch_h
#define lamella_contact_pressed_patch_h

#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_rows.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// The axis of the scene that is nearest to the normal of a contact with
  /// @p points: of the largest component of sum A n.
  unsigned int
  facing_axis(const std::vector<ContactInterface::Point> &points);

  /// From where to where the @p points of a contact reach along the scene's
  /// @p axis [length].
  std::pair<double, double>
  reach_along(const std::vector<ContactInterface::Point> &points,
              const unsigned int                          axis);

  /**
   * Where a contact presses: mean pressure and width of all of it or of a strip
   * from its ContactTraction, whose points are the rows with their forces
   * lambda_i and tributary areas A_i.
   *
   * *Lines.* Across the facing axis the points are taken by lines along one of
   * the other two axes: chains of neighbours on the grid of the surface that
   * carries them (CarryingSurface::lines()). Of a line the runs of points with
   * a force press, up to an edge on either side:
   * - the last point, where the contact itself ends there;
   * - else the zero s* of the pressure, by its moments over points s_b in the
   *   run. The forces of a line are integrals of the pressure with functions
   *   that sum up to linear ones, so
   *     M_b = sum lambda_i max(0, s_i - s_b) = int p max(0, s - s_b) ds,
   *   and where p falls as the root of s* - s, as it does at the edge of smooth
   *   surfaces, M_b grows as (s* - s_b)^(5/2). Two of them, two and four points
   *   inside the edge (a fourth and half of the run if it is shorter), give
   *     s* = (r s_2 - s_4) / (r - 1),   r = (M_4 / M_2)^(2/5),
   *   at least the last pressed point but one (a point beyond the edge has a
   *   force if its function reaches within) and at most the first open one;
   * - half way from the last pressed to the first open point where the run has
   *   less than four points or the pressure does not fall towards its edge.
   * Where points lie on no lines (less than three a line on average, as those
   * of sections by Gmsh do on ends), widths are the extent of the points that
   * press, each with the root of its area, and edges are as coarse as these.
   */
  class PressedPatch
  {
  public:
    /// @p traction is referred to.
    PressedPatch(const ContactTraction             &traction,
                 const std::optional<ContactStrip> &strip = {});

    /// The largest extent, over all lines whose functions reach into the strip,
    /// of what presses along @p axis [length]: the sum of a line's runs in the
    /// strip. 0 along the facing axis.
    double
    width(const unsigned int axis) const;

    /// The smaller one of those along the two axes that the contact does not
    /// face.
    double
    width() const;

    /**
     * The mean of the pressure over the area that presses,
     *   sum w_i lambda_i / sum w_i v_i A_i    [force / length^2],
     * w_i the share of the row that lies in the strip
     * (ContactTraction::shares()) and v_i that of the point's interval on its
     * line, half way to its neighbours along the axis of width(), that lies in
     * a run. 0 where nothing presses.
     */
    double
    pressure() const;

  private:
    /// An interval of a line, in the coordinate along it [length].
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

    /// The points of a line by ascending coordinate, those at one node
    /// together: force, tributary area, share of the strip; and what presses of
    /// it, also out of the strip.
    struct Line
    {
      std::vector<double>   s, force, area, share;
      std::vector<Interval> runs;
    };

    /// The lines along @p axis.
    std::vector<Line>
    lines_along(const unsigned int axis) const;
    /// The runs of @p line up to their edges.
    static std::vector<Interval>
    runs_of(const Line &line);
    /// The area of @p line that presses, in the strip.
    static double
    pressed_area(const Line &line);
    /// Where the pressure ends beyond the last of the places @p s, ascending,
    /// that have the forces @p force above zero; @p next is the first open
    /// place.
    static double
    edge(const std::vector<double> &s,
         const std::vector<double> &force,
         const std::vector<double> &area,
         const double               next);
    /// Whether the points lie on lines along @p axis.
    static bool
    are_lines(const std::vector<Line> &lines);
    /// The extent along @p axis of points that lie on none.
    double
    extent(const unsigned int axis) const;
    /// The strip, or all, as an interval along @p axis.
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
    /// w_i.
    std::vector<double> shares;
  };
} // namespace lamella

#endif
