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
   * (and, where transverse shear strains are assumed, (A_shear - A_NN) (x)
   * S_shear). EBBT is TBT with Kirchhoff's constraint on each element.
   *
   * Here i numbers the nodes of the axis, N_i are their shape functions (class
   * Axis), alpha numbers the fields Phi_alpha of the section, vector functions
   * made of the paper's F_tau (class Section), and d stands for the derivative
   * along y. The strain is
   *   epsilon = sum (N_i D_s Phi_alpha + N_i' D_y Phi_alpha) u_(i,alpha),
   * D = D_s + D_y d/dy being the operator of Eq. 5. That is why its energy
   * splits into four products of an integral over the axis, A_pq, and one over
   * the section, S_pq, p and q telling which side is differentiated along y.
   * The 3 x 3 blocks of K are the paper's fundamental nuclei k^(ij tau s), but
   * for the linear fields, of which some combine two functions. No integral is
   * ever taken over the volume to assemble K; a row of it is a row of A_pq
   * times a row of S_pq.
   *
   * The beam shares its section and its axis with whoever else has them (beams
   * of one mesh and theory have one section) and keeps both alive. Its own are
   * the placement, the DoF map and the constraints.
   *
   * In several processes the rows of K go with the nodes of the axis
   * (Axis::own_nodes), integrals over the volume with its elements
   * (Axis::own_cells).
   *
   * An element of the beam, a "cell" in Location, is the product of an axis
   * element and a section cell, numbered
   * axis element * (number of section cells) + section cell; its unit
   * coordinates are (xi, place along the axis element, eta).
   */
  class Beam : public Body
  {
  public:
    /// Every axis node carries all fields of the section. Throws InputError as
    /// the other one.
    Beam(const std::string             &name,
         std::shared_ptr<const Section> section,
         std::shared_ptr<const Axis>    axis,
         const Placement               &placement);

    /**
     * Node-dependent kinematics: @p fields_of_node as in BeamDofMap, one list
     * for each node of the axis. A field that a node does not carry is zero
     * there. For EBBT, which needs B4, every node has to carry all fields.
     * Throws InputError if there are more processes than nodes on the axis,
     * since each has to own one.
     */
    Beam(const std::string                            &name,
         std::shared_ptr<const Section>                section,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node);

    /// The same with the fields of @p space, modes among them; @p theory is
    /// what theory() calls it.
    Beam(const std::string                            &name,
         std::shared_ptr<const FieldSpace>             space,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node,
         const std::string                            &theory);

    /// Says as well how many polynomials of TE-N a section has left out because
    /// they depend on the others there.
    std::string
    theory() const override;
    /// The sum over the nodes of the fields each carries: (nodes of the axis)
    /// times (fields of the section) if they carry all.
    DofIndex
    n_dofs() const override
    {
      return dof_map.n_dofs();
    }

    /// Of the nodes of the element @p cell of its axis.
    unsigned int
    n_dofs_of_cell(const unsigned int cell) const
    {
      unsigned int sum = 0;
      for (const unsigned int node : axis().nodes_of_cell(cell))
        sum += dof_map.fields(node).size();
      return sum;
    }
    /// Exact where all nodes carry all fields: the non-zeros of A times those
    /// of S. Communicates nothing.
    double
    stiffness_entries() const override;
    /// The DoFs of Axis::own_nodes().
    dealii::IndexSet
    owned_dofs() const override;
    /// That of the DoF's field (SectionField::level).
    unsigned int
    dof_level(const DofIndex dof) const override;
    /// Those of the fields (FieldSpace::sizes()).
    std::vector<double>
    dof_sizes() const override;
    /// On the axis through the section's centre of area, at the DoF's node.
    dealii::Point<3>
    dof_position(const DofIndex dof) const override;
    /// Kirchhoff's of EBBT; empty for all other theories.
    const Constraints &
    kinematic_constraints() const override
    {
      return kirchhoff;
    }
    /**
     * With the rigid motions of a section among its fields these are a few
     * entries a node. With v the direction in the body's axes, h the section's
     * reference length and y_m the middle of the axis a turn is
     *   u_x = -v_z (y - y_m),  u_z = v_x (y - y_m)        (translations),
     *   h v_z, -h v_x                                     (slopes of u_y),
     *   h v_y                                             (turn about the axis)
     * in the fields of RigidField, as the linear functions are x / h and z / h.
     */
    std::vector<Vector>
    rigid_motions() const override;
    /// The turn about the axis for EBBT and TBT, nothing else.
    std::vector<RigidMotion>
    missing_motions() const override;
    dealii::Point<3>
    centre() const override;
    /// Half the length, or the section's reference length if that is more.
    double
    size() const override;
    dealii::BoundingBox<3>
    bounding_box() const override;

    /// What the section answers to @p u all along the axis (AxisLoop).
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    /// `automatic` on one process is a factorisation by dense blocks, one for
    /// each node of the axis, if all of them carry
    /// dense lists (FieldSpace).
    std::unique_ptr<LinearSolver>
    solver_of(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      asked,
              const SolverMonitor  &monitor) const override;
    /// The energy likewise. Rotations are looked at in the section's points
    /// (SectionAnswer::largest_rotation()).
    Deformation
    deformation(const Vector &u) const override;
    std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const override;

    void
    heat(const ScalarField &change) override;
    double
    add_heat(Vector &f) const override;
    void
    add_weight(const dealii::Tensor<1, 3> &acceleration,
               Vector                     &f) const override;
    const std::vector<Ply> &
    plies() const override
    {
      return beam_section->plies();
    }

    /// What heat loads the section at @p y of the axis with, in the fields of
    /// the section: integral D_s^T C epsilon_0 dA on their values and integral
    /// D_y^T C epsilon_0 dA on their derivatives along the axis.
    struct SectionHeat
    {
      Vector on_values, on_derivatives;
    };
    SectionHeat
    section_heat(const double y) const;
    /// What weight does: integral of rho g . Phi dA.
    Vector
    section_weight(const dealii::Tensor<1, 3> &acceleration) const;

    /// Within 1e-6 of the section's smaller extent (nearness()), along the axis
    /// and across. The axis is searched element by element, the section by a
    /// tree of boxes.
    std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const override;
    std::vector<std::vector<Row>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const override;
    FieldSample
    sample(const Location &location, const Vector &u) const override;
    dealii::Point<3>
    position(const Location::Place &place) const override;
    PlyAt
    ply_at(const Location::Place &place) const override;
    /// Along the axis the degree of its elements, across it that of the
    /// section's functions within a cell.
    Cells
    cells() const override;
    /// Along the axis the degree of its elements, one less for EBBT, whose
    /// rotation is -w'; across it that of LE-N, or zero.
    std::array<unsigned int, 3>
    recovery_degrees() const override;
    /// Across it the least degree of LE that a node of the axis element has.
    std::array<unsigned int, 3>
    recovery_degrees_of(const unsigned int cell) const override;

    std::vector<std::string>
    surfaces() const override;
    /**
     * On a lateral surface a point for each node of the axis and each edge
     * point of the section (CrossSectionElement::edge_points), with the area
     * int N_i dy times the edge point's length. On an end the section's grid.
     * Nodes that carry LE-q in a space of a higher degree have the points of
     * LE-q: rows there must not outnumber what the node can deform.
     * `ends` and `all` are these one after the other: places that two of them
     * share come twice, each with its own normal.
     */
    std::vector<SurfacePoint>
    surface_points(const std::string &surface) const override;
    /// Those of an end are as few as its expansion needs: three for EBBT and
    /// TBT, however many cells the section has.
    std::vector<Location>
    fixing_points(const std::string &surface) const override;
    std::vector<Location>
    body_points() const override;
    /// Ends first, a facet for each cell of the section, then the lateral ones,
    /// a facet for each side of a cell on the boundary and each axis element.
    std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const override;
    /// Numbers a node (node of the section) times (nodes of the axis) plus
    /// (node of the axis); cells that share a vertex or a line of the section
    /// mesh share the nodes there.
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

    /// An element of the section each, in the order of its cells.
    std::vector<OutputCell>
    cut(const double       position,
        const unsigned int n,
        const Vector      &u) const override;
    /// Across the section at most 3 of a shape that is of a higher degree than
    /// the expansion.
    GridIntervals
    picture_degrees() const override;
    /**
     * A product, too: the fields' coefficients are formed once at each place
     * along the axis, the functions of the section once at each of its points
     * (of sections that turn, samples_at() what these are).
     * Numbers are (own element of the axis) times (cells of the section) plus
     * (cell of the section). Memory: the coefficients of all places of this
     * process.
     */
    void
    for_each_output_cell(const GridIntervals   &n,
                         const Vector          &u,
                         const UseOfOutputCell &use) const override;

    /// The factors, which live as long as the beam.
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

    /// The section's fields and its modes, which dofs() numbers.
    const FieldSpace &
    fields() const
    {
      return *space;
    }

  protected:
    /// A block is one row of K, its columns ascending: no more of K than that
    /// is in memory, besides the factors. Own nodes only.
    void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

    /// What integrates over the axis. Refers to the beam.
    AxisLoop
    along_axis() const
    {
      return {*space, *beam_axis, dof_map};
    }

    /// The internal forces and the energy at stations with the coefficients
    /// @p q of the fields of @p answer: what it answers.
    virtual SectionForces
    section_forces(const SectionAnswer &answer, const FieldParts &q) const;

    /// The fields of @p u at @p point of the section, at @p on_axis.
    virtual FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const;

    /// sample_at() @p points of the section at @p places along one element of
    /// the axis: all points of a place one after the other.
    virtual std::vector<FieldSample>
    samples_at(const std::vector<SectionPoint> &points,
               const std::vector<AxisPoint>    &places,
               const Vector                    &u) const;

    /// The law of the section cell @p cell at the section's point @p at, with
    /// the initial strain of heat at @p x, which is that point in the scene.
    ElasticLaw
    law_at(const unsigned int      cell,
           const dealii::Point<2> &at,
           const dealii::Point<3> &x) const;

    /// What the stress C epsilon_0 of heat does in each of some groups of
    /// stations of the axis, each given by y, on the fields of the section,
    /// with its energy epsilon_0 . C epsilon_0 / 2. The section's points are
    /// looked at once.
    std::vector<SectionForces>
    forces_of_heat(const std::vector<std::vector<double>> &stations) const;

    /// Calls @p use with each point of the section and, of one kelvin there,
    /// the strain that is resisted and its stress times what the point stands
    /// for in integrals.
    void
    for_each_point_of_heat(
      const std::function<void(const SectionPoint &point,
                               const Voigt        &strain,
                               const Voigt        &stress)> &use) const;

    /// The change of temperature at @p point of the section at @p y.
    double
    temperature_at(const SectionPoint &point, const double y) const
    {
      return temperature(
        placement.to_scene({point.position[0], y, point.position[1]}));
    }

  private:
    friend class BeamSecondOrder;
    friend class BeamGeometricStiffness;

    /// 1e-6 of the section's smaller extent [length]: what is nearer than that
    /// to a line of the mesh lies on it. Positions come out of decimal texts
    /// and rotations, often with ten digits of a long body.
    double
    nearness() const;

    /**
     * Makes w' and the rotation cancel on every element. With B4 the cubic w of
     * an element is then fixed by w and the rotation at its two ends (Hermite's
     * polynomials), and so are both at the two nodes inside:
     *   w = H_0 w_0 + H_2 w_1 - L/h (H_1 a_0 + H_3 a_1),   a = -h w',
     * where u_y = a (z - z_c) / h, L is the element's length, h the section's
     * reference length, and with t = (y - y_0) / L
     *   H_0 = 1 - H_2,        H_2 = t^2 (3 - 2 t),
     *   H_1 = t (1 - t)^2,    H_3 = -t^2 (1 - t).
     * Ties four DoFs of an inner node, w and a of bending in both planes, to
     * those of the ends: the constraint is exact, no penalty is involved, and
     * deflections are smooth from element to element.
     */
    void
    constrain_to_kirchhoff();

    /// The generalised displacements u_tau(y) of Eq. 1, a number of each
    /// FieldPart for all fields of the section, modes added to these, at
    /// several places of one axis element: entry alpha * y.size() + j is that
    /// of the field alpha at place j.
    struct AxisStates
    {
      std::vector<double> y, value, shear_value, derivative;
    };

    /// In the fields of the section, modes added to these, the coefficients of
    /// @p u at the first node of the axis element @p cell, and of each further
    /// node the differences to them.
    std::vector<std::vector<double>>
    coefficients_of_element(const unsigned int cell, const Vector &u) const;

    /// for_each_output_cell() of what turns: the points of the section are
    /// evaluated once, and sampled element by element of the axis.
    void
    for_each_turned_cell(const GridIntervals   &n,
                         const Vector          &u,
                         const UseOfOutputCell &use) const;

    /// Those at the places @p etas in [0, 1] of the axis element @p cell.
    AxisStates
    axis_states(const unsigned int         cell,
                const std::vector<double> &etas,
                const Vector              &u) const;

    /// Kinematics at a point, in the body's axes: the displacement and the
    /// strain (as the theory completes it, order of Eq. 4).
    struct PointState
    {
      dealii::Tensor<1, 3> displacement;
      Voigt                strain;
    };

    /// The sums over the fields that do not vanish at @p point of the section,
    /// at @p on_axis, of the displacement @p u.
    PointState
    point_state(const SectionPoint &point,
                const AxisPoint    &on_axis,
                const Vector       &u) const;

    /// alpha of the ply of @p point there.
    Voigt
    expansion_at(const SectionPoint &point) const;

    /// The body frame's fields in scene and ply axes, with the stress that the
    /// law at the section's point @p point makes of the strain at @p x (scene
    /// axes).
    FieldSample
    field_sample(PointState              state,
                 const SectionPoint     &point,
                 const dealii::Point<3> &x) const;

    /// forces_of_heat() at the integration points of each of
    /// Axis::own_cells().
    std::vector<SectionForces>
    forces_of_heat() const;

    /// A point of the section with what samples need of it, for all places
    /// along the axis.
    struct GridPoint;

    /// The points of a regular grid on @p section_cell, @p n_xi by @p n_eta
    /// intervals, xi fastest.
    std::vector<GridPoint>
    grid_points(const unsigned int section_cell,
                const unsigned int n_xi,
                const unsigned int n_eta) const;

    /// As field_sample(), at @p x (scene axes).
    FieldSample
    grid_sample(const GridPoint            &point,
                const dealii::Tensor<1, 3> &displacement,
                Voigt                       strain,
                const dealii::Point<3>     &x) const;

    /// Fills in the samples of @p cell, n_xi + 1 of @p points in a line, at all
    /// places of @p states.
    void
    sample_grid(const std::vector<GridPoint> &points,
                const unsigned int            n_xi,
                const AxisStates             &states,
                OutputCell                   &cell) const;

    /// An element over @p section_cell without its samples.
    OutputCell
    empty_output_cell(const unsigned int section_cell) const;

    /// The elements of one axis element, a section cell each, with grids of
    /// (n + 1) x (n + 1) samples at the place @p eta in [0, 1] along it.
    std::vector<OutputCell>
    cut_axis_cell(const unsigned int axis_cell,
                  const double       eta,
                  const unsigned int n,
                  const Vector      &u) const;

    /// Adds to the rows @p rows of a quantity, one a component, the @p share
    /// of what is at @p place.
    void
    add_to_rows(const Location::Place &place,
                const Quantity         quantity,
                const FromStrain      &to_frame,
                const double           share,
                std::vector<Row>      &rows) const;

    /// The location with the one place @p eta of @p axis_cell, @p unit of
    /// @p section_cell; @p position (scene axes) is that of it.
    Location
    location(const dealii::Point<3> &position,
             const unsigned int      axis_cell,
             const double            eta,
             const unsigned int      section_cell,
             const dealii::Point<2> &unit) const;

    /// The surface point over @p edge of the section at the place @p eta of
    /// @p axis_cell, its area the weight of the edge (a length) times @p weight
    /// (a length along the axis).
    SurfacePoint
    lateral_point(const EdgePoint   &edge,
                  const double       weight,
                  const unsigned int axis_cell,
                  const double       eta) const;

    /// The surface point at @p point of the section on one of the ends, its
    /// area the point's weight, its depth the length of the axis element there.
    SurfacePoint
    end_point(const EdgePoint &point, const bool at_start) const;

    /// The degree of LE that @p node of the axis carries
    /// (Section::field_degree()); that of the section for nodes with modes.
    unsigned int
    degree_at(const unsigned int node) const;

    /// Of the points @p points of the section, which fix all its fields, as few
    /// as a node with the fields @p list takes: for each component of the
    /// displacement those whose values span the others'.
    std::vector<EdgePoint>
    fixing(std::vector<EdgePoint>           points,
           const std::vector<unsigned int> &list) const;

    /// Fills in the corners and degrees of @p facet, whose cell and square are
    /// set. Along the axis the degrees are those of its elements, in the
    /// section those of the expansion and of its trace.
    void
    complete(SurfaceFacet &facet) const;

    std::shared_ptr<const FieldSpace> space;
    std::shared_ptr<const Section>    beam_section;
    std::shared_ptr<const Axis>       beam_axis;
    BeamDofMap                        dof_map;
    /// theory(); empty: that of the section.
    std::string label;
    /// Closed; without lines but for EBBT.
    Constraints kirchhoff;
  };

  /// The beams among @p bodies, by the numbers of these; null for all others.
  /// Whoever needs beams, as they choose fields or axes, is given these; nobody
  /// else asks what a body is.
  std::vector<const Beam *>
  beams_of(const Bodies &bodies);
} // namespace lamella

#endif
