// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_interlaminar_h
#define lamella_recover_interlaminar_h

#include <lamella/body/body.h>
#include <lamella/recover/face_tractions.h>
#include <lamella/recover/recovery.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/quadrature.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// Geometry of a laminate: a beam whose section is a rectangle of rectangular
  /// cells, with one or more layers of cells per ply.
  struct LaminateBox
  {
    /// Local axes x along the width, y along the beam and z through the plies,
    /// with the origin at the lower left corner of the start section.
    Placement frame;
    /// Width, length and height of the laminate [length].
    dealii::Point<3> size;
  };

  /// Returns the geometry of @p body. Throws InputError, which names the scene
  /// entry @p path, if the body is not a laminate.
  LaminateBox
  laminate_box(const Body &body, const std::string &path);

  /// Error of transverse stresses {xz, yz, zz} that are integrated from
  /// equilibrium over the height of a laminate [force/length^2].
  struct EquilibriumDefect
  {
    double error    = 0.; ///< |integrated stress - traction| on the upper face.
    double largest  = 0.; ///< Largest norm of the transverse stresses.
    double in_plane = 0.; ///< Largest in-plane stress.

    /// Sets each member to the larger of its values here and in @p other.
    void
    add(const EquilibriumDefect &other);

    /// Returns the error relative to the largest transverse stress; 0 if the
    /// error is below 1e-6 of the in-plane stresses (rounding).
    double
    relative() const;
  };

  /// Transverse stresses by equilibrium, `Stress = equilibrium`
  /// (doc/theory/interlaminar-stress.md). In the column over each point (x, y)
  /// of a laminate, the equations
  ///   sigma_xz,z = -(sigma_xx,x + sigma_xy,y)
  ///   sigma_yz,z = -(sigma_xy,x + sigma_yy,y)
  ///   sigma_zz,z = -(sigma_xz,x + sigma_yz,y)
  /// are integrated from the traction on the lower face upwards, with the
  /// in-plane stresses from the displacements (Rolfes and Rohwer, Int. J.
  /// Numer. Meth. Eng. 40 (1997) 51-60). The results are continuous between
  /// plies. All other components are the `recovered` stresses (StressRecovery).
  ///
  /// - Derivatives: a polynomial is fitted to the in-plane stresses at Gauss
  ///   points of the element and its neighbors, and differentiated. If one
  ///   expansion spans the section (TE-N), its polynomial is used across.
  /// - Shear warping: with one quadratic cell per ply, the axial displacement
  ///   lacks the warping of thick laminates by shear, which changes sigma_yy. A
  ///   step of a predictor-corrector method adds its effect (Noor, Burton and
  ///   Peters, Comput. Meth. Appl. Mech. Eng. 82 (1990) 341-363).
  /// - Free edges: if elements are wider than thick, torsion leaves a sigma_xy
  ///   at free sides. It is made to vanish there with the slowest decay of
  ///   warping by torsion (Timoshenko and Goodier, Theory of Elasticity, Art.
  ///   109). Boundary layers due to different plies are not resolved.
  /// - Error: the difference between integrated stresses and traction on the
  ///   upper face is stored (EquilibriumDefect), then subtracted in proportion
  ///   to the height.
  ///
  /// An object evaluates one solution of one body. A column costs about 100
  /// calls of Body::sample() per layer, once. Not collective.
  class EquilibriumStress
  {
  public:
    /// Keeps references to the laminate @p body (index @p number in Bodies),
    /// its displacements @p u and the @p tractions on its faces. Throws
    /// InputError, which names the scene entry @p path, if the body is not a
    /// laminate.
    EquilibriumStress(const Body          &body,
                      const unsigned int   number,
                      const Vector        &u,
                      const FaceTractions &tractions,
                      const std::string   &path);

    /// Returns displacement, strain and stress at @p location; the transverse
    /// stresses are integrated from equilibrium.
    FieldSample
    sample(const Location &location);

    /// Returns the largest error of the integrated stresses at all points
    /// evaluated since the last call of this function.
    EquilibriumDefect
    reset_defect();

  private:
    /// Indices of the stress components in FieldSample vectors.
    static constexpr unsigned int xx = 0, yy = 1, zz = 2, xy = 3, xz = 4,
                                  yz = 5;

    static std::vector<double>
    points_of(const dealii::Quadrature<1> &rule);

    /// A section cell above a given point of the lower face of the laminate.
    struct Layer
    {
      /// Heights of the cell's faces above the lower face [length].
      double       bottom, top;
      unsigned int ply;
    };

    /// Values of sigma_xz, then of sigma_yz (or of sigma_zz alone) at the nodes
    /// of all layers over the height.
    using Profile = dealii::Vector<double>;

    /// Transverse stresses over the height above a point of the lower face.
    struct Column
    {
      std::vector<Layer> layers;
      /// Stresses {sigma_xz, sigma_yz}, and sigma_zz.
      Profile           shear, normal;
      EquilibriumDefect defect;
    };

    /// A finite difference stencil on a line: the m-th derivative at `at` is
    /// sum_i weights[m][i] f(points[i]).
    struct Stencil
    {
      double                           at;
      std::vector<double>              points;
      std::vector<std::vector<double>> weights;
    };

    /// Integrands of the equilibrium equations over the height.
    struct Sources
    {
      /// `shear`: d/dz {sigma_xz, sigma_yz} and its y-derivatives 1 to 3;
      /// `normal`: -sigma_zz,zz; `strain`: d2/dy2, d3/dy3 {gamma_xz, gamma_yz}.
      std::array<Profile, 4> shear;
      Profile                normal;
      std::array<Profile, 2> strain;
      /// Largest in-plane stress.
      double in_plane = 0.;
    };

    /// Sets the nodes through a layer for polynomials of degree @p degree.
    void
    make_nodes(const unsigned int degree);
    void
    make_plies();
    const Column &
    column_at(const double x, const double y);
    Column
    make_column(const double x, const double y);
    /// Subtracts the difference @p missed to the traction on the upper face
    /// from the stresses of @p column, in proportion to the height.
    void
    distribute(const dealii::Tensor<1, 3> &missed, Column &column) const;
    /// Returns {sigma_xz, sigma_yz, sigma_zz} of @p column at the height @p z
    /// in @p ply, or at the nearest height in this ply.
    dealii::Tensor<1, 3>
    transverse_stress(const Column      &column,
                      const unsigned int ply,
                      const double       z) const;
    std::vector<Layer>
    layers_at(const double x, const double y) const;
    /// Returns the stencil for derivatives by coordinate @p d at @p through.
    Stencil
    stencil(const unsigned int d, const dealii::Point<3> &through) const;
    Sources
    sources(const std::vector<Layer> &layers, const double x, const double y);
    /// Decay of a free-edge stress with the distance from a free side (1 at the
    /// side, 0 at the other side), and its derivative by x.
    struct FreeEdgeDecay
    {
      double value, slope;
    };
    FreeEdgeDecay
    free_edge_decay(const unsigned int side, const double x) const;
    /// Corrections of sigma_xy and of its derivative by x that make sigma_xy
    /// vanish at free sides, each with derivatives by y of order 0 to 4.
    struct FreeEdgeCorrection
    {
      dealii::Tensor<1, 5> of_value, of_slope;
    };
    /// Returns the corrections at the sampling points of each of @p layers.
    std::vector<FreeEdgeCorrection>
    free_edge_corrections(const std::vector<Layer> &layers,
                          const double              x,
                          const double              y);
    /// Returns sigma_xy at a free side minus its mean through the thickness,
    /// with derivatives by y of order 0 to 4, at all sampling points of layers.
    const std::vector<dealii::Tensor<1, 5>> &
    free_edge_stress(const unsigned int        side,
                     const std::vector<Layer> &layers,
                     const double              y);
    /// Adds the integrands of layer number @p k to @p all, with the corrections
    /// @p edges_here due to free sides subtracted.
    void
    add_sources(const unsigned int                     k,
                const Layer                           &layer,
                const std::vector<FreeEdgeCorrection> &edges_here,
                const Stencil                         &along_x,
                const Stencil                         &along_y,
                Sources                               &all);
    /// Values sigma_xx, sigma_yy, sigma_xy, gamma_xz, gamma_yz of an element.
    using Sampled = std::array<double, 5>;
    /// Derivatives of the values of Sampled: [m][n] has order m in x, n in y.
    using Derivatives = std::array<std::array<dealii::Tensor<1, 5>, 5>, 3>;
    /// Returns the derivatives at the height @p z in @p ply; updates the
    /// largest in-plane stress @p in_plane.
    Derivatives
    derivatives_at(const double       z,
                   const unsigned int ply,
                   const Stencil     &along_x,
                   const Stencil     &along_y,
                   double            &in_plane);
    /// Returns the cached fields at @p x in an element of @p ply.
    const Sampled &
    sampled_at(const dealii::Point<3> &x, const unsigned int ply);
    /// Returns the profile @p start + int f dz, integrated from the lower face.
    Profile
    integral(const std::vector<Layer>  &layers,
             const Profile             &f,
             const std::vector<double> &start) const;
    /// Returns the plane stresses {xy, yy} of the axial @p displacement.
    Profile
    plane_stress(const std::vector<Layer> &layers,
                 const Profile            &displacement) const;
    /// Returns the section forces int sigma dz of @p stress {xy, yy}, then the
    /// moments int sigma z / H dz with the height H of the laminate.
    std::array<double, 4>
    resultants(const std::vector<Layer> &layers, const Profile &stress) const;
    /// Returns @p stress plus the stress of a strain a + b z, where a and b are
    /// such that the resultants of the sum are zero.
    Profile
    without_resultants(const std::vector<Layer> &layers, Profile stress) const;
    /// Returns the shear-warping correction of the stresses {sigma_xz,
    /// sigma_yz} in @p shear, and its derivative by y.
    std::array<Profile, 2>
    correction(const std::vector<Layer>     &layers,
               const std::array<Profile, 4> &shear,
               const std::array<Profile, 2> &strain) const;
    /// Returns the shear-warping correction of {sigma_xz, sigma_yz}, from their
    /// second derivatives @p shear and those of the shear strains, @p strain.
    Profile
    warped(const std::vector<Layer> &layers,
           const Profile            &shear,
           const Profile            &strain) const;
    /// Returns {sigma_xz, sigma_yz, sigma_zz} due to the traction on the lower
    /// (@p face = 0) or upper (1) face.
    dealii::Tensor<1, 3>
    face_stress(const unsigned int face, const double x, const double y) const;
    /// Returns the height of node @p i of @p layer.
    double
    height(const Layer &layer, const unsigned int i) const
    {
      return layer.bottom + nodes[i] * (layer.top - layer.bottom);
    }

    const Body       &body;
    const Vector     &u;
    const LaminateBox box;
    StressRecovery    recovery;
    /// Tractions on the lower and the upper face of the laminate.
    std::vector<FaceTractions::OnFace> faces;
    /// True if the left, right side is free; decay length of torsional warping.
    std::array<bool, 2> is_free{};
    double              decay = 0.;
    /// Transformations of strains and stresses between scene and body axes.
    ElasticTensor to_body, to_scene;

    /// Sampling points and nodes through a layer, in [0, 1], with weights.
    /// Matrices from samples to nodes, and to integrals up to each node.
    std::vector<double>        samples, sample_weights, nodes, node_weights;
    dealii::FullMatrix<double> to_nodes, integrate;
    /// Compliances {xz, yz} and plane-stress stiffnesses {xy, yy} by ply.
    std::vector<dealii::Tensor<2, 2>> shear_compliance, plane_stiffness;
    /// Axes of the plies in the frame of the body.
    std::vector<Triad> ply_frames;

    std::map<std::array<long, 2>, Column> columns;
    /// Cache of free_edge_stress(), by side and y.
    std::map<std::array<long, 2>, std::vector<dealii::Tensor<1, 5>>> edges;
    std::map<std::array<long, 3>, Sampled>                           sampled;
    EquilibriumDefect                                                defect;
  };
} // namespace lamella

#endif
