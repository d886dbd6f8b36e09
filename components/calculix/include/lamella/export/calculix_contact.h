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
  /// A contact as CalculiX understands it, surface to surface: it integrates
  /// over the faces of the slave what separates them from the master.
  struct CalculixContact
  {
    /// The scene's.
    std::string name;
    /// Faces of bodies, or the master's of an obstacle's layer.
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
   * The contacts of a scene as surface-to-surface contact with their friction
   * and the pressure p = K times the penetration, whatever the scene's
   * enforcement.
   *
   * K is @p stiffness, or a hundred times E_n / h of the softer side (normal
   * modulus over the depth of the shallowest hexahedron below the surface): the
   * penetration is then a hundredth of what that hexahedron is compressed by.
   * For a slender body, whose smallest extension d is below a tenth of its
   * largest one L, it is 10 d / L times that: it gives way by bending far more
   * than where it is touched, and CalculiX' iterations on a contact much
   * stiffer than the body end in wrong states (doc/calculix.md). It is a
   * penalty per area, eps_N of Eq. 20, a force over length^3.
   *
   * The slave, over whose faces CalculiX integrates, is the side that
   * `Points on` names, else the one with the smaller faces in the mean, of
   * equal ones the first; against an obstacle always the body. Refers to the
   * scene; numbers of obstacles' nodes and elements follow those of the mesh.
   */
  class CalculixContacts
  {
  public:
    /// @p stiffness replaces the automatic K of all contacts. Throws InputError
    /// for Overclosure = adjust, for surfaces that bodies do not have and for
    /// those that face nothing of an obstacle within the search distance.
    CalculixContacts(const Scene                 &scene,
                     const CalculixMesh          &mesh,
                     const std::optional<double> &stiffness);

    /// In the order of the scene.
    const std::vector<CalculixContact> &
    contacts() const
    {
      return list;
    }

    /// The name of a surface of contact @p k, from 0: CONTACT1_SLAVE,
    /// CONTACT1_MASTER, ...
    static std::string
    surface_name(const unsigned int k, const bool slave);

    /// Layers of obstacles, surfaces, laws and pairs: what stands before the
    /// first step.
    void
    write_model(std::ostream &deck) const;

    /// The motion of the obstacles in the load step of @p factor: all nodes of
    /// their layers are moved by it times their displacement.
    void
    write_step(std::ostream &deck, const double factor) const;

    /// Asks for the contacts' resultants, and for the pressures: CalculiX may
    /// end in states in which they pull.
    void
    write_output(std::ostream &deck) const;

  private:
    /// Adds the scene's contact @p k with its automatic K.
    void
    add(const unsigned int k, const CalculixMesh &mesh);
    /// Makes @p layer the master of @p contact, in the next free numbers.
    void
    add_layer(ObstacleLayer layer, CalculixContact &contact);
    /// Nodes, elements and a material, which does not matter, of the obstacle
    /// of contact @p k: the sets OBSTACLE1, ...
    void
    write_layer(std::ostream &deck, const unsigned int k) const;

    const Scene &scene;
    /// contacts().
    std::vector<CalculixContact> list;
    /// The next free numbers.
    unsigned int next_node, next_element;
  };
} // namespace lamella

#endif
