// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/finite_strain.h>
#include <lamella/section/shape_change.h>

#include <deal.II/lac/full_matrix.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// @p factor (A_i . B_j + A_j . B_i) in Voigt's order, shears doubled.
    Voigt
    product(const Gradient &A, const Gradient &B, const double factor)
    {
      constexpr std::array<std::array<unsigned int, 2>, 6> pairs{
        {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};
      Voigt strain;
      for (unsigned int k = 0; k < 6; ++k)
        {
          const auto &[i, j] = pairs[k];
          strain[k] =
            factor * (i == j ? A[i] * B[i] : A[i] * B[j] + A[j] * B[i]);
        }
      return strain;
    }



    /// A Saint-Venant state of curvature 1; its warping has no rigid motion.
    class ShapeState
    {
    public:
      ShapeState(const Section      &section,
                 const Vector       &value,
                 const Vector       &derivative,
                 const Tensor<1, 3> &curvature)
        : work(section.n_fields())
        , section(section)
        , a(value)
        , b(derivative)
        , curvature(curvature)
      {
        remove_rigid_parts();
        section.for_each_point(
          [&](const SectionPoint &point, const double weight) {
            add(point, weight);
          });
      }

      /// int e_2 . C e_2 and int e_1 . C e_1.
      double second = 0., first = 0.;
      /// The work on each field, and on a stretch of the axis.
      Vector work;
      double work_of_stretch = 0.;

    private:
      struct Kinematics
      {
        Gradient     H;
        Tensor<1, 3> warped;
        Voigt        strain;
      };
      Kinematics
      at(const SectionPoint &point) const
      {
        Kinematics result;
        for (unsigned int k = 0; k < point.fields->size(); ++k)
          {
            const unsigned int alpha = (*point.fields)[k];
            const auto         d     = field_derivatives(point, k);
            result.H[0] += a[alpha] * d[0];
            result.H[1] += b[alpha] * point.value[k];
            result.H[2] += a[alpha] * d[1];
            result.warped += a[alpha] * point.value[k];
            result.strain +=
              a[alpha] * point.in_plane[k] + b[alpha] * point.along[k];
          }
        const Tensor<1, 3> X = arm(point);
        result.warped -=
          mean + Tensor<1, 3>({rotation * X[2], tilt * X, -rotation * X[0]});
        result.H[0][2] += rotation;
        result.H[2][0] -= rotation;
        // A tilt of the section is a shear of the axis.
        for (const unsigned int c : {0, 2})
          {
            result.H[c][1] -= tilt[c];
            result.H[1][c] += tilt[c];
          }
        return result;
      }

      /// From the center of the section to @p point.
      Tensor<1, 3>
      arm(const SectionPoint &point) const
      {
        const double h = section.element().reference_length();
        Tensor<1, 3> X;
        for (unsigned int k = 0; k < point.fields->size(); ++k)
          {
            if ((*point.fields)[k] == RigidField::slope_x)
              X[0] = h * point.value[k][1];
            if ((*point.fields)[k] == RigidField::slope_z)
              X[2] = h * point.value[k][1];
          }
        return X;
      }

      void
      remove_rigid_parts()
      {
        double       area = 0., polar = 0., moment = 0.;
        Tensor<1, 3> of_warping, sum;
        // Second moments of the section, a unit along y.
        Tensor<2, 3> second_moments;
        second_moments[1][1] = 1.;
        section.for_each_point(
          [&](const SectionPoint &point, const double weight) {
            const Tensor<1, 3> X = arm(point), u = at(point).warped;
            area += weight;
            sum += weight * u;
            polar += weight * X.norm_square();
            moment += weight * (u[0] * X[2] - u[2] * X[0]);
            of_warping += weight * u[1] * X;
            second_moments += weight * outer_product(X, X);
          });
        mean     = sum / area;
        rotation = moment / polar;
        tilt     = invert(second_moments) * of_warping;
      }

      void
      add(const SectionPoint &point, const double weight)
      {
        const Kinematics   here   = at(point);
        const ElasticLaw   law    = section.law(point.cell, point.position);
        const Voigt        stress = law.stress(here.strain);
        const Tensor<1, 3> bent   = cross_product_3d(curvature, here.warped);
        // Nonlinear part of Green's strain, curvature of the warping, and both.
        const Voigt quadratic =
          product(here.H, here.H, 0.5) + axial_strain(bent);
        Gradient of_bent;
        of_bent[1]            = bent;
        const Voigt cubic     = product(here.H, of_bent, 1.);
        const Voigt of_second = law.stress(quadratic);
        first += weight * (here.strain * stress);
        second += weight * (quadratic * of_second + 2. * (stress * cubic));
        const Tensor<2, 3> S  = first_stress(Gradient(), stress);
        const Tensor<2, 3> SH = S * here.H;
        for (unsigned int k = 0; k < point.fields->size(); ++k)
          {
            const unsigned int alpha = (*point.fields)[k];
            const auto         d     = field_derivatives(point, k);
            const Tensor<1, 3> turned =
              cross_product_3d(curvature, point.value[k]);
            work[alpha] +=
              weight * (of_second * point.in_plane[k] + SH[0] * d[0] +
                        SH[2] * d[1] + stress * axial_strain(turned));
            if (alpha == RigidField::translation_y)
              work_of_stretch +=
                weight * (of_second * point.along[k] + SH[1] * point.value[k]);
          }
      }

      const Section     &section;
      Vector             a, b;
      const Tensor<1, 3> curvature;
      /// The rigid motions in the warping, removed from it: turn about y, the
      /// slopes of u_y [rad], and the means of its displacement.
      double       rotation = 0.;
      Tensor<1, 3> tilt, mean;
    };
  } // namespace



  std::array<double, 3>
  stiffening_by_shape(const SaintVenant &states)
  {
    const Section &section = states.of_section();
    const double   h       = section.element().reference_length();
    // Numbers of the states, and the curvature that each has.
    constexpr unsigned int            extension = 0;
    const std::array<unsigned int, 3> number{{3, 1, 2}};
    const std::array<double, 3>       size{{1., 1. / h, -1.}};
    std::array<double, 3>             result;
    for (unsigned int c = 0; c < 3; ++c)
      {
        Tensor<1, 3> curvature;
        curvature[c] = size[c];
        const ShapeState state(section,
                               states.values()[number[c]],
                               states.derivatives()[number[c]],
                               curvature);
        // The relaxation in the section, and that of the axis with what the
        // section does then (the state of extension).
        const Vector  v         = states.constrained_response(state.work);
        double        saved     = state.work * v;
        const Vector &stretched = states.values()[extension];
        const Vector &stretch   = states.derivatives()[extension];
        Vector        on_stretch(stretch.size()), on_value(stretch.size());
        section.S(1, 0).vmult(on_stretch, stretched);
        section.S(1, 1).vmult_add(on_stretch, stretch);
        const double axial_stiffness = stretch * on_stretch;
        const double on_axis = state.work_of_stretch + state.work * stretched;
        saved += on_axis * on_axis / axial_stiffness;
        result[c] =
          2. * (state.second - saved) / state.first / curvature.norm_square();
      }
    return result;
  }
} // namespace lamella
