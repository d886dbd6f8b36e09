// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_h
#define lamella_body_beam_h

#include <lamella/body/axis_loop.h>
#include <lamella/body/body.h>
#include <lamella/body/fields.h>
#include <lamella/body/placement.h>

namespace lamella
{
  /**
   * A beam in the Carrera Unified Formulation: a section times an axis,
   *   u(x, y, z) = sum N_i(y) Phi_alpha(x, z) u_(i,alpha)     (Eqs. 1 and 7),
   * with the stiffness of Eq. 12 as a sum of Kronecker products,
   *   K = A_NN (x) S_00 + A_NdN (x) S_01 + A_dNN (x) S_10 + A_dNdN (x) S_11
   * (and, for assumed transverse shear strains, (A_shear - A_NN) (x) S_shear).
   * EBBT is TBT with Kirchhoff's constraint on each element.
   *
   * N_i is the shape function of axis node i (Axis), Phi_alpha a vector field
   * of the section, made of the paper's F_tau (Section). With D = D_s + D_y
   * d/dy of Eq. 5 the strain is
   *   epsilon = sum (N_i D_s Phi_alpha + N_i' D_y Phi_alpha) u_(i,alpha),
   * so K needs only integrals A_pq over the axis and S_pq over the section. The
   * 3 x 3 blocks of K are the paper's nuclei k^(ij tau s), except for linear
   * fields, some of which combine two functions.
   *
   * Processes share the rows of K by axis nodes (Axis::own_nodes()), and volume
   * integrals by axis elements (Axis::own_cells()). A "cell" of Location is
   * axis element * (number of section cells) + section cell, with unit
   * coordinates (xi, place along the axis element, eta).
   */
  class Beam : public Body
  {
  public:
    /// Constructs a beam whose axis nodes all carry all fields of the section.
    /// Throws InputError if there are more processes than axis nodes.
    Beam(const std::string             &name,
         std::shared_ptr<const Section> section,
         std::shared_ptr<const Axis>    axis,
         const Placement               &placement);

    /// Constructs a beam of node-dependent kinematics with the lists of
    /// BeamDofMap. EBBT needs B4 and all fields at all nodes. Throws InputError
    /// if there are more processes than axis nodes.
    Beam(const std::string                            &name,
         std::shared_ptr<const Section>                section,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node);

    /// Constructs such a beam with modes; theory() begins with @p theory.
    Beam(const std::string                            &name,
         std::shared_ptr<const SectionSpace>           space,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node,
         const std::string                            &theory);

    /// Returns the theory, with the number of dependent polynomials of TE-N.
    std::string
    theory() const override;
    /// Returns the sum over axis nodes of the numbers of their fields.
    DofIndex
    n_dofs() const override
    {
      return dof_map.n_dofs();
    }

    /// Returns the number of DoFs of the nodes of the axis element @p cell.
    unsigned int
    n_dofs_of_cell(const unsigned int cell) const
    {
      unsigned int sum = 0;
      for (const unsigned int node : axis().nodes_of_cell(cell))
        sum += dof_map.fields(node).size();
      return sum;
    }
    /// Returns the non-zeros of A times those of S, exact for full lists.
    double
    stiffness_entries() const override;
    dealii::IndexSet
    owned_dofs() const override;
    unsigned int
    dof_level(const DofIndex dof) const override;
    std::vector<double>
    dof_scales() const override;
    /// Returns the place of the DoF's node on the centroid axis.
    dealii::Point<3>
    dof_position(const DofIndex dof) const override;
    const Constraints &
    kinematic_constraints() const override
    {
      return kirchhoff;
    }
    /// Returns the rigid motions, a few entries per node. With v the direction
    /// in body axes, h the section's reference length and y_m the middle of the
    /// axis, a rotation has in the fields of RigidField
    ///   u_x = -v_z (y - y_m),  u_z = v_x (y - y_m)        (translations),
    ///   h v_z, -h v_x                                     (slopes of u_y),
    ///   h v_y                                             (rotation about y).
    std::vector<Vector>
    rigid_motions() const override;
    std::vector<RigidMotion>
    omitted_rigid_motions() const override;
    dealii::Point<3>
    center() const override;
    /// Returns half the length, at least the section's reference length.
    double
    size() const override;
    dealii::BoundingBox<3>
    bounding_box() const override;

