// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_h
#define lamella_body_beam_h

#include <lamella/body/axis_loop.h>
#include <lamella/body/body.h>
#include <lamella/body/fields.h>

namespace lamella
{
  /// A beam in the Carrera Unified Formulation, with section functions
  /// Phi_alpha (Section) and axial shape functions N_i of axis nodes i (Axis):
  ///   u(x, y, z) = sum N_i(y) Phi_alpha(x, z) u_(i,alpha),
  /// Eqs. 1 and 7 of Nagaraj et al. 2020. With the derivatives D_s by x and z,
  /// and D_y by y, the strain is
  ///   epsilon = sum (N_i D_s Phi_alpha + N_i' D_y Phi_alpha) u_(i,alpha).
  /// The stiffness matrix is a sum of Kronecker products (x) of the axis
  /// matrices A (see Axis) and the section matrices S_pq (see Section),
  ///   K = A_NN (x) S_00 + A_NdN (x) S_01 + A_dNN (x) S_10 + A_dNdN (x) S_11
  /// (and, for assumed transverse shear strains, (A_shear - A_NN) (x) S_shear).
  /// Its 3 x 3 blocks are the fundamental nuclei of Carrera. EBBT
  /// (Euler-Bernoulli) is TBT (Timoshenko) with Kirchhoff's constraint.
  ///
  /// Each process owns the rows of K of its axis nodes, and integrates over its
  /// axis elements. Elements of the body are numbered axis element * (number of
  /// section cells) + section cell, with unit coordinates (xi, along the axis
  /// element, eta).
  class Beam : public Body
  {
  public:
    /// Constructs a beam with all section functions at all axis nodes. Throws
    /// InputError if there are more processes than axis nodes.
    Beam(const std::string                    &name,
         const std::shared_ptr<const Section> &section,
         const std::shared_ptr<const Axis>    &axis,
         const Placement                      &placement);

    /// Constructs a beam with node-dependent kinematics: @p fields_of_node
    /// lists the section functions of each axis node. EBBT requires B4 and all
    /// functions. Throws InputError if processes outnumber axis nodes.
    Beam(const std::string                            &name,
         std::shared_ptr<const Section>                section,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node);

    /// Constructs a beam with node-dependent kinematics and with the modes of
    /// @p section_space, linear combinations of section functions. theory()
    /// begins with the text @p theory.
    Beam(const std::string                            &name,
         std::shared_ptr<const SectionSpace>           section_space,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node,
         const std::string                            &theory);

    /// Returns theory and axis elements, such as `LE-2, 20 B4`. For TE-N also
    /// states the number of dropped polynomials (TaylorElement), if any.
    std::string
    theory() const override;
    /// Returns the number of section functions, summed over all axis nodes.
    DofIndex
    n_dofs() const override
    {
      return dof_map.n_dofs();
    }

    /// Returns the number of DoFs of all nodes of the axis element @p cell.
    unsigned int
    n_dofs_of_cell(const unsigned int cell) const
    {
      unsigned int sum = 0;
      for (const unsigned int node : axis().nodes_of_cell(cell))
        sum += dof_map.fields(node).size();
      return sum;
    }
    /// Returns the number of stiffness nonzeros: those of an axis matrix times
    /// those of a section matrix. It is exact if all nodes have all functions.
    double
    stiffness_entries() const override;
    dealii::IndexSet
    owned_dofs() const override;
    DofInfo
    dof(const DofIndex dof) const override;
    const Constraints &
    kinematic_constraints() const override
    {
      return kirchhoff;
    }
    /// Returns the rigid motions. With the rotation axis v in body axes, the
    /// reference length h of the section and the middle y_m of the axis, a
    /// rotation has these nodal values (in the order of RigidField):
    ///   u_x = -v_z (y - y_m),  u_z = v_x (y - y_m)        (translations),
    ///   h v_z, -h v_x                                     (slopes of u_y),
    ///   h v_y                                             (rotation about y).
    std::vector<Vector>
    rigid_motions(const Vector &u) const override;
    std::vector<RigidMotion>
    omitted_rigid_motions() const override;
    dealii::Point<3>
    center() const override;
    /// Returns half the length or the section's reference length, if larger.
    double
    size() const override;
    dealii::BoundingBox<3>
    bounding_box() const override;

    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    /// Calls @p use with each stiffness row that this process owns.
    void
    for_each_stiffness_block(const Vector        &u,
                             const Vector        &correction,
                             const bool           with_values,
                             const BlockCallback &use) const override;
    /// Calls @p use with each row of the Kronecker product of int N_i N_j dy
    /// and int rho Phi_alpha . Phi_beta dA that this process owns.
    void
    for_each_mass_block(const Vector        &u,
                        const bool           with_values,
                        const BlockCallback &use) const override;
    /// Returns the strain energy, and the largest rotation of all points.
    Deformation
    deformation(const Vector &u) const override;
    std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const override;

