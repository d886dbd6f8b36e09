// SPDX-License-Identifier: LGPL-2.1-or-later

// What a section answers to coefficients of its fields does not depend on how:
// point by point and by products of whole fields, forces, energy and stiffness.

#include "fixtures.h"

#include <lamella/section/section_operator.h>

#include <boost/test/unit_test.hpp>

#include <numeric>
#include <random>

BOOST_AUTO_TEST_SUITE(section_operator)

using namespace lamella;

namespace
{
  using Columns = dealii::LAPACKFullMatrix<double>;
  using List    = std::vector<unsigned int>;

  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  constexpr double rounding = 1e-12;



  /// @p kind of the degree @p order on four plies that couple everything with
  /// everything.
  std::shared_ptr<const Section>
  coupled_section(const Theory::Kind kind, const unsigned int order)
  {
    Theory theory;
    theory.kind  = kind;
    theory.order = order;
    return make_section(
      make_section_mesh(rectangle(0.7, 0.5, {30., -45., 0., 60.}, 2),
                        {{"material", orthotropic}}),
      theory);
  }



  Columns
  random_columns(const unsigned int rows,
                 const unsigned int columns,
                 const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Columns                                result(rows, columns);
    for (unsigned int k = 0; k < columns; ++k)
      for (unsigned int a = 0; a < rows; ++a)
        result(a, k) = uniform(generator);
    return result;
  }



  /// Coefficients of @p n fields at three stations, transverse shear strains of
  /// their own if they are assumed.
  FieldParts
  random_parts(const unsigned int n, const bool assumed_shear)
  {
    FieldParts q;
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      q[p] = random_columns(n, 3, 5 + p);
    if (!assumed_shear)
      q[FieldPart::shear_value] = q[FieldPart::value];
    return q;
  }



  /// The work on values is one number where no shear is assumed.
  FieldParts
  separate_shear_work(const FieldParts &work, const bool assumed_shear)
  {
    FieldParts result = work;
    if (!assumed_shear)
      for (unsigned int k = 0; k < work[0].n(); ++k)
        for (unsigned int a = 0; a < work[0].m(); ++a)
          {
            result[FieldPart::value](a, k) +=
              work[FieldPart::shear_value](a, k);
            result[FieldPart::shear_value](a, k) = 0.;
          }
    return result;
  }



  double
  largest(const Columns &columns)
  {
    double result = 0.;
    for (unsigned int k = 0; k < columns.n(); ++k)
      for (unsigned int a = 0; a < columns.m(); ++a)
        result = std::max(result, std::abs(columns(a, k)));
    return result;
  }



  void
  check_same(Columns found, const Columns &wanted)
  {
    found.add(-1., wanted);
    BOOST_TEST(largest(found) <= rounding * largest(wanted));
  }



  /// The entries number @p m of @p rows as a matrix.
  Columns
  entries(const std::vector<FactorRow> &rows, const unsigned int m)
  {
    Columns result(rows.size(), rows.size());
    for (unsigned int a = 0; a < rows.size(); ++a)
      for (unsigned int k = 0; k < rows[a].columns.size(); ++k)
        result(a, rows[a].columns[k]) = rows[a].entries[k][m];
    return result;
  }



  void
  check_answers_agree(const SectionSpace &space,
                      const List         &list,
                      const bool          assumed_shear)
  {
    const PointwiseSectionOperator by_points(space, list);
    const ProductSectionOperator   by_products(space, list, assumed_shear);
    const FieldParts               q = random_parts(list.size(), assumed_shear);
    const SectionForces            found = by_products.forces(q),
                        wanted           = by_points.forces(q);
    const FieldParts one = separate_shear_work(found.work, assumed_shear),
                     two = separate_shear_work(wanted.work, assumed_shear);
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      check_same(one[p], two[p]);
    for (unsigned int k = 0; k < wanted.energy.size(); ++k)
      BOOST_TEST(std::abs(found.energy[k] / wanted.energy[k] - 1.) < rounding);
    const auto rows = by_products.stiffness(), others = by_points.stiffness();
    for (unsigned int m = 0; m < (assumed_shear ? 5 : 4); ++m)
      check_same(entries(rows, m), entries(others, m));
  }



