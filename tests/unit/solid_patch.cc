// SPDX-License-Identifier: LGPL-2.1-or-later

// The patch test of solids.

#include "patch_states.h"
#include "solid_fixtures.h"

#include <lamella/shape/shapes.h>

BOOST_AUTO_TEST_SUITE(solid_patch)

using namespace lamella;

BOOST_AUTO_TEST_CASE(straight_cells)
{
  const auto C = one_material()->plies[0].stiffness();
  for (const unsigned int degree : {1, 2})
    {
      Solid regular(
        "regular", one_material(), axis_mesh(1.3, 2), Placement(), degree);
      check_patch(regular, C);
      Solid skew(
        "skew", distorted(one_material()), axis_mesh(1.3, 2), tilted, degree);
      check_patch(skew,
                  transpose(strain_rotation(tilted.axes)) * C *
                    strain_rotation(tilted.axes));
      Solid hanging("hanging",
                    distorted(one_material()),
                    axis_mesh(1.3, 2),
                    Placement(),
                    degree,
                    around_a_corner);
      BOOST_TEST(!hanging.hexahedra().hanging_nodes().empty());
      check_patch(hanging, C);
    }
}



BOOST_AUTO_TEST_CASE(curved_cells)
{
  // Hanging nodes on the curve, too: their places are those that the coarse
  // side interpolates.
  const OrientedMaterial oriented_material{"carbon", 20.};
  SolidRefinement        ball{0, {{{0.5, 0.6, 0.}, 0.2, 1}}};
  const auto             mesh =
    make_section_mesh(HalfDisc{0.5, 75., 0.2, 4, oriented_material},
                      {{"carbon", orthotropic}});
  for (const unsigned int degree : {1, 2})
    {
      Solid solid(
        "half disc", mesh, axis_mesh(1.3, 2), Placement(), degree, ball);
      BOOST_TEST(!solid.hexahedra().hanging_nodes().empty());
      check_patch(solid, mesh->plies[0].stiffness());
    }
}

BOOST_AUTO_TEST_SUITE_END()
