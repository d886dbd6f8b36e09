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
  /// A surface-to-surface contact in CalculiX.
  struct CalculixContact
  {
    /// Name of the contact in the scene.
    std::string   name;
    CalculixFaces slave;  ///< Element faces of the slave surface.
    CalculixFaces master; ///< Element faces of the master surface.
    /// True if the slave surface is the second side of the scene's contact.
    bool slave_is_second = false;
    /// Penalty stiffness: pressure over penetration [force / length^3].
    double stiffness = 0.;
    /// Elements that represent an obstacle; empty for contact of two bodies.
    std::optional<ObstacleLayer> layer;
    unsigned int first_node    = 0; ///< Number of the first node of `layer`.
    unsigned int first_element = 0; ///< Number of its first element.
  };

  /**
   * Contacts of a scene as surface-to-surface contacts of CalculiX with
   * friction. The contact pressure is K times the penetration, even if the
   * scene uses another enforcement of contact.
   *
   * K is the penalty stiffness [force / length^3]. By default it is 100
   * E_n / h of the softer side (normal modulus E_n, smallest depth h of
   * hexahedra at the surface). For a slender body, with a smallest extent d
   * below a tenth of its largest extent L, it is reduced by 10 d / L, since
   * contact iterations of CalculiX may fail otherwise
   * (doc/verification/calculix.md).
   *
   * The slave surface is the one named by `Slave side`, otherwise that with
   * smaller faces on average; in contact with an obstacle it is the body. Nodes
   * and elements of obstacles are numbered after those of the bodies. Keeps a
   * reference to the scene.
   */
  class CalculixContacts
  {
  public:
    /// Creates the contacts of @p scene. @p stiffness, unless empty, replaces
    /// the default penalty stiffness of all contacts. Throws InputError for
    /// `Overclosure = adjust`, for surfaces that a body does not have, and for
    /// surfaces farther from an obstacle than the search radius.
    CalculixContacts(const Scene                 &scene,
                     const CalculixMesh          &mesh,
                     const std::optional<double> &stiffness);

    /// Returns the contacts in the order of the scene.
    const std::vector<CalculixContact> &
    contacts() const
    {
      return list;
    }

    /// Returns the name of the slave surface (@p slave is true) or master
    /// surface (false) of the contact of index @p k, such as CONTACT1_SLAVE.
    static std::string
    surface_name(const unsigned int k, const bool slave);

    /// Writes elements of obstacles, surfaces, contact laws and contact pairs.
    void
    write_model(std::ostream &deck) const;

    /// Writes the displacements of obstacles, times the load factor @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

    /// Writes the output requests for contact resultants and pressures.
    void
    write_output(std::ostream &deck) const;

  private:
    /// Adds the contact of index @p k in the scene with its default penalty.
    void
    add(const unsigned int k, const CalculixMesh &mesh);
    /// Sets @p layer as master surface of @p contact and numbers its nodes.
    void
    add_layer(ObstacleLayer layer, CalculixContact &contact);
    /// Writes nodes, elements and material of the obstacle of contact @p k.
    void
    write_layer(std::ostream &deck, const unsigned int k) const;

    const Scene &scene;
    /// Contacts in the order of the scene.
    std::vector<CalculixContact> list;
    /// Next free node number and element number.
    unsigned int next_node, next_element;
  };
} // namespace lamella

#endif
