// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `body`: the interface Body and its implementations, beam (section
// functions times axial shape functions) and solid (hexahedra). Bodies do not
// depend on supports or contacts.
//
// Start with Body, Location and LinearFunctional (base/linear_functional.h).
// Body::locate() finds the elements that contain a point, and Body::rows()
// returns the displacement of the point as linear functionals of the DoFs
// (rows), from which point forces, supports and gaps are formed. Functions that
// follow from others are not members: body_solver.h, fields.h, line_crossings.h
// and surface_topology.h have them.

#ifndef lamella_body_body_h
#define lamella_body_body_h

#include <lamella/base/linear_functional.h>
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
  /// Position and orientation of a body in the scene: the origin o of its
  /// section at y = 0, and the rotation R. Rows of R are the body axes x
  /// (across), y (along the beam), z (up) in scene components. A scene point X
  /// has body coordinates x_body; a scene vector v has body components v_body:
  ///   x_body = R (X - o),   X = o + R^T x_body,   v_body = R v.
  struct Placement
  {
    /// Scene position of the section's lower left corner, or of the origin of
    /// its mesh file, at the start of the axis.
    dealii::Point<3> origin;
    /// Rotation matrix R; its rows are the body axes. The identity by default.
    Triad axes = unit_triad();

    /// Returns the placement with y along @p axis and z as near to @p up as
    /// possible:
    ///   x = axis x up / |axis x up|,   y = axis / |axis|,   z = x x y.
    /// Throws InputError if axis and up are parallel (sine below 1e-6) or zero.
    static Placement
    from_directions(const dealii::Point<3>     &origin,
                    const dealii::Tensor<1, 3> &axis,
                    const dealii::Tensor<1, 3> &up);

    /// Returns the body coordinates of the scene point @p x.
    dealii::Point<3>
    to_body(const dealii::Point<3> &x) const
    {
      return dealii::Point<3>(axes * (x - origin));
    }

    /// Returns the scene coordinates of the point @p x in body axes.
    dealii::Point<3>
    to_scene(const dealii::Point<3> &x) const
    {
      return origin + vector_to_scene(x);
    }

    /// Returns the scene components of a vector given in body axes.
    dealii::Tensor<1, 3>
    vector_to_scene(const dealii::Tensor<1, 3> &v) const
    {
      return transpose(axes) * v;
    }

    /// Returns the body components of a vector given in scene axes.
    dealii::Tensor<1, 3>
    vector_to_body(const dealii::Tensor<1, 3> &v) const
    {
      return axes * v;
    }

    /// Returns the rotation matrix @p R, given in body axes, in scene axes.
    Triad
    rotation_in_scene(const Triad &R) const
    {
      return transpose(axes) * R * axes;
    }

    /// Returns the matrix T that transforms strains (xx, yy, zz, engineering
    /// shears xy, xz, yz) from body to scene axes. Stresses need T^-T.
    ElasticTensor
    strain_to_scene() const
    {
      return strain_rotation(transpose(axes));
    }
  };

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
  /// Degrees are along the three unit coordinates of an element.
  struct Cells
  {
    /// Number of elements on all processes together.
    unsigned int n = 0;
    /// Index of the first element of this process, and one past the last.
    std::pair<unsigned int, unsigned int> own;
    /// Largest polynomial degrees of displacements, at least 1.
    GridIntervals degrees{{1, 1, 1}};
    /// Numbers of intervals that resolve displacement and shape in output.
    GridIntervals output_degrees = degrees;
    /// Degrees p for strain recovery: strains are superconvergent at p Gauss
    /// points. 0 along coordinates in which strains are smooth across elements
    /// (section, Taylor theories).
    GridIntervals recovery_degrees = degrees;
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

  /// Position, scale and hierarchical level of a DoF.
  struct DofInfo
  {
    /// Position of the node, scene axes, for messages.
    dealii::Point<3> position;
    /// Largest displacement due to a unit value of the DoF, up to a factor of
    /// order one, to scale DoFs of different units.
    double scale = 1.;
    /// Level in the hierarchical basis of the section
    /// (doc/theory/stable-basis.md): 0 for rigid motions, higher for finer
    /// functions; 0 for nodal bases. Supports eliminate DoFs of low level
    /// first, for stability.
    unsigned int level = 0;
  };

  /// Largest displacement and rotation in a vector of DoFs.
  struct DofMagnitude
  {
    /// Largest product of a DoF and its DofInfo::scale [length]; unscaled
    /// unless the DoFs include rotations.
    double displacement = 0.;
    /// Largest nodal rotation [rad]; 0 unless the DoFs include rotations.
    double rotation = 0.;
  };

  /// Displacement u = 0 as an empty vector. Functions of Body with an argument
  /// u then return what belongs to the undeformed body, linearized there.
  inline const Vector undisplaced;

  /// Rigid motion: translations along x, y, z [length], rotations [rad].
  using RigidMotion = std::array<double, 6>;

  /// Interface of a discretized elastic body: DoFs, stiffness, points and
  /// surfaces, without boundary conditions. Positions are in scene axes.
  /// Displacements are arguments, which bodies of linear kinematics ignore; the
  /// body stores none. A "row" is a linear functional of the DoFs, such as a
  /// displacement component at a point.
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

    /// Returns position, scale and level of @p dof.
    virtual DofInfo
    dof(const DofIndex dof) const = 0;

    /// Returns the homogeneous constraints of the discretization: Kirchhoff's
    /// constraint in Euler-Bernoulli theory or hanging nodes. The linear solver
    /// applies them; the stiffness matrix and rows() do not include them.
    virtual const Constraints &
    kinematic_constraints() const;

    /// Returns the six rigid motions of the body with the displacement u(X):
    /// unit translations and rotations along and about scene axes,
    ///   e_m,   e_m x (X + u(X) - center()),   m = x, y, z.
    /// They span the null space of the stiffness at u. Linear bodies ignore @p
    /// u. Displacements that the theory lacks (omitted_rigid_motions()) are
    /// zero.
    virtual std::vector<Vector>
    rigid_motions(const Vector &u) const = 0;

    /// Returns true if the kinematics has finite rotations: internal forces are
    /// nonlinear, stresses refer to rotated axes, and rows() of strains and
    /// stresses do not exist.
    virtual bool
    has_finite_rotations() const
    {
      return false;
    }

    /// Returns true if the DoFs include finite rotations. Displacements are
    /// then nonlinear in the DoFs: rows() depend on u.
    virtual bool
    constraints_rotate() const
    {
      return false;
    }

    /// Returns the DoFs @p u updated by the increment @p change, by default the
    /// sum; rotational DoFs are composed.
    virtual Vector
    retract(const Vector &u, const Vector &change) const;

    /// Returns largest displacement and rotation of the DoFs @p u or of an
    /// increment of them; by default the maximum norm of @p u.
    virtual DofMagnitude
    magnitude(const Vector &u) const
    {
      return {u.linfty_norm(), 0.};
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

    /// Returns the bounding box of the undeformed nodes, scene axes; by default
    /// of the corners of all elements.
    virtual dealii::BoundingBox<3>
    bounding_box() const;

    // ---- mechanics

    /// Adds the internal forces to @p f, f += integral B^T sigma(B u) dV, which
    /// is f += K u for a linear body. They are computed from strains, since
    /// rounding of an assembled matrix loses the bending energy of slender
    /// bodies (doc/theory/stable-basis.md). This default implementation is for
    /// linear bodies that are not slender: it multiplies the stiffness blocks.
    /// Collective.
    virtual void
    add_internal_forces(const Vector &u, Vector &f) const;

    /// Adds the product K(u) w of the tangent stiffness K(u) to @p f, which is
    /// add_internal_forces(w, f) for a linear body. Collective.
    virtual void
    add_tangent_forces(const Vector &u, const Vector &w, Vector &f) const;

    /// Returns strain energy and largest rotation of @p u. By default, uses the
    /// work of internal forces for the energy, and curl u of an interpolant
    /// with Cells::output_degrees for the rotation. Collective.
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

    /// Adds the thermal load at the displacement @p u, f += integral (dE/du)^T
    /// C epsilon_0 dV with the thermal strain epsilon_0 and the strain E:
    /// Green's strain for finite rotations, otherwise the linear strain, dE/du
    /// = B. Returns the energy integral epsilon_0 . C epsilon_0 / 2 dV if @p u
    /// is `undisplaced`. This default implementation is for linear bodies and
    /// has one Gauss point more than Cells::output_degrees per coordinate.
    /// Collective.
    virtual double
    add_thermal_load(const Vector &u, Vector &f) const;

    /// Calls @p use with this process's blocks of the derivative by u of the
    /// forces of add_thermal_load(); no blocks for linear bodies.
    virtual void
    for_each_thermal_block(const Vector & /*u*/,
                           const BlockCallback & /*use*/) const
    {}

    /// Adds the load vector of the weight to @p f, f . u = integral rho g . u
    /// dV with the density rho and g = @p acceleration [length / s^2], the
    /// product of the mass matrix and a rigid acceleration. Throws InputError
    /// if a ply has no density. Collective.
    void
    add_weight(const dealii::Tensor<1, 3> &acceleration, Vector &f) const;

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
    /// of an increment of the DoFs @p u: three displacements in scene axes, or
    /// six strains or stresses (xx, yy, zz, xy, xz, yz) in the axes @p frame,
    /// means over all elements at the location. Displacement functionals are
    /// the derivatives of displacements(); linear bodies ignore @p u. Strains
    /// and stresses are always those of linear theory. Stresses of heated plies
    /// have the constant -C epsilon_0.
    virtual std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Vector                &u,
         const Quantity               quantity = Quantity::displacement,
         const Frame                  frame    = Frame::scene) const = 0;

    /// Returns the rotation matrix of the section at @p location for the DoFs
    /// @p u; by default the identity.
    virtual dealii::Tensor<2, 3>
    rotation_at(const Location &location, const Vector &u) const;

    /// Returns the displacements [length, scene axes] at @p locations for the
    /// DoFs @p u; by default the values of rows().
    virtual std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const;
    /// Calls @p use with symmetric blocks of this process's elements that sum
    /// to the load stiffness of the point @p forces F_k at @p locations, the
    /// derivative by u of the nodal forces sum_k rows()^T F_k. No blocks by
    /// default.
    virtual void
    for_each_block_of_forces(
      const std::vector<Location> & /*locations*/,
      const std::vector<dealii::Tensor<1, 3>> & /*forces*/,
      const Vector & /*u*/,
      const BlockCallback & /*use*/) const
    {}

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

    /// Returns Cells::recovery_degrees of the element with the given index.
    virtual GridIntervals
    recovery_degrees_of(const unsigned int) const
    {
      return cells().recovery_degrees;
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

    /// Returns the fields of @p u on the cross-section at the distance
    /// @p position from the start of the axis, at (n + 1)^2 points per element,
    /// on every process. Between two axis elements, fields are means over both.
    virtual std::vector<OutputCell>
    cut(const double position, const unsigned int n, const Vector &u) const;

    /// A callback with the index of an element in this process and its fields.
    using OutputCellCallback =
      std::function<void(const unsigned int, const OutputCell &)>;

    /// Calls @p use once for each element of this process, in any order, with
    /// the fields of @p u on a regular grid of @p n intervals.
    virtual void
    for_each_output_cell(const GridIntervals      &n,
                         const Vector             &u,
                         const OutputCellCallback &use) const;

    // ---- solvers

    /// Calls @p use with the blocks of this process that sum to the
    /// unconstrained tangent stiffness K(u) of the internal forces. If the last
    /// Newton @p correction is not empty, the geometric stiffness uses stresses
    /// linearized at the previous iterate (predicted_strain()). If @p
    /// with_values is false, blocks have only DoFs (sparsity pattern). Linear
    /// bodies ignore @p u and @p correction.
    virtual void
    for_each_stiffness_block(const Vector        &u,
                             const Vector        &correction,
                             const bool           with_values,
                             const BlockCallback &use) const = 0;

    /// Calls @p use with the blocks of this process that sum to the mass matrix
    /// M = int rho R^T R dV, with the displacement functionals R = rows(.., @p
    /// u) and the density rho [force s^2 / length]. If @p with_values is false,
    /// blocks have only DoFs. Throws as densities() does. This default
    /// implementation has one Gauss point more than Cells::output_degrees per
    /// coordinate; beams have Kronecker products.
    virtual void
    for_each_mass_block(const Vector        &u,
                        const bool           with_values,
                        const BlockCallback &use) const;

    /// Returns a solver for the sum of @p terms with the homogeneous
    /// @p constraints, which must include kinematic_constraints(). @p monitor
    /// is called after assembly, and with the size of the matrix factor. Throws
    /// NumericsError with a position in the scene if the matrix is not positive
    /// definite, InputError as solver_kind() does. Collective.
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
    /// Returns the temperature change at @p x (scene axes) [K]; 0 by default.
    double
    temperature(const dealii::Point<3> &x) const
    {
      return temperature_change ? temperature_change(x) : 0.;
    }

    const Placement placement; ///< Position and axes of the body in the scene.

  private:
    std::string body_name;
    ScalarField temperature_change;
  };

  /// The bodies of a scene; block b of a BlockVector has the DoFs of body b.
  using Bodies = std::vector<std::unique_ptr<Body>>;
} // namespace lamella

#endif
