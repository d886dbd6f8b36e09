// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_named_quantity_h
#define lamella_recover_named_quantity_h

#include <lamella/base/arithmetic.h>
#include <lamella/base/entry.h>
#include <lamella/contact/contact_traction.h>
#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A scalar result of the last load step, requested by name: a column of
  /// probes.csv at a probe, a difference of two columns (a measure), the
  /// resultant of a support or contact, the mean pressure, width or dissipation
  /// of a contact or of a strip of a contact, or the value of a mode.
  struct NamedQuantity
  {
    /// Kind of object whose result is requested.
    enum class ObjectKind
    {
      undefined,
      probe,
      support, ///< the reaction on the bodies
      contact, ///< the resultant on the second side
      measure, ///< a difference of two quantities of probes
      mode     ///< `mode-3: frequency` [Hz] or `buckling-1: factor`
    };
    ObjectKind  of = ObjectKind::undefined; ///< Kind of the object.
    std::string name; ///< Name of the object in the scene.
    /// Ply of a probe on a ply interface, from 1 at the bottom; 0 if not given.
    unsigned int ply = 0;
    /// Column: for a probe `uz`, `syy`, ...; for a resultant `fx` to `fz`, `mx`
    /// to `mz`; for a contact also `pressure`, `width`, `width x` to `width z`,
    /// `dissipated`; for a measure `value`.
    std::string column;
    /// First reference value of this quantity in the scene; empty if none.
    std::optional<double> given;
    /// Path of the scene entry that requests the quantity, for error messages.
    std::string path = {};
    /// Range of a coordinate in the contact; empty for the whole contact.
    std::optional<ContactStrip> strip = {};
    /// The two terms of a measure, (terms[0] - terms[1]) / over; else empty.
    std::vector<NamedQuantity> terms = {};
    double                     over  = 1.; ///< Divisor of a measure, not 0.
    /// True if a measure has the unit of its terms (divisor 1); else false.
    bool keeps_unit = true;

    /// Returns the quantity as written in the scene: `upper_top: uz`; with a
    /// ply `middle/2: syz`; with a range of y `roller: fz in y 40 60`.
    std::string
    label() const;

    /// Returns a letter for the kind of quantity: u displacement, e strain, s
    /// stress, j stress jump, f force, m moment, p pressure, w width, d
    /// dissipation, h frequency, l load factor. A measure has the kind of its
    /// terms.
    char
    kind() const;

    /// Returns the number of a mode, from 1; 0 for other quantities.
    unsigned int
    number_of_mode() const;

    /// Returns the label of the unit in @p units: `mm`, `MPa`, `N`, `N mm`;
    /// empty for strains, jumps, divided measures, and scenes without units.
    std::string
    unit(const Units &units) const;
  };

  /// Returns the letter for the kind of quantity in @p column of probes.csv,
  /// for example `s` for the stress `syz` and `e` for strains (also shear).
  char
  kind_of_column(const std::string &column);

  /// A difference of two probe results, divided by a number or distance.
  struct Measure
  {
    std::string   name;     ///< Name in `subsection Measure NAME`.
    NamedQuantity quantity; ///< The two probe results and the divisor.
    /// Reference values of the measure in the scene.
    std::vector<Reference> references;
  };

  /// Throws InputError, which names the scene entry of @p quantity, if the
  /// requested ply is not among @p plies, the numbers (from 1) of the plies
  /// that contain its probe ("0" for a mean over several plies).
  void
  check_ply(const NamedQuantity            &quantity,
            const std::vector<std::string> &plies);

  /// Throws InputError, since @p quantity differs between adjacent @p plies.
  [[noreturn]] void
  refuse_interface(const NamedQuantity            &quantity,
                   const std::vector<std::string> &plies);

  /// Objects of a scene that have results, with their reference values.
  struct QuantityNames
  {
    std::vector<Probe> probes; ///< Probes of the scene.
    /// Reference values of each support, by its name.
    std::map<std::string, std::vector<Reference>> supports;
    /// Reference values of each contact, by its name.
    std::map<std::string, std::vector<Reference>> contacts;
    std::vector<Measure> measures = {}; ///< Measures of the scene.
    /// Reference values of the modes of `Find`, by the name, as `mode-1`.
    std::vector<std::pair<std::string, std::vector<Reference>>> modes = {};
  };

  /// Returns the column of modes called @p name: `factor` of `buckling-1`,
  /// `frequency` of `mode-1`.
  std::string
  column_of_mode(const std::string &name);

  /// Returns the quantity in @p text, NAME: COLUMN, or for a contact NAME:
  /// COLUMN in AXIS FROM TO. Throws InputError for other forms, unless FROM <
  /// TO, and unless a probe, a measure, a mode, or exactly one support or
  /// contact has this name and column. check_strip() checks the range.
  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names);

  /// Returns the quantities in @p text, separated by '|' (parse_quantity()).
  std::vector<NamedQuantity>
  parse_quantities(const Entry &text, const QuantityNames &names);

  /// Returns the result of one of @p probes in @p text, PROBE: COLUMN or
  /// PROBE/PLY: COLUMN. Throws InputError for other texts.
  NamedQuantity
  parse_probe_quantity(const Entry &text, const std::vector<Probe> &probes);

  /// Throws InputError, which names the scene entry of the contact @p quantity,
  /// if its width or strip (range of one coordinate) is not measured along a
  /// tangent of the contact with the contact points @p points, or if the strip
  /// is not within the contact.
  void
  check_strip(const NamedQuantity                        &quantity,
              const std::vector<ContactInterface::Point> &points);

  /// Value of NamedQuantity::path for quantities with reference values only.
  inline const char *const references_path = "References";

  /// Returns all quantities for which the scene gives reference values. Adds
  /// the names of probes without reference values to @p others.
  std::vector<NamedQuantity>
  quantities_with_references(const QuantityNames      &names,
                             std::vector<std::string> &others);

  /// Returns the pressure and shear traction of @p contact for the results
  /// @p rows of its contact points at the end of a load step.
  ContactTraction
  traction_of(const ContactSummary                     &contact,
              const std::vector<ContactRow>            &rows,
              std::vector<ContactTraction::Dissipation> left = {});

  /// Thresholds for the reference of relative errors (ResultNumbers::scale_of).
  struct GoalRules
  {
    /// A value below this fraction of the largest value of its kind is near
    /// zero. Relative errors then refer to the largest value.
    double near_zero = 1e-3;
    /// If the largest value in the material is below this fraction of the
    /// largest value in the scene, relative errors refer to the latter.
    double nothing = arithmetic::negligible;
  };

  /// Copies of all values that a NamedQuantity can request (last load step).
  class ResultNumbers
  {
  public:
    /// Constructs an object without values, for an analysis that failed.
    ResultNumbers() = default;

    /// Copies values of @p results. Throws InputError if no step was solved.
    explicit ResultNumbers(const Results &results);

    /// Returns the value of @p quantity. Throws InputError if its probe lies on
    /// a ply interface, the values of both plies differ (by 1e-9 relatively),
    /// and @p quantity does not name one of the plies; or if it is a mode that
    /// was not found.
    double
    value(const NamedQuantity &quantity) const;

    /// Returns the displacement component and the stress component (scene axes)
    /// of largest magnitude at the probe @p name, in its lowest ply.
    std::vector<NamedQuantity>
    largest_at(const std::string &name) const;

    /// Returns false if @p quantity is a mode that was not found.
    bool
    has(const NamedQuantity &quantity) const
    {
      return quantity.of != NamedQuantity::ObjectKind::mode ||
             find_mode(quantity) != nullptr;
    }

    /// Numbers the modes as similar modes of @p run (Mode::similarity()), and
    /// drops others.
    void
    number_modes_as(const Results &run);

    /// Returns the values of all modes.
    std::vector<NamedQuantity>
    of_modes() const;

    /// Returns the largest magnitude of all results of the same kind as @p
    /// quantity (kind()): at all probes, supports and contacts that have such
    /// results. For a measure, it is divided by the divisor of the measure.
    double
    largest_of_kind(const NamedQuantity &quantity) const;

    /// Returns the largest strain or stress of all probes in the same material
    /// as @p quantity, since stresses of a stiff face are no reference for a
    /// soft core. If the probe is on an interface and no ply is given, the
    /// result is the smallest for its materials; for a box over several plies,
    /// that of the box. For other quantities, returns largest_of_kind().
    double
    largest_in_material(const NamedQuantity &quantity) const;

    /// Returns the reference value of relative errors of @p quantity: its
    /// magnitude, or largest_in_material() if the quantity is near zero.
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

    /// Returns the largest magnitude in columns of the kind @p kind of @p row.
    static double
    largest_of(const char kind, const ProbeRow &row);

    /// Returns the rows of one probe, one per ply, from the bottom.
    std::vector<const ProbeRow *>
    rows_of(const std::string &probe) const;

    /// Returns the mode @p quantity, or null.
    const Mode *
    find_mode(const NamedQuantity &quantity) const;

    /// Returns the value of @p quantity, a result of a support or a contact.
    double
    value_of_resultant(const NamedQuantity &quantity) const;

    /// Force and moment of each support and contact, by its name.
    std::map<std::string, std::vector<double>> supports, contacts;
    /// Traction of each contact, by its name.
    std::map<std::string, ContactTraction> tractions;
    /// Natural and buckling modes, without their DoFs.
    std::vector<Mode>     natural_modes, buckling_modes;
    std::vector<ProbeRow> probes;
  };

  /// Entries of `subsection Measure NAME`, a difference of two probe results
  /// that can be divided by a number or length: Of, Over, References.
  struct MeasureParameters
  {
    /// Declares the entries with defaults, patterns and descriptions.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the measure @p name, a difference of results of @p probes. Of has
    /// the form PROBE[/PLY]: COLUMN - PROBE[/PLY]: COLUMN, Over is a number or
    /// `distance` (of the probes). Throws InputError for other forms, columns
    /// of different units, a difference that is always zero, and if Over is
    /// zero.
    static Measure
    parse(const Entries            &in,
          const std::string        &name,
          const std::vector<Probe> &probes);
  };

  /// Throws InputError if a measure has the name of another object.
  void
  check_names_of_measures(const QuantityNames &names);
} // namespace lamella

#endif
