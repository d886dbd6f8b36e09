// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_conditions_h
#define lamella_export_calculix_conditions_h

#include <lamella/export/calculix_mesh.h>

#include <array>
#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /// Forces by the number of the node, scene components, at load factor 1.
  using NodalForces = std::map<unsigned int, dealii::Tensor<1, 3>>;

  /**
   * The supports and loads of a scene on the nodes of a deck.
   *
   * Loads become the forces that do the same work on the element's own
   * displacements, f_i = int N_i f dA; on a face of 20-node elements those at
   * corners point backwards. A node that two supports hold belongs to the first
   * of them, so that their reactions add up.
   *
   * Supports are not condensed, as they are in Lamella (RowReduction), but
   * prescribe nodes; all components are along the scene's axes. Loads are
   * integrated by Lamella's own points and weights and may be anywhere. Refers
   * to the scene, not to the mesh.
   */
  class CalculixConditions
  {
  public:
    /// Throws InputError for supports that nodes cannot express: of lines and
    /// points beside nodes, of normals oblique to the scene's axes, two that
    /// contradict each other; and for bodies that nothing but contact holds,
    /// with stabilising springs or without: CalculiX would solve a singular
    /// system.
    CalculixConditions(const Scene &scene, const CalculixMesh &mesh);

    /// Nodes of support @p s, from 0, whose component @p c (0 to 2) is
    /// prescribed by it: CalculiX' reaction of the support is the sum over
    /// them.
    const std::set<unsigned int> &
    nodes(const unsigned int s, const unsigned int c) const
    {
      return held[s][c];
    }

    /// The sum of the loads on those, in direction @p c, at load factor 1, a
    /// force: CalculiX adds them to the reactions, and who reads these takes
    /// them off.
    double
    load_on(const unsigned int s, const unsigned int c) const;

    /// The name of the set of nodes(s, c): SUPPORT1_X, ...
    static std::string
    set_name(const unsigned int s, const unsigned int c);

    /// The node sets of the supports, one a component, that reactions are
    /// printed for.
    void
    write_sets(std::ostream &deck) const;

    /// What belongs into the load step of @p factor: all prescribed
    /// displacements and nodal forces, times it.
    void
    write_step(std::ostream &deck, const double factor) const;

  private:
    /// Holds the nodes of support number @p s in what it prescribes: u in the
    /// scene's components, or a displacement along outward normals.
    void
    add_support(const unsigned int s, const CalculixMesh &mesh);
    /// Prescribes @p value (a length) for a component of @p node, on behalf of
    /// support @p s if no other has it. Throws InputError if another one says
    /// another value.
    void
    hold(const unsigned int  node,
         const unsigned int  component,
         const double        value,
         const unsigned int  s,
         const CalculixMesh &mesh);

    const Scene &scene;
    /// Of each node and component the prescribed displacement.
    std::map<std::pair<unsigned int, unsigned int>, double> values;
    /// nodes() of each support and component.
    std::vector<std::array<std::set<unsigned int>, 3>> held;
    /// Of all loads together.
    NodalForces nodal_forces;
  };
} // namespace lamella

#endif