    void
    heat(const ScalarField &change) override;
    double
    add_thermal_load(const Vector &u, Vector &f) const override;
    const std::vector<Ply> &
    plies() const override
    {
      return beam_section->plies();
    }

    /// Thermal load per length on section functions, from thermal strain
    /// epsilon_0, stiffness C, and derivatives D_s by x and z, D_y by y.
    struct SectionThermalLoad
    {
      Vector on_values;      ///< On amplitudes, int D_s^T C epsilon_0 dA.
      Vector on_derivatives; ///< On d/dy of these, int D_y^T C epsilon_0 dA.
    };
    /// Returns the thermal load per length at @p y; zero without heat.
    SectionThermalLoad
    section_thermal_load(const double y) const;
    /// Returns the weight per length on each section function Phi, int rho g .
    /// Phi dA, for @p acceleration g in scene axes.
    Vector
    section_weight(const dealii::Tensor<1, 3> &acceleration) const;
    /// Returns for each rigid section function R (RigidField) the inertial
    /// force per length and unit acceleration on each section function Phi, int
    /// rho R . Phi dA.
    std::vector<Vector>
    section_inertia() const;

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
    cells() const override;
    /// Returns Cells::recovery_degrees: the degree of displacements along the
    /// axis (for EBBT one less, as the rotation is -w'); in the section N for
    /// LE-N, else zero. In the section it is at most the lowest degree of LE of
    /// the nodes of the axis element that contains element @p cell.
    GridIntervals
    recovery_degrees_of(const unsigned int cell) const override;

    std::vector<std::string>
    surfaces() const override;
    /// Returns for a lateral surface one point per axis node i and edge point
    /// of the section (CrossSectionElement::edge_points()), with the area int
    /// N_i dy times the edge point's tributary length; for an end the section
    /// points. Nodes with LE-q have the points of LE-q only, so that
    /// constraints do not outnumber DoFs.
    std::vector<SurfacePoint>
    surface_points(const std::string &surface) const override;
    /// Returns for an end the smallest set of points that determines its
    /// displacement, e.g. three for EBBT and TBT.
    std::vector<Location>
    constraint_points(const std::string &surface) const override;
    std::vector<Location>
    body_points() const override;
    /// Returns the facets of @p surface with node numbers (section node) *
    /// (number of axis nodes) + axis node. Adjacent section cells share nodes.
    SurfaceTopology
    surface_topology(const std::string &surface) const override;
    SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const override;
    std::vector<double>
    line_breaks(const dealii::Point<3> &from,
                const dealii::Point<3> &to) const override;
    unsigned int
    line_degree(const dealii::Point<3> &from,
                const dealii::Point<3> &to) const override;

    std::vector<OutputCell>
    cut(const double       position,
        const unsigned int n,
        const Vector      &u) const override;
    /// Calls @p use with each output element, numbered (index among this
    /// process's axis elements) * (number of section cells) + section cell.
    /// Section functions are computed once per section point.
    void
    for_each_output_cell(const GridIntervals      &n,
                         const Vector             &u,
                         const OutputCellCallback &use) const override;

    /// Returns the section, with section functions, stiffness and plies.
    const Section &
    section() const
    {
      return *beam_section;
    }
    /// Returns the finite element mesh of the axis, with shape functions N_i.
    const Axis &
    axis() const
    {
      return *beam_axis;
    }
    /// Returns the axis with shared ownership, for another beam on this axis.
    std::shared_ptr<const Axis>
    shared_axis() const
    {
      return beam_axis;
    }
    /// Returns the numbering of the DoFs by axis node and section function.
    const BeamDofMap &
    dofs() const
    {
      return dof_map;
    }

    /// Returns the space of all section functions and modes of the axis nodes.
    const SectionSpace &
    fields() const
    {
      return *space;
    }

