// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/body/beam_geometric_stiffness.h>
#include <lamella/body/second_order.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  BeamGeometricStiffness::BeamGeometricStiffness(const Beam &beam)
    : beam(beam)
    , modes(beam.section().n_fields(), beam.fields().n_modes())
    , samples(beam.axis().degree())
  {
    for (unsigned int j = 0; j < modes.n(); ++j)
      std::copy_n(beam.fields().mode(j), modes.m(), &modes(0, j));
    const Axis &axis        = beam.axis();
    const auto [begin, end] = axis.own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      for (unsigned int s = 0; s < samples.size(); ++s)
        {
          along.push_back(axis.evaluate(cell, samples.point(s)[0]));
          lengths.push_back(samples.weight(s) *
                            (axis.cell_end(cell) - axis.cell_begin(cell)));
        }
    const QGauss<2> quadrature(
      std::max(2U, beam.section().element().n_gauss_points() - 1));
    for (unsigned int c = 0; c < beam.section().n_cells(); ++c)
      add_cell(c, quadrature);
  }



  void
  BeamGeometricStiffness::add_cell(const unsigned int   number,
                                   const Quadrature<2> &quadrature)
  {
    const Section             &section = beam.section();
    const CrossSectionElement &element = section.element();
    cells.emplace_back();
    Cell &cell = cells.back();
    for (const Point<2> &unit : quadrature.get_points())
      cell.points.push_back(section.evaluate(number, unit));
    for (const unsigned int alpha : *cell.points[0].fields)
      for (const SectionFunction::Term &term : section.field(alpha).terms)
        if (auto &fields = cell.components[term.component].fields;
            fields.empty() || fields.back() != alpha)
          fields.push_back(alpha);
    for (Component &component : cell.components)
      {
        component.value.reinit(quadrature.size(), component.fields.size());
        component.derivatives.reinit(2 * quadrature.size(),
                                     component.fields.size());
      }
    for (unsigned int p = 0; p < quadrature.size(); ++p)
      {
        cell.areas.push_back(quadrature.weight(p) * cell.points[p].jacobian);
        const FunctionValues f = element.evaluate(number, quadrature.point(p));
        for (unsigned int c = 0; c < 3; ++c)
          set_functions(c, p, f, cell);
      }
  }



  void
  BeamGeometricStiffness::set_functions(const unsigned int    c,
                                        const unsigned int    p,
                                        const FunctionValues &f,
                                        Cell                 &cell) const
  {
    const auto &functions =
      beam.section().element().cell_functions(cell.points[p].cell);
    Component &component = cell.components[c];
    for (unsigned int a = 0; a < component.fields.size(); ++a)
      for (const SectionFunction::Term &term :
           beam.section().field(component.fields[a]).terms)
        if (term.component == c)
          {
            const unsigned int k = std::lower_bound(functions.begin(),
                                                    functions.end(),
                                                    term.function) -
                                   functions.begin();
            component.value(p, a) += term.factor * f.values[k];
            component.derivatives(p, a) += term.factor * f.gradients[k][0];
            component.derivatives(cell.points.size() + p, a) +=
              term.factor * f.gradients[k][1];
          }
  }



  BeamGeometricStiffness::Coefficients
  BeamGeometricStiffness::coefficients(const Vector &w) const
  {
    // Coefficients of fields and modes: one row per node.
    const unsigned int       n_fields = beam.section().n_fields();
    LAPACKFullMatrix<double> of_nodes(beam.axis().n_nodes(), n_fields),
      of_modes(of_nodes.m(), modes.n());
    for (unsigned int node = 0; node < of_nodes.m(); ++node)
      for (unsigned int m = 0; m < beam.dofs().fields(node).size(); ++m)
        {
          const unsigned int alpha = beam.dofs().fields(node)[m];
          (alpha < n_fields ? of_nodes(node, alpha) :
                              of_modes(node, alpha - n_fields)) =
            w[beam.dofs().first(node) + m];
        }
    if (modes.n() > 0)
      of_modes.mTmult(of_nodes, modes, true);

    Coefficients q;
    for (auto &part : q)
      part.reinit(along.size(), n_fields);
    for (unsigned int alpha = 0; alpha < n_fields; ++alpha)
      for (unsigned int k = 0; k < along.size(); ++k)
        {
          const AxisPoint &at    = along[k];
          const auto      &nodes = beam.axis().nodes_of_cell(at.cell);
          for (unsigned int i = 0; i < nodes.size(); ++i)
            {
              const double here = of_nodes(nodes[i], alpha);
              q[FieldPart::value](k, alpha) += at.N[i] * here;
              q[FieldPart::shear_value](k, alpha) += at.N_shear[i] * here;
              // Derivatives of a translation are exactly zero.
              q[FieldPart::derivative](k, alpha) +=
                at.dN[i] * (here - of_nodes(nodes[0], alpha));
            }
        }
    return q;
  }



  void
  BeamGeometricStiffness::find_stress(const Coefficients &q,
                                      const SectionPoint &point,
                                      const double        area,
                                      Voigt              *at_point)
  {
    std::vector<Voigt> strain(along.size());
    for (unsigned int a = 0; a < point.fields->size(); ++a)
      {
        const unsigned int alpha = (*point.fields)[a];
        Voigt              of_value, of_shear;
        for (unsigned int c = 0; c < 6; ++c)
          (is_transverse_shear(c) ? of_shear : of_value)[c] =
            point.in_plane[a][c];
        for (unsigned int k = 0; k < strain.size(); ++k)
          strain[k] += q[FieldPart::value](k, alpha) * of_value +
                       q[FieldPart::shear_value](k, alpha) * of_shear +
                       q[FieldPart::derivative](k, alpha) * point.along[a];
      }
    ElasticLaw law = beam.section().law(point.cell, point.position);
    for (unsigned int k = 0; k < strain.size(); ++k)
      {
        if (beam.is_heated())
          {
            law = beam.law_at(point.cell,
                              point.position,
                              beam.placement.to_scene({point.position[0],
                                                       along[k].y,
                                                       point.position[1]}));
            strain[k] +=
              beam.section().completion_of_initial(point.cell,
                                                   point.position,
                                                   law.initial_strain());
          }
        const Voigt stress = law.stress(strain[k]);
        at_point[k]        = area * lengths[k] * stress;
        largest_wave =
          std::max(largest_wave, short_wave_ratio(stress, law.stiffness()));
      }
  }



  void
  BeamGeometricStiffness::set_stress(const Coefficients &q)
  {
    stress.clear();
    largest_wave = 0.;
    for (const Cell &cell : cells)
      for (unsigned int p = 0; p < cell.points.size(); ++p)
        {
          stress.resize(stress.size() + along.size());
          find_stress(q,
                      cell.points[p],
                      cell.areas[p],
                      stress.data() + (stress.size() - along.size()));
        }
  }



  namespace
  {
    /// Replaces the derivatives u_,i of a component of u by s_ij u_,j.
    void
    apply(const Voigt &s, double &x, double &y, double &z)
    {
      const std::array<double, 3> forces{{s[0] * x + s[3] * y + s[4] * z,
                                          s[3] * x + s[1] * y + s[5] * z,
                                          s[4] * x + s[5] * y + s[2] * z}};
      x = forces[0];
      y = forces[1];
      z = forces[2];
    }
  } // namespace



  void
  BeamGeometricStiffness::add_work(const Component    &component,
                                   const Voigt        *of_cell,
                                   const Coefficients &q,
                                   Coefficients       &work) const
  {
    constexpr std::array<unsigned int, 2> kinds{
      {FieldPart::value, FieldPart::derivative}};
    const unsigned int K = along.size(), n_points = component.value.m(),
                       n_fields = component.fields.size();
    std::array<LAPACKFullMatrix<double>, 2> parts, gradients;
    gradients[0].reinit(K, 2 * n_points);
    gradients[1].reinit(K, n_points);
    const std::array<const LAPACKFullMatrix<double> *, 2> functions{
      {&component.derivatives, &component.value}};
    for (unsigned int i = 0; i < 2; ++i)
      {
        parts[i].reinit(K, n_fields);
        for (unsigned int a = 0; a < n_fields; ++a)
          std::copy_n(&q[kinds[i]](0, component.fields[a]), K, &parts[i](0, a));
        parts[i].mTmult(gradients[i], *functions[i]);
      }
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int k = 0; k < K; ++k)
        apply(of_cell[p * K + k],
              gradients[0](k, p),
              gradients[1](k, p),
              gradients[0](k, n_points + p));
    for (unsigned int i = 0; i < 2; ++i)
      {
        gradients[i].mmult(parts[i], *functions[i]);
        for (unsigned int a = 0; a < n_fields; ++a)
          for (unsigned int k = 0; k < K; ++k)
            work[kinds[i]](k, component.fields[a]) += parts[i](k, a);
      }
  }



  void
  BeamGeometricStiffness::add_forces(const Vector &w, Vector &f) const
  {
    Vector share(f.size());
    if (!along.empty())
      {
        const Coefficients q    = coefficients(w);
        Coefficients       work = q;
        for (auto &part : work)
          part = 0.;
        const Voigt *of_cell = stress.data();
        for (const Cell &cell : cells)
          {
            for (const Component &component : cell.components)
              if (!component.fields.empty())
                add_work(component, of_cell, q, work);
            of_cell += cell.points.size() * along.size();
          }
        add_on_nodes(work, share);
      }
    sum_over_processes(share);
    f += share;
  }



  void
  BeamGeometricStiffness::add_on_nodes(const Coefficients &work,
                                       Vector             &f) const
  {
    const unsigned int       n_fields = beam.section().n_fields();
    LAPACKFullMatrix<double> on_nodes(beam.axis().n_nodes(), n_fields),
      on_modes(on_nodes.m(), modes.n());
    for (unsigned int alpha = 0; alpha < n_fields; ++alpha)
      for (unsigned int k = 0; k < along.size(); ++k)
        {
          const AxisPoint &at    = along[k];
          const auto      &nodes = beam.axis().nodes_of_cell(at.cell);
          for (unsigned int i = 0; i < nodes.size(); ++i)
            on_nodes(nodes[i], alpha) +=
              at.N[i] * work[FieldPart::value](k, alpha) +
              at.dN[i] * work[FieldPart::derivative](k, alpha);
        }
    if (modes.n() > 0)
      on_nodes.mmult(on_modes, modes);
    for (unsigned int node = 0; node < on_nodes.m(); ++node)
      for (unsigned int m = 0; m < beam.dofs().fields(node).size(); ++m)
        {
          const unsigned int alpha = beam.dofs().fields(node)[m];
          f[beam.dofs().first(node) + m] += alpha < n_fields ?
                                              on_nodes(node, alpha) :
                                              on_modes(node, alpha - n_fields);
        }
  }



  double
  BeamGeometricStiffness::largest_short_wave_ratio() const
  {
    return Utilities::MPI::max(largest_wave, communicator());
  }



  double
  short_wave_ratio(const Voigt &stress, const ElasticTensor &C)
  {
    return std::max({0.,
                     -stress[0] / std::min(C[3][3], C[4][4]),
                     -stress[1] / std::min(C[3][3], C[5][5]),
                     -stress[2] / std::min(C[4][4], C[5][5])});
  }
} // namespace lamella
