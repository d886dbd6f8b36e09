// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_face_tractions_h
#define lamella_recover_face_tractions_h

#include <lamella/body/body.h>
#include <lamella/conditions/support.h>
#include <lamella/conditions/traction.h>
#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_constraints.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Tractions t on plane faces of bodies in one state [force/length^2]:
  ///   t = factor sum_loads t_load - p n + q,
  /// with the load factor, the surface loads t_load, the contact pressure p,
  /// the face normal n and the friction traction q. Line and point loads and
  /// support forces are not included, since only their resultants are known. A
  /// contact with points on the face, on either side, contributes its
  /// ContactTraction on the line through the point along the face normal.
  class FaceTractions
  {
  public:
    /// Constructs a state without tractions.
    FaceTractions() = default;

    /// Stores @p loads at load factor @p factor, and the regions of
    /// @p supports. Throws InputError for expressions that cannot be parsed.
    FaceTractions(const std::vector<Load>    &loads,
                  const LoadFactor           &factor,
                  const std::vector<Support> &supports = {});

    /// Adds the traction of @p contact with its normal @p forces and, with
    /// friction, the shear forces @p shears. Keeps a reference to @p contact.
    void
    add_contact(const ContactInterface                              &contact,
                const dealii::ArrayView<const double>               &forces,
                const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// A plane face: name, one of its points, outward unit normal (scene).
    struct Face
    {
      unsigned int         body = 0;
      std::string          surface;
      dealii::Point<3>     origin;
      dealii::Tensor<1, 3> normal;
      /// Distance from the plane within which points lie on the face [length].
      double tolerance = 0.;
    };

    /// Returns true if no part of @p face of @p body has a surface load, a
    /// surface or body support, or a contact.
    bool
    is_free(const Body &body, const Face &face) const;

    /// The traction at points of one face; keeps a reference to FaceTractions.
    class OnFace
    {
    public:
      /// Finds the contacts with points on @p face.
      OnFace(const FaceTractions &all, const Face &face);

      /// Returns the traction at the point @p x of the face, scene components.
      dealii::Tensor<1, 3>
      operator()(const dealii::Point<3> &x) const;

      /// Returns true if a contact has points on the face.
      bool
      has_contacts() const
      {
        return !contacts.empty();
      }

    private:
      /// A contact with points on the face: largest distance of its sides there
      /// [length], and side of the body (1: second, -1: first).
      struct ContactOnFace
      {
        const ContactTraction *traction;
        double                 reach, side;
      };

      const FaceTractions       &all;
      Face                       face;
      std::vector<ContactOnFace> contacts;
    };

  private:
    struct SurfaceLoad
    {
      Region                          region;
      std::shared_ptr<const Traction> traction;
      double                          factor;
    };
    struct LoadedContact
    {
      const ContactInterface *contact;
      ContactTraction         traction;
    };

    std::vector<SurfaceLoad>   loads;
    std::vector<Region>        held;
    std::vector<LoadedContact> contacts;
  };
} // namespace lamella

#endif
