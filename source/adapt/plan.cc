// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/plan.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/body/beam.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/section/section.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  bool
  is_clamp(const Region &region, const double y, const double length)
  {
    const double near = arithmetic::same_position * length;
    return region.is_whole_body() || (y < near && region.covers_end(true)) ||
           (y > length - near && region.covers_end(false));
  }



  bool
  is_constrained_along_axis(const std::vector<Support> &supports,
                            const unsigned int          body)
  {
    return std::any_of(supports.begin(),
                       supports.end(),
                       [body](const Support &support) {
                         return std::any_of(support.on.begin(),
                                            support.on.end(),
                                            [body](const Region &region) {
                                              return region.body == body &&
                                                     region.is_whole_body();
                                            });
                       });
  }



  unsigned int
  n_corners(const Beam &beam)
  {
    return corners_of(beam.section()).size();
  }



  double
  layerwise_dofs(const BodySize &size, const unsigned int degree)
  {
    const double side = degree * std::sqrt(size.cells) + 1.;
    return 3. * size.nodes * side * side;
  }



  namespace
  {
    bool
    has_contact_along_axis(const BodySize &size, const PlanRules &rules)
    {
      return size.loaded > rules.max_contact_share;
    }



    /// What an axis begins with that is touched all along.
    unsigned int
    equal_elements(const BodySize &size, const PlanRules &rules)
    {
      const double most = rules.equal_elements;
      return size.constrained_along_axis ?
               1 :
               std::lround(std::min(most, std::max(2., size.slenderness)));
    }



    /// Returns why a body of SV-N keeps all section fields, or an empty text.
    std::string
    reason_for_all_fields(const PlanInput &facts, const PlanRules &rules)
    {
      const BodySize   &size   = facts.size;
      const std::string of_all = " of " + std::to_string(size.fields);
      if (facts.is_unsolved)
        return "the scene could not be solved in double precision";
      if (size.constrained_along_axis)
        return "supports constrain its sections along the whole axis";
      if (size.nodes <= rules.min_nodes)
        return "its axis has " + std::to_string(size.nodes) + " nodes only";
      if (facts.held && *facts.held > rules.max_held_share * size.fields)
        return "supports would constrain " +
               std::to_string(static_cast<unsigned int>(*facts.held)) + of_all +
               " section functions of a node";
      if (facts.wanted && *facts.wanted > rules.max_fields_share * size.fields)
        return "a node would need " + std::to_string(*facts.wanted) + of_all +
               " section functions";
      return "";
    }



    double
    full(const double m)
    {
      return 0.5 * m * (m + 1.);
    }



    /// Factor non-zeros of @p beam, eliminated as in predicted_costs().
    double
    non_zeros_of(const Beam &beam)
    {
      const Axis &axis   = beam.axis();
      const auto  fields = [&beam](const unsigned int node) {
        return double(beam.dofs().fields(node).size());
      };
      double sum = full(fields(axis.n_nodes() - 1));
      for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
        {
          const auto  &nodes = axis.nodes_of_cell(cell);
          const double begin = fields(nodes[0]), end = fields(nodes[1]);
          double       inside = -begin - end;
          for (const unsigned int node : nodes)
            inside += fields(node);
          sum +=
            full(inside) + inside * (begin + end) + full(begin) + begin * end;
        }
      return sum;
    }
  } // namespace



  std::string
  reason_for_layerwise(const BodySize &size, const PlanRules &rules)
  {
    if (has_contact_along_axis(size, rules))
      return "contacts may touch " + to_text(100. * size.loaded, 3) +
             " % of its length, and there would be a response to each row";
    if (size.is_held_at_side)
      return "a support acts on one of its sides, and there would be a response "
             "to each row";
    const double dofs = layerwise_dofs(size, 2);
    return dofs <= rules.cheap_dofs ?
             "LE-2 has some " + to_text(dofs, 2) +
               " DoFs, less work than making fields of its own" :
             "";
  }



  BodyPlan
  plan(const PlanInput &facts, const PlanRules &rules)
  {
    BodyPlan result;
    result.theory = facts.theory;
    if (facts.is_assumed && facts.has_contacts)
      result.theory_reason = reason_for_layerwise(facts.size, rules);
    if (!result.theory_reason.empty())
      {
        result.theory = Theory::layerwise(rules.first_degree);
        if (facts.is_graded_automatically &&
            has_contact_along_axis(facts.size, rules))
          result.equal_elements = equal_elements(facts.size, rules);
      }
    if (facts.has_pieces)
      result.all_fields = false;
    else if (result.theory.is_saint_venant())
      {
        if (result.theory.order > 0)
          result.fields_reason = reason_for_all_fields(facts, rules);
        result.all_fields = !result.fields_reason.empty();
      }
    return result;
  }



  std::string
  describe_fields(const PlanInput &facts, const BodyPlan &planned)
  {
    std::string all = "all fields of the section";
    if (facts.has_pieces)
      return "fields as Theories say";
    if (!planned.fields_reason.empty())
      return all + ", since " + planned.fields_reason;
    if (planned.all_fields)
      return all;
    return planned.theory.order > 0 ?
             "fields chosen by what touches it, fewer than those of the section" :
             "the rigid fields and Saint-Venant's warpings";
  }



  std::vector<Cost>
  predicted_costs(const Bodies &bodies, const CostRules &rules)
  {
    const std::vector<const Beam *> beams = beams_of(bodies);
    std::vector<Cost>               costs;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const double n    = bodies[b]->n_dofs();
        Cost        &cost = costs.emplace_back();
        const double cube = std::pow(n, 4. / 3.);
        if (const Beam *const beam = beams[b]; beam == nullptr)
          cost.non_zeros = rules.of_solid * cube;
        else if (cost.non_zeros = non_zeros_of(*beam);
                 beam->section().theory().is_layerwise() &&
                 beam->n_dofs() ==
                   beam->axis().n_nodes() * beam->section().n_fields())
          cost.non_zeros = std::min(cost.non_zeros, rules.of_layers * cube);
        cost.operations = operations_of_factor(cost.non_zeros, n);
      }
    return costs;
  }
} // namespace lamella
