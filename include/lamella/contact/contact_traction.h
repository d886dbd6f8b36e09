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

  /// Contact traction in one equilibrium state: the pressure
  ///   p(x) = sum_i lambda_i / A_i phi_i(x)
  /// with the contact forces lambda_i, their functions phi_i on the slave
  /// surface (SlaveSurface) and the tributary areas A_i = int phi_i dA. Hence
  /// the force on the second side, with the normals n_i,
  ///   sum_i lambda_i / A_i n_i int phi_i dA = sum lambda_i n_i,
  /// is the resultant of the contact forces to rounding, for all surfaces and
  /// meshes. With friction, shear forces give a shear traction in the same way.
  ///
  /// For nodal contact, the moment of p n_i differs from that of the nodal
  /// forces by O(h^2) (element size h). The difference is added as a
  /// distributed couple. Contact points off the slave surface have point
  /// forces.
  class ContactTraction
  {
  public:
    /// A contact point with its forces in the equilibrium state.
    struct Row
    {
      /// Undeformed position of the contact point, scene axes.
      dealii::Point<3> place;
      /// Unit normal, outward from the first side.
      dealii::Tensor<1, 3> normal;
      double               area = 0., ///< Tributary area [length^2].
        force = 0.; ///< Normal force, positive in compression.
      /// Moment of the force on the second side about the scene origin.
      dealii::Tensor<1, 3> moment;
      dealii::Tensor<1, 3> shear      = {}; ///< Shear force on the second side.
      double               dissipated = 0.; ///< Energy dissipated by friction.
    };

    /// Energy dissipated at a material point that has no constraint any more.
    struct Dissipation
    {
      dealii::Point<3> place;       ///< Undeformed position, scene axes.
      double           energy = 0.; ///< Energy dissipated by friction.
    };

    /// Creates the traction of the contact points @p rows on the slave surface
    /// @p surface, or point forces if @p surface is null. @p left are points
    /// without a constraint that have dissipated energy.
    ContactTraction(std::shared_ptr<const SlaveSurface> surface,
                    std::vector<Row>                    rows,
                    std::vector<Dissipation>            left = {});

    /// Creates the traction of @p contact with the normal @p forces and, with
    /// friction, the shear forces @p shears, one for each gap constraint.
    ContactTraction(
      const ContactInterface                              &contact,
      const dealii::ArrayView<const double>               &forces,
      const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// Contact traction at a point [force / length^2].
    struct Value
    {
      double               pressure = 0.; ///< Positive in compression.
      dealii::Tensor<1, 3> shear    = {}; ///< Acts on the second side.
    };

    /// Returns the traction at the point @p place of the slave surface.
    Value
    at(const SlaveSurface::Place &place) const;

    /// Returns the traction at the point where the line from @p x along the
    /// unit vector @p n meets the slave surface within @p search_radius, or 0.
    Value
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &n,
            const double                search_radius) const;

    /// Resultant of the contact traction on the second side.
    struct Resultant
    {
      dealii::Tensor<1, 3> force, ///< Sum of the tractions [force].
        moment; ///< Moment about the scene origin [force x length].
    };

    /// Returns the resultant of the traction in @p strip or the whole contact.
    Resultant
    resultant(const std::optional<ContactStrip> &strip = {}) const;

    /// Returns for each contact point the fraction of its tributary area in @p
    /// strip, or 1 without a strip. A point force has 1 or 0.
    std::vector<double>
    shares(const std::optional<ContactStrip> &strip) const;

    /// Returns the energy dissipated by friction in @p strip or the contact.
    double
    dissipated(const std::optional<ContactStrip> &strip = {}) const;

    /// Returns the contact points with their forces.
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
    /// Returns for each contact point the fraction of the integral of phi_i in
    /// @p strip, and that fraction times the vector from the centroid of phi_i
    /// to the centroid of its restriction to the strip.
    std::vector<SlaveSurface::Integrals>
    inside(const ContactStrip &strip) const;
    /// Returns true if contact point @p k is not on the slave surface.
    bool
    is_point(const unsigned int k) const
    {
      return traction_surface == nullptr ||
             traction_surface->integrals()[k].area == 0.;
    }

    std::shared_ptr<const SlaveSurface> traction_surface;
    std::vector<Row>                    all;
    std::vector<Dissipation>            points_left;
  };
} // namespace lamella

#endif
