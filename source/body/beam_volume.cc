// SPDX-License-Identifier: LGPL-2.1-or-later

// What acts in the volume of a beam: heat and weight.

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The forces that the stress @p stress, times what it stands for, does
    /// work with at @p point: of each of its fields those on its value without
    /// transverse shear, on its value in transverse shear, on its derivative.
    std::vector<std::array<double, 3>>
    work_of(const Voigt &stress, const SectionPoint &point)
    {
      std::vector<std::array<double, 3>> work(point.fields->size());
      for (unsigned int a = 0; a < work.size(); ++a)
        {
          for (unsigned int c = 0; c < 6; ++c)
            work[a][is_transverse_shear(c) ? 1 : 0] +=
              point.in_plane[a][c] * stress[c];
          work[a][2] = point.along[a] * stress;
        }
      return work;
    }
  } // namespace



  void
  Beam::heat(const ScalarField &change)
  {
    if (beam_section->completes_by_modes())
      throw InputError("Body " + name() + "/Kinematics/Theory",
                       beam_section->theory().name(),
                       "has contracting modes that heat would strain, too, "
                       "which this theory leaves out",
                       "Take TE-2, LE-N or SV-N for a body with a Temperature, "
                       "or Poisson correction = false.");
    Body::heat(change);
  }



  ElasticLaw
  Beam::law_at(const unsigned int cell,
               const Point<2>    &at,
               const Point<3>    &x) const
  {
    if (!is_heated())
      return beam_section->law(cell, at);
    const Ply &ply = beam_section->plies()[beam_section->cell_ply(cell)];
    return ElasticLaw(beam_section->law(cell, at).stiffness(),
                      temperature(x) * ply.expansion(at));
  }



  Voigt
  Beam::expansion_at(const SectionPoint &point) const
  {
    const Ply &ply = beam_section->plies()[beam_section->cell_ply(point.cell)];
    return ply.expansion(point.position);
  }



  void
  Beam::add_section_works(std::vector<SectionWork> work,
                          const unsigned int       begin,
                          Vector                  &share) const
  {
    SectionForce force;
    for (unsigned int k = 0; k < work.size(); ++k)
      {
        for (unsigned int p = 0; p < 3; ++p)
          {
            space->append_modes(work[k][p]);
            force.work[p].reinit(work[k][p].size(), true);
            std::copy(work[k][p].begin(),
                      work[k][p].end(),
                      force.work[p].begin());
          }
        add_section_force(begin + k, force, share);
      }
  }



  std::pair<std::vector<Beam::SectionWork>, double>
  Beam::works_of_heat() const
  {
    const auto [begin, end]               = own_points();
    const auto               &axis_points = beam_axis->integration_points();
    double                    energy      = 0.;
    const std::vector<double> none(beam_section->n_fields(), 0.);
    std::vector<SectionWork>  work(end - begin, {{none, none, none}});
    beam_section->for_each_point(
      [&, first = begin, last = end](const SectionPoint &point,
                                     const double        weight) {
        const Voigt alpha = expansion_at(point);
        const Voigt active =
          alpha - beam_section->completion_of_initial(point.cell,
                                                      point.position,
                                                      alpha);
        // Of one kelvin.
        const Voigt stress =
          weight *
          (beam_section->law(point.cell, point.position).stiffness() * active);
        const auto unit = work_of(stress, point);
        for (unsigned int k = first; k < last; ++k)
          {
            const double T = temperature(placement.to_scene(
              {point.position[0], axis_points[k].y, point.position[1]}));
            energy += 0.5 * T * T * beam_axis->integration_weights()[k] *
                      (stress * active);
            for (unsigned int a = 0; a < unit.size(); ++a)
              for (unsigned int p = 0; p < 3; ++p)
                work[k - first][p][(*point.fields)[a]] += T * unit[a][p];
          }
      });
    return {std::move(work), energy};
  }



  double
  Beam::add_heat(Vector &f) const
  {
    if (!is_heated())
      return 0.;
    auto [work, energy] = works_of_heat();
    Vector share(f.size());
    add_section_works(std::move(work), own_points().first, share);
    sum_over_processes(share);
    f += share;
    return Utilities::MPI::sum(energy, communicator());
  }



  Beam::SectionHeat
  Beam::section_heat(const double y) const
  {
    SectionHeat heat{Vector(beam_section->n_fields()),
                     Vector(beam_section->n_fields())};
    if (!is_heated())
      return heat;
    beam_section->for_each_point([&](const SectionPoint &point,
                                     const double        weight) {
      const double T = temperature(
        placement.to_scene({point.position[0], y, point.position[1]}));
      const Voigt alpha = expansion_at(point);
      const Voigt active =
        alpha -
        beam_section->completion_of_initial(point.cell, point.position, alpha);
      const auto work =
        work_of(weight * T *
                  (beam_section->law(point.cell, point.position).stiffness() *
                   active),
                point);
      for (unsigned int a = 0; a < work.size(); ++a)
        {
          heat.on_values[(*point.fields)[a]] += work[a][0] + work[a][1];
          heat.on_derivatives[(*point.fields)[a]] += work[a][2];
        }
    });
    return heat;
  }



  Vector
  Beam::section_weight(const Tensor<1, 3> &acceleration) const
  {
    const std::vector<double> rho = densities();
    const Tensor<1, 3>        g   = placement.vector_to_body(acceleration);
    Vector                    load(beam_section->n_fields());
    beam_section->for_each_point(
      [&](const SectionPoint &point, const double weight) {
        const double mass = weight * rho[beam_section->cell_ply(point.cell)];
        for (unsigned int a = 0; a < point.fields->size(); ++a)
          load[(*point.fields)[a]] += mass * (g * point.value[a]);
      });
    return load;
  }



  void
  Beam::add_weight(const Tensor<1, 3> &acceleration, Vector &f) const
  {
    const Vector              load = section_weight(acceleration);
    const std::vector<double> none(load.size(), 0.);
    const auto [begin, end] = own_points();
    Vector share(f.size());
    add_section_works(
      std::vector<SectionWork>(end - begin,
                               {{{load.begin(), load.end()}, none, none}}),
      begin,
      share);
    sum_over_processes(share);
    f += share;
  }
} // namespace lamella
