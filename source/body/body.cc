// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/body_solver.h>
#include <lamella/body/fields.h>
#include <lamella/shape/section_mesh.h>

namespace lamella
{
  using namespace dealii;

  Body::Body(std::string name, const Placement &placement)
    : placement(placement)
    , body_name(std::move(name))
  {}



  Body::~Body() = default;



  const Constraints &
  Body::kinematic_constraints() const
  {
    static const Constraints none = [] {
      Constraints empty;
      empty.close();
      return empty;
    }();
    return none;
  }



  Point<3>
  Body::center() const
  {
    return bounding_box().center();
  }



  double
  Body::size() const
  {
    const BoundingBox<3> box = bounding_box();
    return 0.5 *
           std::max(
             {box.side_length(0), box.side_length(1), box.side_length(2)});
  }



  namespace
  {
    [[noreturn]] void
    refuse_material(const Ply         &ply,
                    const std::string &property,
                    const Body        &body,
                    const std::string &what_asks_for_it,
                    const std::string &remedy)
    {
      throw InputError("Material " + ply.material,
                       "",
                       "body.material-property-missing: the material has no " +
                         property + ", and body '" + body.name() +
                         "', which consists of this material, " +
                         what_asks_for_it,
                       remedy);
    }
  } // namespace



  void
  Body::heat(const ScalarField &change)
  {
    for (const Ply &ply : plies())
      if (!ply.properties.expansion)
        refuse_material(ply,
                        "Thermal expansion",
                        *this,
                        "has a Temperature",
                        "Write it, or remove the body from the load.");
    temperature_change = change;
  }



  std::vector<double>
  densities(const Body &body)
  {
    std::vector<double> rho;
    for (const Ply &ply : body.plies())
      {
        if (!ply.properties.density)
          refuse_material(
            ply,
            "Density",
            body,
            "needs it for Gravity or Find = modes",
            "Write it (0 if its mass does not count), or leave these out.");
        rho.push_back(*ply.properties.density);
      }
    return rho;
  }



  bool
  have_densities(const Bodies &bodies)
  {
    for (const auto &body : bodies)
      for (const Ply &ply : body->plies())
        if (!ply.properties.density)
          return false;
    return true;
  }



  void
  Body::add_internal_forces(const Vector &u, Vector &f) const
  {
    add_product_of_blocks(
      [&](const auto &use) {
        for_each_stiffness_block(undisplaced, undisplaced, true, use);
      },
      u,
      f);
  }



  void
  Body::add_tangent_forces(const Vector &u, const Vector &w, Vector &f) const
  {
    if (!has_finite_rotations())
      return add_internal_forces(w, f);
    add_product_of_blocks(
      [&](const auto &use) {
        for_each_stiffness_block(u, Vector(u.size()), true, use);
      },
      w,
      f);
  }



  double
  Body::stiffness_entries() const
  {
    double n = 0.;
    for_each_stiffness_block(
      undisplaced, undisplaced, false, [&n](const StiffnessBlock &block) {
        n += double(block.rows.size()) * block.columns.size();
      });
    return dealii::Utilities::MPI::sum(n, communicator());
  }
} // namespace lamella
