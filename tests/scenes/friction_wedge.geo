// SPDX-License-Identifier: LGPL-2.1-or-later
// A wedge: its top of width 1 at z = 1, sides that lean by a tangent t from the vertical.
// gmsh -2 friction_wedge.geo -setnumber t 0.28 -o friction_wedge.msh
DefineConstant[t = 0.28];
n = 8;
Point(1) = {-0.5 + t, 0, 0}; Point(2) = {0.5 - t, 0, 0}; Point(3) = {0.5, 1, 0}; Point(4) = {-0.5, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 2, 3, 4} = n + 1;
Transfinite Surface {1};
Recombine Surface {1};
Physical Surface("solid") = {1};
Physical Curve("right")   = {2};
Physical Curve("top")     = {3};
Physical Curve("left")    = {4};
