// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/tangent_operator.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    // Rotation limits: the linear strain has an error of rotation^2 / 2, 0.5 %;
    // and half a turn, which scenes rarely intend.
    constexpr double linear_rotation = 0.1, meaningless_rotation = 3.;
    // A first correction above this says that the assembled matrix has lost
    // more than half of its digits.
    constexpr double ill_conditioned = 1e-7;
    // Of the displacements; a penalty this soft changes the answer.
    constexpr double large_penetration = 1e-3;
    // Of all energy in stabilizing springs.
    constexpr double worth_failing = 0.1, worth_saying = 1e-3;
    // Of the displacements; rows that average this much of the gap away.
    constexpr double large_averaging = 1e-2;
    // From where on the difference between one elastic law of small strains
    // and another shows, and from where on none is to be trusted; and the turn
    // of an element [rad] that B4 with four points loses 1 % to.
    constexpr double worth_naming = 0.01, large_strain = 0.05,
                     large_element_rotation = 20. * dealii::numbers::PI / 180.;
    // What displacements and gaps of a trusted result may be off by.
    constexpr double sound = 1e-6;
    // Forces come out of displacements that are held in doubles, which leaves
    // about eps (L/h)^2 of them: tolerable, but to be told.
    constexpr double tolerable = 1e-3, worth_reporting = 1e-7;



    /// Returns the first check to make when linear rotations are meaningless.
    std::string
    rotation_remedy(const double rotation)
    {
      if (rotation <= meaningless_rotation)
        return "";
      return "this is rarely intended. Check first that moduli, densities, "
             "lengths and loads are in the scene's Units. If so: ";
    }



    void
    check_no_springs(const Checks &checks)
    {
      if (checks.stabilization_share > worth_failing)
        throw NumericsError(
          "solve.spring-energy: Stabilizing springs store " +
          to_text(100. * checks.stabilization_share, 3) +
          " % of the energy, so contacts do not constrain a body with "
          "Stabilization. Add a support, close its gaps by a prescribed "
          "displacement, or load it towards the body that is to support it.");
    }



    void
    check_correction(const State &state)
    {
      const auto last = [](const std::vector<double> &corrections) {
        return corrections.empty() ? 0. : corrections.back();
      };
      const double left =
        std::max(last(state.free_corrections), last(state.contact_corrections));
      if (!(left < sound))
        throw IllConditioned(
          "solve.refinement-not-converged: The iterative refinement of the "
          "linear solution does not converge: its last correction is " +
          to_text(left, 3) +
          " of the displacements. The scene is too ill-conditioned for double "
          "precision: use less slender bodies or less different stiffnesses.");
    }



    /// Forces, moments, residual and energy.
    void
    check_balance(const Checks &checks)
    {
      for (const auto &[what, error] :
           {std::make_pair("forces on a body do not balance",
                           checks.force_balance),
            std::make_pair("moments on a body do not balance",
                           checks.moment_balance),
            std::make_pair("residual forces do not vanish", checks.residual),
            std::make_pair("strain energy differs from the work done",
                           checks.energy_balance)})
        if (!(error < tolerable))
          throw IllConditioned(
            "solve.not-balanced: The solution fails a check: " +
            std::string(what) + ": the relative error is " + to_text(error, 3) +
            ". The scene is too ill-conditioned: use less slender bodies, or "
            "less different stiffnesses and penalties.");
    }



    void
    check_contact_law(const KktResidual &contact,
                      const double       displacement,
                      const double       rounding)
    {
      if (!(contact.imbalance < tolerable))
        throw NumericsError(
          "solve.contact-forces-differ: Contact forces of two bodies differ "
          "by " +
          to_text(contact.imbalance, 3) +
          " of their sum, an error in Lamella: please report the scene.");
      else if (contact.min_force < 0. ||
               !(contact.law_error <= std::max(sound * displacement, rounding)))
        throw NumericsError(
          "solve.contact-law-violated: The contact conditions are violated: "
          "the smallest contact force is " +
          to_text(contact.min_force) +
          ", and the gaps differ from the contact law by up to " +
          to_text(contact.law_error, 3) + " (relative violation " +
          to_text(contact.violation, 3) +
          "). Use a smaller Penalty, or Contact strategy = condensed.");
    }



    void
    check_small_strain(const Checks &checks)
    {
      // Pointwise strains at corners and below line contacts depend on the
      // mesh: the means over sections are checked.
      if (!(checks.max_rms_strain <= large_strain))
        throw NumericsError(
          "solve.strain-beyond-law: The axial strain (root mean square over a "
          "section) reaches " +
          to_text(100. * checks.max_rms_strain, 3) +
          " %, but the law, linear in the Green-Lagrange strain, is valid only "
          "to " +
          to_text(100. * large_strain, 2) + " %. Reduce the loads.");
    }



    void
    add_contact_warnings(const ContactInterface   &contact,
                         const KktResidual        &kkt,
                         const double              displacement,
                         const bool                is_large,
                         std::vector<std::string> &warnings)
    {
      const std::string what = "contact " + contact.name + ": ";
      if (kkt.max_penetration > large_penetration * displacement)
        warnings.push_back(
          "solve.penetration: " + what + "bodies penetrate by " +
          to_text(kkt.max_penetration, 3) + ", " +
          to_text(100. * kkt.max_penetration / displacement, 2) +
          " % of displacements. Increase Penalty, or use Enforcement = exact");
      // Constraints that are paired anew have no initial gap.
      if (is_large)
        return;
      if (kkt.unresolved_curvature > large_averaging * displacement)
        warnings.push_back(
          "solve.curvature-unresolved: " + what +
          "gaps that are averaged over elements are up to " +
          to_text(kkt.unresolved_curvature, 3) +
          " larger than the gaps at the contact points, " +
          to_text(100. * kkt.unresolved_curvature / displacement, 2) +
          " % of the displacements: the mesh does not resolve the curvature. "
          "Refine it there, or use Discretization = node to surface");
      double smallest = 0.;
      for (const GapConstraint &row : contact.rows)
        smallest = std::min(smallest, row.initial_gap);
      if (smallest < 0.)
        warnings.push_back(
          "contact.initial-overlap: " + what +
          "the bodies overlap at the start by up to " + to_text(-smallest, 3) +
          " and are pushed apart by contact forces (Overclosure = resolve)");
    }



    /// Adds warnings of bodies with linear kinematics.
    void
    add_warnings_of_rotations(const Checks             &checks,
                              std::vector<std::string> &warnings)
    {
      if (checks.max_rotation > linear_rotation)
        warnings.push_back(
          "solve.large-rotation: rotations reach " +
          to_text(checks.max_rotation, 3) +
          " rad: " + rotation_remedy(checks.max_rotation) +
          "linear kinematics elongates rotated bodies by rotation^2 / 2 = " +
          to_text(50. * checks.max_rotation * checks.max_rotation, 2) +
          " %. Use Rotations = large if this error matters");
    }



    /// Adds warnings of strains and sections, for finite rotations.
    void
    add_warnings_of_strains(const Checks             &checks,
                            std::vector<std::string> &warnings)
    {
      if (checks.max_strain > large_strain)
        warnings.push_back(
          "solve.local-strain: strains reach " +
          to_text(100. * checks.max_strain, 3) + " % at points (" +
          to_text(100. * checks.max_rms_strain, 2) +
          " % axial, root mean square over a section). At corners and below line "
          "contacts strains depend on the mesh, so do not use stresses there");
      else if (checks.max_strain > worth_naming)
        warnings.push_back(
          "solve.large-strain: strains reach " +
          to_text(100. * checks.max_strain, 3) +
          " %. There, stresses by a material law linear in the Green-Lagrange "
          "strain and by one linear in the stretch differ by " +
          to_text(150. * checks.max_strain, 2) +
          " %. Compare with material tests at this strain");
      if (checks.shape_change > worth_naming)
        warnings.push_back(
          "solve.section-shape: theories with rigid sections neglect the "
          "change of the section shape by bending and twisting (Brazier's "
          "flattening of tubes, Lamb's of wide strips), which would change "
          "moments or torques by up to about " +
          to_text(100. * checks.shape_change, 2) +
          " %. Use Theory = LE-N to include it");
      if (checks.max_element_rotation > large_element_rotation)
        warnings.push_back(
          "solve.element-rotation: an axis element rotates by " +
          to_text(checks.max_element_rotation * 180. / dealii::numbers::PI, 3) +
          " degrees between its ends: errors are some per cent. Use " +
          to_text(std::ceil(checks.max_element_rotation /
                            (large_element_rotation / 2.)),
                  3) +
          " times as many Axis elements there (10 degrees each)");
    }
  } // namespace



  void
  check_solution(const State  &state,
                 const Checks &checks,
                 const double  rotation_limit)
  {
    check_no_springs(checks);
    check_correction(state);
    check_balance(checks);
    for (const KktResidual &contact : checks.contacts)
      check_contact_law(contact, checks.max_displacement, state.rounding());
    if (!std::isfinite(checks.max_rotation) || !std::isfinite(checks.energy))
      throw NumericsError(
        "solve.not-finite: The solution is not finite. Check the loads.");
    if (checks.is_large)
      check_small_strain(checks);
    else if (checks.max_rotation > rotation_limit)
      throw NumericsError(
        "solve.rotation-limit: Rotations reach " +
        to_text(checks.max_rotation, 3) + " rad, beyond Rotation limit = " +
        to_text(rotation_limit) + ": " + rotation_remedy(checks.max_rotation) +
        "linear kinematics is not valid here. Use Rotations = large, reduce "
        "the loads, or raise the limit to accept the linear result.");
  }



  void
  check_followed(const TangentOperator &here, const LoadFactor &at)
  {
    if (const auto missed = here.largest_support_error(at); missed.share > 1.)
      throw NumericsError(
        "solve.supports-contradict: Supports contradict each other at " +
        to_text(missed.place) +
        ": their displacements agree for small rotations only, and for finite "
        "rotations the error of a support is " +
        to_text(missed.share, 3) +
        " times the tolerance. Remove one of the supports, or prescribe the "
        "same Rotation about the same point for all of them.");
  }



  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts)
  {
    std::vector<std::string> warnings;
    for (unsigned int k = 0; k < contacts.size(); ++k)
      add_contact_warnings(contacts[k],
                           checks.contacts[k],
                           checks.max_displacement,
                           checks.is_large,
                           warnings);
    if (checks.is_large)
      add_warnings_of_strains(checks, warnings);
    else
      add_warnings_of_rotations(checks, warnings);
    if (checks.stabilization_share > worth_saying)
      warnings.push_back("solve.spring-energy: stabilizing springs store " +
                         to_text(100. * checks.stabilization_share, 2) +
                         " % of the energy, too much. Reduce Stabilization");
    const double first =
      state.free_corrections.empty() ? 0. : state.free_corrections.front();
    const double forces = std::max({checks.force_balance,
                                    checks.moment_balance,
                                    checks.residual,
                                    checks.energy_balance});
    if (forces > worth_reporting)
      warnings.push_back(
        "solve.not-balanced: forces balance up to a relative error of " +
        to_text(forces, 2) +
        ", since bodies are very slender or stiffnesses very different");
    if (first > ill_conditioned)
      warnings.push_back(
        "solve.ill-conditioned: the first solution of the ill-conditioned "
        "system had the relative error " +
        to_text(first, 2) + ". Iterative refinement reduced it to " +
        to_text(state.free_corrections.back(), 2));
    return warnings;
  }
} // namespace lamella
