// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_solid_h
#define lamella_body_solid_h

#include <lamella/body/body.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/hexahedron.h>
#include <lamella/section/finite_strain.h>
#include <lamella/section/ply_laws.h>

#include <deal.II/numerics/rtree.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  struct StrainMap;
  class SurfaceNode;

  /// A body of hexahedra (a section mesh extruded along the axis), a reference
  /// for beam theories. Elements are Q1 with incompatible modes or Q2. Local
  /// refinement creates hanging nodes. DoF 3 i + c is displacement component c,
  /// in body axes, at node i. Hexahedra of equal ply and shape share their
  /// matrices.
  class Solid : public Body
  {
  public:
    /// Constructs a solid of @p degree 1 or 2; @p refinement is in body axes.
    Solid(const std::string                        &name,
          const std::shared_ptr<const SectionMesh> &section,
          const AxisMesh                           &axis,
          const Placement                          &placement,
          const unsigned int                        degree,
          const SolidRefinement                    &refinement = {});

    std::string
    theory() const override;
    DofIndex
    n_dofs() const override
    {
      return 3 * mesh.nodes().size();
    }
    bool
    is_nodal() const override
    {
      return true;
    }
    double
    stiffness_entries() const override;
    dealii::IndexSet
    owned_dofs() const override;
    DofInfo
    dof(const DofIndex dof) const override
    {
      return {placement.to_scene(mesh.nodes()[dof / 3])};
    }

    const Constraints &
    kinematic_constraints() const override
    {
      return hanging;
    }
    std::vector<Vector>
    rigid_motions(const Vector &u) const override;
    double
    size() const override;
    dealii::BoundingBox<3>
    bounding_box() const override;

    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    void
    for_each_stiffness_block(const Vector        &u,
                             const Vector        &correction,
                             const bool           with_values,
                             const BlockCallback &use) const override;
    Deformation
    deformation(const Vector &u) const override;
    std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const override;
    double
    add_thermal_load(const Vector &u, Vector &f) const override;
    void
    for_each_mass_block(const Vector        &u,
                        const bool           with_values,
                        const BlockCallback &use) const override;
    const std::vector<Ply> &
    plies() const override
    {
      return mesh.section().plies;
    }

    std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const override;
    std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Vector                &u,
         const Quantity               quantity = Quantity::displacement,
         const Frame                  frame    = Frame::scene) const override;
    FieldSample
    sample(const Location &location, const Vector &u) const override;
    dealii::Point<3>
    position(const Location::Place &place) const override;
    PlyAndAxes
    ply_at(const Location::Place &place) const override;
    Cells
    cells() const override
    {
      return {static_cast<unsigned int>(mesh.cells().size()),
              mesh.owned_cells(),
              {{degree(), degree(), degree()}}};
    }

    std::vector<std::string>
    surfaces() const override;
    std::vector<SurfacePoint>
    surface_points(const std::string &surface) const override;
    std::vector<Location>
    body_points() const override;
    SurfaceTopology
    surface_topology(const std::string &surface) const override;
    SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const override;
    std::vector<double>
    line_breaks(const dealii::Point<3> &from,
                const dealii::Point<3> &to) const override;
    /// Returns the polynomial degree of the hexahedra, 1 or 2.
    unsigned int
    degree() const
    {
      return element.degree();
    }

    /// Returns the mesh, in body axes.
    const HexahedralMesh &
    hexahedra() const
    {
      return mesh;
    }

  protected:
    /// Returns displacement, strain and stress at a point of one element.
    virtual FieldSample
    sample_at_element_point(const Location::Place &place,
                            const Vector          &u) const;

    /// Returns the finite element, which all hexahedra share.
    const Hexahedron &
    hexahedron() const
    {
      return element;
    }
    /// Returns the node positions of @p cell, body axes.
    Hexahedron::Nodes
    nodes_of(const unsigned int cell) const;
    /// Returns the DoFs of @p cell in the order of Hexahedron.
    std::vector<DofIndex>
    dofs_of(const unsigned int cell) const;
    /// Returns the elastic law of @p cell at the point @p x, in body axes.
    ElasticLaw
    law(const unsigned int cell, const dealii::Point<3> &x) const
    {
      return laws.at(mesh.cells()[cell].ply, {x[0], x[2]});
    }
    /// Returns the ply axes of @p cell at the point @p x, in body axes.
    Triad
    ply_axes(const unsigned int cell, const dealii::Point<3> &x) const
    {
      return mesh.section().plies[mesh.cells()[cell].ply].axes({x[0], x[2]});
    }

    /// Returns the nodal displacements of @p cell minus those of its first
    /// node, so that rigid translations cause exactly zero strain.
    std::vector<double>
    relative_displacements(const unsigned int cell, const Vector &u) const;

    /// Returns the displacement gradient H of @p u at @p point of @p cell.
    Gradient
    gradient_at(const unsigned int     cell,
                const HexahedronPoint &point,
                const Vector          &u) const;

    /// Returns the law with thermal strain at @p x (unit coordinates @p unit).
    /// Degree 1 uses the temperature at the element center.
    ElasticLaw
    law_at(const unsigned int      cell,
           const dealii::Point<3> &unit,
           const dealii::Point<3> &x) const;

  private:
    friend class SolidSecondOrder;

    /// A set of hexahedra with equal element matrices: the index of one of
    /// them, and the indices of all that this process owns.
    struct Kind
    {
      unsigned int              cell = 0;
      IncompatibleModes         modes;
      std::vector<unsigned int> own_cells;
    };

    void
    find_kinds();
    void
    make_boxes();

    /// Calls @p use(cell, k, point, B, law) for the hexahedra of this process
    /// at each point, with the number k, that @p points_of(nodes) returns. The
    /// strain there is B times the relative displacements.
    template <typename Points, typename Use>
    void
    for_each_point(const Points &points_of, const Use &use) const
    {
      for (const Kind &kind : kinds)
        if (!kind.own_cells.empty())
          {
            unsigned int k = 0;
            for (const HexahedronPoint &point : points_of(nodes_of(kind.cell)))
              {
                const std::vector<Voigt> B = element.strains(point, kind.modes);
                const ElasticLaw law_here  = law(kind.cell, point.position);
                for (const unsigned int cell : kind.own_cells)
                  use(cell, k, point, B, law_here);
                ++k;
              }
          }
    }

    /// Calls for_each_point() with the points of full integration.
    template <typename Use>
    void
    for_each_gauss_point(const Use &use) const
    {
      for_each_point(
        [this](const Hexahedron::Nodes &nodes) {
          return element.quadrature_points(nodes);
        },
        [&use](const unsigned int cell,
               unsigned int,
               const HexahedronPoint    &point,
               const std::vector<Voigt> &B,
               const ElasticLaw         &law) { use(cell, point, B, law); });
    }

    /// Returns the elasticity matrix of @p cell as a function of the point.
    StiffnessField
    stiffness_of(const unsigned int cell) const;

    /// Adds @p share times functionals of @p quantity at @p place to @p rows.
    void
    add_to_rows(const Location::Place         &place,
                const Quantity                 quantity,
                const StrainMap               &to_frame,
                const double                   share,
                std::vector<LinearFunctional> &rows) const;

    /// Returns the cells with bounding boxes within @p tolerance of @p around.
    std::vector<std::pair<dealii::BoundingBox<3>, unsigned int>>
    cells_near(dealii::BoundingBox<3> around, const double tolerance) const;

    /// Returns the locations of the scene point @p point, one per adjacent ply.
    std::vector<Location>
    locate(const dealii::Point<3> &point, const double tolerance) const;

    /// Returns unit coordinates and distance of the cell point nearest to @p x.
    std::pair<dealii::Point<3>, double>
    nearest_in_cell(const unsigned int cell, const dealii::Point<3> &x) const;

    /// Returns the surface point of @p cell at @p unit on its face @p face.
    SurfacePoint
    face_point(const unsigned int      cell,
               const unsigned int      face,
               const dealii::Point<3> &unit) const;

    /// Returns the facets of surface_topology() for @p surface.
    std::vector<SurfaceFacet>
    facets_of(const std::string &surface) const;

    /// Hanging nodes of the mesh by their node index.
    using HangingNodes =
      std::map<unsigned int, const HexahedralMesh::HangingNode *>;

    /// Adds the area of @p face of @p cell to its surface nodes @p nodes.
    void
    add_face(const unsigned int                   cell,
             const unsigned int                   face,
             const HangingNodes                  &hangs,
             std::map<unsigned int, SurfaceNode> &nodes) const;

    /// Adds the intersections of the line a + t d, in the plane of the section,
    /// with the edge of @p cell from corner @p v to @p w, which may be curved.
    void
    add_side_crossings(const unsigned int          cell,
                       const unsigned int          v,
                       const unsigned int          w,
                       const dealii::Point<2>     &a,
                       const dealii::Tensor<1, 2> &d,
                       const double                tolerance,
                       std::vector<double>        &crossings) const;

    /// Returns the element faces (cell, face) of the surface @p surface.
    std::vector<std::pair<unsigned int, unsigned int>>
    faces_of(const std::string &surface) const;

    HexahedralMesh            mesh;
    Hexahedron                element;
    double                    axis_length;
    PlyLaws                   laws;
    Constraints               hanging;
    std::vector<Kind>         kinds;
    std::vector<unsigned int> kind_of_cell;
    bool                      is_curved = false;
    dealii::BoundingBox<3>    box;
    dealii::RTree<std::pair<dealii::BoundingBox<3>, unsigned int>> boxes;
  };
} // namespace lamella

#endif
