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
  /// The integral over a beam's axis by sum factorization. On each element, the
  /// coefficients of the fields at its integration points (stations),
  ///   q_alpha = sum_i N_i u_(i,alpha),   q_alpha' = sum_i N_i' u_(i,alpha),
  /// give section forces W, which act on the element's nodes as
  ///   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy.
  /// An element has the fields that any of its nodes carries, zero at the
  /// others. Each process has the elements Axis::own_cells(). Refers to the
  /// space, the axis and the DoF map.
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

    /// Returns this process's integration points, first and one past the last.
    unsigned int
    n_stations() const
    {
      return axis.integration_points().size() / axis.n_cells();
    }

    /// Returns this process's integration points, first and one past last.
    std::pair<unsigned int, unsigned int>
    own_points() const;

    /// Calls @p use with each own axis element and the section's operator for
    /// its fields, which consecutive elements with the same fields share.
    using ElementCallback =
      std::function<void(const unsigned int, const SectionOperator &)>;
    void
    for_each_element(const ElementCallback &use) const;

    /// Returns the parts of the displacement @p u for the fields @p fields at
    /// @p stations of one element. Derivatives use differences to the element's
    /// first node, so that they vanish exactly for rigid translations.
    FieldParts
    at(const dealii::ArrayView<const AxisPoint> &stations,
       const std::vector<unsigned int>          &fields,
       const Vector                             &u) const;

    /// Returns at() for the integration points of the element @p cell.
    FieldParts
    on_element(const unsigned int               cell,
               const std::vector<unsigned int> &fields,
               const Vector                    &u) const;

    /// Adds the nodal forces of all elements to @p f, which has all DoFs.
    /// @p forces_of returns those at the stations of an element on the fields
    /// of its operator. Collective.
    using ForcesOfElement =
      std::function<SectionForces(const unsigned int, const SectionOperator &)>;
    void
    add_forces(const ForcesOfElement &forces_of, Vector &f) const;

    /// Returns the energy of @p forces over the element @p cell [force length].
    double
    energy(const unsigned int cell, const SectionForces &forces) const;

  private:
    std::vector<unsigned int>
    fields_of_element(const unsigned int cell) const;

    /// Adds @p work to the DoFs of @p cell: the integrated on_element()^T.
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
