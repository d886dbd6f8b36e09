// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `body`: what all bodies have in common, and the two that there are.
// It owns Body, the only face that other rooms see, the beam (an axis times a
// section), the solid (hexahedra on the same section mesh), where they stand in
// the scene, and the fields at their points. A body never knows what holds or
// touches it: no supports, no contact.

#ifndef lamella_body_body_h
#define lamella_body_body_h

#include <lamella/base/row.h>
#include <lamella/linear/stiffness_matrix.h>
#include <lamella/material/elasticity.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// What rows and samples can speak of.
  enum class Quantity
  {
    displacement, ///< three components, scene axes
    strain,       ///< six, order of Eq. 4, engineering shear strains
    stress        ///< six, order of Eq. 4
  };

  /// The axes that a strain or a stress is given in.
  enum class Frame
  {
    scene,
    ply ///< 1 along the fibre, 2 across, 3 normal to the ply: 11,22,33,12,13,23
  };

  /**
   * A point of a body on one side of its ply interfaces. Where elements of the
   * same ply meet it has a place in each of them, and stands for their mean.
   */
  struct Location
  {
    struct Place
    {
      unsigned int     cell;
      dealii::Point<3> unit;
    };
    dealii::Point<3>   position;
    unsigned int       ply = 0;
    std::vector<Place> places;
  };

  /// The fields at a location.
  struct FieldSample
  {
    dealii::Tensor<1, 3> displacement;
    Voigt                strain, stress;
    Voigt                ply_stress;
    /// The largest difference of stress between the places of the location over
    /// the largest stress there, Euclidean norms: what the mesh leaves open.
    double jump = 0.;
  };

  /// A point of a body's surface, at a node or at an integration point.
  struct SurfacePoint
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> normal;
    /// The tributary area, or the integration weight.
    double area = 0.;
    /// Whether sides of different normals meet there.
    bool     corner = false;
    Location location;
    /// n.n : C : n.n of the ply there, and the depth of the cell below.
    double normal_modulus = 0., depth = 0.;
  };

  /**
   * One side of one cell of a body: a piece of its surface that is the image of
   * the unit square under one polynomial map. The point (s, t) of the square is
   * the point origin + s along_s + t along_t of the cell's unit cube.
   */
  struct SurfaceFacet
  {
    unsigned int         cell = 0;
    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> along_s, along_t;
    /// Where (0, 0), (1, 0), (0, 1) and (1, 1) are.
    std::array<dealii::Point<3>, 4> corners;
    /// The degree of the expansion in s and in t: what a grid of nodes has.
    unsigned int degree_s = 0, degree_t = 0;
    /// Positions and displacements are polynomials of these degrees in s and in
    /// t: more than the above where a Taylor expansion meets a curved side.
    unsigned int trace_degree_s = 0, trace_degree_t = 0;
  };

  /// An element of a body for pictures: fields on a grid of (n+1)^3 points, the
  /// first coordinate running fastest.
  struct OutputCell
  {
    unsigned int                  ply = 0;
    dealii::Tensor<1, 3>          fibre;
    std::vector<dealii::Point<3>> positions;
    std::vector<FieldSample>      samples;
  };

  /// What a displacement field does to a body as a whole.
  struct Deformation
  {
    double energy = 0.;
    /// The largest |curl u| / 2 at the integration points, in rad.
    double max_rotation = 0.;
  };

  /// Three translations along the scene's axes and three rotations about them.
  using RigidMotion = std::array<double, 6>;

  /**
   * A linear elastic body: DoFs, a stiffness, rows at its points, points on its
   * surfaces. Supports, loads, contact and reports see nothing else of it, so
   * they do not know whether it is a beam or a solid. All positions are those
   * of the scene. A body takes displacements as an argument and stores none.
   */
  class Body
  {
  public:
    explicit Body(std::string name);
    virtual ~Body();

    const std::string &
    name() const
    {
      return body_name;
    }

    /// The structural theory, as the user writes it.
    virtual std::string
    theory() const = 0;

    virtual DofIndex
    n_dofs() const = 0;

    /// An estimate of the non-zeros of the stiffness from above, known before
    /// it is assembled. Here the sum over all blocks; bodies know better.
    virtual double
    stiffness_entries() const;

    /// Whether DoF 3 i + c is the displacement component c at node i. Only then
    /// does algebraic multigrid understand the matrix, and `cg` is offered.
    virtual bool
    is_nodal() const
    {
      return false;
    }

    /// The DoFs whose rows of the stiffness this process keeps: contiguous, and
    /// all of them where there is one process.
    virtual dealii::IndexSet
    owned_dofs() const
    {
      return dealii::complete_index_set(n_dofs());
    }

    /// 0 for DoFs that hold the rigid motions, higher for finer ones. Supports
    /// eliminate coarse DoFs first and so leave the hierarchy intact.
    virtual unsigned int
    dof_level(const DofIndex dof) const = 0;

    /// Where @p dof is at home, for messages: of a beam the place of its node
    /// on the axis.
    virtual dealii::Point<3>
    dof_position(const DofIndex dof) const = 0;

    /// What the theory itself ties together, whatever the supports:
    /// displacements of the body satisfy these homogeneous constraints.
    virtual const Constraints &
    kinematic_constraints() const = 0;

    /// The six rigid motions as displacement vectors: three unit translations
    /// along the scene's axes, three unit rotations about them through
    /// centre().
    virtual std::vector<Vector>
    rigid_motions() const = 0;

    /// Those rigid motions that the theory's displacements do not contain (EBBT
    /// and TBT cannot turn about their axis): nothing needs to hold them.
    virtual std::vector<RigidMotion>
    missing_motions() const
    {
      return {};
    }

    virtual dealii::Point<3>
    centre() const = 0;

    /// Half the largest extension: the length that makes a rotation comparable
    /// with a translation.
    virtual double
    size() const = 0;

    virtual dealii::BoundingBox<3>
    bounding_box() const = 0;

    /**
     * f += integral B^T C (B u) dV, strain first: the rounding is that of the
     * strains and not that of the entries of an assembled matrix, which loses
     * the bending energy of slender bodies (doc/stable-basis.md).
     */
    virtual void
    add_internal_forces(const Vector &u, Vector &f) const = 0;

    virtual Deformation
    deformation(const Vector &u) const = 0;

    /// The places of each point, one location a ply; none outside of the body.
    virtual std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const = 0;

    /// For each location the rows of @p quantity: three for displacements, six
    /// for strains and stresses (in @p frame).
    virtual std::vector<std::vector<Row>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const = 0;

    virtual FieldSample
    sample(const Location &location, const Vector &u) const = 0;

    /// Where @p place is. With locate() it gives an element's neighbours: those
    /// that have a place at one of its corners.
    virtual dealii::Point<3>
    position(const Location::Place &place) const = 0;

    /**
     * How the recovery of strains sees an element (recover/recovery.h): for
     * each unit coordinate the degree of the displacements whose derivatives
     * are best at that many Gauss points. Zero along a coordinate in which one
     * expansion spans all elements, so that strains are smooth there and leave
     * nothing to recover: across the section of Taylor theories.
     */
    virtual std::array<unsigned int, 3>
    recovery_degrees() const = 0;

    /// Names that the functions below take; `all` is the whole surface.
    virtual std::vector<std::string>
    surfaces() const = 0;

    /**
     * Points that fix the trace on @p surface, with outward normals and
     * tributary areas int N_i F_tau dA, which sum to the area.
     */
    virtual std::vector<SurfacePoint>
    surface_points(const std::string &surface) const = 0;

    /// Locations that fix the displacement on @p surface, as few as that takes.
    virtual std::vector<Location>
    fixing_points(const std::string &surface) const = 0;

    /// Locations that fix the displacement of the whole body.
    virtual std::vector<Location>
    body_points() const = 0;

    /// The facets that @p surface is made of.
    virtual std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const = 0;

    /// The point of @p facet at (s, t) = @p st; its area is the area per unit
    /// of the square, |dX/ds x dX/dt|.
    virtual SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const = 0;

    /// The parameters in [0, 1], ascending, where the segment from @p a to @p b
    /// crosses from element to element, its ends among them.
    virtual std::vector<double>
    line_breaks(const dealii::Point<3> &a, const dealii::Point<3> &b) const = 0;

    /// The largest polynomial degree of displacements along a coordinate of an
    /// element: for pictures.
    virtual unsigned int
    degree() const = 0;

    /// The polynomial degree of displacements along the segment from @p a to
    /// @p b within an element: on a skew line the sum of those it runs along.
    virtual unsigned int
    line_degree(const dealii::Point<3> &a, const dealii::Point<3> &b) const = 0;

    /// Points of the segment from @p a to @p b that fix the displacement there.
    std::vector<dealii::Point<3>>
    line_points(const dealii::Point<3> &a, const dealii::Point<3> &b) const;

    /// Numbers of the elements in the section at @p position along the axis and
    /// their fields on an n x n grid each, for contours.
    virtual std::vector<OutputCell>
    cut(const double position, const unsigned int n, const Vector &u) const = 0;

    /// The elements of this process, all together those of the body, with the
    /// fields on their grids.
    virtual std::vector<OutputCell>
    output_cells(const unsigned int n, const Vector &u) const = 0;

    /// What @p asked means for this body, never `automatic`. Throws InputError
    /// where it is not offered.
    SolverKind
    solver_kind(const SolverKind asked) const;

    /// What the stiffness is assembled from: blocks without constraints, and
    /// @p springs. Refers to the body.
    StiffnessTerms
    stiffness_terms(const std::vector<SpringTerm> &springs = {}) const;

    /**
     * The stiffness with @p springs, condensed by the homogeneous part of
     * @p constraints (constrained DoFs keep a positive diagonal and nothing
     * else), for a solver as @p asked.
     */
    std::unique_ptr<StiffnessMatrix>
    assembled_stiffness(const Constraints             &constraints,
                        const std::vector<SpringTerm> &springs = {},
                        const SolverKind asked = SolverKind::automatic) const;

    /**
     * What solves with that matrix. Here it is assembled, factorised (or
     * prepared for iterations), and dropped where its solver does without; a
     * body that knows the structure of its matrix may never assemble it.
     * @p monitor is told when it is there and how large a factor becomes.
     * Throws NumericsError if it is not positive definite.
     */
    virtual std::unique_ptr<LinearSolver>
    make_solver(const Constraints             &constraints,
                const std::vector<SpringTerm> &springs = {},
                const SolverKind               asked   = SolverKind::automatic,
                const SolverMonitor           &monitor = {}) const;

  protected:
    /// Calls @p use with block after block of the unconstrained stiffness, this
    /// process's share of them, with values if @p with_values.
    virtual void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;

  private:
    std::string body_name;
  };
} // namespace lamella

#endif
