// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_pressed_patch_h
#define lamella_recover_pressed_patch_h

#include <lamella/recover/results.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// The part of a contact between two values of a scene coordinate.
  struct ContactStrip
  {
    /// 0, 1, 2 for x, y, z.
    unsigned int axis = 0;
    /// Undeformed places [length], from < to.
    double from = 0., to = 0.;
  };

  /// Where @p point of a contact is, undeformed in the scene: the node that
  /// carries it, or its place on First if it has none.
  inline const dealii::Point<3> &
  place_of(const ContactInterface::Point &point)
  {
    return point.node.places.empty() ? point.first : point.node.position;
  }

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
   * What of a contact presses: resultant, mean pressure and width of all of it
   * or of a strip, from the forces lambda_i of its points and their tributary
   * areas A_i.
   *
   * *Strips.* Along an axis of the scene a point stands for the interval half
   * way to the next coordinates at which the contact has points (up to the
   * first and the last one themselves), and a strip has the share w_i of it
   * that lies in the strip. Strips that follow each other have shares that sum
   * to 1, so their forces sum to that of the contact, and nothing jumps where
   * the end of a strip passes a point.
   *
   * *Lines.* Across the facing axis the points are taken by lines along one of
   * the other two axes, those with the same coordinate on the third. Of a line
   * the runs of points with a force press, up to an edge on either side:
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
    /// @p rows are those of a contact; referred to.
    PressedPatch(const std::vector<ContactRow>     &rows,
                 const std::optional<ContactStrip> &strip = {});

    /// sum w_i (force and moment of the point) on the second side, the moment
    /// about the scene's origin.
    Wrench
    resultant() const;

    /// The largest extent, over all lines, of what presses along @p axis
    /// [length]: the sum of a line's runs in the strip. 0 along the facing
    /// axis.
    double
    width(const unsigned int axis) const;

    /// The smaller one of those along the two axes that the contact does not
    /// face.
    double
    width() const;

    /**
     * The mean of the pressure over the area that presses,
     *   sum w_i lambda_i / sum v_i A_i    [force / length^2],
     * v_i the share of the point's interval on its line, along the axis of
     * width(), that lies in a run and in the strip. 0 where nothing presses.
     */
    double
    pressure() const;

    /// The largest lambda_i / A_i.
    double
    largest_pressure() const;

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

    /// The points of a line by ascending coordinate, those at one place
    /// together: force, tributary area, share of a strip across the line; and
    /// what presses of it.
    struct Line
    {
      std::vector<double>   s, force, area, share;
      std::vector<Interval> runs;
    };

    /// Numbers of the @p points by their coordinate along @p axis, those of the
    /// same one together, ascending.
    std::vector<std::vector<unsigned int>>
    by_coordinate(const std::vector<unsigned int> &points,
                  const unsigned int               axis) const;
    double
    coordinate(const unsigned int point, const unsigned int axis) const
    {
      return place_of(rows[point].point)[axis];
    }

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

    const std::vector<ContactRow>    &rows;
    const std::optional<ContactStrip> strip;
    unsigned int                      facing = 2;
    /// w_i.
    std::vector<double> shares;
  };
} // namespace lamella

#endif
