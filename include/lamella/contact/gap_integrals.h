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
  /// Averages of a row over its points (GapPoint) with the weights a_q
  /// phi_i(X_q) / A_i: the mortar integrals of a weighted gap. psi_k are the
  /// functions of trace nodes on either surface; n is outward from the slave
  /// side.
  struct GapIntegrals
  {
    /// A_i = sum a_q phi_i over points with a projection [length^2].
    double area = 0.;
    /// Averages of g [length] and of n.
    double               gap = 0.;
    dealii::Tensor<1, 3> normal;
    /// Average of slide(), if reference points are held.
    dealii::Tensor<1, 3> slip_increment;
    /// Averages of psi_k n and psi_k (I - n n) for a node. The latter times any
    /// tangent t is the weight of the slip along t.
    struct OfNode
    {
      dealii::Tensor<1, 3>          normal;
      dealii::SymmetricTensor<2, 3> tangential;
    };
    boost::container::flat_map<unsigned int, OfNode> slave, master;
  };

  /// Determination of the place opposite a material point.
  enum class MasterPoints
  {
    paired,   ///< the paired place; n is the averaged normal
    projected ///< current closest-point projection (closest_point_projection())
  };

  /**
   * Returns the integrals of the @p n_rows rows of a contact with the gap
   * points @p points, on the current surfaces @p sides; the slave is the second
   * if @p on_second. @p functions are those of the rows, null if row k is point
   * k.
   *
   * MasterPoints::projected replaces the opposite places in @p points by
   * projections within @p search_radius [length], and omits points without one.
   * The gap is g = n_2 . (x_1 - x_2) with the exact gradient n . (delta x_2 -
   * delta x_1), n = -n_2; its average is the gradient of the averaged gap,
   * since the weights are constant. MasterPoints::paired uses n = (n_1 - n_2) /
   * |n_1 - n_2| and g = n . (x_2 - x_1), whose gradient this is if x_2 - x_1 is
   * along n.
   *
   * If reference points @p held since the beginning of a step are given, slips
   * are included. Points that newly face the surface are added to them.
   */
  std::vector<GapIntegrals>
  integrate_gaps(const ContactSides    &sides,
                 const bool             on_second,
                 const SlaveSurface    *functions,
                 const unsigned int     n_rows,
                 const MasterPoints     master_points,
                 const double           search_radius,
                 std::vector<GapPoint> &points,
                 SlipReferencePoints   *held = nullptr);

  /// Returns slip_reference_point() of each of @p points, which are projected
  /// on @p sides. Arguments as in integrate_gaps().
  SlipReferencePoints
  slip_reference_points(const ContactSides    &sides,
                        const bool             on_second,
                        const MasterPoints     master_points,
                        const double           search_radius,
                        std::vector<GapPoint> &points);

  /// Returns the rows to which @p point, with number @p number, contributes,
  /// and its weight a_q phi_i(X_q) in each; see integrate_gaps().
  std::vector<std::pair<unsigned int, double>>
  shares_of(const SlaveSurface *functions,
            const unsigned int  number,
            const GapPoint     &point);
} // namespace lamella

#endif
