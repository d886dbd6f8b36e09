// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/recover/interlaminar.h>
#include <lamella/recover/sampler.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Where the scene asks for the stresses of @p request.
    template <typename Request>
    std::string
    entry_of(const char *kind, const Request &request)
    {
      return std::string(kind) + " " + request.name + "/Stress";
    }



    /// sigma . d.
    Tensor<1, 3>
    traction_on(const Voigt &s, const Tensor<1, 3> &d)
    {
      return Point<3>(s[0] * d[0] + s[3] * d[1] + s[4] * d[2],
                      s[3] * d[0] + s[1] * d[1] + s[5] * d[2],
                      s[4] * d[0] + s[5] * d[1] + s[2] * d[2]);
    }

    double
    largest_component(const Voigt &s)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < s.dimension; ++i)
        largest = std::max(largest, std::abs(s[i]));
      return largest;
    }
  } // namespace



  Sampler::Sampler(const Bodies             &bodies,
                   const std::vector<Probe> &probes,
                   const std::vector<Line>  &lines,
                   const std::vector<Cut>   &cuts,
                   const bool                in_scene_axes)
    : bodies(bodies)
    , probes(probes)
    , lines(lines)
    , cuts(cuts)
    , in_scene_axes(in_scene_axes)
  {
    const auto check_stress = [&bodies](const char *kind, const auto &request) {
      if (request.stress == StressValues::equilibrium)
        laminate_box(*bodies[request.body], entry_of(kind, request));
    };
    for (const Probe &probe : probes)
      {
        probe_points.push_back(box_points(*bodies[probe.body],
                                          probe.position,
                                          probe.box,
                                          "Probe " + probe.name));
        check_stress("Probe", probe);
      }
    for (const Line &line : lines)
      {
        line_sample_points.push_back(places_of(line));
        check_stress("Line", line);
      }
    for (const Cut &cut : cuts)
      {
        check_cut(cut);
        check_stress("Cut", cut);
      }
  }



  std::vector<std::string>
  Sampler::plies_at(const unsigned int probe) const
  {
    std::vector<std::string> plies;
    for (const BoxPoints &points : probe_points[probe])
      {
        const unsigned int ply = 1 + points[0].second.ply;
        const bool         is_one =
          std::all_of(points.begin(), points.end(), [ply](const auto &point) {
            return 1 + point.second.ply == ply;
          });
        plies.push_back(is_one ? std::to_string(ply) : "0");
      }
    return plies;
  }



  unsigned int
  Sampler::number_of(const std::string &probe) const
  {
    const auto place =
      std::find_if(probes.begin(), probes.end(), [&](const Probe &one) {
        return one.name == probe;
      });
    AssertThrow(place != probes.end(), ExcInternalError());
    return place - probes.begin();
  }



  bool
  Sampler::is_between_plies(const NamedQuantity &quantity) const
  {
    if (quantity.of != NamedQuantity::ObjectKind::probe || quantity.ply != 0)
      return false;
    const unsigned int probe = number_of(quantity.name);
    return plies_at(probe).size() > 1 && quantity.column[0] != 'u' &&
           !is_traction_by_equilibrium(probes[probe], quantity.column);
  }



  bool
  Sampler::is_traction_by_equilibrium(const Probe       &probe,
                                      const std::string &column) const
  {
    if (probe.stress != StressValues::equilibrium)
      return false;
    const LaminateBox box =
      laminate_box(*bodies[probe.body], entry_of("Probe", probe));
    const bool is_level =
      std::abs(box.frame.axes[2][2]) > 1. - arithmetic::rounding_of_results;
    return column == "s33" ||
           (is_level &&
            (column == "szz" || column == "sxz" || column == "syz"));
  }



  void
  Sampler::check(const NamedQuantity &quantity) const
  {
    for (const NamedQuantity &term : quantity.terms)
      check(term);
    if (quantity.of != NamedQuantity::ObjectKind::probe)
      return;
    const auto plies = plies_at(number_of(quantity.name));
    check_ply(quantity, plies);
    if (is_between_plies(quantity))
      refuse_interface(quantity, plies);
  }



  NamedQuantity
  Sampler::in_lower_ply(NamedQuantity quantity) const
  {
    if (is_between_plies(quantity))
      quantity.ply = std::stoul(plies_at(number_of(quantity.name)).front());
    return quantity;
  }



  void
  Sampler::check_cut(const Cut &cut) const
  {
    const Body &body = *bodies[cut.body];
    if (body.cut(cut.position, 1, Vector(body.n_dofs())).empty())
      throw InputError("Cut " + cut.name + "/At",
                       "",
                       "recover.cut-outside: the axis of body '" + body.name() +
                         "' ends before " + to_text(cut.position) +
                         ", the position of the cut",
                       "Write a distance from its start between 0 and Length.");
  }



  class Sampler::Recoveries
  {
  public:
    Recoveries(const Sampler       &sampler,
               const BlockVector   &u,
               const FaceTractions &tractions)
      : sampler(sampler)
      , u(u)
      , tractions(tractions)
    {}

    /// What samples the fields of @p body; @p entry is where it is asked for.
    Fields
    operator()(const unsigned int body,
               const StressValues values,
               const std::string &entry)
    {
      if (values == StressValues::equilibrium)
        return [&of = columns_of(body, entry)](const Location &location) {
          return of.sample(location);
        };
      std::unique_ptr<StressRecovery> &recovery = all[{body, values}];
      if (recovery == nullptr)
        recovery = std::make_unique<StressRecovery>(*sampler.bodies[body],
                                                    u.block(body),
                                                    values);
      return [&of = *recovery](const Location &location) {
        return of.sample(location);
      };
    }

    /// Equilibrium defects since the last call; none if not requested.
    std::optional<double>
    defect(const unsigned int body, const StressValues values)
    {
      if (values != StressValues::equilibrium)
        return std::nullopt;
      return columns.at(body).reset_defect().relative();
    }

  private:
    EquilibriumStress &
    columns_of(const unsigned int body, const std::string &entry)
    {
      return columns
        .try_emplace(
          body, *sampler.bodies[body], body, u.block(body), tractions, entry)
        .first->second;
    }

    const Sampler       &sampler;
    const BlockVector   &u;
    const FaceTractions &tractions;
    std::map<std::pair<unsigned int, StressValues>,
             std::unique_ptr<StressRecovery>>
                                              all;
    std::map<unsigned int, EquilibriumStress> columns;
  };



  void
  Sampler::sample(const BlockVector   &u,
                  StepResults         &results,
                  const FaceTractions &tractions) const
  {
    Recoveries recoveries(*this, u, tractions);
    sample_probes(recoveries, results);
    for (unsigned int l = 0; l < lines.size(); ++l)
      {
        const Fields          fields = recoveries(lines[l].body,
                                         lines[l].stress,
                                         entry_of("Line", lines[l]));
        std::vector<LineRow> &rows   = results.lines.emplace_back();
        for (const auto &[s, location] : line_sample_points[l])
          rows.push_back({s, row_at(lines[l].body, location, fields)});
        results.jumps.push_back(
          interface_jump(rows, lines[l].to - lines[l].from));
        // Where a line crosses plies is a matter of axes that turn along.
        for (LineRow &row : rows)
          if (in_scene_axes)
            to_scene_axes(row.fields.sample);
        results.defects.lines.push_back(
          recoveries.defect(lines[l].body, lines[l].stress));
      }
    for (const Cut &cut : cuts)
      {
        results.cuts.push_back(cut_rows(cut, u, recoveries));
        results.defects.cuts.push_back(recoveries.defect(cut.body, cut.stress));
      }
  }



  std::vector<std::vector<FieldRow>>
  Sampler::sample_probes(const BlockVector   &u,
                         const FaceTractions &tractions) const
  {
    Recoveries  recoveries(*this, u, tractions);
    StepResults results;
    sample_probes(recoveries, results);
    return std::move(results.probes);
  }



  Sampler::Fields
  Sampler::told(Fields fields) const
  {
    if (!in_scene_axes)
      return fields;
    return [fields = std::move(fields)](const Location &location) {
      FieldSample sample = fields(location);
      to_scene_axes(sample);
      return sample;
    };
  }



  void
  Sampler::sample_probes(Recoveries &recoveries, StepResults &results) const
  {
    results.probes.resize(probes.size());
    for (unsigned int p = 0; p < probes.size(); ++p)
      {
        const auto &[body, stress] = std::tie(probes[p].body, probes[p].stress);
        const Fields fields =
          told(recoveries(body, stress, entry_of("Probe", probes[p])));
        for (const BoxPoints &points : probe_points[p])
          results.probes[p].push_back(mean_row(p, points, fields));
        results.defects.probes.push_back(recoveries.defect(body, stress));
      }
  }



  FieldRow
  Sampler::mean_row(const unsigned int p,
                    const BoxPoints   &points,
                    const Fields      &fields) const
  {
    if (points.size() == 1)
      return row_at(probes[p].body, points[0].second, fields);
    FieldRow row{bodies[probes[p].body]->name(),
                 points[0].second.ply,
                 probes[p].position,
                 {}};
    for (const auto &[weight, location] : points)
      {
        const FieldSample sample = fields(location);
        row.sample.displacement += weight * sample.displacement;
        row.sample.strain += weight * sample.strain;
        row.sample.stress += weight * sample.stress;
        row.sample.ply_stress += weight * sample.ply_stress;
        row.sample.jump = std::max(row.sample.jump, sample.jump);
        if (location.ply != row.ply)
          row.ply = several_plies;
      }
    return row;
  }



  FieldRow
  Sampler::row_at(const unsigned int body,
                  const Location    &location,
                  const Fields      &fields) const
  {
    return {bodies[body]->name(),
            location.ply,
            location.position,
            fields(location)};
  }



  std::vector<CutRow>
  Sampler::cut_rows(const Cut         &cut,
                    const BlockVector &u,
                    Recoveries        &recoveries) const
  {
    const Body  &body = *bodies[cut.body];
    const Fields fields =
      recoveries(cut.body, cut.stress, entry_of("Cut", cut));
    const unsigned int  n = cut.samples + 1;
    std::vector<CutRow> rows;
    auto cells = body.cut(cut.position, cut.samples, u.block(cut.body));
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int k = 0; k < cells[c].samples.size(); ++k)
        {
          const Point<3> &x   = cells[c].positions[k];
          CutRow          row = {c,
                                 k % n,
                                 k / n,
                                 {body.name(), cells[c].ply, x, cells[c].samples[k]}};
          if (cut.stress != StressValues::element)
            {
              const auto here = body.locate({x});
              for (const Location &location : here.front())
                if (location.ply == cells[c].ply)
                  row.fields.sample = fields(location);
            }
          if (in_scene_axes)
            to_scene_axes(row.fields.sample);
          rows.push_back(row);
        }
    return rows;
  }



  InterfaceJump
  interface_jump(const std::vector<LineRow> &rows, const Tensor<1, 3> &d)
  {
    InterfaceJump      jump;
    double             largest_jump = 0., traction = 0., component = 0.;
    const Tensor<1, 3> along = d / d.norm();
    const LineRow     *last  = nullptr;
    for (const LineRow &row : rows)
      {
        const Voigt &stress = row.fields.sample.stress;
        traction  = std::max(traction, traction_on(stress, along).norm());
        component = std::max(component, largest_component(stress));
        if (last != nullptr && row.s == last->s &&
            row.fields.ply != last->fields.ply)
          {
            ++jump.interfaces;
            largest_jump = std::max(
              largest_jump,
              traction_on(stress - last->fields.sample.stress, along).norm());
          }
        last = &row;
      }
    // Tractions that are rounding of the other stresses jump by nothing.
    if (traction > arithmetic::negligible * component)
      {
        jump.of_stress   = largest_jump / component;
        jump.of_traction = largest_jump / traction;
      }
    return jump;
  }



  void
  for_each_defect(const Results                           &results,
                  const EquilibriumDefects                &defects,
                  const std::function<void(const std::string &kind,
                                           const std::string &name,
                                           double             share)> &use)
  {
    const auto of_kind = [&use](const char                     *kind,
                                const std::vector<std::string> &names,
                                const auto                     &shares) {
      for (unsigned int k = 0; k < shares.size(); ++k)
        if (shares[k])
          use(kind, names[k], *shares[k]);
    };
    of_kind("probe", results.probes, defects.probes);
    of_kind("line", results.lines, defects.lines);
    of_kind("cut", results.cuts, defects.cuts);
  }
} // namespace lamella
