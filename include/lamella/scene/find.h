// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_find_h
#define lamella_scene_find_h

#include <lamella/base/entry.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/solve/modes.h>

#include <optional>

namespace lamella
{
  /// Analyses after the load steps (entries `Find` and `Modes`, and `subsection
  /// Harmonic response`).
  struct FindRequest
  {
    /// True if the load factor of first ply failure is computed.
    bool first_failure = false;
    /// Natural modes to compute; empty for none.
    std::optional<ModeRequest> modes = {};
    /// Number of buckling modes to compute.
    unsigned int n_buckling_modes = 0;
    /// Steady harmonic response to compute; empty for none.
    std::optional<HarmonicRequest> response = {};
    /// Reference values of modes by their names, `mode-1` and so on.
    std::vector<Reference> references = {};

    /// Declares the entries in @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the values of the entries in @p prm, at the top level. @p
    /// has_criteria tells whether the scene has failure criteria. Throws
    /// InputError for other texts.
    static FindRequest
    parse(dealii::ParameterHandler &prm, const bool has_criteria);

    /// Returns the names of all modes, with their reference values. Modes of a
    /// range have all numbers that Modes may have.
    std::vector<std::pair<std::string, std::vector<Reference>>>
    names_of_modes() const;
  };
} // namespace lamella

#endif
