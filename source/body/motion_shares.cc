// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/body/fields.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/std_cxx17/cmath.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Points of a cross-section with masses, positions and velocities in axes
    /// of the body, v[m] those of motion m.
    struct SectionMotion
    {
      std::vector<double>                    mass;
      std::vector<Point<3>>                  x;
      std::vector<std::vector<Tensor<1, 3>>> v;

      /// Adds the velocities at a point of @p body with the functionals @p row
      /// and the @p rotation, for the DoFs @p motions.
      template <typename Row>
      void
      add_velocities(const Body                        &body,
                     const Row                         &row,
                     const Tensor<2, 3>                &rotation,
                     const std::vector<const Vector *> &motions)
      {
        v.resize(motions.size());
        for (unsigned int m = 0; m < v.size(); ++m)
          {
            Tensor<1, 3> velocity;
            for (unsigned int c = 0; c < 3; ++c)
              velocity[c] = row[c](*motions[m]);
            v[m].push_back(
              body.place().vector_to_body(transpose(rotation) * velocity));
          }
      }
    };



    /// Returns the determinant of the map to @p body from the unit cube of the
    /// element of @p place, by differences, which are exact up to curvature.
    double
    volume_factor(const Body &body, const Location::Place &place)
    {
      constexpr double h = 0.1;
      Tensor<2, 3>     jacobian;
      for (unsigned int d = 0; d < 3; ++d)
        {
          Location::Place from = place, to = place;
          from.unit[d] -= h;
          to.unit[d] += h;
          const Tensor<1, 3> difference =
            body.position(to) - body.position(from);
          for (unsigned int c = 0; c < 3; ++c)
            jacobian[c][d] = difference[c] / (2. * h);
        }
      return std::abs(determinant(jacobian));
    }



    /// Returns the cross-sections of Gauss points of @p body, by their
    /// positions along the axis.
    std::map<long, SectionMotion>
    section_motions(const Body                        &body,
                    const std::vector<double>         &rho,
                    const Vector                      &u,
                    const std::vector<const Vector *> &v)
    {
      const QAnisotropic<3> gauss(QGauss<1>(2), QGauss<1>(8), QGauss<1>(2));
      const double same = arithmetic::quadrature_tolerance * body.size();
      std::map<long, SectionMotion> sections;
      for (unsigned int cell = 0; cell < body.cells().n; ++cell)
        {
          std::vector<Location> locations;
          for (const Point<3> &unit : gauss.get_points())
            {
              const Location::Place place{cell, unit};
              locations.push_back(
                {body.position(place), body.ply_at(place).ply, {place}});
            }
          const auto rows = body.rows(locations, u);
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              const Location &at      = locations[q];
              const Point<3>  x       = body.place().to_body(at.position);
              SectionMotion  &section = sections[std::lround(x[1] / same)];
              section.mass.push_back(gauss.weight(q) *
                                     (rho.empty() ? 1. : rho[at.ply]) *
                                     volume_factor(body, at.places[0]));
              section.x.push_back(x);
              section.add_velocities(body, rows[q], body.rotation_at(at, u), v);
            }
        }
      return sections;
    }



    /// Velocity omega x (x - center) + mean of a rigid cross-section.
    struct RigidVelocity
    {
      double       mass = 0.;
      Tensor<1, 3> center, mean, omega;
      Tensor<1, 3> angular_momentum;   ///< About the center.
      double       polar_inertia = 0.; ///< Trace of the moments of inertia.
    };



    /// Returns the rigid motion with the momenta of @p section in motion @p m.
    RigidVelocity
    rigid_velocity(const SectionMotion &section, const unsigned int m)
    {
      RigidVelocity rigid;
      for (unsigned int k = 0; k < section.mass.size(); ++k)
        {
          rigid.mass += section.mass[k];
          rigid.center += section.mass[k] * section.x[k];
          rigid.mean += section.mass[k] * section.v[m][k];
        }
      if (!(rigid.mass > 0.))
        return {};
      rigid.center /= rigid.mass;
      rigid.mean /= rigid.mass;
      SymmetricTensor<2, 3> inertia;
      for (unsigned int k = 0; k < section.mass.size(); ++k)
        {
          const Tensor<1, 3> r = section.x[k] - rigid.center;
          inertia +=
            section.mass[k] * (r.norm_square() * unit_symmetric_tensor<3>() -
                               symmetrize(outer_product(r, r)));
          rigid.angular_momentum +=
            section.mass[k] * cross_product_3d(r, section.v[m][k]);
        }
      rigid.polar_inertia = trace(inertia);
      // Points on a line do not determine the rotation.
      if (determinant(inertia) > 0.)
        rigid.omega = invert(inertia) * rigid.angular_momentum;
      return rigid;
    }



    /// Adds the energies of motion @p m of @p section to @p shares: the rigid
    /// motion with its momenta, and what remains.
    void
    add_energies(const SectionMotion &section,
                 const unsigned int   m,
                 const RigidVelocity &rigid,
                 MotionShares        &shares)
    {
      const auto add = [&](const Motion motion, const double energy) {
        shares[static_cast<unsigned int>(motion)] += std::max(0., energy);
      };
      const auto translation = [&](const unsigned int c) {
        return rigid.mass * rigid.mean[c] * rigid.mean[c];
      };
      const auto rotation = [&](const unsigned int c) {
        return rigid.omega[c] * rigid.angular_momentum[c];
      };
      add(Motion::bending_x, translation(2) + rotation(0));
      add(Motion::bending_z, translation(0) + rotation(2));
      add(Motion::axial, translation(1));
      add(Motion::torsion, rotation(1));
      for (unsigned int k = 0; k < section.mass.size(); ++k)
        {
          const Tensor<1, 3> rest =
            section.v[m][k] - rigid.mean -
            cross_product_3d(rigid.omega, section.x[k] - rigid.center);
          add(Motion::width, section.mass[k] * rest[0] * rest[0]);
          add(Motion::warping, section.mass[k] * rest[1] * rest[1]);
          add(Motion::thickness, section.mass[k] * rest[2] * rest[2]);
        }
    }



    /// Adds the momenta of a cross-section at @p s, from 0 to 1 along the body.
    void
    add_momenta(const RigidVelocity &rigid,
                const double         s,
                std::vector<double> &momenta)
    {
      constexpr unsigned int n_polynomials = 16;
      momenta.resize(6 * n_polynomials);
      const double radius = std::sqrt(rigid.polar_inertia / rigid.mass);
      for (unsigned int k = 0; k < n_polynomials; ++k)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double factor =
              std::sqrt(2. * k + 1.) * std_cxx17::legendre(k, 2. * s - 1.);
            momenta[6 * k + c] += factor * rigid.mass * rigid.mean[c];
            if (radius > 0.)
              momenta[6 * k + 3 + c] +=
                factor * rigid.angular_momentum[c] / radius;
          }
    }
  } // namespace



  std::vector<BodyMotion>
  motions_of(const Body                        &body,
             const std::vector<double>         &rho,
             const Vector                      &u,
             const std::vector<const Vector *> &v)
  {
    std::vector<BodyMotion> motions(v.size());
    const auto              sections = section_motions(body, rho, u, v);
    if (sections.empty())
      return motions;
    const double first  = sections.begin()->first,
                 length = std::max(1., sections.rbegin()->first - first);
    for (unsigned int m = 0; m < v.size(); ++m)
      {
        MotionShares &shares = motions[m].shares;
        for (const auto &[y, section] : sections)
          {
            const RigidVelocity rigid = rigid_velocity(section, m);
            add_energies(section, m, rigid, shares);
            if (rigid.mass > 0.)
              add_momenta(rigid, (y - first) / length, motions[m].momenta);
          }
        double sum = 0.;
        for (const double share : shares)
          sum += share;
        for (double &share : shares)
          share /= sum > 0. ? sum : 1.;
      }
    return motions;
  }
} // namespace lamella
