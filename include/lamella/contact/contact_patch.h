// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_patch_h
#define lamella_contact_contact_patch_h

#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_constraints.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Returns the scene axis (0, 1, 2) along which the contact mainly acts: the
  /// largest component of the area-weighted mean normal of @p points.
  unsigned int
  facing_axis(const std::vector<ContactInterface::Point> &points);

  /// Returns the range (smallest, largest coordinate) of the contact points @p
  /// points along scene axis @p axis [length].
  std::pair<double, double>
  search_radius_along(const std::vector<ContactInterface::Point> &points,
                      const unsigned int                          axis);

  /// Loaded area of a contact, or of a strip of it: width and mean pressure,
  /// from the forces lambda_i and areas A_i of the contact points.
  ///
  /// Points are grouped into lines along one of the two axes normal to
  /// facing_axis(): chains of neighbors on the grid of the slave surface
  /// (SlaveSurface::lines()). A loaded interval consists of adjacent points
  /// with a force. On either side it ends at
  /// - the last point with a force if the contact ends there;
  /// - else the zero s* of the pressure p(s), extrapolated as at the edge of
  ///   Hertzian contact, where p falls as the root of s* - s. The moments M_b =
  ///   sum lambda_i max(0, s_i - s_b) about points s_b then grow as (s* -
  ///   s_b)^(5/2). M_2 and M_4 about the points two and four inside the edge
  ///   give s* = (r s_2 - s_4) / (r - 1), r = (M_4 / M_2)^(2/5);
  /// - but midway between the last loaded and the first open point for less
  ///   than four loaded points, or if the pressure does not fall to the edge.
  ///
  /// If lines have on average fewer than three points, the width is the extent
  /// of the loaded points, each with a square of its area around it.
  class ContactPatch
  {
  public:
    /// Evaluates @p traction in @p strip, or in the whole contact without a
    /// strip. Keeps a reference to @p traction, which must outlive this object.
    ContactPatch(const ContactTraction             &traction,
                 const std::optional<ContactStrip> &strip = {});

    /// Returns the largest extent of the loaded area along scene axis @p axis
    /// [length]; 0 along the axis on which the contact mainly acts.
    double
    width(const unsigned int axis) const;

    /// Returns the smaller width along the two tangential axes [length].
    double
    width() const;

    /// Returns the mean pressure over the loaded area,
    ///   sum w_i lambda_i / sum w_i v_i A_i    [force / length^2],
    /// with forces lambda_i, areas A_i, the fraction w_i of contact point i in
    /// the strip (ContactTraction::shares()), and the fraction v_i of its
    /// interval that is loaded. The interval extends halfway to the neighbors
    /// along the axis of width(). Returns 0 if there is no load.
    double
    pressure() const;

    /// Returns the largest tension -lambda_i / A_i of contact points in the
    /// strip, zero if there is none [force / length^2]: the peel stress of a
    /// tie.
    double
    peel() const;

    /// Returns the largest shear traction |lambda_t,i| / A_i in the strip.
    double
    shear() const;

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

    /// Contact points on a line: coordinates s in ascending order, forces,
    /// areas, fractions in the strip; and the loaded intervals `runs`.
    struct Line
    {
      std::vector<double>   s, force, area, share;
      std::vector<Interval> runs;
    };

    /// Returns the lines of contact points along scene axis @p axis.
    std::vector<Line>
    lines_along(const unsigned int axis) const;
    /// Returns the loaded intervals of @p line, extended to their edges.
    static std::vector<Interval>
    loaded_intervals(const Line &line);
    /// Returns the loaded area of @p line in the strip.
    static double
    loaded_area(const Line &line);
    /// Returns the coordinate at which the pressure vanishes beyond the last of
    /// the loaded points with ascending coordinates @p s, forces @p force and
    /// areas @p area. @p next is the coordinate of the first open point.
    static double
    edge(const std::vector<double> &s,
         const std::vector<double> &force,
         const std::vector<double> &area,
         const double               next);
    /// Returns true if the lines have at least three points each on average.
    static bool
    are_lines(const std::vector<Line> &lines);
    /// Returns the extent along @p axis of points that do not form lines.
    double
    extent(const unsigned int axis) const;
    /// Returns the range of the strip along scene axis @p axis, or all numbers.
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
    /// Fraction of each contact point in the strip.
    std::vector<double> shares;
  };
} // namespace lamella

#endif
