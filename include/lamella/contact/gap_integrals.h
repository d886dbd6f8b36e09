// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_gap_integrals_h
#define lamella_contact_gap_integrals_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/master_surface.h>
#include <lamella/contact/pairing.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <boost/container/flat_map.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// Unit tangents t_1, t_2 of a surface; with the normal n right-handed.
  using Tangents = std::array<dealii::Tensor<1, 3>, 2>;

  /// Returns the unit tangents for the unit normal @p n. The first is as close
  /// as possible to the scene's y axis (x if n is within 5 degrees of y).
  Tangents
  tangents_of(const dealii::Tensor<1, 3> &n);

  /// Returns the unit tangents for the normal @p n at the point @p st of a
  /// facet with the undeformed map @p before and the deformed map @p now. The
  /// first has the direction of the deformed first tangent of tangents_of().
  Tangents
  convected_tangents(const FacetMap             &before,
                     const FacetMap             &now,
                     const dealii::Point<2>     &st,
                     const dealii::Tensor<1, 3> &n);

  /// Reference point of the slip in a load step: the slave point of a contact
  /// and the master point that it faced at the beginning of the step.
  struct SlipReferencePoint
  {
    GapPoint point; ///< Both material points at the beginning of the step.
    /// For an obstacle: vector from Obstacle::point to the opposite point.
    dealii::Tensor<1, 3> on_obstacle,
      normal; ///< For an obstacle: its unit normal at the opposite point.
  };

  /// Slip reference points, one per contact point; an entry is empty if its
  /// point is unpaired.
  using SlipReferencePoints = std::vector<std::optional<SlipReferencePoint>>;

  /// Begin of a load step, from which slips are measured.
  struct SlipReference
  {
    /// Surfaces at the beginning of the step; null before the first step.
    std::shared_ptr<const ContactSides> sides;
    SlipReferencePoints                 points; ///< Facing points there.
  };

  /// Mortar integrals of one weighted gap i: averages over the contact points
  /// X_q (GapPoint) with the weights a_q phi_i(X_q) / A_i, where a_q is the
  /// area of the point and phi_i the multiplier function. psi_k are trace
  /// functions of either surface; n is the normal outward from the slave side.
  struct GapIntegrals
  {
    /// Integral of phi_i over points that have a projection [length^2].
    double               area = 0.;
    double               gap  = 0.; ///< Average gap [length].
    dealii::Tensor<1, 3> normal;    ///< Average normal, not of length 1.
    /// Average slip in the load step [length]; zero without a reference.
    dealii::Tensor<1, 3> slip_increment;
    /// Averages for one trace node with trace function psi and the normal n.
    struct OfNode
    {
      /// Average of psi n, with the trace function psi and the normal n.
      dealii::Tensor<1, 3> normal;
      /// Average of psi (I - n n), with trace function psi and normal n.
      dealii::SymmetricTensor<2, 3> tangential;
    };
    boost::container::flat_map<unsigned int, OfNode>
      slave,  ///< Averages by number of the trace node on the slave side.
      master; ///< Averages by number of the trace node on the master side.
  };

  /// Choice of the point opposite a slave point on the master surface.
  enum class MasterPoints
  {
    paired,   ///< the stored point; the gap is along the averaged normal
    projected ///< current closest-point projection (closest_point_projection())
  };

  /// Returns the mortar integrals of the @p n_rows constraints of a contact at
  /// the contact points @p points, on the current surfaces @p sides. The slave
  /// is the second surface if @p on_second, else the first. @p functions are
  /// the multiplier functions; if null, constraint k has point k only.
  ///
  /// Points without area are omitted. MasterPoints::projected replaces the
  /// opposite points in @p points by closest-point projections within @p
  /// search_radius [length], and omits points without a projection. The gap is
  /// g = n_2 . (x_1 - x_2) with the exact gradient n . (delta x_2 - delta x_1),
  /// n = -n_2. MasterPoints::paired uses n = (n_1 - n_2) / |n_1 - n_2| and g =
  /// n . (x_2 - x_1); this gradient is exact if x_2 - x_1 is along n. x_1, n_1
  /// are the point and outward normal of the slave, x_2, n_2 of the master.
  ///
  /// Slips are measured from the beginning @p reference of the load step. A
  /// constraint without any projection has the slip of its points at the begin
  /// of the step (slip_past_edge()).
  std::vector<GapIntegrals>
  integrate_gaps(const ContactSides    &sides,
                 const bool             on_second,
                 const SlaveSurface    *functions,
                 const unsigned int     n_rows,
                 const MasterPoints     master_points,
                 const double           search_radius,
                 std::vector<GapPoint> &points,
                 const SlipReference   *reference = nullptr);

  /// Returns slip_reference_point() of each of the contact points @p points,
  /// which are projected on @p sides. Arguments as in integrate_gaps().
  SlipReferencePoints
  slip_reference_points(const ContactSides    &sides,
                        const bool             on_second,
                        const MasterPoints     master_points,
                        const double           search_radius,
                        std::vector<GapPoint> &points);

  /// Returns the constraints to which @p point with the index @p number
  /// contributes, with weights: area times multiplier function in @p functions.
  /// If these are null, it contributes to constraint @p number with its area.
  std::vector<std::pair<unsigned int, double>>
  shares_of(const SlaveSurface *functions,
            const unsigned int  number,
            const GapPoint     &point);
} // namespace lamella

#endif