  /// The energy is half the work of the forces on what makes them, and the
  /// forces are those of the stiffness.
  void
  check_answer(const SectionOperator &answer, const bool assumed_shear)
  {
    const List         &list   = answer.fields();
    const FieldParts    q      = random_parts(list.size(), assumed_shear);
    const SectionForces forces = answer.forces(q);
    const auto          rows   = answer.stiffness();
    const FieldParts    work = separate_shear_work(forces.work, assumed_shear);
    std::vector<unsigned int> number(rows.size(), list.size());
    for (unsigned int a = 0; a < list.size(); ++a)
      number[list[a]] = a;
    for (unsigned int k = 0; k < forces.energy.size(); ++k)
      {
        double twice = 0.;
        for (unsigned int p = 0; p < FieldPart::n; ++p)
          for (unsigned int a = 0; a < list.size(); ++a)
            twice += q[p](a, k) * forces.work[p](a, k);
        BOOST_TEST(std::abs(0.5 * twice / forces.energy[k] - 1.) < rounding);
      }
    if (assumed_shear)
      return;
    FieldParts product = field_parts(list.size(), q[0].n());
    for (unsigned int a = 0; a < list.size(); ++a)
      for (unsigned int b = 0; b < rows[list[a]].columns.size(); ++b)
        for (unsigned int k = 0; k < q[0].n(); ++k)
          {
            const auto        &S = rows[list[a]].entries[b];
            const unsigned int j = number[rows[list[a]].columns[b]];
            const double       v = q[FieldPart::value](j, k),
                         d       = q[FieldPart::derivative](j, k);
            product[FieldPart::value](a, k) += S[0] * v + S[1] * d;
            product[FieldPart::derivative](a, k) += S[2] * v + S[3] * d;
          }
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      if (p != FieldPart::shear_value)
        check_same(work[p], product[p]);
  }



  List
  numbers(const unsigned int n)
  {
    List list(n);
    std::iota(list.begin(), list.end(), 0);
    return list;
  }
} // namespace

BOOST_AUTO_TEST_CASE(points_and_products_agree_for_taylor)
{
  for (const unsigned int order : {2, 4})
    {
      const SectionSpace space(coupled_section(Theory::Kind::TE, order));
      List               fewer = numbers(space.n_fields());
      fewer.erase(fewer.begin() + 8, fewer.begin() + 12);
      for (const bool assumed_shear : {false, true})
        for (const List &list : {numbers(space.n_fields()), fewer})
          check_answers_agree(space, list, assumed_shear);
    }
}



BOOST_AUTO_TEST_CASE(points_and_products_agree_for_modes)
{
  const auto         section = coupled_section(Theory::Kind::LE, 2);
  const SectionSpace space(section, random_columns(section->n_fields(), 7, 17));
  List               dense = numbers(6);
  for (const unsigned int j : {0, 1, 3, 6})
    dense.push_back(space.first_mode() + j);
  check_answers_agree(space, dense, false);
}



BOOST_AUTO_TEST_CASE(forces_are_conjugate_to_coefficients)
{
  for (const auto &[kind, order] : {std::make_pair(Theory::Kind::EBBT, 1),
                                    std::make_pair(Theory::Kind::TBT, 1),
                                    std::make_pair(Theory::Kind::TE, 1),
                                    std::make_pair(Theory::Kind::TE, 3),
                                    std::make_pair(Theory::Kind::LE, 2)})
    {
      const SectionSpace space(coupled_section(kind, order));
      for (const bool assumed_shear : {false, true})
        check_answer(*make_section_operator(space,
                                            numbers(space.n_fields()),
                                            assumed_shear),
                     assumed_shear);
    }
  // Modes beside all fields, too.
  const auto         section = coupled_section(Theory::Kind::LE, 2);
  const SectionSpace space(section, random_columns(section->n_fields(), 4, 17));
  check_answer(*make_section_operator(space, numbers(space.n_fields()), false),
               false);
}



BOOST_AUTO_TEST_CASE(the_factory_takes_what_suits)
{
  const auto         section = coupled_section(Theory::Kind::LE, 2);
  const SectionSpace space(section, random_columns(section->n_fields(), 2, 17)),
    taylor(coupled_section(Theory::Kind::TE, 2));
  List dense = numbers(6), mixed = numbers(9);
  dense.push_back(space.first_mode());
  mixed.push_back(space.first_mode());
  const auto by_products =
    [](const SectionSpace &space, const List &list, const bool assumed_shear) {
      return dynamic_cast<const ProductSectionOperator *>(
               make_section_operator(space, list, assumed_shear).get()) !=
             nullptr;
    };
  BOOST_TEST(by_products(space, dense, false));
  BOOST_TEST(!by_products(space, dense, true));
  BOOST_TEST(!by_products(space, mixed, false));
  BOOST_TEST(by_products(taylor, numbers(taylor.n_fields()), false));
  BOOST_TEST(by_products(taylor, numbers(taylor.n_fields()), true));
}

BOOST_AUTO_TEST_SUITE_END()
