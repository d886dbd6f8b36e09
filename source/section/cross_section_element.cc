// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/cross_section_element.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/grid/grid_tools.h>

namespace lamella
{
  using namespace dealii;

  CrossSectionElement::CrossSectionElement(
    const std::shared_ptr<const SectionMesh> &mesh,
    const unsigned int                        geometric_degree)
    : mesh(mesh)
    , geometry(mesh, geometric_degree)
  {
    double       area = 0.;
    Tensor<1, 2> moment;
    for (const auto &cell : mesh->mesh.active_cell_iterators())
      {
        area += cell->measure();
        moment += cell->measure() * Tensor<1, 2>(cell->barycenter());
      }
    origin = Point<2>(moment / area);

    const auto corners = bounding_box().get_boundary_points();
    length             = 0.5 * corners.first.distance(corners.second);
  }



  BoundingBox<2>
  CrossSectionElement::bounding_box() const
  {
    return GridTools::compute_bounding_box(mesh->mesh);
  }



  FunctionValues
  CrossSectionElement::linear_functions(const Point<2>     &position,
                                        const Tensor<2, 2> &jacobian) const
  {
    FunctionValues result;
    result.position  = position;
    result.jacobian  = jacobian;
    result.values    = {1.,
                        (position[0] - origin[0]) / length,
                        (position[1] - origin[1]) / length};
    result.gradients = {Tensor<1, 2>(),
                        Point<2>(1. / length, 0.),
                        Point<2>(0., 1. / length)};
    return result;
  }



  std::vector<std::pair<unsigned int, unsigned int>>
  CrossSectionElement::boundary_faces(const std::string &name) const
  {
    std::vector<std::pair<unsigned int, unsigned int>> faces;
    for (const auto &cell : mesh->mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            mesh->boundaries.at(cell->face(f)->boundary_id()) == name)
          faces.emplace_back(cell->active_cell_index(), f);
    return faces;
  }



  void
  CrossSectionElement::add_side(EdgePoint          &point,
                                const SideShare    &share,
                                const Tensor<1, 2> &own_normal)
  {
    constexpr double cosine = 0.94;
    if (point.weight > 0. && own_normal * point.normal <
                               cosine * own_normal.norm() * point.normal.norm())
      point.corner = true;
    point.normal += share.scaled_normal;
    point.weight += share.weight;
  }



  CrossSectionElement::SideShare
  CrossSectionElement::side_share(
    const unsigned int                         cell,
    const unsigned int                         face,
    const Quadrature<1>                       &quadrature,
    const std::function<double(const double)> &shape) const
  {
    SideShare result;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double       t = quadrature.point(q)[0];
        const Tensor<1, 2> n =
          scaled_face_normal(face, map(cell, face_point(face, t)).jacobian);
        const double share = shape(t) * quadrature.weight(q);
        result.scaled_normal += share * n;
        result.weight += share * n.norm();
      }
    return result;
  }



  EdgePoint
  CrossSectionElement::point_at(const unsigned int cell,
                                const Point<2>    &unit) const
  {
    EdgePoint point;
    point.cell     = cell;
    point.unit     = unit;
    point.position = map(cell, unit).position;
    return point;
  }



  double
  CrossSectionElement::depth(const unsigned int cell,
                             const unsigned int face) const
  {
    const auto   jacobian = map(cell, face_point(face, 0.5)).jacobian;
    const double area     = std::abs(determinant(jacobian));
    return area / scaled_face_normal(face, jacobian).norm();
  }



  EdgePoint
  CrossSectionElement::edge_point(const unsigned int cell,
                                  const unsigned int face,
                                  const double       t) const
  {
    EdgePoint point;
    point.cell     = cell;
    point.unit     = face_point(face, t);
    const auto at  = map(cell, point.unit);
    point.position = at.position;
    point.normal   = scaled_face_normal(face, at.jacobian);
    point.weight   = point.normal.norm();
    point.normal /= point.weight;
    point.depth = depth(cell, face);
    return point;
  }



  Point<2>
  face_point(const unsigned int face, const double t)
  {
    // deal.II's faces of the unit square: x = 0, x = 1, y = 0, y = 1.
    const double fixed = face % 2;
    return face < 2 ? Point<2>(fixed, t) : Point<2>(t, fixed);
  }



  Tensor<1, 2>
  scaled_face_normal(const unsigned int face, const Tensor<2, 2> &jacobian)
  {
    Tensor<1, 2> unit_normal;
    unit_normal[face / 2] = face % 2 == 1 ? 1. : -1.;
    // Nanson's formula in the plane.
    return determinant(jacobian) * (transpose(invert(jacobian)) * unit_normal);
  }
} // namespace lamella
