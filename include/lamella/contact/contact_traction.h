// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_traction_h
#define lamella_contact_contact_traction_h

#include <lamella/contact/slave_surface.h>

#include <deal.II/base/array_view.h>

#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  struct ContactInterface;

  /// Contact traction in one state: the pressure
  ///   p(x) = sum_i lambda_i / A_i phi_i(x)
  /// with the contact forces lambda_i, their functions phi_i on the slave
  /// surface (SlaveSurface) and the tributary areas A_i = int phi_i dA. Hence
  /// int p dA = sum lambda_i, and, with normals n_i, the force on the second
  /// side,
  ///   sum_i lambda_i / A_i n_i int phi_i dA = sum lambda_i n_i,
  /// is the resultant of the contact forces to rounding, for all surfaces and
  /// meshes. With friction, the shear forces lambda_t,i on the second side give
  /// the shear traction q(x) in the same way.
  ///
  /// For nodal contact, the moment of p n_i differs from that of the nodal
  /// forces by O(h^2); the difference is added as a distributed couple. Contact
  /// points without a facet have point forces.
  class ContactTraction
  {
  public:
    /// A contact point with its forces in the state.
    struct Row
    {
      /// Undeformed position in the scene (place_of()).
      dealii::Point<3> place;
      /// Normal n_i, outward from the first side.
      dealii::Tensor<1, 3> normal;
      /// Tributary area [length^2], and normal force lambda_i >= 0 [force].
      double area = 0., force = 0.;
      /// Moment of the force on the second side about the scene origin.
      dealii::Tensor<1, 3> moment;
      /// Shear force on the second side, and energy dissipated by friction.
      dealii::Tensor<1, 3> shear      = {};
      double               dissipated = 0.;
    };

    /// Creates the traction of the contact points @p rows on @p surface, or of
    /// point forces if @p surface is null.
    ContactTraction(std::shared_ptr<const SlaveSurface> surface,
                    std::vector<Row>                    rows);

    /// Creates the traction of @p contact with the normal @p forces and, with
    /// friction, the shear forces @p shears. Moments use the contact points.
    ContactTraction(
      const ContactInterface                              &contact,
      const dealii::ArrayView<const double>               &forces,
      const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// Pressure p and shear traction q at a point [force/length^2].
    struct Value
    {
      double               pressure = 0.;
      dealii::Tensor<1, 3> shear    = {};
    };

    /// Returns the traction at the point @p place of the surface.
    Value
    at(const SlaveSurface::Place &place) const;

    /// Returns the traction at the point where the line from @p x along the
    /// unit vector @p n meets the surface within @p search_radius, or 0.
    Value
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &n,
            const double                search_radius) const;

    /// Contact force on the second side, and its moment about the scene origin.
    struct Resultant
    {
      dealii::Tensor<1, 3> force, moment;
    };

    /// Returns the resultant of the traction over the contact or @p strip.
    Resultant
    resultant(const std::optional<ContactStrip> &strip = {}) const;

    /// Returns for each contact point the fraction int_strip phi_i dA / A_i in
    /// @p strip, or 1 without a strip. A point force has 1 or 0.
    std::vector<double>
    shares(const std::optional<ContactStrip> &strip) const;

    /// Returns the energy dissipated in the contact or in a strip of it.
    double
    dissipated(const std::optional<ContactStrip> &strip = {}) const;

    /// Returns the largest pressure lambda_i / A_i of a contact point.
    double
    largest_pressure() const;

    const std::vector<Row> &
    rows() const
    {
      return all;
    }

    /// Returns the slave surface; null if unknown.
    const std::shared_ptr<const SlaveSurface> &
    surface() const
    {
      return traction_surface;
    }

  private:
    /// Returns for each contact point the fraction of its function phi_i that
    /// lies in @p strip (shares()), and that fraction times the vector from the
    /// centroid of phi_i to the centroid of its part in the strip.
    std::vector<SlaveSurface::Integrals>
    inside(const ContactStrip &strip) const;
    /// Returns true if contact point @p k is on no facet.
    bool
    is_point(const unsigned int k) const
    {
      return traction_surface == nullptr ||
             traction_surface->integrals()[k].area == 0.;
    }

    std::shared_ptr<const SlaveSurface> traction_surface;
    std::vector<Row>                    all;
  };
} // namespace lamella

#endif