    /// Adds the section forces of @p u, integrated over the axis (AxisLoop).
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    /// Returns dense blocks per axis node, factorized for `automatic` on one
    /// process if all nodes carry dense lists (SectionSpace).
    std::unique_ptr<LinearSolver>
    solver_of(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested,
              const SolverMonitor  &monitor) const override;
    /// Returns energy and the largest rotation (SectionOperator's) at points.
    Deformation
    deformation(const Vector &u) const override;
    std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const override;

    void
    heat(const ScalarField &change) override;
    double
    add_thermal_load(Vector &f) const override;
    void
    add_weight(const dealii::Tensor<1, 3> &acceleration,
               Vector                     &f) const override;
    const std::vector<Ply> &
    plies() const override
    {
      return beam_section->plies();
    }

    /// Thermal load on the section's fields: integral D_s^T C epsilon_0 dA on
    /// values, integral D_y^T C epsilon_0 dA on derivatives along the axis.
    struct SectionThermalLoad
    {
      Vector on_values, on_derivatives;
    };
    SectionThermalLoad
    section_thermal_load(const double y) const;
    /// Returns the load by weight on the fields, integral of rho g . Phi dA.
    Vector
    section_weight(const dealii::Tensor<1, 3> &acceleration) const;

    /// Returns the locations within nearness(), along the axis and across.
    std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const override;
    std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const override;
    FieldSample
    sample(const Location &location, const Vector &u) const override;
    dealii::Point<3>
    position(const Location::Place &place) const override;
    PlyAndAxes
    ply_at(const Location::Place &place) const override;
    /// Returns cells with the degrees of axis elements and section functions.
    Cells
    cells() const override;
    /// Returns the degree of the axis elements (for EBBT, whose rotation is
    /// -w', one less), and across it that of LE-N, else zero.
    std::array<unsigned int, 3>
    recovery_degrees() const override;
    /// Returns across the axis the least LE degree of the element's nodes.
    std::array<unsigned int, 3>
    recovery_degrees_of(const unsigned int cell) const override;

    std::vector<std::string>
    surfaces() const override;
    /// Returns on a lateral surface a point per axis node and edge point of the
    /// section (CrossSectionElement::edge_points()), with the area int N_i dy
    /// times that point's length, and on an end the section's grid. LE-q nodes
    /// have the points of LE-q, as rows must not outnumber DoFs. `ends` and
    /// `all` repeat shared places.
    std::vector<SurfacePoint>
    surface_points(const std::string &surface) const override;
    /// Returns on an end as few points as it needs: three for EBBT and TBT.
    std::vector<Location>
    constraint_points(const std::string &surface) const override;
    std::vector<Location>
    body_points() const override;
    /// Returns facets of ends by section cells, then lateral ones by elements.
    std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const override;
    /// Returns the topology with node numbers (section node) * (axis nodes) +
    /// axis node; section cells share nodes at common vertices and lines.
    SurfaceTopology
    surface_topology(const std::string &surface) const override;
    SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const override;
    std::vector<double>
    line_breaks(const dealii::Point<3> &a,
                const dealii::Point<3> &b) const override;
    unsigned int
    line_degree(const dealii::Point<3> &a,
                const dealii::Point<3> &b) const override;

    std::vector<OutputCell>
    cut(const double       position,
        const unsigned int n,
        const Vector      &u) const override;
    /// Returns across the section min(trace degree, max(degree, 3)).
    GridIntervals
    output_degrees() const override;
    /// Calls @p use with cells numbered (own axis element) * (section cells) +
    /// section cell. Forms coefficients once per place on the axis, keeping all
    /// of this process, and functions once per section point.
    void
    for_each_output_cell(const GridIntervals      &n,
                         const Vector             &u,
                         const OutputCellCallback &use) const override;

