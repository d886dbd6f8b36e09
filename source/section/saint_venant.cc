// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/factorization.h>
#include <lamella/section/saint_venant.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int t_x = RigidField::translation_x,
                           t_y = RigidField::translation_y,
                           t_z = RigidField::translation_z,
                           s_x = RigidField::slope_x, s_z = RigidField::slope_z,
                           r_y = RigidField::rotation_y;

    /// What S_00 knows nothing of.
    constexpr std::array<unsigned int, 4> held{{t_x, t_y, t_z, r_y}};

    enum State : unsigned int
    {
      extension,
      torsion,
      curvature_x,
      curvature_z,
      shear_x,
      shear_z
    };



    /// S_00 with the held fields' rows and columns those of the unit matrix,
    /// times a number of the size of the others.
    Matrix
    with_fixed_fields(const Matrix &S_00)
    {
      Matrix K(S_00.get_sparsity_pattern());
      K.copy_from(S_00);
      double largest = 0.;
      for (unsigned int i = 0; i < K.m(); ++i)
        largest = std::max(largest, K.diag_element(i));
      const auto is_held = [](const unsigned int i) {
        return std::find(held.begin(), held.end(), i) != held.end();
      };
      for (unsigned int i = 0; i < K.m(); ++i)
        for (auto entry = K.begin(i); entry != K.end(i); ++entry)
          if (is_held(i) || is_held(entry->column()))
            entry->value() = entry->column() == i ? largest : 0.;
      return K;
    }



    /// S_pq v.
    Vector
    times(const Matrix &S, const Vector &v)
    {
      Vector product(v.size());
      S.vmult(product, v);
      return product;
    }



    /// The section forces of the state (@p a, @p b), in the order of Force.
    Tensor<1, 6>
    resultants(const Section &section, const Vector &a, const Vector &b)
    {
      Vector g = times(section.S(1, 0), a);
      g += times(section.S(1, 1), b);
      const double h = section.element().reference_length();
      Tensor<1, 6> forces;
      forces[SaintVenant::F_x] = g[t_x];
      forces[SaintVenant::F_y] = g[t_y];
      forces[SaintVenant::F_z] = g[t_z];
      forces[SaintVenant::M_x] = -h * g[s_z];
      forces[SaintVenant::M_y] = h * g[r_y];
      forces[SaintVenant::M_z] = h * g[s_x];
      return forces;
    }
  } // namespace



  SaintVenant::SaintVenant(const Section &section)
    : section(section)
  {
    Assert(section.n_fields() > r_y, ExcMessage("There is no torsion field."));
    solver = factorize(with_fixed_fields(section.S(0, 0)), "the section");
    find_states();
    find_compliance();
  }



  Vector
  SaintVenant::right_hand_side(const Vector &v, const Vector &w) const
  {
    Vector a = times(section.S(1, 0), v);
    a -= times(section.S(0, 1), v);
    a += times(section.S(1, 1), w);
    return a;
  }



  Vector
  SaintVenant::constrained_response(Vector load) const
  {
    for (const unsigned int field : held)
      load[field] = 0.;
    solver->solve(load);
    return load;
  }



  Vector
  SaintVenant::solve(const Vector &v, const Vector &w) const
  {
    return constrained_response(right_hand_side(v, w));
  }



  Vector
  SaintVenant::response_to_constant(const Vector &load) const
  {
    constexpr std::array<unsigned int, 4> balancing{
      {extension, torsion, shear_x, shear_z}};
    FullMatrix<double>  of_states(held.size());
    std::vector<Vector> tractions;
    for (unsigned int j = 0; j < balancing.size(); ++j)
      {
        tractions.push_back(
          right_hand_side(value[balancing[j]], derivative[balancing[j]]));
        for (unsigned int i = 0; i < held.size(); ++i)
          of_states(i, j) = tractions[j][held[i]];
      }
    of_states.gauss_jordan();
    dealii::Vector<double> resultants(held.size()), share(held.size());
    for (unsigned int i = 0; i < held.size(); ++i)
      resultants[i] = load[held[i]];
    of_states.vmult(share, resultants);
    Vector v = load;
    for (unsigned int j = 0; j < balancing.size(); ++j)
      v.add(-share[j], tractions[j]);
    return constrained_response(std::move(v));
  }



  void
  SaintVenant::find_states()
  {
    const unsigned int n = section.n_fields();
    const double       h = section.element().reference_length();
    const auto unit = [n](const unsigned int field, const double size = 1.) {
      Vector v(n);
      v[field] = size;
      return v;
    };
    derivative = {unit(t_y), unit(r_y), unit(s_x, -h), unit(s_z, -h)};
    const Vector nothing(n);
    value = {solve(derivative[extension], nothing),
             solve(derivative[torsion], nothing),
             solve(derivative[curvature_x], unit(t_x)),
             solve(derivative[curvature_z], unit(t_z))};
    find_shear_states();
  }



  void
  SaintVenant::find_shear_states()
  {
    // As much of extension and torsion as frees a curvature of F_y and M_y.
    std::array<Tensor<1, 6>, 4> forces;
    for (unsigned int k = 0; k < 4; ++k)
      forces[k] = resultants(section, value[k], derivative[k]);
    Tensor<2, 2> of_both;
    for (unsigned int k : {extension, torsion})
      {
        of_both[0][k] = forces[k][F_y];
        of_both[1][k] = forces[k][M_y];
      }
    const Tensor<2, 2> inverse = invert(of_both);
    for (const unsigned int k : {curvature_x, curvature_z})
      {
        const Tensor<1, 2> share =
          -1. * (inverse * Tensor<1, 2>({forces[k][F_y], forces[k][M_y]}));
        Vector a = value[k], b = derivative[k];
        for (unsigned int m : {extension, torsion})
          {
            a.add(share[m], value[m]);
            b.add(share[m], derivative[m]);
          }
        value.push_back(solve(a, b));
        derivative.push_back(a);
      }
  }



  void
  SaintVenant::find_resultants(FullMatrix<double> &forces,
                               FullMatrix<double> &energies) const
  {
    for (unsigned int k = 0; k < 6; ++k)
      {
        const Tensor<1, 6> f = resultants(section, value[k], derivative[k]);
        for (unsigned int i = 0; i < 6; ++i)
          forces(i, k) = f[i];
        Vector on_a = times(section.S(0, 0), value[k]);
        on_a += times(section.S(0, 1), derivative[k]);
        Vector on_b = times(section.S(1, 0), value[k]);
        on_b += times(section.S(1, 1), derivative[k]);
        for (unsigned int l = 0; l < 6; ++l)
          energies(l, k) = value[l] * on_a + derivative[l] * on_b;
      }
  }



  void
  SaintVenant::find_compliance()
  {
    FullMatrix<double> forces(6, 6), energies(6, 6);
    find_resultants(forces, energies);
    // Forces of one state differ by powers of the length: scaled, or the
    // inverse loses digits where the units are far from the section's size.
    std::array<double, 6> scale;
    for (unsigned int k = 0; k < 6; ++k)
      {
        scale[k] = 1. / std::sqrt(energies(k, k));
        for (unsigned int i = 0; i < 6; ++i)
          forces(i, k) *= scale[k];
      }
    for (unsigned int k = 0; k < 6; ++k)
      for (unsigned int l = 0; l < 6; ++l)
        energies(k, l) *= scale[k] * scale[l];
    FullMatrix<double> inverse(6), product(6), compliance(6), stiffness(6);
    inverse.invert(forces);
    energies.mmult(product, inverse);
    inverse.Tmmult(compliance, product);
    compliance.symmetrize();
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        section_compliance[i][j] = compliance(i, j);
    // F Q^-1 F^T, with Q scaled to a unit diagonal.
    FullMatrix<double> of_energies(6);
    of_energies.invert(energies);
    of_energies.mTmult(product, forces);
    forces.mmult(stiffness, product);
    stiffness.symmetrize();
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        section_stiffness[i][j] = stiffness(i, j);
  }



  FieldColumns
  saint_venant_warpings(const SaintVenant &states, const Warping &warping)
  {
    // Of the energies of a state: a section that does not contract (nu = 0) has
    // no warping in extension, and two states may warp alike.
    constexpr double          rounding = 1e-20, alike = 1e-7;
    const Section            &section = states.of_section();
    FieldColumns              fields(section.n_fields(), 6), energies(fields);
    std::vector<unsigned int> warping_ones;
    for (unsigned int k = 0; k < states.values().size(); ++k)
      {
        Vector field = states.values()[k];
        warping.remove_rigid(field);
        const Vector  energy = times(section.S(0, 0), field);
        const double  norm2  = field * energy;
        const Vector &b      = states.derivatives()[k];
        if (!(norm2 > rounding * (b * times(section.S(1, 1), b))))
          continue;
        for (unsigned int i = 0; i < field.size(); ++i)
          {
            fields(i, k)   = field[i] / std::sqrt(norm2);
            energies(i, k) = energy[i] / std::sqrt(norm2);
          }
        warping_ones.push_back(k);
      }
    if (warping_ones.empty())
      return FieldColumns(section.n_fields(), 0);
    fields   = selected_columns(fields, warping_ones);
    energies = selected_columns(energies, warping_ones);
    return orthonormal(fields, energies, alike);
  }



  SectionConstants
  section_constants(const SectionTensor &c, const Point<2> &center)
  {
    using Force                = SaintVenant::Force;
    constexpr unsigned int F_x = Force::F_x, F_y = Force::F_y, F_z = Force::F_z,
                           M_x = Force::M_x, M_y = Force::M_y, M_z = Force::M_z;
    SectionConstants result;
    result.GJ = 1. / c[M_y][M_y];

    // Bending flexibilities: the smaller eigenvalue is the larger stiffness.
    const double mean = 0.5 * (c[M_x][M_x] + c[M_z][M_z]),
                 half = 0.5 * (c[M_x][M_x] - c[M_z][M_z]), mixed = c[M_x][M_z],
                 radius = std::hypot(half, mixed);
    result.EI           = {{1. / (mean - radius), 1. / (mean + radius)}};
    if (radius > arithmetic::negligible * mean)
      result.angle = 0.5 * std::atan2(-mixed, -half) * 180. / numbers::PI;

    // A force at (x, z) has M_x = -z F_y, M_z = x F_y, M_y = z F_x - x F_z.
    Tensor<2, 2> bending;
    bending[0][0] = -c[M_x][M_x];
    bending[0][1] = c[M_x][M_z];
    bending[1][0] = -c[M_z][M_x];
    bending[1][1] = c[M_z][M_z];
    const Tensor<1, 2> tension =
      invert(bending) * Tensor<1, 2>({-c[M_x][F_y], -c[M_z][F_y]});
    result.tension_center = center + Tensor<1, 2>({tension[1], tension[0]});
    result.EA =
      1. / (c[F_y][F_y] - tension[0] * c[M_x][F_y] + tension[1] * c[M_z][F_y]);
    const double x = c[M_y][F_z] / c[M_y][M_y], z = -c[M_y][F_x] / c[M_y][M_y];
    result.shear_center = center + Tensor<1, 2>({x, z});
    result.kGA_x        = 1. / (c[F_x][F_x] + z * c[M_y][F_x]);
    result.kGA_z        = 1. / (c[F_z][F_z] - x * c[M_y][F_z]);
    return result;
  }



  Voigt
  stretch_of_fiber(const Section &section, const SectionPoint &point)
  {
    const double square =
      point.position.distance_square(section.element().center());
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      if ((*point.fields)[k] == RigidField::translation_y)
        return square * point.along[k];
    return Voigt();
  }



  TwistStretch::TwistStretch(const SaintVenant &states)
    : section(states.of_section())
    , relaxation(section.n_fields())
    , on_derivatives(section.n_fields(), 0.)
  {
    Vector on_values(section.n_fields());
    section.for_each_point([&](const SectionPoint &point, const double weight) {
      const Voigt fiber = stretch_of_fiber(section, point);
      const Voigt stress =
        weight * section.law(point.cell, point.position).stress(fiber);
      square += fiber * stress;
      for (unsigned int k = 0; k < point.fields->size(); ++k)
        {
          const unsigned int alpha = (*point.fields)[k];
          on_values[alpha] -= point.in_plane[k] * stress;
          on_derivatives[alpha] += point.along[k] * stress;
        }
    });
    relaxation = states.constrained_response(on_values);
    square -= on_values * relaxation;
    Vector of_relaxation(section.n_fields());
    section.S(1, 0).vmult(of_relaxation, relaxation);
    for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
      on_derivatives[alpha] += of_relaxation[alpha];

    c = stiffening_of(states);
  }



  double
  TwistStretch::stiffening_of(const SaintVenant &states) const
  {
    using Force              = SaintVenant::Force;
    constexpr Force shears[] = {Force::F_x, Force::F_z},
                    axial[]  = {Force::F_y, Force::M_x, Force::M_z};
    const SectionTensor &C = states.compliance(), &D = states.stiffness();
    const double         h = section.element().reference_length();
    // The shears that go with a twist of 1 about the torsion center, and what
    // these make of the stretch and the curvatures, of k^2 / 2.
    const double G_x = C[shears[0]][Force::M_y] / C[Force::M_y][Force::M_y],
                 G_z = C[shears[1]][Force::M_y] / C[Force::M_y][Force::M_y];
    const std::array<double, 3> q{
      {G_x * G_x + G_z * G_z, -2. * G_x, -2. * G_z}};
    // The work of r^2 on each of these.
    const std::array<double, 3> work{{on_derivatives[RigidField::translation_y],
                                      -h * on_derivatives[RigidField::slope_z],
                                      h * on_derivatives[RigidField::slope_x]}};
    double                      energy = square, on_axis = work[0];
    for (unsigned int i = 0; i < 3; ++i)
      {
        energy += 2. * q[i] * work[i];
        on_axis += D[Force::F_y][axial[i]] * q[i];
        for (unsigned int j = 0; j < 3; ++j)
          energy += q[i] * D[axial[i]][axial[j]] * q[j];
      }
    return (energy - on_axis * on_axis / D[Force::F_y][Force::F_y]) / 2. *
           C[Force::M_y][Force::M_y];
  }



  Voigt
  TwistStretch::strain(const SectionPoint &point) const
  {
    Voigt sum = stretch_of_fiber(section, point);
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      sum += relaxation[(*point.fields)[k]] * point.in_plane[k];
    return sum;
  }
} // namespace lamella
