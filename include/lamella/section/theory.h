// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_theory_h
#define lamella_section_theory_h

#include <lamella/base/entry.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A structural theory of a body: for beams, the cross-section expansion and
  /// the correction of Poisson locking (doc/theory/theories.md).
  ///
  /// - EBBT, Euler-Bernoulli: sections stay plane and normal to the axis;
  ///   requires axis elements B4.
  /// - TBT, Timoshenko: sections stay plane; u_y is linear over the section.
  ///   EBBT and TBT have no torsion.
  /// - TE-N, Taylor: each component is a polynomial of degree N over the
  ///   section, an equivalent single layer theory (Nagaraj et al. 2020, Eq. 2).
  /// - LE-N: layer-wise Lagrange elements of degree N (Eq. 3), L4, L9, L16 for
  ///   N = 1, 2, 3.
  /// - SV-N, Saint-Venant: the six rigid motions of a section, its six
  ///   Saint-Venant warpings, and section functions from harmonic loads at N
  ///   wave numbers for the loads and contacts of the scene; SV is SV-0. All
  ///   are computed with LE of degree section_order.
  /// - solid-N: hexahedral elements of degree N = 1 or 2.
  ///
  /// All displacement components have the same section functions, except that
  /// u_x and u_z are constant over the section for EBBT and TBT.
  struct Theory
  {
    /// Kinds of theory (see Theory); `undefined` before parse().
    enum class Kind
    {
      undefined,
      EBBT,
      TBT,
      TE,
      LE,
      SV,
      solid
    };
    Kind kind = Kind::undefined; ///< Kind of theory, without its order N.
    /// N of TE-N, LE-N, SV-N and solid-N; 1 for EBBT and TBT.
    unsigned int order = 0;
    /// Degree of the LE with which the functions of SV-N are computed.
    unsigned int section_order = default_section_order;

    /// Default of section_order.
    static constexpr unsigned int default_section_order = 3;

    /// True if the functions of LE (also of the LE for SV) have a hierarchical
    /// basis, required if axis nodes have different degrees; false for nodal
    /// functions (LagrangeElement::Basis).
    bool hierarchical = false;

    /// True if sections of EBBT, TBT and TE-1 contract freely under bending
    /// (StrainCompletion). If false, they are 35 % too stiff at nu = 0.3.
    bool poisson_correction = true;
    /// Shear correction factor k of TBT, 0 < k <= 1, for the shear stiffness k
    /// G A, e.g. 5/6 for homogeneous rectangles. Stresses include k.
    double shear_factor = 1.;
    /// True if sections of TBT also rotate about the axis, with the torsional
    /// stiffness G I_p and polar moment of area I_p; false for no torsion.
    bool twists = false;

    /// Returns the theory LE-@p order.
    static Theory
    layer_wise(const unsigned int order)
    {
      Theory result;
      result.kind  = Kind::LE;
      result.order = order;
      return result;
    }

    /// Returns the name for messages, e.g. EBBT, TE-4, solid-2, LE-2 (L9).
    std::string
    name() const;

    /// Returns true for EBBT and TBT, the theories without warping.
    bool
    is_classical() const
    {
      return kind == Kind::EBBT || kind == Kind::TBT;
    }

    // Properties, to be used instead of comparing the kind.

    /// Returns true for solid elements, which have no cross-section expansion.
    bool
    is_solid() const
    {
      return kind == Kind::solid;
    }
    /// Returns true for equivalent single layer theories: EBBT, TBT and TE.
    bool
    is_single_layer() const
    {
      return is_classical() || is_taylor();
    }
    /// Returns true for Taylor expansions TE-N.
    bool
    is_taylor() const
    {
      return kind == Kind::TE;
    }
    /// Returns true for layer-wise Lagrange expansions LE-N.
    bool
    is_layerwise() const
    {
      return kind == Kind::LE;
    }
    /// Returns true for SV-N, the theory of Saint-Venant warpings and of
    /// section functions computed from harmonic loads at N wave numbers.
    bool
    is_saint_venant() const
    {
      return kind == Kind::SV;
    }
    /// Returns true for SV-N, N >= 1, with functions from harmonic loads.
    bool
    has_responses() const
    {
      return is_saint_venant() && order > 0;
    }
    /// Returns true if sections stay normal to the axis (EBBT).
    bool
    keeps_sections_normal() const
    {
      return kind == Kind::EBBT;
    }
    /// Returns true for theories (EBBT, TBT, SV) whose sections, for finite
    /// rotations, rotate rigidly and deform in corotated axes.
    bool
    has_rotating_sections() const
    {
      return is_classical() || is_saint_venant();
    }
    /// Returns the theory used for finite rotations: for EBBT and TBT,
    /// Timoshenko's theory with torsion (`twists`), otherwise this theory.
    Theory
    of_rotating() const
    {
      Theory result = *this;
      if (!is_classical())
        return result;
      if (keeps_sections_normal())
        result.shear_factor = 1.;
      result.kind   = Kind::TBT;
      result.twists = true;
      return result;
    }
    /// Returns true if sections can rotate about the beam axis.
    bool
    can_twist() const
    {
      return !is_classical() || twists;
    }
    /// Returns true if u_x and u_z are at least quadratic over the section, so
    /// that lateral contraction under bending needs no StrainCompletion.
    bool
    describes_contraction() const
    {
      return !is_single_layer() || order > 1;
    }

    /// Returns SV with @p waves wave numbers, whose functions are computed with
    /// this theory, which must be LE-N.
    Theory
    to_saint_venant(const unsigned int waves) const;

    /// Returns true if this theory includes all displacements of @p other: same
    /// kind (EBBT and TBT count as TE) and at least the order of @p other.
    bool
    holds(const Theory &other) const;

    /// Returns the layer-wise theory LE-@p order.
    static Theory
    layerwise(const unsigned int order);
    /// Returns SV-N with N = @p waves and functions computed with LE-@p degree.
    static Theory
    make_saint_venant(const unsigned int waves, const unsigned int degree);
    /// Returns the Taylor expansion TE-@p order.
    static Theory
    taylor(const unsigned int order);
    /// Returns the theory of solid elements of degree @p order.
    static Theory
    solid(const unsigned int order);

    /// Returns for SV-N the theory LE of its functions, else this theory.
    Theory
    of_section() const;

    /// Returns the theory named in @p entry: TE-N with N from 1 to 20, LE-N (1
    /// to 8), solid-N (1, 2), SV-N (0 to 40), EBBT or TBT; else throws
    /// InputError.
    static Theory
    parse(const Entry &entry);
  };

  /// Names of the kinds in parameter files; `-N` follows if there is an order.
  template <>
  struct Names<Theory::Kind>
  {
    /// Value and name of each kind except `undefined`.
    static constexpr NameOf<Theory::Kind> all[] = {{Theory::Kind::EBBT, "EBBT"},
                                                   {Theory::Kind::TBT, "TBT"},
                                                   {Theory::Kind::TE, "TE"},
                                                   {Theory::Kind::LE, "LE"},
                                                   {Theory::Kind::SV, "SV"},
                                                   {Theory::Kind::solid,
                                                    "solid"}};
  };

  /// Different theories in successive intervals of the axis of one beam; empty
  /// if the whole beam has the same theory.
  struct TheoryPieces
  {
    /// Theory of each interval, in the order of ascending y.
    std::vector<Theory> theories;
    /// Coordinates y between successive intervals, ascending [length].
    std::vector<double> breaks;

    /// Returns true if the whole beam has the same theory.
    bool
    empty() const
    {
      return theories.empty();
    }

    /// Returns the theory that contains the functions of all intervals: the
    /// SV-N with the largest N, else the LE of the highest degree. Its LE
    /// degree is used to compute the section functions of all intervals.
    Theory
    leading() const;
  };

  /// Declares and parses the theory in a body's `subsection Kinematics`.
  struct TheoryParameters
  {
    /// Declares the entries of the theory in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the theory of a body from the entries @p in, by default @p
    /// scene_theory. Throws InputError, e.g. for a shear factor not in (0, 1].
    static Theory
    parse(const Entries &in, const Entry &scene_theory);

    /// Returns the theories of the intervals of the axis of a body of
    /// @p length, from the entries `Theories` and `Theory breaks`; empty if
    /// they are not set. All have the same section order; they are hierarchical
    /// if LE degrees differ from it. Throws InputError unless
    /// - all are LE or SV, one per interval, and breaks ascend;
    /// - all SV-N have the same N;
    /// - the section order is at least the highest LE degree.
    static TheoryPieces
    parse_pieces(const Entries &in, const double length);
  };

  /// Lexicographic comparison of all members, for use as a key of a map.
  bool
  operator<(const Theory &a, const Theory &b);
} // namespace lamella

#endif
