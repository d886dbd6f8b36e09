// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_start_h
#define lamella_estimate_start_h

#include <lamella/estimate/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /**
   * What a run to a tolerance begins with where @p scene does not say its
   * Theory: SV-6, but LE-1 for bodies of which LE-2 has at most cheap_dofs, and
   * for those which contacts may touch along more than long_contact of their
   * length: every node there would carry responses to all that touches, which
   * are more than the few fields that take part. Of the latter axes that grade
   * themselves begin with ten equal elements: a contact that is everywhere
   * would make them fine everywhere.
   * Nothing is solved; rows are made of the bodies with the fields of TE-1.
   * Throws what building a scene throws.
   */
  Scene
  start_of(Scene scene, const PlanRules &rules = {});

  /// @p scene, out of which @p model was made, with LE-1 for the bodies of SV-N
  /// that keep all fields of their section (FieldRules::most_fields): these are
  /// compact, and lower degrees come first. Whether any changed.
  bool
  begin_lower(Scene &scene, const BuiltScene &model);
} // namespace lamella

#endif
