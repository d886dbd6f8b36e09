// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_face_tractions_h
#define lamella_recover_face_tractions_h

#include <lamella/body/body.h>
#include <lamella/conditions/support.h>
#include <lamella/conditions/traction.h>
#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_rows.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * What acts on the plane faces of bodies in a state, as a traction t per
   * area: t = factor sum_loads t_load - p n + q, of all loads on surfaces and
   * of the contact pressure p and the shear q of friction there. Loads along
   * lines and at points have no traction and are left out, and so are the
   * forces of supports, which are known as resultants only.
   *
   * *Contact.* A contact that has points on the face presses and rubs it with
   * the values of its ContactTraction on the line through the place along the
   * normal of the face, whichever side carries the points.
   */
  class FaceTractions
  {
  public:
    /// Nothing acts anywhere.
    FaceTractions() = default;

    /// @p loads at load factor @p factor, and what @p supports hold, with
    /// forces that are not known. Throws InputError for expressions that do not
    /// parse.
    FaceTractions(const std::vector<Load>    &loads,
                  const LoadFactor           &factor,
                  const std::vector<Support> &supports = {});

    /// The traction of @p contact, which is referred to, with the @p forces in
    /// its rows and, with friction, @p shears.
    void
    add_contact(const ContactInterface                              &contact,
                const dealii::ArrayView<const double>               &forces,
                const dealii::ArrayView<const dealii::Tensor<1, 3>> &shears);

    /// A plane face of a body: its name there, a point of it, its outward unit
    /// normal, scene axes.
    struct Face
    {
      unsigned int         body = 0;
      std::string          surface;
      dealii::Point<3>     origin;
      dealii::Tensor<1, 3> normal;
      /// Points closer than this to its plane lie on it [length].
      double tolerance = 0.;
    };

    /// Whether nothing is on any part of @p face of @p body: no load on a
    /// surface, support of a surface or of all the body, nor contact.
    bool
    is_free(const Body &body, const Face &face) const;

    /// The traction at points of one face. Refers to the tractions it is of.
    class OnFace
    {
    public:
      /// Finds the points of contacts that lie on @p face.
      OnFace(const FaceTractions &all, const Face &face);

      /// Scene components [force/length^2]. @p x a point of the face.
      dealii::Tensor<1, 3>
      operator()(const dealii::Point<3> &x) const;

      /// Whether a contact has points on the face.
      bool
      has_contacts() const
      {
        return !contacts.empty();
      }

    private:
      /// A contact that has points on the face, how far its two sides are
      /// apart at these [length], and 1 on its second side, -1 on its first.
      struct Pressing
      {
        const ContactTraction *traction;
        double                 reach, side;
      };

      const FaceTractions  &all;
      Face                  face;
      std::vector<Pressing> contacts;
    };

  private:
    struct SurfaceLoad
    {
      Region                          region;
      std::shared_ptr<const Traction> traction;
      double                          factor;
    };
    struct Pressed
    {
      const ContactInterface *contact;
      ContactTraction         traction;
    };

    std::vector<SurfaceLoad> loads;
    std::vector<Region>      held;
    std::vector<Pressed>     contacts;
  };
} // namespace lamella

#endif
