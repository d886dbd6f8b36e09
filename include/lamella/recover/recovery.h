// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `recover`: better stresses than those of the elements, and values
// at requested places. It owns the recovery by patches and by equilibrium
// and the sampling of probes, lines and cuts into Results. It never changes
// the solution.

#ifndef lamella_recover_recovery_h
#define lamella_recover_recovery_h

#include <lamella/base/names.h>
#include <lamella/body/body.h>

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  /// Strain, stress and stress in ply axes, each six components (Voigt order).
  using FieldValues = dealii::Tensor<1, 18>;

  /// Strains and stresses at a superconvergent point of an element.
  struct PatchPoint
  {
    dealii::Point<3> position; ///< Undeformed position, scene axes [length].
    FieldValues      values;   ///< Strains and stresses at the position.
  };

  /// Least-squares polynomial through values at points, with a degree for each
  /// of three local coordinates. Terms are products of Legendre polynomials
  /// over the bounding box of the points, ordered by total degree. A term is
  /// omitted if less than a tenth of the vector of its values at the points is
  /// orthogonal to the terms before it. If none is omitted, polynomials of the
  /// given degrees are reproduced. A fit of m points and n terms costs m n^2
  /// operations (orthogonalization instead of normal equations).
  class PatchFit
  {
  public:
    /// Constructs a constant polynomial that has the @p values everywhere.
    explicit PatchFit(const FieldValues &values);

    /// Fits @p points in local coordinates along the columns of each of
    /// @p frames (edges of elements, of any length). The polynomial is the mean
    /// of these fits, so that it is independent of the order of the elements.
    /// It has (degrees[0] + 1) (degrees[1] + 1) (degrees[2] + 1) terms of at
    /// most degree degrees[d] in coordinate d.
    PatchFit(const std::vector<PatchPoint>           &points,
             const std::vector<dealii::Tensor<2, 3>> &frames,
             const std::array<unsigned int, 3>       &degrees);

    /// Returns the value of the polynomial at the point @p x (scene axes).
    FieldValues
    operator()(const dealii::Point<3> &x) const;

    /// Returns the number of polynomial terms that the fitted points determine.
    unsigned int
    rank() const
    {
      return n_terms;
    }

  private:
    /// Degrees of a product of three Legendre polynomials, one per coordinate.
    using Term = std::array<unsigned int, 3>;

    /// The fitted polynomial in the coordinates of one frame.
    struct Polynomial
    {
      /// Map to coordinates in which the box [-1, 1]^3 bounds the points.
      dealii::Tensor<2, 3> to_box;
      dealii::Point<3>     center;
      /// Terms by total degree, and their coefficients; 0 for omitted terms.
      std::vector<Term>        terms;
      std::vector<FieldValues> coefficients;

      /// Returns the values of all terms at the point @p x, scene axes.
      std::vector<double>
      basis(const dealii::Point<3> &x) const;

      /// Fits the coefficients to @p points. Returns the number of terms used.
      unsigned int
      fit(const std::vector<PatchPoint> &points);
    };

    /// Returns all terms up to @p degrees, ordered by total degree.
    static std::vector<Term>
    terms_of(const std::array<unsigned int, 3> &degrees);

    /// Returns a polynomial with the terms up to @p degrees on the bounding box
    /// of @p points in the coordinates of @p frame, without coefficients. The
    /// box may be flat along coordinates of degree 0.
    static Polynomial
    in_frame(const std::vector<PatchPoint>     &points,
             const dealii::Tensor<2, 3>        &frame,
             const std::array<unsigned int, 3> &degrees);

    /// Fitted polynomial of each frame; empty if this object is a constant.
    std::vector<Polynomial> polynomials;
    FieldValues             constant;
    unsigned int            n_terms = 1;
  };

  /// Method by which strains and stresses are computed at a point that several
  /// elements of a ply share. Values of different plies are never averaged.
  enum class StressValues
  {
    undefined,
    element,    ///< mean over the elements that contain the point
    nodal,      ///< means at nodes over adjacent elements, interpolated
    recovered,  ///< superconvergent patch recovery
    equilibrium ///< recovered, but transverse stresses by equilibrium
  };

  /// Names of the values of StressValues in parameter files.
  template <>
  struct Names<StressValues>
  {
    /// Value and name of each method to compute stresses.
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
  /// - The patch of a corner on a surface may determine fewer terms than that
  ///   of another corner of the same elements. The polynomial of the corner
  ///   with most terms and most shared elements is then used.
  /// - If a ply has one element through its thickness, the polynomial has
  ///   degree p - 1 there. If p = 1, two points are used along such a
  ///   coordinate, since the center alone does not detect bending; locking
  ///   errors are then included.
  /// - At a hanging node, the field of the larger element is used.
  /// - If degrees differ between elements (LE-1 beside LE-2), the patch has the
  ///   lowest degree.
  /// - Taylor theories are recovered along the axis only.
  /// Each patch is fitted when first needed. A patch of eight bricks of degree
  /// p costs 8 p^3 calls of Body::sample().
  class StressRecovery
  {
  public:
    /// Keeps references to @p body and the displacements @p u, which must not
    /// change. @p values must not be `equilibrium` (see EquilibriumStress).
    StressRecovery(const Body        &body,
                   const Vector      &u,
                   const StressValues values);

    /// Returns the fields at @p location, with strains and stresses of the kind
    /// that was passed to the constructor. Patches that are needed are fitted.
    FieldSample
    sample(const Location &location);

  private:
    using Place = Location::Place;

    /// Unique key of a point in caches: the smallest index of the elements that
    /// contain the point, and unit coordinates in it, rounded to 1e-9.
    using Key = std::pair<unsigned int, std::array<long, 3>>;

    /// Recovered field of a node: polynomials and their weights in a sum.
    using Source = std::vector<std::pair<double, const PatchFit *>>;

    static Key
    key_of(const Place &place);

    /// Returns the discontinuous element strains and stresses at @p place.
    FieldValues
    element_values(const unsigned int ply, const Place &place) const;

    /// Returns the continuous strains and stresses at @p place: the polynomials
    /// of the nodes of its element, weighted by their shape functions.
    FieldValues
    field(const unsigned int ply, const Place &place);

    /// Returns the nodes of the element of @p place, each with the value of its
    /// shape function at @p place. Nodes are the corners for `recovered`
    /// stresses and Gauss-Lobatto points for `nodal` stresses.
    std::vector<std::pair<Place, double>>
    nodes(const Place &place) const;

    /// Returns true if @p place is a node of its element (not a hanging node).
    bool
    is_node(const Place &place) const;

    /// Returns the point @p place in each element of the ply that contains it.
    const std::vector<Place> &
    meeting(const unsigned int ply, const Place &place);

    /// Returns the recovered field at @p node as a weighted sum of polynomials.
    const Source &
    source(const unsigned int ply, const Place &node);

    /// Returns the polynomial fitted to the patch of elements at @p node; for
    /// `nodal` stresses the mean of the elements' values.
    const PatchFit &
    own_fit(const unsigned int ply, const Place &node);

    /// Returns the lowest polynomial degree of @p elements in each coordinate.
    std::array<unsigned int, 3>
    degrees_of(const std::vector<Place> &elements) const;

    /// Returns the polynomial of the patch at @p node if the patch determines
    /// all terms. Otherwise returns the mean of the polynomials of those
    /// corners that determine most terms and share most elements.
    Source
    best_fits(const unsigned int ply, const Place &node);

    /// Returns true if @p element has degree 1 and no neighbor along @p d.
    bool
    is_one_linear_layer(const unsigned int ply,
                        Place              element,
                        const unsigned int d);

    /// Returns strains and stresses at the reduced Gauss points of @p elements.
    std::vector<PatchPoint>
    patch_points(const unsigned int ply, const std::vector<Place> &elements);

    /// Returns the edge vectors (columns) of @p elements, without duplicates.
    std::vector<dealii::Tensor<2, 3>>
    frames(const std::vector<Place> &elements) const;

    const Body        &body;
    const Vector      &u;
    const StressValues kind;
    /// Polynomial degree in each coordinate; 0 in coordinates without recovery.
    const std::array<unsigned int, 3> degrees;
    /// Unit coordinates of the nodes of an element; empty without recovery.
    std::array<std::vector<double>, 3> node_coordinates;

    /// Caches of patches, Gauss point values, polynomials and fields of nodes.
    std::map<Key, std::vector<Place>>              element_patches;
    std::map<Key, std::vector<PatchPoint>>         gauss_points;
    std::map<Key, std::unique_ptr<const PatchFit>> fits;
    std::map<Key, Source>                          sources;
  };
} // namespace lamella

#endif
