// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `recover`: better stresses than those of the elements, and values
// at requested places. It owns the recovery by patches and by equilibrium
// and the sampling of probes, lines and cuts into Results. It never changes
// the solution.

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
  /// Kind of strains and stresses at points shared by elements of a ply (axis
  /// elements times section cells, or hexahedra). Plies are never averaged.
  enum class StressValues
  {
    undefined,
    element,    ///< mean over the elements that contain the point
    nodal,      ///< means at nodes over adjacent elements, interpolated
    recovered,  ///< superconvergent patch recovery
    equilibrium ///< recovered, but transverse stresses by equilibrium
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

  /// Strains and stresses that are continuous within a ply, computed from the
  /// discontinuous values of the elements. Displacements and FieldSample::jump
  /// are element values.
  ///
  /// `nodal`: the mean over the elements that share a node, interpolated
  /// between the nodes of each element (Gauss-Lobatto points of the
  /// displacements' degree p). At a surface the error is O(h^p).
  ///
  /// `recovered`: superconvergent patch recovery (Zienkiewicz and Zhu, Int. J.
  /// Numer. Meth. Eng. 33 (1992) 1331-1364). In the patch of all elements at a
  /// corner v, a polynomial P_v of degree p in each local coordinate is fitted
  /// to the values at the reduced Gauss points (p per coordinate), which
  /// converge with h^(p+1). Within an element
  ///   sigma(X) = sum_v N_v(X) P_v(X),   N_v trilinear, v its corners,
  /// which is continuous and reproduces what the fits reproduce (Blacker and
  /// Belytschko, Int. J. Numer. Meth. Eng. 37 (1994) 517-536).
  /// - A corner whose patch determines fewer terms than another corner of the
  ///   same elements, such as on a surface, uses the polynomial of the corner
  ///   that shares most of its elements.
  /// - A ply with one element through its thickness determines degree p - 1:
  ///   values are extrapolated from the reduced Gauss points. If p = 1, two
  ///   points are used along coordinates with one element, since the center
  ///   alone does not detect bending; locking errors are then included.
  /// - A corner on the edge of a larger element uses that element's values.
  /// - If degrees differ between elements (LE-1 beside LE-2), each has its own
  ///   Gauss points, and the patch has the lowest degree.
  /// - Along coordinates with zero Body::recovery_degrees(), the values at the
  ///   point are used: Taylor theories are recovered along the axis only.
  /// Each patch is fitted once, when first needed, for one state of one body. A
  /// patch of eight bricks of degree p costs 8 p^3 calls of Body::sample().
  class StressRecovery
  {
  public:
    /// Keeps references to @p body and the displacements @p u, which must not
    /// change. @p values must not be `equilibrium` (see EquilibriumStress).
    StressRecovery(const Body        &body,
                   const Vector      &u,
                   const StressValues values);

    /// Returns all fields at @p location as Body::sample(), with strains and
    /// stresses of the chosen kind. Fits missing patches.
    FieldSample
    sample(const Location &location);

  private:
    using Place = Location::Place;

    /// Cell and unit coordinates of a point, rounded to 1e-9; of several cells
    /// at a point, the smallest cell number.
    using Key = std::pair<unsigned int, std::array<long, 3>>;

    /// Recovered field at a node: weights and patch fits owned by this object.
    using Source = std::vector<std::pair<double, const PatchFit *>>;

    static Key
    key_of(const Place &place);

    /// Returns the strains and stresses of the element itself at @p place.
    FieldValues
    element_values(const unsigned int ply, const Place &place) const;

    /// Returns the continuous field in the element of @p place: sum_v N_v P_v,
    /// or for `nodal` the interpolated means.
    FieldValues
    field(const unsigned int ply, const Place &place);

    /// Returns the nodes of the element at @p place, each with its shape
    /// function at @p place: corners (trilinear N_v) for `recovered`,
    /// Gauss-Lobatto points for `nodal`, only along recovered coordinates.
    std::vector<std::pair<Place, double>>
    nodes(const Place &place) const;

    /// Returns true if @p place is at a node of its element, to 1e-4 of its
    /// size. A smaller element's corner on its edge is no node.
    bool
    is_node(const Place &place) const;

    /// Returns point @p place in each element of the ply that contains it.
    const std::vector<Place> &
    meeting(const unsigned int ply, const Place &place);

    /// Returns the fits for the values at @p node, equal for all elements.
    const Source &
    source(const unsigned int ply, const Place &node);

    /// Returns the fit of the patch at @p node; for `nodal` its mean.
    const PatchFit &
    own_fit(const unsigned int ply, const Place &node);

    /// Returns the lowest degrees of @p elements (Body::recovery_degrees_of()).
    std::array<unsigned int, 3>
    degrees_of(const std::vector<Place> &elements) const;

    /// Returns the fits used at @p node: its own if it determines all terms;
    /// else the mean over the corners with most terms and shared elements.
    Source
    best_fits(const unsigned int ply, const Place &node);

    /// Returns true if @p element, linear along @p d, has no neighbor along d.
    bool
    is_one_linear_layer(const unsigned int ply,
                        Place              element,
                        const unsigned int d);

    /// Returns the values at the superconvergent reduced Gauss points.
    std::vector<PatchPoint>
    patch_points(const unsigned int ply, const std::vector<Place> &elements);

    /// Returns the distinct frames of mean element edges in a patch, as
    /// columns, for any order of the element coordinates.
    std::vector<dealii::Tensor<2, 3>>
    frames(const std::vector<Place> &elements) const;

    const Body        &body;
    const Vector      &u;
    const StressValues kind;
    /// Body::recovery_degrees(): 0 along coordinates without recovery.
    const std::array<unsigned int, 3> degrees;
    /// Unit coordinates in [0, 1] of the nodes of an element, if recovered.
    std::array<std::vector<double>, 3> node_coordinates;

    /// Caches of element patches, values at Gauss points, fits and sources.
    std::map<Key, std::vector<Place>>              element_patches;
    std::map<Key, std::vector<PatchPoint>>         gauss_points;
    std::map<Key, std::unique_ptr<const PatchFit>> fits;
    std::map<Key, Source>                          sources;
  };
} // namespace lamella

#endif
