// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_geometrically_exact_beam_h
#define lamella_body_geometrically_exact_beam_h

#include <lamella/body/beam.h>
#include <lamella/body/frame_strains.h>
#include <lamella/section/saint_venant.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace lamella
{
  /// A geometrically exact beam: finite rotations of its sections, small
  /// strains and small warping. A point X of a section with center X_c moves to
  ///   x = X_c + r + R (X - X_c + Phi a)
  /// with the displacement r(y) of the center, the rotation R(y) of the
  /// section, and the amplitudes a(y) of its warping functions Phi. In section
  /// axes, strains are linear in the generalized strains (axial and shear
  /// strain Gamma, curvatures and twist kappa)
  ///   e = (Gamma, kappa, kappa_y^2 / 2, a, a')                 (FrameStrains),
  /// so the stress resultants s = D e have a constant matrix D, that of a
  /// linear Beam (SectionOperator). With Saint-Venant warping functions this is
  /// Simo's beam with the exact section stiffness. TwistStretch adds the terms
  /// of kappa_y^2 / 2 (Wagner's stiffening of twisted strips). The flattening
  /// of bent tubes and wide strips is neglected; Deformation::shape_change
  /// estimates its effect.
  ///
  /// In a displacement vector u, a node has r and a rotation vector of angle 0
  /// to pi, scaled as RigidField. In an increment du, it is a spin about body
  /// axes that follows the rotation in u; retract() computes u updated by du.
  /// Moments in forces are conjugate to spins. Functionals of displacements
  /// depend on u (rows()).
  ///
  /// Nodal quaternions are interpolated along an element. Reduced integration,
  /// one Gauss point fewer than nodes, avoids locking. EBBT is TBT with a shear
  /// stiffness of 10^4 times the axial stiffness, as a penalty. Sections that
  /// cannot twist must rotate in one plane.
  class GeometricallyExactBeam : public FiniteRotationBeam
  {
  public:
    /// Constructs a beam with all functions of @p section at all nodes, of a
    /// theory from Theory::of_rotating(). @p keeps_normal is true for EBBT (no
    /// shear strain). If not empty, @p theory is the text of theory().
    GeometricallyExactBeam(const std::string                    &name,
                           const std::shared_ptr<const Section> &section,
                           const std::shared_ptr<const Axis>    &axis,
                           const Placement                      &placement,
                           const std::string                    &theory = "",
                           const bool keeps_normal = false);

    /// Constructs a beam with the functions @p fields_of_node at each node.
    /// Throws InputError if a function is neither rigid nor a mode of @p space.
    GeometricallyExactBeam(
      const std::string                            &name,
      std::shared_ptr<const SectionSpace>           space,
      std::shared_ptr<const Axis>                   axis,
      const Placement                              &placement,
      const std::vector<std::vector<unsigned int>> &fields_of_node,
      const std::string                            &theory,
      const bool                                    keeps_normal = false);

    bool
    constraints_rotate() const override
    {
      return true;
    }
    /// Returns the sum of @p u and @p change, with rotations composed. Throws
    /// NumericsError if a section that cannot twist would twist.
    Vector
    retract(const Vector &u, const Vector &change) const override;
    DofMagnitude
    magnitude(const Vector &u) const override;
    std::vector<Vector>
    rigid_motions(const Vector &u) const override;
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    /// Calls @p use with the tangent of each locally owned axis element.
    void
    for_each_stiffness_block(const Vector        &u,
                             const Vector        &correction,
                             const bool           with_values,
                             const BlockCallback &use) const override;
    /// Calls @p use with element blocks at @p u (Body::for_each_mass_block()):
    /// displacements are nonlinear in the rotations.
    void
    for_each_mass_block(const Vector        &u,
                        const bool           with_values,
                        const BlockCallback &use) const override
    {
      Body::for_each_mass_block(u, with_values, use);
    }
    Deformation
    deformation(const Vector &u) const override;
    double
    add_thermal_load(const Vector &u, Vector &f) const override;
    void
    for_each_thermal_block(const Vector        &u,
                           const BlockCallback &use) const override;
    dealii::Tensor<2, 3>
    rotation_at(const Location &location, const Vector &u) const override;
    std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const override;
    std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Vector                &u,
         const Quantity               quantity = Quantity::displacement,
         const lamella::Frame frame = lamella::Frame::scene) const override;
    void
    for_each_block_of_forces(const std::vector<Location>             &locations,
                             const std::vector<dealii::Tensor<1, 3>> &forces,
                             const Vector                            &u,
                             const BlockCallback &use) const override;

  protected:
    FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const override;
    std::vector<FieldSample>
    samples_at(const std::vector<SectionPoint> &points,
               const std::vector<AxisPoint>    &places,
               const Vector                    &u) const override;

  private:
    /// Section stiffness D of an axis element. `fields` are the indices of its
    /// section functions, `warpings` of those m that are not rigid.
    struct Law
    {
      std::vector<unsigned int> fields, warpings;
      /// Matrix D of order 7 + 2 m, for the 7 FrameStrains and warping a, a'.
      dealii::LAPACKFullMatrix<double> D;
    };

    /// Nodal displacements and rotations of an axis element.
    struct Element
    {
      /// Quaternions of nodal rotations, with signs such that q[0] . q[i] >= 0.
      std::vector<Quaternion>           q;
      std::vector<dealii::Tensor<1, 3>> r;
      /// Amplitudes of the warping functions at each node.
      std::vector<std::vector<double>> a;
    };

    /// Interpolated rotation quaternion Q, displacement r and warping
    /// amplitudes a at an axis point, with their derivatives along y.
    struct Frame
    {
      Quaternion           Q, dQ;
      dealii::Tensor<1, 3> r, dr;
      std::vector<double>  a, da;
    };

    /// Integration point of an axis element.
    struct Station
    {
      AxisPoint point;
      double    weight = 0.;
    };

    /// An unknown of an element: a displacement, spin or warping amplitude of a
    /// node. The beam's DoF, if it exists, is `factor` times the unknown.
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

    /// Numbers of section strains (FrameStrains), and of rigid DoFs per node.
    static constexpr unsigned int n_strains       = 7,
                                  n_node_unknowns = RigidField::n_all;
    using OfFrame = std::array<double, n_strains>;

    /// Derivative of the quaternion Q, Q' and r' (11 values) at an axis point
    /// by the displacement r and the spin of one node.
    using ByNode = std::array<dealii::Tensor<1, 6>, 11>;

    /// A point of a section, with the warping functions of the element.
    struct PointFields
    {
      AxisPoint on_axis;
      /// Position from the center of the section.
      dealii::Tensor<1, 3> X;
      /// Values of the warping functions at the point.
      std::vector<dealii::Tensor<1, 3>> Phi;
    };

    void
    make_laws(const bool keeps_normal);
    std::shared_ptr<Law>
    make_law(const SectionOperator &section_operator) const;
    /// Sets the row and the column of the section stiffness for kappa_y^2 / 2.
    void
    add_twist_stretch(Law &law) const;

    /// Returns the number of rigid functions, the first of the section.
    unsigned int
    n_rigid() const
    {
      return std::min<unsigned int>(n_node_unknowns, section().n_fields());
    }

    /// Converts the forces @p work on the section functions @p list at Gauss
    /// point @p k to stress resultants, except for that of kappa_y^2 / 2.
    std::vector<double>
    on_strains(const std::vector<unsigned int> &list,
               const FieldParts                &work,
               const unsigned int               k) const;

    /// Returns the stress resultants of the thermal stress C epsilon_0 at the
    /// integration points of the axis element @p cell.
    std::vector<Vector>
    thermal_stresses(const unsigned int cell) const;
    /// Returns the thermal stress resultants conjugate to the twist strain
    /// kappa_y^2 / 2 at the axial positions @p places.
    std::vector<double>
    thermal_stress_on_twist(const std::vector<double> &places) const;

    /// Returns the strain at the section point @p point for kappa_y^2 / 2 = 1.
    Voigt
    twist_strain(const SectionPoint &point) const;

    /// Returns the rotation vector of @p node in a displacement @p u, or its
    /// spin in an increment @p u.
    dealii::Tensor<1, 3>
    rotation(const unsigned int node, const Vector &u) const;

    Element
    element(const unsigned int cell, const Vector &u) const;
    static Frame
    frame_at(const AxisPoint &point, const Element &element);
    /// Return the generalized strains of a section at the axis point @p frame.
    static std::vector<double>
    strains(const Frame &frame, const FrameStrains &of);
    static std::vector<double>
    strains(const Frame &frame);
    /// Returns the stress resultants of the generalized strains @p e.
    static Vector
    stresses(const Law &law, const std::vector<double> &e);

    std::vector<LocalDof>
    local_dofs(const unsigned int cell) const;
    /// Adds the forces @p local on the unknowns @p dofs of an element to @p f.
    static void
    add_local(const std::vector<LocalDof> &dofs,
              const std::vector<double>   &local,
              Vector                      &f);
    /// Returns the element matrix @p local as a block of the beam's stiffness.
    /// The block has no values if @p local is empty.
    static StiffnessBlock
    block_of(const std::vector<LocalDof>            &dofs,
             const dealii::LAPACKFullMatrix<double> &local);
    static ByNode
    by_node(const Element     &element,
            const AxisPoint   &point,
            const unsigned int i);

    /// Adds the nodal forces of the stress resultants @p s at the integration
    /// point @p station to the element vector @p f.
    static void
    add_forces(const Station       &station,
               const Element       &element,
               const Vector        &s,
               std::vector<double> &f);

    /// Returns the resultants of FrameStrains extrapolated linearly from the
    /// element @p before by the increment @p change, for the geometric
    /// stiffness (Magisano, Leonetti and Garcea 2017).
    static OfFrame
    predicted(const Station             &station,
              const Law                 &law,
              const Element             &before,
              const std::vector<double> &change);
    /// Adds the tangent stiffness of the integration point @p station to @p K,
    /// with the resultants @p s of FrameStrains in the geometric stiffness.
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
    /// Returns by_node() for all nodes of an element at @p station.
    static std::vector<ByNode>
    by_nodes(const Station &station, const Element &element);
    /// Returns the part of a spin's diagonal entry from the second derivative
    /// of the unit quaternion @p q. @p by_q is the derivative of the energy by
    /// q.
    static double
    along_geodesic(const Quaternion &by_q, const Quaternion &q)
    {
      return -(by_q * q) / 4.;
    }
    /// Returns the material part of the second derivative by (Q, Q', r') of the
    /// energy of FrameStrains.
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

    /// Kinematics and strains of a section.
    struct SectionState
    {
      Frame frame;
      /// Generalized strains e, and the amplitudes of section functions and
      /// their axial derivatives in a linear beam with the same strains.
      std::vector<double> e, value, derivative;
      /// Coefficients of the warping displacements.
      std::vector<double> warping;
    };
    /// Return kinematics and strains of a section of an element or axis point.
    SectionState
    section_state(const unsigned int cell, const Frame &frame) const;
    SectionState
    section_state(const AxisPoint &on_axis, const Vector &u) const;
    /// Returns the state for output, with strains interpolated in the element.
    SectionState
    output_state(const AxisPoint &on_axis, const Vector &u) const;

    PointFields
    fields_at(const Location::Place &place) const;
    /// Returns the position of @p point relative to the section's center.
    dealii::Tensor<1, 3>
    from_center(const SectionPoint &point) const;
    /// Returns the warping displacement at the point @p at, in section axes.
    static dealii::Tensor<1, 3>
    warping(const PointFields &at, const Frame &frame);
    /// Returns the displacement of @p point, in body axes.
    dealii::Tensor<1, 3>
    displacement(const SectionPoint &point, const SectionState &state) const;
    /// Returns displacement, strain and stress at @p point of the section at
    /// the axial position @p y.
    FieldSample
    sample_of_section(const SectionPoint &point,
                      const double        y,
                      const SectionState &state) const;
    /// Returns the rotated position of the point @p at of a section, relative
    /// to its center and with warping, with its derivatives.
    static RotatedVector
    rotated_point(const PointFields &at, const Frame &frame);
    /// Returns the derivative of the displacement at @p at (body axes) by each
    /// unknown of @p element.
    static std::vector<dealii::Tensor<1, 3>>
    by_local(const PointFields &at, const Element &element);
    /// Adds @p share times the linearized displacement functionals at @p place
    /// to @p rows, one per displacement component.
    void
    add_rows(const Location::Place         &place,
             const double                   share,
             const Vector                  &u,
             std::vector<LinearFunctional> &rows) const;
    /// Adds the load stiffness of the point force @p force at @p at to @p K.
    static void
    add_force(const PointFields                &at,
              const dealii::Tensor<1, 3>       &force,
              const Element                    &element,
              dealii::LAPACKFullMatrix<double> &K);

    /// Adds the row of the spin component @p spin in add_force(). @p row has
    /// the derivatives of the conjugate moment by Q and by the rotated vector.
    static void
    add_force_row(const PointFields                &at,
                  const Element                    &element,
                  const dealii::Tensor<1, 7>       &row,
                  const unsigned int                spin,
                  dealii::LAPACKFullMatrix<double> &K);

    /// Updates the largest strains in @p deformation by those of @p state.
    void
    add_strains(const SectionState &state, Deformation &deformation) const;

    /// Returns the strain at @p point for @p state, in section axes.
    Voigt
    strain_at(const SectionPoint &point, const SectionState &state) const;

    /// Reference length of the section [length].
    double h;
    /// The section, or for EBBT and TBT an LE-2 section of its mesh, whose
    /// Saint-Venant states give TwistStretch and Deformation::shape_change.
    std::shared_ptr<const Section>      deformable_section;
    std::unique_ptr<const TwistStretch> twist_stretch;
    /// Shape change (stiffening_by_shape()) minus the part in TwistStretch.
    std::array<double, 3>                   stiffening;
    std::vector<std::vector<Station>>       stations;
    std::vector<std::shared_ptr<const Law>> laws;
  };
} // namespace lamella

#endif
