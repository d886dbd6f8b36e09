// SPDX-License-Identifier: LGPL-2.1-or-later
// A double-T 20 mm wide and 30 mm high with rounded corners between its web (2 mm)
// and its flanges (3 mm), radius 3 mm: gmsh -2 rail.geo -o rail.msh
//
// Not a structured mesh: Gmsh recombines triangles into quadrilaterals; with
// RecombinationAlgorithm = 3 no triangle stays.

width = 20; height = 30; web = 2; flange = 3; radius = 3;
size = 1.5;                            // of the cells

m = width / 2; a = m - web / 2; b = m + web / 2;
Point(1)  = {0, 0, 0, size};                    Point(2)  = {width, 0, 0, size};
Point(3)  = {width, flange, 0, size};           Point(4)  = {b + radius, flange, 0, size};
Point(5)  = {b, flange + radius, 0, size};      Point(6)  = {b, height - flange - radius, 0, size};
Point(7)  = {b + radius, height - flange, 0, size};
Point(8)  = {width, height - flange, 0, size};  Point(9)  = {width, height, 0, size};
Point(10) = {0, height, 0, size};               Point(11) = {0, height - flange, 0, size};
Point(12) = {a - radius, height - flange, 0, size};
Point(13) = {a, height - flange - radius, 0, size};
Point(14) = {a, flange + radius, 0, size};      Point(15) = {a - radius, flange, 0, size};
Point(16) = {0, flange, 0, size};
// Centers of the rounded corners.
Point(21) = {b + radius, flange + radius, 0};
Point(22) = {b + radius, height - flange - radius, 0};
Point(23) = {a - radius, height - flange - radius, 0};
Point(24) = {a - radius, flange + radius, 0};

Line(1) = {1, 2};     Line(2) = {2, 3};     Line(3) = {3, 4};
Circle(4) = {4, 21, 5};
Line(5) = {5, 6};
Circle(6) = {6, 22, 7};
Line(7) = {7, 8};     Line(8) = {8, 9};     Line(9) = {9, 10};
Line(10) = {10, 11};  Line(11) = {11, 12};
Circle(12) = {12, 23, 13};
Line(13) = {13, 14};
Circle(14) = {14, 24, 15};
Line(15) = {15, 16};  Line(16) = {16, 1};
Curve Loop(1) = {1:16};
Plane Surface(1) = {1};

Recombine Surface {1};
Mesh.Algorithm = 6;
Mesh.RecombinationAlgorithm = 3;       // quadrilaterals alone

Physical Surface("carbon") = {1};
Physical Curve("bottom") = {1};
Physical Curve("top")    = {9};
