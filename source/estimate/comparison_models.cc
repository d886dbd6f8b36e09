// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/names.h>
#include <lamella/base/text.h>
#include <lamella/estimate/comparison_models.h>

#include <limits>
#include <ostream>

namespace lamella
{
  const Model *
  ModelCache::find(const Scene &scene) const
  {
    const auto place = models.find(key_of(scene));
    return place == models.end() ? nullptr : &place->second;
  }



  void
  ModelCache::keep(const Model &model)
  {
    models[key_of(model.scene)] = model;
  }



  ComparisonModels::ComparisonModels(const Simulation &run,
                                     std::ostream     &out,
                                     ModelCache       &cache)
    : run(run)
    , out(out)
    , cache(cache)
  {}



  Model
  ComparisonModels::solved(const Scene                                   &scene,
                           const std::string                             &what,
                           const std::function<void(const Simulation &)> &look)
  {
    const auto numbered = [this](Model model) {
      model.numbers.number_modes_as(run.results());
      return model;
    };
    if (const Model *known = cache.find(scene); known != nullptr && !look)
      return numbered(*known);
    std::ostream nowhere(nullptr);
    out << "  " << what << ": " << std::flush;
    // `Rotations = auto` is decided for the run itself only.
    Scene compared                    = scene;
    compared.solve.computes_estimates = false;
    Simulation     simulation(compared, nowhere, run.model().rules());
    const Results &results = simulation.solve();
    Model          model{simulation.model().scene(),
                ResultNumbers(results),
                sizes_of(simulation.model())};
    out << results.n_dofs() << " DoFs, "
        << to_text(results.seconds.at("total"), 2) << " s" << std::endl;
    cache.keep(model);
    if (look)
      look(simulation);
    return numbered(std::move(model));
  }



  namespace
  {
    // Each of these functions decomposes its structure, so that a new member
    // does not compile until it is named. Unused members come from the text.

    std::string
    describe(const double number)
    {
      return to_text(number, std::numeric_limits<double>::max_digits10) + " ";
    }

    std::string
    describe(const unsigned int number)
    {
      return std::to_string(number) + " ";
    }



    std::string
    describe(const Theory &theory)
    {
      const auto &[kind,
                   order,
                   section_order,
                   hierarchical,
                   poisson_correction,
                   shear_factor,
                   twists] = theory;
      return describe(static_cast<unsigned int>(kind)) + describe(order) +
             describe(section_order) + (hierarchical ? "h" : "") +
             (poisson_correction ? "p" : "") + describe(shear_factor) +
             (twists ? "t" : "");
    }



    template <typename Number>
    std::string
    describe(const std::vector<Number> &numbers)
    {
      std::string words;
      for (const Number &number : numbers)
        words += describe(number);
      return words + "| ";
    }



    /// Returns the element ends of @p axis in any notation. Repeated halves are
    /// sums: ends are rounded to fractions of the length above rounding errors.
    std::string
    describe_ends(const AxisMesh &axis)
    {
      std::string words;
      double      end = 0.;
      for (const double length : element_lengths(axis))
        {
          end += length;
          words += std::to_string(std::llround(
                     end / (arithmetic::same_position_along * axis.length))) +
                   " ";
        }
      return words + "| ";
    }



    std::string
    describe(const AxisMesh &axis)
    {
      const auto &[length,
                   degree,
                   elements,
                   breaks,
                   refinement_factor,
                   equidistant_nodes,
                   assumed_shear] = axis;
      // A graded axis has no elements yet.
      return describe(length) + describe(degree) +
             (refinement_factor > 0. ? describe(elements) + describe(breaks) :
                                       describe_ends(axis)) +
             describe(refinement_factor) + (equidistant_nodes ? "e" : "") +
             (assumed_shear ? "s" : "");
    }



    std::string
    describe(const SolidRefinement &refinement)
    {
      const auto &[everywhere, balls, memory_limit] = refinement;
      std::string words                             = describe(everywhere);
      for (const auto &[center, radius, times] : balls)
        words += describe(center[0]) + describe(center[1]) +
                 describe(center[2]) + describe(radius) + describe(times);
      return words;
    }



    std::string
    describe(const BodyDescription &body)
    {
      const auto &[name,
                   section,
                   theory,
                   pieces,
                   placement,
                   axis,
                   stabilization,
                   is_held,
                   has_finite_rotations,
                   has_inertia,
                   refinement]     = body;
      const auto &[theories, ends] = pieces;
      return name + " " + section + " " + describe(theory) +
             describe(theories) + describe(ends) + describe(axis) +
             (stabilization ? describe(*stabilization) : "") +
             (is_held ? "held " : "") + (has_finite_rotations ? "turns " : "") +
             (has_inertia ? "has inertia " : "") + describe(refinement);
    }



    std::string
    describe(const ContactPair &contact)
    {
      const auto &[name,
                   first,
                   second,
                   obstacle,
                   discretization,
                   enforcement,
                   overclosure,
                   slave_side,
                   penalty,
                   tolerance,
                   search_distance,
                   friction,
                   is_automatic,
                   part_of,
                   adhesive,
                   where]                             = contact;
      const auto &[kind, value]                       = penalty;
      const auto &[thickness, modulus, shear_modulus] = adhesive;
      std::string words                               = name;
      for (const auto choice : {static_cast<unsigned int>(discretization),
                                static_cast<unsigned int>(enforcement),
                                static_cast<unsigned int>(overclosure),
                                static_cast<unsigned int>(slave_side),
                                static_cast<unsigned int>(is_automatic),
                                part_of.value_or(0),
                                static_cast<unsigned int>(kind)})
        words += " " + describe(choice);
      return words + describe(value) + describe(tolerance) +
             describe(friction) + describe(thickness) + describe(modulus) +
             describe(shear_modulus) +
             (search_distance ? describe(*search_distance) : "");
    }


    /// Returns the nonzero refinements @p what of sections.
    std::string
    describe(const std::string                         &what,
             const std::map<std::string, unsigned int> &times)
    {
      std::string words;
      for (const auto &[section, number] : times)
        if (number > 0)
          words += section + " " + what + describe(number) + "; ";
      return words;
    }



    std::string
    describe(const FindRequest &find)
    {
      const bool is_number = find.modes && !find.modes->range;
      return describe(is_number ? find.modes->number : 0) +
             (find.modes && find.modes->has_stresses ? "stressed " : "") +
             describe(find.n_buckling_modes);
    }
  } // namespace



  std::string
  key_of(const Scene &scene)
  {
    const auto &[title,
                 units,
                 materials,
                 sections,
                 divisions,
                 corner_layers,
                 bodies,
                 supports,
                 loads,
                 gravity,
                 obstacles,
                 contacts,
                 solve,
                 probes,
                 lines,
                 cuts,
                 measures,
                 strength,
                 find,
                 support_references,
                 contact_references,
                 write_vtu,
                 goals,
                 trade,
                 warnings,
                 resolved] = scene;
    std::string key        = resolved;
    for (const unsigned int n : solve.substeps.each)
      key += describe(n);
    for (const BodyDescription &body : bodies)
      key += describe(body) + "; ";
    key += describe("divided", divisions);
    key += describe("corner layers", corner_layers);
    for (const ContactPair &contact : contacts)
      key += describe(contact) + "; ";
    return key + describe(find);
  }
} // namespace lamella
