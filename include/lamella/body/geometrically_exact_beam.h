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
   * A beam with finite rotations of its sections and small warping. With r(y)
   * the displacement of the section's center, R(y) its rotation and a the
   * amplitudes of the fields that are no rigid motions,
   *   x = X_c + r + R (X - X_c + Phi a).
   * Strains are small in section axes and linear in
   *   e = (Gamma, kappa, kappa_y^2 / 2, a, a')                 (FrameStrains),
   * so the stresses s = D e have a constant matrix D, that of a Beam
   * (SectionOperator). With Saint-Venant's fields this is Simo's beam with the
   * section's stiffness, including warping in shear and torsion, Poisson's
   * effect and couplings of a layup. TwistStretch gives the terms of kappa_y^2
   * / 2, Wagner's stiffening of a twisted strip. Other quadratic strains
   * (flattening of bent tubes and wide strips) are neglected;
   * Deformation::shape_change measures them.
   *
   * In a state u the rigid fields of a node are its r and its rotation vector,
   * of angle 0 to pi, scaled as for small rotations (RigidField). In changes du
   * and in forces they are spins on top of the state, about body axes;
   * retract() combines both. Rows depend on the state (rows_at()), at u = 0 a
   * Beam's.
   *
   * Quaternions of nodes are interpolated along an element. Integrals use one
   * Gauss point fewer than nodes, which does not lock at any slenderness. (One
   * more for the terms of a and a' doubles the number of elements needed if
   * warping is constrained.)
   *
   * Sections that stay normal to the axis (EBBT) are those of TBT with 10^4
   * times the axial stiffness against shear, which leaves a share (h / L)^2 of
   * 1e-5 of the deflection. A section that cannot twist rotates in one plane.
   */
  class GeometricallyExactBeam : public Beam
  {
  public:
    /// Constructs a beam whose nodes all carry all fields of @p section, that
    /// of Theory::of_rotating(). theory() returns @p theory, if not empty.
    GeometricallyExactBeam(const std::string             &name,
                           std::shared_ptr<const Section> section,
                           std::shared_ptr<const Axis>    axis,
                           const Placement               &placement,
                           const std::string             &theory       = "",
                           const bool                     keeps_normal = false);

    /// Constructs a beam as Beam does. Throws InputError for lists not dense.
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
    /// Returns the state. Throws NumericsError if a rigid section would twist.
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
    /// Calls @p use with a block for each own element of the axis.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /// Section law D of an axis element: its fields, among them m warpings.
    struct Law
    {
      std::vector<unsigned int> fields, warpings;
      /// Square matrix of 7 + 2 m rows in the order of e.
      dealii::LAPACKFullMatrix<double> D;
    };

    /// State of an element of the axis, node by node.
    struct Element
    {
      /// Quaternions, signs by a nonnegative product with the first.
      std::vector<Quaternion>           q;
      std::vector<dealii::Tensor<1, 3>> r;
      /// Amplitudes of Law::warpings.
      std::vector<std::vector<double>> a;
    };

    /// State at a point of the axis.
    struct Frame
    {
      Quaternion           Q, dQ;
      dealii::Tensor<1, 3> r, dr;
      std::vector<double>  a, da;
    };

    /// Integration point of an element.
    struct Station
    {
      AxisPoint point;
      double    weight = 0.;
    };

    /// A local unknown of an element, node after node its r, spin and warpings.
    /// The DoF, if any, is `factor` times it.
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

    /// Numbers of FrameStrains, and of r and the spin of a node.
    static constexpr unsigned int n_strains       = 7,
                                  n_node_unknowns = RigidField::n_all;
    using OfFrame = std::array<double, n_strains>;

    /// Derivative of (Q, Q', r') by r and the spin of a node.
    using ByNode = std::array<dealii::Tensor<1, 6>, 11>;

    /// A point of the section with the fields of an element there.
    struct PointFields
    {
      AxisPoint on_axis;
      /// Position from the center of the section.
      dealii::Tensor<1, 3> X;
      /// Values of Law::warpings.
      std::vector<dealii::Tensor<1, 3>> Phi;
    };

    void
    make_stations();
    void
    make_laws(const bool keeps_normal);
    std::shared_ptr<Law>
    make_law(const SectionOperator &section_operator) const;
    /// Sets the row and the column of kappa_y^2 / 2.
    void
    add_twist_stretch(Law &law) const;

    /// Returns the number of the section's first fields, which are no warpings.
    unsigned int
    n_rigid() const
    {
      return std::min<unsigned int>(n_node_unknowns, section().n_fields());
    }

    /// Returns the stresses on e of the @p work on the fields @p list at
    /// station @p k, without that on kappa_y^2 / 2.
    std::vector<double>
    on_strains(const std::vector<unsigned int> &list,
               const FieldParts                &work,
               const unsigned int               k) const;

    /// Returns the stresses on e of C epsilon_0 at the stations of @p cell.
    std::vector<Vector>
    thermal_stresses(const unsigned int cell) const;
    /// Returns the heat stresses on kappa_y^2 / 2 at @p places on the axis.
    std::vector<double>
    thermal_stress_on_twist(const std::vector<double> &places) const;

    /// Returns the strain of kappa_y^2 / 2 = 1 at @p point of the section.
    Voigt
    twist_strain(const SectionPoint &point) const;

    /// Returns the rotation vector of @p node in a state, its spin in a change.
    dealii::Tensor<1, 3>
    rotation(const unsigned int node, const Vector &u) const;

    Element
    element(const unsigned int cell, const Vector &u) const;
    static Frame
    frame_at(const AxisPoint &point, const Element &element);
    /// Return e at a point.
    static std::vector<double>
    strains(const Frame &frame, const FrameStrains &of);
    static std::vector<double>
    strains(const Frame &frame);
    /// Returns D e.
    static Vector
    stresses(const Law &law, const std::vector<double> &e);

    std::vector<LocalDof>
    local_dofs(const unsigned int cell) const;
    /// Adds the forces @p local to @p f.
    static void
    add_local(const std::vector<LocalDof> &dofs,
              const std::vector<double>   &local,
              Vector                      &f);
    /// Returns the block of @p local; without values if it is empty.
    static StiffnessBlock
    block_of(const std::vector<LocalDof>            &dofs,
             const dealii::LAPACKFullMatrix<double> &local);
    static ByNode
    by_node(const Element     &element,
            const AxisPoint   &point,
            const unsigned int i);

    /// Adds the forces of the stresses @p s on e at @p station to @p f.
    static void
    add_forces(const Station       &station,
               const Element       &element,
               const Vector        &s,
               std::vector<double> &f);

    /// Returns the frame's stresses that the linearization at @p before
    /// predicts for @p change (Magisano, Leonetti and Garcea).
    static OfFrame
    predicted(const Station             &station,
              const Law                 &law,
              const Element             &before,
              const std::vector<double> &change);
    /// Add to the local matrix @p K, with @p n numbers per node: the tangent of
    /// a station with the frame's stresses @p s; their geometric part and the
    /// second derivative @p by_measures of the energy by (Q, Q', r'); the
    /// products of r and spins with those of node @p j; those with a warping.
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
    /// Returns the contribution to a spin's diagonal of the second derivative
    /// of a unit quaternion @p q, with the energy's derivative @p by_q.
    static double
    along_geodesic(const Quaternion &by_q, const Quaternion &q)
    {
      return -(by_q * q) / 4.;
    }
    /// Returns the second derivative of the energy of the frame's strains by
    /// (Q, Q', r') without stresses.
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

    /// State of a section.
    struct SectionState
    {
      Frame frame;
      /// Strains e, and values and axial derivatives that they give each field.
      std::vector<double> e, value, derivative;
      /// Coefficients of the warping displacements.
      std::vector<double> warping;
    };
    /// Return the state of a section of the element @p cell.
    SectionState
    section_state(const unsigned int cell, const Frame &frame) const;
    SectionState
    section_state(const AxisPoint &on_axis, const Vector &u) const;
    /// Returns the state for samples, strains interpolated between stations.
    SectionState
    output_state(const AxisPoint &on_axis, const Vector &u) const;

    PointFields
    fields_at(const Location::Place &place) const;
    /// Returns X of PointFields.
    dealii::Tensor<1, 3>
    from_center(const SectionPoint &point) const;
    /// Returns Phi a at @p at, in body axes.
    static dealii::Tensor<1, 3>
    warping(const PointFields &at, const Frame &frame);
    /// Returns the displacement of @p point, in body axes.
    dealii::Tensor<1, 3>
    displacement(const SectionPoint &point, const SectionState &state) const;
    /// Returns the sample of @p point of a section at @p y in @p state.
    FieldSample
    sample_of_section(const SectionPoint &point,
                      const double        y,
                      const SectionState &state) const;
    /// Returns R (X + Phi a) at @p at.
    static RotatedVector
    rotated_point(const PointFields &at, const Frame &frame);
    /// Returns the displacement at @p at (body axes) per unit of each unknown.
    static std::vector<dealii::Tensor<1, 3>>
    by_local(const PointFields &at, const Element &element);
    /// Adds @p share of the rows of the displacement at @p place to @p rows.
    void
    add_rows(const Location::Place         &place,
             const double                   share,
             const Vector                  &u,
             std::vector<LinearFunctional> &rows) const;
    /// Adds to @p K the derivative of the work of @p force at @p at.
    static void
    add_force(const PointFields                &at,
              const dealii::Tensor<1, 3>       &force,
              const Element                    &element,
              dealii::LAPACKFullMatrix<double> &K);

    /// Adds the part of add_force() of the spin number @p spin, with @p row its
    /// derivatives by Q and by the rotated vector.
    static void
    add_force_row(const PointFields                &at,
                  const Element                    &element,
                  const dealii::Tensor<1, 7>       &row,
                  const unsigned int                spin,
                  dealii::LAPACKFullMatrix<double> &K);

    /// Adds the strains of a section in @p state to @p deformation.
    void
    add_strains(const SectionState &state, Deformation &deformation) const;

    /// Returns the strain at @p point of a section in @p state, section axes.
    Voigt
    strain_at(const SectionPoint &point, const SectionState &state) const;

    /// Reference length of the section.
    double h;
    /// The section, or an LE-2 section of its mesh if it is rigid.
    std::shared_ptr<const Section>      deformable_section;
    std::unique_ptr<const TwistStretch> twist_stretch;
    /// Result of stiffening_by_shape() less the part in the law.
    std::array<double, 3>                   stiffening;
    std::vector<std::vector<Station>>       stations;
    std::vector<std::shared_ptr<const Law>> laws;
  };
} // namespace lamella

#endif
