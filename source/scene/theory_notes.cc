// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/scene/theory_notes.h>
#include <lamella/section/theory_limits.h>
#include <lamella/shape/properties.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lamella
{
  namespace
  {
    /// Smallest reported relative errors, of deflections and of torsion.
    constexpr double worth_saying = 0.02, torsion_worth_saying = 0.05;



    /// Returns the error factor of the bending stiffness of @p plies by shear:
    /// (1 + phi) / (1 + phi_N), phi = 12 E I / (k G A L^2).
    double
    shear_error(const BodyDescription  &body,
                const std::vector<Ply> &plies,
                const double            width)
    {
      const LaminateStiffness stiffness = laminate_stiffness(plies, width);
      const double            L         = body.axis.length;
      const auto              phi       = [&](const double kGA) {
        return 12. * stiffness.EI / (kGA * L * L);
      };
      const double truth = phi(shear_stiffness(plies, width));
      double       found = 0.;
      if (body.theory.is_taylor())
        found = phi(shear_stiffness(plies, width, body.theory.order));
      else if (!body.theory.keeps_sections_normal())
        found = phi(body.theory.shear_factor * stiffness.GA);
      return (1. + truth) / (1. + found);
    }



    /// Returns "5 % too stiff" or "3.5 times too stiff", for instance.
    std::string
    describe_stiffness(const double ratio)
    {
      const std::string percent =
        to_text(100. * std::abs(ratio - 1.), 1) + " %";
      return ratio > 1.5 ? to_text(ratio, 2) + " times too stiff" :
             ratio > 1.  ? percent + " too stiff" :
                           percent + " too soft";
    }



    /// Adds notes on the shear error of single-layer theories of laminates.
    void
    add_shear_note(const BodyDescription    &body,
                   const Scene              &scene,
                   std::vector<std::string> &notes)
    {
      const auto *laminate =
        std::get_if<Laminate>(&scene.sections.at(body.section));
      if (laminate == nullptr)
        return;
      const double ratio =
        shear_error(body, laminate->plies(scene.materials), laminate->width);
      if (std::abs(ratio - 1.) > worth_saying)
        notes.push_back(
          "scene.shear-of-theory: body " + body.name +
          ": compared with the shear stiffness k G A of the section, " +
          body.theory.name() + " is " + describe_stiffness(ratio) +
          " in bending at this length, since it does not describe the shear of "
          "these plies (12 E I / (k G A L^2)). Use LE-N");
    }



    /// Adds notes on Taylor theories of thin-walled sections in torsion.
    void
    add_torsion_note(const BodyDescription                    &body,
                     const std::shared_ptr<const SectionMesh> &mesh,
                     std::vector<std::string>                 &notes)
    {
      if (!body.theory.is_taylor())
        return;
      const auto truth = torsional_stiffness(*mesh);
      if (!truth)
        return;
      const auto found = torsional_stiffness(*make_section(mesh, body.theory));
      if (found && *found > (1. + torsion_worth_saying) * *truth)
        notes.push_back(
          "scene.torsion-of-theory: body " + body.name + ": in torsion " +
          body.theory.name() + " is " + to_text(*found / *truth, 2) +
          " times as stiff as LE-2 for this section (G J = " +
          to_text(*found, 3) + " instead of " + to_text(*truth, 3) +
          "). Bending of the section's walls is too stiff as well. Use LE-N if "
          "the body twists or its walls bend");
    }

    /// Returns the relative increase of the axial stiffness without lateral
    /// contraction: C_yy over E_y, both summed over the area, less one.
    double
    contraction_stiffening(const SectionMesh       &section,
                           const SectionProperties &p)
    {
      double held = 0., contracting = 0.;
      for (unsigned int i = 0; i < section.plies.size(); ++i)
        {
          const Ply &ply = section.plies[i];
          held += p.ply_areas[i] * ply.stiffness()[1][1];
          contracting += p.ply_areas[i] / compliance(ply)[1][1];
        }
      return held / contracting - 1.;
    }



    /// Returns the lengths of the first and the last element.
    std::array<double, 2>
    end_elements(const AxisMesh &axis)
    {
      const double first =
                     axis.breaks.empty() ? axis.length : axis.breaks.front(),
                   last = axis.length -
                          (axis.breaks.empty() ? 0. : axis.breaks.back());
      return {{first / axis.elements.front(), last / axis.elements.back()}};
    }



    /// Returns whether @p support clamps end 0 (start) or 1 of body @p b.
    bool
    clamps(const Support &support, const unsigned int b, const unsigned int end)
    {
      const bool holds_all =
        !support.normal && support.u[0] && support.u[1] && support.u[2];
      return holds_all && std::any_of(support.on.begin(),
                                      support.on.end(),
                                      [&](const Region &region) {
                                        return region.body == b &&
                                               region.covers_end(end == 0);
                                      });
    }



    /// Adds notes on long elements at clamps, which prevent contraction within
    /// about a width of the section; long elements spread this disturbance.
    void
    add_clamp_note(const unsigned int        number,
                   const Scene              &scene,
                   const SectionMesh        &mesh,
                   std::vector<std::string> &notes)
    {
      // Elements longer than `coarse` widths are reported, `fine` ones
      // suffice. `cost` is the error of the deflection per stiffening and
      // share of the length (measured, doc/theory/theories.md).
      constexpr double coarse = 0.5, fine = 0.25, cost = 0.16, worth = 2e-3;

      const BodyDescription  &body    = scene.bodies[number];
      const SectionProperties p       = section_properties(mesh);
      const double            width   = p.low.distance(p.high);
      double                  longest = 0.;
      for (const Support &support : scene.supports)
        for (const unsigned int end : {0, 1})
          if (clamps(support, number, end))
            longest = std::max(longest, end_elements(body.axis)[end]);
      const double error =
        cost * contraction_stiffening(mesh, p) * longest / body.axis.length;
      if (longest > coarse * width && error > worth)
        notes.push_back(
          "scene.long-element-at-clamp: body " + body.name +
          ": a support constrains the section at an element of length " +
          to_text(longest, 3) + ", " + to_text(longest / width, 2) +
          " times the width of the section, so deflections may be " +
          to_text(100. * error, 1) +
          " % too small. Use elements of the length " +
          to_text(fine * width, 2) + " next to this support (Axis breaks)");
    }



    /// Returns whether LE-1 is used all along the axis or in some piece.
    bool
    has_LE_1(const BodyDescription &body)
    {
      std::vector<Theory> theories = body.pieces.theories;
      theories.push_back(body.theory);
      return std::any_of(theories.begin(),
                         theories.end(),
                         [](const Theory &theory) {
                           return theory.is_layerwise() && theory.order == 1;
                         });
    }



    /// Returns notes on the errors of low orders.
    std::vector<std::string>
    notes_on_orders(const Scene &scene)
    {
      std::vector<std::string> notes;
      for (const BodyDescription &body : scene.bodies)
        {
          if (!body.theory.is_solid() && body.axis.degree < 3 &&
              !body.axis.assumed_shear)
            notes.push_back(
              "scene.shear-locking: body " + body.name + ": B" +
              std::to_string(body.axis.degree + 1) +
              " elements with Shear strains = full are too stiff in bending if "
              "they are longer than the section is high (shear locking). Use "
              "Axis element = B4, or Shear strains = auto");
          if (has_LE_1(body))
            notes.push_back(
              "scene.poisson-locking: body " + body.name +
              ": the bilinear cells (L4) of LE-1 cannot contract in bending "
              "and are too stiff (Poisson locking). Use LE-2");
        }
      return notes;
    }



    /// Returns notes on sections where incompatible modes are ineffective.
    std::vector<std::string>
    notes_on_hexahedra(const Scene &scene)
    {
      std::vector<std::string> notes;
      for (const BodyDescription &body : scene.bodies)
        {
          const SectionShape &shape = scene.sections.at(body.section);
          if (body.theory.is_solid() && body.theory.order == 1 &&
              !std::holds_alternative<Laminate>(shape) &&
              !std::holds_alternative<ThinWalled>(shape))
            notes.push_back(
              "scene.distorted-solid-1: body " + body.name +
              ": long hexahedra of solid-1 are too stiff in bending if section "
              "cells are no rectangles, by tens of per cent for this shape (" +
              name_of(shape) + "). Use Theory = solid-2");
        }
      return notes;
    }



    /// Returns notes on theories without free twist for off-axis plies.
    std::vector<std::string>
    notes_on_coupling(const Scene &scene)
    {
      std::vector<std::string> notes;
      for (const BodyDescription &body : scene.bodies)
        {
          const Laminate *laminate =
            std::get_if<Laminate>(&scene.sections.at(body.section));
          if (laminate == nullptr || body.theory.describes_contraction())
            continue;
          const LaminateStiffness stiffness =
            laminate_stiffness(laminate->plies(scene.materials),
                               laminate->width);
          const double ratio = stiffness.EI_untwisted / stiffness.EI;
          if (ratio > 1.01)
            notes.push_back(
              "scene.bend-twist-coupling: body " + body.name +
              ": the layup twists when it bends, which " + body.theory.name() +
              " cannot describe. By lamination theory this makes the body " +
              to_text(ratio, 3) +
              " times too stiff in bending. Use TE-N with N >= 2, or LE-N");
        }
      return notes;
    }
  } // namespace



  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes)
  {
    std::vector<std::string> notes;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const BodyDescription &body = scene.bodies[b];
        const auto            &mesh = meshes.at(body.section);
        // Other theories have plane sections, or contract freely.
        if (body.theory.describes_contraction() && !body.theory.is_solid())
          add_clamp_note(b, scene, *mesh, notes);
        if (!body.theory.is_single_layer())
          continue;
        add_shear_note(body, scene, notes);
        if (!std::holds_alternative<Laminate>(scene.sections.at(body.section)))
          add_torsion_note(body, mesh, notes);
      }
    return notes;
  }



  std::vector<std::string>
  notes_on_choices(const Scene &scene)
  {
    std::vector<std::string> notes;
    for (const auto &found : {notes_on_orders(scene),
                              notes_on_hexahedra(scene),
                              notes_on_coupling(scene)})
      notes.insert(notes.end(), found.begin(), found.end());
    return notes;
  }
} // namespace lamella
