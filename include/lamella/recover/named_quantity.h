// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_named_quantity_h
#define lamella_recover_named_quantity_h

#include <lamella/base/arithmetic.h>
#include <lamella/contact/contact_traction.h>
#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A number of a run's results that can be asked for by name, at the last
  /// load step: a column of probes.csv at a probe, a difference of two of them
  /// (a measure), a component of the resultant of a support or a contact, or
  /// the mean pressure or a width of what presses of a contact or what friction
  /// has dissipated so far, all of it or a strip (ContactTraction,
  /// PressedPatch).
  struct NamedQuantity
  {
    /// What it is a number of.
    enum class Of
    {
      undefined,
      probe,
      support, ///< the reaction on the bodies
      contact, ///< the resultant on the second side
      measure  ///< a difference of two quantities of probes
    };
    Of of = Of::undefined;
    /// Of the probe, support, contact or measure.
    std::string name;
    /// Of a probe on a ply interface, from 1 at the bottom; 0: not said.
    unsigned int ply = 0;
    /// `uz`, `syy`, ... of a probe; of a resultant `fx`, `fy`, `fz` or its
    /// moments `mx`, `my`, `mz`; of a contact also `pressure`, `width`,
    /// `width x`, `width y`, `width z` and `dissipated`. Of a measure `value`.
    std::string column;
    /// The first of the scene's References of this quantity.
    std::optional<double> given;
    /// The entry that asks for it, for messages.
    std::string path = {};
    /// Of a contact what it is restricted to, if anything.
    std::optional<ContactStrip> strip = {};
    /// Of a measure its two terms, of which it is the difference of the first
    /// less the second, over a number that is not zero.
    std::vector<NamedQuantity> terms = {};
    double                     over  = 1.;
    /// Whether that is 1 and no distance, so that the unit stays.
    bool is_plain = true;

    /// `upper_top: uz`, with a ply `middle/2: syz`, with a strip `roller: fz in
    /// y 40 60`, as the scene says it.
    std::string
    label() const;

    /// Numbers of one kind can be compared. Its letter: u displacement, e
    /// strain, s stress, j jump of a probe, f force, m moment, p pressure, w
    /// width, d what is dissipated. Of a measure that of its terms.
    char
    kind() const;

    /// As @p units label it: `mm`, `MPa`, `N`, `N mm`. Empty of strains and
    /// jumps, of measures that are over something, and in a scene without
    /// units.
    std::string
    unit(const Units &units) const;
  };

  /// NamedQuantity::kind() of the column @p column: its first letter, of shear
  /// strains that of strains.
  char
  kind_of_column(const std::string &column);

  /// The difference of a column at two probes, over a number or over their
  /// distance: a twist, an indentation, an opening.
  struct Measure
  {
    /// As in `subsection Measure NAME`.
    std::string name;
    /// With its terms, and the first of the references as what is given.
    NamedQuantity quantity;
    /// Of `value`.
    std::vector<Reference> references;
  };

  /// Throws InputError with the entry of @p quantity, of a probe in @p plies
  /// (counted from 1; "0" for a mean over several), if it names another one.
  void
  require_ply(const NamedQuantity            &quantity,
              const std::vector<std::string> &plies);

  /// Throws that the probe of @p quantity has different values in @p plies.
  [[noreturn]] void
  refuse_interface(const NamedQuantity            &quantity,
                   const std::vector<std::string> &plies);

  /// What the names in a quantity can mean: the names of a scene, with the
  /// References that it gives for each.
  struct QuantityNames
  {
    std::vector<Probe>                            probes;
    std::map<std::string, std::vector<Reference>> supports, contacts;
    std::vector<Measure>                          measures = {};
  };

  /// The quantity that @p text says, NAME: COLUMN, of a contact also NAME:
  /// COLUMN in AXIS FROM TO. Throws InputError unless a probe, a measure, a
  /// support or a contact has that name, and only one of the latter two, and
  /// has such a number, for another form of the strip, and unless FROM is less
  /// than TO. Whether the strip is in the contact check_strip() says.
  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names);

  /// Those that @p text names, between '|'. Throws as parse_quantity() does.
  std::vector<NamedQuantity>
  parse_quantities(const Entry &text, const QuantityNames &names);

  /// The column of one of @p probes that @p text says, PROBE: COLUMN or
  /// PROBE/PLY: COLUMN. Throws InputError if it says anything else.
  NamedQuantity
  parse_of_probe(const Entry &text, const std::vector<Probe> &probes);

  /// Throws InputError, with the path of @p quantity, which is of a contact,
  /// unless the contact with @p points has such a strip and such a width:
  /// across the axis that it faces along, and a strip within its reach.
  void
  check_strip(const NamedQuantity                        &quantity,
              const std::vector<ContactInterface::Point> &points);

  /// The path of quantities that nobody asks for by name.
  inline const char *const references_path = "References";

  /// Everything that the scene has References for, each once. Names of probes
  /// without any are appended to @p others.
  std::vector<NamedQuantity>
  quantities_with_references(const QuantityNames      &names,
                             std::vector<std::string> &others);

  /// The traction of @p contact whose rows are @p rows at the end of a step.
  ContactTraction
  traction_of(const ContactFacts &contact, const std::vector<ContactRow> &rows);

  /// What decides which scale a number has: shares of the largest of a kind.
  struct GoalRules
  {
    /// Values below this have the largest of their kind for a scale.
    double near_zero = 1e-3;
    /// A material whose largest is below this of the scene's bears nothing but
    /// rounding, which is no scale.
    double nothing = arithmetic::negligible;
  };

  /**
   * The numbers of a run that a NamedQuantity may ask for, at its last load
   * step, free of the run itself: they go through pipes and into records, all
   * of them and not only those that are asked for.
   */
  class ResultNumbers
  {
  public:
    /// Those of a run that failed: none.
    ResultNumbers() = default;

    /// Throws InputError if no step was solved.
    explicit ResultNumbers(const Results &results);

    /// Those that to_json() has written. Throws nlohmann::json::exception for
    /// anything else.
    explicit ResultNumbers(const nlohmann::json &json);

    /// An object whose doubles come back to the last bit.
    nlohmann::json
    to_json() const;

    /// The value of @p quantity, which must be one of the scene's. Throws
    /// InputError if a probe lies on an interface, its plies differ there (by
    /// more than 1e-9 of the larger) and the quantity names none, or names one
    /// that is not there.
    double
    value(const NamedQuantity &quantity) const;

    /// The displacement and the stress, components in scene axes, that are
    /// largest in magnitude at the probe @p name: two quantities. On an
    /// interface the stress is that of the first ply there.
    std::vector<NamedQuantity>
    largest_at(const std::string &name) const;

    /// The largest magnitude of what is of the same kind as @p quantity: any
    /// displacement, strain or stress of any probe, any force or any moment of
    /// supports and contacts, the pressure at any point of any contact, the
    /// width of any contact along any axis, what any dissipates. Of a measure
    /// the largest of the kind of its terms over what these are divided by.
    double
    largest_of_kind(const NamedQuantity &quantity) const;

    /**
     * The same of a strain or a stress among the probes in the material of its
     * ply, in any body and at any angle, its own among them: what a stiff face
     * bears says nothing of a soft core. So where no other probe is in the
     * material, all six components at the place itself are what is compared. On
     * an interface that names no ply the material with the least. A box that
     * reaches into several plies is of no material, and is compared with
     * itself alone. Of everything else largest_of_kind(): displacements and
     * forces are continuous from one material to the next.
     */
    double
    largest_in_material(const NamedQuantity &quantity) const;

    /// What a change or an error of @p quantity is small against: its value
    /// or, where that is near zero, the largest of its kind in its material.
    double
    scale_of(const NamedQuantity &quantity, const GoalRules &rules = {}) const;

  private:
    /// A row of a probe, of one ply (from 1 at the bottom).
    struct ProbeRow
    {
      std::string  probe;
      unsigned int ply = 0;
      /// Of the ply; empty of a mean over several.
      std::string material;
      /// By the names of probes.csv.
      std::map<std::string, double> columns;
    };

    /// The largest magnitude of the columns of @p kind in @p row.
    static double
    largest_of(const char kind, const ProbeRow &row);

    /// Those of one probe, a ply each, from the bottom.
    std::vector<const ProbeRow *>
    rows_of(const std::string &probe) const;

    /// value() of a support or a contact.
    double
    value_of_resultant(const NamedQuantity &quantity) const;

    /// Force and moment, six components each: of the reaction on the bodies,
    /// and on the second side.
    std::map<std::string, std::vector<double>> supports, contacts;
    /// Of each contact.
    std::map<std::string, ContactTraction> tractions;
    std::vector<ProbeRow>                  probes;
  };
} // namespace lamella

#endif
