// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `recover`: better stresses than those of the elements, and values at
// the places that a scene asks for. It owns the recovery by patches and by
// equilibrium and the sampling of probes, lines and cuts into Results. It never
// changes the solution and never knows what the values are for: no goals, no
// files.

#ifndef lamella_recover_recovery_h
#define lamella_recover_recovery_h

#include <lamella/base/names.h>
#include <lamella/body/body.h>
#include <lamella/recover/patch_fit.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  /// Which strains and stresses are reported where elements of one ply meet.
  /// Elements are those of the beam's axis times the section's cells, or
  /// hexahedra. Across ply interfaces nothing is ever joined. `undefined` fails
  /// an assertion.
  enum class StressValues
  {
    undefined,
    element,    ///< those of the elements that hold the point, their mean
    nodal,      ///< means at the nodes over all elements there, interpolated
    recovered,  ///< superconvergent patch recovery
    equilibrium ///< that, with transverse stresses by equilibrium
  };

  template <>
  struct Names<StressValues>
  {
    static constexpr NameOf<StressValues> all[] = {
      {StressValues::element, "element"},
      {StressValues::nodal, "nodal"},
      {StressValues::recovered, "recovered"},
      {StressValues::equilibrium, "equilibrium"}};
  };

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
   *   values are extrapolated from the reduced Gauss points. Where p = 1 these
   *   would be the middle alone, which knows no bending: two points are taken,
   *   along any coordinate with one element, and what the element locks by.
   * - A corner on the edge of a larger element takes what that one has there.
   * - Where degrees differ from element to element (nodes of LE-1 beside LE-2)
   *   each has its own Gauss points, and a patch the least degree of its
   *   elements.
   * - Along coordinates in which Body::recovery_degrees() is zero values are
   *   those at the point itself: Taylor theories are recovered along the axis
   *   only.
   *
   * Only the patches that requests need are fitted, each once.
   *
   * One object is the recovery of one state of one body: what it has fitted it
   * keeps, by the first of the places that meet at a corner, and nothing tells
   * it that @p u has changed. A patch of eight brick elements of degree p has 8
   * p^3 Gauss points, each of which costs a Body::sample().
   */
  class StressRecovery
  {
  public:
    /// @p body and the displacements @p u are referred to and have to stay as
    /// they are. Nothing is computed yet. @p values are not `equilibrium`,
    /// which is EquilibriumStress.
    StressRecovery(const Body        &body,
                   const Vector      &u,
                   const StressValues values);

    /// All fields at @p location, in scene axes and in ply axes as
    /// Body::sample() gives them, strains and stresses replaced by those of the
    /// chosen kind. Fits what has not been fitted yet, so it is not const.
    FieldSample
    sample(const Location &location);

  private:
    using Place = Location::Place;

    /// A place without the rounding of its unit coordinates. The cell, and unit
    /// coordinates to 1e-9. Places of one point in different cells have
    /// different keys; the one with the smallest cell stands for them.
    using Key = std::pair<unsigned int, std::array<long, 3>>;

    /// What a node takes its values from: a weighted sum of fits. The weights
    /// sum to 1; the fits belong to this object.
    using Source = std::vector<std::pair<double, const PatchFit *>>;

    static Key
    key_of(const Place &place);

    /// The element's own strains and stresses at @p place.
    FieldValues
    element_values(const unsigned int ply, const Place &place) const;

    /// The continuous field in the element of @p place. sum_v N_v(X) P_v(X)
    /// above, or of `nodal` the interpolation of the nodes' means.
    FieldValues
    field(const unsigned int ply, const Place &place);

    /// The nodes of the element of @p place with their shape functions there;
    /// along coordinates without recovery they stay at @p place. Of `recovered`
    /// the corners (trilinear N_v), of `nodal` the Gauss-Lobatto points of the
    /// displacements' degrees. They sum to 1.
    std::vector<std::pair<Place, double>>
    nodes(const Place &place) const;

    /// Whether @p place is at a node of its element. To 1e-4 of the element: on
    /// the edge of a larger element a corner of a smaller one is none.
    bool
    is_node(const Place &place) const;

    /// Where @p place is in each element of the ply that holds the point. By
    /// ascending cells, @p place itself among them: the patch of a corner.
    const std::vector<Place> &
    meeting(const unsigned int ply, const Place &place);

    /// What the field takes at @p node, the same from all elements that share
    /// it: that makes it continuous.
    const Source &
    source(const unsigned int ply, const Place &node);

    /// The fit of the patch at @p node, whatever its neighbours have. Of
    /// `nodal` the constant mean of the elements there.
    const PatchFit &
    own_fit(const unsigned int ply, const Place &node);

    /// The degrees of a patch's fit: the least of its @p elements
    /// (Body::recovery_degrees_of()).
    std::array<unsigned int, 3>
    degrees_of(const std::vector<Place> &elements) const;

    /// The fits that @p node takes, as above. Its own where that fixes all
    /// terms; else the richest, and of those the ones that share most elements,
    /// their mean where several do.
    Source
    best_fits(const unsigned int ply, const Place &node);

    /// Whether @p element, linear along its coordinate @p d, has no neighbour
    /// there in its ply.
    bool
    is_one_linear_layer(const unsigned int ply,
                        Place              element,
                        const unsigned int d);

    /// The values at the reduced Gauss points of @p elements: as many a
    /// coordinate as its degree, the superconvergent points.
    std::vector<PatchPoint>
    patch_points(const unsigned int ply, const std::vector<Place> &elements);

    /// The different directions of edges in a patch. The mean edges of each
    /// element, in columns; frames whose columns have the same directions in
    /// any order count once.
    std::vector<dealii::Tensor<2, 3>>
    frames(const std::vector<Place> &elements) const;

    const Body        &body;
    const Vector      &u;
    const StressValues kind;
    /// Body::recovery_degrees(): 0 along coordinates without recovery.
    const std::array<unsigned int, 3> degrees;
    /// Unit coordinates of an element's nodes along each coordinate. From 0 to
    /// 1; empty along coordinates without recovery.
    std::array<std::vector<double>, 3> node_coordinates;

    /// What is known so far: patches of corners, values at the Gauss points of
    /// elements, fits and sources.
    std::map<Key, std::vector<Place>>              meetings;
    std::map<Key, std::vector<PatchPoint>>         gauss_points;
    std::map<Key, std::unique_ptr<const PatchFit>> fits;
    std::map<Key, Source>                          sources;
  };
} // namespace lamella

#endif
