// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `body`: what all bodies have in common, and the two that there are.
// It owns Body, the only face that other rooms see, the beam (an axis times a
// section), the solid (hexahedra on the same section mesh), where they stand in
// the scene, and the fields at their points. A body never knows what holds or
// touches it: no supports, no contact.
//
// Where to start reading: Body is the interface, Location and Row (base/row.h)
// are the two words that everything said to a body is made of. "Put a force at
// this point", "hold this edge", "how far are these surfaces apart" all become
// Body::locate(), which finds the elements that hold a point, and Body::rows(),
// which gives the displacement there as a linear functional of the body's DoFs.

#ifndef lamella_body_body_h
#define lamella_body_body_h

#include <lamella/base/row.h>
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

  /// What rows and samples can speak of: the three fields of linear elasticity,
  /// u, epsilon = D u (Eq. 5) and sigma = C (epsilon - epsilon_0) (Eq. 6 with
  /// the law's initial strain epsilon_0).
  enum class Quantity
  {
    displacement, ///< three components, scene axes
    strain,       ///< six, order of Eq. 4, engineering shear strains
    stress        ///< six, order of Eq. 4
  };

  /// The axes that a strain or a stress is given in. Displacements are always
  /// in those of the scene.
  enum class Frame
  {
    scene, ///< x, y, z of the scene, whatever the body's placement
    ply ///< 1 along the fibre, 2 across, 3 normal to the ply: 11,22,33,12,13,23
  };

  /**
   * A point of a body on one side of its ply interfaces: the answer to "which
   * element holds x, and where in it". Where elements of the same ply meet it
   * has a place in each of them, and stands for their mean: displacements agree
   * there, strains and stresses of a finite-element space do not.
   *
   * Elements of different plies are never averaged. In an interface sigma_xx,
   * sigma_yy and sigma_xy of a laminate jump, and rightly so; a point of it has
   * one location a ply (Body::locate).
   *
   * Plain numbers: a location stays good as long as the body's mesh, which
   * never changes.
   */
  struct Location
  {
    struct Place
    {
      /// The element, as the body numbers them: of a beam axis element times
      /// section cell (class Beam), of a solid the hexahedron.
      unsigned int cell;
      /// Where on its unit cube, (xi, place along the axis, eta) in [0, 1]^3:
      /// the first and the last are those of the section's cell, for beams and
      /// solids alike.
      dealii::Point<3> unit;
    };
    /// The point that was asked for, scene axes. Where it lies beyond a curved
    /// edge its places may be a little beside it.
    dealii::Point<3> position;
    /// The ply that all places belong to, a number in the section mesh's plies.
    unsigned int ply = 0;
    /// At least one.
    std::vector<Place> places;
  };

  /**
   * All fields at a location, as probes, lines, cuts and pictures show them:
   * the means over its places. They come of the displacements by the law of the
   * ply there, sigma = C (epsilon - epsilon_0); nothing is smoothed or
   * recovered here (recover/recovery.h does that).
   */
  struct FieldSample
  {
    /// In the scene's axes; a length.
    dealii::Tensor<1, 3> displacement;
    /// In the scene's axes, order of Eq. 4, {xx, yy, zz, xy, xz, yz}; the last
    /// three of the strain are engineering shear strains, gamma = 2 epsilon.
    Voigt strain, stress;
    /// The stress in the ply's own axes, {11, 22, 33, 12, 13, 23}: what
    /// strengths are compared with.
    Voigt ply_stress;
    /// R, which turns with the material: of a body that turns `stress` is
    /// R^T sigma R of Cauchy's sigma, in the scene's axes.
    Triad turn = dealii::unit_symmetric_tensor<3>();
    /// The largest difference of stress between the places of the location over
    /// the largest stress there, Euclidean norms: what the mesh leaves open.
    double jump = 0.;
  };

  /**
   * A point of a body's surface, with what collocation asks for there: the
   * normal n_1 of the gap function (Eqs. 14 to 17), the area that a nodal force
   * is spread over, and how stiff the body is below. Where the point comes from
   * surface_points() it is a node, where it comes from surface_point() any
   * place of a facet.
   */
  struct SurfacePoint
  {
    /// In the undeformed scene.
    dealii::Point<3> position;
    /// Unit length, outward, scene axes; at a node where several sides meet the
    /// mean of theirs, weighted by area. (A beam keeps the points of different
    /// named surfaces apart, even where they are at one place.)
    dealii::Tensor<1, 3> normal;
    /// The tributary area of a node (length^2), or at a place of a facet the
    /// area per unit of its square, |dX/ds x dX/dt|, still to be multiplied
    /// with a quadrature weight.
    double area = 0.;
    /// Whether sides of different normals, by some 20 degrees and more, meet
    /// there: a normal displacement or a gap has no direction at such a node.
    bool corner = false;
    /// The same point for rows() and sample(): one place, in the cell below.
    Location location;
    /**
     * What the automatic penalty is made of, a column of material below the
     * point with the stiffness E_n A / d (contact/enforcement.h):
     * E_n = (n n) : C : (n n), the modulus of confined compression along n in
     * the ply there (force / length^2), and the depth d of the cell below,
     * normal to the surface (length).
     */
    double normal_modulus = 0., depth = 0.;
  };

  /**
   * One side of one cell of a body: a piece of its surface that is the image of
   * the unit square under one polynomial map. The point (s, t) of the square is
   * the point origin + s along_s + t along_t of the cell's unit cube.
   *
   * On a lateral surface s goes along the edge of the section and t along the
   * axis; on the ends s and t are the two coordinates of the section. Whether
   * (along_s) x (along_t) points out of the body or into it depends on the
   * side: take the normal from Body::surface_point() or FacetMap::outward().
   *
   * Plain numbers, as a location: surface integrals of loads and of mortar
   * contact are sums over facets, each by its own quadrature.
   */
  struct SurfaceFacet
  {
    /// As Location::Place::cell.
    unsigned int cell = 0;
    /// Of the unit cube: its corner that is (0, 0), and two of its axes.
    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> along_s, along_t;
    /// Where (0, 0), (1, 0), (0, 1) and (1, 1) are, scene axes.
    std::array<dealii::Point<3>, 4> corners;
    /// The degree of the expansion in s and in t: what a grid of nodes has.
    unsigned int degree_s = 0, degree_t = 0;
    /// Positions and displacements are polynomials of these degrees in s and in
    /// t: more than the above where a Taylor expansion meets a curved side.
    unsigned int trace_degree_s = 0, trace_degree_t = 0;
  };

  struct Ply;
  struct SurfaceTopology;

  /// A number at each point of the scene.
  using ScalarField = std::function<double(const dealii::Point<3> &)>;

  /// How many intervals a grid on an element's unit cube has along each of its
  /// coordinates: xi of the section, that of the axis, the other one of the
  /// section (Location::Place::unit).
  using GridIntervals = std::array<unsigned int, 3>;

  /**
   * The elements of a body by number, as all see them that look at elements and
   * not at points: pictures, cuts, lines, the recovery of strains. What there
   * is at a place of an element Body::position(), Body::ply_at() and
   * Body::sample() say.
   */
  struct Cells
  {
    /// How many the body has on all processes together.
    unsigned int n = 0;
    /// Those of this process, the first and one past the last.
    std::pair<unsigned int, unsigned int> own;
    /// The degrees of the displacements within an element along its unit
    /// coordinates, each at least 1. Where elements differ, the largest.
    GridIntervals degrees{{1, 1, 1}};
  };

  /// The ply that a place lies in, a number in Body::plies(), and its axes
  /// there in those of the body, a row each (Ply::axes()).
  struct PlyAt
  {
    unsigned int ply = 0;
    Triad        axes;
  };

  /**
   * An element of a body for pictures: fields on a regular grid of its unit
   * cube, or on the layer of it that a cut goes through. The coordinate xi of
   * the section runs fastest, then that of the axis, then the other one of the
   * section.
   *
   * Elements do not share points: stresses differ from side to side, and a
   * picture should show that.
   */
  struct OutputCell
  {
    /// The element's ply, and the directions of its fibres and of its normal,
    /// those of its own plane (unit length, scene axes); of a ply in a curved
    /// wall those in the element's middle.
    unsigned int         ply = 0;
    dealii::Tensor<1, 3> fibre, ply_normal;
    /// Undeformed, scene axes; as many samples as positions.
    std::vector<dealii::Point<3>> positions;
    std::vector<FieldSample>      samples;
  };

  /// What a displacement field does to a body as a whole: one number for the
  /// energy balance, one for the limits of geometrical linearity.
  struct Deformation
  {
    /// integral epsilon . C epsilon / 2 dV (force times length): the strain
    /// energy where no heat strains the body, and half the work of all forces
    /// on it, those of heat (Body::add_heat()) among them (Clapeyron). Of a
    /// body that turns less integral epsilon . C epsilon_0 dV.
    double energy = 0.;
    /// The largest |curl u| / 2 at the integration points, in rad. The theory
    /// is that of small rotations; solve/checks.h warns or fails beyond them.
    /// Of a body that turns (Body::turns()) the largest angle.
    double max_rotation = 0.;
    /// Of a body that turns the largest principal value of Green's strain, the
    /// largest root mean square over a section of that along the axis, and,
    /// where fields follow the turn, the largest one from one end of an element
    /// to the other [rad].
    double max_strain = 0., max_mean_strain = 0., max_element_turn = 0.;
    /// Of sections that turn as a whole by what share, largest along the axis,
    /// their moments and torques leave out what bending and twisting do to
    /// their shape (stiffening_by_shape(), less what the law has of it).
    double shape_change = 0.;
  };

  /// A rigid motion as amplitudes: three translations along the scene's axes
  /// (length) and three rotations about them (rad) through Body::centre().
  using RigidMotion = std::array<double, 6>;

  /**
   * A linear elastic body as a discretised boundary-value problem without its
   * boundary conditions: DoFs, a stiffness, rows at its points, points on its
   * surfaces. Supports, loads, contact and reports see nothing else of it, so
   * they do not know whether it is a beam or a solid. All positions are those
   * of the scene. A body takes displacements as an argument and stores none.
   *
   * What follows from the principle of virtual displacements (Eqs. 8 to 12) is
   * split accordingly. The body owns the left-hand side,
   *   delta L_int = delta u . K u,   K = int B^T C B dV,
   * where epsilon = B u at a point is what rows(.., Quantity::strain) gives.
   * The right-hand side is made by others of rows: a force P at X is
   *   f_k += sum_c P_c r_c,k   with   u_c(X) = sum_k r_c,k u_k
   * (Row::add_to), a prescribed displacement is r_c(u) = value, a gap of two
   * bodies the difference of their rows along a normal (Eq. 16).
   *
   * The functions come in groups by those who call them, in this order: DoFs
   * and rigid motions (supports, and whoever solves); mechanics (`solve`);
   * points, rows and samples (conditions, contact, recovery); surfaces (the
   * same three); elements (recovery and reports); solvers (`solve`).
   *
   * A new kind of body has to write those that are pure, as few as say what it
   * is: its DoFs, how it answers a displacement, the map of an element and the
   * rows there, how its surface hangs together. All others follow from these,
   * by code that is written once, here, and are written again only where a body
   * knows a shorter way.
   *
   * Where several processes run, each holds the same body and whole vectors.
   * Those functions that share work are collective, which is said at each:
   * all processes call them with the same arguments. The others communicate
   * nothing and say the same everywhere.
   *
   * Vectors u and f have n_dofs() entries. The product u . f is a work, force
   * times length, whatever the single DoFs mean.
   */
  class Body
  {
  public:
    /// @p name is the scene's, for messages; @p placement says where the body
    /// stands.
    explicit Body(std::string name, const Placement &placement = {});
    virtual ~Body();

    // ---- DoFs and rigid motions

    const std::string &
    name() const
    {
      return body_name;
    }

    /// Where the body stands in the scene: y of its axes is the position along
    /// it (cut()).
    const Placement &
    place() const
    {
      return placement;
    }

    /// The structural theory, as the user writes it, and what the mesh has of
    /// it: `LE-2, 20 B4`, `solid-2, 720 hexahedra`. For messages and tables;
    /// nothing is decided by it.
    virtual std::string
    theory() const = 0;

    /// Of the unconstrained body, on all processes together.
    virtual DofIndex
    n_dofs() const = 0;

    /// An estimate of the non-zeros of the stiffness from above, known before
    /// it is assembled. Here the sum over all blocks; bodies know better. A
    /// double, since products of sizes overflow integers before memory is
    /// asked for. Collective.
    virtual double
    stiffness_entries() const;

    /// Whether DoF 3 i + c is the displacement component c at node i. Only then
    /// does algebraic multigrid understand the matrix, and `cg` is offered. Not
    /// so of a beam, whose DoFs are amplitudes of fields of its section.
    virtual bool
    is_nodal() const
    {
      return false;
    }

    /// The DoFs whose rows of the stiffness this process keeps: contiguous, and
    /// all of them where there is one process. The processes' sets follow upon
    /// each other and do not overlap.
    virtual dealii::IndexSet
    owned_dofs() const
    {
      return dealii::complete_index_set(n_dofs());
    }

    /**
     * The place of @p dof in the hierarchy of the basis (doc/stable-basis.md):
     * 0 for DoFs that hold the rigid motions, higher for finer ones. Supports
     * eliminate coarse DoFs first and so leave the hierarchy intact, which is
     * what keeps the digits of slender beams. 0 for all DoFs of a nodal basis.
     */
    virtual unsigned int
    dof_level(const DofIndex) const
    {
      return 0;
    }

    /// For each DoF the largest displacement of the body that a unit of it
    /// makes, but for a factor of order one: what makes weights of rows that
    /// belong to DoFs of different kinds comparable. 1 for all DoFs of a nodal
    /// basis.
    virtual std::vector<double>
    dof_sizes() const
    {
      return std::vector<double>(n_dofs(), 1.);
    }

    /// Where @p dof is at home, for messages: of a beam the place of its node
    /// on the axis.
    virtual dealii::Point<3>
    dof_position(const DofIndex dof) const = 0;

    /**
     * What the theory itself ties together, whatever the supports:
     * displacements of the body satisfy these homogeneous constraints. They are
     * closed; the stiffness blocks and the rows below are those of the
     * unconstrained DoFs, and whoever solves applies the constraints first
     * (Row::reduced). Kirchhoff's of EBBT, the hanging nodes of a refined
     * solid, none otherwise.
     */
    virtual const Constraints &
    kinematic_constraints() const;

    /**
     * The six rigid motions as displacement vectors, three unit translations
     * along the scene's axes and three unit rotations about them through the
     * centre,
     *   u(X) = e_m,   u(X) = e_m x (X - centre()),   m = x, y, z.
     * They span the null space of the stiffness: what supports have to hold,
     * and what multigrid has to keep. Of one that the theory does not contain
     * (missing_motions()) the vector holds the part that it does.
     */
    virtual std::vector<Vector>
    rigid_motions() const = 0;

    /// The same of the body where @p u has moved it, for forces whose moments
    /// are those about places where they act now,
    ///   e_m   and   e_m x (X + u - centre()).
    /// Here, where displacements are small, rigid_motions().
    virtual std::vector<Vector>
    rigid_motions_at(const Vector &) const
    {
      return rigid_motions();
    }

    /// Whether the body turns by any angle: its internal forces are not linear
    /// in displacements and act where these have moved it, and strains and
    /// stresses of samples are in axes that turn with the material. Rows of
    /// strains and stresses it has none.
    virtual bool
    turns() const
    {
      return false;
    }

    /// Whether rows of displacements depend on the state (rows_at()), which is
    /// then no sum of changes (updated()): of bodies with rotations as DoFs.
    virtual bool
    rows_turn() const
    {
      return false;
    }

    /// The state that @p change makes of the state @p u. Here the sum.
    virtual Vector
    updated(const Vector &u, const Vector &change) const;

    /// The largest rotation among those DoFs of @p change that are rotations
    /// [rad]; here there are none.
    virtual double
    largest_spin(const Vector &) const
    {
      return 0.;
    }

    /// Those rigid motions that the theory's displacements do not contain (EBBT
    /// and TBT cannot turn about their axis): nothing needs to hold them, and
    /// no couple about them does work.
    virtual std::vector<RigidMotion>
    missing_motions() const
    {
      return {};
    }

    /// The point that rigid rotations turn about and moments are taken about,
    /// scene axes: of a beam the section's centre of area half way along the
    /// axis, of a solid the middle of the box around its nodes. Here that of
    /// bounding_box().
    virtual dealii::Point<3>
    centre() const;

    /// Half the largest extension, here of bounding_box(): the length that
    /// makes a rotation comparable with a translation. A scale for tolerances,
    /// no measure.
    virtual double
    size() const;

    /// Of the undeformed body, its sides along the scene's axes. It goes by
    /// vertices or nodes, so curved edges may leave it a little.
    virtual dealii::BoundingBox<3>
    bounding_box() const = 0;

    // ---- mechanics

    /**
     * f += integral B^T sigma(B u) dV, strain first: the rounding is that of
     * the strains and not that of the entries of an assembled matrix, which
     * loses the bending energy of slender bodies (doc/stable-basis.md).
     * Residuals, reactions and the iterative refinement of solutions all go
     * this way; in exact arithmetic it is f + K u.
     *
     * No constraints are applied: the entries of @p f at constrained DoFs are
     * those of the forces that act there. @p u and @p f are whole, on every
     * process the same. Collective.
     */
    virtual void
    add_internal_forces(const Vector &u, Vector &f) const = 0;

    /// The strain energy of @p u and the largest rotation in it. Here the work
    /// of the internal forces, and curl u of the displacements at a grid of
    /// picture_degrees() in each element, which is theirs if they are
    /// isoparametric. Collective; all processes get the same.
    virtual Deformation
    deformation(const Vector &u) const;

    /// What the linear strain leaves out at the displacement @p u, which is not
    /// kept. Refers to the body. Collective.
    virtual std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const = 0;

    /**
     * From now on the body is warmer than without stress by @p change [K], a
     * function of the scene, in the place of what it was before: each ply has
     * the initial strain epsilon_0 = alpha T, alpha its Ply::expansion(), which
     * samples and rows know. It is part of the body, as its materials are, and
     * does not grow with the load factor. Throws InputError for a ply whose
     * material has no expansion and for a theory that cannot be heated.
     */
    virtual void
    heat(const ScalarField &change);

    bool
    is_heated() const
    {
      return bool(temperature_change);
    }

    /// f += integral B^T C epsilon_0 dV: what heat does, as the load that makes
    /// the same displacements; no resultant. By the points that integrate the
    /// stiffness. Returns integral epsilon_0 . C epsilon_0 / 2 dV, the energy
    /// of the body when it is heated and held. Zero if nobody heats it. Here by
    /// rows at Gauss points, one more than picture_degrees() along each
    /// coordinate. Collective.
    virtual double
    add_heat(Vector &f) const;

    /// Of a body that turns by any angle, what heat does in the state @p u,
    /// f += integral (dE/du)^T C epsilon_0 dV, that of add_heat() at rest; and
    /// blocks that sum to its derivative, symmetric (along geodesics, of
    /// rotations). Here the derivative is constant, as that of Green's strain
    /// is, and none.
    virtual void
    add_heat_at(const Vector &u, Vector &f) const;
    virtual void
    for_each_block_of_heat(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// f += integral of rho g . u dV, g = @p acceleration in scene axes
    /// [length/s^2]. Throws InputError for a ply whose material has no density.
    /// Here by rows, as add_heat(). Collective.
    virtual void
    add_weight(const dealii::Tensor<1, 3> &acceleration, Vector &f) const;

    /// The same weight as forces at points, an element at a time: @p use is
    /// called with places and forces (scene axes), which live no longer. This
    /// process's share of the elements. Throws InputError likewise.
    using UseOfForces =
      std::function<void(const std::vector<Location> &,
                         const std::vector<dealii::Tensor<1, 3>> &)>;
    void
    for_each_cell_by_weight(const dealii::Tensor<1, 3> &acceleration,
                            const UseOfForces          &use) const;

    /// The homogeneous parts of the body's section.
    virtual const std::vector<Ply> &
    plies() const = 0;

    // ---- points, rows and samples

    /**
     * The places of each point, by point and by ply: one location a ply, plies
     * ascending, and none for a point outside of the body. @p points are of the
     * undeformed scene.
     *
     * Tolerances (of beams 1e-6 of the section's smaller extent) are far above
     * the rounding of positions, and far below any element. Beyond a curved
     * edge, which the mesh interpolates, a point counts as on the body within
     * 2 % of the size of the cell.
     */
    virtual std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const = 0;

    /**
     * For each location the rows of @p quantity, functionals of this body's
     * DoFs (base/row.h): three for displacements, scene axes, and six for
     * strains and stresses, order of Eq. 4, in the axes of @p frame, which
     * displacements ignore. Of a location with several places they are the
     * means of those of the places. The rows of a stress have the constant
     * -C epsilon_0 of the ply's law where heat strains it (and those of a
     * strain what the theory completes there); all others have none.
     *
     * Entries are sorted by DoF. Shape functions that vanish but for rounding,
     * as those of all other nodes do at a node, have none, so that rows there
     * are short.
     */
    virtual std::vector<std::vector<Row>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const = 0;

    /// R of the section at @p location in the state @p u, in scene axes: what
    /// rows turn by. Here 1, as none do.
    virtual dealii::Tensor<2, 3>
    turn_at(const Location &location, const Vector &u) const;

    /// The displacements at @p locations in the state @p u [length], scene
    /// axes, and of a change of the state the rows that give theirs. Here
    /// those of rows(), whatever the state.
    virtual std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const;
    virtual std::vector<std::vector<Row>>
    rows_at(const std::vector<Location> &locations, const Vector &u) const;

    /// Calls @p use with blocks that sum to the derivative of what @p forces
    /// do at @p locations (scene axes) in the state @p u, sum over k of
    /// rows_at()^T F_k: symmetric, that along geodesics of rotations. Here
    /// none, as the rows do not change.
    virtual void
    for_each_block_of_forces(
      const std::vector<Location>                       &locations,
      const std::vector<dealii::Tensor<1, 3>>           &forces,
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// All fields of the displacement @p u at @p location, the means over its
    /// places and how much these differ. The numbers are those of rows(), which
    /// are asked here; bodies have them at less cost, six stresses at once.
    virtual FieldSample
    sample(const Location &location, const Vector &u) const;

    /// Where @p place is, scene axes: the map of an element's unit cube. With
    /// locate() it gives an element's neighbours: those that have a place at
    /// one of its corners.
    virtual dealii::Point<3>
    position(const Location::Place &place) const = 0;

    /// The ply of the element there.
    virtual PlyAt
    ply_at(const Location::Place &place) const = 0;

    // ---- surfaces

    /// Names that the functions below take: the named boundaries of the
    /// section, swept along the axis, then the two sections `start` and `end`,
    /// both of them as `ends`, and `all`, the whole surface. Who takes a name
    /// from a user compares it with these: of an unknown one there are simply
    /// no points.
    virtual std::vector<std::string>
    surfaces() const = 0;

    /// The facets that @p surface is made of, without gaps and overlaps, and
    /// the nodes that they share, by the body's own numbers
    /// (body/surface_topology.h): what makes nodal functions on the surface
    /// continuous.
    virtual SurfaceTopology
    surface_topology(const std::string &surface) const = 0;

    /**
     * The point of @p facet, one of this body's, at (s, t) = @p st in [0, 1]^2;
     * its area is the area per unit of the square, |dX/ds x dX/dt|, so that
     *   int f dA = int_0^1 int_0^1 f area ds dt.
     * Callers with many points take a FacetMap instead.
     */
    virtual SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const = 0;

    /// The facets of surface_topology() alone: the cells of surface integrals.
    virtual std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const;

    /**
     * Points that fix the trace on @p surface, with outward normals and
     * tributary areas: int N_i F_tau dA of the nodal functions there, which sum
     * to the area (on the ends of a beam with curved edges only nearly). Where
     * node-to-node contact (the paper's Sec. 3.3) is collocated, and supports
     * of the normal displacement. Here the nodes of the facets' grids; one that
     * hangs between two others gives them its area, half each.
     */
    virtual std::vector<SurfacePoint>
    surface_points(const std::string &surface) const;

    /// Locations that fix the displacement on @p surface, as few as that takes:
    /// with u given at all of them it is given on the whole surface. What a
    /// support that prescribes u there is made of. Here the nodes of the
    /// facets' traces that hang nowhere.
    virtual std::vector<Location>
    fixing_points(const std::string &surface) const;

    /// Locations that fix the displacement of the whole body. Here the
    /// Gauss-Lobatto grid of each element, of the degrees of cells(): points
    /// that elements share come from each of them.
    virtual std::vector<Location>
    body_points() const;

    // ---- elements

    /// The elements by number.
    virtual Cells
    cells() const = 0;

    /**
     * How the recovery of strains sees an element (recover/recovery.h): for
     * each unit coordinate the degree p of the displacements, whose derivatives
     * are best at the p Gauss points (superconvergence). Zero along a
     * coordinate in which one expansion spans all elements, so that strains are
     * smooth there and leave nothing to recover: across the section of Taylor
     * theories. The order is that of Location::Place::unit. Here those of
     * cells().
     */
    virtual std::array<unsigned int, 3>
    recovery_degrees() const
    {
      return cells().degrees;
    }

    /// The same of the element @p cell where elements differ: at most the above
    /// and zero along the same coordinates.
    virtual std::array<unsigned int, 3>
    recovery_degrees_of(const unsigned int) const
    {
      return recovery_degrees();
    }

    /**
     * The parameters in [0, 1], ascending, where the segment from @p a to @p b
     * crosses from element to element, its ends among them: between two of them
     * the displacement along it is one polynomial. Scene axes. Curved edges of
     * the section count as straight here, from vertex to vertex. Here where it
     * meets the sides of elements, each the bilinear surface through its
     * corners. Bodies follow curved edges.
     */
    virtual std::vector<double>
    line_breaks(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /// The polynomial degree of displacements along the segment from @p a to
    /// @p b within an element: on a skew line the sum of those it runs along,
    /// since the functions are products. Zero only where a equals b. Here those
    /// of cells(), whose unit coordinates follow the axes of the body.
    virtual unsigned int
    line_degree(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /// Points of the segment from @p a to @p b that fix the displacement there:
    /// line_degree() + 1 Gauss-Lobatto points between each two of its
    /// line_breaks(), those at breaks once. In the order of the segment. It
    /// must have a length.
    std::vector<dealii::Point<3>>
    line_points(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /**
     * The section at @p position (a length from the start of the axis), element
     * by element, with the fields of @p u on (n + 1) x (n + 1) points each, for
     * contours. Where it lies between two elements along the axis the fields
     * are the means of both, with their jump. Empty if @p position is outside
     * of the body. The whole section on every process. Here the second unit
     * coordinate of an element runs along the axis, its two sides across.
     */
    virtual std::vector<OutputCell>
    cut(const double position, const unsigned int n, const Vector &u) const;

    /// The degrees of the displacements within an element along each of its
    /// unit coordinates, and of its shape where that is more: as many intervals
    /// as a picture of it needs. At least 1. Here those of cells().
    virtual GridIntervals
    picture_degrees() const
    {
      return cells().degrees;
    }

    /// What is done with an element: its number among those of this process,
    /// and what is on it, which is good until the next one.
    using UseOfOutputCell =
      std::function<void(const unsigned int, const OutputCell &)>;

    /// Calls @p use with each element of this process once, in any order, with
    /// the fields of @p u on a grid of @p n, each at least 1. The elements of
    /// all processes are those of the body. Nothing is averaged, and no jump is
    /// known. One element is in memory at a time.
    virtual void
    for_each_output_cell(const GridIntervals   &n,
                         const Vector          &u,
                         const UseOfOutputCell &use) const;

    /// The same elements by their numbers, with (n + 1)^3 points each.
    std::vector<OutputCell>
    output_cells(const unsigned int n, const Vector &u) const;

    // ---- solvers

    /**
     * What @p asked means for this body and this number of processes, never
     * `automatic`: that one is `cg` for nodal bodies of more than 300000 DoFs,
     * whose factor would take tens of gigabytes, else CHOLMOD on one process
     * and MUMPS on several. (A beam of dense lists has a way of its own on one
     * process: Beam::solver_of().) Throws InputError where it is not offered:
     * `cholmod` on several processes, `cg` for a body that is not nodal.
     */
    SolverKind
    solver_kind(const SolverKind asked) const;

    /// What the stiffness is assembled from: blocks without constraints, and
    /// the terms k r^T r of @p springs, whose rows are of this body. Refers to
    /// the body, which must outlive it.
    StiffnessTerms
    stiffness_terms(const std::vector<SpringTerm> &springs = {}) const;

    /**
     * The stiffness with @p springs, condensed by the homogeneous part of
     * @p constraints (constrained DoFs keep a positive diagonal and nothing
     * else), for a solver as @p asked. With u = T v + u_0, where v are the free
     * DoFs and u_0 is a particular solution, it is
     *   T^T (K + sum k r^T r) T.
     * @p constraints are those of the supports with the kinematic ones, closed.
     * Throws InputError as solver_kind() does. Collective.
     */
    std::unique_ptr<StiffnessMatrix>
    assembled_stiffness(const Constraints             &constraints,
                        const std::vector<SpringTerm> &springs = {},
                        const SolverKind asked = SolverKind::automatic) const;

    /**
     * What solves with that matrix, solver_of(). Here it is assembled,
     * factorised (or prepared for iterations), and dropped where its solver
     * does without; a body that knows the structure of its matrix may never
     * assemble it.
     * @p monitor is told when it is there and how large a factor becomes; what
     * it throws passes through. Throws NumericsError if the matrix is not
     * positive definite, with the place in the scene where that shows first,
     * and InputError as solver_kind() does. Collective.
     */
    std::unique_ptr<LinearSolver>
    make_solver(const Constraints             &constraints,
                const std::vector<SpringTerm> &springs = {},
                const SolverKind               asked   = SolverKind::automatic,
                const SolverMonitor           &monitor = {}) const;

    /// The tangent of the internal forces at the displacement @p u, in the
    /// three ways that are asked for: as terms of a matrix with the springs
    /// @p springs, as f += K(u) w, and as what solves with it. Where bodies are
    /// linear it is the stiffness at all u, else what for_each_tangent_block()
    /// says. A @p correction is the last one on the way to u, none where it is
    /// empty: the stress that turns is the one that it predicted (GreenAnswer).
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
                        const SolverKind     asked   = SolverKind::automatic,
                        const SolverMonitor &monitor = {}) const;

    /// What solves with the matrix of @p terms, condensed by @p constraints:
    /// assembled, factorised and dropped as make_solver() says.
    virtual std::unique_ptr<LinearSolver>
    solver_of(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      asked,
              const SolverMonitor  &monitor) const;

  protected:
    /**
     * Calls @p use with block after block of the unconstrained stiffness, this
     * process's share of them, with values if @p with_values (else for the
     * pattern alone, which needs no integrals). The sum of all blocks of all
     * processes is K. A beam's blocks are single rows, a solid's the matrices
     * of its elements; the block is good until @p use returns.
     */
    virtual void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;

    /// The same of the tangent at @p u, after the @p correction, which has its
    /// size. Only of bodies that turn (an assertion fails otherwise).
    virtual void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// T at @p x (scene axes) [K]; zero where nobody heats the body.
    double
    temperature(const dealii::Point<3> &x) const
    {
      return temperature_change ? temperature_change(x) : 0.;
    }

    /// Of each ply the density. Throws InputError for one without.
    std::vector<double>
    densities() const;

    /// Throws @p error again, as a NumericsError that says as well where in the
    /// scene its DoF is.
    [[noreturn]] void
    throw_with_place(const NotPositiveDefinite &error) const;

    const Placement placement;

  private:
    /// The matrix of @p terms, condensed, for a solver as @p asked.
    std::unique_ptr<StiffnessMatrix>
    assembled(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      asked) const;

    /// Of each own element the Gauss points of add_heat(), with their weights.
    using UseOfPoints = std::function<void(const std::vector<Location> &,
                                           const std::vector<double> &)>;
    void
    for_each_cell_by_points(const UseOfPoints &use) const;

    /// Whether the middle of the side of @p before that ends it along the axis
    /// lies on the one that begins @p cell, or the other way round.
    bool
    meets(const unsigned int before, const unsigned int cell) const;

    /// Fields at the grid points of @p cell, @p etas along the axis; the
    /// intervals of @p n count in the section.
    OutputCell
    sample_grid(const unsigned int         cell,
                const GridIntervals       &n,
                const std::vector<double> &etas,
                const Vector              &u) const;

    /// Replaces the samples of @p cell's first layer of points by the means
    /// with those of the cells before it along the axis.
    void
    average_with_layer_before(const unsigned int cell,
                              const Vector      &u,
                              OutputCell        &grid) const;

    std::string body_name;
    ScalarField temperature_change;
  };

  /// The bodies of a scene, in the order of its list: a body's number
  /// (BodyRow::body, blocks of vectors) is its place here.
  using Bodies = std::vector<std::unique_ptr<Body>>;
} // namespace lamella

#endif
