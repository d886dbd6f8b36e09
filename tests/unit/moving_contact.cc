// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact on surfaces that have moved: rows are tangent planes of the gap,
// whatever the state; who faces whom is found anew where bodies have slid; a
// pairing that has grown stale is said to be.

#include "contact_fixtures.h"

#include <lamella/body/parameters.h>
#include <lamella/contact/contact.h>

#include <deal.II/lac/full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

BOOST_AUTO_TEST_SUITE(moving_contact)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double width = 2., height = 1., distance = 0.02;



  BodyDescription
  description(const std::string &theory,
              const std::string &name,
              const Point<3>    &origin,
              const double       length,
              const unsigned int elements)
  {
    BodyDescription body;
    body.name             = name;
    body.section          = "strip";
    body.theory           = Theory::parse({"Theory", theory});
    body.axis.length      = length;
    body.axis.elements    = {elements};
    body.placement.origin = origin;
    return body;
  }



  /// A short one above a longer one.
  Bodies
  two_strips(const std::string &upper,
             const std::string &lower,
             const unsigned int elements = 3)
  {
    return make_bodies(
      {description(upper, "upper", {0., 2., height + distance}, 4., elements),
       description(lower, "lower", {}, 10., 5)},
      {{"strip",
        make_section_mesh(rectangle(width, height, {0.}),
                          {{"material", Material(soft)}})}});
  }



  ContactPair
  between(const Discretization            discretization,
          std::shared_ptr<const Obstacle> obstacle = nullptr)
  {
    ContactPair contact;
    contact.name           = "touch";
    contact.first          = {0, Region::Kind::surface, "bottom", {}};
    contact.second         = {1, Region::Kind::surface, "top", {}};
    contact.obstacle       = std::move(obstacle);
    contact.enforcement    = Enforcement::penalty;
    contact.penalty        = {PenaltyKind::per_node, 1.};
    contact.discretization = discretization;
    contact.slave_side     = SlaveSide::first;
    return contact;
  }



  /// The DoFs of u(x) = G x + c, which all these bodies have.
  Vector
  affine(const Body &body, const Tensor<2, 3> &G, const Tensor<1, 3> &c = {})
  {
    const auto                 places = body.body_points();
    const auto                 rows   = body.rows(places, undisplaced);
    dealii::FullMatrix<double> normal(body.n_dofs(), body.n_dofs());
    Vector                     right(body.n_dofs()), u(body.n_dofs());
    for (unsigned int k = 0; k < places.size(); ++k)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double target = G[i] * places[k].position + c[i];
          for (const auto &[a, w] : rows[k][i].entries())
            {
              right[a] += w * target;
              for (const auto &[b, v] : rows[k][i].entries())
                normal(a, b) += w * v;
            }
        }
    normal.gauss_jordan();
    normal.vmult(u, right);
    return u;
  }



  /// R - 1 of a turn by @p angle about an axis askew.
  Tensor<2, 3>
  rotation(const double angle)
  {
    Tensor<1, 3> axis({1., 0.4, -0.3});
    axis /= axis.norm();
    Tensor<2, 3> K;
    K[0][1] = -axis[2];
    K[0][2] = axis[1];
    K[1][0] = axis[2];
    K[1][2] = -axis[0];
    K[2][0] = -axis[1];
    K[2][1] = axis[0];
    return std::sin(angle) * K + (1. - std::cos(angle)) * K * K;
  }



  BlockVector
  both(const Bodies &bodies, const Tensor<2, 3> &G, const Tensor<1, 3> &c = {})
  {
    BlockVector u = zero(bodies);
    for (unsigned int b = 0; b < 2; ++b)
      u.block(b) = affine(*bodies[b], G, c);
    return u;
  }



  BlockVector
  any(const Bodies &bodies, const unsigned int seed)
  {
    BlockVector u = zero(bodies);
    for (unsigned int b = 0; b < 2; ++b)
      u.block(b) = any_displacement(*bodies[b], seed + b);
    return u;
  }



  /// A contact with its constraints and pairing at the last call.
  struct PairedContact
  {
    PairedContact(const ContactPair &pair, const Bodies &bodies)
      : contact(pair, bodies, interface, history)
    {}

    const std::vector<GapConstraint> &
    rows() const
    {
      return interface.rows;
    }

    void
    pair(const BlockVector &u, const LoadFactor &factor)
    {
      interface = contact.pair(u, factor, history);
    }

    void
    move(const BlockVector &u, const LoadFactor &factor)
    {
      interface = contact.evaluate(u, factor, std::move(interface), history);
    }

    void
    begin_step(const BlockVector &u, const LoadFactor &factor)
    {
      contact.begin_step(u, factor, history, interface);
    }

    unsigned int
    count_missing(const BlockVector &u) const
    {
      return contact.count_missing_constraints(u, 0., interface);
    }

    ContactInterface interface;
    ContactHistory   history;
    const Contact    contact;
  };



  /// The largest difference between the rows at @p u and central differences of
  /// the gap along @p d.
  double
  off_from_differences(PairedContact     &contact,
                       const BlockVector &u,
                       const BlockVector &d)
  {
    constexpr double    h = 1e-5, factor = 0.7;
    std::vector<double> slope, gap, change(contact.rows().size());
    contact.pair(u, factor);
    for (const GapConstraint &row : contact.rows())
      {
        slope.push_back(row.jump(d));
        gap.push_back(row.gap(u, factor));
      }
    change.assign(contact.rows().size(), 0.);
    for (const double step : {-h, h})
      {
        BlockVector near = u;
        near.add(step, d);
        contact.move(near, factor);
        for (unsigned int k = 0; k < change.size(); ++k)
          change[k] += contact.rows()[k].gap(near, factor) / (2. * step);
      }
    double worst = 0.;
    for (unsigned int k = 0; k < change.size(); ++k)
      worst = std::max(worst, std::abs(change[k] - slope[k]));
    // The obstacle's motion is part of the tangent plane, too.
    contact.move(u, factor + h);
    for (unsigned int k = 0; k < change.size(); ++k)
      worst = std::max(worst,
                       std::abs(contact.rows()[k].gap(u, factor + h) - gap[k] -
                                h * contact.rows()[k].gap_rate));
    return worst;
  }



  std::shared_ptr<const Obstacle>
  obstacle(const Obstacle::Shape shape)
  {
    return std::make_shared<const Obstacle>(
      shape == Obstacle::Shape::plane ?
        Obstacle{"floor",
                 shape,
                 {0., 0., 0.9},
                 Tensor<1, 3>({0., 0., 1.}),
                 0.,
                 Tensor<1, 3>({0., 0.1, 0.05})} :
        Obstacle{"roller",
                 shape,
                 {0., 4., -8.},
                 Tensor<1, 3>({1., 0., 0.}),
                 9.,
                 Tensor<1, 3>({0., 0.1, 0.05})});
  }
} // namespace



