// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_h
#define lamella_body_beam_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_dof_map.h>
#include <lamella/body/body.h>
#include <lamella/body/placement.h>
#include <lamella/section/section.h>

namespace lamella
{
  /**
   * A beam in the Carrera Unified Formulation: a section times an axis,
   *   u(x, y, z) = sum N_i(y) Phi_alpha(x, z) u_(i,alpha)     (Eqs. 1 and 7),
   * with the stiffness of Eq. 12 as a sum of Kronecker products,
   *   K = A_NN (x) S_00 + A_NdN (x) S_01 + A_dNN (x) S_10 + A_dNdN (x) S_11
   * (and, where transverse shear strains are assumed, (A_shear - A_NN) (x)
   * S_shear). EBBT is TBT with Kirchhoff's constraint on each element.
   *
   * An element of the beam, a "cell" in Location, is the product of an axis
   * element and a section cell, numbered
   * axis element * (number of section cells) + section cell; its unit
   * coordinates are (xi, place along the axis element, eta).
   */
  class Beam : public Body
  {
  public:
    /// Every axis node carries all fields of the section.
    Beam(const std::string             &name,
         std::shared_ptr<const Section> section,
         std::shared_ptr<const Axis>    axis,
         const Placement               &placement);

    /// Node-dependent kinematics: @p fields_of_node as in BeamDofMap.
    Beam(const std::string                            &name,
         std::shared_ptr<const Section>                section,
         std::shared_ptr<const Axis>                   axis,
         const Placement                              &placement,
         const std::vector<std::vector<unsigned int>> &fields_of_node);

    std::string
    theory() const override;
    DofIndex
    n_dofs() const override
    {
      return dof_map.n_dofs();
    }
    double
    stiffness_entries() const override;
    dealii::IndexSet
    owned_dofs() const override;
    unsigned int
    dof_level(const DofIndex dof) const override;
    dealii::Point<3>
    dof_position(const DofIndex dof) const override;
    const Constraints &
    kinematic_constraints() const override
    {
      return kirchhoff;
    }
    std::vector<Vector>
    rigid_motions() const override;
    std::vector<RigidMotion>
    missing_motions() const override;
    dealii::Point<3>
    centre() const override;
    double
    size() const override;
    dealii::BoundingBox<3>
    bounding_box() const override;

    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    Deformation
    deformation(const Vector &u) const override;

    std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const override;
    std::vector<std::vector<Row>>
    rows(const std::vector<Location> &locations,
         const Quantity               quantity,
         const Frame                  frame = Frame::scene) const override;
    FieldSample
    sample(const Location &location, const Vector &u) const override;
    dealii::Point<3>
    position(const Location::Place &place) const override;
    std::array<unsigned int, 3>
    recovery_degrees() const override;

    std::vector<std::string>
    surfaces() const override;
    std::vector<SurfacePoint>
    surface_points(const std::string &surface) const override;
    std::vector<Location>
    fixing_points(const std::string &surface) const override;
    std::vector<Location>
    body_points() const override;
    std::vector<SurfaceFacet>
    surface_facets(const std::string &surface) const override;
    SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const override;
    std::vector<double>
    line_breaks(const dealii::Point<3> &a,
                const dealii::Point<3> &b) const override;
    unsigned int
    degree() const override;
    unsigned int
    line_degree(const dealii::Point<3> &a,
                const dealii::Point<3> &b) const override;

    std::vector<OutputCell>
    cut(const double       position,
        const unsigned int n,
        const Vector      &u) const override;
    std::vector<OutputCell>
    output_cells(const unsigned int n, const Vector &u) const override;

    const Section &
    section() const
    {
      return *beam_section;
    }
    const Axis &
    axis() const
    {
      return *beam_axis;
    }
    const BeamDofMap &
    dofs() const
    {
      return dof_map;
    }

  protected:
    void
    for_each_stiffness_block(
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /**
     * Makes w' and the rotation cancel on every element. With B4 the cubic w of
     * an element is then fixed by w and the rotation at its two ends (Hermite's
     * polynomials), and so are both at the two nodes inside:
     *   w = H_0 w_0 + H_2 w_1 - L/h (H_1 a_0 + H_3 a_1),   a = -h w',
     * where u_y = a (z - z_c) / h.
     */
    void
    constrain_to_kirchhoff();

    /// The fields' coefficients and their derivatives along y at a point of the
    /// axis: for each alpha sum_i N_i u_(i,alpha), the same with what stands
    /// for N_i in transverse shear, and sum_i N_i' u_(i,alpha).
    struct AxisState
    {
      std::vector<double> value, shear_value, derivative;

      explicit AxisState(const unsigned int n_fields)
        : value(n_fields, 0.)
        , shear_value(n_fields, 0.)
        , derivative(n_fields, 0.)
      {}
    };

    AxisState
    axis_state(const AxisPoint &point, const Vector &u) const;

    /// The integration points along the axis that are this process's, first and
    /// one past the last.
    std::pair<unsigned int, unsigned int>
    own_points() const;

    /// What the section answers at a point of the axis: the forces that do work
    /// on each field's value, in transverse shear and else, and on its
    /// derivative, and the strain energy per length.
    struct SectionForce
    {
      std::array<Vector, 3> work;
      double                energy = 0.;
    };

    /// Calls @p use with the section force at each of own_points(), from the
    /// moments of a section that spans_the_section(). Strains come first here,
    /// too: those of whole fields in place of those at points.
    void
    for_each_section_force(
      const Vector                                                        &u,
      const std::function<void(const unsigned int, const SectionForce &)> &use)
      const;

    /// The two ways of add_internal_forces(), this process' share.
    void
    add_forces_by_moments(const Vector &u, Vector &share) const;
    void
    add_forces_by_points(const Vector &u, Vector &share) const;

    /// Displacement, strain and stress in the body frame.
    struct PointState
    {
      dealii::Tensor<1, 3> displacement, slope;
      Voigt                strain;
      double               twist = 0.;
    };

    static PointState
    point_state(const SectionPoint &point, const AxisState &state);

    /// The body frame's fields in scene and ply axes.
    FieldSample
    field_sample(const PointState &state, const unsigned int cell) const;

    /// The elements of one axis element with n x m x n grids of samples, m = n
    /// or, for a cut, one layer at @p eta.
    std::vector<OutputCell>
    sample_axis_cell(const unsigned int         axis_cell,
                     const std::vector<double> &etas,
                     const unsigned int         n,
                     const Vector              &u) const;

    Location
    location(const dealii::Point<3> &position,
             const unsigned int      axis_cell,
             const double            eta,
             const unsigned int      section_cell,
             const dealii::Point<2> &unit) const;

    SurfacePoint
    lateral_point(const EdgePoint   &edge,
                  const double       weight,
                  const unsigned int axis_cell,
                  const double       eta) const;

    SurfacePoint
    end_point(const EdgePoint &point, const bool at_start) const;

    /// The facet whose unit square @p facet maps to, its corners and degrees.
    void
    complete(SurfaceFacet &facet) const;

    std::shared_ptr<const Section> beam_section;
    std::shared_ptr<const Axis>    beam_axis;
    Placement                      placement;
    BeamDofMap                     dof_map;
    Constraints                    kirchhoff;
  };
} // namespace lamella

#endif
