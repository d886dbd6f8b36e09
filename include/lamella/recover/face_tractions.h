// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_face_tractions_h
#define lamella_recover_face_tractions_h

#include <lamella/body/body.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_constraints.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Tractions t on plane faces of bodies [force/length^2] at one load factor:
  ///   t = factor sum_loads t_load - p n + q,
  /// with the load factor, the surface loads t_load, the contact pressure p,
  /// the face normal n and the friction traction q. Line and point loads and
  /// support forces are not included, since only their resultants are known. If
  /// a contact has contact points on the face, its p and q at a point x are
  /// those where the line through x along n meets the slave surface.
  class FaceTractions
  {
  public:
    /// Constructs an object with zero traction on all faces.
    FaceTractions() = default;

    /// Stores the surface loads among @p all_loads, multiplied by @p factor,
    /// and the regions of @p supports, for is_free(). Throws InputError if the
    /// formula of a load cannot be parsed.
    FaceTractions(const std::vector<Load>    &all_loads,
                  const LoadFactor           &factor,
                  const std::vector<Support> &supports = {});

    /// Adds the traction of @p contact, whose contact points have the normal
    /// forces @p forces and the shear forces @p shears (empty without
    /// friction). Keeps a reference to @p contact.
    void
    add_contact(const ContactInterface                              &contact,
                const dealii::ArrayView<const double>               &forces,
                const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// A plane face of a body.
    struct Face
    {
      unsigned int         body = 0; ///< Index of the body in Bodies.
      std::string          surface;  ///< Name of the surface of the body.
      dealii::Point<3>     origin;   ///< A point of the face, scene axes.
      dealii::Tensor<1, 3> normal;   ///< Outward unit normal, scene axes.
      /// Largest distance of points on the face from its plane [length].
      double tolerance = 0.;
    };

    /// Returns true if no surface load, contact, or support (except of lines
    /// and points) acts on any part of @p face, a face of @p body.
    bool
    is_free(const Body &body, const Face &face) const;

    /// Evaluates the traction at points of one plane face of a body.
    class OnFace
    {
    public:
      /// Finds the contacts on @p face; keeps a reference to @p all tractions.
      OnFace(const FaceTractions &all, const Face &face);

      /// Returns the traction vector at the point @p x of the face, scene axes.
      dealii::Tensor<1, 3>
      operator()(const dealii::Point<3> &x) const;

      /// Returns true if at least one contact has contact points on the face.
      bool
      has_contacts() const
      {
        return !contacts.empty();
      }

    private:
      /// A contact that has contact points on the face. `reach` is the search
      /// distance along the normal [length]; `side` is 1 if the face belongs to
      /// the second body of the contact, and -1 if it belongs to the first.
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
