// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_plausibility_h
#define lamella_recover_plausibility_h

#include <lamella/base/units.h>
#include <lamella/body/body.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * What results are as a rule not, if numbers are in the units that the scene
   * names: strains above 2 %, and displacements above the length of a body.
   * Both are looked at on the surface of each body, at a thousand points of it,
   * where bending strains most; so places where stresses are singular hardly
   * count.
   */
  class Plausibility
  {
  public:
    /// @p bodies is referred to. Without units nothing is looked at.
    Plausibility(const Bodies &bodies, const Units &units);

    /// A sentence a body and fault, without a full stop, of the displacements
    /// @p u, which have a block for each body.
    std::vector<std::string>
    doubts(const BlockVector &u);

  private:
    void
    find_places();

    const Bodies &bodies;
    Units         units;
    /// Of each body, once somebody has asked: on large sections to list them
    /// takes a while.
    std::vector<std::vector<Location>> places;
  };
} // namespace lamella

#endif
