// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_carrying_surface_h
#define lamella_contact_carrying_surface_h

#include <lamella/body/facet_map.h>
#include <lamella/contact/polygon.h>
#include <lamella/contact/search.h>

#include <optional>
#include <string>
#include <utility>
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

  /**
   * The part of a surface that the rows of a contact live on, with the
   * functions phi_i of the rows there:
   * - `trace`: pairs of nodes and nodes against a surface. phi_i is the nodal
   *   function of the node's grid, L_a(s) L_b(t) of the expansion's degree,
   *   whose integral is the tributary area of the node.
   * - `hats`: weighted gaps. phi_i is the multiplier's own, bilinear on the
   *   cells between neighbouring nodes, over what of them faces the other side.
   *
   * What belongs together the body says (SurfaceTopology): facets share a node
   * if they name the same number. Plain numbers that refer to no body, of the
   * undeformed scene; made once by make_interface() and shared.
   */
  class CarryingSurface
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
      /// Of the grid of nodes, which are Gauss-Lobatto points.
      unsigned int degree_s = 1, degree_t = 1;
      /// Numbers of the nodes on this surface, those of SurfaceTopology; the
      /// first coordinate runs fastest.
      std::vector<unsigned int> nodes;
      /// To the rows of which nodes the function of each node belongs, with
      /// what share: to its own row with 1; that of a hanging node in halves to
      /// those of its ends; to none where the node faces nothing.
      std::vector<std::vector<std::pair<unsigned int, double>>> rows;
      /// What of the unit square the functions live on: convex,
      /// counterclockwise, each within a cell of the grid if they are hats.
      std::vector<Polygon> parts;
    };

    /// @p n_rows of the contact; @p facets name those below.
    CarryingSurface(const Functions    functions,
                    const unsigned int n_rows,
                    std::vector<Facet> facets);

    /// Of a row: the integrals of its function and of the function times the
    /// place, [length^2] and [length^3].
    struct Integrals
    {
      double               area = 0.;
      dealii::Tensor<1, 3> moment;
    };

    /// int phi_i dA and int x phi_i dA over the surface, for each row.
    const std::vector<Integrals> &
    integrals() const
    {
      return whole;
    }

    /**
     * The same over what lies in @p strip.
     *
     * Exact to rounding on plane parallelograms. Where facets are curved a
     * strip ends on straight lines in (s, t) between places of its end on a
     * grid of four by four; strips side by side leave nothing out and share
     * nothing, wherever they end.
     */
    std::vector<Integrals>
    integrals(const ContactStrip &strip) const;

    /// A place on a facet, by its number.
    struct Place
    {
      unsigned int     facet = 0;
      dealii::Point<2> st;
    };

    /// Where the line through @p x along @p d, a unit vector, meets what rows
    /// live on, up to @p reach [length] ahead or behind; the nearest of such
    /// places.
    std::optional<Place>
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &d,
            const double                reach) const;

    /// The functions of the nodes of the facet at @p place, in their order: a
    /// partition of 1 over the facet.
    std::vector<double>
    functions_at(const Place &place) const;

    /**
     * Chains of nodes that have a row of their own, from neighbour to neighbour
     * along the grids' lines, ascending in the scene's coordinate @p axis and
     * at the same @p across: of each node its rows (two at a sharp edge).
     *
     * Links that leave the coordinate across by more than 1e-6 of the extent of
     * the surface are none, so of a grid that is askew to the scene each node
     * stands alone.
     */
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
    /// Adds the integrals over @p part of @p facet.
    void
    add_integrals(const Facet            &facet,
                  const Polygon          &part,
                  std::vector<Integrals> &sums) const;
    /// The values of the functions of @p facet at @p st.
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

  /// A node that carries a row: where it is in its body, and the normal of the
  /// row, of either sign.
  struct CarryingNode
  {
    Location             location;
    dealii::Tensor<1, 3> normal;
  };

  /**
   * That of rows at nodes of the grids of @p surface of @p body: row k is that
   * of @p nodes[k].
   *
   * @p whole is whether rows live on facets all of whose nodes have one, as
   * where nodes face nodes, and the smaller area of the two counts; rows that
   * have no such facet, and all rows if it is false, live on every facet of
   * their node. Of several rows at one node, as at an edge on which each side
   * keeps its own normal, a facet takes the one whose normal is most like its
   * own, and none that is more than 60 degrees from it. Nodes between others
   * that have rows, where the body has an expansion of lower degree, share
   * their functions with these.
   */
  CarryingSurface
  surface_of_nodes(const Body                      &body,
                   const std::string               &surface,
                   const std::vector<CarryingNode> &nodes,
                   const bool                       whole);

  /**
   * The place (s, t) on the unit square of @p map where the line x + t d meets
   * it, up to 1e-7 outside; @p d a unit vector.
   * Newton's method on the two components of X(s, t) - x across d, from the
   * middle; an affine map takes one step. Nothing if the line misses it or the
   * iteration leaves the facet far behind.
   */
  std::optional<dealii::Point<2>>
  place_on_line(const FacetMap             &map,
                const dealii::Point<3>     &x,
                const dealii::Tensor<1, 3> &d);
} // namespace lamella

#endif
