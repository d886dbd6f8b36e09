// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_gap_integrals_h
#define lamella_contact_gap_integrals_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/contact/slide.h>

#include <deal.II/base/symmetric_tensor.h>

#include <boost/container/flat_map.hpp>

#include <vector>

namespace lamella
{
  /**
   * What a row averages over its points (GapPoint), with the weights
   * a_q phi_i(X_q) / A_i: of a weighted gap mortar integrals.
   *
   * Numbers of nodes are those of the trace nodes of either surface, psi_k
   * their functions. n points out of the carrying side.
   */
  struct GapIntegrals
  {
    /// A_i = sum a_q phi_i of the points that face something [length^2]; zero
    /// where none does. Then all else is zero, too.
    double area = 0.;
    /// The averages of g [length] and of n.
    double               gap = 0.;
    dealii::Tensor<1, 3> normal;
    /// That of slide(), where places are held.
    dealii::Tensor<1, 3> slid;
    /// Those of a node's function, psi_k n and psi_k (I - n n): the latter
    /// applied to any tangent t is the weight of the slip along t, so no frame
    /// is kept and none is preferred.
    struct OfNode
    {
      dealii::Tensor<1, 3>          normal;
      dealii::SymmetricTensor<2, 3> tangential;
    };
    boost::container::flat_map<unsigned int, OfNode> carrying, opposing;
  };

  /// What decides on the place opposite of a material point.
  enum class Feet
  {
    kept, ///< the place that it was paired with; n is the averaged normal
    found ///< the foot on the other side where that stands (find_foot())
  };

  /**
   * The integrals of the @p n_rows rows of a contact whose gaps are measured at
   * @p points, on the surfaces where @p sides stand; the carrying one is the
   * second if @p on_second. @p functions are those of the rows, null where row
   * k is point k.
   *
   * With Feet::found the places opposite in @p points become the feet, at most
   * @p reach [length] away, and points without any are left out. The gap of a
   * foot is g = n_2 . (x_1 - x_2) and its gradient n . (delta x_2 - delta x_1),
   * n = -n_2, exactly; the average of these is the gradient of the averaged
   * gap, since what points weigh does not change.
   *
   * With places @p held since a step began there is what points have slid
   * since. One that comes to face something is held from there on.
   *
   * With Feet::kept n = (n_1 - n_2) / |n_1 - n_2| and g = n . (x_2 - x_1), of
   * which that is the gradient as long as x_2 - x_1 is along n.
   */
  std::vector<GapIntegrals>
  integrate_gaps(const ContactSides    &sides,
                 const bool             on_second,
                 const CarryingSurface *functions,
                 const unsigned int     n_rows,
                 const Feet             feet,
                 const double           reach,
                 std::vector<GapPoint> &points,
                 HeldPlaces            *held = nullptr);

  /// Where each of @p points, which become the feet, faces something where @p
  /// sides stand: held_place(). Arguments are those of integrate_gaps().
  HeldPlaces
  held_places(const ContactSides    &sides,
              const bool             on_second,
              const Feet             feet,
              const double           reach,
              std::vector<GapPoint> &points);

  /// The rows that @p point, the one with the number @p number, is part of, and
  /// what it weighs in each, a_q phi_i(X_q); @p functions as above.
  std::vector<std::pair<unsigned int, double>>
  shares_of(const CarryingSurface *functions,
            const unsigned int     number,
            const GapPoint        &point);
} // namespace lamella

#endif
