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
  /// A number of the last load step, requested by name: a column of probes.csv,
  /// a difference of two (a measure), a resultant of a support or contact, or
  /// the mean pressure, width or dissipation of a contact or a strip of it.
  struct NamedQuantity
  {
    /// Kind of object that the quantity belongs to.
    enum class ObjectKind
    {
      undefined,
      probe,
      support, ///< the reaction on the bodies
      contact, ///< the resultant on the second side
      measure  ///< a difference of two quantities of probes
    };
    ObjectKind of = ObjectKind::undefined;
    /// Name of the probe, support, contact or measure.
    std::string name;
    /// Ply of a probe on an interface, from 1 at the bottom; 0 if not given.
    unsigned int ply = 0;
    /// Column: of a probe `uz`, `syy`, ...; of a resultant `fx` to `fz`, `mx`
    /// to `mz`; of a contact also `pressure`, `width`, `width x` to `width z`,
    /// `dissipated`; of a measure `value`.
    std::string column;
    /// First of the scene's References of this quantity.
    std::optional<double> given;
    /// Entry that requests the quantity, for messages.
    std::string path = {};
    /// Strip of a contact that the quantity is restricted to, if any.
    std::optional<ContactStrip> strip = {};
    /// Terms of a measure: (first - second) / `over`, with `over` not zero.
    std::vector<NamedQuantity> terms = {};
    double                     over  = 1.;
    /// True if `over` is 1 and no distance, so that the unit is unchanged.
    bool keeps_unit = true;

    /// Returns the scene's text: `upper_top: uz`, `middle/2: syz` with a ply,
    /// `roller: fz in y 40 60` with a strip.
    std::string
    label() const;

    /// Returns the letter of its kind; only equal kinds compare: u
    /// displacement, e strain, s stress, j jump of a probe, f force, m moment,
    /// p pressure, w width, d dissipation. A measure has the kind of its terms.
    char
    kind() const;

    /// Returns the unit's label in @p units: `mm`, `MPa`, `N`, `N mm`; empty
    /// for strains, jumps, divided measures, and scenes without units.
    std::string
    unit(const Units &units) const;
  };

  /// Returns the kind of @p column: its first letter; `e` for shear strains.
  char
  kind_of_column(const std::string &column);

  /// A difference of a column at two probes, over a number or their distance.
  struct Measure
  {
    /// Name in `subsection Measure NAME`.
    std::string name;
    /// Quantity with its terms; the first reference is its `given`.
    NamedQuantity quantity;
    /// References of `value`.
    std::vector<Reference> references;
  };

  /// Throws InputError with the entry of @p quantity if it names another ply
  /// than @p plies (from 1; "0" for a mean).
  void
  check_ply(const NamedQuantity            &quantity,
            const std::vector<std::string> &plies);

  /// Throws InputError: the probe of @p quantity has several @p plies.
  [[noreturn]] void
  refuse_interface(const NamedQuantity            &quantity,
                   const std::vector<std::string> &plies);

  /// The names of a scene that a quantity can refer to, with their References.
  struct QuantityNames
  {
    std::vector<Probe>                            probes;
    std::map<std::string, std::vector<Reference>> supports, contacts;
    std::vector<Measure>                          measures = {};
  };

  /// Returns the quantity in @p text: NAME: COLUMN, of a contact also NAME:
  /// COLUMN in AXIS FROM TO. Throws InputError unless a probe, a measure, or
  /// exactly one support or contact has that name and column, for another form
  /// of the strip, and unless FROM < TO. check_strip() checks the position.
  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names);

  /// Returns the quantities in @p text between '|', as parse_quantity().
  std::vector<NamedQuantity>
  parse_quantities(const Entry &text, const QuantityNames &names);

  /// Returns the column of one of @p probes in @p text, PROBE: COLUMN or
  /// PROBE/PLY: COLUMN. Throws InputError for others.
  NamedQuantity
  parse_probe_quantity(const Entry &text, const std::vector<Probe> &probes);

  /// Throws InputError, with the path of @p quantity, unless strip and width
  /// are across the facing axis of the contact with @p points, and within it.
  void
  check_strip(const NamedQuantity                        &quantity,
              const std::vector<ContactInterface::Point> &points);

  /// Path of quantities that no entry requests by name.
  inline const char *const references_path = "References";

  /// Returns every quantity with References; appends other probes to @p others.
  std::vector<NamedQuantity>
  quantities_with_references(const QuantityNames      &names,
                             std::vector<std::string> &others);

  /// Returns the traction of @p contact for its @p rows at the end of a step.
  ContactTraction
  traction_of(const ContactSummary          &contact,
              const std::vector<ContactRow> &rows);

  /// Thresholds for the scale of a number.
  struct GoalRules
  {
    /// Values below this share of the largest of their kind take that as scale.
    double near_zero = 1e-3;
    /// A material with values below this share of the scene's is no scale.
    double nothing = arithmetic::negligible;
  };

  /// The numbers of a run, at its last load step, that any NamedQuantity may
  /// request, independent of the run.
  class ResultNumbers
  {
  public:
    /// Constructs the numbers of a failed run: none.
    ResultNumbers() = default;

    /// Throws InputError if no step was solved.
    explicit ResultNumbers(const Results &results);

    /// Reads what to_json() wrote. Throws nlohmann::json::exception otherwise.
    explicit ResultNumbers(const nlohmann::json &json);

    /// Returns a JSON object from which doubles are restored exactly.
    nlohmann::json
    to_json() const;

    /// Returns the value of @p quantity. Throws InputError on an interface
    /// whose plies differ (by 1e-9) if the quantity names none or another one.
    double
    value(const NamedQuantity &quantity) const;

    /// Returns the displacement and the stress component (scene axes) of
    /// largest magnitude at the probe @p name, in the first ply.
    std::vector<NamedQuantity>
    largest_at(const std::string &name) const;

    /// Returns the largest magnitude of the kind of @p quantity: any
    /// displacement, strain or stress of any probe, any force or moment of
    /// supports and contacts, any contact's pressure at a point, width, or
    /// dissipation. For a measure, that of its terms over its divisor.
    double
    largest_of_kind(const NamedQuantity &quantity) const;

    /// Returns the largest strain or stress of the probes in the material of
    /// the ply of @p quantity, in any body: a stiff face is no scale for a soft
    /// core. If no other probe is in the material, the six components at the
    /// point are compared. An interface without a named ply uses the material
    /// with the least value, a box over several plies its own. Returns
    /// largest_of_kind() for other kinds, which are continuous.
    double
    largest_in_material(const NamedQuantity &quantity) const;

    /// Returns the scale of @p quantity: its magnitude, or if that is near zero
    /// the largest of its kind in its material.
    double
    scale_of(const NamedQuantity &quantity, const GoalRules &rules = {}) const;

  private:
    /// A row of a probe, of one ply (from 1 at the bottom).
    struct ProbeRow
    {
      std::string  probe;
      unsigned int ply = 0;
      /// Material of the ply; empty for a mean over several.
      std::string material;
      /// Values by column name of probes.csv.
      std::map<std::string, double> columns;
    };

    /// Returns the largest magnitude of the columns of @p kind in @p row.
    static double
    largest_of(const char kind, const ProbeRow &row);

    /// Returns the rows of one probe, one per ply, from the bottom.
    std::vector<const ProbeRow *>
    rows_of(const std::string &probe) const;

    /// Returns value() of a support or a contact.
    double
    value_of_resultant(const NamedQuantity &quantity) const;

    /// Forces and moments on bodies by supports, on second sides by contacts.
    std::map<std::string, std::vector<double>> supports, contacts;
    /// Traction of each contact.
    std::map<std::string, ContactTraction> tractions;
    std::vector<ProbeRow>                  probes;
  };
} // namespace lamella

#endif
