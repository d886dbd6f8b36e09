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
  /// A body whose section is a laminate: a rectangle of rectangular cells.
  struct LaminateBox
  {
    /// The lower left corner of its start, with the axes x across, y along, z
    /// through the plies.
    Placement frame;
    /// Width, length and height.
    dealii::Point<3> size;
  };

  /// @p body as one. Throws InputError under the path @p path if it is a solid
  /// or its section is no rectangle, bottom to top, of rectangular cells.
  LaminateBox
  laminate_box(const Body &body, const std::string &path);

  /// What the integration of equilibrium leaves: the stresses that it finds on
  /// the upper face less the traction there, and the largest transverse stress
  /// of the columns, norms of {xz, yz, zz}; and the largest of the in-plane
  /// stresses that were integrated. [force/length^2]
  struct ClosureError
  {
    double error = 0., largest = 0., in_plane = 0.;

    /// Those of @p other as well.
    void
    add(const ClosureError &other);

    /// The share error / largest; 0 where the error is below 1e-6 of the
    /// in-plane stresses, as in pure bending, where there is nothing to
    /// integrate but what their digits leave.
    double
    relative() const;
  };

  /**
   * Transverse stresses by equilibrium, `Stress = equilibrium`
   * (doc/interlaminar-stress.md). In the column over each place (x, y) of a
   * laminate, from the lower face upwards,
   *   sigma_xz,z = -(sigma_xx,x + sigma_xy,y)
   *   sigma_yz,z = -(sigma_xy,x + sigma_yy,y)
   *   sigma_zz,z = -(sigma_xz,x + sigma_yz,y)
   * from the traction there, with the in-plane stresses of the displacements
   * (Rolfes and Rohwer, Int. J. Numer. Meth. Eng. 40 (1997) 51-60). They are
   * continuous between plies. All but these three are those of `recovered`.
   *
   * *Derivatives.* The in-plane stresses are taken where they are best, at the
   * p Gauss points of each element along the axis and (layer-wise) across, of
   * the elements at the column and one further on each side. A polynomial of
   * degree p + 1 along and p across is fitted to them and differentiated. Where
   * one expansion spans the section its own polynomial is.
   *
   * *Shear warping.* With one quadratic cell a ply a thick laminate's u_y lacks
   * the warping by shear, and with it syy its share. The transverse shear
   * strains S tau - gamma that the displacements lack, integrated over the
   * thickness, are a displacement e, and
   *   tau = tau_0 + P(tau'' - gamma''),   e,z = S tau - gamma,
   *   P: delta,z = -Q (e,yy + a + b z),   delta = 0 on both faces,
   * Q of plane stress, a and b such that resultants stay those of the solution
   * (a predictor-corrector as of Noor, Burton and Peters, Comput. Meth. Appl.
   * Mech. Eng. 82 (1990) 341-363, along the axis alone). tau_0'' is the fit's;
   * of what is added delta'' = c delta, with c the mean ratio of tau_0'' to
   * tau_0, which is exact for waves along the axis and nothing (c = 0) where
   * tau_0 is at most linear. It is left out where it is no correction any more:
   * above half of tau_0.
   *
   * *Free edges.* What twists has sigma_xy up to its free sides in elements
   * that are wider than thick; it falls to zero there within about one height.
   * At a side that nothing is on, e the sigma_xy of the fit there less its mean
   * through the thickness, sigma_xy is taken as
   *   sigma_xy - e phi(x),   phi = 1 at the side and 0 at the other,
   *   phi'' = (pi / H)^2 (G_yz / G_xy) phi,
   * the slowest decay of the warping by torsion (Timoshenko and Goodier, Theory
   * of Elasticity, Art. 109, for one material), G_xy the mean of the plies' Q
   * and 1 / G_yz that of their compliances. Whatever phi, the resultant of what
   * is added is exact. Where elements resolve the layer e is what their fit
   * leaves, a few per cent. Layers between plies that differ, as of a pulled
   * angle-ply laminate, are as thin as a ply and are not described.
   *
   * *Closure.* What is found on the upper face differs from the traction there
   * by what the mesh leaves open. This closure error is kept, and then
   * distributed: subtracted in proportion to the height above the lower face.
   *
   * One object is that of one state of one body. A column takes some hundred
   * Body::sample() a layer of cells; columns and samples are kept, and columns
   * of the same elements share the latter. Communicates nothing.
   */
  class EquilibriumStress
  {
  public:
    /// @p body, number @p number of the scene, a laminate, and its
    /// displacements @p u in a state in which @p tractions act. Body,
    /// displacements and tractions are referred to. Throws as laminate_box()
    /// does.
    EquilibriumStress(const Body          &body,
                      const unsigned int   number,
                      const Vector        &u,
                      const FaceTractions &tractions,
                      const std::string   &path);

    /// All fields at @p location, in scene axes and in ply axes.
    FieldSample
    sample(const Location &location);

    /// Of the columns that were sampled since the last call.
    ClosureError
    take_closure();

  private:
    /// Order of Eq. 4.
    static constexpr unsigned int xx = 0, yy = 1, zz = 2, xy = 3, xz = 4,
                                  yz = 5;

    /// The coordinates of the points of @p rule.
    static std::vector<double>
    points_of(const dealii::Quadrature<1> &rule);

    /// A cell of the section that a column passes.
    struct Layer
    {
      /// Above the lower face [length].
      double       bottom, top;
      unsigned int ply;
    };

    /// A function of z over a column: values at the nodes of its layers, layer
    /// by layer, of xz and then of yz, or of zz.
    using Profile = dealii::Vector<double>;

    /// Transverse stresses over a place of the lower face.
    struct Column
    {
      std::vector<Layer> layers;
      /// {xz, yz}, and zz.
      Profile      shear, normal;
      ClosureError closure;
    };

    /// How derivatives at a place of a line are made of the values at points
    /// of it: the m-th one at `at` is sum_i weights[m][i] f(points[i]).
    struct Stencil
    {
      double                           at;
      std::vector<double>              points;
      std::vector<std::vector<double>> weights;
    };

    /// What is integrated.
    struct Sources
    {
      /// tau,z of {xz, yz} with its derivatives along y up to the third; minus
      /// sigma_zz,zz; the second and the third derivative of gamma.
      std::array<Profile, 4> shear;
      Profile                normal;
      std::array<Profile, 2> strain;
      /// The largest of the stresses.
      double in_plane = 0.;
    };

    /// The places through a layer, for line polynomials of @p degree there.
    void
    make_nodes(const unsigned int degree);
    /// The compliances, stiffnesses and axes of the plies.
    void
    make_plies();
    /// The length on which torsion decays from a free side.
    double
    torsional_decay() const;
    const Column &
    column_at(const double x, const double y);
    Column
    make_column(const double x, const double y);
    /// Takes @p missed off @p column in proportion to the height, which closes
    /// it on the upper face.
    void
    distribute(const dealii::Tensor<1, 3> &missed, Column &column) const;
    /// {sigma_xz, sigma_yz, sigma_zz} of @p column at the height @p z, in the
    /// layer of @p ply that holds it or is nearest to it.
    dealii::Tensor<1, 3>
    transverse_stress(const Column      &column,
                      const unsigned int ply,
                      const double       z) const;
    /// The cells over (x, y), bottom to top.
    std::vector<Layer>
    layers_at(const double x, const double y) const;
    /// The stencil of the place @p through of the body for derivatives along
    /// its coordinate @p d, 0 or 1, up to the fourth.
    Stencil
    stencil(const unsigned int d, const dealii::Point<3> &through) const;
    Sources
    sources(const std::vector<Layer> &layers, const double x, const double y);
    /// phi of a side and its derivative along x.
    struct EdgeShape
    {
      double value, slope;
    };
    EdgeShape
    edge_shape(const unsigned int side, const double x) const;
    /// What free sides take off sigma_xy, and off its derivative along x, each
    /// with derivatives along y.
    struct EdgeShare
    {
      dealii::Tensor<1, 5> of_value, of_slope;
    };
    /// At the places of each of @p layers where stresses are taken.
    std::vector<EdgeShare>
    edge_shares(const std::vector<Layer> &layers,
                const double              x,
                const double              y);
    /// e at a side less its mean through the thickness, with derivatives along
    /// y, at these places.
    const std::vector<dealii::Tensor<1, 5>> &
    edge_stress(const unsigned int        side,
                const std::vector<Layer> &layers,
                const double              y);
    /// Those of layer number @p k into @p all, less @p edges_here.
    void
    add_sources(const unsigned int            k,
                const Layer                  &layer,
                const std::vector<EdgeShare> &edges_here,
                const Stencil                &along_x,
                const Stencil                &along_y,
                Sources                      &all);
    /// sigma_xx, yy, xy and gamma_xz, yz of the element.
    using Sampled = std::array<double, 5>;
    /// By the number of derivatives along x and along y: those of Sampled.
    using Derivatives = std::array<std::array<dealii::Tensor<1, 5>, 5>, 3>;
    /// At the height @p z of @p ply. @p in_plane becomes the largest of the
    /// stresses that they are made of, if it was less.
    Derivatives
    derivatives_at(const double       z,
                   const unsigned int ply,
                   const Stencil     &along_x,
                   const Stencil     &along_y,
                   double            &in_plane);
    /// At @p x of the body, inside of an element of @p ply; each point is
    /// sampled once.
    const Sampled &
    sampled_at(const dealii::Point<3> &x, const unsigned int ply);
    /// @p start + int f dz from the lower face on, of a profile of one or two
    /// components; @p start has one entry each.
    Profile
    integral(const std::vector<Layer>  &layers,
             const Profile             &f,
             const std::vector<double> &start) const;
    /// The stresses {xy, yy} of strains that are @p displacement (per length
    /// along y), {x, y}: Q of plane stress.
    Profile
    plane_stress(const std::vector<Layer> &layers,
                 const Profile            &displacement) const;
    /// int sigma dz of {xy, yy}, then int sigma z / H dz.
    std::array<double, 4>
    resultants(const std::vector<Layer> &layers, const Profile &stress) const;
    /// @p stress with that of a displacement linear in z, a + b z, which takes
    /// its resultants away.
    Profile
    without_resultants(const std::vector<Layer> &layers, Profile stress) const;
    /// The correction delta of shear stresses and its derivative along y; zero
    /// where it is none. @p shear: tau_0 with its derivatives.
    std::array<Profile, 2>
    correction(const std::vector<Layer>     &layers,
               const std::array<Profile, 4> &shear,
               const std::array<Profile, 2> &strain) const;
    /// P above: delta of e'', for tau'' = @p shear and gamma'' = @p strain.
    Profile
    warped(const std::vector<Layer> &layers,
           const Profile            &shear,
           const Profile            &strain) const;
    /// {sigma_xz, sigma_yz, sigma_zz} that the traction on a face asks for.
    dealii::Tensor<1, 3>
    face_stress(const unsigned int face, const double x, const double y) const;
    /// The height of node @p i of @p layer.
    double
    height(const Layer &layer, const unsigned int i) const
    {
      return layer.bottom + nodes[i] * (layer.top - layer.bottom);
    }

    const Body       &body;
    const Vector     &u;
    const LaminateBox box;
    StressRecovery    recovery;
    /// Of the lower and the upper face.
    std::vector<FaceTractions::OnFace> faces;
    /// The sides x = 0 and x = W; the length on which torsion decays from them.
    std::array<bool, 2> is_free{};
    double              decay = 0.;
    /// Strains, and so stresses, from the scene's axes to the body's and back.
    ElasticTensor to_body, to_scene;

    /// Places through a layer, from 0 to 1: those where stresses are taken, and
    /// the nodes of what is made of them, with their weights; from values at
    /// the former to those at nodes, and from these to int_0^t at nodes.
    std::vector<double>        samples, sample_weights, nodes, node_weights;
    dealii::FullMatrix<double> to_nodes, integrate;
    /// By plies, {xz, yz}: strains of stresses; and of {xy, yy} in plane stress
    /// (sigma_zz as it is) stresses of strains.
    std::vector<dealii::Tensor<2, 2>> shear_compliance, plane_stiffness;
    /// By plies, in the body's axes.
    std::vector<Triad> ply_frames;

    std::map<std::array<long, 2>, Column> columns;
    /// By side and y, see edge_stress().
    std::map<std::array<long, 2>, std::vector<dealii::Tensor<1, 5>>> edges;
    std::map<std::array<long, 3>, Sampled>                           sampled;
    ClosureError                                                     closure;
  };
} // namespace lamella

#endif
