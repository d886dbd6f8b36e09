// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_geometrically_exact_beam_h
#define lamella_body_geometrically_exact_beam_h

#include <lamella/body/beam.h>
#include <lamella/body/frame_strains.h>
#include <lamella/section/twist_stretch.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace lamella
{
  /**
   * A geometrically exact beam: finite rotations of sections, small strains and
   * small warping. With the displacement r(y) of the center X_c of a section,
   * its rotation R(y) and amplitudes a(y) of the warping functions Phi (section
   * functions that are not rigid motions),
   *   x = X_c + r + R (X - X_c + Phi a).
   * Strains in section axes are linear in the generalized strains
   *   e = (Gamma, kappa, kappa_y^2 / 2, a, a')                 (FrameStrains),
   * (shears and stretch Gamma, curvatures and twist kappa), so the section
   * forces s = D e have a constant matrix D, computed as for Beam. With
   * Saint-Venant's warping functions this is Simo's beam with the exact section
   * stiffness. Terms of kappa_y^2 / 2 are Wagner's stiffening of twisted strips
   * (TwistStretch). Flattening of bent tubes and wide strips is neglected;
   * Deformation::shape_change measures it.
   *
   * In a displacement vector u, the DoFs of a node are r, its rotation vector
   * (angle 0 to pi), scaled as in RigidField, and a. In increments du and in
   * forces, rotational DoFs are spins about body axes, which retract() adds to
   * u. Rows of displacements depend on u (rows_at()).
   *
   * Quaternions of nodes are interpolated along an element. Reduced integration
   * with one Gauss point fewer than nodes avoids shear locking.
   *
   * EBBT, whose sections stay normal to the axis, is TBT with a shear stiffness
   * of 10^4 times the axial stiffness. If the theory has no twist, rotations
   * are limited to one plane.
   */
  class GeometricallyExactBeam : public Beam
  {
  public:
    /// Constructs a beam with all functions of @p section, that of
    /// Theory::of_rotating(), at all nodes. Sections stay normal to the axis if
    /// @p keeps_normal. theory() returns @p theory, if not empty.
    GeometricallyExactBeam(const std::string             &name,
                           std::shared_ptr<const Section> section,
                           std::shared_ptr<const Axis>    axis,
                           const Placement               &placement,
                           const std::string             &theory       = "",
                           const bool                     keeps_normal = false);

    /// Constructs a node-dependent beam as Beam does. Throws InputError if a
    /// node's list does not have dense section matrices (SectionSpace).
    GeometricallyExactBeam(
      const std::string                            &name,
      std::shared_ptr<const SectionSpace>           space,
      std::shared_ptr<const Axis>                   axis,
      const Placement                              &placement,
      const std::vector<std::vector<unsigned int>> &fields_of_node,
      const std::string                            &theory,
      const bool                                    keeps_normal = false);

    bool
    has_finite_rotations() const override
    {
      return true;
    }
    bool
    constraints_rotate() const override
    {
      return true;
    }
    /// Returns @p u updated by @p change. Throws NumericsError if sections
    /// would twist although the theory has no twist.
    Vector
    retract(const Vector &u, const Vector &change) const override;
    double
    largest_spin(const Vector &change) const override;
    std::vector<Vector>
    rigid_motions_at(const Vector &u) const override;
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    Deformation
    deformation(const Vector &u) const override;
    void
    add_thermal_load_at(const Vector &u, Vector &f) const override;
    void
    for_each_thermal_block(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const override;
    dealii::Tensor<2, 3>
    rotation_at(const Location &location, const Vector &u) const override;
    std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const override;
    std::vector<std::vector<LinearFunctional>>
    rows_at(const std::vector<Location> &locations,
            const Vector                &u) const override;
    void
    for_each_block_of_forces(
      const std::vector<Location>                       &locations,
      const std::vector<dealii::Tensor<1, 3>>           &forces,
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  protected:
    FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const override;
    std::vector<FieldSample>
    samples_at(const std::vector<SectionPoint> &points,
               const std::vector<AxisPoint>    &places,
               const Vector                    &u) const override;
    /// Calls @p use with one block per axis element of this process.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /// Section stiffness D of an axis element, with the section functions of
    /// the element, m of which are warping functions.
    struct Law
    {
      std::vector<unsigned int> fields, warpings;
      /// Square matrix of 7 + 2 m rows, in the order of e.
      dealii::LAPACKFullMatrix<double> D;
    };

    /// Nodal values of an axis element.
    struct Element
    {
      /// Unit quaternions, with signs such that products with q[0] are >= 0.
      std::vector<Quaternion>           q;
      std::vector<dealii::Tensor<1, 3>> r;
      /// Amplitudes a of Law::warpings.
      std::vector<std::vector<double>> a;
    };

    /// Interpolated values at a point of the axis, and derivatives along y.
    struct Frame
    {
      Quaternion           Q, dQ;
      dealii::Tensor<1, 3> r, dr;
      std::vector<double>  a, da;
    };

    /// Integration point of an axis element and its weight [length].
    struct Station
    {
      AxisPoint point;
      double    weight = 0.;
    };

    /// A local unknown of an element, which are r, spin and a of each node. The
    /// global DoF, if it exists, is `factor` times the local unknown.
    struct LocalDof
    {
      DofIndex dof    = dealii::numbers::invalid_dof_index;
      double   factor = 1.;

      bool
      exists() const
      {
        return dof != dealii::numbers::invalid_dof_index;
      }
    };

    /// Numbers of FrameStrains, and of components of r and spin of a node.
    static constexpr unsigned int n_strains       = 7,
                                  n_node_unknowns = RigidField::n_all;
    using OfFrame = std::array<double, n_strains>;

    /// Derivatives of (Q, Q', r') by r and the spin of a node.
    using ByNode = std::array<dealii::Tensor<1, 6>, 11>;

    /// A point of a section with the values of warping functions.
    struct PointFields
    {
      AxisPoint on_axis;
      /// Position from the center of the section.
      dealii::Tensor<1, 3> X;
      /// Values of the functions Law::warpings.
      std::vector<dealii::Tensor<1, 3>> Phi;
    };

    void
    make_stations();
    void
    make_laws(const bool keeps_normal);
    std::shared_ptr<Law>
    make_law(const SectionOperator &section_operator) const;
    /// Sets the row and the column of D for the strain kappa_y^2 / 2.
    void
    add_twist_stretch(Law &law) const;

    /// Returns the number of section functions that are rigid motions.
    unsigned int
    n_rigid() const
    {
      return std::min<unsigned int>(n_node_unknowns, section().n_fields());
    }

    /// Returns section forces conjugate to e from @p work, forces on section
    /// functions @p list, at station @p k; zero for kappa_y^2 / 2.
    std::vector<double>
    on_strains(const std::vector<unsigned int> &list,
               const FieldParts                &work,
               const unsigned int               k) const;

    /// Returns the thermal section forces, those of C epsilon_0, at the
    /// stations of the axis element @p cell.
    std::vector<Vector>
    thermal_stresses(const unsigned int cell) const;
    /// Returns the thermal section force conjugate to kappa_y^2 / 2 at @p
    /// places, axial positions y.
    std::vector<double>
    thermal_stress_on_twist(const std::vector<double> &places) const;

    /// Returns the strain at @p point of the section for kappa_y^2 / 2 = 1.
    Voigt
    twist_strain(const SectionPoint &point) const;

    /// Returns the rotational DoFs of @p node in @p u, without scaling.
    dealii::Tensor<1, 3>
    rotation(const unsigned int node, const Vector &u) const;

    Element
    element(const unsigned int cell, const Vector &u) const;
    static Frame
    frame_at(const AxisPoint &point, const Element &element);
    /// Return the generalized strains e of @p frame.
    static std::vector<double>
    strains(const Frame &frame, const FrameStrains &of);
    static std::vector<double>
    strains(const Frame &frame);
    /// Returns the section forces D e.
    static Vector
    stresses(const Law &law, const std::vector<double> &e);

    std::vector<LocalDof>
    local_dofs(const unsigned int cell) const;
    /// Adds the local forces of an element to the global vector @p f.
    static void
    add_local(const std::vector<LocalDof> &dofs,
              const std::vector<double>   &local,
              Vector                      &f);
    /// Returns the element matrix @p local as a block (no values if empty).
    static StiffnessBlock
    block_of(const std::vector<LocalDof>            &dofs,
             const dealii::LAPACKFullMatrix<double> &local);
    static ByNode
    by_node(const Element     &element,
            const AxisPoint   &point,
            const unsigned int i);

    /// Adds the local forces of the section forces @p s at @p station to @p f.
    static void
    add_forces(const Station       &station,
               const Element       &element,
               const Vector        &s,
               std::vector<double> &f);

    /// Returns the section forces (of the seven FrameStrains) predicted by
    /// linearization at the values @p before for the increment @p change
    /// (Magisano, Leonetti and Garcea).
    static OfFrame
    predicted(const Station             &station,
              const Law                 &law,
              const Element             &before,
              const std::vector<double> &change);
    /// Add contributions of a station to the tangent @p K of an element: all;
    /// those of (Q, Q', r') with section forces @p s and the second derivative
    /// @p by_measures of the energy; rows and columns of r and spins with those
    /// of node @p j; those of r and spins with a warping amplitude. A node has
    /// @p n unknowns.
    static void
    add_frame_tangent(const Station                    &station,
                      const Law                        &law,
                      const Element                    &element,
                      const OfFrame                    &s,
                      dealii::LAPACKFullMatrix<double> &K);
    static void
    add_stress_tangent(const Station                    &station,
                       const Element                    &element,
                       const FrameStrains               &of,
                       const std::vector<ByNode>        &by,
                       const OfFrame                    &s,
                       dealii::Tensor<2, 11>             by_measures,
                       dealii::LAPACKFullMatrix<double> &K);
    /// Returns by_node() of all nodes at @p station.
    static std::vector<ByNode>
    by_nodes(const Station &station, const Element &element);
    /// Returns the diagonal term of a spin in the tangent due to the second
    /// derivative of a unit quaternion @p q by the spin, with the derivative @p
    /// by_q of the energy by q.
    static double
    along_geodesic(const Quaternion &by_q, const Quaternion &q)
    {
      return -(by_q * q) / 4.;
    }
    /// Returns the material part of the energy's second derivative by (Q, Q',
    /// r').
    static dealii::Tensor<2, 11>
    square_of_strains(const Law &law, const FrameStrains &of);
    static void
    add_rigid_tangent(const dealii::Tensor<2, 11>      &by_measures,
                      const std::vector<ByNode>        &by,
                      const unsigned int                j,
                      const unsigned int                n,
                      dealii::LAPACKFullMatrix<double> &K);
    static void
    add_coupling(const dealii::Tensor<1, 11>      &coupled,
                 const std::vector<ByNode>        &by,
                 const std::vector<double>        &N,
                 const unsigned int                warping,
                 const unsigned int                n,
                 dealii::LAPACKFullMatrix<double> &K);
    void
    add_warping_tangent(const unsigned int                cell,
                        dealii::LAPACKFullMatrix<double> &K) const;

    /// Generalized strains and amplitudes of a section, for output.
    struct SectionState
    {
      Frame frame;
      /// Strains e, and the amplitudes q and q' of section functions of a Beam
      /// that have the same strains.
      std::vector<double> e, value, derivative;
      /// Amplitudes of the warping displacements.
      std::vector<double> warping;
    };
    /// Return strains and amplitudes of a section of the axis element @p cell.
    SectionState
    section_state(const unsigned int cell, const Frame &frame) const;
    SectionState
    section_state(const AxisPoint &on_axis, const Vector &u) const;
    /// Returns section_state() with strains interpolated between stations.
    SectionState
    output_state(const AxisPoint &on_axis, const Vector &u) const;

    PointFields
    fields_at(const Location::Place &place) const;
    /// Returns the position of @p point from the center of the section.
    dealii::Tensor<1, 3>
    from_center(const SectionPoint &point) const;
    /// Returns the warping displacement Phi a at @p at, in section axes.
    static dealii::Tensor<1, 3>
    warping(const PointFields &at, const Frame &frame);
    /// Returns the displacement of @p point, in body axes.
    dealii::Tensor<1, 3>
    displacement(const SectionPoint &point, const SectionState &state) const;
    /// Returns displacement, strain and stress at @p point of a section.
    FieldSample
    sample_of_section(const SectionPoint &point,
                      const double        y,
                      const SectionState &state) const;
    /// Returns R (X + Phi a) at @p at, and its derivatives.
    static RotatedVector
    rotated_point(const PointFields &at, const Frame &frame);
    /// Returns the derivatives of the displacement at @p at (body axes) by the
    /// local unknowns of the element.
    static std::vector<dealii::Tensor<1, 3>>
    by_local(const PointFields &at, const Element &element);
    /// Adds @p share times the rows of the displacement at @p place to @p rows.
    void
    add_rows(const Location::Place         &place,
             const double                   share,
             const Vector                  &u,
             std::vector<LinearFunctional> &rows) const;
    /// Adds to @p K the derivative by local unknowns of the generalized forces
    /// of the point force @p force at @p at.
    static void
    add_force(const PointFields                &at,
              const dealii::Tensor<1, 3>       &force,
              const Element                    &element,
              dealii::LAPACKFullMatrix<double> &K);

    /// Adds the row of add_force() for the spin component @p spin; @p row has
    /// its derivatives by Q and by the rotated vector.
    static void
    add_force_row(const PointFields                &at,
                  const Element                    &element,
                  const dealii::Tensor<1, 7>       &row,
                  const unsigned int                spin,
                  dealii::LAPACKFullMatrix<double> &K);

    /// Updates the maxima in @p deformation by the strains of a section.
    void
    add_strains(const SectionState &state, Deformation &deformation) const;

    /// Returns the strain at @p point of a section, in section axes.
    Voigt
    strain_at(const SectionPoint &point, const SectionState &state) const;

    /// Reference length of the section.
    double h;
    /// The section, or an LE-2 section of its mesh if section() is rigid.
    std::shared_ptr<const Section>      deformable_section;
    std::unique_ptr<const TwistStretch> twist_stretch;
    /// Result of stiffening_by_shape() without the terms that D contains.
    std::array<double, 3>                   stiffening;
    std::vector<std::vector<Station>>       stations;
    std::vector<std::shared_ptr<const Law>> laws;
  };
} // namespace lamella

#endif
