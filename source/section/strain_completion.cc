// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/strain_completion.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Strains of section fields, and those that free contraction completes.
    constexpr std::array<unsigned int, 3> kept{{1, 3, 5}}, completed{{0, 2, 4}};



    /// P with eps = P eps_kept, see FreeContraction.
    ElasticTensor
    free_contraction(const ElasticTensor &C)
    {
      Tensor<2, 3> C_bb, C_ba;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            C_bb[i][j] = C[completed[i]][completed[j]];
            C_ba[i][j] = C[completed[i]][kept[j]];
          }
      const Tensor<2, 3> b_of_a = -1. * (invert(C_bb) * C_ba);
      ElasticTensor      P;
      for (unsigned int i = 0; i < 3; ++i)
        {
          P[kept[i]][kept[i]] = 1.;
          for (unsigned int j = 0; j < 3; ++j)
            P[completed[i]][kept[j]] = b_of_a[i][j];
        }
      return P;
    }
  } // namespace



  FreeContraction::FreeContraction(const PlyLaws                   &laws,
                                   const std::vector<unsigned int> &ply_of_cell)
    : laws(laws)
    , ply_of_cell(ply_of_cell)
  {
    for (unsigned int ply = 0; ply < laws.n_plies(); ++ply)
      completion.push_back(free_contraction(laws.constant(ply).stiffness()));
  }



  ElasticTensor
  FreeContraction::completion_at(const unsigned int cell,
                                 const Point<2>    &x) const
  {
    const unsigned int ply = ply_of_cell[cell];
    return laws.has_varying_law(ply) ?
             free_contraction(laws.at(ply, x).stiffness()) :
             completion[ply];
  }



  void
  FreeContraction::complete(SectionPoint &point) const
  {
    const ElasticTensor P = completion_at(point.cell, point.position);
    for (Voigt &strain : point.in_plane)
      strain = P * strain;
    for (Voigt &strain : point.along)
      strain = P * strain;
  }



  Voigt
  FreeContraction::of_initial(const unsigned int cell,
                              const Point<2>    &x,
                              const Voigt       &initial) const
  {
    return initial - completion_at(cell, x) * initial;
  }



  ContractionModes::ContractionModes(
    const std::shared_ptr<const SectionMesh> &mesh,
    const std::vector<SectionPoint>          &points,
    const std::vector<double>                &weights,
    const PlyLaws                            &laws,
    const std::vector<unsigned int>          &ply_of_cell,
    const unsigned int                        n_fields)
    : modes(mesh, mode_degree)
    , means(2 * (modes.n_functions() - 3))
  {
    const unsigned int n = means.size();
    find_means(points, weights);
    LAPACKFullMatrix<double> K(n);
    of_in_plane.reinit(n, n_fields);
    of_along.reinit(n, n_fields);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const SectionPoint &point = points[k];
        const ElasticTensor C =
          laws.at(ply_of_cell[point.cell], point.position).stiffness();
        add_energies(point, weights[k], C, K);
      }
    // Modes across a thin section are stiffer than those along it by orders of
    // magnitude, to which Cholesky's factorization is indifferent.
    K.set_property(LAPACKSupport::symmetric);
    K.compute_cholesky_factorization();
    K.solve(of_in_plane);
    K.solve(of_along);
  }



  void
  ContractionModes::find_means(const std::vector<SectionPoint> &points,
                               const std::vector<double>       &weights)
  {
    const unsigned int n = means.size();
    std::vector<Voigt> sums(n);
    double             area = 0.;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const auto strain = mode_strains(points[k].cell, points[k].unit);
        area += weights[k];
        for (unsigned int m = 0; m < n; ++m)
          sums[m] += weights[k] * strain[m];
      }
    for (unsigned int m = 0; m < n; ++m)
      means[m] = sums[m] / area;
  }



  void
  ContractionModes::add_energies(const SectionPoint       &point,
                                 const double              weight,
                                 const ElasticTensor      &C,
                                 LAPACKFullMatrix<double> &K)
  {
    const std::vector<Voigt> strain = mode_strains(point.cell, point.unit);
    for (unsigned int m = 0; m < strain.size(); ++m)
      {
        const Voigt stress = weight * (C * strain[m]);
        for (unsigned int l = 0; l < strain.size(); ++l)
          K(m, l) += stress * strain[l];
        for (unsigned int a = 0; a < point.fields->size(); ++a)
          {
            const unsigned int alpha = (*point.fields)[a];
            of_in_plane(m, alpha) -= stress * point.in_plane[a];
            of_along(m, alpha) -= stress * point.along[a];
          }
      }
  }



  std::vector<Voigt>
  ContractionModes::mode_strains(const unsigned int cell,
                                 const Point<2>    &unit) const
  {
    const FunctionValues f = modes.evaluate(cell, unit);
    std::vector<Voigt>   strains;
    for (unsigned int tau = 3; tau < modes.n_functions(); ++tau)
      {
        Voigt of_x, of_z;
        of_x[0] = f.gradients[tau][0];
        of_x[4] = f.gradients[tau][1];
        of_z[2] = f.gradients[tau][1];
        of_z[4] = f.gradients[tau][0];
        strains.push_back(of_x);
        strains.push_back(of_z);
      }
    for (unsigned int m = 0; m < strains.size(); ++m)
      strains[m] -= means[m];
    return strains;
  }



  void
  ContractionModes::complete(SectionPoint &point) const
  {
    const std::vector<Voigt> strain = mode_strains(point.cell, point.unit);
    for (unsigned int a = 0; a < point.fields->size(); ++a)
      for (unsigned int m = 0; m < strain.size(); ++m)
        {
          const unsigned int alpha = (*point.fields)[a];
          point.in_plane[a] += of_in_plane(m, alpha) * strain[m];
          point.along[a] += of_along(m, alpha) * strain[m];
        }
  }
} // namespace lamella
