// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_plan_rules_h
#define lamella_adapt_plan_rules_h

namespace lamella
{
  /**
   * The numbers that decide which model a body gets, of a run to a tolerance
   * and of what it is compared with (plan(), enriched()). They are
   * judgements on the runs of `scripts/measure tolerances`: each of them kept a
   * run from taking several times the seconds or the memory of another model
   * that said the same. None of them was optimised.
   */
  struct PlanRules
  {
    /// The DoFs of a body up to which LE-N is enriched as it is; beyond them
    /// the section's own fields stand in.
    double most_dofs_of_layers = 60000.;
    /// Fields that a node of SV-10 near something carries; a section wants more
    /// than twice as many (worth_while) for these to be fewer.
    double fields_of_responses = 200., worth_while = 2.;
    /// The DoFs that LE-2 may have for being cheaper than the making of
    /// responses.
    double cheap_dofs = 20000.;
    /// The share of a beam's length along which others may touch it above which
    /// its own fields are no smaller than LE, and take long to be made: there
    /// is a response to each row of the contact.
    double long_contact = 0.5;
    /// Wave numbers of what stands in for theories without responses, what SV-N
    /// gets more, the least that is worth while, and the most.
    unsigned int many_waves = 10, more_waves = 4, least_waves = 6,
                 most_waves = 40;
    /// The degree of LE that a run begins with: the least that has poorer
    /// levels to tell its errors by.
    unsigned int first_degree = 3;
    /// The degree from which on the cells of a section are divided instead.
    unsigned int highest_degree = 8;
    /// The same of sections with corners, which get layers there
    /// (graded_to_corners()): lower in runs whose degrees do not contract.
    unsigned int corner_degree = 8;
    /// As many as a scene may say (`Corner layers`).
    unsigned int most_corner_layers = 6;
    /// What axes that would grade themselves to a contact that is everywhere
    /// begin with at most: as where a scene says nothing of the axis.
    unsigned int equal_elements = 10;
    /// A body of SV-N keeps all fields of its section where its nodes would
    /// carry more than this share of them on average, or where its axis has no
    /// more nodes than that: nothing would be won.
    double       most_fields = 0.5;
    unsigned int least_nodes = 15;
    /// Nor where supports, but clamps, hold more load vectors than this share
    /// of the fields, on average: a surface held all along leaves lists with
    /// little but what is held to be eliminated from, which is slow and costs
    /// digits.
    double most_held = 0.05;
  };

  /// What a model costs that is not built yet, as counted by hand from the
  /// algorithms. That it is right within a factor of some two is all that
  /// decides: doc/tolerances.md has seconds of both kinds.
  struct CostRules
  {
    /// Axes' worth of nodes that bars take: two models on halved elements, one
    /// on quarters.
    double axes = 8.;
    /// Multiplications for a node with m fields, over m^3: the factors of its
    /// block and of what couples it to the next.
    double of_block = 5.;
    /// Wave numbers that responses are made at, and multiplications of their
    /// eigenvectors over the cube of their number.
    double waves = 10., of_eigenvectors = 10.;
    /// Non-zeros of the factor of a solid over n^(4/3) (foreseen_costs()): 12
    /// to 13 for cantilevers of 135 to 4,875 DoFs; and the most of LE: 14 to 23
    /// for the large ones of prm/.
    double of_solid = 13., of_layers = 19.;
  };
} // namespace lamella

#endif
