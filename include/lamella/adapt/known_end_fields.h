// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_known_end_fields_h
#define lamella_adapt_known_end_fields_h

#include <lamella/adapt/end_fields.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// Whether @p zones do for @p held: those that are embedded do not where it
  /// is looked at.
  bool
  suffice(const std::vector<EndZone> &zones, const HeldSection &held);

  /// Those that a section has from another one of the same cells and of a lower
  /// degree: its zones @p zones embedded in @p section (embedded()) and freed
  /// of what this one has for warpings, @p warpings. They are as good as they
  /// were.
  std::vector<EndZone>
  embedded(const std::vector<EndZone> &zones,
           const Section              &from,
           const Section              &section,
           const Warping              &warping,
           const FieldColumns         &warpings,
           const EndFieldRules        &rules = {});

  /**
   * End fields that are made once and asked for by many: those of models of one
   * scene differ in their axes and loads, and have the same ends. A richer
   * section, LE-4 for LE-3, has those of the poorer one embedded where nobody
   * looks at the end itself (HeldSection::is_looked_at): what the degree
   * changes of them does not reach far, and the piece is most of what such a
   * model costs.
   */
  class EndFields
  {
  public:
    explicit EndFields(const EndFieldRules &rules = {});

    /// end_fields(), or what it said of a section with the same matrices and
    /// fields, held alike; or those of a poorer one, embedded. Models of one
    /// scene have the same heat. Collective.
    std::vector<EndZone>
    zones(const std::shared_ptr<const Section> &section,
          const SaintVenant                    &states,
          const Warping                        &warping,
          const FieldColumns                   &warpings,
          const HeldSection                    &held,
          const std::vector<HeatedSection>     &heat = {});

    const EndFieldRules &
    limits() const
    {
      return rules;
    }

    /// How many pieces were solved.
    std::size_t
    n_made() const
    {
      return n_pieces;
    }

  private:
    struct Known
    {
      std::shared_ptr<const Section> section;
      FieldColumns                   warpings;
      /// Its element is that of the piece.
      HeldSection          held;
      std::vector<EndZone> zones;
    };

    /// The number of those of a poorer section of the body, held by the same;
    /// how many there are if there is none.
    std::size_t
    poorer(const Section &section, const HeldSection &held) const;

    EndFieldRules      rules;
    std::vector<Known> known;
    std::size_t        n_pieces = 0;
  };
} // namespace lamella

#endif
