// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_axis_loop_h
#define lamella_body_axis_loop_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_dof_map.h>
#include <lamella/section/section_operator.h>

#include <deal.II/base/array_view.h>

#include <functional>
#include <utility>
#include <vector>

namespace lamella
{
  /// Integration along the axis of a beam by sum factorization. With nodal DoFs
  /// u_(i,alpha) of section functions alpha and shape functions N_i of axis
  /// nodes, amplitudes at an integration point (station) of an element,
  ///   q_alpha = sum_i N_i u_(i,alpha),   q_alpha' = sum_i N_i' u_(i,alpha),
  /// determine section forces W_0 (conjugate to q) and W_1 (to q') and nodal
  /// forces
  ///   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy.
  /// The functions of an element are all functions of its nodes; an amplitude
  /// that a node lacks is zero. Each process integrates the elements
  /// Axis::own_cells(). Keeps references to the arguments of its constructor.
  class AxisLoop
  {
  public:
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

    /// Returns this process's first integration point, and one past the last.
    std::pair<unsigned int, unsigned int>
    own_points() const;

    /// Calls @p use with the index of each axis element of this process and the
    /// section operator for its functions.
    using ElementCallback =
      std::function<void(const unsigned int, const SectionOperator &)>;
    void
    for_each_element(const ElementCallback &use) const;

    /// Returns the amplitudes q and q' of the section functions @p fields in
    /// the displacement @p u at @p stations of one element. Derivatives use
    /// differences to the first node and vanish exactly for rigid translations.
    FieldParts
    at(const dealii::ArrayView<const AxisPoint> &stations,
       const std::vector<unsigned int>          &fields,
       const Vector                             &u) const;

    /// Returns at() for all integration points of the axis element @p cell.
    FieldParts
    on_element(const unsigned int               cell,
               const std::vector<unsigned int> &fields,
               const Vector                    &u) const;

    /// Adds the nodal forces of all elements to @p f. @p forces_of returns the
    /// section forces W at the stations of an element. Collective.
    using ForcesOfElement =
      std::function<SectionForces(const unsigned int, const SectionOperator &)>;
    void
    add_forces(const ForcesOfElement &forces_of, Vector &f) const;

    /// Returns the integral of the energy per length in @p forces over the axis
    /// element @p cell [force length].
    double
    energy(const unsigned int cell, const SectionForces &forces) const;

  private:
    std::vector<unsigned int>
    fields_of_element(const unsigned int cell) const;

    /// Adds the nodal forces of section forces @p work on the element @p cell.
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