BOOST_AUTO_TEST_CASE(rows_are_gradients_of_the_gap_at_any_state)
{
  for (const std::string theory :
       {"LE-1", "LE-2", "TE-2", "solid-1", "solid-2"})
    for (const auto discretization : {Discretization::node_to_surface,
                                      Discretization::surface_to_surface,
                                      Discretization::edge_to_surface})
      for (const unsigned int against : {0, 1, 2})
        BOOST_TEST_CONTEXT(theory << ' ' << name_of(discretization)
                                  << " against " << against)
        {
          if (discretization == Discretization::edge_to_surface && against > 0)
            continue;
          const Bodies  bodies = two_strips(theory, theory);
          PairedContact contact(
            between(discretization,
                    against == 0 ?
                      nullptr :
                      obstacle(against == 1 ? Obstacle::Shape::plane :
                                              Obstacle::Shape::cylinder)),
            bodies);
          // Turned, slid along and across, and bent anyhow.
          BlockVector u =
            against == 0 ? both(bodies, rotation(0.6)) : zero(bodies);
          u.block(0) += affine(*bodies[0], {}, Tensor<1, 3>({0.2, 1.1, 0.3}));
          u.add(0.02, any(bodies, 1));
          BOOST_TEST(off_from_differences(contact, u, any(bodies, 5)) < 1e-6);
        }
}