    const Section &
    section() const
    {
      return *beam_section;
    }
    const Axis &
    axis() const
    {
      return *beam_axis;
    }
    std::shared_ptr<const Axis>
    shared_axis() const
    {
      return beam_axis;
    }
    const BeamDofMap &
    dofs() const
    {
      return dof_map;
    }

    const SectionSpace &
    fields() const
    {
      return *space;
    }

  protected:
    /// Calls @p use with single rows of K of own nodes, columns ascending.
    void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

    AxisLoop
    along_axis() const
    {
      return {*space, *beam_axis, dof_map};
    }

    /// Returns forces and energy per length at stations with coefficients @p q.
    virtual SectionForces
    section_forces(const SectionOperator &section_operator,
                   const FieldParts      &q) const;

    /// Returns fields of @p u at section point @p point, axis point @p on_axis.
    virtual FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const;

    /// Returns sample_at() for all @p points at each place of one element.
    virtual std::vector<FieldSample>
    samples_at(const std::vector<SectionPoint> &points,
               const std::vector<AxisPoint>    &places,
               const Vector                    &u) const;

    /// Returns the law of section cell @p cell at @p at, heated as at @p x.
    ElasticLaw
    law_at(const unsigned int      cell,
           const dealii::Point<2> &at,
           const dealii::Point<3> &x) const;

    /// Returns the work of C epsilon_0 of heat on the section's fields, and its
    /// energy epsilon_0 . C epsilon_0 / 2, for groups of stations y.
    std::vector<SectionForces>
    thermal_forces(const std::vector<std::vector<double>> &stations) const;

    /// Calls @p use for section points with the strain that opposes one kelvin,
    /// and its stress times the integration weight.
    void
    for_each_thermal_point(
      const std::function<void(const SectionPoint &point,
                               const Voigt        &strain,
                               const Voigt        &stress)> &use) const;

    double
    temperature_at(const SectionPoint &point, const double y) const
    {
      return temperature(
        placement.to_scene({point.position[0], y, point.position[1]}));
    }

  private:
    friend class BeamSecondOrder;
    friend class BeamGeometricStiffness;

    /// Returns 1e-6 of the smaller section extent, or 1e-10 of the length.
    double
    position_tolerance() const;

    /// Constrains w' and the rotation to cancel on every B4 element. The cubic
    /// w is then given by w and the rotation a at its ends (Hermite):
    ///   w = H_0 w_0 + H_2 w_1 - L/h (H_1 a_0 + H_3 a_1),   a = -h w',
    /// where u_y = a (z - z_c) / h, L is the element's length, h the section's
    /// reference length, and with t = (y - y_0) / L
    ///   H_0 = 1 - H_2,        H_2 = t^2 (3 - 2 t),
    ///   H_1 = t (1 - t)^2,    H_3 = -t^2 (1 - t).
    /// Ties w and a of bending in both planes at the two inner nodes exactly to
    /// those of the ends; deflections are smooth across elements.
    void
    constrain_to_kirchhoff();

    /// Displacements u_tau(y) of Eq. 1 by FieldPart, for all fields and modes:
    /// entry alpha * y.size() + j is field alpha at place j of one axis
    /// element.
    struct AxisStates
    {
      std::vector<double> y, value, shear_value, derivative;
    };

    /// Returns coefficients of @p u at the first node of @p cell, and
    /// differences of the others to it.
    std::vector<std::vector<double>>
    coefficients_of_element(const unsigned int cell, const Vector &u) const;

    /// Calls @p use for finite rotations, evaluating section points once.
    void
    for_each_rotated_cell(const GridIntervals      &n,
                          const Vector             &u,
                          const OutputCellCallback &use) const;

    /// Returns the states at @p etas in [0, 1] of axis element @p cell.
    AxisStates
    axis_states(const unsigned int         cell,
                const std::vector<double> &etas,
                const Vector              &u) const;

