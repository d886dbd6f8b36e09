// SPDX-License-Identifier: LGPL-2.1-or-later

// Beams whose nodes carry modes, combinations of a section's fields: all that
// they say is what a beam with all fields says of the same displacement. And
// Saint-Venant's states, which lists of Saint-Venant fields hold exactly,
// beside others, too.

#include "fixtures.h"

#include <lamella/adapt/node_fields.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/linear_functional.h>
#include <lamella/body/body_solver.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section_response.h>

#include <boost/test/unit_test.hpp>

#include <complex>
#include <numeric>
#include <random>
#include <set>

BOOST_AUTO_TEST_SUITE(section_space)

using namespace lamella;
using dealii::FullMatrix;
using dealii::Point;

namespace
{
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  using Lists = std::vector<std::vector<unsigned int>>;



  Vector
  random_vector(const unsigned int n, const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Vector                                 v(n);
    for (double &x : v)
      x = uniform(generator);
    return v;
  }



  /// Four plies that couple everything with everything.
  std::shared_ptr<const Section>
  coupled_section(const unsigned int degree = 2)
  {
    return make_section(rectangle(0.7, 0.5, {30., -45., 0., 60.}, 2),
                        orthotropic,
                        degree);
  }



  std::shared_ptr<const SectionSpace>
  random_space(const std::shared_ptr<const Section> &section,
               const unsigned int                    n_modes)
  {
    FieldColumns modes(section->n_fields(), n_modes);
    for (unsigned int j = 0; j < n_modes; ++j)
      {
        const Vector one = random_vector(section->n_fields(), 17 + j);
        std::copy(one.begin(), one.end(), &modes(0, j));
      }
    return std::make_shared<SectionSpace>(section, modes);
  }



  /// The rigid fields and the modes from @p first on.
  std::vector<unsigned int>
  dense_list(const SectionSpace &space, const unsigned int first = 0)
  {
    std::vector<unsigned int> list(6);
    std::iota(list.begin(), list.end(), 0);
    for (unsigned int j = first; j < space.n_modes(); ++j)
      list.push_back(space.first_mode() + j);
    return list;
  }



  /// All fields of the section.
  std::vector<unsigned int>
  whole_list(const SectionSpace &space)
  {
    std::vector<unsigned int> list(space.first_mode());
    std::iota(list.begin(), list.end(), 0);
    return list;
  }



  /// The displacement @p u of @p beam in the DoFs of @p full, which carries all
  /// fields of the section at all nodes.
  Vector
  in_all_fields(const Beam &beam, const Vector &u, const Beam &full)
  {
    Vector result(full.n_dofs());
    for (unsigned int node = 0; node < beam.dofs().n_nodes(); ++node)
      for (unsigned int k = 0; k < beam.dofs().fields(node).size(); ++k)
        {
          const Vector field =
            beam.fields().in_section_functions(beam.dofs().fields(node)[k]);
          for (unsigned int a = 0; a < field.size(); ++a)
            result[full.dofs().first(node) + a] +=
              u[beam.dofs().first(node) + k] * field[a];
        }
    return result;
  }



  /// The transpose of in_all_fields().
  Vector
  in_lists(const Beam &beam, const Vector &f, const Beam &full)
  {
    Vector result(beam.n_dofs());
    for (unsigned int node = 0; node < beam.dofs().n_nodes(); ++node)
      for (unsigned int k = 0; k < beam.dofs().fields(node).size(); ++k)
        {
          const Vector field =
            beam.fields().in_section_functions(beam.dofs().fields(node)[k]);
          for (unsigned int a = 0; a < field.size(); ++a)
            result[beam.dofs().first(node) + k] +=
              f[full.dofs().first(node) + a] * field[a];
        }
    return result;
  }



  void
  check_same(const Vector &found, const Vector &wanted, const double tolerance)
  {
    Vector difference = found;
    difference -= wanted;
    BOOST_TEST(difference.linfty_norm() < tolerance * wanted.linfty_norm());
  }



