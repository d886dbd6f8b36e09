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
  /// Part of a contact between two values of a scene coordinate.
  struct ContactStrip
  {
    /// Axis: 0, 1, 2 for x, y, z.
    unsigned int axis = 0;
    /// Undeformed coordinates [length], from < to.
    double from = 0., to = 0.;
  };

  /**
   * The slave (nonmortar) surface of a contact, restricted to the support of
   * its rows, with their functions phi_i:
   * - `trace`: node pairs and nodes against a surface. phi_i is the nodal
   *   function of the grid, L_a(s) L_b(t) of the expansion degree; its integral
   *   is the tributary area of the node.
   * - `hats`: weighted gaps. phi_i is the multiplier function, bilinear on the
   *   cells between neighboring nodes, restricted to the part that faces the
   *   other side.
   * Facets share a node if they have the same number in SurfaceTopology.
   * Undeformed geometry without reference to a body, from make_interface().
   */
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
      /// Degrees of the grid of nodes, which are Gauss-Lobatto points.
      unsigned int degree_s = 1, degree_t = 1;
      /// Node numbers of SurfaceTopology; the first coordinate runs fastest.
      std::vector<unsigned int> nodes;
      /// Rows to which each node's function contributes: its own with 1; for a
      /// hanging node those of its ends with halves; none if it faces nothing.
      std::vector<std::vector<std::pair<unsigned int, double>>> rows;
      /// Parts of the unit square in the functions' support: convex,
      /// counterclockwise, each within a grid cell for hats.
      std::vector<Polygon> parts;
    };

    /// Creates the surface with @p n_rows rows, which @p facets refer to.
    SlaveSurface(const Functions    functions,
                 const unsigned int n_rows,
                 std::vector<Facet> facets);

    /// Integrals of a row's function [length^2], and of it times position.
    struct Integrals
    {
      double               area = 0.;
      dealii::Tensor<1, 3> moment;
    };

    /// Returns int phi_i dA and int x phi_i dA over the surface for each row.
    const std::vector<Integrals> &
    integrals() const
    {
      return whole;
    }

    /// Returns the integrals() over the part in @p strip, exact to rounding on
    /// plane parallelograms. On curved facets a strip ends on straight lines in
    /// (s, t) between points of its boundary on a 4 x 4 grid.
    std::vector<Integrals>
    integrals(const ContactStrip &strip) const;

    /// A point on a facet, given by its number.
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

    /// Returns the facet's nodal functions at @p place, a partition of unity.
    std::vector<double>
    functions_at(const Place &place) const;

    /// Returns chains of neighboring nodes that have rows, along the grid
    /// lines, by ascending coordinate @p axis at constant coordinate @p across
    /// (to 1e-6 of the surface extent). Each entry lists the rows of a node,
    /// two at a sharp edge. On a grid oblique to the scene axes each node is a
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
    /// Adds the integrals over @p part of @p facet to @p sums.
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

  /// A node with a row: its location, and the row's normal of either sign.
  struct SlaveNode
  {
    Location             location;
    dealii::Tensor<1, 3> normal;
  };

  /**
   * Returns the slave surface with a row k at each node @p nodes[k] of the
   * grids of @p surface of @p body.
   *
   * If @p whole, rows have support on facets all of whose nodes have a row, as
   * for node pairs, where the smaller area counts. Rows without such a facet,
   * and all rows otherwise, have support on every facet of their node. Of
   * several rows at one node, a facet takes the one with the closest normal,
   * within 60 degrees of its own. Nodes between others that have rows, where
   * the body has an expansion of lower degree, share their functions with
   * these.
   */
  SlaveSurface
  make_nodal_slave_surface(const Body                   &body,
                           const std::string            &surface,
                           const std::vector<SlaveNode> &nodes,
                           const bool                    whole);

  /// Returns the intersection (s, t) of the line x + t d, unit @p d, with @p
  /// map, up to 1e-7 outside the unit square. Newton's method, from the center,
  /// on the two components of X(s, t) - x normal to d; an affine map takes one
  /// step. Empty if the line misses or the iteration leaves the facet far
  /// behind.
  std::optional<dealii::Point<2>>
  line_intersection(const FacetMap             &map,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &d);
} // namespace lamella

#endif
