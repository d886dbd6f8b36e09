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
  /// A contact as CalculiX understands it: it integrates over the faces of the
  /// slave.
  struct CalculixContact
  {
    std::string   name;
    CalculixFaces slave, master;
    /// Whether the slave is the scene's second side.
    bool slave_is_second = false;
    /// Pressure over penetration, force / length^3.
    double stiffness = 0.;
    /// Of a contact with an obstacle, with the numbers of its first node and
    /// element.
    std::optional<ObstacleLayer> layer;
    unsigned int                 first_node = 0, first_element = 0;
  };

  /**
   * The contacts of a scene as frictionless surface-to-surface contact with the
   * pressure p = K times the penetration, whatever the scene's enforcement.
   *
   * K is @p stiffness, or a hundred times E_n / h of the softer side (normal
   * modulus over the depth of the shallowest hexahedron below the surface): the
   * penetration is then a hundredth of what that hexahedron is compressed by.
   * For a slender body, whose smallest extension d is below a tenth of its
   * largest one L, it is 10 d / L times that: it gives way by bending far more
   * than where it is touched, and CalculiX' iterations on a contact much
   * stiffer than the body end in wrong states (doc/calculix.md).
   */
  class CalculixContacts
  {
  public:
    /// Throws InputError for Overclosure = adjust and for surfaces that face
    /// nothing of an obstacle.
    CalculixContacts(const Scene                 &scene,
                     const CalculixMesh          &mesh,
                     const std::optional<double> &stiffness);

    const std::vector<CalculixContact> &
    contacts() const
    {
      return list;
    }

    /// CONTACT1_SLAVE, CONTACT1_MASTER, ...
    static std::string
    surface_name(const unsigned int k, const bool slave);

    /// Layers of obstacles, surfaces, laws and pairs.
    void
    write_model(std::ostream &deck) const;

    /// The motion of the obstacles in the load step of @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

    /// Asks for the contacts' resultants, and for the pressures: CalculiX may
    /// end in states in which they pull.
    void
    write_output(std::ostream &deck) const;

  private:
    void
    add(const unsigned int k, const CalculixMesh &mesh);
    void
    write_layer(std::ostream &deck, const unsigned int k) const;

    const Scene                 &scene;
    std::vector<CalculixContact> list;
    /// The next free numbers.
    unsigned int next_node, next_element;
  };
} // namespace lamella

#endif
