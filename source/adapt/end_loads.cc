// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/base/arithmetic.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <cmath>
#include <utility>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using RigidField::n_all;



    /// The tractions of the six states on the section: S_10 a + S_11 b.
    std::vector<Vector>
    tractions(const SaintVenant &states)
    {
      const Section      &section = states.of_section();
      std::vector<Vector> result;
      for (unsigned int k = 0; k < states.values().size(); ++k)
        {
          Vector load(section.n_fields());
          section.S(1, 0).vmult(load, states.values()[k]);
          section.S(1, 1).vmult_add(load, states.derivatives()[k]);
          result.push_back(load);
        }
      return result;
    }



    /// The section forces at the held end, in the order of SaintVenant::Force,
    /// of the section load @p load at the distance @p arm in y from it.
    Tensor<1, 6>
    forces_at_end(const Section &section, const Vector &load, const double arm)
    {
      namespace Rigid = RigidField;
      const double h  = section.element().reference_length();
      Tensor<1, 6> forces;
      forces[SaintVenant::F_x] = load[Rigid::translation_x];
      forces[SaintVenant::F_y] = load[Rigid::translation_y];
      forces[SaintVenant::F_z] = load[Rigid::translation_z];
      forces[SaintVenant::M_y] = h * load[Rigid::rotation_y];
      forces[SaintVenant::M_x] =
        arm * load[Rigid::translation_z] - h * load[Rigid::slope_z];
      forces[SaintVenant::M_z] =
        h * load[Rigid::slope_x] - arm * load[Rigid::translation_x];
      return forces;
    }



    /// Eigenvalues, ascending, and eigenvectors of the symmetric @p matrix.
    std::pair<Vector, FullMatrix<double>>
    eigenvalues_of(const LAPACKFullMatrix<double> &matrix)
    {
      LAPACKFullMatrix<double>              copy = matrix;
      std::pair<Vector, FullMatrix<double>> result;
      const double                          bound =
        2. * matrix.frobenius_norm() + arithmetic::smallest_divisor;
      copy.set_property(LAPACKSupport::symmetric);
      copy.compute_eigenvalues_symmetric(
        -bound, bound, 0., result.first, result.second);
      return result;
    }



    /// Combinations of six loads, a column each, that do no work on the free
    /// motions: @p work is that of the loads on each of these.
    FullMatrix<double>
    without_work_on(const std::vector<Tensor<1, 6>> &work)
    {
      LAPACKFullMatrix<double> gram(n_all, n_all);
      for (const Tensor<1, 6> &one : work)
        for (unsigned int i = 0; i < n_all; ++i)
          for (unsigned int j = 0; j < n_all; ++j)
            gram(i, j) += one[i] * one[j] / one.norm_square();
      const auto [values, vectors] = eigenvalues_of(gram);
      unsigned int n               = 0;
      while (n < n_all && values[n] < arithmetic::rounding_of_solutions)
        ++n;
      FullMatrix<double> result(n_all, n);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int i = 0; i < n_all; ++i)
          result(i, k) = vectors(i, k);
      return result;
    }



    /// The work of the six section @p loads at the node whose DoFs begin at
    /// @p first on each of @p motions.
    std::vector<Tensor<1, 6>>
    work_of(const std::vector<Vector> &loads,
            const std::vector<Vector> &motions,
            const DofIndex             first)
    {
      std::vector<Tensor<1, 6>> work(motions.size());
      for (unsigned int m = 0; m < motions.size(); ++m)
        for (unsigned int k = 0; k < n_all; ++k)
          for (unsigned int a = 0; a < loads[k].size(); ++a)
            work[m][k] += motions[m][first + a] * loads[k][a];
      return work;
    }
  } // namespace



  std::vector<Vector>
  free_motions(const Beam &piece, const std::vector<PrescribedFunctional> &rows)
  {
    std::vector<Vector> rigid = piece.rigid_motions(undisplaced);
    for (Vector &motion : rigid)
      motion /= motion.linfty_norm();
    LAPACKFullMatrix<double> gram(n_all, n_all);
    for (const PrescribedFunctional &row : rows)
      {
        std::array<double, n_all> value;
        for (unsigned int j = 0; j < n_all; ++j)
          value[j] = row.row.row(rigid[j]);
        for (unsigned int i = 0; i < n_all; ++i)
          for (unsigned int j = 0; j < n_all; ++j)
            gram(i, j) += value[i] * value[j];
      }
    const auto [values, vectors] = eigenvalues_of(gram);
    std::vector<Vector> result;
    for (unsigned int k = 0; k < n_all; ++k)
      if (values[k] <= arithmetic::rounding_of_results * values[n_all - 1])
        {
          Vector motion(piece.n_dofs());
          for (unsigned int j = 0; j < n_all; ++j)
            motion.add(vectors(j, k), rigid[j]);
          result.push_back(motion);
        }
    return result;
  }



  std::vector<Vector>
  end_loads(const SaintVenant         &states,
            const Beam                &piece,
            const unsigned int         far_node,
            const double               arm,
            const std::vector<Vector> &motions)
  {
    const Section      &section = states.of_section();
    std::vector<Vector> loads   = tractions(states);
    // Unit energy each, so that no digits are lost by powers of lengths.
    for (Vector &load : loads)
      {
        const Tensor<1, 6> s = forces_at_end(section, load, arm);
        load /= std::sqrt(s * (states.compliance() * s));
      }
    const FullMatrix<double> parts =
      without_work_on(work_of(loads, motions, piece.dofs().first(far_node)));
    const unsigned int n = parts.n();

    std::vector<Vector> combined(n, Vector(section.n_fields()));
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int i = 0; i < n_all; ++i)
        combined[k].add(parts(i, k), loads[i]);
    LAPACKFullMatrix<double> energy(n, n);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; l < n; ++l)
        energy(k, l) =
          forces_at_end(section, combined[k], arm) *
          (states.compliance() * forces_at_end(section, combined[l], arm));
    std::vector<Vector> result(n, Vector(section.n_fields()));
    if (n == 0)
      return result;
    const auto [values, vectors] = eigenvalues_of(energy);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; l < n; ++l)
        result[k].add(vectors(l, k) / std::sqrt(values[k]), combined[l]);
    return result;
  }



  HeatedSection::HeatedSection(const SaintVenant              &states,
                               const Beam::SectionThermalLoad &heat)
    : answer(states.response_to_constant(heat.on_values))
    , traction(answer.size())
  {
    const Section &section = states.of_section();
    section.S(1, 0).vmult(traction, answer);
    const double size =
      traction.linfty_norm() + heat.on_derivatives.linfty_norm();
    traction -= heat.on_derivatives;
    const std::vector<Vector> of_states = tractions(states);
    FullMatrix<double>        forces(n_all);
    for (unsigned int j = 0; j < n_all; ++j)
      for (unsigned int i = 0; i < n_all; ++i)
        forces(i, j) = forces_at_end(section, of_states[j], 0.)[i];
    forces.gauss_jordan();
    const Tensor<1, 6> left = forces_at_end(section, traction, 0.);
    for (unsigned int j = 0; j < n_all; ++j)
      {
        double part = 0.;
        for (unsigned int i = 0; i < n_all; ++i)
          part += forces(j, i) * left[i];
        traction.add(-part, of_states[j]);
        answer.add(-part, states.values()[j]);
      }
    if (traction.linfty_norm() < arithmetic::same_value * size)
      traction = 0.;
  }
} // namespace lamella
