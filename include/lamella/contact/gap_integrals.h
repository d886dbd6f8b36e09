// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_gap_integrals_h
#define lamella_contact_gap_integrals_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/slip_increment.h>

#include <deal.II/base/symmetric_tensor.h>

#include <boost/container/flat_map.hpp>

#include <vector>

namespace lamella
{
  /// Mortar integrals of one weighted gap i: averages over the contact points
  /// X_q (GapPoint) with the weights a_q phi_i(X_q) / A_i, where a_q is the
  /// area of the point and phi_i the multiplier function. psi_k are trace
  /// functions of either surface; n is the normal outward from the slave side.
  struct GapIntegrals
  {
    /// Area A_i = sum a_q phi_i over points with a projection [length^2].
    double area = 0.;
    /// Averages of the gap g [length] and of the normal n.
    double               gap = 0.;
    dealii::Tensor<1, 3> normal;
    /// Average slip_increment_of(), if reference points are given.
    dealii::Tensor<1, 3> slip_increment;
    /// Averages of psi_k n and psi_k (I - n n) for trace node k. The latter
    /// times a tangent t is the weight of the slip along t.
    struct OfNode
    {
      dealii::Tensor<1, 3>          normal;
      dealii::SymmetricTensor<2, 3> tangential;
    };
    boost::container::flat_map<unsigned int, OfNode> slave, master;
  };

  /// Choice of the master point opposite a slave point, for its gap.
  enum class MasterPoints
  {
    paired,   ///< the stored point; n is the averaged normal
    projected ///< current closest-point projection (closest_point_projection())
  };

  /// Returns the mortar integrals of the @p n_rows constraints of a contact at
  /// the contact points @p points, on the current surfaces @p sides; the slave
  /// is the second side if @p on_second. @p functions are the multiplier
  /// functions; if null, constraint k has point k only.
  ///
  /// MasterPoints::projected replaces the opposite points in @p points by
  /// closest-point projections within @p search_radius [length], and omits
  /// points without a projection. The gap is g = n_2 . (x_1 - x_2) with the
  /// exact gradient n . (delta x_2 - delta x_1), n = -n_2. MasterPoints::paired
  /// uses n = (n_1 - n_2) / |n_1 - n_2| and g = n . (x_2 - x_1); this gradient
  /// is exact if x_2 - x_1 is along n.
  ///
  /// If @p held, the reference points of the beginning of the step, are given,
  /// computes slips, and adds reference points for newly facing points.
  std::vector<GapIntegrals>
  integrate_gaps(const ContactSides    &sides,
                 const bool             on_second,
                 const SlaveSurface    *functions,
                 const unsigned int     n_rows,
                 const MasterPoints     master_points,
                 const double           search_radius,
                 std::vector<GapPoint> &points,
                 SlipReferencePoints   *held = nullptr);

  /// Returns slip_reference_point() of each of the contact points @p points,
  /// which are projected on @p sides. Arguments as in integrate_gaps().
  SlipReferencePoints
  slip_reference_points(const ContactSides    &sides,
                        const bool             on_second,
                        const MasterPoints     master_points,
                        const double           search_radius,
                        std::vector<GapPoint> &points);

  /// Returns the constraints to which contact point @p point number @p number
  /// contributes, with its weight a_q phi_i(X_q) in each (integrate_gaps()).
  std::vector<std::pair<unsigned int, double>>
  shares_of(const SlaveSurface *functions,
            const unsigned int  number,
            const GapPoint     &point);
} // namespace lamella

#endif
