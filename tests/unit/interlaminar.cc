// SPDX-License-Identifier: LGPL-2.1-or-later

// Transverse stresses by equilibrium: against the exact solution of
// cylindrical bending with one L9 a ply, where the element's own are a tenth
// off and more; against Jourawski's parabola, which is exact for a rectangle
// without Poisson's ratio; continuity, faces, closure and contact pressures.

#include "pagano_strip.h"

#include <lamella/base/exceptions.h>
#include <lamella/body/solid.h>
#include <lamella/recover/interlaminar.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(interlaminar)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr unsigned int zz = 2, xz = 4, yz = 5;

  const std::vector<std::vector<double>> layups{{0., 90., 0.}, {0., 90.}};



  /// A strip of one L9 a ply and @p elements B4, solved.
  struct Strip
  {
    Strip(const std::vector<double> &angles,
          const double               slenderness,
          const unsigned int         elements)
      : exact(exact_solution(angles, slenderness))
      , structure(
          half_strip(make_section(rectangle(1., 1., angles), graphite_epoxy, 2),
                     slenderness,
                     elements))
      , u(solution(structure))
      , tractions({pagano_load(slenderness)}, 1.)
      , equilibrium(body(), 0, u, tractions, "here")
    {}

    const Body &
    body() const
    {
      return *structure.bodies()[0];
    }

    Location
    at(const double y, const double z, const unsigned int ply) const
    {
      const auto places = body().locate({{0.3, y, z}});
      for (const Location &location : places[0])
        if (location.ply == ply)
          return location;
      throw std::logic_error("no such place");
    }

    PaganoSolution    exact;
    Structure         structure;
    Vector            u;
    FaceTractions     tractions;
    EquilibriumStress equilibrium;
  };



  /// The largest errors, of sigma_yz over its largest value, of sigma_zz over
  /// the load; at interfaces of sigma_yz over what it is there.
  struct Errors
  {
    double yz = 0., zz = 0., yz_interface = 0., yz_element = 0., defect = 0.;
  };



  /// At the support, where sigma_yz is largest, at mid-span, where sigma_zz is,
  /// at nodes of the axis and between them; 11 heights a ply.
  Errors
  errors(Strip &strip)
  {
    Errors       worst;
    const auto  &plies = strip.exact.stack();
    const double S     = strip.exact.length();
    const auto   value = [&](const double y, const double z, unsigned int ply) {
      return strip.exact(y, z, ply).stress;
    };
    double largest = 0.;
    for (unsigned int i = 0; i < plies.size(); ++i)
      for (unsigned int k = 0; k <= 40; ++k)
        largest =
          std::max(largest,
                   std::abs(value(0.,
                                  plies[i].bottom +
                                    (plies[i].top - plies[i].bottom) * k / 40.,
                                  i)[yz]));
    for (const double y : {0., 0.07 * S, 0.21 * S, 0.25 * S, 0.4 * S, 0.5 * S})
      for (unsigned int i = 0; i < plies.size(); ++i)
        for (unsigned int k = 0; k <= 10; ++k)
          {
            const double z =
              plies[i].bottom + (plies[i].top - plies[i].bottom) * k / 10.;
            const Location where = strip.at(y, z, i);
            const Voigt    found = strip.equilibrium.sample(where).stress;
            const Voigt    own   = strip.body().sample(where, strip.u).stress;
            const Voigt    exact = value(y, z, i);
            const auto     raise = [](double &to, const double by) {
              to = std::max(to, std::abs(by));
            };
            raise(worst.yz, (found[yz] - exact[yz]) / largest);
            raise(worst.yz_element, (own[yz] - exact[yz]) / largest);
            raise(worst.zz, found[zz] - exact[zz]);
            if (k == 10 && i + 1 < plies.size() && y < 0.45 * S)
              raise(worst.yz_interface, found[yz] / exact[yz] - 1.);
          }
    worst.defect = strip.equilibrium.reset_defect().relative();
    return worst;
  }



  /// A cantilever of the isotropic material without Poisson's ratio under a
  /// shear force V = 1 on its end, one L9 a ply, at @p placement.
  Solved
  cantilever(const Placement &placement, const Laminate &laminate)
  {
    const EngineeringConstants material =
      EngineeringConstants::isotropic(100., 0.);
    const Tensor<1, 3> force = placement.vector_to_scene(Point<3>(0., 0., 1.)) /
                               (laminate.width * laminate.height());
    return solve_linear(
      std::make_unique<Beam>("cantilever",
                             make_section(laminate, material, 2),
                             make_axis(30., 18),
                             placement),
      {clamp("start")},
      {traction("end", digits(force[0]), digits(force[1]), digits(force[2]))});
  }
} // namespace

