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
  /// Forces by number of the node, in scene components, at load factor 1.
  using NodalForces = std::map<unsigned int, dealii::Tensor<1, 3>>;

  /// Supports and loads of a scene on the nodes of a deck. Loads become
  /// consistent nodal forces, f_i = int N_i f dA, of opposite sign at the
  /// corners of faces of 20-node elements. Supports prescribe nodes, in
  /// components along the scene's axes. A node of two supports belongs to the
  /// first, so that their reactions add up. Refers to the scene.
  class CalculixConditions
  {
  public:
    /// Throws InputError for supports that nodes cannot express: lines and
    /// points off the nodes, normals oblique to the scene's axes, contradictory
    /// ones. Throws it also for bodies that only contact constrains: the system
    /// of CalculiX would be singular.
    CalculixConditions(const Scene &scene, const CalculixMesh &mesh);

    /// Returns the nodes at which support @p s, from 0, prescribes the
    /// component @p c (0 to 2). The support's reaction is the sum over them.
    const std::set<unsigned int> &
    nodes(const unsigned int s, const unsigned int c) const
    {
      return held[s][c];
    }

    /// Returns the sum of the loads on nodes(s, c) in direction @p c at load
    /// factor 1. CalculiX adds it to the reactions; readers subtract it.
    double
    load_vector_on(const unsigned int s, const unsigned int c) const;

    /// Returns the name of the set of nodes(s, c): SUPPORT1_X, ...
    static std::string
    set_name(const unsigned int s, const unsigned int c);

    /// Writes the node sets for the reactions, one per support and component.
    void
    write_sets(std::ostream &deck) const;

    /// Writes prescribed displacements and nodal forces times @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

  private:
    /// Prescribes the nodes of support number @p s: u in the scene's
    /// components, or a displacement along outward normals.
    void
    add_support(const unsigned int s, const CalculixMesh &mesh);
    /// Prescribes @p value (a length) for a component of @p node, as part of
    /// support @p s. Throws InputError if another one prescribes another value.
    void
    hold(const unsigned int  node,
         const unsigned int  component,
         const double        value,
         const unsigned int  s,
         const CalculixMesh &mesh);

    const Scene &scene;
    /// Prescribed displacement of each node and component.
    std::map<std::pair<unsigned int, unsigned int>, double> values;
    /// nodes() of each support and component.
    std::vector<std::array<std::set<unsigned int>, 3>> held;
    /// Sum of all loads.
    NodalForces nodal_forces;
  };
} // namespace lamella

#endif
