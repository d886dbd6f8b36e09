// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/cylinder_contact_lines.h>
#include <lamella/scene/rotation_rules.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    const std::string rule = "scene.not-with-large-rotations: this entry or "
                             "value is not available with Rotations = large",
                      linear_as_well = " Or write Rotations = linear.";



    [[noreturn]] void
    refuse(const std::string &entry,
           const std::string &value,
           const std::string &why,
           const std::string &remedy)
    {
      throw InputError(entry, value, why, remedy + linear_as_well);
    }



    void
    check_body(const BodyDescription &body)
    {
      const std::string place  = "Body " + body.name + "/";
      const Theory     &theory = body.theory;
      if (!body.pieces.empty())
        refuse(place + "Kinematics/Theories",
               "",
               rule,
               "Write one Theory for the body instead of Theories.");
      const unsigned int cubic                = 3;
      const bool         has_finite_rotations = theory.has_rotating_sections();
      if (!can_rotate(theory))
        refuse(place + "Kinematics/Theory",
               theory.name(),
               "scene.theory-cannot-rotate: Rotations = large needs a theory "
               "that can represent finite rotations of sections",
               "Use EBBT, TBT, SV, SV-N, LE-N, TE-N with N >= 2, or solid-2.");
      if (!has_finite_rotations && !theory.is_solid() &&
          body.axis.degree != cubic)
        refuse(place + "Kinematics/Axis element",
               "B" + std::to_string(body.axis.degree + 1),
               "scene.membrane-locking: B2 and B3 elements show membrane "
               "locking in finite rotations",
               "Write Axis element = B4.");
    }



    /// Returns whether @p roller would touch @p body between its surface
    /// points, which are too coarse, so that the nearest line is needed.
    /// Automatic axes are graded later, but not to spacings of 6e-3 radii.
    bool
    needs_line_contact(const BodyDescription &body, const Obstacle &roller)
    {
      const AxisMesh &axis = body.axis;
      if (axis.refinement_factor > 0.)
        return true;
      const double at   = body.placement.to_body(roller.point)[1];
      double       from = 0., length = 0.;
      for (unsigned int piece = 0; piece < axis.elements.size(); ++piece)
        {
          const double to =
            piece < axis.breaks.size() ? axis.breaks[piece] : axis.length;
          if (piece == 0 || at > from)
            length = (to - from) / axis.elements[piece];
          from = to;
        }
      return are_too_coarse_for(length / axis.degree, roller.radius);
    }



    /// Returns whether @p contact has a penalty per area, not for lines.
    bool
    has_area_penalty(const ContactPair &contact)
    {
      return contact.enforcement == Enforcement::penalty &&
             contact.penalty.kind != PenaltyKind::automatic;
    }



    /// Returns whether @p contact is with a roller across the beam @p body.
    bool
    has_roller(const ContactPair &contact, const BodyDescription &body)
    {
      return contact.obstacle != nullptr &&
             contact.obstacle->shape == Obstacle::Shape::cylinder &&
             !body.theory.is_solid() &&
             std::abs(contact.obstacle->direction * body.placement.axes[1]) <
               arithmetic::parallel_sine;
    }



    /// Throws InputError if `line to roller` of @p contact is impossible. Sets
    /// it instead of `auto` if points of @p body are too coarse.
    void
    choose_line(ContactPair &contact, const BodyDescription &body)
    {
      const std::string place = "Contact " + contact.name + "/";
      const bool        is_line =
        contact.discretization == Discretization::line_to_roller;
      if (is_line && has_area_penalty(contact))
        throw InputError(place + "Penalty",
                         "",
                         "scene.penalty-of-line: a Penalty is a force per area "
                         "and penetration, but line contact has no area",
                         "Write Enforcement = exact, or Penalty = auto.");
      if (is_line && !has_roller(contact, body))
        throw InputError(place + "Discretization",
                         name_of(contact.discretization),
                         "scene.no-line-contact: line to roller needs a beam "
                         "perpendicular to the roller, but body '" +
                           body.name + "' is no such beam",
                         "Write Discretization = auto.");
      if (contact.discretization != Discretization::automatic ||
          !allows_line_contact(contact, body) ||
          !needs_line_contact(body, *contact.obstacle))
        return;
      contact.discretization = Discretization::line_to_roller;
    }



    void
    check_contact(const Scene &scene, ContactPair &contact)
    {
      const std::string      place = "Contact " + contact.name + "/";
      const BodyDescription &body  = scene.bodies[contact.first.body];
      if (contact.discretization == Discretization::node_to_node)
        refuse(place + "Discretization",
               name_of(contact.discretization),
               "scene.fixed-pairs: node to node contact has fixed pairs of "
               "nodes, but with Rotations = large the surfaces may slide",
               "Write Discretization = surface to surface or node to surface.");
      choose_line(contact, body);
      if (contact.discretization == Discretization::automatic)
        contact.discretization = Discretization::surface_to_surface;
    }



    void
    check_requests(const Scene &scene)
    {
      const auto check = [](const std::string &kind, const auto &requests) {
        for (const auto &request : requests)
          if (request.stress == StressValues::equilibrium)
            refuse(kind + " " + request.name + "/Stress",
                   name_of(request.stress),
                   rule,
                   "Write Stress = element or recovered.");
      };
      check("Probe", scene.probes);
      check("Line", scene.lines);
      check("Cut", scene.cuts);
      if (!scene.strength.criteria.empty() &&
          scene.strength.stress == StressValues::equilibrium)
        refuse("Strength/Stress",
               name_of(scene.strength.stress),
               rule,
               "Write Stress = recovered.");
    }



    void
    check_goals(const GoalParameters &goals)
    {
      if (!goals.tolerances.empty())
        refuse("Goals/Tolerance",
               "",
               rule,
               "Remove Tolerance, and compare with a run on more elements.");
      if (goals.bars == ErrorBars::richer)
        refuse("Goals/Error bars",
               name_of(goals.bars),
               rule,
               "Write true, which compares with fewer axis elements.");
    }



    /// Throws InputError for entries that small rotations do not allow.
    void
    check_linear(const Scene &scene)
    {
      for (const Load &load : scene.loads)
        if (load.is_follower && scene.solve.rotations == Rotations::linear)
          throw InputError("Load " + load.name + "/Pressure",
                           load.pressure.text() + ", follows",
                           "scene.follower-load-linear: a follower load "
                           "rotates, but Rotations = linear neglects rotations",
                           "Remove 'follows', or write Rotations = large.");
    }
  } // namespace



  bool
  allows_line_contact(const ContactPair &contact, const BodyDescription &body)
  {
    return has_roller(contact, body) && !has_area_penalty(contact);
  }



  bool
  can_rotate(const Theory &theory)
  {
    // Theories whose sections rotate or can represent a rotation.
    constexpr unsigned int min_order = 2;
    return theory.has_rotating_sections() || theory.is_layerwise() ||
           ((theory.is_solid() || theory.is_taylor()) &&
            theory.order >= min_order);
  }



  Scene
  with_finite_rotations(Scene scene)
  {
    scene.solve.rotations = Rotations::large;
    for (BodyDescription &body : scene.bodies)
      {
        check_body(body);
        body.has_finite_rotations = true;
      }
    for (const Load &load : scene.loads)
      if (!load.pressure.empty() && !load.is_follower)
        scene.warnings.push_back(
          "scene.dead-pressure: load " + load.name +
          ": its Pressure is a dead load, that is, per undeformed area and "
          "along the undeformed normal. For a follower load write `" +
          load.pressure.text() + ", follows`");
    for (ContactPair &contact : scene.contacts)
      check_contact(scene, contact);
    check_requests(scene);
    check_goals(scene.goals);
    return scene;
  }



  bool
  requests_finite_rotations(const Scene &scene)
  {
    return std::any_of(scene.loads.begin(),
                       scene.loads.end(),
                       [](const Load &load) { return load.is_follower; });
  }



  void
  apply_rotations(Scene &scene)
  {
    if (scene.solve.rotations == Rotations::large)
      {
        scene = with_finite_rotations(std::move(scene));
        return;
      }
    check_linear(scene);
    for (ContactPair &contact : scene.contacts)
      choose_line(contact, scene.bodies[contact.first.body]);
    if (scene.solve.rotations == Rotations::automatic)
      try
        {
          with_finite_rotations(scene);
        }
      catch (const InputError &error)
        {
          if (requests_finite_rotations(scene))
            throw;
          scene.solve.rotations = Rotations::linear;
          scene.warnings.push_back(
            "scene.rotations-linear: Rotations = auto uses linear kinematics, "
            "since Rotations = large is not possible for this scene: " +
            error.path() +
            (error.value().empty() ? "" : " = " + error.value()) + ": " +
            error.rule());
        }
  }
} // namespace lamella
