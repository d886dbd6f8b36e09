// SPDX-License-Identifier: LGPL-2.1-or-later
// A hollow regular hexagon, 20 mm between opposite corners outside, walls 2 mm
// thick: gmsh -2 hexagon.geo -o hexagon.msh
//
// Six transfinite walls, from corner to corner; the scene calls the material
// carbon as well, so it needs no Parts.

outside = 10;                          // center to corner
inside  = outside - 2 / Cos(Pi / 6);   // walls 2 thick
across  = 2;                           // cells through a wall
along   = 3;                           // cells along a wall

For i In {0:5}
  angle = i * Pi / 3;
  Point(1 + i)  = {outside * (1 + Cos(angle)), outside * Sin(angle), 0};
  Point(11 + i) = {outside + inside * Cos(angle), inside * Sin(angle), 0};
EndFor
For i In {0:5}
  next = (i + 1) % 6;
  Line(1 + i)  = {1 + i, 1 + next};    // outside
  Line(11 + i) = {11 + i, 11 + next};  // inside
  Line(21 + i) = {11 + i, 1 + i};      // between walls
EndFor
For i In {0:5}
  next = (i + 1) % 6;
  Curve Loop(1 + i) = {21 + i, 1 + i, -(21 + next), -(11 + i)};
  Plane Surface(1 + i) = {1 + i};
EndFor

Transfinite Curve {1:6, 11:16} = along + 1;
Transfinite Curve {21:26} = across + 1;
Transfinite Surface {1:6};
Recombine Surface {1:6};

Physical Surface("carbon") = {1:6};
Physical Curve("top")     = {2};
Physical Curve("bottom")  = {5};
Physical Curve("outside") = {1, 3, 4, 6};
Physical Curve("inside")  = {11:16};