BOOST_AUTO_TEST_CASE(pairs_of_nodes_that_face_each_other)
{
  // Their rows leave out what the sideways offset multiplies; here it is none.
  const Bodies bodies =
    make_bodies({description("LE-2", "upper", {0., 0., 1.02}, 4., 3),
                 description("LE-2", "lower", {}, 4., 3)},
                {{"strip",
                  make_section_mesh(rectangle(width, height, {0.}),
                                    {{"material", Material(soft)}})}});
  PairedContact contact(between(Discretization::node_to_node), bodies);
  BOOST_TEST(off_from_differences(contact,
                                  both(bodies, rotation(0.6)),
                                  any(bodies, 5)) < 1e-6);
}



BOOST_AUTO_TEST_CASE(flat_faces_that_have_not_moved_keep_their_rows)
{
  for (const auto discretization : {Discretization::node_to_node,
                                    Discretization::node_to_surface,
                                    Discretization::surface_to_surface})
    BOOST_TEST_CONTEXT(name_of(discretization))
    {
      const bool    nodes  = discretization == Discretization::node_to_node;
      const Bodies  bodies = two_strips("LE-2", nodes ? "LE-2" : "TE-2", 2);
      PairedContact contact(between(discretization), bodies);
      const std::vector<GapConstraint> before = contact.rows();
      const BlockVector                u = zero(bodies), d = any(bodies, 3);
      contact.move(u, 0.);
      BOOST_REQUIRE(contact.rows().size() == before.size());
      for (unsigned int k = 0; k < before.size(); ++k)
        {
          BOOST_TEST(std::abs(contact.rows()[k].jump(d) - before[k].jump(d)) <
                     1e-11);
          BOOST_TEST(std::abs(contact.rows()[k].initial_gap -
                              before[k].initial_gap) < 1e-12);
        }
      BOOST_TEST(contact.count_missing(u) == 0u);
    }
}



