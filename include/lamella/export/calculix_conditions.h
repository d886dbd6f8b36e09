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
  /// Forces at nodes, scene components, at load factor 1.
  using NodalForces = std::map<unsigned int, dealii::Tensor<1, 3>>;

  /**
   * The supports and loads of a scene on the nodes of a deck.
   *
   * Loads become the forces that do the same work on the element's own
   * displacements, f_i = int N_i f dA; on a face of 20-node elements those at
   * corners point backwards. A node that two supports hold belongs to the first
   * of them, so that their reactions add up.
   */
  class CalculixConditions
  {
  public:
    /// Throws InputError for supports that nodes cannot express: of lines and
    /// points beside nodes, of normals oblique to the scene's axes, two that
    /// contradict each other; and for bodies that nothing but contact holds.
    CalculixConditions(const Scene &scene, const CalculixMesh &mesh);

    /// Nodes of support @p s whose component @p c is prescribed by it.
    const std::set<unsigned int> &
    nodes(const unsigned int s, const unsigned int c) const
    {
      return held[s][c];
    }

    /// The loads on those, in direction @p c: CalculiX adds them to the
    /// reactions.
    double
    load_on(const unsigned int s, const unsigned int c) const;

    /// The set of nodes(s, c): SUPPORT1_X, ...
    static std::string
    set_name(const unsigned int s, const unsigned int c);

    /// The node sets of the supports.
    void
    write_sets(std::ostream &deck) const;

    /// What belongs into the load step of @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

  private:
    void
    add_support(const unsigned int s, const CalculixMesh &mesh);
    void
    hold(const unsigned int  node,
         const unsigned int  component,
         const double        value,
         const unsigned int  s,
         const CalculixMesh &mesh);

    const Scene &scene;
    /// Of each node and component the prescribed displacement.
    std::map<std::pair<unsigned int, unsigned int>, double> values;
    std::vector<std::array<std::set<unsigned int>, 3>>      held;
    NodalForces                                             nodal_forces;
  };
} // namespace lamella

#endif
