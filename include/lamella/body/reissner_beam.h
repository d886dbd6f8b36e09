// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_reissner_beam_h
#define lamella_body_reissner_beam_h

#include <lamella/body/beam.h>
#include <lamella/body/frame_strains.h>
#include <lamella/section/twist_stretch.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace lamella
{
  /**
   * A beam whose sections turn by any angle and warp a little: its centre goes
   * by r(y), the section turns by R(y), and what else it does, the amplitudes a
   * of its fields that are no rigid motions, turns with it,
   *   x = X_c + r + R (X - X_c + Phi a).
   * Strains are small in the axes of the section, and linear in
   *   e = (Gamma, kappa, kappa_y^2 / 2, a, a')                 (FrameStrains),
   * so that what the section answers is what it answers to the same numbers in
   * a Beam (SectionAnswer), and a constant matrix: s = D e. Of Saint-Venant's
   * fields that is Simo's beam with the section's own stiffness; warping in
   * shear and torsion, Poisson's effect and all couplings of a layup are in it;
   * what kappa_y^2 / 2 is of the section is TwistStretch, Wagner's stiffening
   * of a twisted strip. What it leaves out are other strains that are quadratic
   * in the section itself: the flattening of bent tubes and of wide strips;
   * Deformation::shape_change says how much that is.
   *
   * DoFs are those of the Beam. In a state u the six rigid fields of a node
   * have another meaning: its r, and its rotation vector, of 0 to pi, as small
   * rotations have it (RigidField). In changes du, and in forces, they are
   * spins on top of the state, about the axes of the body, and updated() puts
   * both together. Rows of displacements, their change with du, depend on the
   * state (rows_at()). At u = 0 both are those of the Beam.
   *
   * Quaternions of the nodes are interpolated along an element, and integrals
   * are those of one Gauss point fewer than nodes, which locks at no
   * slenderness. (With one more for what has a and a' alone 16 elements were as
   * far off as 8 without, where warping is held.)
   *
   * Sections that stay normal to the axis (EBBT) are those of TBT with 10^4
   * times the axial stiffness against shear: a share (h / L)^2 of 1e-5 of the
   * deflection is left of it. A section that cannot twist turns in one plane.
   */
  class ReissnerBeam : public Beam
  {
  public:
    /// Every node carries all fields of the section, which is that of
    /// Theory::of_turning(); whether it @p stays_normal. What theory() says is
    /// @p theory, or that of the section.
    ReissnerBeam(const std::string             &name,
                 std::shared_ptr<const Section> section,
                 std::shared_ptr<const Axis>    axis,
                 const Placement               &placement,
                 const std::string             &theory       = "",
                 const bool                     stays_normal = false);

    /// As the constructor of Beam; lists of fields are dense (FieldSpace).
    /// Throws InputError for lists that are not.
    ReissnerBeam(const std::string                            &name,
                 std::shared_ptr<const FieldSpace>             space,
                 std::shared_ptr<const Axis>                   axis,
                 const Placement                              &placement,
                 const std::vector<std::vector<unsigned int>> &fields_of_node,
                 const std::string                            &theory,
                 const bool stays_normal = false);

    bool
    turns() const override
    {
      return true;
    }
    bool
    rows_turn() const override
    {
      return true;
    }
    /// Throws NumericsError where a section that cannot twist would have to.
    Vector
    updated(const Vector &u, const Vector &change) const override;
    double
    largest_spin(const Vector &change) const override;
    std::vector<Vector>
    rigid_motions_at(const Vector &u) const override;
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    Deformation
    deformation(const Vector &u) const override;
    void
    add_heat_at(const Vector &u, Vector &f) const override;
    void
    for_each_block_of_heat(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const override;
    dealii::Tensor<2, 3>
    turn_at(const Location &location, const Vector &u) const override;
    std::vector<dealii::Tensor<1, 3>>
    displacements(const std::vector<Location> &locations,
                  const Vector                &u) const override;
    std::vector<std::vector<Row>>
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
    /// A block for each own element of the axis.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /// What the sections of an element of the axis answer, D e, and to which
    /// fields, of which m are no rigid motions.
    struct Law
    {
      std::vector<unsigned int> fields, warpings;
      /// 7 + 2 m numbers squared, in the order of e.
      dealii::LAPACKFullMatrix<double> D;
    };

    /// The state of an element of the axis, node by node.
    struct Element
    {
      /// All alike in sign.
      std::vector<Quaternion>           q;
      std::vector<dealii::Tensor<1, 3>> r;
      /// The amplitudes of Law::warpings.
      std::vector<std::vector<double>> a;
    };

    /// The state at a point of the axis.
    struct Frame
    {
      Quaternion           Q, dQ;
      dealii::Tensor<1, 3> r, dr;
      std::vector<double>  a, da;
    };

    /// A point that an element is integrated by.
    struct Station
    {
      AxisPoint point;
      double    weight = 0.;
    };

    /// One of the numbers of an element that its forces and its tangent are
    /// made for, node after node its r, its spin and its warpings: the DoF is
    /// `factor` of it, if there is one.
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

    /// Those of FrameStrains; r and the spin of a node.
    static constexpr unsigned int n_strains = 7, n_of_node = RigidField::n_all;
    using OfFrame = std::array<double, n_strains>;

    /// d(Q, Q', r') by r and the spin of a node.
    using ByNode = std::array<dealii::Tensor<1, 6>, 11>;

    /// A point of the section and what is there of the fields of an element.
    struct PointFields
    {
      AxisPoint on_axis;
      /// From the centre of the section.
      dealii::Tensor<1, 3> X;
      /// Of Law::warpings.
      std::vector<dealii::Tensor<1, 3>> Phi;
    };

    void
    make_stations();
    void
    make_laws(const bool stays_normal);
    std::shared_ptr<Law>
    make_law(const SectionAnswer &answer) const;
    /// The row and the column of kappa_y^2 / 2.
    void
    add_twist_stretch(Law &law) const;

    /// How many of the section's fields, the first ones, are no warpings.
    unsigned int
    n_rigid() const
    {
      return std::min<unsigned int>(n_of_node, section().n_fields());
    }

    /// The stresses on e that the @p work on the fields @p list is, at station
    /// @p k, with none on kappa_y^2 / 2.
    std::vector<double>
    on_strains(const std::vector<unsigned int> &list,
               const FieldParts                &work,
               const unsigned int               k) const;

    /// Of each station of the element @p cell the stresses on e of C epsilon_0.
    std::vector<Vector>
    heat_stresses(const unsigned int cell) const;
    /// Those on kappa_y^2 / 2 at each of @p places along the axis.
    std::vector<double>
    heat_on_twist(const std::vector<double> &places) const;

    /// The strain of kappa_y^2 / 2 = 1 at @p point of the section.
    Voigt
    twist_strain(const SectionPoint &point) const;

    /// The rotation vector of @p node in a state, or its spin in a change.
    dealii::Tensor<1, 3>
    rotation(const unsigned int node, const Vector &u) const;

    Element
    element(const unsigned int cell, const Vector &u) const;
    static Frame
    frame_at(const AxisPoint &point, const Element &element);
    /// e there.
    static std::vector<double>
    strains(const Frame &frame, const FrameStrains &of);
    static std::vector<double>
    strains(const Frame &frame);
    /// D e.
    static Vector
    stresses(const Law &law, const std::vector<double> &e);

    std::vector<LocalDof>
    local_dofs(const unsigned int cell) const;
    /// Adds the forces @p local to @p f.
    static void
    add_local(const std::vector<LocalDof> &dofs,
              const std::vector<double>   &local,
              Vector                      &f);
    /// The matrix @p local; without values where it is empty.
    static StiffnessBlock
    block_of(const std::vector<LocalDof>            &dofs,
             const dealii::LAPACKFullMatrix<double> &local);
    static ByNode
    by_node(const Element     &element,
            const AxisPoint   &point,
            const unsigned int i);

    /// Adds what the stresses @p s on e do at @p station to the local forces
    /// @p f.
    static void
    add_forces(const Station       &station,
               const Element       &element,
               const Vector        &s,
               std::vector<double> &f);

    /// The stresses of the frame's strains that a @p change of the local
    /// numbers predicts where it starts from @p before: the linear part of what
    /// it makes (Magisano, Leonetti and Garcea, see green_tangent()).
    static OfFrame
    predicted(const Station             &station,
              const Law                 &law,
              const Element             &before,
              const std::vector<double> &change);
    /// Add to the local matrix @p K: all of a station with the stresses @p s of
    /// the frame's strains; what these do as r and spins turn e, on top of the
    /// second derivative @p by_measures of the energy by (Q, Q', r'); the
    /// products of r and spins with those of node @p j; those with a warping. A
    /// node has @p n numbers.
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
    /// by_node() of all nodes at @p station.
    static std::vector<ByNode>
    by_nodes(const Station &station, const Element &element);
    /// What the second derivative of a unit quaternion @p q as spins go on adds
    /// to a spin, where the energy has the derivative @p by_q.
    static double
    along_geodesic(const Quaternion &by_q, const Quaternion &q)
    {
      return -(by_q * q) / 4.;
    }
    /// That of the energy of the frame's strains by (Q, Q', r') without
    /// stresses.
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

    /// A section in a state.
    struct SectionState
    {
      Frame frame;
      /// e, and what the warpings and the frame's strains are of each field of
      /// the section: of its value and of its derivative along the axis.
      std::vector<double> e, value, derivative;
      /// Coefficients of the displacements.
      std::vector<double> warping;
    };
    /// That of a section of the element @p cell.
    SectionState
    section_state(const unsigned int cell, const Frame &frame) const;
    SectionState
    section_state(const AxisPoint &on_axis, const Vector &u) const;
    /// Returns the section state for samples: its strains are interpolated
    /// along the element from those at its stations.
    SectionState
    shown_state(const AxisPoint &on_axis, const Vector &u) const;

    PointFields
    fields_at(const Location::Place &place) const;
    /// X of PointFields.
    dealii::Tensor<1, 3>
    from_centre(const SectionPoint &point) const;
    /// Phi a of the point @p at, in axes of the body.
    static dealii::Tensor<1, 3>
    warping(const PointFields &at, const Frame &frame);
    /// The displacement of @p point, in axes of the body.
    dealii::Tensor<1, 3>
    displacement(const SectionPoint &point, const SectionState &state) const;
    /// What is shown of @p point of a section at @p y that is in @p state.
    FieldSample
    sample_of_section(const SectionPoint &point,
                      const double        y,
                      const SectionState &state) const;
    /// R (X + Phi a) there.
    static TurnedVector
    turned_point(const PointFields &at, const Frame &frame);
    /// The displacement there of a unit of each local number, in axes of the
    /// body.
    static std::vector<dealii::Tensor<1, 3>>
    by_local(const PointFields &at, const Element &element);
    /// Adds @p share of the rows of the displacement at @p place to @p rows.
    void
    add_rows(const Location::Place &place,
             const double           share,
             const Vector          &u,
             std::vector<Row>      &rows) const;
    /// Adds to @p K the derivative of the work of @p force, in axes of the
    /// body, on these numbers at @p at.
    static void
    add_force(const PointFields                &at,
              const dealii::Tensor<1, 3>       &force,
              const Element                    &element,
              dealii::LAPACKFullMatrix<double> &K);

    /// The part of add_force() of the spin whose number is @p spin, @p row its
    /// derivatives by Q and what R turns.
    static void
    add_force_row(const PointFields                &at,
                  const Element                    &element,
                  const dealii::Tensor<1, 7>       &row,
                  const unsigned int                spin,
                  dealii::LAPACKFullMatrix<double> &K);

    /// Takes what a section in @p state has into @p deformation.
    void
    add_strains(const SectionState &state, Deformation &deformation) const;

    /// The strain at @p point of a section in @p state.
    Voigt
    strain_at(const SectionPoint &point, const SectionState &state) const;

    /// The reference length of the section.
    double h;
    /// The section, or where it is rigid one that is not.
    std::shared_ptr<const Section>      deforming;
    std::unique_ptr<const TwistStretch> twist_stretch;
    /// stiffening_by_shape() less what the law has.
    std::array<double, 3>                   stiffening;
    std::vector<std::vector<Station>>       stations;
    std::vector<std::shared_ptr<const Law>> laws;
  };
} // namespace lamella

#endif
