// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `body`: the interface Body and its implementations, beam (section
// functions times axial shape functions) and solid (hexahedra). Bodies do not
// depend on supports or contacts.
//
// Start with Body, Location and LinearFunctional (base/linear_functional.h).
// Body::locate() finds the elements that contain a point, and Body::rows()
// returns the displacement of the point as linear functionals of the DoFs
// (rows), from which point forces, supports and gaps are formed.

#ifndef lamella_body_body_h
#define lamella_body_body_h

#include <lamella/base/linear_functional.h>
#include <lamella/body/placement.h>
#include <lamella/linear/stiffness_matrix.h>
#include <lamella/material/elasticity.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  class NotPositiveDefinite;
  class SecondOrder;

  /// A field that can be evaluated at a point: displacement u, strain epsilon,
  /// or stress sigma = C (epsilon - epsilon_0) with the initial strain
  /// epsilon_0 (Eqs. 5 and 6 of Nagaraj et al. 2020).
  enum class Quantity
  {
    displacement, ///< three components x, y, z in scene axes
    strain,       ///< xx, yy, zz and engineering shears xy, xz, yz
    stress        ///< xx, yy, zz, xy, xz, yz
  };

  /// Axes of strain and stress components.
  enum class Frame
  {
    scene, ///< global axes x, y, z of the scene, not those of the body
    ply ///< 1 along the fiber, 2 across, 3 normal to the ply: 11,22,33,12,13,23
  };

  /// A point of a body in one of its plies, with the elements of this ply that
  /// contain the point. Fields at the point are means over these elements. A
  /// point on the interface of two plies has two locations, one per ply
  /// (Body::locate()), since in-plane stresses are discontinuous.
  struct Location
  {
    /// A point of one element, given by unit coordinates.
    struct Place
    {
      /// Index of the element: axis element * (number of section cells) +
      /// section cell (Beam), or index of the hexahedron (Solid).
      unsigned int cell;
      /// Unit coordinates (xi, along the axis, eta) in [0, 1]^3.
      dealii::Point<3> unit;
    };
    /// Position of the undeformed point, scene axes.
    dealii::Point<3> position;
    /// Index of the ply in Body::plies().
    unsigned int ply = 0;
    /// The elements that contain the point, at least one, and unit coordinates.
    std::vector<Place> places;
  };

  /// Displacement, strain and stress at a location: means over the elements
  /// that contain it, without stress recovery (recover/recovery.h).
  struct FieldSample
  {
    /// Displacement in scene axes [length].
    dealii::Tensor<1, 3> displacement;
    /// Strain {xx, yy, zz, xy, xz, yz} in scene axes; shears are 2 epsilon.
    Voigt strain, stress; ///< Stress {xx, yy, zz, xy, xz, yz} in scene axes.
    /// Stress in ply axes, {11, 22, 33, 12, 13, 23}, for strength criteria.
    Voigt ply_stress;
    /// Rotation R of the material. For finite rotations, the member `stress` is
    /// R^T sigma R with the Cauchy stress sigma.
    Triad rotation = dealii::unit_symmetric_tensor<3>();
    /// Largest stress difference between the elements that contain the point,
    /// divided by the largest stress (mean_sample()); 0 for one element.
    double jump = 0.;
  };

  /// A point of the surface of a body with normal and area, for contact and
  /// loads: a surface node (Body::surface_points()) or any point of a facet
  /// (Body::surface_point()).
  struct SurfacePoint
  {
    /// Position in the undeformed scene.
    dealii::Point<3> position;
    /// Outward unit normal, scene axes; at nodes shared by several faces of a
    /// solid the mean of face normals, weighted by area.
    dealii::Tensor<1, 3> normal;
    /// Tributary area of a node [length^2]; for a point of a facet the Jacobian
    /// |dX/ds x dX/dt| of the map from the unit square.
    double area = 0.;
    /// True for a node whose adjacent faces have normals that differ by 20
    /// degrees or more, so that its normal is not unique.
    bool corner = false;
    /// Location of the point, in the element adjacent to the surface.
    Location location;
    /// Elastic modulus E_n = (n n) : C : (n n) along the normal n [force /
    /// length^2], from which the automatic penalty is computed.
    double normal_modulus = 0., depth = 0.; ///< Element size along n [length].
  };

  /// A face of an element on the surface of a body, parameterized by (s, t) in
  /// the unit square. The point (s, t) has the unit coordinates origin + s
  /// along_s + t along_t in the element. On lateral surfaces s runs along the
  /// section's edge and t along the axis. The outward normal
  /// (Body::surface_point()) is along_s x along_t or its opposite.
  struct SurfaceFacet
  {
    /// Index of the element, see Location::Place::cell.
    unsigned int         cell = 0;
    dealii::Point<3>     origin;  ///< Unit coordinates of (s, t) = (0, 0).
    dealii::Tensor<1, 3> along_s, ///< Change of unit coordinates per unit s.
      along_t;                    ///< Change of unit coordinates per unit t.
    /// Corners (s, t) = (0, 0), (1, 0), (0, 1) and (1, 1), scene axes.
    std::array<dealii::Point<3>, 4> corners;
    /// Polynomial degree along s of the grid of nodes used by contact.
    unsigned int degree_s = 0, degree_t = 0; ///< Degree of this grid along t.
    /// Polynomial degree along s of the displacement on the facet.
    unsigned int trace_degree_s = 0,
                 trace_degree_t = 0; ///< Degree of the displacement along t.
  };

  struct Ply;
  struct SurfaceTopology;

  /// A scalar function of the position in the scene.
  using ScalarField = std::function<double(const dealii::Point<3> &)>;

  /// Numbers of intervals of a regular grid along three unit coordinates.
  using GridIntervals = std::array<unsigned int, 3>;

  /// Number, ownership and polynomial degrees of the elements of a body.
  struct Cells
  {
    /// Number of elements on all processes together.
    unsigned int n = 0;
    /// Index of the first element of this process, and one past the last.
    std::pair<unsigned int, unsigned int> own;
    /// Largest polynomial degrees of displacements along the three unit
    /// coordinates of an element, at least 1.
    GridIntervals degrees{{1, 1, 1}};
  };

  /// A ply of the section and its axes at a point.
  struct PlyAndAxes
  {
    unsigned int ply = 0; ///< Index of the ply in Body::plies().
    Triad        axes;    ///< Ply axes 1, 2, 3 at the point, in body axes.
  };

  /// Fields of an element on a regular grid of its unit cube or of a cut
  /// through it, for output; xi runs fastest, then the axis, then eta (xi, eta:
  /// section coordinates). Elements do not share points: stresses are
  /// discontinuous.
  struct OutputCell
  {
    unsigned int         ply = 0; ///< Index of the ply in Body::plies().
    dealii::Tensor<1, 3> fiber,   ///< Fiber direction, scene axes.
      ply_normal;                 ///< Normal of the ply, scene axes.
    /// Undeformed positions of the grid points, scene axes.
    std::vector<dealii::Point<3>> positions;
    std::vector<FieldSample>      samples; ///< Fields at `positions`.
  };

  /// Strain energy of a displacement of a body, and measures of how large
  /// rotations and strains are.
  struct Deformation
  {
    /// Energy integral epsilon . C epsilon / 2 dV [force length], with the
    /// total strain epsilon. For finite rotations, integral epsilon . C
    /// epsilon_0 dV with the thermal strain epsilon_0 is subtracted.
    double energy = 0.;
    /// Largest rotation [rad], |curl u| / 2 if rotations are small.
    double max_rotation = 0.;
    /// Largest principal Green strain; 0 unless rotations are finite.
    double max_strain      = 0.,
           max_rms_strain  = 0., ///< Largest RMS of axial strain in a section.
      max_element_rotation = 0.; ///< Largest rotation along an element [rad].
    /// Largest relative change of bending moments and torques due to the change
    /// of the section's shape, which GeometricallyExactBeam neglects.
    double shape_change = 0.;
  };

  /// Rigid motion: translations along x, y, z [length], rotations [rad].
  using RigidMotion = std::array<double, 6>;

  /// Interface of a discretized elastic body: DoFs, stiffness, points and
  /// surfaces, without boundary conditions. Positions are in scene axes.
  /// Displacements are arguments; the body stores none. A "row" is a linear
  /// functional of the DoFs, such as a displacement component at a point.
  /// Equations are those of Nagaraj et al. 2020.
  ///
  /// In the principle of virtual work (Eqs. 8 to 12) the internal work is
  ///   delta L_int = delta u . K u,   K = int B^T C B dV,
  /// where the functionals epsilon = B u at a point are rows(..,
  /// Quantity::strain). A force P at the point X contributes to the load vector
  /// f by the functionals r_c of the displacement components u_c(X),
  ///   f_k += sum_c P_c r_c,k   with   u_c(X) = sum_k r_c,k u_k
  /// A prescribed displacement is r_c(u) = value. A gap is the difference of
  /// the displacement functionals of two bodies along a normal (Eq. 16).
  ///
  /// All processes hold the same body and complete vectors of n_dofs() entries.
  /// Collective functions must be called by all processes with the same
  /// arguments. The product u . f is a work, whatever the units of the DoFs.
  class Body
  {
  public:
    /// Constructs the body called @p name in messages, at @p placement.
    explicit Body(std::string name, const Placement &placement = {});
    virtual ~Body();

    // ---- DoFs and rigid motions

    /// Returns the name of the body in the scene file and in messages.
    const std::string &
    name() const
    {
      return body_name;
    }

    /// Returns position and axes of the body; its y axis is the beam axis.
    const Placement &
    place() const
    {
      return placement;
    }

    /// Returns theory and mesh for output, e.g. `LE-2, 20 B4` (20 elements).
    virtual std::string
    theory() const = 0;

    /// Returns the number of DoFs of the unconstrained body on all processes.
    virtual DofIndex
    n_dofs() const = 0;

    /// Returns an upper bound of the number of nonzeros of the stiffness
    /// matrix. Collective.
    virtual double
    stiffness_entries() const;

    /// Returns true if DoF 3 i + c is displacement component c of node i, which
    /// the multigrid solver `cg` requires; false for other numberings.
    virtual bool
    is_nodal() const
    {
      return false;
    }

    /// Returns the contiguous range of DoFs whose rows of the stiffness matrix
    /// this process owns. Ranges are in the order of processes.
    virtual dealii::IndexSet
    owned_dofs() const
    {
      return dealii::complete_index_set(n_dofs());
    }

    /// Returns the level of @p dof in the hierarchical basis of the section
    /// (doc/theory/stable-basis.md): 0 for rigid motions, higher for finer
    /// functions; 0 for nodal bases. Supports eliminate DoFs of low level
    /// first, for stability.
    virtual unsigned int
    dof_level(const DofIndex) const
    {
      return 0;
    }

    /// Returns for each DoF the largest displacement due to a unit value of the
    /// DoF, up to a factor of order one, to scale DoFs of different units.
    virtual std::vector<double>
    dof_scales() const
    {
      return std::vector<double>(n_dofs(), 1.);
    }

    /// Returns the position of the node of @p dof, for messages.
    virtual dealii::Point<3>
    dof_position(const DofIndex dof) const = 0;

    /// Returns the homogeneous constraints of the discretization: Kirchhoff's
    /// constraint in Euler-Bernoulli theory or hanging nodes. The linear solver
    /// applies them; the stiffness matrix and rows() do not include them.
    virtual const Constraints &
    kinematic_constraints() const;

    /// Returns the six rigid motions, which span the null space of the
    /// stiffness: unit translations and rotations along and about scene axes,
    ///   u(X) = e_m,   u(X) = e_m x (X - center()),   m = x, y, z.
    /// Displacements that the theory lacks (omitted_rigid_motions()) are zero.
    virtual std::vector<Vector>
    rigid_motions() const = 0;

    /// Returns the rigid motions of the body displaced by the argument u: unit
    /// translations e_m and rotations e_m x (X + u - center()) for the scene
    /// axes m = x, y, z. This default implementation returns rigid_motions().
    virtual std::vector<Vector>
    rigid_motions_at(const Vector &) const
    {
      return rigid_motions();
    }

    /// Returns true if the kinematics has finite rotations: internal forces are
    /// nonlinear, stresses refer to rotated axes, and rows() of strains and
    /// stresses do not exist.
    virtual bool
    has_finite_rotations() const
    {
      return false;
    }

    /// Returns true if the DoFs include finite rotations. Displacements are
    /// then nonlinear in the DoFs (rows_at()), and retract() adds increments.
    virtual bool
    constraints_rotate() const
    {
      return false;
    }

    /// Returns the DoFs @p u updated by the increment @p change, by default the
    /// sum; rotational DoFs are composed.
    virtual Vector
    retract(const Vector &u, const Vector &change) const;

    /// Returns the largest nodal rotation [rad] of an increment; 0 by default.
    virtual double
    largest_spin(const Vector &) const
    {
      return 0.;
    }

    /// Returns the rigid motions that the theory lacks, such as rotation about
    /// the axis of Euler-Bernoulli and Timoshenko beams. They need no support.
    virtual std::vector<RigidMotion>
    omitted_rigid_motions() const
    {
      return {};
    }

    /// Returns the reference point of rotations and moments, scene axes; by
    /// default the center of bounding_box().
    virtual dealii::Point<3>
    center() const;

    /// Returns half the largest extent of the body, a length for tolerances.
    virtual double
    size() const;

    /// Returns the bounding box of the undeformed nodes, scene axes.
    virtual dealii::BoundingBox<3>
    bounding_box() const = 0;

    // ---- mechanics

    /// Adds the internal forces to @p f, f += integral B^T sigma(B u) dV, which
    /// is f += K u for a linear body. They are computed from strains, since
    /// rounding of an assembled matrix loses the bending energy of slender
    /// bodies (doc/theory/stable-basis.md). Collective.
    virtual void
    add_internal_forces(const Vector &u, Vector &f) const = 0;

    /// Returns strain energy and largest rotation of @p u. By default, uses the
    /// work of internal forces for the energy, and curl u of an interpolant
    /// with output_degrees() for the rotation. Collective.
    virtual Deformation
    deformation(const Vector &u) const;

    /// Returns second-order strains and geometric stiffness for buckling at the
    /// displacement @p u. The body must outlive the result. Collective.
    virtual std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const = 0;

    /// Sets the change of temperature T [K] from the stress-free state, a
    /// function of scene position, which causes the initial strain epsilon_0 =
    /// alpha T. Throws InputError if a ply has no expansion coefficients or the
    /// theory does not support temperatures.
    virtual void
    heat(const ScalarField &change);

    /// Returns true if heat() has set a change of temperature.
    bool
    is_heated() const
    {
      return bool(temperature_change);
    }

    /// Adds the thermal load, f += integral B^T C epsilon_0 dV with the thermal
    /// strain epsilon_0. Returns the energy integral epsilon_0 . C epsilon_0 /
    /// 2 dV. This default implementation has one Gauss point more than
    /// output_degrees() per coordinate. Collective.
    virtual double
    add_thermal_load(Vector &f) const;

    /// Adds the thermal load for finite rotations at the displacement @p u, f
    /// += integral (dE/du)^T C epsilon_0 dV with Green's strain E and the
    /// thermal strain epsilon_0. Collective.
    virtual void
    add_thermal_load_at(const Vector &u, Vector &f) const;
    /// Calls @p use with this process's blocks of the derivative by u of the
    /// forces of add_thermal_load_at().
    virtual void
    for_each_thermal_block(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Adds the load vector of the weight to @p f, f . u = integral rho g . u
    /// dV with the density rho and g = @p acceleration [length / s^2]. Throws
    /// InputError if a ply has no density. Collective.
    virtual void
    add_weight(const dealii::Tensor<1, 3> &acceleration, Vector &f) const;

    /// A callback with the Gauss points of an element and a force at each.
    using ForcesCallback =
      std::function<void(const std::vector<Location> &,
                         const std::vector<dealii::Tensor<1, 3>> &)>;
    /// Calls @p use for each element of this process, or @p of_all_processes,
    /// with its Gauss points and their weights (forces, scene axes). Throws as
    /// add_weight() does.
    void
    for_each_cell_by_weight(const dealii::Tensor<1, 3> &acceleration,
                            const ForcesCallback       &use,
                            const bool of_all_processes = false) const;

    /// Returns the plies (of one material and fiber angle) of the section.
    virtual const std::vector<Ply> &
    plies() const = 0;

    // ---- points, rows and samples

    /// Returns for each of @p points (undeformed, scene axes) one location per
    /// ply that contains the point, in the order of plies; none for a point
    /// outside. The tolerance is 1e-6 of the smaller extent of the section, at
    /// curved edges 2 % of the element size.
    virtual std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const = 0;

    /// Returns for each location the components of @p quantity as functionals
    /// of the DoFs: three displacements in scene axes, or six strains or
    /// stresses (xx, yy, zz, xy, xz, yz) in the axes @p frame, means over all
    /// elements at the location. Stresses of heated plies have the constant -C
    /// epsilon_0.
    virtual std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const = 0;

    /// Returns the rotation matrix of the section at @p location for the DoFs
    /// @p u; by default the identity.
    virtual dealii::Tensor<2, 3>
    rotation_at(const Location &location, const Vector &u) const;

    /// Returns the displacements [length, scene axes] at @p locations for the
    /// DoFs @p u; by default the values of rows().
    virtual std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const;
    /// Returns the derivatives of displacements() by @p u as functionals of an
    /// increment of the DoFs, three per location; by default rows().
    virtual std::vector<std::vector<LinearFunctional>>
    rows_at(const std::vector<Location> &locations, const Vector &u) const;

    /// Calls @p use with symmetric blocks of this process's elements that sum
    /// to the load stiffness of the point @p forces F_k at @p locations, the
    /// derivative by u of the nodal forces sum_k rows_at()^T F_k. No blocks by
    /// default.
    virtual void
    for_each_block_of_forces(
      const std::vector<Location>                       &locations,
      const std::vector<dealii::Tensor<1, 3>>           &forces,
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Returns displacement, strain and stress of @p u at @p location.
    virtual FieldSample
    sample(const Location &location, const Vector &u) const;

    /// Returns the undeformed position of a point of an element, scene axes.
    virtual dealii::Point<3>
    position(const Location::Place &place) const = 0;

    /// Returns the ply and the ply axes at a point of an element.
    virtual PlyAndAxes
    ply_at(const Location::Place &place) const = 0;

    // ---- surfaces

    /// Returns the names of surfaces: lateral ones, named like the boundaries
    /// of the section, then `start`, `end`, `ends` (both) and `all`.
    virtual std::vector<std::string>
    surfaces() const = 0;

    /// Returns the facets (element faces) of @p surface, without gaps and
    /// overlaps, with numbers of their shared nodes.
    virtual SurfaceTopology
    surface_topology(const std::string &surface) const = 0;

    /// Returns the point of @p facet at (s, t) = @p st in [0, 1]^2; its area is
    /// the Jacobian of the facet. FacetMap is faster for many points.
    virtual SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const = 0;

    /// Returns the facets (element faces) of surface_topology() for @p surface.
    virtual std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const;

    /// Returns points that determine the displacement of @p surface, with
    /// outward normals and tributary areas, for node-to-node contact (Sec. 3.3
    /// of Nagaraj et al. 2020) and normal supports. By default these are the
    /// nodes of facets without hanging nodes.
    virtual std::vector<SurfacePoint>
    surface_points(const std::string &surface) const;

    /// Returns locations that determine the displacement of @p surface, as few
    /// as possible; by default the nodes of its facets without hanging nodes.
    virtual std::vector<Location>
    constraint_points(const std::string &surface) const;

    /// Returns locations that determine the displacement of the whole body; by
    /// default the Gauss-Lobatto points of each element.
    virtual std::vector<Location>
    body_points() const;

    // ---- elements

    /// Returns number, ownership and degrees of the elements.
    virtual Cells
    cells() const = 0;

    /// Returns for each unit coordinate the degree p for strain recovery:
    /// strains are superconvergent at p Gauss points. 0 along coordinates in
    /// which strains are smooth across elements (section, Taylor theories).
    virtual std::array<unsigned int, 3>
    recovery_degrees() const
    {
      return cells().degrees;
    }

    /// Returns the recovery_degrees() of the element with the given index.
    virtual std::array<unsigned int, 3>
    recovery_degrees_of(const unsigned int) const
    {
      return recovery_degrees();
    }

    /// Returns the parameters in [0, 1], ascending from 0 to 1, at which the
    /// segment from @p from to @p to (scene axes) crosses element faces. The
    /// default implementation assumes bilinear faces.
    virtual std::vector<double>
    line_breaks(const dealii::Point<3> &from, const dealii::Point<3> &to) const;

    /// Returns the polynomial degree of displacements along the segment from
    /// @p from to @p to within an element; zero if both are equal.
    virtual unsigned int
    line_degree(const dealii::Point<3> &from, const dealii::Point<3> &to) const;

    /// Returns ordered points from @p from to @p to that determine the
    /// displacement on the segment: line_degree() + 1 Gauss-Lobatto points
    /// between successive line_breaks().
    std::vector<dealii::Point<3>>
    line_points(const dealii::Point<3> &from, const dealii::Point<3> &to) const;

    /// Returns the fields of @p u on the cross-section at the distance
    /// @p position from the start of the axis, at (n + 1)^2 points per element,
    /// on every process. Between two axis elements, fields are means over both.
    virtual std::vector<OutputCell>
    cut(const double position, const unsigned int n, const Vector &u) const;

    /// Returns the number of intervals along each unit coordinate of an element
    /// that resolve its displacement and shape in output.
    virtual GridIntervals
    output_degrees() const
    {
      return cells().degrees;
    }

    /// A callback with the index of an element in this process and its fields.
    using OutputCellCallback =
      std::function<void(const unsigned int, const OutputCell &)>;

    /// Calls @p use once for each element of this process, in any order, with
    /// the fields of @p u on a regular grid of @p n intervals.
    virtual void
    for_each_output_cell(const GridIntervals      &n,
                         const Vector             &u,
                         const OutputCellCallback &use) const;

    /// Returns the fields of @p u in all elements, at (n + 1)^3 points each.
    std::vector<OutputCell>
    output_cells(const unsigned int n, const Vector &u) const;

    // ---- solvers

    /// Returns the solver @p requested or, if it is `automatic`, `cg` for nodal
    /// bodies of more than 300000 DoFs, otherwise CHOLMOD on one process and
    /// MUMPS on several. Throws InputError for `cholmod` on several processes
    /// and for `cg` if is_nodal() is false.
    SolverKind
    solver_kind(const SolverKind requested) const;

    /// Returns the terms of the unconstrained stiffness K + sum k r^T r, where
    /// each of @p springs has a stiffness k and an elongation r, a functional
    /// of the DoFs. The body must outlive the result.
    StiffnessTerms
    stiffness_terms(const std::vector<SpringTerm> &springs = {}) const;

    /// Returns the stiffness T^T (K + sum k r^T r) T, assembled for the solver
    /// @p requested: K of the body, k and r the stiffness and elongation of
    /// each of @p springs. The homogeneous @p constraints u = T v must include
    /// kinematic_constraints(). Throws as solver_kind() does. Collective.
    std::unique_ptr<StiffnessMatrix>
    assembled_stiffness(
      const Constraints             &constraints,
      const std::vector<SpringTerm> &springs   = {},
      const SolverKind               requested = SolverKind::automatic) const;

    /// Returns a solver for the matrix of assembled_stiffness(). @p monitor is
    /// called after assembly, and with the size of the matrix factor. Throws
    /// NumericsError with a position in the scene if the matrix is not positive
    /// definite, InputError as solver_kind() does. Collective.
    std::unique_ptr<LinearSolver>
    make_solver(const Constraints             &constraints,
                const std::vector<SpringTerm> &springs = {},
                const SolverKind     requested         = SolverKind::automatic,
                const SolverMonitor &monitor           = {}) const;

    /// Returns the terms of the tangent stiffness K(u) of the internal forces.
    /// If the last Newton @p correction is not empty, the geometric stiffness
    /// uses stresses linearized at the previous iterate (predicted_strain()).
    StiffnessTerms
    tangent_terms(const Vector                  &u,
                  const Vector                  &correction,
                  const std::vector<SpringTerm> &springs = {}) const;
    /// Adds the product K(u) w of the tangent stiffness K(u) to f.
    void
    add_tangent_forces(const Vector &u, const Vector &w, Vector &f) const;
    /// Returns a solver for the sum of tangent_terms(), see make_solver().
    std::unique_ptr<LinearSolver>
    make_tangent_solver(const Vector                  &u,
                        const Vector                  &correction,
                        const Constraints             &constraints,
                        const std::vector<SpringTerm> &springs = {},
                        const SolverKind     requested = SolverKind::automatic,
                        const SolverMonitor &monitor   = {}) const;

    /// Returns a solver for the sum of @p terms with the homogeneous
    /// @p constraints. Parameters and exceptions are those of make_solver().
    virtual std::unique_ptr<LinearSolver>
    solver_of(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested,
              const SolverMonitor  &monitor) const;

    /// Returns the first Gauss point of this process (undeformed, scene axes)
    /// with det F <= 0 at @p u; none if there is none, or by default.
    virtual std::vector<dealii::Point<3>>
    inverted_points(const Vector & /*u*/) const
    {
      return {};
    }

  protected:
    /// Calls @p use with the blocks of this process that sum to the
    /// unconstrained stiffness K. If @p with_values is false, blocks have only
    /// DoFs, without values (sparsity pattern).
    virtual void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;

    /// Calls @p use with the blocks of the tangent stiffness at @p u; see
    /// tangent_terms() for @p correction. Requires finite rotations.
    virtual void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Returns the temperature change at @p x (scene axes) [K]; 0 by default.
    double
    temperature(const dealii::Point<3> &x) const
    {
      return temperature_change ? temperature_change(x) : 0.;
    }

    /// Returns the density of each ply. Throws InputError if a ply has none.
    std::vector<double>
    densities() const;

    /// Rethrows @p error as a NumericsError with the position of its DoF.
    [[noreturn]] void
    rethrow_with_position(const NotPositiveDefinite &error) const;

    const Placement placement; ///< Position and axes of the body in the scene.

  private:
    /// Returns the condensed matrix of @p terms for the solver @p requested.
    std::unique_ptr<StiffnessMatrix>
    assembled(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested) const;

    /// A callback with the Gauss points of an element and their weights JxW.
    using PointsCallback = std::function<void(const std::vector<Location> &,
                                              const std::vector<double> &)>;
    void
    for_each_cell_by_points(const PointsCallback &use,
                            const bool of_all_processes = false) const;

    /// Returns true if the elements @p before and @p cell are axial neighbors.
    bool
    is_adjacent(const unsigned int before, const unsigned int cell) const;

    /// Returns the fields of the element @p cell at @p etas in [0, 1] along the
    /// axis, with @p n intervals in the section.
    OutputCell
    sample_grid(const unsigned int         cell,
                const GridIntervals       &n,
                const std::vector<double> &etas,
                const Vector              &u) const;

    /// Replaces the fields of @p grid on the face of the element @p cell
    /// nearest to the start by means with those of the adjacent element.
    void
    average_with_previous_layer(const unsigned int cell,
                                const Vector      &u,
                                OutputCell        &grid) const;

    std::string body_name;
    ScalarField temperature_change;
  };

  /// The bodies of a scene; block b of a BlockVector has the DoFs of body b.
  using Bodies = std::vector<std::unique_ptr<Body>>;
} // namespace lamella

#endif
