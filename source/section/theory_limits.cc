// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/theory_limits.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  using namespace dealii;

  ElasticTensor
  compliance(const Ply &ply)
  {
    const ElasticTensor C = ply.stiffness();
    FullMatrix<double>  inverse(6);
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        inverse(i, j) = C[i][j];
    inverse.gauss_jordan();
    ElasticTensor result;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        result[i][j] = inverse(i, j);
    return result;
  }



  namespace
  {
    /// A ply along the beam: moduli per width.
    struct Layer
    {
      double bottom, top, E, G;
    };



    /// E and G_yz times the width, from the compliance of each ply.
    std::vector<Layer>
    layers_of(const std::vector<Ply> &plies, const double width)
    {
      std::vector<Layer> layers;
      for (const Ply &ply : plies)
        {
          const ElasticTensor S = compliance(ply);
          layers.push_back(
            {ply.bottom, ply.top, width / S[1][1], width / S[5][5]});
        }
      return layers;
    }



    /// The integral of @p f(layer, z) over the thickness.
    template <typename Function>
    double
    integral(const std::vector<Layer> &layers,
             const unsigned int        n_points,
             const Function           &f)
    {
      const QGauss<1> gauss(n_points);
      double          sum = 0.;
      for (const Layer &layer : layers)
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const double t = layer.top - layer.bottom;
            sum += gauss.weight(q) * t *
                   f(layer, layer.bottom + gauss.point(q)[0] * t);
          }
      return sum;
    }



    /// z_0 and E I.
    std::pair<double, double>
    bending(const std::vector<Layer> &layers)
    {
      const double EA =
        integral(layers, 1, [](const Layer &l, double) { return l.E; });
      const double z0 =
        integral(layers,
                 1,
                 [](const Layer &l, const double z) { return l.E * z; }) /
        EA;
      return {z0, integral(layers, 2, [z0](const Layer &l, const double z) {
                return l.E * (z - z0) * (z - z0);
              })};
    }



    /// Of a section's @p n fields the places among those whose section strain
    /// does not vanish, and how many these are. (The slopes are among them:
    /// they let the section turn about its shear center.)
    std::pair<std::vector<unsigned int>, unsigned int>
    fields_with_strain(const unsigned int n)
    {
      std::vector<unsigned int> place(n, numbers::invalid_unsigned_int);
      unsigned int              n_free = 0;
      for (unsigned int a = 0; a < n; ++a)
        if (a > RigidField::translation_z && a != RigidField::rotation_y)
          place[a] = n_free++;
      return {place, n_free};
    }
  } // namespace



  double
  shear_stiffness(const std::vector<Ply> &plies, const double width)
  {
    const std::vector<Layer> layers = layers_of(plies, width);
    const auto [z0, EI]             = bending(layers);
    // S at the bottom of the layer that is integrated.
    double       below = 0., flexibility = 0.;
    const double reference = z0;
    for (const Layer &layer : layers)
      {
        const auto S = [&](const double z) {
          return below +
                 0.5 * layer.E *
                   ((z - reference) * (z - reference) -
                    (layer.bottom - reference) * (layer.bottom - reference));
        };
        flexibility +=
          integral({layer}, 3, [&](const Layer &l, const double z) {
            return S(z) * S(z) / l.G;
          });
        below = S(layer.top);
      }
    return EI * EI / flexibility;
  }



  double
  shear_stiffness(const std::vector<Ply> &plies,
                  const double            width,
                  const unsigned int      N)
  {
    // w = sum_i a_i P_i minimizes 1/2 int G w'^2 - int E (z - z_0) w V / (E I):
    // 1 / (k G A) = b . A^-1 b.
    const std::vector<Layer> layers = layers_of(plies, width);
    const auto [z0, EI]             = bending(layers);
    const double bottom             = plies.front().bottom,
                 height             = plies.back().top - bottom;
    std::vector<Polynomials::Polynomial<double>> basis, slope;
    for (unsigned int i = 1; i <= N; ++i)
      {
        basis.push_back(Polynomials::Legendre(i));
        slope.push_back(basis.back().derivative());
      }
    FullMatrix<double>  A(N, N);
    std::vector<double> b(N);
    for (unsigned int i = 0; i < N; ++i)
      {
        const double center = z0, bending_stiffness = EI;
        b[i] = integral(layers, N + 2, [&](const Layer &l, const double z) {
          return l.E * (z - center) * basis[i].value((z - bottom) / height) /
                 bending_stiffness;
        });
        for (unsigned int j = 0; j < N; ++j)
          A(i, j) =
            integral(layers, N + 2, [&](const Layer &l, const double z) {
              const double t = (z - bottom) / height;
              return l.G * slope[i].value(t) * slope[j].value(t) /
                     (height * height);
            });
      }
    A.gauss_jordan();
    double flexibility = 0.;
    for (unsigned int i = 0; i < N; ++i)
      for (unsigned int j = 0; j < N; ++j)
        flexibility += b[i] * A(i, j) * b[j];
    return 1. / flexibility;
  }



  std::optional<double>
  torsional_stiffness(const Section &section)
  {
    constexpr unsigned int max_fields_share = 2500;

    const unsigned int n = section.n_fields();
    if (section.theory().is_classical() || n > max_fields_share)
      return {};
    // S_00 w = -S_01 r_y without the fields whose section strain vanishes.
    const double           h   = section.element().reference_length();
    constexpr unsigned int r_y = RigidField::rotation_y;
    const auto [place, n_free] = fields_with_strain(n);
    LAPACKFullMatrix<double> K(n_free, n_free);
    Vector                   w(n_free);
    for (unsigned int a = 0; a < n; ++a)
      if (place[a] != numbers::invalid_unsigned_int)
        {
          for (auto entry = section.S(0, 0).begin(a);
               entry != section.S(0, 0).end(a);
               ++entry)
            if (place[entry->column()] != numbers::invalid_unsigned_int)
              K(place[a], place[entry->column()]) = entry->value();
          w[place[a]] = section.S(0, 1).el(a, r_y);
        }
    const Vector load = w;
    K.set_property(LAPACKSupport::symmetric);
    try
      {
        K.compute_cholesky_factorization();
      }
    catch (const ExceptionBase &)
      {
        // Cells 10,000 times as long as thick leave no digits of it.
        return {};
      }
    K.solve(w);
    return (section.S(1, 1).el(r_y, r_y) - w * load) * h * h;
  }



  std::optional<double>
  torsional_stiffness(const SectionMesh &mesh)
  {
    constexpr unsigned int most_cells = 150;

    if (mesh.mesh.n_active_cells() > most_cells)
      return {};
    // The mesh outlives the section that is made of it here.
    const std::shared_ptr<const SectionMesh> lent(&mesh,
                                                  [](const SectionMesh *) {});
    return torsional_stiffness(
      *make_section(lent, Theory::parse({"Theory", "LE-2"})));
  }
} // namespace lamella
