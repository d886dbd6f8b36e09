// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_contact_h
#define lamella_export_calculix_contact_h

#include <lamella/export/calculix_mesh.h>
#include <lamella/export/calculix_obstacle.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A surface-to-surface contact of CalculiX, which integrates the separation
  /// from the master over the faces of the slave.
  struct CalculixContact
  {
    /// Name in the scene.
    std::string name;
    /// Faces of bodies; the master of an obstacle has those of its layer.
    CalculixFaces slave, master;
    /// True if the slave is the scene's second side.
    bool slave_is_second = false;
    /// Pressure over penetration, force / length^3.
    double stiffness = 0.;
    /// Layer of an obstacle, with the numbers of its first node and element.
    std::optional<ObstacleLayer> layer;
    unsigned int                 first_node = 0, first_element = 0;
  };

  /**
   * Contacts of a scene as surface-to-surface contact with friction and the
   * pressure p = K times the penetration, for any enforcement of the scene.
   *
   * K is @p stiffness, or 100 E_n / h of the softer side (normal modulus over
   * the depth of the shallowest hexahedron at the surface). K of a slender
   * body, with a smallest extent d below a tenth of its largest one L, is 10 d
   * / L times that: CalculiX' contact iterations may fail if the contact is
   * much stiffer than the body (doc/verification/calculix.md). K is a penalty
   * per area, eps_N of Eq. 20 [force / length^3].
   *
   * The slave is the side named by `Slave side`, else the one with smaller
   * faces on average, or the first if equal; against an obstacle it is the
   * body. Refers to the scene. Nodes and elements of obstacles are numbered
   * after those of the mesh.
   */
  class CalculixContacts
  {
  public:
    /// Replaces the automatic K of all contacts by @p stiffness, if given.
    /// Throws InputError for Overclosure = adjust, for surfaces that bodies do
    /// not have, and for surfaces farther than the search radius from an
    /// obstacle.
    CalculixContacts(const Scene                 &scene,
                     const CalculixMesh          &mesh,
                     const std::optional<double> &stiffness);

    /// Returns the contacts in the order of the scene.
    const std::vector<CalculixContact> &
    contacts() const
    {
      return list;
    }

    /// Returns the surface name of contact @p k, from 0: CONTACT1_SLAVE.
    static std::string
    surface_name(const unsigned int k, const bool slave);

    /// Writes layers of obstacles, surfaces, laws and pairs.
    void
    write_model(std::ostream &deck) const;

    /// Writes the motion of the obstacles in a load step: @p factor times the
    /// displacement.
    void
    write_step(std::ostream &deck, const double factor) const;

    /// Writes the request for resultants and pressures of the contacts.
    void
    write_output(std::ostream &deck) const;

  private:
    /// Adds the scene's contact @p k with its automatic K.
    void
    add(const unsigned int k, const CalculixMesh &mesh);
    /// Makes @p layer the master of @p contact, with the next free numbers.
    void
    add_layer(ObstacleLayer layer, CalculixContact &contact);
    /// Writes nodes, elements and a materialof the obstacle of contact @p k.
    void
    write_layer(std::ostream &deck, const unsigned int k) const;

    const Scene &scene;
    /// contacts().
    std::vector<CalculixContact> list;
    /// Next free numbers.
    unsigned int next_node, next_element;
  };
} // namespace lamella

#endif
