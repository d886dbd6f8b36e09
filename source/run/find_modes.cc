// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/text.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>
#include <lamella/solve/modes.h>
#include <lamella/solve/small_motions.h>

#include <complex>

namespace lamella
{
  namespace
  {
    using Columns = std::vector<double>;



    /// Adds the rows of all probes at @p frequency [Hz] to @p response; @p
    /// fields has the columns of each row of probes for each motion.
    void
    add_rows(const double                             frequency,
             const std::vector<std::complex<double>> &coefficients,
             const std::vector<std::vector<Columns>> &fields,
             std::vector<HarmonicRow>                 rows,
             std::vector<HarmonicRow>                &response)
    {
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          rows[r].frequency = frequency;
          rows[r].values.resize(fields.front()[r].size());
          for (unsigned int m = 0; m < coefficients.size(); ++m)
            for (unsigned int c = 0; c < rows[r].values.size(); ++c)
              rows[r].values[c] += coefficients[m] * fields[m][r][c];
          response.push_back(std::move(rows[r]));
        }
    }



    /// Returns the derivatives of all columns at the probes of @p built along
    /// @p v at the displacements @p u, by central differences, which are exact
    /// for linear kinematics.
    std::vector<Columns>
    derivatives(const BuiltScene  &built,
                const BlockVector &u,
                const BlockVector &v)
    {
      // Rotations of this size have an error of 2e-7.
      constexpr double small   = 1e-3;
      const double     largest = v.linfty_norm();
      const double     h =
        largest > 0. ? small * built.structure().size() / largest : 1.;
      std::vector<Columns> columns;
      for (const double sign : {1., -1.})
        {
          BlockVector w = u;
          w.add(sign * h, v);
          unsigned int row = 0;
          for (const auto &probe :
               built.sampler().sample_probes(w, FaceTractions()))
            for (const FieldRow &one : probe)
              {
                const Columns values = field_values(one.sample);
                if (sign > 0.)
                  columns.emplace_back(values.size());
                for (unsigned int c = 0; c < values.size(); ++c)
                  columns[row][c] += sign / (2. * h) * values[c];
                ++row;
              }
        }
      return columns;
    }



    /// Computes the response at the probes by @p equations.
    void
    find_response(const BuiltScene         &built,
                  const HarmonicRequest    &request,
                  const VibrationEquations &equations,
                  Results                  &results)
    {
      const HarmonicResponse   response(equations,
                                      results.last().load_factor,
                                      *results.natural_modes,
                                      request);
      std::vector<HarmonicRow> rows;
      for (unsigned int p = 0; p < results.probes.size(); ++p)
        for (const FieldRow &row : results.last().probes[p])
          rows.push_back({0., p, row.ply, {}});
      std::vector<std::vector<Columns>> fields;
      for (const BlockVector &motion : response.motions())
        fields.push_back(derivatives(built, equations.state.u, motion));
      for (const double frequency : response.frequencies())
        add_rows(frequency,
                 response.coefficients(frequency),
                 fields,
                 rows,
                 results.response);
      // Twice the frequency: omitted modes are static within a third.
      const auto &modes = results.natural_modes->modes;
      if (modes.empty() || modes.back().value < 2. * request.frequencies.back())
        results.endnotes.push_back(
          "run.few-modes-for-response: The response at " +
          to_text(request.frequencies.back(), 6) + " Hz contains modes up to " +
          to_text(modes.empty() ? 0. : modes.back().value, 6) +
          " Hz only; others respond as in statics. Request more Modes, up to "
          "twice the largest frequency");
    }



