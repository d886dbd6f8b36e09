// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_face_tractions_h
#define lamella_recover_face_tractions_h

#include <lamella/body/body.h>
#include <lamella/conditions/support.h>
#include <lamella/conditions/traction.h>
#include <lamella/recover/results.h>

#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /**
   * What acts on the plane faces of bodies in a state, as a traction t per
   * area: t = factor sum_loads t_load - p n, of all loads on surfaces and of
   * the contact pressure p there. Loads along lines and at points have no
   * traction and are left out, and so are the forces of supports, which are
   * known as resultants only.
   *
   * *Contact.* A point of a contact that lies on the face has the pressure
   * lambda / A, its force over its tributary area. Where the points are those
   * of a grid along the face's two directions the pressure is bilinear between
   * them, zero at places of the grid that have no point, constant beyond its
   * ends for half the last interval, and zero further out. Of points that make
   * no grid the nearest one counts, within half the root of its area.
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
                  const double                factor,
                  const std::vector<Support> &supports = {});

    /// The pressure of a contact with the @p forces at its @p points;
    /// @p second is the body on its second side, none for an obstacle.
    void
    add_contact(const unsigned int                          first,
                const std::optional<unsigned int>           second,
                const std::vector<ContactInterface::Point> &points,
                const dealii::ArrayView<const double>      &forces);

    /// A plane face of a body: its name there, a point of it, its outward
    /// normal and two directions along it, all unit vectors in scene axes.
    struct Face
    {
      unsigned int         body = 0;
      std::string          surface;
      dealii::Point<3>     origin;
      dealii::Tensor<1, 3> normal, along_s, along_t;
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
      /// Of one contact: the places on the face, by their coordinates along it
      /// from the origin, and the pressures.
      struct Pressures
      {
        std::vector<std::array<double, 2>> places;
        std::vector<double>                values, spacings;
        /// Different coordinates, ascending; a grid if both are not empty.
        std::array<std::vector<double>, 2> grid;
        /// Of each place of the grid, the second coordinate slowest.
        std::vector<double> on_grid;
      };

      static void
      make_grid(Pressures &pressures, const double same);
      /// [force/length^2] at @p st.
      static double
      pressure(const Pressures &pressures, const std::array<double, 2> &st);

      const FaceTractions   &all;
      Face                   face;
      std::vector<Pressures> contacts;
    };

  private:
    struct SurfaceLoad
    {
      Region                          region;
      std::shared_ptr<const Traction> traction;
    };
    struct Pressed
    {
      unsigned int         body;
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> normal;
      double               pressure, spacing;
    };

    double                            factor = 0.;
    std::vector<SurfaceLoad>          loads;
    std::vector<Region>               held;
    std::vector<std::vector<Pressed>> contacts;
  };
} // namespace lamella

#endif
