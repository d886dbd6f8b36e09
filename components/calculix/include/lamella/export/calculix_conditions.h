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
  /// Nodal forces at load factor 1, scene axes, by node number.
  using NodalForces = std::map<unsigned int, dealii::Tensor<1, 3>>;

  /// Supports and loads of a scene as conditions on the nodes of a CalculiX
  /// input deck. Loads become consistent nodal forces f_i = int N_i f dA.
  /// Supports prescribe nodal displacements along the axes of the scene. A node
  /// that belongs to two supports is assigned to the first, so that the sum of
  /// reactions is correct. Keeps a reference to the scene.
  class CalculixConditions
  {
  public:
    /// Throws InputError for supports that cannot be prescribed at nodes: lines
    /// and points that are not at nodes, normals oblique to the axes of the
    /// scene, contradictory values. Throws InputError also if only contact
    /// constrains a rigid motion (singular in CalculiX).
    CalculixConditions(const Scene &scene, const CalculixMesh &mesh);

    /// Returns the nodes at which the support of index @p s prescribes the
    /// component @p c (0 to 2). The sum of their reactions is the support's.
    const std::set<unsigned int> &
    nodes(const unsigned int s, const unsigned int c) const
    {
      return held[s][c];
    }

    /// Returns the sum of applied nodal forces on nodes(s, c) in direction @p c
    /// at load factor 1, which CalculiX includes in its reactions.
    double
    load_vector_on(const unsigned int s, const unsigned int c) const;

    /// Returns the name of the node set of nodes(s, c), such as SUPPORT1_X.
    static std::string
    set_name(const unsigned int s, const unsigned int c);

    /// Writes the node sets, one per support and component.
    void
    write_sets(std::ostream &deck) const;

    /// Writes prescribed displacements and nodal forces, times @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

  private:
    /// Prescribes the displacements of the nodes of the support of index @p s.
    void
    add_support(const unsigned int s, const CalculixMesh &mesh);
    /// Prescribes the displacement @p value [length] for @p component of @p
    /// node by support @p s. Throws InputError if another support prescribes
    /// another value.
    void
    hold(const unsigned int  node,
         const unsigned int  component,
         const double        value,
         const unsigned int  s,
         const CalculixMesh &mesh);

    const Scene &scene;
    /// Prescribed displacement of each node and component.
    std::map<std::pair<unsigned int, unsigned int>, double> values;
    /// Nodes of each support and component.
    std::vector<std::array<std::set<unsigned int>, 3>> held;
    /// Sum of the nodal forces of all loads.
    NodalForces nodal_forces;
  };
} // namespace lamella

#endif
