// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/report/tables.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace lamella
{
  using namespace dealii;
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// Below this share of what it could be, a number is rounding.
    constexpr double negligible = arithmetic::rounding_of_solutions;



    /// DoFs of LE-@p degree: 3 per vertex and node inside of sides and cells.
    double
    n_dofs(const SectionMesh &section, const unsigned int degree)
    {
      const double inner = degree - 1.;
      return 3. * (section.mesh.n_used_vertices() +
                   inner * section.mesh.n_active_lines() +
                   inner * inner * section.mesh.n_active_cells());
    }



    /// @p m with couplings that are rounding set to zero. Throws NumericsError
    /// unless it has a positive diagonal and finite entries.
    SectionTensor
    cleaned(SectionTensor m)
    {
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          {
            const double scale = std::sqrt(m[i][i]) * std::sqrt(m[j][j]);
            if (!(scale > 0.) || !std::isfinite(m[i][j]))
              throw NumericsError(
                "report.section-ill-conditioned: The stiffness of the section "
                "is too ill-conditioned for double precision: use thicker "
                "cells, or more similar moduli.");
            if (i != j && std::abs(m[i][j]) < negligible * scale)
              m[i][j] = 0.;
          }
      return m;
    }



    /// @p point with coordinates that are rounding set to zero.
    Point<2>
    cleaned(Point<2> point, const double size)
    {
      for (unsigned int d = 0; d < 2; ++d)
        if (std::abs(point[d]) < negligible * size)
          point[d] = 0.;
      return point;
    }



    SectionConstants
    constants_of(const SectionTensor &compliance,
                 const Point<2>      &center,
                 const double         size)
    {
      SectionConstants result = section_constants(compliance, center);
      result.tension_center   = cleaned(result.tension_center, size);
      result.shear_center     = cleaned(result.shear_center, size);
      // Upright is upright, whichever way rounding turned it; in degrees.
      constexpr double same_angle = arithmetic::decimal_tolerance;
      if (result.angle < same_angle - 90.)
        result.angle += 180.;
      if (std::abs(result.angle) < same_angle)
        result.angle = 0.;
      for (const double value : {result.EA,
                                 result.EI[0],
                                 result.EI[1],
                                 result.GJ,
                                 result.kGA_x,
                                 result.kGA_z})
        if (!(value > 0.) || !std::isfinite(value))
          throw NumericsError(
            "report.section-ill-conditioned: The 6 x 6 section compliance is "
            "too ill-conditioned. Use more similar moduli.");
      return result;
    }



    std::optional<SectionTensor>
    mass_of(const Section &section)
    {
      for (const Ply &ply : section.plies())
        if (!ply.properties.density)
          return {};
      const auto    &points = section.integration_points();
      SectionTensor  mass;
      const Point<2> center = section.element().center();
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const double x = points[q].position[0] - center[0],
                       z = points[q].position[1] - center[1];
          const double m = section.integration_weights()[q] *
                           *section.plies()[section.cell_ply(points[q].cell)]
                              .properties.density;
          // The columns of N.
          const std::array<Tensor<1, 3>, 6> u{{Tensor<1, 3>({1., 0., 0.}),
                                               Tensor<1, 3>({0., 1., 0.}),
                                               Tensor<1, 3>({0., 0., 1.}),
                                               Tensor<1, 3>({0., -z, 0.}),
                                               Tensor<1, 3>({z, 0., -x}),
                                               Tensor<1, 3>({0., x, 0.})}};
          for (unsigned int i = 0; i < 6; ++i)
            for (unsigned int j = 0; j < 6; ++j)
              mass[i][j] += m * (u[i] * u[j]);
        }
      return cleaned(mass);
    }



    void
    compute(const Section &section, SectionStiffness &result)
    {
      const double size      = section.element().reference_length();
      result.reference_point = cleaned(section.element().center(), size);
      const SaintVenant states(section);
      result.compliance = cleaned(states.compliance());
      result.stiffness  = cleaned(states.stiffness());
      result.constants =
        constants_of(result.compliance, section.element().center(), size);
      result.mass = mass_of(section);
    }



    Json
    to_json(const Point<2> &point)
    {
      return Json::array({point[0], point[1]});
    }



    Json
    to_json(const SectionTensor &m)
    {
      Json rows = Json::array();
      for (unsigned int i = 0; i < 6; ++i)
        {
          rows.push_back(Json::array());
          for (unsigned int j = 0; j < 6; ++j)
            rows.back().push_back(m[i][j]);
        }
      return rows;
    }
  } // namespace



  unsigned int
  expansion_degree(const SectionMesh &mesh)
  {
    if (n_dofs(mesh, 3) <= 20000.)
      return 3;
    return n_dofs(mesh, 2) <= 60000. ? 2 : 1;
  }



  SectionStiffness
  section_stiffness(std::shared_ptr<const SectionMesh> mesh)
  {
    constexpr double max_dofs = 300000.;

    SectionStiffness result;
    const Theory     theory = Theory::layerwise(expansion_degree(*mesh));
    result.expansion        = "LE-" + std::to_string(theory.order);
    try
      {
        if (n_dofs(*mesh, theory.order) > max_dofs)
          throw NumericsError(
            "report.section-too-large: The section has more than 300,000 DoFs "
            "with theory LE-1. Use a coarser mesh of the section.");
        compute(*make_section(std::move(mesh), theory), result);
      }
    catch (const NumericsError &error)
      {
        result.fault = error.what();
      }
    return result;
  }



  std::string
  section_json(const std::string      &name,
               const SectionStiffness &section,
               const Units            &units)
  {
    Json json;
    json["section"]   = name;
    json["units"]     = {{"length", units.length}, {"force", units.force}};
    json["expansion"] = section.expansion;
    if (!section.fault.empty())
      json["fault"] = section.fault;
    else
      {
        const SectionConstants &constants = section.constants;
        json["order"]                     = section_force_names;
        json["reference_point"]           = to_json(section.reference_point);
        json["EA"]                        = constants.EA;
        json["EI_1"]                      = constants.EI[0];
        json["EI_2"]                      = constants.EI[1];
        json["angle_deg"]                 = constants.angle;
        json["GJ"]                        = constants.GJ;
        json["kGA_x"]                     = constants.kGA_x;
        json["kGA_z"]                     = constants.kGA_z;
        json["tension_center"]            = to_json(constants.tension_center);
        json["shear_center"]              = to_json(constants.shear_center);
        json["stiffness"]                 = to_json(section.stiffness);
        json["compliance"]                = to_json(section.compliance);
        if (section.mass)
          json["mass"] = to_json(*section.mass);
      }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }



  void
  write_section(const std::string      &directory,
                const std::string      &name,
                const SectionMesh      &mesh,
                const SectionStiffness &section,
                const Units            &units)
  {
    const std::string path = directory + "/sections/" + name;
    write_file(path + ".csv", section_table(mesh));
    write_file(path + ".json", section_json(name, section, units));
  }
} // namespace lamella
