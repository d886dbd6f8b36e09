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

  /**
   * The traction of a contact in a state: the pressure
   *   p(x) = sum_i lambda_i / A_i phi_i(x)
   * with the row forces lambda_i, their functions phi_i on the slave surface
   * (SlaveSurface) and the tributary areas A_i = int phi_i dA. Hence int p dA =
   * sum lambda_i, and the force on the second side,
   *   sum_i lambda_i / A_i n_i int phi_i dA = sum lambda_i n_i,
   * is the resultant of the rows to rounding for all surfaces and meshes, with
   * the row normals n_i. Friction adds the shear traction q(x) of lambda_t,i
   * likewise: on the second side, opposite on the first.
   *
   * Pressures of nodal rows are lumped, and so is their moment. The difference
   * to the moment of p n_i, of order h^2, is added as a couple distributed like
   * the force. Rows without a facet are point forces. All evaluations of
   * pressure between points, or in a part of the contact, use this class.
   */
  class ContactTraction
  {
  public:
    /// A row of the contact with its force in the state.
    struct Row
    {
      /// Undeformed position in the scene: place_of() its point.
      dealii::Point<3> place;
      /// Normal n_i, outward from First.
      dealii::Tensor<1, 3> normal;
      /// Tributary area [length^2], and lambda_i >= 0 [force].
      double area = 0., force = 0.;
      /// Moment of its force on the second side about the origin of the scene.
      dealii::Tensor<1, 3> moment;
      /// Force on the second side beside lambda_i n_i, and energy dissipated.
      dealii::Tensor<1, 3> shear      = {};
      double               dissipated = 0.;
    };

    /// Creates the traction of @p rows on @p surface; if null, of point forces.
    ContactTraction(std::shared_ptr<const SlaveSurface> surface,
                    std::vector<Row>                    rows);

    /// Creates the traction of @p contact with the row @p forces and, with
    /// friction, @p shears; moments are those at the row positions.
    ContactTraction(
      const ContactInterface                              &contact,
      const dealii::ArrayView<const double>               &forces,
      const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// Tractions p and q at a point [force/length^2].
    struct Value
    {
      double               pressure = 0.;
      dealii::Tensor<1, 3> shear    = {};
    };

    /// Returns the traction at @p place of the surface.
    Value
    at(const SlaveSurface::Place &place) const;

    /// Returns the traction where the line through @p x along the unit vector
    /// @p n meets the surface within @p search_radius [length], else zero.
    Value
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &n,
            const double                search_radius) const;

    /// Force and moment about the origin of the scene, on the second side.
    struct Resultant
    {
      dealii::Tensor<1, 3> force, moment;
    };

    /// Returns the integral over the contact or a strip; strips add up.
    Resultant
    resultant(const std::optional<ContactStrip> &strip = {}) const;

    /// Returns each row's share in @p strip, int_strip phi_i dA / A_i; else 1.
    /// A point force is inside or outside.
    std::vector<double>
    shares(const std::optional<ContactStrip> &strip) const;

    /// Returns the energy dissipated in the contact or a strip (shares()).
    double
    dissipated(const std::optional<ContactStrip> &strip = {}) const;

    /// Returns the largest lambda_i / A_i with the tributary area A_i.
    double
    largest_pressure() const;

    const std::vector<Row> &
    rows() const
    {
      return all;
    }

    /// Returns the surface; null if unknown.
    const std::shared_ptr<const SlaveSurface> &
    surface() const
    {
      return traction_surface;
    }

  private:
    /// Returns for each row its share int_strip phi_i dA / A_i, and the offset
    /// of its centroid from that of phi_i times the share: int_strip x phi_i dA
    /// / A_i
    /// - share int x phi_i dA / A_i.
    std::vector<SlaveSurface::Integrals>
    inside(const ContactStrip &strip) const;
    /// Returns true if row @p k is on no facet.
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
