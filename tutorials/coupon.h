// SPDX-License-Identifier: LGPL-2.1-or-later

// The section of step-8 and step-15, that of the coupon of
// prm/flexure_test.prm, in millimeters and newtons: 32 plies, one cell a ply
// and six across. With it what may press on its top, and its fields on a grid
// for the pictures.

#ifndef lamella_tutorials_coupon_h
#define lamella_tutorials_coupon_h

#include <lamella/base/units.h>
#include <lamella/material/material.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section.h>
#include <lamella/section/section_response.h>
#include <lamella/section/warping.h>
#include <lamella/shape/shapes.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace lamella
{
  struct Coupon
  {
    static constexpr double width = 13., ply = 0.125;

    Materials                          materials;
    Laminate                           laminate;
    std::shared_ptr<const SectionMesh> mesh;
    std::shared_ptr<const Section>     section;

    /// As a scene describes it: a layup code, a material of the library. The
    /// section's matrices S_pq in LE-2 are all that the rest is made of.
    Coupon()
    {
      const Units units = Units::parse({"Units", "mm, N"});
      materials         = {{"carbon", library_material("IM7-8552", units)}};

      const auto         angles = parse_layup({"Layup", "[0/45/-45/90]4s"});
      const unsigned int n      = angles.size();
      laminate                  = {width,
                                   angles,
                                   std::vector<double>(n, ply),
                                   std::vector<std::string>(n, "carbon"),
                                   /*cells_per_ply=*/{1},
                                   /*cells_across=*/{6}};
      mesh                      = make_section_mesh(laminate, materials);
      section = make_section(mesh, Theory::parse({"Theory", "LE-2"}));
    }

    /**
     * What a nose may do to the section, as section load vectors
     *   f_alpha = int over the top of  -p(x) e_z . Phi_alpha  dx.
     * Where it will touch is the result of a contact analysis, so there is a
     * vector for each hat function p between the nodes at the top, thirteen of
     * them. They sum to 1: their sum is the nose along all of its line.
     */
    std::vector<Vector>
    hats() const
    {
      const CrossSectionElement &element = section->element();
      std::vector<double>        nodes;
      for (const EdgePoint &point : element.edge_points("top"))
        nodes.push_back(point.position[0]);
      std::sort(nodes.begin(), nodes.end());
      const double spacing = nodes[1] - nodes[0];

      std::vector<Vector> loads(nodes.size(), Vector(section->n_fields()));
      const dealii::QIterated<1> rule(dealii::QGauss<1>(3), /*n_copies=*/2);
      for (const auto &[cell, face] : element.boundary_faces("top"))
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const EdgePoint edge =
              element.edge_point(cell, face, rule.point(q)[0]);
            const SectionPoint point = section->evaluate(edge.cell, edge.unit);
            for (unsigned int j = 0; j < nodes.size(); ++j)
              {
                const double hat =
                  1. - std::abs(edge.position[0] - nodes[j]) / spacing;
                if (hat > 0.)
                  for (unsigned int a = 0; a < point.value.size(); ++a)
                    loads[j][(*point.fields)[a]] +=
                      -hat * point.value[a][2] * edge.weight * rule.weight(q);
              }
          }
      return loads;
    }

    /// Writes a field on a regular grid of the section, for the pictures: u_x
    /// and u_z of @p plane, u_y of @p axial.
    void
    draw(std::ostream      &csv,
         const std::string &name,
         const Vector      &plane,
         const Vector      &axial) const
    {
      constexpr unsigned int across = 24;
      const unsigned int     up     = laminate.angles.size();
      for (unsigned int j = 0; j <= up; ++j)
        for (unsigned int i = 0; i <= across; ++i)
          {
            const dealii::Point<2> x(width * i / across, ply * j);
            const auto [cell, unit] = section->locate(x, 1e-8 * width).front();
            const SectionPoint   point = section->evaluate(cell, unit);
            dealii::Tensor<1, 3> u;
            for (unsigned int a = 0; a < point.value.size(); ++a)
              {
                const unsigned int alpha = (*point.fields)[a];
                u[0] += plane[alpha] * point.value[a][0];
                u[1] += axial[alpha] * point.value[a][1];
                u[2] += plane[alpha] * point.value[a][2];
              }
            csv << '"' << name << "\"," << x[0] << "," << x[1] << "," << u[0]
                << "," << u[1] << "," << u[2] << "\n";
          }
    }

    /// The head of the table, the six rigid motions, and what is left of the
    /// six states without them.
    void
    draw_states(std::ostream      &csv,
                const SaintVenant &states,
                const Warping     &warping) const
    {
      csv << "field,x,z,ux,uy,uz\n";
      const char *rigid[] = {
        "u_x", "u_y", "u_z", "turn about z", "turn about x", "turn about y"};
      const char *warped[] = {"extension",
                              "torsion",
                              "bending about z",
                              "bending about x",
                              "shear along x",
                              "shear along z"};
      for (unsigned int r = 0; r < 6; ++r)
        {
          Vector field(section->n_fields());
          field[r] = 1.;
          draw(csv, rigid[r], field, field);
        }
      for (unsigned int k = 0; k < 6; ++k)
        {
          Vector field = states.values()[k];
          warping.remove_rigid(field);
          draw(csv, warped[k], field, field);
        }
    }

    /// The responses to @p load at some wave numbers of its shape along the
    /// axis. The load is real, so sections move in their plane where it is
    /// largest and along the axis a quarter of a wave further: real part in the
    /// plane, imaginary part along the axis.
    void
    draw_responses(std::ostream      &csv,
                   const std::string &name,
                   const Vector      &load,
                   const Warping     &warping) const
    {
      for (const std::string k : {"0.2", "1", "5"})
        {
          const auto parts =
            SectionResponse(*section).at(std::stod(k), {load})[0];
          Vector plane = parts.front(), axial = parts.back();
          warping.remove_rigid(plane);
          warping.remove_rigid(axial);
          draw(csv, name + ", k = " + k, plane, axial);
        }
    }
  };



  inline Vector
  sum_of(const std::vector<Vector> &vectors)
  {
    Vector sum(vectors[0].size());
    for (const Vector &one : vectors)
      sum += one;
    return sum;
  }



  /// @p n wave numbers from @p first to @p last in equal ratios.
  inline std::vector<double>
  wave_numbers(const double first, const double last, const unsigned int n)
  {
    std::vector<double> k;
    for (unsigned int i = 0; i < n; ++i)
      k.push_back(first * std::pow(last / first, i / (n - 1.)));
    return k;
  }



  /// Responses @p of_loads at the wave numbers @p waves, each a real and an
  /// imaginary part, which are fields of their own. SectionResponse factorizes
  /// once for each wave number, for all loads.
  inline std::vector<std::vector<Vector>>
  responses(const Section             &section,
            const std::vector<Vector> &of_loads,
            const std::vector<double> &waves)
  {
    const SectionResponse            response(section);
    std::vector<std::vector<Vector>> result;
    for (const double k : waves)
      for (std::vector<Vector> &parts : response.at(k, of_loads))
        result.push_back(std::move(parts));
    return result;
  }



  /// All of them together nearly depend on each other. Warping::basis() takes
  /// the rigid motions and the fields @p known out, scales what is left to unit
  /// norm, and keeps the combinations that are independent by more than @p
  /// tolerance.
  inline FieldColumns
  basis_of(const std::vector<std::vector<Vector>> &responses,
           const Warping                          &warping,
           const FieldColumns                     &known,
           const double                            tolerance)
  {
    std::vector<Vector> snapshots;
    for (const std::vector<Vector> &parts : responses)
      snapshots.insert(snapshots.end(), parts.begin(), parts.end());
    return warping.basis(snapshots, known, known, tolerance);
  }
} // namespace lamella

#endif