    /// Displacement and completed strain (Eq. 4) at a point, in body axes.
    struct PointState
    {
      dealii::Tensor<1, 3> displacement;
      Voigt                strain;
    };

    /// Returns the state at section point @p point, axis point @p on_axis.
    PointState
    point_state(const SectionPoint &point,
                const AxisPoint    &on_axis,
                const Vector       &u) const;

    /// Returns the thermal expansion alpha of the ply at @p point.
    Voigt
    expansion_at(const SectionPoint &point) const;

    /// Returns @p state in scene and ply axes, with the stress of the law.
    FieldSample
    field_sample(PointState              state,
                 const SectionPoint     &point,
                 const dealii::Point<3> &x) const;

    /// Returns thermal_forces() at integration points of Axis::own_cells().
    std::vector<SectionForces>
    thermal_forces() const;

    /// A section point with the data of samples for all places on the axis.
    struct GridPoint;

    /// Returns a grid of points on @p section_cell, xi fastest.
    std::vector<GridPoint>
    grid_points(const unsigned int section_cell,
                const unsigned int n_xi,
                const unsigned int n_eta) const;

    /// Returns field_sample() for @p point of a grid.
    FieldSample
    grid_sample(const GridPoint            &point,
                const dealii::Tensor<1, 3> &displacement,
                Voigt                       strain,
                const dealii::Point<3>     &x) const;

    /// Sets samples of @p cell at @p states; n_xi + 1 of @p points are a line.
    void
    sample_grid(const std::vector<GridPoint> &points,
                const unsigned int            n_xi,
                const AxisStates             &states,
                OutputCell                   &cell) const;

    OutputCell
    empty_output_cell(const unsigned int section_cell) const;

    /// Returns an output cell per section cell: (n + 1)^2 samples at @p eta.
    std::vector<OutputCell>
    cut_axis_cell(const unsigned int axis_cell,
                  const double       eta,
                  const unsigned int n,
                  const Vector      &u) const;

    /// Adds @p share of the rows at @p place to @p rows, one per component.
    void
    add_to_rows(const Location::Place         &place,
                const Quantity                 quantity,
                const StrainMap               &to_frame,
                const double                   share,
                std::vector<LinearFunctional> &rows) const;

    /// Returns the location at @p eta of @p axis_cell, @p unit of @p
    /// section_cell.
    Location
    location(const dealii::Point<3> &position,
             const unsigned int      axis_cell,
             const double            eta,
             const unsigned int      section_cell,
             const dealii::Point<2> &unit) const;

    /// Returns the surface point over @p edge at @p eta of @p axis_cell, its
    /// area edge weight times @p weight (both lengths).
    SurfacePoint
    lateral_point(const EdgePoint   &edge,
                  const double       weight,
                  const unsigned int axis_cell,
                  const double       eta) const;

    /// Returns the surface point of an end; depth is the axis element's length.
    SurfacePoint
    end_point(const EdgePoint &point, const bool at_start) const;

    /// Returns the LE degree of @p node, the section's for nodes with modes.
    unsigned int
    degree_at(const unsigned int node) const;

    /// Returns few of @p points whose values span those of the fields @p list.
    std::vector<EdgePoint>
    select_constraint_points(std::vector<EdgePoint>           points,
                             const std::vector<unsigned int> &list) const;

    /// Sets corners and degrees of @p facet from its cell and square.
    void
    complete(SurfaceFacet &facet) const;

    std::shared_ptr<const SectionSpace> space;
    std::shared_ptr<const Section>      beam_section;
    std::shared_ptr<const Axis>         beam_axis;
    BeamDofMap                          dof_map;
    /// Result of theory(); that of the section if empty.
    std::string label;
    /// Kirchhoff's constraints, closed; empty except for EBBT.
    Constraints kirchhoff;
  };

  /// Returns the beams among @p bodies by number, null for other bodies.
  std::vector<const Beam *>
  beams_of(const Bodies &bodies);
} // namespace lamella

#endif
