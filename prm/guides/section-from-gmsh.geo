// SPDX-License-Identifier: LGPL-2.1-or-later
// An equilateral triangle, 20 mm on each side, its centroid in the origin:
//   gmsh -2 section-from-gmsh.geo -o section-from-gmsh.msh
side  = 20;
cells = 3;                       // along half of a side

r = side / Sqrt(3);              // centroid to corner
For i In {0:2}
  a = Pi / 2 + 2 * Pi * i / 3;
  Point(1 + i) = {r * Cos(a), r * Sin(a), 0};                              // corners
  Point(4 + i) = {r / 2 * Cos(a + Pi / 3), r / 2 * Sin(a + Pi / 3), 0};    // middles of sides
EndFor
Point(7) = {0, 0, 0};
For i In {0:2}
  Line(1 + i) = {1 + i, 4 + i};             // corner to middle
  Line(4 + i) = {4 + i, 1 + (i + 1) % 3};   // middle to next corner
  Line(7 + i) = {4 + i, 7};                 // middle to centroid
EndFor
// A block of four sides around each corner.
For i In {0:2}
  before = (i + 2) % 3;
  Curve Loop(1 + i) = {4 + before, 1 + i, 7 + i, -(7 + before)};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Curve {1:9} = cells + 1;
Transfinite Surface {1:3};
Recombine Surface {1:3};

Physical Surface("steel") = {1:3};          // a material of the scene
Physical Curve("left")    = {1, 4};
Physical Curve("bottom")  = {2, 5};
Physical Curve("right")   = {3, 6};
