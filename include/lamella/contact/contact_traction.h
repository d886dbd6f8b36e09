// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_traction_h
#define lamella_contact_contact_traction_h

#include <lamella/contact/carrying_surface.h>

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
   * with the rows' forces lambda_i and their functions phi_i on the surface
   * that carries them (CarryingSurface), A_i = int phi_i dA. That is the
   * tributary area of the row: int p dA = sum lambda_i, and the force on the
   * second side,
   *   sum_i lambda_i / A_i n_i int phi_i dA = sum lambda_i n_i,
   * is the resultant of the rows to rounding, whatever surfaces and meshes are.
   * n_i is the row's normal. Friction adds the shear q(x), of lambda_t,i in the
   * same way: on the second side, opposite on the first.
   *
   * Pressures of rows that have their force at a node alone are lumped; so is
   * their moment. What the moment of p n_i about the node is off by, an h^2 of
   * the moment, counts as a couple that is spread like the force: moments of
   * the rows are kept, too.
   *
   * Rows on no facet (none of a body is) are points with a force. Everything
   * that asks for the pressure of a contact between its points, or for a part
   * of it, asks here. Plain numbers; the surface is shared.
   */
  class ContactTraction
  {
  public:
    /// A row of the contact with what it does in the state.
    struct Row
    {
      /// Where it is, undeformed in the scene: place_of() its point.
      dealii::Point<3> place;
      /// n_i, outwards from First.
      dealii::Tensor<1, 3> normal;
      /// The tributary area [length^2], and lambda_i [force], not negative.
      double area = 0., force = 0.;
      /// Of its force on the second side, about the scene's origin.
      dealii::Tensor<1, 3> moment;
      /// What of its force on the second side is not lambda_i n_i [force], and
      /// what the row has dissipated so far [energy]: zero without friction.
      dealii::Tensor<1, 3> shear      = {};
      double               dissipated = 0.;
    };

    /// @p surface carries @p rows, in their order; null if nothing is known of
    /// it: then all rows are points.
    ContactTraction(std::shared_ptr<const CarryingSurface> surface,
                    std::vector<Row>                       rows);

    /// That of @p contact with @p forces in its rows and, with friction, @p
    /// shears (else empty); moments are those of the forces at the rows'
    /// places.
    ContactTraction(
      const ContactInterface                              &contact,
      const dealii::ArrayView<const double>               &forces,
      const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// p and q at a place [force/length^2].
    struct Value
    {
      double               pressure = 0.;
      dealii::Tensor<1, 3> shear    = {};
    };

    /// At @p place of the surface.
    Value
    at(const CarryingSurface::Place &place) const;

    /// Where the line through @p x along the unit vector @p n meets the
    /// surface within @p reach [length]; zero if it does not. So it is asked
    /// for on either side of the contact.
    Value
    on_line(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &n,
            const double                reach) const;

    /// Force and moment about the scene's origin, on the second side.
    struct Resultant
    {
      dealii::Tensor<1, 3> force, moment;
    };

    /// Of all of the contact or of a strip: the integral of its traction there.
    /// Those of strips side by side sum to that of the contact.
    Resultant
    resultant(const std::optional<ContactStrip> &strip = {}) const;

    /// Of each row the part of its force that is in @p strip,
    /// int_strip phi_i dA / A_i, or 1. A row that is a point is in it or not.
    std::vector<double>
    shares(const std::optional<ContactStrip> &strip) const;

    /// What friction has dissipated so far in all of the contact or in a strip:
    /// that of its rows by shares() [energy].
    double
    dissipated(const std::optional<ContactStrip> &strip = {}) const;

    /// The largest lambda_i / A_i, A_i the tributary area.
    double
    largest_pressure() const;

    const std::vector<Row> &
    rows() const
    {
      return all;
    }

    /// Null if nothing is known of it.
    const std::shared_ptr<const CarryingSurface> &
    surface() const
    {
      return carrier;
    }

  private:
    /// Of each row its share int_strip phi_i dA / A_i, and how far the middle
    /// of that is from the middle of phi_i, times the share:
    /// int_strip x phi_i dA / A_i - share int x phi_i dA / A_i. A point is in
    /// @p strip or not.
    std::vector<CarryingSurface::Integrals>
    inside(const ContactStrip &strip) const;
    /// Whether the row @p k is on no facet.
    bool
    is_point(const unsigned int k) const
    {
      return carrier == nullptr || carrier->integrals()[k].area == 0.;
    }

    std::shared_ptr<const CarryingSurface> carrier;
    std::vector<Row>                       all;
  };
} // namespace lamella

#endif
