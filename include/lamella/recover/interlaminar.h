// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_interlaminar_h
#define lamella_recover_interlaminar_h

#include <lamella/body/placement.h>
#include <lamella/recover/face_tractions.h>
#include <lamella/recover/recovery.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/quadrature.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Geometry of a laminate: a beam whose section is a rectangle of rectangular
  /// cells, with one or more layers of cells per ply.
  struct LaminateBox
  {
    /// Frame at the lower left corner of the start: x across, z through plies.
    Placement frame;
    /// Width, length and height [length].
    dealii::Point<3> size;
  };

  /// Returns the geometry of @p body. Throws InputError with the path @p path
  /// unless it is a laminate.
  LaminateBox
  laminate_box(const Body &body, const std::string &path);

  /// Defect of the integration of equilibrium over the height [force/length^2]:
  /// the difference `error` between the integrated stresses and the traction on
  /// the upper face, the largest transverse stress `largest` (norms of {xz, yz,
  /// zz}), and the largest in-plane stress `in_plane`.
  struct EquilibriumDefect
  {
    double error = 0., largest = 0., in_plane = 0.;

    /// Sets each member to its maximum with that of @p other.
    void
    add(const EquilibriumDefect &other);

    /// Returns error / largest; 0 for errors below 1e-6 of in-plane stresses.
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
  /// *Derivatives.* In-plane stresses are evaluated at the p Gauss points of
  /// each element, along the axis and (layer-wise theories) across it, in the
  /// element of the column and one more on each side. A polynomial, of degree p
  /// across and p + 1 along the axis, is fitted and differentiated. If one
  /// expansion spans the section (TE-N), its polynomial is used.
  ///
  /// *Shear warping.* With one quadratic cell per ply, the axial displacement
  /// of a thick laminate lacks the warping by shear. Its effect on sigma_yy is
  /// corrected. The missing transverse shear strain S tau - gamma (shear stress
  /// tau, shear compliance S, strain gamma of the displacements), integrated
  /// over the thickness, is a displacement e:
  ///   tau = tau_0 + P(tau'' - gamma''),   e,z = S tau - gamma,
  ///   P: delta,z = -Q (e,yy + a + b z),   delta = 0 on both faces,
  /// with the shear stress tau_0 without correction, derivatives '' along the
  /// axis, the plane-stress stiffness Q, and a, b such that the resultants do
  /// not change (a predictor-corrector method after Noor, Burton and Peters,
  /// Comput. Meth. Appl. Mech. Eng. 82 (1990) 341-363). The correction delta =
  /// P(...) has delta'' = c delta with the mean ratio c of tau_0'' (from the
  /// fit) to tau_0. This is exact for waves; c = 0 if tau_0 is at most linear.
  /// A correction above half of tau_0 is omitted.
  ///
  /// *Free edges.* In elements wider than thick, torsion leaves sigma_xy at
  /// free sides, where it must vanish within about one height H. If e is the
  /// fitted sigma_xy at a free side minus its mean through the thickness, then
  /// sigma_xy is replaced by
  ///   sigma_xy - e phi(x),   phi = 1 at the side and 0 at the other,
  ///   phi'' = (pi / H)^2 (G_yz / G_xy) phi,
  /// the slowest decay of warping by torsion (Timoshenko and Goodier, Theory of
  /// Elasticity, Art. 109), with the mean G_xy of the plies and the harmonic
  /// mean G_yz. The resultant of the change is exact for any phi. Boundary
  /// layers between different plies, as in an angle-ply laminate in tension,
  /// are not resolved.
  ///
  /// *Defect.* The difference between the integrated stresses and the traction
  /// on the upper face is stored as equilibrium defect, then subtracted in
  /// proportion to the height. An object is for one state of one body. A column
  /// costs about a hundred Body::sample() per layer, cached. Not collective.
  class EquilibriumStress
  {
  public:
    /// Keeps references to @p body (number @p number, a laminate) and its
    /// displacements @p u; uses its @p tractions. Throws InputError with the
    /// path @p path as laminate_box() does.
    EquilibriumStress(const Body          &body,
                      const unsigned int   number,
                      const Vector        &u,
                      const FaceTractions &tractions,
                      const std::string   &path);

    /// Returns all fields at @p location, in scene axes and in ply axes.
    FieldSample
    sample(const Location &location);

    /// Returns the defect of the columns evaluated since the last call.
    EquilibriumDefect
    reset_defect();

  private:
    /// Indices of the stress components in FieldSample vectors.
    static constexpr unsigned int xx = 0, yy = 1, zz = 2, xy = 3, xz = 4,
                                  yz = 5;

    static std::vector<double>
    points_of(const dealii::Quadrature<1> &rule);

    /// A section cell that a column passes through.
    struct Layer
    {
      /// Heights above the lower face [length].
      double       bottom, top;
      unsigned int ply;
    };

    /// A function of the height z in a column: values at the nodes of each
    /// layer, layer by layer, for the components xz, then yz, or for zz alone.
    using Profile = dealii::Vector<double>;

    /// Transverse stresses in the column over a point of the lower face:
    /// profiles of {xz, yz} and of zz.
    struct Column
    {
      std::vector<Layer> layers;
      /// Profiles of {xz, yz} and of zz.
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

    /// Integrands of the equilibrium equations in a column.
    struct Sources
    {
      /// `shear`: tau,z of {xz, yz} with its derivatives along y up to the
      /// third; `normal`: -sigma_zz,zz; `strain`: gamma'' and gamma'''.
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
    /// Returns the length over which torsional warping decays from a free side.
    double
    torsional_decay() const;
    const Column &
    column_at(const double x, const double y);
    Column
    make_column(const double x, const double y);
    /// Subtracts the defect @p missed from @p column, linear in the height.
    void
    distribute(const dealii::Tensor<1, 3> &missed, Column &column) const;
    /// Returns {sigma_xz, sigma_yz, sigma_zz} of @p column at the height @p z,
    /// in the layer of @p ply at or next to it.
    dealii::Tensor<1, 3>
    transverse_stress(const Column      &column,
                      const unsigned int ply,
                      const double       z) const;
    std::vector<Layer>
    layers_at(const double x, const double y) const;
    /// Returns the stencil at @p through for derivatives by coordinate @p d.
    Stencil
    stencil(const unsigned int d, const dealii::Point<3> &through) const;
    Sources
    sources(const std::vector<Layer> &layers, const double x, const double y);
    /// Function phi of the class comment at a free side, and its slope by x.
    struct FreeEdgeDecay
    {
      double value, slope;
    };
    FreeEdgeDecay
    free_edge_decay(const unsigned int side, const double x) const;
    /// Corrections of sigma_xy and sigma_xy,x due to free sides.
    struct FreeEdgeCorrection
    {
      dealii::Tensor<1, 5> of_value, of_slope;
    };
    /// Returns the corrections at the sampling points of each of @p layers.
    std::vector<FreeEdgeCorrection>
    free_edge_corrections(const std::vector<Layer> &layers,
                          const double              x,
                          const double              y);
    /// Returns stress e (class comment) at a free side, with derivatives.
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
    /// Derivatives of Sampled, by order along x and along y.
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
    /// Returns int sigma dz of {xy, yy}, then int sigma z / H dz.
    std::array<double, 4>
    resultants(const std::vector<Layer> &layers, const Profile &stress) const;
    /// Returns @p stress plus the stress of a strain a + b z such that its
    /// resultants are zero.
    Profile
    without_resultants(const std::vector<Layer> &layers, Profile stress) const;
    /// Returns the correction delta of shear stresses and its derivative along
    /// y. @p shear contains tau_0 with its derivatives.
    std::array<Profile, 2>
    correction(const std::vector<Layer>     &layers,
               const std::array<Profile, 4> &shear,
               const std::array<Profile, 2> &strain) const;
    /// Returns P(tau'' - gamma'') for tau'' = @p shear, gamma'' = @p strain.
    Profile
    warped(const std::vector<Layer> &layers,
           const Profile            &shear,
           const Profile            &strain) const;
    /// Returns {sigma_xz, sigma_yz, sigma_zz} of the traction on a face.
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
    /// Tractions on the lower and the upper face.
    std::vector<FaceTractions::OnFace> faces;
    /// True for free sides x = 0, x = W; decay length of torsional warping.
    std::array<bool, 2> is_free{};
    double              decay = 0.;
    /// Transformations of strains and stresses between scene and body axes.
    ElasticTensor to_body, to_scene;

    /// Sampling points and nodes through a layer, in [0, 1], with weights;
    /// matrices from samples to nodes, and from nodes to int_0^t.
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
