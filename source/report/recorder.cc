// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/text.h>
#include <lamella/report/fields_table.h>
#include <lamella/report/recorder.h>

#include <algorithm>
#include <array>
#include <memory>

namespace lamella
{
  using namespace dealii;

  Recorder::Recorder(const Structure                     &structure,
                     const std::vector<ContactInterface> &contacts,
                     const std::vector<std::string>      &support_names,
                     const std::vector<Probe>            &probes,
                     const std::vector<Line>             &lines,
                     const std::vector<Cut>              &cuts)
    : structure(structure)
    , contacts(contacts)
    , support_names(support_names)
    , probes(probes)
    , lines(lines)
    , cuts(cuts)
  {
    for (const Probe &probe : probes)
      {
        const Body &body = *structure.bodies()[probe.body];
        probe_locations.push_back(
          locate_sides(body, {probe.position}, "Probe " + probe.name).front());
      }
    for (const Line &line : lines)
      locate_line(line);
    for (const Cut &cut : cuts)
      {
        const Body &body = *structure.bodies()[cut.body];
        if (body.cut(cut.position, 1, Vector(body.n_dofs())).empty())
          throw InputError("Cut " + cut.name + "/At: the axis of body '" +
                           body.name() + "' does not reach " +
                           to_text(cut.position) +
                           ". Give a distance from its start, up to its "
                           "Length.");
      }

    files["probes.csv"]  = "step,probe," + fields_header() + "\n";
    files["history.csv"] = history_header() + "\n";
    for (const Line &line : lines)
      files["lines/" + line.name + ".csv"] =
        "s,step,line," + fields_header() + "\n";
    for (const Cut &cut : cuts)
      files["cuts/" + cut.name + ".csv"] =
        "step,cut,cell,i,j," + fields_header() + "\n";
    for (const ContactInterface &contact : contacts)
      files["contact_" + contact.name + ".csv"] =
        "step,x,y,z,x2,y2,z2,nx,ny,nz,area,initial_gap,gap,force,pressure,"
        "active\n";
  }



  void
  Recorder::locate_line(const Line &line)
  {
    const Body       &body  = *structure.bodies()[line.body];
    const std::string what  = "Line " + line.name;
    const auto        point = [&line](const double t) {
      return line.from + t * (line.to - line.from);
    };
    locate_all(body, {line.from, line.to}, what);

    // Pieces of one ply each: elements of the same ply are merged. A line in an
    // interface has two sides, the lower ply first, then all of the upper one.
    struct Piece
    {
      double       begin, end;
      unsigned int ply;
    };
    std::array<std::vector<Piece>, 2> sides;
    const std::vector<double> breaks = body.line_breaks(line.from, line.to);
    std::vector<Point<3>>     middles;
    for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
      middles.push_back(point(0.5 * (breaks[k] + breaks[k + 1])));
    const auto found = locate_sides(body, middles, what);
    for (unsigned int k = 0; k < middles.size(); ++k)
      {
        const std::vector<Location> &plies = found[k];
        for (unsigned int side = 0;
             side < std::min<std::size_t>(2, plies.size());
             ++side)
          {
            std::vector<Piece> &pieces = sides[side];
            if (!pieces.empty() && pieces.back().ply == plies[side].ply &&
                pieces.back().end == breaks[k])
              pieces.back().end = breaks[k + 1];
            else
              pieces.push_back({breaks[k], breaks[k + 1], plies[side].ply});
          }
      }
    std::vector<Piece> all = std::move(sides[0]);
    all.insert(all.end(), sides[1].begin(), sides[1].end());

    line_samples.emplace_back();
    for (const Piece &piece : all)
      for (unsigned int i = 0; i < line.samples; ++i)
        {
          const double t =
            piece.begin + (piece.end - piece.begin) * i / (line.samples - 1);
          const std::vector<Location> both = body.locate({point(t)}).front();
          for (const Location &location : both)
            if (location.ply == piece.ply)
              line_samples.back().push_back(
                {t * line.from.distance(line.to), location});
        }
  }