BOOST_AUTO_TEST_CASE(a_turn_of_both_bodies_changes_no_gap)
{
  for (const auto discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    for (const double angle : {0.3, 1., std::acos(-1.)})
      BOOST_TEST_CONTEXT(name_of(discretization) << " by " << angle)
      {
        const Bodies  bodies = two_strips("LE-1", "TE-2");
        PairedContact contact(between(discretization), bodies);
        BlockVector   u = both(bodies, rotation(angle));
        contact.move(u, 0.);
        for (const GapConstraint &row : contact.rows())
          BOOST_TEST(std::abs(row.gap(u, 0.) - distance) < 1e-10);
        BOOST_TEST(contact.count_missing(u) == 0u);
        // Nor does a small turn on top of it, about any axis of the scene.
        for (unsigned int axis = 0; axis < 3; ++axis)
          {
            Tensor<2, 3> small;
            small[axis][(axis + 1) % 3] = 1.;
            small[(axis + 1) % 3][axis] = -1.;
            const BlockVector d = both(bodies, small * rotation(angle) + small);
            for (const GapConstraint &row : contact.rows())
              BOOST_TEST(std::abs(row.jump(d)) < 1e-9);
          }
      }
}



BOOST_AUTO_TEST_CASE(what_slides_far_faces_other_places)
{
  for (const auto discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    BOOST_TEST_CONTEXT(name_of(discretization))
    {
      const Bodies  bodies = two_strips("LE-2", "LE-1");
      PairedContact contact(between(discretization), bodies),
        anew(between(discretization), bodies);
      // The lower one with a hollow that is not everywhere the same.
      BlockVector u = zero(bodies);
      u.add(0.01, any(bodies, 2));
      u.block(0) = affine(*bodies[0], {}, Tensor<1, 3>({0., 3.3, -distance}));
      // From rows that were moved to another place.
      contact.move(zero(bodies), 0.);
      contact.move(u, 0.);
      // The same gaps as those of a search where it stands: exactly at nodes;
      // in the mean but for where the points are. Nodes at the sides of the
      // lower one, which has become narrower here and there, face nothing, by
      // the one projection or the other.
      anew.pair(u, 0.);
      const double same =
        discretization == Discretization::node_to_surface ? 1e-10 : 2e-3;
      unsigned int compared = 0;
      for (unsigned int k = 0; k < contact.rows().size(); ++k)
        {
          const auto is_here = [&](const ContactInterface::Point &point) {
            return point.node.position ==
                   contact.interface.points[k].node.position;
          };
          const auto found         = std::find_if(anew.interface.points.begin(),
                                          anew.interface.points.end(),
                                          is_here);
          const GapConstraint &row = contact.rows()[k];
          if (found == anew.interface.points.end() || row.parts.empty())
            continue;
          const GapConstraint &fresh =
            anew.rows()[found - anew.interface.points.begin()];
          BOOST_TEST(std::abs(row.gap(u, 0.) - fresh.gap(u, 0.)) < same);
          ++compared;
        }
      BOOST_TEST(2 * compared > contact.rows().size());
    }
}



BOOST_AUTO_TEST_CASE(what_is_left_behind_has_no_row_and_what_comes_is_missing)
{
  for (const auto discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    BOOST_TEST_CONTEXT(name_of(discretization))
    {
      // The long one carries the points: some leave the short one's face, and
      // others come under it.
      const Bodies bodies = two_strips("LE-1", "LE-1");
      ContactPair  pair   = between(discretization);
      pair.slave_side     = SlaveSide::second;
      PairedContact contact(pair, bodies);
      BlockVector   u = zero(bodies);
      u.block(0) =
        affine(*bodies[0], {}, Tensor<1, 3>({0., 3.3, -1.1 * distance}));
      BOOST_TEST(contact.count_missing(u) > 0u);
      contact.move(u, 0.);
      // A row that faces nothing any more has no functional.
      BOOST_TEST(
        std::any_of(contact.rows().begin(),
                    contact.rows().end(),
                    [](const auto &row) { return row.parts.empty(); }));
      contact.pair(u, 0.);
      BOOST_TEST(contact.count_missing(u) == 0u);
      for (const GapConstraint &row : contact.rows())
        BOOST_TEST(std::abs(row.gap(u, 0.) + 0.1 * distance) < 1e-10);
    }
}



namespace
{
  Tensor<2, 3>
  unit()
  {
    return dealii::unit_symmetric_tensor<3>();
  }



  /// What rubs: who carries the points, and against what.
  struct FrictionCase
  {
    Discretization                  discretization;
    SlaveSide                       slave_side;
    std::shared_ptr<const Obstacle> against;
  };



  std::string
  words(const FrictionCase &what)
  {
    return std::string(name_of(what.discretization)) + " on " +
           name_of(what.slave_side) + " against " +
           (what.against ? what.against->name : "a body");
  }



  std::vector<FrictionCase>
  friction_cases()
  {
    std::vector<FrictionCase> all;
    for (const auto discretization :
         {Discretization::node_to_surface, Discretization::surface_to_surface})
      {
        for (const auto on : {SlaveSide::first, SlaveSide::second})
          all.push_back({discretization, on, nullptr});
        for (const auto shape :
             {Obstacle::Shape::plane, Obstacle::Shape::cylinder})
          all.push_back({discretization, SlaveSide::first, obstacle(shape)});
      }
    all.push_back({Discretization::edge_to_surface, SlaveSide::first, nullptr});
    return all;
  }



  ContactPair
  pair_of(const FrictionCase &what)
  {
    ContactPair contact = between(what.discretization, what.against);
    contact.slave_side  = what.slave_side;
    contact.friction    = 0.3;
    return contact;
  }



  /// Turned as a whole unless an obstacle stands there, strained, and touching.
  BlockVector
  touching(const Bodies &bodies, const FrictionCase &what)
  {
    Tensor<2, 3> G;
    if (!what.against)
      G = rotation(0.6);
    G[0][0] += 0.02;
    G[1][1] -= 0.03;
    BlockVector u = both(bodies, G);
    u.block(0) +=
      affine(*bodies[0], {}, (unit() + G) * Tensor<1, 3>({0., 0., -distance}));
    return u;
  }



  std::vector<Tensor<1, 2>>
  slips(const PairedContact &contact,
        const BlockVector   &u,
        const LoadFactor    &factor)
  {
    std::vector<Tensor<1, 2>> result;
    for (const GapConstraint &row : contact.rows())
      {
        result.emplace_back();
        for (unsigned int a = 0; a < row.slips.size(); ++a)
          result.back()[a] = row.slips[a].slip(u, factor);
      }
    return result;
  }



  double
  largest(const std::vector<Tensor<1, 2>> &slips)
  {
    double most = 0.;
    for (const Tensor<1, 2> &slip : slips)
      most = std::max(most, slip.norm());
    return most;
  }
} // namespace



BOOST_AUTO_TEST_CASE(slips_are_those_since_the_step_began)
{
  constexpr double h = 1e-5, factor = 0.7;
  for (const FrictionCase &what : friction_cases())
    BOOST_TEST_CONTEXT(words(what))
    {
      const Bodies      bodies = two_strips("LE-2", "LE-2");
      PairedContact     contact(pair_of(what), bodies);
      const BlockVector u = touching(bodies, what), d = any(bodies, 5);
      contact.pair(u, factor);
      contact.begin_step(u, factor);
      BOOST_REQUIRE(!contact.rows().empty());
      BOOST_TEST(largest(slips(contact, u, factor)) < 1e-12);
      std::vector<double> gap;
      for (const GapConstraint &row : contact.rows())
        gap.push_back(std::abs(row.gap(u, factor)));
      // Rows that touch are their gradients there, with the way of an obstacle;
      // the projection of one that does not is moved by turns, too.
      BlockVector near = u;
      near.add(h, d);
      auto predicted = slips(contact, near, factor + h);
      near.add(-2. * h, d);
      const auto back = slips(contact, near, factor - h);
      for (unsigned int k = 0; k < back.size(); ++k)
        predicted[k] -= back[k];
      std::vector<bool> faces(back.size(), true);
      for (const double side : {-1., 1.})
        {
          near = u;
          near.add(side * h, d);
          contact.move(near, factor + side * h);
          const auto found = slips(contact, near, factor + side * h);
          for (unsigned int k = 0; k < found.size(); ++k)
            {
              predicted[k] -= side * found[k];
              faces[k] = faces[k] && !contact.rows()[k].parts.empty();
            }
        }
      for (unsigned int k = 0; k < predicted.size(); ++k)
        if (faces[k])
          BOOST_TEST(predicted[k].norm() < (1e-6 + 10. * gap[k]) * 2. * h);
      // What is paired in the step has slid since it began.
      near = u;
      near.block(0) += affine(*bodies[0], {}, Tensor<1, 3>({0., 0.2, 0.}));
      contact.move(near, factor);
      const double before = largest(slips(contact, near, factor));
      contact.pair(near, factor);
      BOOST_TEST(before > 0.1);
      BOOST_TEST(std::abs(largest(slips(contact, near, factor)) - before) <
                 0.02);
    }
}



BOOST_AUTO_TEST_CASE(bodies_that_turn_together_do_not_slip)
{
  for (const FrictionCase &what : friction_cases())
    if (!what.against)
      BOOST_TEST_CONTEXT(words(what))
      {
        const Bodies      bodies = two_strips("LE-2", "LE-2");
        PairedContact     contact(pair_of(what), bodies);
        const BlockVector start = both(bodies, rotation(0.3));
        contact.pair(start, 0.);
        contact.begin_step(start, 0.);
        const auto        frames = contact.rows();
        const BlockVector turned =
          both(bodies, rotation(1.3), Tensor<1, 3>({3., -1., 2.}));
        contact.move(turned, 0.);
        BOOST_TEST(largest(slips(contact, turned, 0.)) < 1e-11);
        // Their frames have turned along.
        const Tensor<2, 3> by =
          (unit() + rotation(1.3)) * transpose(unit() + rotation(0.3));
        for (unsigned int k = 0; k < frames.size(); ++k)
          for (unsigned int a = 0; a < 2; ++a)
            BOOST_TEST((contact.rows()[k].slips[a].tangent -
                        by * frames[k].slips[a].tangent)
                         .norm() < 1e-11);
        // The upper one slides along the lower one by a known way.
        const Tensor<1, 3> way =
          (unit() + rotation(1.3)) * Tensor<1, 3>({0.1, 0.5, 0.});
        BlockVector slid = turned;
        slid.block(0) += affine(*bodies[0], {}, way);
        // So do points that have left the other surface, and in a new pairing
        // those that have come over it.
        const auto check_slips = [&] {
          for (const GapConstraint &row : contact.rows())
            for (const SlipConstraint &slip : row.slips)
              BOOST_TEST(std::abs(slip.slip(slid, 0.) + way * slip.tangent) <
                         1e-10);
        };
        contact.move(slid, 0.);
        check_slips();
        contact.pair(slid, 0.);
        check_slips();
      }
}



BOOST_AUTO_TEST_CASE(forces_of_a_state_nearby_are_those_of_rows_moved_there)
{
  constexpr double factor = 0.7;
  for (const FrictionCase &what : friction_cases())
    BOOST_TEST_CONTEXT(words(what))
    {
      const Bodies      bodies = two_strips("LE-2", "LE-2");
      PairedContact     contact(pair_of(what), bodies);
      const BlockVector start = touching(bodies, what);
      BlockVector       u     = start;
      contact.pair(start, factor);
      contact.begin_step(start, factor);
      u.add(0.01, any(bodies, 7));
      contact.move(u, factor);
      // At the rims some face nothing there.
      std::vector<bool> faces;
      for (const GapConstraint &row : contact.rows())
        faces.push_back(!row.parts.empty());
      contact.move(start, factor);
      std::vector<double>       lambda;
      std::vector<Tensor<1, 2>> shear;
      for (unsigned int k = 0; k < contact.rows().size(); ++k)
        {
          lambda.push_back(k % 3 == 0 || !faces[k] ? 0. : 1. + 0.1 * k);
          shear.push_back(lambda.back() * Tensor<1, 2>({0.2, -0.1 * (k % 2)}));
        }
      const ContactInterface loaded = contact.contact.evaluate_loaded(
        u,
        factor,
        contact.interface,
        contact.history,
        dealii::ArrayView<const double>(lambda.data(), lambda.size()));
      contact.move(u, factor);
      BlockVector f = zero(bodies), expected = zero(bodies);
      for (unsigned int k = 0; k < lambda.size(); ++k)
        for (auto *on : {&f, &expected})
          {
            const GapConstraint &row =
              on == &f ? loaded.rows[k] : contact.rows()[k];
            if (lambda[k] != 0.)
              row.add_to(*on, lambda[k]);
            for (unsigned int a = 0; a < row.slips.size(); ++a)
              if (lambda[k] != 0.)
                row.slips[a].add_to(*on, shear[k][a]);
          }
      f -= expected;
      BOOST_TEST(f.linfty_norm() < 1e-11 * expected.linfty_norm());
    }
}



BOOST_AUTO_TEST_CASE(slip_is_what_is_across_the_normal)
{
  for (const auto discretization : {Discretization::node_to_node,
                                    Discretization::node_to_surface,
                                    Discretization::surface_to_surface})
    for (const double angle : {0., 0.8})
      BOOST_TEST_CONTEXT(name_of(discretization) << " turned by " << angle)
      {
        const Bodies bodies = two_strips("LE-2", "LE-2", 2);
        ContactPair  pair   = between(discretization);
        pair.friction       = 0.3;
        PairedContact contact(pair, bodies);
        if (angle > 0.)
          contact.move(both(bodies, rotation(angle)), 0.);
        const Tensor<1, 3> shift({0.3, -0.2, 0.5});
        BlockVector        d = zero(bodies), of_both = both(bodies, {}, shift);
        d.block(1) = affine(*bodies[1], {}, shift);
        for (unsigned int k = 0; k < contact.rows().size(); ++k)
          {
            const auto         &slips = contact.rows()[k].slips;
            const Tensor<1, 3> &n     = contact.interface.points[k].normal,
                               &t_1 = slips[0].tangent, &t_2 = slips[1].tangent;
            BOOST_TEST(std::abs(t_1 * n) < 1e-12);
            BOOST_TEST((cross_product_3d(t_1, t_2) - n).norm() < 1e-12);
            for (const SlipConstraint &slip : slips)
              {
                BOOST_TEST(std::abs(slip.jump(d) - shift * slip.tangent) <
                           1e-11);
                // Of both bodies together nothing slips.
                BOOST_TEST(std::abs(slip.jump(of_both)) < 1e-11);
              }
          }
      }
}

BOOST_AUTO_TEST_SUITE_END()
