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
  /// Nodal forces at load factor 1 in scene axes, by node number.
  using NodalForces = std::map<unsigned int, dealii::Tensor<1, 3>>;

  /// Supports and loads of a scene as conditions on the nodes of a CalculiX
  /// input deck. Loads become consistent nodal forces f_i = int N_i t dA with
  /// shape functions N_i and traction t. Supports prescribe nodal displacements
  /// along scene axes. A node of two supports is assigned to the first, so that
  /// the sum of reactions is correct. Keeps a reference to the scene.
  class CalculixConditions
  {
  public:
    /// Throws InputError for supports that cannot be prescribed at nodes: lines
    /// and points that are not at nodes, normals oblique to scene axes,
    /// contradictory values; also if only contact constrains a rigid motion.
    CalculixConditions(const Scene &scene, const CalculixMesh &mesh);

    /// Returns the nodes at which support @p s prescribes the displacement
    /// component @p c (0 to 2). Its reaction is the sum of their reactions.
    const std::set<unsigned int> &
    nodes(const unsigned int s, const unsigned int c) const
    {
      return held[s][c];
    }

    /// Returns the sum of applied forces in direction @p c at the nodes of
    /// support @p s, at load factor 1. CalculiX includes it in reactions.
    double
    load_vector_on(const unsigned int s, const unsigned int c) const;

    /// Returns whether the scene has static steps: always, except for natural
    /// modes without loads, contacts and prescribed displacements.
    bool
    has_static_steps() const
    {
      return has_statics;
    }

    /// Returns the number of rigid motions that supports leave free.
    unsigned int
    n_rigid_motions() const
    {
      return n_free_motions;
    }

    /// Returns the node set name of support @p s, component @p c: SUPPORT1_X.
    static std::string
    set_name(const unsigned int s, const unsigned int c);

    /// Writes the node sets to @p deck, one per support and component.
    void
    write_sets(std::ostream &deck) const;

    /// Writes prescribed displacements and nodal forces, times @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

  private:
    /// Prescribes the displacements of the nodes of the support of index @p s.
    void
    add_support(const unsigned int s, const CalculixMesh &mesh);
    /// Prescribes the displacement @p value for @p component of @p node by
    /// support @p s. Throws InputError if another support contradicts it.
    void
    hold(const unsigned int  node,
         const unsigned int  component,
         const double        value,
         const unsigned int  s,
         const CalculixMesh &mesh);

    const Scene &scene;
    /// Prescribed displacement of each node and component.
    std::map<std::pair<unsigned int, unsigned int>, double> values;
    /// Nodes at which each support prescribes each component.
    std::vector<std::array<std::set<unsigned int>, 3>> held;
    /// Sum of the nodal forces of all loads.
    NodalForces  nodal_forces;
    bool         has_statics    = true;
    unsigned int n_free_motions = 0;
  };
} // namespace lamella

#endif
