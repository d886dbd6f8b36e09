// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `recover`: better stresses than those of the elements, and values at
// requested places. It owns the recovery by patches and by equilibrium and the
// sampling of probes, lines and cuts into Results.

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
  /// Kind of strains and stresses where elements (axis elements times section
  /// cells, or hexahedra) of one ply meet. Plies are never averaged.
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
   * Strains and stresses that are continuous within a ply, from the
   * discontinuous ones of the elements. Displacements and FieldSample::jump
   * stay those of the elements.
   *
   * `nodal`: the mean over the elements that share a node, interpolated over
   * each element's nodes (Gauss-Lobatto points of the displacements' degree p).
   * At a surface it is one-sided and converges with h^p.
   *
   * `recovered`: superconvergent patch recovery (Zienkiewicz and Zhu, Int. J.
   * Numer. Meth. Eng. 33 (1992) 1331-1364). In the patch of all elements at a
   * corner v, a polynomial P_v of degree p in each local coordinate is fitted
   * to the values at the reduced Gauss points (p per coordinate), which
   * converge with h^(p+1). Within an element
   *   sigma(X) = sum_v N_v(X) P_v(X),   N_v trilinear, v its corners,
   * which is continuous and reproduces what the fits reproduce (Blacker and
   * Belytschko, Int. J. Numer. Meth. Eng. 37 (1994) 517-536).
   * - A corner whose patch determines fewer terms than another corner of the
   *   same elements, as on a surface, takes the polynomial of the one that
   *   shares most of its elements.
   * - A ply of one element through its thickness determines degree p - 1:
   *   values are extrapolated from the reduced Gauss points. If p = 1, two
   *   points are used along any coordinate with one element, since the center
   *   alone misses bending; locking errors are then included.
   * - A corner on the edge of a larger element takes the larger one's values.
   * - If degrees differ between elements (LE-1 beside LE-2), each has its own
   *   Gauss points, and the patch has the least degree.
   * - Along coordinates with zero Body::recovery_degrees(), values are those at
   *   the point: Taylor theories are recovered along the axis only.
   * Patches are fitted on demand, each once, for one state of one body. A patch
   * of eight bricks of degree p takes 8 p^3 Body::sample().
   */
  class StressRecovery
  {
  public:
    /// Stores references to @p body and the constant displacements @p u. @p
    /// values must not be `equilibrium` (see EquilibriumStress).
    StressRecovery(const Body        &body,
                   const Vector      &u,
                   const StressValues values);

    /// Returns all fields at @p location as Body::sample(), with strains and
    /// stresses of the chosen kind. Fits missing patches.
    FieldSample
    sample(const Location &location);

  private:
    using Place = Location::Place;

    /// Cell and unit coordinates of a place, rounded to 1e-9; of several keys
    /// of a point, the smallest cell's.
    using Key = std::pair<unsigned int, std::array<long, 3>>;

    /// Weighted sum of fits of this object, a node's values; weights sum to 1.
    using Source = std::vector<std::pair<double, const PatchFit *>>;

    static Key
    key_of(const Place &place);

    /// Returns the element's own strains and stresses at @p place.
    FieldValues
    element_values(const unsigned int ply, const Place &place) const;

    /// Returns the continuous field in the element of @p place: sum_v N_v P_v,
    /// or for `nodal` the interpolated means.
    FieldValues
    field(const unsigned int ply, const Place &place);

    /// Returns the nodes of the element of @p place with their shape functions
    /// there: for `recovered` the corners (trilinear N_v), for `nodal` the
    /// Gauss-Lobatto points, along recovered coordinates.
    std::vector<std::pair<Place, double>>
    nodes(const Place &place) const;

    /// Returns whether @p place is at a node of its element, to 1e-4 of it. A
    /// smaller element's corner on a larger one's edge is none.
    bool
    is_node(const Place &place) const;

    /// Returns @p place in each element of the ply there, by ascending cells.
    const std::vector<Place> &
    meeting(const unsigned int ply, const Place &place);

    /// Returns the source of the field at @p node, equal for all its elements.
    const Source &
    source(const unsigned int ply, const Place &node);

    /// Returns the fit of the patch at @p node; for `nodal` its elements' mean.
    const PatchFit &
    own_fit(const unsigned int ply, const Place &node);

    /// Returns the least degrees of @p elements (Body::recovery_degrees_of()).
    std::array<unsigned int, 3>
    degrees_of(const std::vector<Place> &elements) const;

    /// Returns the fits used at @p node: its own if that determines all terms;
    /// else the richest of corners that share most elements, averaged.
    Source
    best_fits(const unsigned int ply, const Place &node);

    /// Returns whether @p element, linear along @p d, has no neighbor there.
    bool
    is_one_linear_layer(const unsigned int ply,
                        Place              element,
                        const unsigned int d);

    /// Returns the values at the superconvergent reduced Gauss points.
    std::vector<PatchPoint>
    patch_points(const unsigned int ply, const std::vector<Place> &elements);

    /// Returns the distinct frames of mean element edges in a patch, in
    /// columns, whatever the order of directions.
    std::vector<dealii::Tensor<2, 3>>
    frames(const std::vector<Place> &elements) const;

    const Body        &body;
    const Vector      &u;
    const StressValues kind;
    /// Body::recovery_degrees(): 0 along coordinates without recovery.
    const std::array<unsigned int, 3> degrees;
    /// Unit coordinates in [0, 1] of an element's nodes, if recovered.
    std::array<std::vector<double>, 3> node_coordinates;

    /// Caches: patches of corners, values at Gauss points, fits and sources.
    std::map<Key, std::vector<Place>>              element_patches;
    std::map<Key, std::vector<PatchPoint>>         gauss_points;
    std::map<Key, std::unique_ptr<const PatchFit>> fits;
    std::map<Key, Source>                          sources;
  };
} // namespace lamella

#endif
