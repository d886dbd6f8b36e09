// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_theory_h
#define lamella_section_theory_h

#include <lamella/base/entry.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * A structural theory: the cross-section expansion of a beam and the
   * completion of its strains (the paper's Sec. 2; doc/theory/theories.md).
   *
   * - EBBT, Euler-Bernoulli: sections stay plane and normal to the axis
   *   (Kirchhoff's constraint, exact, needs B4).
   * - TBT, Timoshenko: sections stay plane, u_y is linear over the section.
   *   Neither can twist.
   * - TE-N: all polynomials of degree N for each component (Eq. 2), an
   *   equivalent single layer.
   * - LE-N: layer-wise Lagrange elements of degree N (Eq. 3), L4, L9, L16 for N
   *   = 1, 2, 3.
   * - SV-N, Saint-Venant: the six rigid motions of a section and its six
   *   Saint-Venant warpings, with the full three-dimensional law, and the
   *   responses at N wave numbers to loads and contacts; SV is SV-0. The fields
   *   are made of those of LE (section_order).
   * - solid-N: hexahedra of degree N, 1 or 2, without section fields.
   *
   * The displacement components have the same functions F_tau, except u_x and
   * u_z of EBBT and TBT, constant over the section.
   */
  struct Theory
  {
    /// Kind; `undefined` is the default only, never from parse().
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
    /// N of TE-N, LE-N, SV-N and solid-N; 1 for the classical theories.
    unsigned int order = 0;
    /// Degree of the LE whose fields those of SV-N are made of.
    unsigned int section_order = default_section_order;

    static constexpr unsigned int default_section_order = 3;

    /// Flag for LE, also that of SV: functions are hierarchical by degree
    /// (LagrangeElement::Basis). Bodies whose nodes mix degrees need it.
    bool hierarchical = false;

    /// Flag: sections of EBBT, TBT and TE-1 contract freely under bending.
    /// Otherwise Poisson locking makes deflections some 26 % too small at nu =
    /// 0.3. EBBT and TBT condense sigma_xx = sigma_zz = sigma_xz = 0 out of the
    /// law of each ply; TE-1 condenses quadratic contraction modes of the
    /// section.
    bool poisson_correction = true;
    /// Factor k on the shear stiffness of TBT, G A -> k G A, above 0 and at
    /// most 1 (5/6 for rectangles of one material, 1 in the paper). Reported
    /// stresses contain it.
    double shear_factor = 1.;
    /// Flag of TBT: sections also rotate about the axis, a sixth field of
    /// stiffness G times the polar moment. For finite rotations
    /// (of_rotating()).
    bool twists = false;

    /// Returns LE-@p order.
    static Theory
    layer_wise(const unsigned int order)
    {
      Theory result;
      result.kind  = Kind::LE;
      result.order = order;
      return result;
    }

    /// Returns the name for messages: EBBT, TE-4, solid-2, LE-2 (L9).
    std::string
    name() const;

    /// Returns true for theories of five fields: no torsion, no warping.
    bool
    is_classical() const
    {
      return kind == Kind::EBBT || kind == Kind::TBT;
    }

    // Queries of other rooms, instead of the kind.

    /// Returns true for hexahedra, without a section expansion.
    bool
    is_solid() const
    {
      return kind == Kind::solid;
    }
    /// Returns true if one polynomial spans all plies: EBBT, TBT and TE.
    bool
    is_single_layer() const
    {
      return is_classical() || is_taylor();
    }
    /// Returns true for a complete polynomial in each component.
    bool
    is_taylor() const
    {
      return kind == Kind::TE;
    }
    /// Returns true if each section cell has functions of its own.
    bool
    is_layerwise() const
    {
      return kind == Kind::LE;
    }
    /// Returns true if the fields are solutions on the section for loads and
    /// contacts of a scene; the order is the number of waves.
    bool
    is_saint_venant() const
    {
      return kind == Kind::SV;
    }
    /// Returns true for responses at wave numbers, SV-N with N of 1 or more.
    bool
    has_responses() const
    {
      return is_saint_venant() && order > 0;
    }
    /// Returns true if sections stay normal to the axis (no shear strain).
    bool
    keeps_sections_normal() const
    {
      return kind == Kind::EBBT;
    }
    /// Returns true if sections of bodies with finite rotations rotate rigidly
    /// and deform in their own axes. Other theories are total Lagrangian.
    bool
    has_rotating_sections() const
    {
      return is_classical() || is_saint_venant();
    }
    /// Returns the theory for finite rotations: TBT that twists for EBBT and
    /// TBT, else this one.
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
    /// Returns true if u_x and u_z are more than linearover sections.
    bool
    describes_contraction() const
    {
      return !is_single_layer() || order > 1;
    }

    /// Returns the SV of @p waves wave numbers made of this LE-N.
    Theory
    to_saint_venant(const unsigned int waves) const;

    /// Returns true if the theory contains the displacements of @p other: one
    /// family (TE includes EBBT and TBT), and no lower order.
    bool
    holds(const Theory &other) const;

    /// Return LE of @p order, SV of @p waves wave numbers made of LE of
    /// @p degree, TE and solid of @p order.
    static Theory
    layerwise(const unsigned int order);
    static Theory
    make_saint_venant(const unsigned int waves, const unsigned int degree);
    static Theory
    taylor(const unsigned int order);
    static Theory
    solid(const unsigned int order);

    /// Returns the theory of the Section with the fields(LE for SV-N).
    Theory
    of_section() const;

    /// Returns the theory spelled in @p entry. Throws InputError for anything
    /// else. N is 1 to 20 for TE, 1 to 8 for LE, 1 to 2 for solid, and 0 to 40
    /// for SV.
    static Theory
    parse(const Entry &entry);
  };

  /// Names before the `-N` of theories with an order.
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

  /// Theories of pieces of the axis, from break to break; may be empty.
  struct TheoryPieces
  {
    std::vector<Theory> theories;
    /// Distances from the start, ascending, one fewer than theories [length].
    std::vector<double> breaks;

    bool
    empty() const
    {
      return theories.empty();
    }

    /// Returns the theory whose fields are managed automatically: the first
    /// SV-N of the largest N, else the LE of the highest degree. Its section
    /// order is that of all pieces.
    Theory
    leading() const;
  };

  /// Theory entries of a body's `subsection Kinematics`.
  struct TheoryParameters
  {
    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the theory, by default @p scene_theory. Throws InputError, also
    /// if the shear factor is not above 0 and at most 1.
    static Theory
    parse(const Entries &in, const Entry &scene_theory);

    /// Returns `Theories` and `Theory breaks` of a body of @p length, empty if
    /// not given. Throws InputError for theories other than LE and SV, a number
    /// of theories that is not that of pieces, SV-N of different N, a section
    /// order below the highest LE degree, and breaks that do not ascend. All
    /// have one section order, and are hierarchical if an LE is of a lower
    /// degree.
    static TheoryPieces
    parse_pieces(const Entries &in, const double length);
  };

  /// Compares all members, as a key of theories that share section fields.
  bool
  operator<(const Theory &a, const Theory &b);
} // namespace lamella

#endif
