// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/kkt_residual.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  BodyForces::BodyForces(const Body &of, const Vector &u)
    : body(of)
    , rigid(of.rigid_motions(u))
    , size(of.size())
  {}



  void
  BodyForces::add(const Wrench &about_center, const double least)
  {
    sum.force += about_center.force;
    sum.moment += about_center.moment;
    at_least(std::max(
      {least, about_center.force.norm(), about_center.moment.norm() / size}));
  }



  void
  BodyForces::at_least(const double force)
  {
    largest = std::max(largest, force);
  }



  std::pair<double, double>
  BodyForces::unbalanced() const
  {
    const auto share = [this](const double left) {
      return left == 0. ? 0. : left / largest;
    };
    return {share(sum.force.norm()), share(sum.moment.norm() / size)};
  }



  namespace
  {
    /// The point nearest to @p mean of the line on which the force of @p wrench
    /// has its moment about the origin (up to a couple along it).
    Point<3>
    line_of_action(const Wrench &wrench, const Point<3> &mean)
    {
      const Tensor<1, 3> &force = wrench.force;
      const Tensor<1, 3>  arm =
        cross_product_3d(force, wrench.moment) / force.norm_square();
      return Point<3>(arm + (mean * force / force.norm_square()) * force);
    }



    /// Between the points of a pair, none if they overlap.
    double
    gap_of(const ContactInterface::Point &pair)
    {
      return std::max(0.,
                      (pair.second - pair.first) *
                        (pair.normal / pair.normal.norm()));
    }



    /// Adds the errors of the law in gaps and slips of a tied @p contact.
    void
    check_ties(const ContactInterface &contact,
               const ConstraintForces &forces,
               const BlockVector      &u,
               const LoadFactor       &factor,
               const double            displacement,
               KktResidual            &kkt)
    {
      const auto add = [&kkt](const double error) {
        kkt.law_error = std::max(kkt.law_error, std::abs(error));
      };
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const GapConstraint &row = contact.rows[k];
          add(row.gap(u, factor) + law_compliance(row) * forces.normal[k]);
          for (const SlipConstraint &slip : row.slips)
            add(slip.slip(u, factor) + law_compliance(row, true) *
                                         (slip.tangent * forces.shear_of(k)));
        }
      kkt.active    = contact.rows.size();
      kkt.violation = kkt.law_error / displacement;
    }



    /// What the rows say of gaps and forces, each for itself.
    void
    check_rows(const ContactInterface &contact,
               const ConstraintForces &forces,
               const BlockVector      &u,
               const LoadFactor       &factor,
               const double            displacement,
               KktResidual            &kkt)
    {
      double smallest = std::numeric_limits<double>::max(), largest = 0.;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const GapConstraint &row    = contact.rows[k];
          const double         lambda = forces.normal[k];
          const double         g      = row.gap(u, factor);
          kkt.max_penetration         = std::max(kkt.max_penetration, -g);
          kkt.law_error =
            std::max(kkt.law_error,
                     lambda == 0. ? -g :
                                    std::abs(g + law_compliance(row) * lambda));
          kkt.complementarity =
            std::max(kkt.complementarity, std::max(g, 0.) * std::abs(lambda));
          largest = std::max(largest, std::abs(lambda));
          if (lambda != 0.)
            {
              ++kkt.active;
              kkt.unresolved_curvature = std::max(kkt.unresolved_curvature,
                                                  contact.rows[k].initial_gap -
                                                    gap_of(contact.points[k]));
              smallest                 = std::min(smallest, lambda);
            }
        }
      if (kkt.active == 0)
        return;
      kkt.min_force = smallest;
      kkt.violation =
        std::max({kkt.law_error / displacement,
                  -smallest / largest,
                  kkt.complementarity / (displacement * largest)});
    }



    /// Adds the errors of Coulomb's law in @p contact to @p kkt.
    void
    check_friction(const ContactInterface &contact,
                   const ConstraintForces &forces,
                   KktResidual            &kkt)
    {
      kkt.dissipated = 0.;
      for (const auto &[point, of] : forces.friction.history)
        if (point.first == forces.contact)
          kkt.dissipated += of.dissipated;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          if (forces.magnitude(k) == 0.)
            continue;
          kkt.shear += forces.shear[k];
          (forces.slips(k) ? kkt.slipping : kkt.sticking) +=
            contact.points[k].area;
        }
    }



    /// Resultant of the row @p forces on the body at @p side, about its center.
    std::vector<Wrench>
    wrenches_of_rows(const ContactInterface &contact,
                     const ConstraintForces &forces,
                     const unsigned int      side,
                     const BodyForces       &on_body)
    {
      std::vector<Wrench> of_rows(contact.rows.size());
      for (unsigned int k = 0; k < of_rows.size(); ++k)
        if (forces.magnitude(k) != 0.)
          of_rows[k] = on_body.resultant_of_work([&](const Vector &motion) {
            const GapConstraint &row = contact.rows[k];
            double work = forces.normal[k] * row.parts[side].row(motion);
            for (const SlipConstraint &slip : row.slips)
              work += slip.tangent * forces.shear_of(k) *
                      slip.parts[side].row(motion);
            return work;
          });
      return of_rows;
    }



    Wrench
    sum(const std::vector<Wrench> &wrenches)
    {
      Wrench whole;
      for (const Wrench &wrench : wrenches)
        {
          whole.force += wrench.force;
          whole.moment += wrench.moment;
        }
      return whole;
    }



    /// The mean of the points that are pressed, weighted with their forces.
    Point<3>
    mean_point(const ContactInterface &contact, const ConstraintForces &forces)
    {
      Tensor<1, 3> mean;
      double       weight = 0.;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const double force =
            contact.rows[k].is_tied() ? forces.magnitude(k) : forces.normal[k];
          mean += force * contact.points[k].first;
          weight += force;
        }
      return Point<3>(mean / weight);
    }



    /// Whether what a contact transmits is read from its second body: one that
    /// deforms, and whose theory misses no more motions than that of the first
    /// (a theory without a turn about its axis sees no torque about it).
    bool
    is_read_from_second(const ContactInterface        &contact,
                        const std::vector<BodyForces> &on_body)
    {
      const auto missing = [&](const unsigned int b) {
        return on_body[b].body.omitted_rigid_motions().size();
      };
      return contact.second_body.has_value() &&
             missing(*contact.second_body) <= missing(contact.first_body);
    }



    /// Force, moment and center of pressure; adds the forces to the bodies'.
    void
    add_contact_forces(const ContactInterface  &contact,
                       const ConstraintForces  &forces,
                       KktResidual             &kkt,
                       std::vector<BodyForces> &on_body)
    {
      std::vector<Wrench> on_first =
        wrenches_of_rows(contact, forces, 0, on_body[contact.first_body]);
      std::vector<Wrench> on_second;
      const Wrench        of_first = sum(on_first);
      // Forces of ties may cancel in their resultant.
      const double all = forces.sum_of_magnitudes();
      on_body[contact.first_body].add(of_first, all);
      if (contact.second_body.has_value())
        {
          BodyForces &second     = on_body[*contact.second_body];
          on_second              = wrenches_of_rows(contact, forces, 1, second);
          const Wrench of_second = sum(on_second);
          second.add(of_second, all);
          if (all != 0.)
            kkt.imbalance = (of_first.force + of_second.force).norm() / all;
        }

      const bool        from_second = is_read_from_second(contact, on_body);
      const BodyForces &seen_by =
        on_body[from_second ? *contact.second_body : contact.first_body];
      kkt.of_rows = std::move(from_second ? on_second : on_first);
      for (Wrench &wrench : kkt.of_rows)
        {
          // From the center of the body to the origin of the scene.
          wrench.moment +=
            cross_product_3d(seen_by.body.center(), wrench.force);
          if (!from_second)
            wrench = {-wrench.force, -wrench.moment};
        }
      const Wrench whole = sum(kkt.of_rows);
      kkt.force          = whole.force;
      kkt.moment         = whole.moment;
      if (kkt.force.norm() != 0.)
        kkt.center_of_pressure =
          line_of_action(whole, mean_point(contact, forces));
    }
  } // namespace



  void
  add_resultants(KktResidual &whole, const KktResidual &part)
  {
    const double own = whole.force.norm(), other = part.force.norm();
    if (other == 0.)
      return;
    const Point<3> mean =
      whole.center_of_pressure +
      other / (own + other) *
        (part.center_of_pressure - whole.center_of_pressure);
    whole.force += part.force;
    whole.moment += part.moment;
    whole.shear += part.shear;
    whole.sticking += part.sticking;
    whole.slipping += part.slipping;
    whole.dissipated += part.dissipated;
    whole.center_of_pressure =
      line_of_action(Wrench{whole.force, whole.moment}, mean);
  }



  ConstraintForces::ConstraintForces(const GapConstraints &rows,
                                     const unsigned int    contact,
                                     const State          &state)
    : normal(rows.of_contact(contact, state.force))
    , shear(rows.of_contact(contact, state.friction.shear))
    , direction(rows.of_contact(contact, state.friction.direction))
    , friction(state.friction)
    , contact(contact)
  {}



  KktResidual
  check_contact(const ContactInterface  &contact,
                const ConstraintForces  &forces,
                const BlockVector       &u,
                const LoadFactor        &factor,
                const double             displacement,
                std::vector<BodyForces> &on_body)
  {
    KktResidual kkt;
    (contact.is_tied() ?
       check_ties :
       check_rows)(contact, forces, u, factor, displacement, kkt);
    if (forces.shear.size() > 0)
      check_friction(contact, forces, kkt);
    add_contact_forces(contact, forces, kkt, on_body);
    if (contact.obstacle != nullptr && contact.obstacle->body)
      kkt.obstacle_displacement = contact.obstacle->displacement_at(factor, u);
    return kkt;
  }
} // namespace lamella
