// SPDX-License-Identifier: LGPL-2.1-or-later
// The right half of an elastic half plane under a punch of half width 1, cells finest at its
// edge: gmsh -2 friction_punch.geo -o friction_punch.msh
far = 600; pad = 18; edge = 8; out = 16;
Point(1) = {0, 0, 0};    Point(2) = {0.9, 0, 0};    Point(3) = {1, 0, 0};    Point(4) = {far, 0, 0};
Point(5) = {0, -far, 0}; Point(6) = {0.9, -far, 0}; Point(7) = {1, -far, 0}; Point(8) = {far, -far, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4};
Line(4) = {5, 6}; Line(5) = {6, 7}; Line(6) = {7, 8};
Line(7) = {1, 5}; Line(8) = {2, 6}; Line(9) = {3, 7}; Line(10) = {4, 8};
Transfinite Curve {1, 4} = pad + 1;
Transfinite Curve {2, 5} = edge + 1 Using Progression 0.7;
Transfinite Curve {3, 6, 7, 8, 9, 10} = out + 1 Using Progression 1.8;
For k In {1:3}
  Curve Loop(k) = {k, 7 + k, -(3 + k), -(6 + k)};
  Plane Surface(k) = {k};
  Transfinite Surface {k};
  Recombine Surface {k};
EndFor
Physical Surface("solid") = {1:3};
Physical Curve("pad")     = {1, 2};
Physical Curve("middle")  = {7};
Physical Curve("base")    = {4, 5, 6};