BOOST_AUTO_TEST_CASE(cylindrical_bending)
{
  for (const auto &angles : layups)
    for (const double S : {4., 10., 50.})
      {
        Strip        strip(angles, S, 16);
        const Errors e = errors(strip);
        BOOST_TEST_MESSAGE(
          angles.size() << " plies, S = " << S << ": sigma_yz " << 100. * e.yz
                        << " %, at interfaces " << 100. * e.yz_interface
                        << " %, sigma_zz " << 100. * e.zz << " %, closure "
                        << 100. * e.defect << " %; the elements' sigma_yz "
                        << 100. * e.yz_element << " %");
        BOOST_TEST(e.yz < 5e-3);
        BOOST_TEST(e.yz_interface < 5e-3);
        BOOST_TEST(e.zz < 2e-2);
        BOOST_TEST(e.defect < 2e-2);
        BOOST_TEST(e.yz_element > 5e-2);
      }
}



BOOST_AUTO_TEST_CASE(converges_along_the_axis)
{
  // Derivatives of a polynomial of degree 4 through superconvergent points:
  // sigma_yz wants one, the correction three, of an order h^2 or better.
  for (const auto &angles : layups)
    {
      std::vector<double> of;
      for (const unsigned int n : {4, 8, 16})
        {
          Strip strip(angles, 10., n);
          of.push_back(errors(strip).yz);
        }
      BOOST_TEST_MESSAGE(angles.size()
                         << " plies: rates " << std::log2(of[0] / of[1])
                         << " and " << std::log2(of[1] / of[2]));
      BOOST_TEST(std::log2(of[0] / of[1]) > 1.8);
      BOOST_TEST(std::log2(of[1] / of[2]) > 1.8);
    }
}



BOOST_AUTO_TEST_CASE(continuous_and_zero_on_free_faces)
{
  for (const auto &angles : layups)
    {
      Strip       strip(angles, 4., 6);
      const auto &plies = strip.exact.stack();
      for (const double y : {0., 0.3, 1., 1.7})
        {
          const auto at = [&](const double z, const unsigned int ply) {
            return strip.equilibrium.sample(strip.at(y, z, ply)).stress;
          };
          double largest = 0.;
          for (unsigned int i = 0; i < plies.size(); ++i)
            largest =
              std::max(largest,
                       std::abs(
                         at(0.5 * (plies[i].bottom + plies[i].top), i)[yz]));
          for (unsigned int i = 0; i + 1 < plies.size(); ++i)
            for (const unsigned int c : {zz, xz, yz})
              BOOST_TEST(
                std::abs(at(plies[i].top, i)[c] - at(plies[i].top, i + 1)[c]) <
                1e-10 * largest);
          const Voigt  bottom = at(0., 0), top = at(1., plies.size() - 1);
          const double q = std::sin(pi * y / 4.);
          for (const unsigned int c : {zz, xz, yz})
            {
              BOOST_TEST(std::abs(bottom[c]) < 1e-10 * largest);
              BOOST_TEST(std::abs(top[c] - (c == zz ? q : 0.)) <
                         1e-10 * largest);
            }
        }
      // What was distributed is not nothing, and is said.
      BOOST_TEST(strip.equilibrium.reset_defect().relative() > 1e-6);
      BOOST_TEST(strip.equilibrium.reset_defect().largest == 0.);
    }
}