  protected:
    /// Calls @p use with the cells of for_each_output_cell(), whose samples are
    /// those of samples_at(), for beams whose displacements are not products.
    void
    for_each_sampled_cell(const GridIntervals      &n,
                          const Vector             &u,
                          const OutputCellCallback &use) const;

    /// Returns the integration of nodal forces along the axis of this beam.
    AxisLoop
    along_axis() const
    {
      return {*space, *beam_axis, dof_map};
    }

    /// Returns section forces and energy per length at points of the axis, for
    /// amplitudes and derivatives @p q of the section functions.
    virtual SectionForces
    section_forces(const SectionOperator &section_operator,
                   const FieldParts      &q) const;

    /// Returns displacement, strain and stress of @p u at the section point @p
    /// point and the axis point @p on_axis.
    virtual FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const;

    /// Returns sample_at() at all section @p points at each of @p places.
    virtual std::vector<FieldSample>
    samples_at(const std::vector<SectionPoint> &points,
               const std::vector<AxisPoint>    &places,
               const Vector                    &u) const;

    /// Returns the elastic law of section cell number @p cell at its point @p
    /// at, with the thermal strain at the position @p x (scene axes).
    ElasticLaw
    law_at(const unsigned int      cell,
           const dealii::Point<2> &at,
           const dealii::Point<3> &x) const;

    /// Returns section forces of the thermal stress C epsilon_0, and its energy
    /// epsilon_0 . C epsilon_0 / 2 per length, for lists of axial positions y.
    std::vector<SectionForces>
    thermal_forces(const std::vector<std::vector<double>> &stations) const;

    /// Calls @p use for all integration points of the section with minus the
    /// thermal strain per kelvin, and its stress times the integration weight.
    void
    for_each_thermal_point(
      const std::function<void(const SectionPoint &point,
                               const Voigt        &strain,
                               const Voigt        &stress)> &use) const;

    /// Returns the temperature change at section point @p point and at @p y.
    double
    temperature_at(const SectionPoint &point, const double y) const
    {
      return temperature(
        placement.to_scene({point.position[0], y, point.position[1]}));
    }

  private:
    /// Calls @p use with the rows that this process owns of the sum of the
    /// Kronecker products of axis matrices and @p on_section.
    void
    for_each_product_row(const std::vector<FactorRow> &on_section,
                         const bool                    with_values,
                         const BlockCallback          &use) const;

    friend class BeamSecondOrder;
    friend class BeamGeometricStiffness;

    /// Returns the tolerance for positions: 1e-6 of the smaller section extent,
    /// or 1e-10 of the length if larger.
    double
    position_tolerance() const;

    /// Applies Kirchhoff's constraint to the inner nodes of every B4 element,
    /// in both planes of bending: section rotation a = -h w', with u_y = a (z -
    /// z_c) / h and the section's reference length h. The cubic deflection w
    /// follows from w and a at the ends 0 and 1 of an element of length L
    /// (Hermite):
    ///   w = H_0 w_0 + H_2 w_1 - L/h (H_1 a_0 + H_3 a_1),
    ///   H_0 = 1 - H_2,        H_2 = t^2 (3 - 2 t),     t = (y - y_0) / L,
    ///   H_1 = t (1 - t)^2,    H_3 = -t^2 (1 - t).
    void
    constrain_to_kirchhoff();

    /// Amplitudes of section functions and their derivatives at positions y of
    /// one axis element: entry alpha * y.size() + j is function alpha at y[j].
    struct AxisStates
    {
      std::vector<double> y, value, shear_value, derivative;
    };

    /// Returns the nodal values of @p u at the first node of axis element @p
    /// cell, and for its other nodes the differences to the first node.
    std::vector<std::vector<double>>
    coefficients_of_element(const unsigned int cell, const Vector &u) const;

    /// Returns the amplitudes at @p etas in [0, 1] of axis element @p cell.
    AxisStates
    axis_states(const unsigned int         cell,
                const std::vector<double> &etas,
                const Vector              &u) const;

    /// Displacement and strain (see StrainCompletion) at a point, in body axes.
    struct PointState
    {
      dealii::Tensor<1, 3> displacement;
      Voigt                strain;
    };

    /// Returns displacement and strain at @p point, at axis point @p on_axis.
    PointState
    point_state(const SectionPoint &point,
                const AxisPoint    &on_axis,
                const Vector       &u) const;

