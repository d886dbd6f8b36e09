// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_axis_loop_h
#define lamella_body_axis_loop_h

#include <lamella/axis/axis.h>
#include <lamella/base/linear_algebra.h>
#include <lamella/section/section_operator.h>

#include <deal.II/base/array_view.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// Numbering of the DoFs of a beam. A DoF is the amplitude of a section
  /// function at an axis node. Each node has its own list of section functions
  /// (node-dependent kinematics) and contiguous DoFs,
  ///   DoF of (i, alpha) = first(i) + place(i, alpha),
  /// for node i and section function alpha, which is entry place(i, alpha) of
  /// the ascending list fields(i) of the section functions of node i.
  class BeamDofMap
  {
  public:
    /// Constructs the map from the list of section functions of each axis node,
    /// ascending and below @p n_fields.
    BeamDofMap(const std::vector<std::vector<unsigned int>> &fields_of_node,
               const unsigned int                            n_fields);

    /// Returns the number of DoFs: section functions, summed over all nodes.
    DofIndex
    n_dofs() const
    {
      return offsets.back();
    }

    /// Returns the number of axis nodes.
    unsigned int
    n_nodes() const
    {
      return kinds.size();
    }

    /// Returns the indices of the section functions of @p node, ascending.
    const std::vector<unsigned int> &
    fields(const unsigned int node) const
    {
      return lists[kinds[node]];
    }

    /// Returns the first DoF of @p node. Its DoFs are in the order of fields().
    DofIndex
    first(const unsigned int node) const
    {
      return offsets[node];
    }

    /// Returns the index of section function @p alpha in the list fields() of
    /// @p node, or -1 if the node does not have this function.
    int
    place(const unsigned int node, const unsigned int alpha) const
    {
      return places[kinds[node]][alpha];
    }

    /// Returns the axis node of @p dof, by bisection.
    unsigned int
    node_of(const DofIndex dof) const;

    /// Returns the index of the section function of @p dof, by bisection.
    unsigned int
    field_of(const DofIndex dof) const;

  private:
    std::vector<std::vector<unsigned int>> lists; ///< Distinct lists of fields.
    std::vector<std::vector<int>> places;  ///< place() for each of `lists`.
    std::vector<unsigned int>     kinds;   ///< Index in `lists` for each node.
    std::vector<DofIndex>         offsets; ///< first() of nodes, then n_dofs().
  };

  /// Integration along the axis of a beam by sum factorization. The DoFs
  /// u_(i,alpha) of axis nodes i and section functions alpha give the
  /// amplitudes at an integration point (station),
  ///   q_alpha = sum_i N_i u_(i,alpha),   q_alpha' = sum_i N_i' u_(i,alpha),
  /// with shape functions N_i. From the section forces W_0 (conjugate to q) and
  /// W_1 (conjugate to q'), the nodal forces are
  ///   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy.
  /// An element has all section functions of its nodes. The DoF of a function
  /// that a node lacks is zero. Each process integrates Axis::own_cells().
  class AxisLoop
  {
  public:
    /// Stores references to the arguments, which must outlive this object.
    AxisLoop(const SectionSpace &space,
             const Axis         &axis,
             const BeamDofMap   &dof_map)
      : space(space)
      , axis(axis)
      , dof_map(dof_map)
    {}

    /// Returns the number of integration points per axis element.
    unsigned int
    n_stations() const
    {
      return axis.integration_points().size() / axis.n_cells();
    }

    /// Returns the section functions of the nodes of axis element @p cell.
    std::vector<unsigned int>
    fields_of_element(const unsigned int cell) const;

    /// Function of the index of an axis element and its section operator.
    using ElementCallback =
      std::function<void(const unsigned int, const SectionOperator &)>;
    /// Calls @p use with each axis element of this process and its operator.
    void
    for_each_element(const ElementCallback &use) const;

    /// Returns the amplitudes q and derivatives q' of the section functions @p
    /// fields at the points @p stations of one element, for the displacements
    /// @p u. Derivatives vanish exactly for rigid translations, as they are
    /// computed from differences to the value at the first node.
    FieldParts
    at(const dealii::ArrayView<const AxisPoint> &stations,
       const std::vector<unsigned int>          &fields,
       const Vector                             &u) const;

    /// Returns the amplitudes of the section functions @p fields and their
    /// axial derivatives at the integration points of element @p cell, for the
    /// displacements @p u.
    FieldParts
    on_element(const unsigned int               cell,
               const std::vector<unsigned int> &fields,
               const Vector                    &u) const;

    /// Function that returns section forces at an element's integration points.
    using ForcesOfElement =
      std::function<SectionForces(const unsigned int, const SectionOperator &)>;
    /// Adds to @p f the nodal forces of all elements for the section forces
    /// @p forces_of. Collective.
    void
    add_forces(const ForcesOfElement &forces_of, Vector &f) const;

    /// Returns the strain energy of axis element @p cell, the integral of the
    /// energy per length SectionForces::energy of @p forces [force length].
    double
    energy(const unsigned int cell, const SectionForces &forces) const;

  private:
    /// Adds to @p f the nodal forces of the section forces @p work of the
    /// section functions @p fields on the element @p cell.
    void
    add_on_nodes(const unsigned int               cell,
                 const std::vector<unsigned int> &fields,
                 const FieldParts                &work,
                 Vector                          &f) const;

    const SectionSpace &space;
    const Axis         &axis;
    const BeamDofMap   &dof_map;
  };
} // namespace lamella

#endif