BOOST_AUTO_TEST_CASE(jourawski)
{
  // sigma_yz = 3 V / (2 A) (1 - (2 z / h - 1)^2) and nothing else: u_y has the
  // cubic warping that L9 does not, here of one cell, of three plies with
  // several cells, upright and askew. Seven heights from either end, whose
  // disturbances the polynomials must not see.
  const Laminate one   = rectangle(0.6, 2.),
                 three = rectangle(0.6, 2., {0., 0., 0.}, 2, 2);
  const Placement oblique_placement =
    Placement::from_directions({1., 2., -3.},
                               Point<3>(1., 2., 0.5),
                               Point<3>(-0.3, 0.2, 1.));
  for (const Laminate &laminate : {one, three})
    for (const Placement &placement : {Placement(), oblique_placement})
      {
        const Solved        solved = cantilever(placement, laminate);
        const Body         &body   = *solved.structure->bodies()[0];
        const FaceTractions none;
        EquilibriumStress   equilibrium(
          body, 0, solved.state.u.block(0), none, "here");
        for (const double x : {0.1, 0.3, 0.47})
          for (const double z : {0., 0.3, 2. / 3., 1., 1.9, 2.})
            {
              const Point<3> place = placement.to_scene({x, 14.2, z});
              const auto     found = body.locate({place});
              for (const Location &location : found[0])
                {
                  const FieldSample sample = equilibrium.sample(location);
                  const Voigt       stress =
                    transpose(placement.strain_to_scene()) * sample.stress;
                  const double expected =
                    1.5 / (0.6 * 2.) * (1. - (z - 1.) * (z - 1.));
                  BOOST_TEST(std::abs(stress[yz] - expected) < 1e-6);
                  BOOST_TEST(std::abs(stress[xz]) < 1e-6);
                  BOOST_TEST(std::abs(stress[zz]) < 1e-6);
                  // Fibers run along y: 1 is y, 3 is z.
                  BOOST_TEST(std::abs(sample.ply_stress[4] - stress[yz]) <
                             1e-10);
                }
            }
        BOOST_TEST(equilibrium.reset_defect().relative() < 1e-6);
      }
}



namespace
{
  /// A strip 10 x 1 x 40 with @p cells across and through, clamped and twisted
  /// by T = 1.
  Solved
  twisted_strip(const unsigned int cells, const unsigned int through)
  {
    const double      c = 12. / (10. * 1. * (100. + 1.));
    const std::string a = digits(c);
    return solve_linear(
      std::make_unique<Beam>(
        "strip",
        make_section(rectangle(10., 1., {0.}, cells, through),
                     EngineeringConstants::isotropic(1., 0.),
                     2),
        make_axis(40., 10),
        Placement()),
      {clamp("start")},
      {traction("end", a + " * (z - 0.5)", "0", "-" + a + " * (x - 5)")});
  }



  /// Saint-Venant's torsion of that strip, by its series (Timoshenko and
  /// Goodier, Art. 109): tau_yz at the middle of the short side, and its
  /// integral from there to the middle of the strip, which is -int tau_xy dz
  /// over the upper half of what is there.
  std::array<double, 2>
  torsion_of_short_side()
  {
    double J = 0., tau = 0., force = 0.;
    for (int n = 1, sign = 1; n < 400; n += 2, sign = -sign)
      {
        const double k = n * pi * 10. / 2.;
        J += std::tanh(k) / std::pow(n, 5);
        tau += sign * std::tanh(k) / (n * n);
        force += sign * (1. - 1. / std::cosh(k)) / std::pow(n, 3);
      }
    J = 10. / 3. * (1. - 192. / (std::pow(pi, 5) * 10.) * J);
    return {{8. / (pi * pi) * tau / J, 8. / std::pow(pi, 3) * force / J}};
  }
} // namespace



BOOST_AUTO_TEST_CASE(torsion_at_free_edges)
{
  // Cells that are 2.5 times as wide as the strip is thick know little of what
  // happens at its edges; cells of a quarter resolve it. The resultant is
  // there with both, the peak nearly. A side that is held is no free edge.
  const auto [peak, resultant] = torsion_of_short_side();
  for (const auto &[cells, through] :
       {std::array<unsigned int, 2>{{4, 1}}, {{40, 3}}})
    {
      const Solved        solved = twisted_strip(cells, through);
      const Body         &body   = *solved.structure->bodies()[0];
      const Vector       &u      = solved.state.u.block(0);
      const FaceTractions none, held({}, 1., {clamp("left"), clamp("right")});
      EquilibriumStress   free(body, 0, u, none, "here"),
        fixed(body, 0, u, held, "here");
      const auto place = [&body](const double x) {
        return body.locate({{x, 20., 0.5}})[0].front();
      };
      // By Simpson's rule over 0 to 5, fine where it falls.
      const auto integral = [&](EquilibriumStress &of) {
        double sum = 0.;
        for (const auto &[begin, end] :
             {std::pair<double, double>{0., 1.}, {1., 2.}, {2., 5.}})
          for (unsigned int k = 0; k <= 20; ++k)
            sum += (end - begin) / 60. *
                   (k % 20 == 0 ? 1. :
                    k % 2 == 0  ? 2. :
                                  4.) *
                   of.sample(place(begin + (end - begin) * k / 20.)).stress[yz];
        return sum;
      };
      const double edge = free.sample(place(0.)).stress[yz],
                   own  = body.sample(place(0.), u).stress[yz];
      BOOST_TEST_MESSAGE(cells
                         << " cells: resultant " << integral(free) / resultant
                         << " of the exact one, where the sides are held "
                         << integral(fixed) / resultant << ", peak "
                         << edge / peak << ", of the element " << own / peak);
      BOOST_TEST(std::abs(std::abs(integral(free)) / resultant - 1.) < 0.05);
      BOOST_TEST(std::abs(std::abs(edge) / peak - 1.) < 0.2);
      BOOST_TEST(std::abs(edge + free.sample(place(10.)).stress[yz]) <
                 1e-6 * peak);
      BOOST_TEST(std::abs(free.sample(place(5.)).stress[yz]) < 1e-6 * peak);
      if (cells == 4)
        BOOST_TEST(std::abs(integral(fixed)) < 0.7 * resultant);
    }
}



