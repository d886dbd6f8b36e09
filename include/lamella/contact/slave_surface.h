// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_slave_surface_h
#define lamella_contact_slave_surface_h

#include <lamella/body/facet_map.h>
#include <lamella/contact/search.h>
#include <lamella/contact/segments.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Strip of a contact surface between two values of one scene coordinate.
  struct ContactStrip
  {
    unsigned int axis = 0;  ///< Scene coordinate: 0, 1, 2 for x, y, z.
    double       from = 0., ///< Lower undeformed coordinate [length].
      to              = 0.; ///< Upper undeformed coordinate [length].
  };

  /// The slave (nonmortar) surface of a contact with the shape functions phi_i
  /// of its constraints:
  /// - `trace`: nodal contact. phi_i is the Lagrange function of the
  ///   Gauss-Lobatto grid of the expansion degree; its integral is the
  ///   tributary area of the node.
  /// - `hats`: weighted gaps. phi_i is the multiplier function, bilinear on the
  ///   cells between neighboring nodes, on the area that faces the master side.
  ///
  /// Facets share a node if it has the same number in SurfaceTopology.
  class SlaveSurface
  {
  public:
    /// Kind of the shape functions of the constraints.
    enum class Functions
    {
      trace, ///< Lagrange functions of the nodes, for nodal contact.
      hats   ///< Bilinear multiplier functions, for weighted gaps.
    };

    /// A facet of the slave surface with its nodes and constraints.
    struct Facet
    {
      FacetMap     map;          ///< Undeformed geometry X(s, t).
      unsigned int degree_s = 1, ///< Degree of the Gauss-Lobatto grid in s.
        degree_t            = 1; ///< Degree of the Gauss-Lobatto grid in t.
      /// Node numbers of SurfaceTopology; the coordinate s runs fastest.
      std::vector<unsigned int> nodes;
      /// Indices of the constraints to which each node's function contributes,
      /// with factors: 1 for the node's constraint; 1/2 for both end nodes of a
      /// hanging node; none if the node has no constraint.
      std::vector<std::vector<std::pair<unsigned int, double>>> rows;
      /// Polygons (s, t) where functions are nonzero; hats: each in one cell.
      std::vector<Polygon> parts;
    };

    /// Creates the surface of @p facets with @p n_rows constraints.
    SlaveSurface(const Functions    functions,
                 const unsigned int n_rows,
                 std::vector<Facet> facets);

    /// Integrals of a constraint's shape function phi_i over a surface.
    struct Integrals
    {
      double               area = 0.; ///< Integral of phi_i [length^2].
      dealii::Tensor<1, 3> moment;    ///< Integral of x phi_i [length^3].
    };

    /// Returns the integrals of each shape function over the whole surface.
    const std::vector<Integrals> &
    integrals() const
    {
      return whole;
    }

    /// Returns the integrals of each shape function over @p strip. They are
    /// exact to rounding on plane parallelograms. On curved facets, the strip
    /// boundary is approximated by straight lines in (s, t) on a 4 x 4 grid.
    std::vector<Integrals>
    integrals(const ContactStrip &strip) const;

    /// A surface point, given by its facet coordinates.
    struct Place
    {
      unsigned int     facet = 0; ///< Index of the facet in facets().
      dealii::Point<2> st;        ///< Coordinates (s, t) in the unit square.
    };

    /// Returns the surface point nearest to @p x on the line through @p x along
    /// the unit vector @p d, up to @p search_radius [length] in both
    /// directions; empty if there is none.
    std::optional<Place>
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &d,
            const double                search_radius) const;

    /// Returns the values at @p place of the nodal functions of its facet, in
    /// the order of Facet::nodes. They sum to one.
    std::vector<double>
    functions_at(const Place &place) const;

    /// Returns the nodes with constraints, grouped by grid lines of constant
    /// coordinate @p across (to 1e-6 of the surface extent). Nodes of a line
    /// are in ascending order of the coordinate @p axis. Each node is a list of
    /// the indices of its constraints, two at a sharp edge.
    std::vector<std::vector<std::vector<unsigned int>>>
    lines(const unsigned int axis, const unsigned int across) const;

    /// Returns the number of constraints.
    unsigned int
    n_rows() const
    {
      return rows;
    }

    /// Returns the facets of the surface.
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
    /// Sets @p values to the nodal functions of @p facet at (s, t) = @p st.
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

  /// A surface node with a contact constraint.
  struct SlaveNode
  {
    Location             location; ///< Element and unit coordinates.
    dealii::Tensor<1, 3> normal;   ///< Unit normal, inward or outward.
  };

  /// Returns the slave surface of nodal contact on @p surface of @p body, with
  /// constraint k at the facet grid node @p nodes[k].
  ///
  /// The function of a constraint is nonzero on the facets of its node. If @p
  /// whole is true (node pairs), these are only the facets all of whose nodes
  /// have a constraint, unless there is none. If several constraints are at one
  /// node, a facet uses the one with the closest normal, within 60 degrees of
  /// its own. The function of a node without a constraint, between two nodes
  /// with constraints on a grid line, is divided between these.
  SlaveSurface
  make_nodal_slave_surface(const Body                   &body,
                           const std::string            &surface,
                           const std::vector<SlaveNode> &nodes,
                           const bool                    whole);

  /// Returns the facet coordinates at which the line through @p x along the
  /// unit vector @p d intersects the facet with the map @p map. Points up to
  /// 1e-7 outside the unit square are accepted. Newton's method, from the
  /// center; returns an empty optional if it does not converge.
  std::optional<dealii::Point<2>>
  line_intersection(const FacetMap             &map,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &d);
} // namespace lamella

#endif
