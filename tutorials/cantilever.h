// SPDX-License-Identifier: LGPL-2.1-or-later

// The beam of step-9: one space of fields in which several theories are lists
// (step-8), so that what one of them finds can be said in the words of another,
// exactly.

#ifndef lamella_tutorials_cantilever_h
#define lamella_tutorials_cantilever_h

#include <lamella/body/beam.h>
#include <lamella/scene/scene.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/warping.h>
#include <lamella/solve/linear_system.h>

#include <memory>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace lamella
{
  /// The fields that a node carries, by their numbers.
  using List = std::vector<unsigned int>;



  /// A beam all of whose nodes carry one list, with its factors and what it
  /// finds.
  struct Model
  {
    List                                   list;
    std::unique_ptr<Structure>             structure;
    std::shared_ptr<const TangentOperator> factors;
    Vector                                 u;
  };



  struct Cantilever
  {
    const Scene                         scene;
    std::shared_ptr<const Section>      section;
    std::shared_ptr<const SectionSpace> space;
    std::shared_ptr<const Axis>         axis;

    /// The section of the scene in @p file with the functions of LE-3,
    /// hierarchical by degree, and the six Saint-Venant warpings beside them.
    /// The axis is finer than the scene's where stresses are asked for.
    explicit Cantilever(const std::string &file)
      : scene(read_scene(SceneText::read(file, {})))
    {
      Theory theory       = Theory::parse({"Theory", "LE-3"});
      theory.hierarchical = true;
      section = make_section(build_section_meshes(scene).at("strip"), theory);
      const SaintVenant states(*section);
      const Warping     warping(*section);
      space =
        std::make_shared<SectionSpace>(section,
                                       saint_venant_warpings(states, warping));

      AxisMesh description = scene.bodies[0].axis;
      description.breaks   = {3., 7., 9., 11., 13., 20.};
      description.elements = {2, 2, 2, 4, 2, 3, 4};
      axis                 = std::make_shared<Axis>(description);
    }

    /// LE of @p degree: the fields of the section up to this degree.
    List
    layer_wise(const unsigned int degree) const
    {
      List list;
      for (unsigned int alpha = 0; alpha < section->n_fields(); ++alpha)
        if (section->field_degree(alpha) <= degree)
          list.push_back(alpha);
      return list;
    }

    /// SV: six rigid motions of the section and six warpings.
    List
    saint_venant() const
    {
      List list(6 + space->n_modes());
      std::iota(list.begin(), list.begin() + 6, 0);
      std::iota(list.begin() + 6, list.end(), space->first_mode());
      return list;
    }

    /// What every run computes, with the scene's clamp and load: K u = f.
    Model
    solved(const List &list) const
    {
      Bodies bodies;
      bodies.push_back(
        std::make_unique<Beam>("beam",
                               space,
                               axis,
                               scene.bodies[0].placement,
                               std::vector<List>(axis->n_nodes(), list),
                               "a list"));
      Model model;
      model.list      = list;
      model.structure = std::make_unique<Structure>(std::move(bodies),
                                                    scene.supports,
                                                    scene.loads);
      model.factors   = linearized(*model.structure);
      const std::vector<GapConstraint> no_rows;
      model.u = LinearSystem(model.factors, no_rows).solve_free(1.).u.block(0);
      return model;
    }

    /// A displacement @p u of nodes with @p list in the words of nodes with all
    /// fields of the section: of these each is itself, a mode is a combination.
    Vector
    embedded(const Vector &u, const List &list) const
    {
      const unsigned int n = section->n_fields();
      Vector             result(axis->n_nodes() * n);
      for (unsigned int k = 0; k < list.size(); ++k)
        {
          const Vector field = space->in_section_functions(list[k]);
          for (unsigned int node = 0; node < axis->n_nodes(); ++node)
            for (unsigned int alpha = 0; alpha < n; ++alpha)
              result[node * n + alpha] +=
                u[node * list.size() + k] * field[alpha];
        }
      return result;
    }

    /// A displacement @p u of @p body on a grid of the section x = 1.5 along
    /// the beam, for plot.py.
    static void
    draw(std::ostream      &csv,
         const std::string &name,
         const Body        &body,
         const Vector      &u)
    {
      for (unsigned int j = 0; j <= 12; ++j)
        for (unsigned int i = 0; i <= 120; ++i)
          {
            const dealii::Point<3> place(1.5, 0.25 * i, 0.25 * j);
            const auto at    = locate_all(body, {place}, "pictures")[0];
            const auto moved = body.sample(at, u).displacement;
            csv << name << "," << place[1] << "," << place[2] << "," << moved[1]
                << "," << moved[2] << "\n";
          }
    }
  };
} // namespace lamella

#endif