  /// One element with dense lists, one with all fields at one end, one with
  /// fewer modes, on an axis of the degree @p degree.
  Lists
  mixed_lists(const SectionSpace &space, const unsigned int degree)
  {
    const auto dense = dense_list(space), fewer = dense_list(space, 3),
               whole = whole_list(space);
    Lists lists;
    for (unsigned int node = 0; node <= 3 * degree; ++node)
      lists.push_back(node <= degree     ? dense :
                      node == 3 * degree ? whole :
                      node > 2 * degree  ? fewer :
                                           dense);
    return lists;
  }
} // namespace

BOOST_AUTO_TEST_CASE(lists_of_modes_are_a_projection)
{
  const auto      section   = coupled_section();
  const auto      space     = random_space(section, 5);
  const Placement placement = Placement::from_directions(Point<3>(1., 2., 3.),
                                                         Point<3>(1., 2., 0.5),
                                                         Point<3>(0., 0.3, 1.));
  for (const unsigned int degree : {1, 2, 3})
    {
      const auto axis = make_axis(1.3, 3, degree);
      const Beam full("full", section, axis, placement);
      const Beam beam(
        "beam", space, axis, placement, mixed_lists(*space, degree), "modes");
      const Vector u      = random_vector(beam.n_dofs(), 3);
      const Vector u_full = in_all_fields(beam, u, full);

      // Strain first, and the assembled matrix.
      Vector forces(beam.n_dofs()), all_forces(full.n_dofs());
      beam.add_internal_forces(u, forces);
      full.add_internal_forces(u_full, all_forces);
      const Vector wanted = in_lists(beam, all_forces, full);
      check_same(forces, wanted, 1e-12);
      Constraints none;
      none.close();
      Vector product(beam.n_dofs());
      assembled_stiffness(beam, none)
        ->for_each_entry(
          [&](const DofIndex row, const DofIndex column, const double value) {
            product[row] += value * u[column];
          });
      check_same(product, wanted, 1e-12);
      BOOST_TEST(
        std::abs(beam.deformation(u).energy / full.deformation(u_full).energy -
                 1.) < 1e-12);

      // Rows and samples.
      const Point<3> inside = placement.to_scene({0.21, 0.5, 0.17});
      for (const Quantity quantity :
           {Quantity::displacement, Quantity::strain, Quantity::stress})
        {
          const auto rows = beam.rows({beam.locate({inside})[0][0]},
                                      undisplaced,
                                      quantity)[0],
                     all  = full.rows({full.locate({inside})[0][0]},
                                     undisplaced,
                                     quantity)[0];
          for (unsigned int c = 0; c < rows.size(); ++c)
            BOOST_TEST(std::abs(rows[c](u) - all[c](u_full)) <
                       1e-11 * (1. + std::abs(all[c](u_full))));
        }
      const FieldSample s = beam.sample(beam.locate({inside})[0][0], u),
                        t = full.sample(full.locate({inside})[0][0], u_full);
      BOOST_TEST((s.stress - t.stress).norm() < 1e-11 * t.stress.norm());
      for (const Vector &motion : beam.rigid_motions(undisplaced))
        BOOST_TEST(beam.deformation(motion).energy < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(dense_lists_that_differ)
{
  // Nothing but dense lists, two of them within most elements: forces and
  // energy are still those of all fields, and what a factorization solves is
  // in equilibrium, strain first.
  const auto section = coupled_section();
  const auto space   = random_space(section, 5);
  const auto axis    = make_axis(1.3, 4, 3);
  const auto dense = dense_list(*space), fewer = dense_list(*space, 3);
  Lists      lists;
  for (unsigned int node = 0; node < axis->n_nodes(); ++node)
    lists.push_back(node % 5 < 3 ? dense : fewer);
  const Beam   full("full", section, axis, Placement());
  const Beam   beam("beam", space, axis, Placement(), lists, "modes");
  const Vector u      = random_vector(beam.n_dofs(), 3);
  const Vector u_full = in_all_fields(beam, u, full);
  Vector       forces(beam.n_dofs()), all_forces(full.n_dofs());
  beam.add_internal_forces(u, forces);
  full.add_internal_forces(u_full, all_forces);
  check_same(forces, in_lists(beam, all_forces, full), 1e-12);
  BOOST_TEST(
    std::abs(beam.deformation(u).energy / full.deformation(u_full).energy -
             1.) < 1e-12);

  Constraints clamp;
  for (unsigned int k = 0; k < lists[0].size(); ++k)
    clamp.add_line(beam.dofs().first(0) + k);
  clamp.close();
  Vector load = random_vector(beam.n_dofs(), 5);
  clamp.set_zero(load);
  Vector solution = load;
  make_solver(beam, clamp)->solve(solution);
  clamp.set_zero(solution);
  Vector answer(beam.n_dofs());
  beam.add_internal_forces(solution, answer);
  clamp.set_zero(answer);
  check_same(answer, load, 1e-9);
  // A spring that pushes: the place is said.
  LinearFunctional end;
  end.add(beam.dofs().first(axis->n_nodes() - 1), 1.);
  BOOST_CHECK_EXCEPTION(make_solver(beam, clamp, {{end, -1e9}}),
                        NumericsError,
                        [](const NumericsError &error) {
                          return std::string(error.what())
                                   .find(" first near ") != std::string::npos;
                        });
}


namespace
{
  /// The nodal values of Saint-Venant's state @p k at @p y, in the section's
  /// fields: a polynomial in y.
  Vector
  state_at(const SaintVenant &states, const unsigned int k, const double y)
  {
    Vector u = states.values()[k];
    u.add(y, states.derivatives()[k]);
    // What the derivative is the warping of: a curvature has a rigid section
    // that turns, a shear the curvature, extension and torsion in its b.
    Vector next(u.size());
    if (k == 2 || k == 3)
      next[k == 2 ? RigidField::translation_x : RigidField::translation_z] = 1.;
    if (k >= 4)
      {
        // b of the shear is the value of a curvature with shares of extension
        // and torsion; its own derivative is the same combination of theirs.
        const Vector &a    = states.derivatives()[k];
        Vector        rest = a;
        rest -= states.values()[k - 2];
        FullMatrix<double> gram(2);
        Vector             right(2), share(2);
        for (unsigned int i = 0; i < 2; ++i)
          {
            right[i] = states.values()[i] * rest;
            for (unsigned int j = 0; j < 2; ++j)
              gram(i, j) = states.values()[i] * states.values()[j];
          }
        gram.gauss_jordan();
        gram.vmult(share, right);
        next = states.derivatives()[k - 2];
        next.add(share[0], states.derivatives()[0]);
        next.add(share[1], states.derivatives()[1]);
      }
    u.add(0.5 * y * y, next);
    if (k >= 4)
      u[k == 4 ? RigidField::translation_x : RigidField::translation_z] +=
        y * y * y / 6.;
    return u;
  }



  /// The numbers of the fields @p list whose combination is @p field, by least
  /// squares in the energy of S_00 + S_11.
  Vector
  in_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const Vector                    &field)
  {
    const unsigned int  n = list.size();
    std::vector<Vector> columns, products;
    for (const unsigned int alpha : list)
      {
        columns.push_back(space.in_section_functions(alpha));
        products.emplace_back(field.size());
        space.section().S(0, 0).vmult(products.back(), columns.back());
        space.section().S(1, 1).vmult_add(products.back(), columns.back());
      }
    FullMatrix<double> gram(n);
    Vector             right(n), result(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        right[i] = products[i] * field;
        for (unsigned int j = 0; j < n; ++j)
          gram(i, j) = products[i] * columns[j];
      }
    gram.gauss_jordan();
    gram.vmult(result, right);
    return result;
  }



  /// Each of the six states is in equilibrium at every node of @p beam but the
  /// ends.
  void
  check_states(const Beam &beam, const SaintVenant &states)
  {
    const unsigned int n_nodes = beam.dofs().n_nodes();
    for (unsigned int k = 0; k < 6; ++k)
      {
        Vector u(beam.n_dofs()), forces(beam.n_dofs());
        for (unsigned int node = 0; node < n_nodes; ++node)
          {
            const Vector exact = state_at(states, k, beam.axis().nodes()[node]);
            const auto  &list  = beam.dofs().fields(node);
            const Vector part  = list == whole_list(beam.fields()) ?
                                   exact :
                                   in_list(beam.fields(), list, exact);
            for (unsigned int i = 0; i < part.size(); ++i)
              u[beam.dofs().first(node) + i] = part[i];
          }
        beam.add_internal_forces(u, forces);
        double inside = 0.;
        for (unsigned int node = 1; node + 1 < n_nodes; ++node)
          for (unsigned int i = 0; i < beam.dofs().fields(node).size(); ++i)
            inside =
              std::max(inside, std::abs(forces[beam.dofs().first(node) + i]));
        BOOST_TEST(inside < 1e-10 * forces.linfty_norm(),
                   "state " << k << ": " << inside / forces.linfty_norm());
      }
  }
} // namespace

BOOST_AUTO_TEST_CASE(saint_venant_states_are_held_exactly)
{
  // Each state is a polynomial of degree 3 at most in y with section vectors of
  // the Saint-Venant list: in equilibrium at every node but the ends, on lists
  // of Saint-Venant fields alone and beside all fields.
  const auto         section = coupled_section(3);
  const SaintVenant  states(*section);
  const FieldColumns warpings =
    saint_venant_warpings(states, Warping(*section));
  BOOST_TEST(warpings.n() == 6);
  const auto space = std::make_shared<SectionSpace>(section, warpings);
  const auto axis  = make_axis(1.3, 3, 3);
  const auto sv = dense_list(*space), whole = whole_list(*space);
  for (const Lists &lists :
       {Lists(10, sv),
        Lists{sv, sv, sv, sv, sv, whole, sv, sv, sv, sv},
        Lists{whole, whole, whole, whole, sv, sv, sv, sv, sv, whole}})
    {
      check_states(Beam("beam", space, axis, Placement(), lists, "SV"), states);
    }
}



BOOST_AUTO_TEST_CASE(chosen_fields_hold_the_states)
{
  // The lists that a scene gets, responses near a load and clamps, fewer
  // elsewhere, beside all fields and beside SV: all hold the six states, which
  // are what a patch test is for such fields, and rigid motions without strain.
  const Laminate      plies = rectangle(0.7, 0.5, {30., -45., 0., 60.}, 2);
  const SectionMeshes meshes{
    {"plies", make_section_mesh(plies, {{"material", orthotropic}})}};
  const Support clamps{"clamps",
                       {{0, Region::Kind::surface, "ends", {}}},
                       {{0., 0., 0.}}};
  const Load    patch{"patch",
                   {{0, Region::Kind::surface, "top", {}}},
                   {},
                   "if((y > 2) && (y < 2.5), 1 + x, 0)"};
  for (const std::vector<std::string> &theories : {std::vector<std::string>{},
                                                   {"LE-2", "SV-4", "LE-2"},
                                                   {"SV-4", "LE-2", "SV"}})
    {
      BodyDescription body;
      body.name                 = "beam";
      body.section              = "plies";
      body.theory               = Theory::parse({"Theory", "SV-4"});
      body.theory.section_order = 2;
      body.axis.length          = 5.;
      body.axis.elements        = {10};
      for (const std::string &name : theories)
        {
          body.pieces.theories.push_back(Theory::parse({"Theories", name}));
          body.pieces.theories.back().section_order = 2;
        }
      if (!theories.empty())
        {
          body.pieces.breaks = {1., 3.};
          body.theory        = body.pieces.leading();
        }
      Bodies     bodies = make_bodies({body}, meshes);
      FieldRules rules;
      rules.plan.max_fields_share = 2.;
      choose_fields(bodies, {body}, {clamps}, {patch}, {}, {}, rules);
      const Beam           &beam = dynamic_cast<const Beam &>(*bodies[0]);
      std::set<std::size_t> sizes;
      for (unsigned int node = 0; node < beam.dofs().n_nodes(); ++node)
        sizes.insert(beam.dofs().fields(node).size());
      BOOST_TEST(sizes.size() >= 2);
      check_states(beam, SaintVenant(beam.section()));
      for (const Vector &motion : beam.rigid_motions(undisplaced))
        {
          Vector forces(beam.n_dofs());
          beam.add_internal_forces(motion, forces);
          BOOST_TEST(beam.deformation(motion).energy < 1e-20);
          BOOST_TEST(forces.linfty_norm() < 1e-10 * motion.linfty_norm());
        }
    }
}



BOOST_AUTO_TEST_CASE(warping_is_free_of_rigid_motions)
{
  const auto    section = coupled_section();
  const Warping warping(*section);
  // The area's products, and what is left of a field without them.
  Vector translation(section->n_fields());
  translation[RigidField::translation_x] = 1.;
  BOOST_TEST(
    std::abs((warping.traction(translation) * translation) / section->area() -
             1.) < 1e-12);
  Vector field = random_vector(section->n_fields(), 5);
  warping.remove_rigid(field);
  for (unsigned int r = 0; r < 6; ++r)
    {
      Vector rigid(section->n_fields());
      rigid[r] = 1.;
      BOOST_TEST(std::abs(warping.traction(rigid) * field) < 1e-12);
    }
  // A basis is orthonormal, free of what is known, and as large as what is
  // independent.
  std::vector<Vector> snapshots;
  for (unsigned int j = 0; j < 4; ++j)
    snapshots.push_back(random_vector(section->n_fields(), 30 + j));
  snapshots.push_back(snapshots[0]);
  snapshots.back().add(-2., snapshots[2]);
  const FieldColumns known =
    saint_venant_warpings(SaintVenant(*section), warping);
  snapshots.push_back(column_of(known, 1));
  const FieldColumns basis = warping.basis(snapshots, known, known, 1e-6);
  BOOST_TEST(basis.n() == 4);
  const FieldColumns metrics = warping.metric(basis);
  for (unsigned int i = 0; i < basis.n(); ++i)
    {
      const Vector metric = column_of(metrics, i);
      for (unsigned int j = 0; j < basis.n(); ++j)
        BOOST_TEST(std::abs(metric * column_of(basis, j) - (i == j ? 1. : 0.)) <
                   1e-10);
      for (unsigned int j = 0; j < known.n(); ++j)
        BOOST_TEST(std::abs(metric * column_of(known, j)) < 1e-8);
    }
}



BOOST_AUTO_TEST_CASE(responses_solve_the_pencil)
{
  const auto         section = coupled_section();
  const unsigned int n       = section->n_fields();
  const Vector       load    = random_vector(n, 9);
  const double       k       = 3.7;
  const auto         parts   = SectionResponse(*section).at(k, {load})[0];
  BOOST_TEST(parts.size() == 2);
  // (S_00 + k^2 S_11) x - k (S_01 - S_10) y = f, and the same with 0.
  const auto apply = [&](const Vector &v, const bool symmetric) {
    Vector a(n), b(n);
    section->S(0, symmetric ? 0 : 1).vmult(a, v);
    section->S(1, symmetric ? 1 : 0).vmult(b, v);
    a.add(symmetric ? k * k : -1., b);
    if (!symmetric)
      a *= k;
    return a;
  };
  Vector real = apply(parts[0], true), imaginary = apply(parts[1], true);
  real -= apply(parts[1], false);
  imaginary += apply(parts[0], false);
  real -= load;
  BOOST_TEST(real.linfty_norm() < 1e-10);
  BOOST_TEST(imaginary.linfty_norm() < 1e-10);
}



BOOST_AUTO_TEST_CASE(rows_that_span_the_others)
{
  dealii::LAPACKFullMatrix<double> A(6, 3);
  const double                     values[6][3] = {
                        {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 0}, {1, 1, 0}};
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      A(i, j) = values[i][j];
  BOOST_TEST(select_independent_rows(A, 1e-10) ==
               (std::vector<unsigned int>{4, 2}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
