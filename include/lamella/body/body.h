// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `body`: the interface Body, its two kinds, beam (an axis times a
// section) and solid (hexahedra on the same section mesh), their placement and
// the fields at their points. A body knows neither supports nor contacts.
//
// Start with Body, Location and LinearFunctional (base/linear_functional.h).
// Body::locate() finds the elements that contain a point, and Body::rows()
// returns the displacement there as a linear functional of the DoFs. Point
// forces, supports and gaps are made of these two.

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

  /// The fields that rows and samples evaluate: the displacement u, the strain
  /// epsilon = D u (Eq. 5) and the stress sigma = C (epsilon - epsilon_0) (Eq.
  /// 6 with the initial strain epsilon_0 of the law).
  enum class Quantity
  {
    displacement, ///< three components, scene axes
    strain,       ///< six, order of Eq. 4, engineering shear strains
    stress        ///< six, order of Eq. 4
  };

  /// Axes of a strain or a stress. Displacements always are in scene axes.
  enum class Frame
  {
    scene, ///< x, y, z of the scene, whatever the body's placement
    ply ///< 1 along the fiber, 2 across, 3 normal to the ply: 11,22,33,12,13,23
  };

  /// A point of a body in one of its plies, with the elements that contain it.
  /// A field there is the mean of these elements. Elements of different plies
  /// are never averaged, since sigma_xx, sigma_yy and sigma_xy of a laminate
  /// jump at interfaces: a point there has one location per ply
  /// (Body::locate()). A location refers to no body and stays valid.
  struct Location
  {
    struct Place
    {
      /// Element: (axis element, section cell) as in Beam, or the hexahedron.
      unsigned int cell;
      /// Position (xi, along the axis, eta) in [0, 1]^3.
      dealii::Point<3> unit;
    };
    /// The requested point, scene axes; places may differ beyond a curved edge.
    dealii::Point<3> position;
    /// The ply of all places, a number in the plies of the section mesh.
    unsigned int ply = 0;
    /// The elements that contain the point, at least one.
    std::vector<Place> places;
  };

  /// Fields at a location, the means over its places, from displacements by the
  /// ply's law, without smoothing (see recover/recovery.h).
  struct FieldSample
  {
    /// Displacement in scene axes [length].
    dealii::Tensor<1, 3> displacement;
    /// Strain and stress in scene axes, order of Eq. 4, {xx, yy, zz, xy, xz,
    /// yz}, with engineering shear strains gamma = 2 epsilon.
    Voigt strain, stress;
    /// Stress in ply axes, {11, 22, 33, 12, 13, 23}, for strength criteria.
    Voigt ply_stress;
    /// Rotation R of the material: at finite rotations `stress` is R^T sigma R.
    Triad rotation = dealii::unit_symmetric_tensor<3>();
    /// Largest stress difference between places over the largest stress.
    double jump = 0.;
  };

  /// A point of a body's surface for collocation: the normal n_1 of the gap
  /// (Eqs. 14 to 17), the area of a nodal force, and the stiffness below. It is
  /// a node in surface_points(), and any place of a facet in surface_point().
  struct SurfacePoint
  {
    /// Position in the undeformed scene.
    dealii::Point<3> position;
    /// Outward unit normal, scene axes; at a node of several sides their mean
    /// by area (a beam has a point for each side).
    dealii::Tensor<1, 3> normal;
    /// Tributary area of a node (length^2), or at a place of a facet the area
    /// per unit of its square, |dX/ds x dX/dt|, without quadrature weight.
    double area = 0.;
    /// Flag of a node whose sides differ by 20 degrees or more: a normal
    /// displacement or a gap has no direction there.
    bool corner = false;
    /// The point for rows() and sample(): one place, in the cell below.
    Location location;
    /// Data of the automatic penalty E_n A / d (contact/enforcement.h): modulus
    /// E_n = (n n) : C : (n n) [force / length^2], cell depth d along n.
    double normal_modulus = 0., depth = 0.;
  };

  /// A side of one cell of a body: the image of the unit square under a
  /// polynomial map. The point (s, t) is origin + s along_s + t along_t in the
  /// cell's unit cube. On a lateral surface s runs along the section's edge and
  /// t along the axis; on ends both are coordinates of the section. (along_s) x
  /// (along_t) may point either way: take the normal from Body::surface_point()
  /// or FacetMap::outward(). A facet refers to no body.
  struct SurfaceFacet
  {
    /// Element number as in Location::Place::cell.
    unsigned int cell = 0;
    /// Corner of the unit cube that is (0, 0), and the axes of s and t there.
    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> along_s, along_t;
    /// Positions of (0, 0), (1, 0), (0, 1) and (1, 1), scene axes.
    std::array<dealii::Point<3>, 4> corners;
    /// Degrees of the expansion in s and in t: those of a grid of nodes.
    unsigned int degree_s = 0, degree_t = 0;
    /// Degrees of positions and displacements, higher on curved sides.
    unsigned int trace_degree_s = 0, trace_degree_t = 0;
  };

  struct Ply;
  struct SurfaceTopology;

  /// A scalar function of the position in the scene.
  using ScalarField = std::function<double(const dealii::Point<3> &)>;

  /// Numbers of intervals of a grid along the axes of Location::Place::unit.
  using GridIntervals = std::array<unsigned int, 3>;

  /// The elements of a body by number, for Body::position() and the like.
  struct Cells
  {
    /// Number of elements on all processes together.
    unsigned int n = 0;
    /// Elements of this process, the first and one past the last.
    std::pair<unsigned int, unsigned int> own;
    /// Degrees of the displacements within an element along its unit
    /// coordinates, each at least 1; the largest if elements differ.
    GridIntervals degrees{{1, 1, 1}};
  };

  /// The ply at a place, a number in Body::plies(), and its axes in body axes.
  struct PlyAndAxes
  {
    unsigned int ply = 0;
    Triad        axes;
  };

  /// An element for output: fields on a regular grid of its unit cube, or of a
  /// cut through it; xi runs fastest, then the axis, then eta. Elements do not
  /// share points, so that jumps of stress stay visible.
  struct OutputCell
  {
    /// Ply, directions of its fibers and its normal (unit vectors, scene axes).
    unsigned int         ply = 0;
    dealii::Tensor<1, 3> fiber, ply_normal;
    /// Undeformed positions, scene axes, one per sample.
    std::vector<dealii::Point<3>> positions;
    std::vector<FieldSample>      samples;
  };

  /// Integrals of a displacement field, and measures of geometrical linearity.
  struct Deformation
  {
    /// Energy integral epsilon . C epsilon / 2 dV [force length]: half the work
    /// of all forces, heat included (Body::add_thermal_load(), Clapeyron). For
    /// finite rotations, integral epsilon . C epsilon_0 dV is subtracted.
    double energy = 0.;
    /// Largest |curl u| / 2 at integration points [rad], for finite rotations
    /// the largest angle; solve/checks.h limits it.
    double max_rotation = 0.;
    /// Extremes at finite rotations: the principal Green strain, the root mean
    /// square of the axial strain over a section, and, of total Lagrangian
    /// bodies, the rotation over one element [rad].
    double max_strain = 0., max_mean_strain = 0., max_element_rotation = 0.;
    /// Largest share of moments and torques of rigidly rotating sections that
    /// the change of their shape would add (stiffening_by_shape()).
    double shape_change = 0.;
  };

  /// Amplitudes of a rigid motion: scene translations [length], rotations
  /// [rad].
  using RigidMotion = std::array<double, 6>;

  /**
   * A linear elastic body as a discretized boundary-value problem without its
   * boundary conditions: DoFs, a stiffness, rows at points, points on surfaces.
   * Supports, loads, contact and reports use this interface only. Positions are
   * in scene axes. A body takes displacements as arguments and stores none.
   *
   * In the principle of virtual displacements (Eqs. 8 to 12) the body owns the
   * left-hand side,
   *   delta L_int = delta u . K u,   K = int B^T C B dV,
   * where epsilon = B u at a point is rows(.., Quantity::strain). Rows form the
   * right-hand side: a force P at X is
   *   f_k += sum_c P_c r_c,k   with   u_c(X) = sum_k r_c,k u_k
   * (LinearFunctional::add_to()), a prescribed displacement is r_c(u) = value,
   * a gap of two bodies the difference of their rows along a normal (Eq. 16).
   *
   * A new kind of body implements the pure functions; faster versions may
   * override the others. Several processes hold the same body and whole
   * vectors. All call collective functions with the same arguments; the others
   * do not communicate and return the same everywhere. Vectors u and f have
   * n_dofs() entries. The product u . f is a work, whatever the units of single
   * DoFs.
   */
  class Body
  {
  public:
    /// Constructs the base of the body @p name (in messages) at @p placement.
    explicit Body(std::string name, const Placement &placement = {});
    virtual ~Body();

    // ---- DoFs and rigid motions

    const std::string &
    name() const
    {
      return body_name;
    }

    /// Returns the placement; y of its axes is the position along it (cut()).
    const Placement &
    place() const
    {
      return placement;
    }

    /// Returns the structural theory with its mesh, `LE-2, 20 B4` or `solid-2,
    /// 720 hexahedra`, for messages and tables only.
    virtual std::string
    theory() const = 0;

    /// Returns the number of DoFs of the unconstrained body on all processes.
    virtual DofIndex
    n_dofs() const = 0;

    /// Returns an upper estimate of the stiffness's non-zeros before assembly,
    /// a double, as products of sizes may overflow. Collective.
    virtual double
    stiffness_entries() const;

    /// Returns true if DoF 3 i + c is component c of the displacement of node
    /// i, as multigrid (`cg`) requires. DoFs of beams are amplitudes of fields.
    virtual bool
    is_nodal() const
    {
      return false;
    }

    /// Returns the DoFs whose stiffness rows this process owns: a contiguous
    /// range, all DoFs on one process. Ranges follow each other by process.
    virtual dealii::IndexSet
    owned_dofs() const
    {
      return dealii::complete_index_set(n_dofs());
    }

    /// Returns the level of @p dof in the hierarchical basis
    /// (doc/theory/stable-basis.md): 0 for rigid motions and nodal bases,
    /// higher for finer DoFs. Supports eliminate coarse DoFs first.
    virtual unsigned int
    dof_level(const DofIndex) const
    {
      return 0;
    }

    /// Returns for each DoF the largest displacement due to a unit of it, up to
    /// a factor of order one. It makes rows comparable between kinds of DoFs.
    virtual std::vector<double>
    dof_scales() const
    {
      return std::vector<double>(n_dofs(), 1.);
    }

    /// Returns the position of @p dof for messages; of a beam, its axis node.
    virtual dealii::Point<3>
    dof_position(const DofIndex dof) const = 0;

    /// Returns the closed homogeneous constraints of the theory: Kirchhoff's of
    /// EBBT, hanging nodes of a solid, else none. Stiffness and rows do not
    /// contain them; solvers apply them first (LinearFunctional::reduced()).
    virtual const Constraints &
    kinematic_constraints() const;

    /// Returns the six rigid motions, which span the null space of the
    /// stiffness: unit translations along the scene's axes and unit rotations
    /// about them,
    ///   u(X) = e_m,   u(X) = e_m x (X - center()),   m = x, y, z;
    /// of omitted_rigid_motions() the part that the theory contains.
    virtual std::vector<Vector>
    rigid_motions() const = 0;

    /// Returns the rigid motions of the body displaced by @p u, e_m and e_m x
    /// (X + u - center()); here rigid_motions().
    virtual std::vector<Vector>
    rigid_motions_at(const Vector &) const
    {
      return rigid_motions();
    }

    /// Returns true if the body admits finite rotations: internal forces are
    /// nonlinear, and strains and stresses refer to rotated axes without rows.
    virtual bool
    has_finite_rotations() const
    {
      return false;
    }

    /// Returns true for rotational DoFs: rows of displacements depend on the
    /// state (rows_at()), and states are not additive (retract()).
    virtual bool
    constraints_rotate() const
    {
      return false;
    }

    /// Returns the state that @p change makes of the state @p u, here the sum.
    virtual Vector
    retract(const Vector &u, const Vector &change) const;

    /// Returns the largest rotation in the DoFs of @p change [rad], here 0.
    virtual double
    largest_spin(const Vector &) const
    {
      return 0.;
    }

    /// Returns the rigid motions that the theory lacks (rotation about the axis
    /// of EBBT and TBT). They need no support, and their couples do no work.
    virtual std::vector<RigidMotion>
    omitted_rigid_motions() const
    {
      return {};
    }

    /// Returns the center of rotations and moments, scene axes: of a beam the
    /// centroid at mid-length; here the center of bounding_box().
    virtual dealii::Point<3>
    center() const;

    /// Returns half the largest extension, a length scale for tolerances.
    virtual double
    size() const;

    /// Returns the undeformed box, scene axes; curved edges may leave it.
    virtual dealii::BoundingBox<3>
    bounding_box() const = 0;

    // ---- mechanics

    /// Adds the internal forces, f += integral B^T sigma(B u) dV, f + K u in
    /// exact arithmetic. Strains come first: rounding of an assembled matrix
    /// loses the bending energy of slender bodies (doc/theory/stable-basis.md).
    /// Entries of @p f at constrained DoFs are the forces there. @p u and @p f
    /// are whole, equal on all processes. Collective.
    virtual void
    add_internal_forces(const Vector &u, Vector &f) const = 0;

    /// Returns the strain energy of @p u and the largest rotation; here the
    /// work of the internal forces, and curl u of an interpolation on a grid of
    /// output_degrees() in each element. Collective, the same on all processes.
    virtual Deformation
    deformation(const Vector &u) const;

    /// Returns the terms of second order in the strain at the displacement
    /// @p u, which is not stored. Refers to the body. Collective.
    virtual std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const = 0;

    /// Sets the change of temperature @p change [K] from the stress-free state
    /// by scene position, in place of any earlier one. Plies get the initial
    /// strain epsilon_0 = alpha T in samples and rows. Throws InputError if a
    /// ply has no expansion or the theory cannot be heated.
    virtual void
    heat(const ScalarField &change);

    bool
    is_heated() const
    {
      return bool(temperature_change);
    }

    /// Adds the thermal load, f += integral B^T C epsilon_0 dV, which has no
    /// resultant. Returns the energy integral epsilon_0 . C epsilon_0 / 2 dV,
    /// zero if unheated. Here one Gauss point more than output_degrees() along
    /// each coordinate. Collective.
    virtual double
    add_thermal_load(Vector &f) const;

    /// Adds, for finite rotations, the thermal load in the state @p u, f +=
    /// integral (dE/du)^T C epsilon_0 dV. The second function gives its
    /// derivative as symmetric blocks, here none (Green's strain).
    virtual void
    add_thermal_load_at(const Vector &u, Vector &f) const;
    virtual void
    for_each_thermal_block(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Adds the weight, f += integral of rho g . u dV, g = @p acceleration
    /// [length/s^2]. Throws InputError without a density. Collective.
    virtual void
    add_weight(const dealii::Tensor<1, 3> &acceleration, Vector &f) const;

    /// Calls @p use for each element of this process with the weight as forces
    /// at points (scene axes), valid during the call. Throws as add_weight().
    using ForcesCallback =
      std::function<void(const std::vector<Location> &,
                         const std::vector<dealii::Tensor<1, 3>> &)>;
    void
    for_each_cell_by_weight(const dealii::Tensor<1, 3> &acceleration,
                            const ForcesCallback       &use) const;

    /// Returns the homogeneous parts of the body's section.
    virtual const std::vector<Ply> &
    plies() const = 0;

    // ---- points, rows and samples

    /// Returns for each of @p points (undeformed scene) one location per ply,
    /// ascending; none outside of the body. The tolerance (of beams 1e-6 of the
    /// section's smaller extent) is far above rounding and far below any
    /// element; beyond a curved edge it is 2 % of the cell's size.
    virtual std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const = 0;

    /// Returns for each location the rows of @p quantity: three for
    /// displacements, scene axes; six for strains and stresses, order of Eq. 4,
    /// in the axes @p frame; means over several places. Rows of a stress have
    /// the constant -C epsilon_0 of a heated ply, those of a strain the part
    /// that the theory completes, others none. Entries are sorted by DoF,
    /// without rounding zeros.
    virtual std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const = 0;

    /// Returns the rotation R of the section at @p location, here 1.
    virtual dealii::Tensor<2, 3>
    rotation_at(const Location &location, const Vector &u) const;

    /// Return the displacements at @p locations in the state @p u [length],
    /// scene axes, and the rows of their change; here rows() for any state.
    virtual std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const;
    virtual std::vector<std::vector<LinearFunctional>>
    rows_at(const std::vector<Location> &locations, const Vector &u) const;

    /// Calls @p use with symmetric blocks that sum to the derivative of @p
    /// forces in the state @p u, sum over k of rows_at()^T F_k. Here none.
    virtual void
    for_each_block_of_forces(
      const std::vector<Location>                       &locations,
      const std::vector<dealii::Tensor<1, 3>>           &forces,
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Returns all fields of @p u at @p location, means over its places.
    virtual FieldSample
    sample(const Location &location, const Vector &u) const;

    /// Returns the position of @p place, scene axes.
    virtual dealii::Point<3>
    position(const Location::Place &place) const = 0;

    /// Returns the ply of the element at @p place.
    virtual PlyAndAxes
    ply_at(const Location::Place &place) const = 0;

    // ---- surfaces

    /// Returns the names of surfaces: the section's boundaries swept along the
    /// axis, then the sections `start` and `end`, both as `ends`, and `all`. An
    /// unknown name has no points: callers check user input against these.
    virtual std::vector<std::string>
    surfaces() const = 0;

    /// Returns the facets of @p surface, without gaps and overlaps, and their
    /// shared nodes by the body's numbers (body/surface_topology.h).
    virtual SurfaceTopology
    surface_topology(const std::string &surface) const = 0;

    /// Returns the point of @p facet at (s, t) = @p st in [0, 1]^2 with the
    /// area per unit of the square, int f dA = int_0^1 int_0^1 f area ds dt.
    /// FacetMap is faster for many points.
    virtual SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const = 0;

    /// Returns the facets of surface_topology().
    virtual std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const;

    /// Returns points that determine the trace on @p surface, with outward
    /// normals and tributary areas int N_i F_tau dA, which sum to the area
    /// (approximately on beam ends with curved edges), for node-to-node contact
    /// (Sec. 3.3 of the paper) and normal supports. Here nodes of the facets'
    /// grids; a hanging node passes half its area to each neighbor.
    virtual std::vector<SurfacePoint>
    surface_points(const std::string &surface) const;

    /// Returns few locations that determine the displacement on @p surface;
    /// here nodes of facets' traces, none hanging.
    virtual std::vector<Location>
    constraint_points(const std::string &surface) const;

    /// Returns locations that determine the displacement of the whole body;
    /// here the Gauss-Lobatto grid of each element.
    virtual std::vector<Location>
    body_points() const;

    // ---- elements

    /// Returns the elements by number.
    virtual Cells
    cells() const = 0;

    /// Returns for each unit coordinate of an element the degree p for the
    /// recovery of strains (recover/recovery.h), which are superconvergent at p
    /// Gauss points. Zero along coordinates with one expansion over all
    /// elements (the section of Taylor theories), as strains are smooth there.
    virtual std::array<unsigned int, 3>
    recovery_degrees() const
    {
      return cells().degrees;
    }

    /// Returns the recovery degrees of the element @p cell, at most
    /// recovery_degrees() and zero along the same coordinates.
    virtual std::array<unsigned int, 3>
    recovery_degrees_of(const unsigned int) const
    {
      return recovery_degrees();
    }

    /// Returns the parameters in [0, 1], ascending, where the segment from @p a
    /// to @p b (scene axes) enters and leaves elements, its ends included. In
    /// between, the displacement is one polynomial. Here sides are bilinear.
    virtual std::vector<double>
    line_breaks(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /// Returns the degree of displacements along the segment from @p a to @p b
    /// within an element, on a skew line the sum over the coordinates, zero
    /// only if a equals b; here from cells().
    virtual unsigned int
    line_degree(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /// Returns ordered points from @p a to @p b that determine the
    /// displacement: line_degree() + 1 Gauss-Lobatto points between
    /// line_breaks().
    std::vector<dealii::Point<3>>
    line_points(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /// Returns the section at @p position (a length from the axis's start),
    /// with the fields of @p u on (n + 1) x (n + 1) points per element: the
    /// whole section on every process, empty outside of the body. Between two
    /// elements fields are the means of both, with their jump.
    virtual std::vector<OutputCell>
    cut(const double position, const unsigned int n, const Vector &u) const;

    /// Returns the number of intervals, at least 1, of an element's output
    /// along each unit coordinate, from the degrees of displacement and shape.
    virtual GridIntervals
    output_degrees() const
    {
      return cells().degrees;
    }

    /// A callback with an element's number in this process and its fields.
    using OutputCellCallback =
      std::function<void(const unsigned int, const OutputCell &)>;

    /// Calls @p use once for each element of this process, in any order, with
    /// the fields of @p u on a grid of @p n, each at least 1, not averaged.
    virtual void
    for_each_output_cell(const GridIntervals      &n,
                         const Vector             &u,
                         const OutputCellCallback &use) const;

    /// Returns all output cells by number, with (n + 1)^3 points each.
    std::vector<OutputCell>
    output_cells(const unsigned int n, const Vector &u) const;

    // ---- solvers

    /// Returns the solver that @p requested selects. `automatic` is `cg` for
    /// nodal bodies of more than 300000 DoFs (whose factor would take tens of
    /// gigabytes), else CHOLMOD on one process and MUMPS on several. Throws
    /// InputError for `cholmod` on several processes and for `cg` if not nodal.
    SolverKind
    solver_kind(const SolverKind requested) const;

    /// Returns the terms of the stiffness: blocks without constraints, and k
    /// r^T r of @p springs, whose rows are of this body. Refers to the body.
    StiffnessTerms
    stiffness_terms(const std::vector<SpringTerm> &springs = {}) const;

    /// Returns the stiffness with @p springs, for the solver @p requested,
    /// condensed by the closed homogeneous @p constraints, kinematic ones
    /// included: with u = T v + u_0 and the free DoFs v, T^T (K + sum k r^T r)
    /// T. Constrained DoFs keep a positive diagonal only. Throws InputError as
    /// solver_kind() does. Collective.
    std::unique_ptr<StiffnessMatrix>
    assembled_stiffness(
      const Constraints             &constraints,
      const std::vector<SpringTerm> &springs   = {},
      const SolverKind               requested = SolverKind::automatic) const;

    /// Returns a solver with the matrix of assembled_stiffness(), by
    /// solver_of(). @p monitor is called after assembly and with the size of a
    /// factor; its exceptions pass. Throws NumericsError with a place in the
    /// scene if the matrix is not positive definite, InputError as
    /// solver_kind() does. Collective.
    std::unique_ptr<LinearSolver>
    make_solver(const Constraints             &constraints,
                const std::vector<SpringTerm> &springs = {},
                const SolverKind     requested         = SolverKind::automatic,
                const SolverMonitor &monitor           = {}) const;

    /// Return the tangent of the internal forces at @p u: terms with @p
    /// springs, f += K(u) w, and a solver. @p correction is the last one on the
    /// way to u, or empty: the geometric part has the stress that it predicted
    /// (FiniteStrainSectionOperator).
    StiffnessTerms
    tangent_terms(const Vector                  &u,
                  const Vector                  &correction,
                  const std::vector<SpringTerm> &springs = {}) const;
    void
    add_tangent_forces(const Vector &u, const Vector &w, Vector &f) const;
    std::unique_ptr<LinearSolver>
    make_tangent_solver(const Vector                  &u,
                        const Vector                  &correction,
                        const Constraints             &constraints,
                        const std::vector<SpringTerm> &springs = {},
                        const SolverKind     requested = SolverKind::automatic,
                        const SolverMonitor &monitor   = {}) const;

    /// Returns a solver with the matrix of @p terms, condensed by
    /// @p constraints and handled as in make_solver().
    virtual std::unique_ptr<LinearSolver>
    solver_of(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested,
              const SolverMonitor  &monitor) const;

  protected:
    /// Calls @p use with this process's blocks of the unconstrained stiffness
    /// (rows of a beam, element matrices of a solid), which sum to K; without
    /// @p with_values the pattern. A block is valid during the call.
    virtual void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;

    /// Calls @p use with the blocks of the tangent at @p u after @p correction
    /// (of the size of u). Asserts finite rotations.
    virtual void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// Returns T at @p x (scene axes) [K]; zero if the body is not heated.
    double
    temperature(const dealii::Point<3> &x) const
    {
      return temperature_change ? temperature_change(x) : 0.;
    }

    /// Returns the density of each ply. Throws InputError if one has none.
    std::vector<double>
    densities() const;

    /// Rethrows @p error as a NumericsError with the place of its DoF.
    [[noreturn]] void
    rethrow_with_position(const NotPositiveDefinite &error) const;

    const Placement placement;

  private:
    /// Returns the matrix of @p terms, condensed, for the solver @p requested.
    std::unique_ptr<StiffnessMatrix>
    assembled(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested) const;

    /// A callback with Gauss points of an element, weights times |det J|.
    using PointsCallback = std::function<void(const std::vector<Location> &,
                                              const std::vector<double> &)>;
    void
    for_each_cell_by_points(const PointsCallback &use) const;

    /// Returns true if @p before and @p cell are neighbors along the axis.
    bool
    is_adjacent(const unsigned int before, const unsigned int cell) const;

    /// Returns fields at the grid points of @p cell, at @p etas along the axis,
    /// with @p n intervals in the section.
    OutputCell
    sample_grid(const unsigned int         cell,
                const GridIntervals       &n,
                const std::vector<double> &etas,
                const Vector              &u) const;

    /// Replaces samples on the begin side of @p cell by the means with the
    /// cells before it along the axis.
    void
    average_with_previous_layer(const unsigned int cell,
                                const Vector      &u,
                                OutputCell        &grid) const;

    std::string body_name;
    ScalarField temperature_change;
  };

  /// The bodies of a scene. Indices are BodyFunctional::body and vector blocks.
  using Bodies = std::vector<std::unique_ptr<Body>>;
} // namespace lamella

#endif