  class Recorder::Recoveries
  {
  public:
    Recoveries(const Structure &structure, const BlockVector &u)
      : structure(structure)
      , u(u)
    {}

    StressRecovery &
    operator()(const unsigned int body, const StressValues values)
    {
      std::unique_ptr<StressRecovery> &recovery = all[{body, values}];
      if (recovery == nullptr)
        recovery = std::make_unique<StressRecovery>(*structure.bodies()[body],
                                                    u.block(body),
                                                    values);
      return *recovery;
    }

  private:
    const Structure   &structure;
    const BlockVector &u;
    std::map<std::pair<unsigned int, StressValues>,
             std::unique_ptr<StressRecovery>>
      all;
  };



  void
  Recorder::record(const unsigned int step,
                   const double       factor,
                   const State       &state,
                   const Checks      &checks)
  {
    Recoveries recoveries(structure, state.u);
    record_probes(step, recoveries);
    jumps.clear();
    for (unsigned int l = 0; l < lines.size(); ++l)
      record_line(step, l, recoveries);
    for (const Cut &cut : cuts)
      record_cut(step, cut, state.u, recoveries);
    record_contacts(step, factor, state);
    record_history(step, factor, checks);
  }



  namespace
  {
    /// sigma . d.
    Tensor<1, 3>
    traction_on(const Voigt &s, const Tensor<1, 3> &d)
    {
      return Point<3>(s[0] * d[0] + s[3] * d[1] + s[4] * d[2],
                      s[3] * d[0] + s[1] * d[1] + s[5] * d[2],
                      s[4] * d[0] + s[5] * d[1] + s[2] * d[2]);
    }
  } // namespace



  void
  Recorder::record_probes(const unsigned int step, Recoveries &recoveries)
  {
    last_probe_samples.clear();
    for (unsigned int p = 0; p < probes.size(); ++p)
      {
        const Body     &body     = *structure.bodies()[probes[p].body];
        StressRecovery &recovery = recoveries(probes[p].body, probes[p].stress);
        for (const Location &location : probe_locations[p])
          {
            const FieldSample sample = recovery.sample(location);
            if (last_probe_samples.size() == p)
              last_probe_samples.push_back(sample);
            files["probes.csv"] += std::to_string(step) + "," + probes[p].name +
                                   "," +
                                   fields_line(body.name(),
                                               location.ply,
                                               location.position,
                                               sample) +
                                   "\n";
          }
      }
  }