BOOST_AUTO_TEST_CASE(tractions_on_a_face)
{
  // A grid of 2 x 3 nodes on the plane z = 1, lambda / A = 10 k and a shear of
  // k (1, -2, 0): linear between them, nothing beyond, and nothing on the other
  // face. The bodies press each other alike, and rub each other the other way.
  const Polygon square{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
  std::vector<SlaveSurface::Facet> facets;
  for (unsigned int j = 0; j < 2; ++j)
    {
      const double y = j;
      facets.push_back(
        {FacetMap(
           1,
           1,
           {{0., y, 1.}, {1., y, 1.}, {0., y + 1., 1.}, {1., y + 1., 1.}}),
         1,
         1,
         {2 * j, 2 * j + 1, 2 * j + 2, 2 * j + 3},
         {},
         {square}});
      for (const unsigned int node : facets.back().nodes)
        facets.back().rows.push_back({{node, 1.}});
    }
  ContactInterface contact;
  contact.first_body  = 0;
  contact.second_body = 1;
  contact.surface =
    std::make_shared<const SlaveSurface>(SlaveSurface::Functions::hats,
                                         6,
                                         facets);
  std::vector<double>               forces;
  std::vector<dealii::Tensor<1, 3>> shears;
  for (unsigned int k = 0; k < 6; ++k)
    {
      ContactInterface::Point point;
      point.first   = Point<3>(k % 2, k / 2, 1.);
      point.second  = point.first;
      point.normal  = Point<3>(0., 0., 1.);
      point.area    = k / 2 == 1 ? 0.5 : 0.25;
      point.spacing = 1.;
      contact.points.push_back(point);
      forces.push_back(10. * k * point.area);
      shears.push_back(k * point.area * Point<3>(1., -2., 0.));
    }
  FaceTractions all;
  all.add_contact(contact,
                  dealii::make_array_view(forces),
                  dealii::make_array_view(shears));
  FaceTractions::Face face{
    0, "top", Point<3>(0., 0., 1.), Point<3>(0., 0., 1.), 1e-6};
  const FaceTractions::OnFace top(all, face);
  BOOST_TEST(std::abs(top(Point<3>(0., 0., 1.))[2]) < 1e-12);
  BOOST_TEST((top(Point<3>(1., 2., 1.)) - Point<3>(-5., 10., -50.)).norm() <
             1e-12);
  BOOST_TEST(std::abs(top(Point<3>(0.25, 1.5, 1.))[2] + 32.5) < 1e-12);
  BOOST_TEST(std::abs(top(Point<3>(0.25, 2.5, 1.))[2]) < 1e-12);
  // The other body is pressed from above as well, on a face that looks down.
  face.body   = 1;
  face.normal = Point<3>(0., 0., -1.);
  const FaceTractions::OnFace below(all, face);
  BOOST_TEST((below(Point<3>(1., 2., 1.)) - Point<3>(5., -10., 50.)).norm() <
             1e-12);
  face.body = 0;
  const FaceTractions::OnFace wrong_way(all, face);
  BOOST_TEST(wrong_way(Point<3>(1., 2., 1.)).norm() == 0.);
}



BOOST_AUTO_TEST_CASE(only_laminates)
{
  const auto mesh =
    make_section_mesh(rectangle(1., 1.), {{"material", graphite_epoxy}});
  AxisMesh axis;
  axis.length   = 2.;
  axis.elements = {2};
  const Solid solid("block", mesh, axis, Placement(), 2);
  BOOST_CHECK_THROW(laminate_box(solid, "here"), InputError);
  const Beam        beam("strip",
                  make_section(mesh, 2),
                  make_axis(2., 2),
                  Placement());
  const LaminateBox box = laminate_box(beam, "here");
  BOOST_TEST((box.size - Point<3>(1., 2., 1.)).norm() < 1e-12);
  BOOST_TEST(box.frame.origin.norm() < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
