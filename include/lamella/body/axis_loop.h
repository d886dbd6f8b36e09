// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_axis_loop_h
#define lamella_body_axis_loop_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_dof_map.h>
#include <lamella/section/section_answer.h>

#include <deal.II/base/array_view.h>

#include <functional>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The integral over a beam's axis, by sum factorisation: on each element the
   * coefficients of the fields at its integration points, its stations,
   *   q_alpha = sum_i N_i u_(i,alpha),   q_alpha' = sum_i N_i' u_(i,alpha),
   * then what acts on the fields there, the section's answer or anything else,
   * and what that does to the element's nodes,
   *   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy.
   * Whatever a beam integrates along its axis is one call of it.
   *
   * An element has the fields that any of its nodes carries; those that a node
   * does not carry are zero there. In several processes each has the elements
   * Axis::own_cells(). Refers to the space, the axis and the DoF map of a beam.
   */
  class AxisLoop
  {
  public:
    AxisLoop(const FieldSpace &space,
             const Axis       &axis,
             const BeamDofMap &dof_map)
      : space(space)
      , axis(axis)
      , dof_map(dof_map)
    {}

    /// The integration points of an element of the axis.
    unsigned int
    n_stations() const
    {
      return axis.integration_points().size() / axis.n_cells();
    }

    /// The integration points along the axis that are this process's, first and
    /// one past the last.
    std::pair<unsigned int, unsigned int>
    own_points() const;

    /// Calls @p use with each own element of the axis and what the section
    /// answers to its fields. Elements in a row with the same fields have the
    /// same answer, which lives no longer.
    using UseOfElement =
      std::function<void(const unsigned int, const SectionAnswer &)>;
    void
    for_each_element(const UseOfElement &use) const;

    /// What the displacement @p u gives the fields @p fields at @p stations of
    /// one element. Derivatives are taken of the differences to the element's
    /// first node: a rigid translation has none, to the last bit.
    FieldParts
    at(const dealii::ArrayView<const AxisPoint> &stations,
       const std::vector<unsigned int>          &fields,
       const Vector                             &u) const;

    /// That at the integration points of the element @p cell.
    FieldParts
    on_element(const unsigned int               cell,
               const std::vector<unsigned int> &fields,
               const Vector                    &u) const;

    /// Adds to @p f, which has all DoFs, what the forces of all elements come
    /// to: @p forces_of returns those at the stations of an element, on the
    /// fields of the answer that it is given. Collective.
    using ForcesOfElement =
      std::function<SectionForces(const unsigned int, const SectionAnswer &)>;
    void
    add_forces(const ForcesOfElement &forces_of, Vector &f) const;

    /// The integral of the energy @p forces has over the element @p cell
    /// [force length].
    double
    energy(const unsigned int cell, const SectionForces &forces) const;

  private:
    std::vector<unsigned int>
    fields_of_element(const unsigned int cell) const;

    /// The transpose of on_element(), integrated: adds what @p work does to the
    /// DoFs of the nodes of @p cell.
    void
    add_on_nodes(const unsigned int               cell,
                 const std::vector<unsigned int> &fields,
                 const FieldParts                &work,
                 Vector                          &f) const;

    const FieldSpace &space;
    const Axis       &axis;
    const BeamDofMap &dof_map;
  };
} // namespace lamella

#endif