  void
  Recorder::record_cut(const unsigned int step,
                       const Cut         &cut,
                       const BlockVector &u,
                       Recoveries        &recoveries)
  {
    const Body        &body     = *structure.bodies()[cut.body];
    StressRecovery    &recovery = recoveries(cut.body, cut.stress);
    std::string       &file     = files["cuts/" + cut.name + ".csv"];
    const unsigned int n        = cut.samples + 1;
    auto cells = body.cut(cut.position, cut.samples, u.block(cut.body));
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int k = 0; k < cells[c].samples.size(); ++k)
        {
          FieldSample    &sample = cells[c].samples[k];
          const Point<3> &x      = cells[c].positions[k];
          if (cut.stress != StressValues::element)
            {
              const auto here = body.locate({x});
              for (const Location &location : here.front())
                if (location.ply == cells[c].ply)
                  sample = recovery.sample(location);
            }
          file += std::to_string(step) + "," + cut.name + "," +
                  std::to_string(c) + "," + std::to_string(k % n) + "," +
                  std::to_string(k / n) + "," +
                  fields_line(body.name(), cells[c].ply, x, sample) + "\n";
        }
  }



  void
  Recorder::record_line(const unsigned int step,
                        const unsigned int l,
                        Recoveries        &recoveries)
  {
    const Line        &line     = lines[l];
    const Body        &body     = *structure.bodies()[line.body];
    StressRecovery    &recovery = recoveries(line.body, line.stress);
    std::string       &file     = files["lines/" + line.name + ".csv"];
    const Tensor<1, 3> d = (line.to - line.from) / line.from.distance(line.to);

    InterfaceJump jump{line.name, 0, 0.};
    double        largest = 0., largest_stress = 0., last_s = -1.;
    Tensor<1, 3>  last;
    unsigned int  last_ply = 0;
    for (const auto &[s, location] : line_samples[l])
      {
        const FieldSample sample = recovery.sample(location);
        file +=
          csv(s) + "," + std::to_string(step) + "," + line.name + "," +
          fields_line(body.name(), location.ply, location.position, sample) +
          "\n";

        const Tensor<1, 3> traction = traction_on(sample.stress, d);
        largest                     = std::max(largest, traction.norm());
        largest_stress = std::max(largest_stress, sample.stress.norm());
        if (s == last_s && location.ply != last_ply)
          {
            ++jump.interfaces;
            jump.relative = std::max(jump.relative, (traction - last).norm());
          }
        last_s   = s;
        last     = traction;
        last_ply = location.ply;
      }
    // Tractions that are rounding of the other stresses jump by nothing.
    jump.relative =
      largest > 1e-9 * largest_stress ? jump.relative / largest : 0.;
    if (jump.interfaces > 0)
      jumps.push_back(jump);
  }



  void
  Recorder::record_contacts(const unsigned int step,
                            const double       factor,
                            const State       &state)
  {
    touching.resize(state.force.size(), false);
    changes.resize(contacts.size());
    unsigned int row = 0;
    for (unsigned int i = 0; i < contacts.size(); ++i)
      {
        const ContactInterface &contact = contacts[i];
        std::string   &file   = files["contact_" + contact.name + ".csv"];
        StatusChanges &change = changes[i].emplace_back();
        for (unsigned int k = 0; k < contact.rows.size(); ++k, ++row)
          {
            const ContactInterface::Point &point = contact.points[k];
            file += std::to_string(step);
            for (const auto *x : {&point.first, &point.second})
              for (unsigned int c = 0; c < 3; ++c)
                file += "," + csv((*x)[c]);
            for (unsigned int c = 0; c < 3; ++c)
              file += "," + csv(point.normal[c]);
            const double force = state.force[row];
            for (const double value : {point.area,
                                       contact.rows[k].initial_gap,
                                       contact.rows[k].gap(state.u, factor),
                                       force,
                                       force / point.area})
              file += "," + csv(value);
            const bool touches = force > 0.;
            file += touches ? ",1\n" : ",0\n";
            change.closed += touches && !touching[row];
            change.opened += !touches && touching[row];
            touching[row] = touches;
          }
      }
  }



  std::string
  Recorder::history_header() const
  {
    std::string header = "step,load_factor";
    for (const std::string &name : support_names)
      for (const char *c : {"fx", "fy", "fz"})
        header += ",support:" + name + ":" + c;
    for (const ContactInterface &contact : contacts)
      for (const char *c : {"fx", "fy", "fz"})
        header += ",contact:" + contact.name + ":" + c;
    for (const Probe &probe : probes)
      for (const char *c : {"ux", "uy", "uz"})
        header += ",probe:" + probe.name + ":" + c;
    return header;
  }



  void
  Recorder::record_history(const unsigned int step,
                           const double       factor,
                           const Checks      &checks)
  {
    std::string line = std::to_string(step) + "," + csv(factor);
    const auto  add  = [&line](const Tensor<1, 3> &v) {
      for (unsigned int c = 0; c < 3; ++c)
        line += "," + csv(v[c]);
    };
    for (const Tensor<1, 3> &reaction : checks.reactions)
      add(reaction);
    for (const KuhnTucker &contact : checks.contacts)
      add(contact.force);
    for (const FieldSample &sample : last_probe_samples)
      add(sample.displacement);
    files["history.csv"] += line + "\n";
  }



  double
  Recorder::probe_value(const unsigned int probe,
                        const std::string &quantity) const
  {
    const auto &names = field_names();
    const auto  place = std::find(names.begin(), names.end(), quantity);
    Assert(place != names.end(), ExcMessage("No such quantity."));
    return field_values(last_probe_samples[probe])[place - names.begin()];
  }



  void
  Recorder::write(const std::string &directory) const
  {
    for (const auto &[name, text] : files)
      write_file(directory + "/" + name, text);
  }
} // namespace lamella
