// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/body/fields.h>
#include <lamella/report/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The output cells of all bodies as patches of deal.II.
    class BodiesOutput : public DataOutInterface<3, 3>
    {
    public:
      /// With reserve factors by @p strength, unless it is null.
      explicit BodiesOutput(const StrengthSweep *strength)
        : strength(strength)
        , dataset_names(make_names(strength != nullptr))
      {}

      void
      add(const Body &body, const unsigned int number, const Vector &u)
      {
        // Cells of a degree that readers draw; expansions may be higher.
        const unsigned int n = std::min(body.degree(), 4u);
        for (const OutputCell &cell : body.output_cells(n, u))
          {
            DataOutBase::Patch<3, 3> patch;
            patch.reference_cell       = ReferenceCells::Hexahedron;
            patch.patch_index          = patches.size();
            patch.n_subdivisions       = n;
            patch.points_are_available = true;
            patch.data.reinit(dataset_names.size() + 3, cell.samples.size());
            for (unsigned int k = 0; k < cell.samples.size(); ++k)
              fill_point(patch, cell, number, k);
            for (unsigned int v = 0; v < 8; ++v)
              {
                const unsigned int corner = n * (v % 2) +
                                            (n + 1) * n * (v / 2 % 2) +
                                            (n + 1) * (n + 1) * n * (v / 4);
                patch.vertices[v] =
                  cell.positions[corner] + cell.samples[corner].displacement;
              }
            patches.push_back(patch);
          }
      }

    private:
      void
      fill_point(DataOutBase::Patch<3, 3> &patch,
                 const OutputCell         &cell,
                 const unsigned int        body,
                 const unsigned int        k) const
      {
        const FieldSample  &sample = cell.samples[k];
        std::vector<double> values = field_values(sample);
        values.pop_back(); // the jump is not known here
        values.push_back(cell.ply + 1);
        values.push_back(body + 1);
        if (strength != nullptr)
          values.push_back(
            strength->inverse_reserve(body, cell.ply, sample.ply_stress));
        for (unsigned int c = 0; c < 3; ++c)
          values.push_back(cell.fibre[c]);
        const Point<3> x = cell.positions[k] + sample.displacement;
        for (unsigned int c = 0; c < 3; ++c)
          values.push_back(x[c]);
        for (unsigned int i = 0; i < values.size(); ++i)
          patch.data(i, k) = static_cast<float>(values[i]);
      }

      const std::vector<DataOutBase::Patch<3, 3>> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return dataset_names;
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        const unsigned int fibre = dataset_names.size() - 3;
        return {{0,
                 2,
                 "displacement",
                 DataComponentInterpretation::component_is_part_of_vector},
                {fibre,
                 fibre + 2,
                 "fibre",
                 DataComponentInterpretation::component_is_part_of_vector}};
      }

      static std::vector<std::string>
      make_names(const bool with_reserve)
      {
        std::vector<std::string> names = field_names();
        names.pop_back();
        names.insert(names.end(), {"ply", "body"});
        if (with_reserve)
          names.push_back("inverse_reserve_factor");
        names.insert(names.end(), {"fibre_x", "fibre_y", "fibre_z"});
        return names;
      }

      const StrengthSweep                  *strength;
      const std::vector<std::string>        dataset_names;
      std::vector<DataOutBase::Patch<3, 3>> patches;
    };
  } // namespace



  std::string
  write_vtu(const std::string   &directory,
            const unsigned int   step,
            const double         factor,
            const Structure     &structure,
            const BlockVector   &u,
            const StrengthSweep *strength)
  {
    BodiesOutput output(strength);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      output.add(*structure.bodies()[b], b, u.block(b));
    output.set_flags(DataOutBase::VtkFlags(
      factor, step, false, DataOutBase::VtkFlags::best_speed, true));

    const std::string name = "solution_" + Utilities::int_to_string(step, 4);
    const auto        part = [&name](const unsigned int process) {
      return n_processes() == 1 ? name + ".vtu" :
                                         name + "." + std::to_string(process) + ".vtu";
    };
    const auto write = [&directory](const std::string &file_name,
                                    const auto        &content) {
      OutputFile file(directory + "/" + file_name);
      try
        {
          content(file.stream());
        }
      catch (const ExceptionBase &)
        {
          // deal.II's word for a stream that takes no more.
          return false;
        }
      return file.put_in_place();
    };
    bool written = write(part(this_process()), [&output](std::ostream &file) {
      output.write_vtu(file);
    });
    if (n_processes() > 1 && is_speaker())
      {
        std::vector<std::string> parts;
        for (unsigned int p = 0; p < n_processes(); ++p)
          parts.push_back(part(p));
        written = write(name + ".pvtu",
                        [&](std::ostream &file) {
                          output.write_pvtu_record(file, parts);
                        }) &&
                  written;
      }
    if (!on_all_processes(written))
      fail_to_write(directory + "/" + name + ".vtu");
    return name + (n_processes() == 1 ? ".vtu" : ".pvtu");
  }



  void
  write_pvd(const std::string                                 &directory,
            const std::string                                 &name,
            const std::vector<std::pair<double, std::string>> &files)
  {
    if (files.empty())
      return;
    std::ostringstream text;
    DataOutBase::write_pvd_record(text, files);
    write_file(directory + "/" + name + ".pvd", text.str());
  }
} // namespace lamella
