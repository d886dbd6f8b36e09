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
  ///   section (Eq. 2), an equivalent single layer theory.
  /// - LE-N: layer-wise Lagrange elements of degree N (Eq. 3), L4, L9, L16 for
  ///   N = 1, 2, 3.
  /// - SV-N, Saint-Venant: the six rigid motions of a section, its six
  ///   Saint-Venant warpings, and section functions from harmonic loads at N
  ///   wave numbers for the loads and contacts of the scene; SV is SV-0. All
  ///   are computed with LE of degree section_order.
  /// - solid-N: hexahedral elements of degree N = 1 or 2.
  ///
  /// All displacement components have the same functions F_tau, except that u_x
  /// and u_z are constant over the section for EBBT and TBT.
  struct Theory
  {
    /// Kind of theory; parse() never returns the default, `undefined`.
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
    Kind kind = Kind::undefined;
    /// N of TE-N, LE-N, SV-N and solid-N; 1 for EBBT and TBT.
    unsigned int order = 0;
    /// Degree of the LE with which the functions of SV-N are computed.
    unsigned int section_order = default_section_order;

    static constexpr unsigned int default_section_order = 3;

    /// True if the functions of LE, also for SV, are hierarchical by degree
    /// (see LagrangeElement::Basis). Required if nodes have different degrees.
    bool hierarchical = false;

    /// True if sections of EBBT, TBT and TE-1 contract freely under bending
    /// (StrainCompletion). Otherwise, Poisson locking makes deflections about
    /// 26 % too small at nu = 0.3.
    bool poisson_correction = true;
    /// Shear correction factor k of TBT, 0 < k <= 1: the shear stiffness is k G
    /// A (5/6 for homogeneous rectangles, 1 in the paper). Stresses include k.
    double shear_factor = 1.;
    /// True if sections of TBT also rotate about the axis, with the torsional
    /// stiffness G I_p of the polar moment I_p (see of_rotating()).
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

    /// Returns true for EBBT and TBT, without torsion and warping.
    bool
    is_classical() const
    {
      return kind == Kind::EBBT || kind == Kind::TBT;
    }

    // Properties, to be used instead of comparing the kind.

    /// Returns true for solid elements, without a section expansion.
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
    /// Returns true for SV-N, whose functions are computed from solutions on
    /// the section; N is the number of wave numbers.
    bool
    is_saint_venant() const
    {
      return kind == Kind::SV;
    }
    /// Returns true for SV-N, N >= 1: section functions from harmonic loads.
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
    /// Returns true if, for finite rotations, sections rotate rigidly and
    /// deform in corotated axes. Other theories are total Lagrangian.
    bool
    has_rotating_sections() const
    {
      return is_classical() || is_saint_venant();
    }
    /// Returns the theory for finite rotations: TBT with `twists` for EBBT and
    /// TBT, otherwise this theory.
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
    /// Returns true if sections can rotate about the axis.
    bool
    can_twist() const
    {
      return !is_classical() || twists;
    }
    /// Returns true if u_x and u_z are more than linear over sections.
    bool
    describes_contraction() const
    {
      return !is_single_layer() || order > 1;
    }

    /// Returns SV with @p waves wave numbers and the LE-N of this object.
    Theory
    to_saint_venant(const unsigned int waves) const;

    /// Returns true if the displacements of this theory include those of
    /// @p other: both have the same kind (TE includes EBBT and TBT), and the
    /// order of @p other is not higher.
    bool
    holds(const Theory &other) const;

    /// Return LE, SV, TE and solid theories. For SV, @p waves is the number of
    /// wave numbers and @p degree the degree of the LE of its functions.
    static Theory
    layerwise(const unsigned int order);
    static Theory
    make_saint_venant(const unsigned int waves, const unsigned int degree);
    static Theory
    taylor(const unsigned int order);
    static Theory
    solid(const unsigned int order);

    /// Returns the theory of the Section object: LE for SV-N, else this theory.
    Theory
    of_section() const;

    /// Returns the theory named in @p entry. Throws InputError for other text.
    /// N is 1 to 20 for TE, 1 to 8 for LE, 1 to 2 for solid, 0 to 40 for SV.
    static Theory
    parse(const Entry &entry);
  };

  /// Names of the kinds, to which `-N` is added if the theory has an order.
  template <>
  struct Names<Theory::Kind>
  {
    static constexpr NameOf<Theory::Kind> all[] = {{Theory::Kind::EBBT, "EBBT"},
                                                   {Theory::Kind::TBT, "TBT"},
                                                   {Theory::Kind::TE, "TE"},
                                                   {Theory::Kind::LE, "LE"},
                                                   {Theory::Kind::SV, "SV"},
                                                   {Theory::Kind::solid,
                                                    "solid"}};
  };

  /// Different theories in successive intervals of the axis; may be empty.
  struct TheoryPieces
  {
    std::vector<Theory> theories;
    /// Coordinates y at which intervals end, ascending [length].
    std::vector<double> breaks;

    bool
    empty() const
    {
      return theories.empty();
    }

    /// Returns the theory that contains the functions of all intervals: the
    /// first SV-N with the largest N, else the LE of the highest degree. All
    /// intervals have the section order of this theory.
    Theory
    leading() const;
  };

  /// Declares and parses the theory in a body's `subsection Kinematics`.
  struct TheoryParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the theory of the body, by default @p scene_theory. Throws
    /// InputError for invalid entries or a shear factor outside of (0, 1].
    static Theory
    parse(const Entries &in, const Entry &scene_theory);

    /// Returns `Theories` and `Theory breaks` of a body of @p length; empty if
    /// they are not set. All theories have the same section order, and are
    /// hierarchical if LE degrees differ from it. Throws InputError for
    /// theories other than LE and SV, a number of theories different from the
    /// number of intervals, SV-N with different N, a section order below the
    /// highest LE degree, and breaks that do not ascend.
    static TheoryPieces
    parse_pieces(const Entries &in, const double length);
  };

  /// Lexicographic comparison of all members, for use as a key.
  bool
  operator<(const Theory &a, const Theory &b);
} // namespace lamella

#endif
