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
   * A structural theory: which cross-section expansion a beam has, and what its
   * strains are completed with (the paper's Sec. 2).
   *
   * - EBBT, Euler-Bernoulli: u_x, u_y, u_z of the axis, sections stay plane and
   *   normal to the axis (Kirchhoff's constraint, exact, needs B4).
   * - TBT, Timoshenko: sections stay plane, u_y is linear over the section.
   *   Neither can twist.
   * - TE-N: all polynomials of degree N for each component (Eq. 2).
   * - LE-N: layer-wise Lagrange elements of degree N (Eq. 3), L4, L9, L16 for
   *   N = 1, 2, 3.
   * - SV-N, Saint-Venant: the six rigid motions of a section and its six
   *   Saint-Venant warpings, with the full three-dimensional law, and the
   *   responses at N wave numbers to whatever touches the body in its scene;
   *   SV is SV-0. The fields are made of those of LE (section_order).
   * - solid-N: no beam at all, but hexahedra of degree N, 1 or 2.
   *
   * In each the three displacement components have the same functions F_tau,
   * but for EBBT and TBT, where u_x and u_z are constant over the section. TE
   * is an equivalent single layer, LE is layer-wise. doc/theories.md compares
   * them. A plain value; Section makes the fields of it.
   */
  struct Theory
  {
    /// `undefined` is the default only, and what parse() never returns.
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
    /// Of SV-N the degree of the LE whose fields its own are made of.
    unsigned int section_order = default_section_order;

    static constexpr unsigned int default_section_order = 3;

    /// Of LE, and of the LE that SV is made of: whether the functions are
    /// hierarchical by degree, so that LE-q of lower degrees are parts of it
    /// (LagrangeElement::Basis). The space is the same; only bodies whose nodes
    /// mix degrees need it.
    bool hierarchical = false;

    /**
     * Whether sections of EBBT, TBT and TE-1, whose own functions cannot
     * follow the contraction under bending, contract freely (Poisson locking
     * otherwise). EBBT and TBT condense sigma_xx = sigma_zz = sigma_xz = 0 out
     * of the law of each ply; TE-1, which has stiffness in xx and zz of its
     * own, condenses quadratic contraction modes of the section.
     *
     * Without it a deflection is some 26 % too small at nu = 0.3. Other
     * theories contract by themselves and ignore it.
     */
    bool poisson_correction = true;
    /// Of TBT: multiplies the shear stiffness of sections, G A -> k G A. k,
    /// above 0 and at most 1, 5/6 for rectangles of one material; 1 as in the
    /// paper. Ignored by all others. Reported stresses have it, so that their
    /// resultant is the shear force.
    double shear_factor = 1.;
    /// Of TBT: whether its sections turn about the axis as well and keep their
    /// shape in that: a sixth field (RigidField), with G times the polar moment
    /// as its stiffness. For bodies that turn by any angle (of_turning()).
    bool twists = false;

    /// LE-@p order.
    static Theory
    layer_wise(const unsigned int order)
    {
      Theory result;
      result.kind  = Kind::LE;
      result.order = order;
      return result;
    }

    /// For messages and reports: EBBT, TBT, TE-4, solid-2; of LE with the
    /// element's name in the literature, LE-2 (L9). Not for parse().
    std::string
    name() const;

    /// Classical theories: 1, x, z for u_y alone. Their space is that of five
    /// fields: no torsion, no warping.
    bool
    is_classical() const
    {
      return kind == Kind::EBBT || kind == Kind::TBT;
    }

    // What others ask of a theory: no room above knows the kinds.

    /// Whether there is no expansion of a section at all, but hexahedra.
    bool
    is_solid() const
    {
      return kind == Kind::solid;
    }
    /// Whether one polynomial spans the whole section, over all plies: the
    /// classical theories and TE.
    bool
    is_single_layer() const
    {
      return is_classical() || is_taylor();
    }
    /// Whether it is a complete polynomial in each component.
    bool
    is_taylor() const
    {
      return kind == Kind::TE;
    }
    /// Whether each cell of a section has functions of its own, of a degree
    /// that is the theory's order.
    bool
    is_layerwise() const
    {
      return kind == Kind::LE;
    }
    /// Whether the fields are solutions on the section, of which a scene
    /// chooses those that it excites; the order numbers their waves.
    bool
    is_of_solutions() const
    {
      return kind == Kind::SV;
    }
    /// Whether these answer at wave numbers, SV-N with N of 1 or more.
    bool
    has_responses() const
    {
      return is_of_solutions() && order > 0;
    }
    /// Whether sections stay normal to the axis, which ties rotations to
    /// deflections and leaves no shear strain.
    bool
    keeps_sections_normal() const
    {
      return kind == Kind::EBBT;
    }
    /// Whether, of bodies that turn by any angle, a section turns as a whole
    /// and deforms in axes of its own; those of all others that turn deform as
    /// a turned one does.
    bool
    has_turning_sections() const
    {
      return is_classical() || is_of_solutions();
    }
    /// What a classical theory is made of there: TBT that twists, of both. All
    /// others stay.
    Theory
    of_turning() const
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
    /// Whether a section can turn about the axis.
    bool
    can_twist() const
    {
      return !is_classical() || twists;
    }
    /// Whether sections contract, and plies couple, by functions of the
    /// theory's own: not so where u_x and u_z are linear at most.
    bool
    contracts_by_itself() const
    {
      return !is_single_layer() || order > 1;
    }

    /// Of LE-N the SV of @p waves wave numbers whose fields are made of it.
    Theory
    from_solutions(const unsigned int waves) const;

    /// Whether the displacements of @p other are among those of the theory: of
    /// one family, in which EBBT is the least of TE and TBT the next, and no
    /// lower order.
    bool
    holds(const Theory &other) const;

    /// LE of the degree @p order, SV of @p waves wave numbers made of LE of the
    /// degree @p degree, TE and solid of the order @p order, with defaults for
    /// the rest.
    static Theory
    layerwise(const unsigned int order);
    static Theory
    of_solutions(const unsigned int waves, const unsigned int degree);
    static Theory
    taylor(const unsigned int order);
    static Theory
    solid(const unsigned int order);

    /// The theory that makes the Section in which the fields are: LE of the
    /// section_order for SV-N, the theory itself for all others.
    Theory
    of_section() const;

    /// The theory that @p entry spells, with defaults for the rest. Throws
    /// InputError for anything else. N is from 1 to 20 for TE, to 8 for LE, to
    /// 2 for solid, and from 0 to 40 for SV.
    static Theory
    parse(const Entry &entry);
  };

  /// What stands before the `-N` of those that have an order.
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

  /// Theories along the axis, one from each break to the next: node-dependent
  /// kinematics by hand. Empty: one theory all along.
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

    /// The theory whose fields are looked after by themselves: the first SV-N
    /// with the largest N, or else the LE of the highest degree; its section
    /// order is the degree of the section's space, that of all pieces.
    Theory
    leading() const;
  };

  /// The entries of a body's `subsection Kinematics` that speak of its theory.
  struct TheoryParameters
  {
    /// Theory (empty: the scene's), Theories with Theory breaks, Section order,
    /// Poisson correction, Shear factor.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The theory, or that of the scene's entry @p scene_theory where the body
    /// names none. Throws InputError. Also for a shear factor that is not above
    /// 0 and at most 1, whatever the theory.
    static Theory
    parse(const Entries &in, const Entry &scene_theory);

    /// What `Theories` and `Theory breaks` say of a body of @p length; empty
    /// where there are none. Throws InputError for theories that cannot stand
    /// beside others (all but LE and SV), other numbers of theories than of
    /// pieces, SV-N of different N, a section order below the highest degree of
    /// LE, and breaks that do not ascend. All theories returned have one
    /// section order, that of a space which holds them all; it is hierarchical
    /// where an LE is of a lower degree.
    static TheoryPieces
    parse_pieces(const Entries &in, const double length);
  };

  /// For use as a key: theories that share the section's fields and matrices.
  /// By kind, orders, hierarchy, Poisson correction, shear factor and twist,
  /// one after the other.
  bool
  operator<(const Theory &a, const Theory &b);
} // namespace lamella

#endif
