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
  /// A scalar result of the last load step, requested by name: a column of
  /// probes.csv at a probe, a difference of two columns (a measure), the
  /// resultant of a support or contact, or the mean pressure, width or
  /// dissipation of a contact or of a strip of a contact.
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
    /// Ply of a probe on a ply interface, from 1 at the bottom; 0 if not given.
    unsigned int ply = 0;
    /// Column: for a probe `uz`, `syy`, ...; for a resultant `fx` to `fz`, `mx`
    /// to `mz`; for a contact also `pressure`, `width`, `width x` to `width z`,
    /// `dissipated`; for a measure `value`.
    std::string column;
    /// First reference value of this quantity in the scene (References).
    std::optional<double> given;
    /// Path of the entry that requests the quantity, for messages.
    std::string path = {};
    /// Strip of a contact to which the quantity is restricted, if any.
    std::optional<ContactStrip> strip = {};
    /// Measure: (terms[0] - terms[1]) / `over`, with `over` not zero.
    std::vector<NamedQuantity> terms = {};
    double                     over  = 1.;
    /// True if `over` is the number 1, so that a measure has its terms' unit.
    bool keeps_unit = true;

    /// Returns the text in the scene: `upper_top: uz`, `middle/2: syz` with a
    /// ply, `roller: fz in y 40 60` with a strip.
    std::string
    label() const;

    /// Returns a letter for the kind of quantity (only equal kinds are
    /// compared): u displacement, e strain, s stress, j jump, f force, m
    /// moment, p pressure, w width, d dissipation. A measure: as its terms.
    char
    kind() const;

    /// Returns the label of the unit in @p units: `mm`, `MPa`, `N`, `N mm`;
    /// empty for strains, jumps, divided measures, and scenes without units.
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
    /// Quantity with its terms; `given` is the first reference value.
    NamedQuantity quantity;
    /// Reference values of `value`.
    std::vector<Reference> references;
  };

  /// Throws InputError with the entry of @p quantity if it requests a ply that
  /// is not among @p plies (from 1; "0" for a mean).
  void
  check_ply(const NamedQuantity            &quantity,
            const std::vector<std::string> &plies);

  /// Throws InputError: the probe of @p quantity is in several @p plies.
  [[noreturn]] void
  refuse_interface(const NamedQuantity            &quantity,
                   const std::vector<std::string> &plies);

  /// Names in a scene to which a quantity can refer, with their References.
  struct QuantityNames
  {
    std::vector<Probe>                            probes;
    std::map<std::string, std::vector<Reference>> supports, contacts;
    std::vector<Measure>                          measures = {};
  };

  /// Returns the quantity in @p text, NAME: COLUMN, or for a contact NAME:
  /// COLUMN in AXIS FROM TO. Throws InputError unless a probe, a measure, or
  /// exactly one support or contact has this name and column, for other forms,
  /// and unless FROM < TO. check_strip() checks the position.
  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names);

  /// Returns the quantities in @p text, separated by '|' (parse_quantity()).
  std::vector<NamedQuantity>
  parse_quantities(const Entry &text, const QuantityNames &names);

  /// Returns the column of one of @p probes in @p text, PROBE: COLUMN or
  /// PROBE/PLY: COLUMN. Throws InputError for other texts.
  NamedQuantity
  parse_probe_quantity(const Entry &text, const std::vector<Probe> &probes);

  /// Throws InputError, with the path of @p quantity, unless its strip or width
  /// is along an axis normal to the contact normal of @p points, and the strip
  /// lies within the contact.
  void
  check_strip(const NamedQuantity                        &quantity,
              const std::vector<ContactInterface::Point> &points);

  /// Path of quantities that are requested by References only.
  inline const char *const references_path = "References";

  /// Returns every quantity with References; adds other probes to @p others.
  std::vector<NamedQuantity>
  quantities_with_references(const QuantityNames      &names,
                             std::vector<std::string> &others);

  /// Returns the mean pressure data of @p contact from @p rows at a step's end.
  ContactTraction
  traction_of(const ContactSummary          &contact,
              const std::vector<ContactRow> &rows);

  /// Thresholds for ResultNumbers::scale_of().
  struct GoalRules
  {
    /// A value below this fraction of the largest value of its kind is near
    /// zero; its errors then refer to the largest value.
    double near_zero = 1e-3;
    /// Materials with values below this fraction of the scene's are ignored.
    double nothing = arithmetic::negligible;
  };

  /// Values at the last load step of all quantities that a NamedQuantity can
  /// request. The object does not refer to the run.
  class ResultNumbers
  {
  public:
    /// Constructs an object without values, for a failed run.
    ResultNumbers() = default;

    /// Stores values of @p results. Throws InputError if no step was solved.
    explicit ResultNumbers(const Results &results);

    /// Reads the output of to_json(); throws nlohmann::json::exception.
    explicit ResultNumbers(const nlohmann::json &json);

    /// Returns a JSON object from which doubles are restored exactly.
    nlohmann::json
    to_json() const;

    /// Returns the value of @p quantity. Throws InputError at an interface of
    /// plies with different values (by 1e-9) unless @p quantity names one of
    /// the plies.
    double
    value(const NamedQuantity &quantity) const;

    /// Returns the displacement and the stress component (scene axes) of
    /// largest magnitude at the probe @p name, in the first ply.
    std::vector<NamedQuantity>
    largest_at(const std::string &name) const;

    /// Returns the largest magnitude of the kind of @p quantity: any
    /// displacement, strain or stress of any probe, any force or moment of
    /// supports and contacts, pressure at a point, width, or dissipation of any
    /// contact. For a measure, the value for its terms over its divisor.
    double
    largest_of_kind(const NamedQuantity &quantity) const;

    /// Returns the largest strain or stress of all probes in the material of
    /// the ply of @p quantity, in any body: a stiff face is no reference for a
    /// soft core. If no other probe is in the material, the six components at
    /// the point are compared. On an interface without a given ply, the
    /// material with the smallest value is used, for a box over several plies
    /// the values of the box. For other kinds: largest_of_kind().
    double
    largest_in_material(const NamedQuantity &quantity) const;

    /// Returns the reference size of errors of @p quantity: its magnitude, or
    /// if it is near zero largest_in_material().
    double
    scale_of(const NamedQuantity &quantity, const GoalRules &rules = {}) const;

  private:
    /// A row of the probe table, for one ply (from 1 at the bottom).
    struct ProbeRow
    {
      std::string  probe;
      unsigned int ply = 0;
      /// Material of the ply; empty for a mean over several plies.
      std::string material;
      /// Values by column name of probes.csv.
      std::map<std::string, double> columns;
    };

    /// Returns the largest magnitude of the columns of kind @p kind in @p row.
    static double
    largest_of(const char kind, const ProbeRow &row);

    /// Returns the rows of one probe, one per ply, from the bottom.
    std::vector<const ProbeRow *>
    rows_of(const std::string &probe) const;

    /// Returns value() for a support or a contact.
    double
    value_of_resultant(const NamedQuantity &quantity) const;

    /// Resultants of supports on bodies, and of contacts on second sides.
    std::map<std::string, std::vector<double>> supports, contacts;
    /// Traction of each contact.
    std::map<std::string, ContactTraction> tractions;
    std::vector<ProbeRow>                  probes;
  };
} // namespace lamella

#endif
