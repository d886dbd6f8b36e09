// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_plan_rules_h
#define lamella_estimate_plan_rules_h

namespace lamella
{
  /**
   * The numbers that decide which model a body gets, of a run to a tolerance
   * and of what it is compared with (start_of(), enriched()). They are
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
    /// The degree from which on the cells of a section are divided instead.
    unsigned int highest_degree = 8;
    /// What axes that would grade themselves to a contact that is everywhere
    /// begin with: as where a scene says nothing of the axis.
    unsigned int equal_elements = 10;
  };
} // namespace lamella

#endif