    /// Computes the natural modes and the response; @p stresses are null
    /// without stresses, or if the tangent contains them.
    void
    find_vibrations(const BuiltScene         &built,
                    LinearSystem             &system,
                    const State              &state,
                    const GeometricStiffness *stresses,
                    Results                  &results)
    {
      const FindRequest &request = built.scene().find;
      // Stresses of linear kinematics are no approximation beyond its range.
      const bool is_in_range = request.modes->has_stresses &&
                               results.last().checks.beyond.is_in_range();
      const VibrationEquations equations(system,
                                         state,
                                         is_in_range ? stresses : nullptr);
      results.natural_modes =
        natural_modes(equations, results.inertia->center(), *request.modes);
      const std::size_t n = results.natural_modes->modes.size();
      if (!request.modes->range && n < request.modes->number)
        results.endnotes.push_back("run.few-modes: only " + std::to_string(n) +
                                   " natural modes were found");
      if (!is_in_range)
        results.endnotes.push_back(
          "run.modes-without-prestress: The last load step is beyond the range "
          "of linear kinematics: natural modes are those of bodies without "
          "stresses. Use Rotations = large to include the stresses");
      if (request.response)
        find_response(built, *request.response, equations, results);
    }



    /// Computes @p n buckling modes; @p stresses are null without stresses.
    void
    find_buckling_modes(const unsigned int        n,
                        LinearSystem             &system,
                        const State              &state,
                        const GeometricStiffness *stresses,
                        Results                  &results)
    {
      if (system.tangent().of().has_finite_rotations())
        Entry("Find", "buckling")
          .refuse(
            "run.buckling-with-large-rotations: linear buckling multiplies the "
            "stresses of linear kinematics",
            "Write Rotations = linear, or increase the loads until the run "
            "reports an unstable state.");
      if (stresses == nullptr)
        Entry("Find", "buckling")
          .refuse("run.buckling-without-load: the last load step has no "
                  "displacements, and therefore no stresses",
                  "Add a load.");
      results.buckling_modes = buckling_modes(system, state, *stresses, n);
      if (results.buckling_modes.size() < n)
        results.endnotes.push_back(
          "run.few-buckling-modes: the loads have only " +
          std::to_string(results.buckling_modes.size()) +
          " buckling modes with positive factors");
    }



    /// Returns the equations with the tangent stiffness at @p state, which
    /// contains the stresses.
    std::unique_ptr<LinearSystem>
    tangent_system(const BuiltScene &built,
                   const State      &state,
                   const LoadFactor &factor)
    {
      return std::make_unique<LinearSystem>(
        std::make_shared<const TangentOperator>(built.structure(),
                                                state.u,
                                                built.scene().solve.solver,
                                                TangentOperator::BodyMonitor(),
                                                BlockVector(),
                                                factor),
        built.rows());
    }



    /// Sets the values of the modes among @p goals, or a note.
    void
    add_quantities(const std::vector<NamedQuantity> &goals, Results &results)
    {
      const ResultNumbers numbers(results);
      for (const NamedQuantity &goal : goals)
        if (goal.of != NamedQuantity::ObjectKind::mode)
          continue;
        else if (numbers.has(goal))
          results.quantities[goal.label()] = numbers.value(goal);
        else
          results.endnotes.push_back(
            "run.mode-not-found: There is no value of " + goal.label() +
            ": this mode is not among those that were "
            "found. Request more Modes, or another "
            "range");
    }
  } // namespace



  void
  find_modes(const BuiltScene &built,
             LinearSystem     *system,
             const State      &state,
             Results          &results)
  {
    const FindRequest                  &request = built.scene().find;
    std::unique_ptr<LinearSystem>       large;
    std::unique_ptr<GeometricStiffness> stresses;
    if (system == nullptr)
      {
        large  = tangent_system(built, state, results.last().load_factor);
        system = large.get();
      }
    else if (state.u.linfty_norm() > 0.)
      stresses = std::make_unique<GeometricStiffness>(*system, state);
    if (built.structure().has_unsymmetric_loads())
      Entry("Find", "modes")
        .refuse(
          "run.modes-with-follower-loads: the follower loads of the scene have "
          "an unsymmetric stiffness, and modes need a symmetric one",
          "Replace moments and pressures on edges by forces.");
    if (request.modes)
      find_vibrations(built, *system, state, stresses.get(), results);
    if (request.n_buckling_modes > 0)
      find_buckling_modes(
        request.n_buckling_modes, *system, state, stresses.get(), results);
    add_quantities(built.scene().goals.quantities, results);
  }
} // namespace lamella
