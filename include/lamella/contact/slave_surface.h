// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_slave_surface_h
#define lamella_contact_slave_surface_h

#include <lamella/body/facet_map.h>
#include <lamella/contact/polygon.h>
#include <lamella/contact/search.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Strip of a contact between two values of a scene coordinate.
  struct ContactStrip
  {
    /// Axis: 0, 1, 2 for x, y, z.
    unsigned int axis = 0;
    /// Undeformed coordinates [length], from < to.
    double from = 0., to = 0.;
  };

  /// The slave (nonmortar) surface of a contact, restricted to the support of
  /// the contact constraints, with their functions phi_i:
  /// - `trace`: nodal contact. phi_i is the nodal function L_a(s) L_b(t) of the
  ///   grid of the expansion degree; its integral is the tributary area of the
  ///   node.
  /// - `hats`: weighted gaps. phi_i is the multiplier function, bilinear on the
  ///   cells between neighboring nodes, restricted to the part that faces the
  ///   other side.
  /// Facets share a node if it has the same number in SurfaceTopology. The
  /// geometry is undeformed and does not refer to a body.
  class SlaveSurface
  {
  public:
    enum class Functions
    {
      trace,
      hats
    };

    struct Facet
    {
      FacetMap map;
      /// Degrees of the grid of Gauss-Lobatto nodes in s and t.
      unsigned int degree_s = 1, degree_t = 1;
      /// Node numbers of SurfaceTopology; the first coordinate runs fastest.
      std::vector<unsigned int> nodes;
      /// For each node, the numbers of the constraints to which its function
      /// contributes, with factors: 1 for its own constraint; 1/2 for each of
      /// the end nodes of a hanging node; none if it faces nothing.
      std::vector<std::vector<std::pair<unsigned int, double>>> rows;
      /// Parts of the unit square in which the functions are not zero; for hats
      /// each within a grid cell.
      std::vector<Polygon> parts;
    };

    /// Creates the surface with @p n_rows constraints, used by @p facets.
    SlaveSurface(const Functions    functions,
                 const unsigned int n_rows,
                 std::vector<Facet> facets);

    /// Integral of a constraint's function phi_i [length^2], and of x phi_i.
    struct Integrals
    {
      double               area = 0.;
      dealii::Tensor<1, 3> moment;
    };

    /// Returns the integrals of each constraint over the whole surface.
    const std::vector<Integrals> &
    integrals() const
    {
      return whole;
    }

    /// Returns the integrals over the part of the surface in @p strip, exact to
    /// rounding on plane parallelograms. On curved facets, the boundary of the
    /// strip is approximated by straight lines in (s, t) on a 4 x 4 grid.
    std::vector<Integrals>
    integrals(const ContactStrip &strip) const;

    /// A point (s, t) on the facet of the given number.
    struct Place
    {
      unsigned int     facet = 0;
      dealii::Point<2> st;
    };

    /// Returns the nearest intersection with the line through @p x along the
    /// unit vector @p d, up to @p search_radius [length] in both directions.
    std::optional<Place>
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &d,
            const double                search_radius) const;

    /// Returns the facet's nodal functions at @p place (partition of unity).
    std::vector<double>
    functions_at(const Place &place) const;

    /// Returns chains of neighboring nodes with constraints, along grid lines
    /// on which the coordinate @p across is constant (to 1e-6 of the surface
    /// extent), by ascending coordinate @p axis. Each entry lists the
    /// constraints of a node, two at a sharp edge. Oblique grids: a node is a
    /// chain.
    std::vector<std::vector<std::vector<unsigned int>>>
    lines(const unsigned int axis, const unsigned int across) const;

    Functions
    functions() const
    {
      return kind;
    }

    unsigned int
    n_rows() const
    {
      return rows;
    }

    const std::vector<Facet> &
    facets() const
    {
      return all;
    }

  private:
    /// Adds the integrals over the polygon @p part of @p facet to @p sums.
    void
    add_integrals(const Facet            &facet,
                  const Polygon          &part,
                  std::vector<Integrals> &sums) const;
    /// Evaluates the functions of @p facet at @p st.
    void
    evaluate(const Facet            &facet,
             const dealii::Point<2> &st,
             std::vector<double>    &values) const;

    Functions              kind;
    unsigned int           rows;
    std::vector<Facet>     all;
    std::vector<Integrals> whole;
    BoxSearch              boxes;
  };

  /// A node with a contact constraint, and its surface normal (either sign).
  struct SlaveNode
  {
    Location             location;
    dealii::Tensor<1, 3> normal;
  };

  /// Returns the slave surface of nodal contact on @p surface of @p body, with
  /// constraint k at node @p nodes[k] of the facet grids.
  ///
  /// If @p whole, as for node pairs, constraints have support on facets all of
  /// whose nodes have a constraint. Constraints without such a facet, and all
  /// constraints otherwise, have support on every facet of their node. If
  /// several constraints are at one node, a facet uses the one with the closest
  /// normal, within 60 degrees of its own. If the body has a lower expansion
  /// degree, functions of nodes in between are added to those of nodes with
  /// constraints.
  SlaveSurface
  make_nodal_slave_surface(const Body                   &body,
                           const std::string            &surface,
                           const std::vector<SlaveNode> &nodes,
                           const bool                    whole);

  /// Returns the intersection (s, t) of the line x + t d, with unit vector
  /// @p d, and a facet with the map @p map, up to 1e-7 outside the unit square.
  /// Newton's method, from the center. Empty without intersection.
  std::optional<dealii::Point<2>>
  line_intersection(const FacetMap             &map,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &d);
} // namespace lamella

#endif
