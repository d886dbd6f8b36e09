// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `recover`: better stresses than those of the elements, and values at
// the places that a scene asks for. It owns the recovery by patches and the
// sampling of probes, lines and cuts into Results. It never changes the
// solution and never knows what the values are for: no goals, no files.

#ifndef lamella_recover_recovery_h
#define lamella_recover_recovery_h

#include <lamella/body/body.h>
#include <lamella/recover/patch_fit.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Which strains and stresses are reported where elements of one ply meet.
  enum class StressValues
  {
    undefined,
    element,  ///< those of the elements that hold the point, their mean
    nodal,    ///< means at the nodes over all elements there, interpolated
    recovered ///< superconvergent patch recovery
  };

  /// Throws InputError, beginning with @p what, unless @p text is element,
  /// nodal or recovered.
  StressValues
  parse_stress_values(const std::string &text, const std::string &what);

  /**
   * Strains and stresses that are continuous within a ply, from those of the
   * elements, which are not. Only elements of one ply are joined, so nothing is
   * smoothed across an interface. Displacements and FieldSample::jump stay
   * those of the elements.
   *
   * `nodal`: the mean over the elements that share a node, interpolated over
   * the nodes of each element (Gauss-Lobatto points of the displacements'
   * degree p). At a surface it is one-sided and converges as the elements do,
   * with h^p.
   *
   * `recovered`: superconvergent patch recovery (Zienkiewicz and Zhu, Int. J.
   * Numer. Meth. Eng. 33 (1992) 1331-1364). In the patch of all elements at a
   * corner v a polynomial P_v of degree p in each local coordinate is fitted to
   * the values at the reduced Gauss points, p a coordinate, which converge with
   * h^(p+1). Within an element
   *   sigma(X) = sum_v N_v(X) P_v(X),   N_v trilinear, v its corners,
   * which gives a node in the middle of an edge the mean of its two patches, is
   * continuous, and reproduces what the fits reproduce (Blacker and Belytschko,
   * Int. J. Numer. Meth. Eng. 37 (1994) 517-536).
   * - A corner whose patch fixes fewer terms than that of another corner of the
   *   same elements, as on a surface, takes the polynomial of the latter that
   *   shares most of its elements.
   * - A ply of one element through its thickness fixes degree p - 1 there:
   *   values are extrapolated from the reduced Gauss points.
   * - A corner on the edge of a larger element takes what that one has there.
   * - Along coordinates in which Body::recovery_degrees() is zero values are
   *   those at the point itself: Taylor theories are recovered along the axis
   *   only.
   *
   * Only the patches that requests need are fitted, each once.
   */
  class StressRecovery
  {
  public:
    /// @p body and the displacements @p u are referred to.
    StressRecovery(const Body        &body,
                   const Vector      &u,
                   const StressValues values);

    FieldSample
    sample(const Location &location);

  private:
    using Place = Location::Place;

    /// A place without the rounding of its unit coordinates.
    using Key = std::pair<unsigned int, std::array<long, 3>>;

    /// What a node takes its values from: a weighted sum of fits.
    using Source = std::vector<std::pair<double, const PatchFit *>>;

    static Key
    key_of(const Place &place);

    FieldValues
    element_values(const unsigned int ply, const Place &place) const;

    /// The continuous field in the element of @p place.
    FieldValues
    field(const unsigned int ply, const Place &place);

    /// The nodes of the element of @p place with their shape functions there;
    /// along coordinates without recovery they stay at @p place.
    std::vector<std::pair<Place, double>>
    nodes(const Place &place) const;

    /// Whether @p place is at a node of its element.
    bool
    is_node(const Place &place) const;

    /// Where @p place is in each element of the ply that holds the point.
    const std::vector<Place> &
    meeting(const unsigned int ply, const Place &place);

    const Source &
    source(const unsigned int ply, const Place &node);

    /// The fit of the patch at @p node, whatever its neighbours have.
    const PatchFit &
    own_fit(const unsigned int ply, const Place &node);

    /// The fits that @p node takes, as above.
    Source
    best_fits(const unsigned int ply, const Place &node);

    std::vector<PatchPoint>
    patch_points(const unsigned int ply, const std::vector<Place> &elements);

    /// The different directions of edges in a patch.
    std::vector<dealii::Tensor<2, 3>>
    frames(const std::vector<Place> &elements) const;

    const Body                       &body;
    const Vector                     &u;
    const StressValues                kind;
    const std::array<unsigned int, 3> degrees;
    /// Unit coordinates of an element's nodes along each coordinate.
    std::array<std::vector<double>, 3> node_coordinates;

    std::map<Key, std::vector<Place>>              meetings;
    std::map<Key, std::vector<PatchPoint>>         gauss_points;
    std::map<Key, std::unique_ptr<const PatchFit>> fits;
    std::map<Key, Source>                          sources;
  };
} // namespace lamella

#endif