    /// Returns thermal_forces() at the integration points of this process.
    std::vector<SectionForces>
    thermal_forces() const;

    /// A section point with the output data that do not depend on y.
    struct GridPoint;

    /// Returns a regular grid of points on @p section_cell; xi varies fastest.
    std::vector<GridPoint>
    grid_points(const unsigned int section_cell,
                const unsigned int n_xi,
                const unsigned int n_eta) const;

    /// Returns a FieldSample at @p point with @p displacement and @p strain.
    FieldSample
    grid_sample(const GridPoint            &point,
                const dealii::Tensor<1, 3> &displacement,
                Voigt                       strain,
                const dealii::Point<3>     &x) const;

    /// Sets the samples of @p cell for the amplitudes @p states at the section
    /// points @p points, a grid with @p n_xi + 1 points along xi.
    void
    sample_grid(const std::vector<GridPoint> &points,
                const unsigned int            n_xi,
                const AxisStates             &states,
                OutputCell                   &cell) const;

    OutputCell
    empty_output_cell(const unsigned int section_cell) const;

    /// Returns an output element for each section cell, with (n + 1)^2 samples,
    /// at @p eta in [0, 1] of the axis element @p axis_cell.
    std::vector<OutputCell>
    cut_axis_cell(const unsigned int axis_cell,
                  const double       eta,
                  const unsigned int n,
                  const Vector      &u) const;

    /// Adds @p share times the functional of each component of @p quantity at
    /// @p place to @p rows.
    void
    add_to_rows(const Location::Place         &place,
                const Quantity                 quantity,
                const StrainMap               &to_frame,
                const double                   share,
                std::vector<LinearFunctional> &rows) const;

    /// Returns the location at @p eta in [0, 1] and @p unit in a section cell.
    Location
    location(const dealii::Point<3> &position,
             const unsigned int      axis_cell,
             const double            eta,
             const unsigned int      section_cell,
             const dealii::Point<2> &unit) const;

    /// Returns the surface point at @p edge of the section and @p eta in @p
    /// axis_cell. Its area is the edge point's weight times @p weight.
    SurfacePoint
    lateral_point(const EdgePoint   &edge,
                  const double       weight,
                  const unsigned int axis_cell,
                  const double       eta) const;

    /// Returns a surface point of an end; its depth is the axis element length.
    SurfacePoint
    end_point(const EdgePoint &edge_point, const bool at_start) const;

    /// Returns the LE degree of axis node @p node; with modes, the section's.
    unsigned int
    degree_at(const unsigned int node) const;

    /// Returns a minimal set of @p points whose displacements determine all
    /// amplitudes of the section functions @p list.
    std::vector<EdgePoint>
    select_constraint_points(std::vector<EdgePoint>           points,
                             const std::vector<unsigned int> &list) const;

    /// Returns the facets of surface_topology() for @p surface: facets of the
    /// ends, one per section cell, followed by facets of lateral surfaces.
    std::vector<SurfaceFacet>
    facets_of(const std::string &surface) const;

    /// Sets corners and degrees of @p facet from its section cell and its axes.
    void
    complete(SurfaceFacet &facet) const;

    std::shared_ptr<const SectionSpace> space;
    std::shared_ptr<const Section>      beam_section;
    std::shared_ptr<const Axis>         beam_axis;
    BeamDofMap                          dof_map;
    /// Text of theory(); if empty, theory() is that of the section.
    std::string label;
    /// Kirchhoff's constraints; empty except for EBBT.
    Constraints kirchhoff;
  };

  /// A beam whose internal forces and fields are nonlinear in its DoFs.
  class FiniteRotationBeam : public Beam
  {
  public:
    using Beam::Beam;

    bool
    has_finite_rotations() const override
    {
      return true;
    }
    std::vector<OutputCell>
    cut(const double       position,
        const unsigned int n,
        const Vector      &u) const override
    {
      return Body::cut(position, n, u);
    }
    void
    for_each_output_cell(const GridIntervals      &n,
                         const Vector             &u,
                         const OutputCellCallback &use) const override
    {
      for_each_sampled_cell(n, u, use);
    }
  };

  /// Returns a pointer to each of @p bodies that is a beam, null for others.
  std::vector<const Beam *>
  beams_of(const Bodies &bodies);
} // namespace lamella

#endif
