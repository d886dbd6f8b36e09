// SPDX-License-Identifier: LGPL-2.1-or-later
// A sandwich 40 mm wide and 12 mm high, whose carbon skins, 2 mm thick, close the
// foam core at the right; its left side is open:
// gmsh -2 sandwich.geo -o sandwich.msh
//
// Physical surfaces say of what the parts are made (skin and core, which the
// scene's Parts maps to materials and angles), physical curves name the boundary.

width = 40; height = 12; skin = 2;
xs[] = {0, width - skin, width};
zs[] = {0, skin, height - skin, height};
columns[] = {10, 2};                   // cells of each column and row
rows[]    = {2, 4, 2};

For j In {0:3}
  For i In {0:2}
    Point(1 + i + 3 * j) = {xs[i], zs[j], 0};
  EndFor
EndFor
For j In {0:3}
  For i In {0:1}
    Line(1 + i + 2 * j) = {1 + i + 3 * j, 2 + i + 3 * j};     // 1 to 8, level
    Transfinite Curve {1 + i + 2 * j} = columns[i] + 1;
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    Line(11 + i + 3 * j) = {1 + i + 3 * j, 4 + i + 3 * j};    // 11 to 19, upright
    Transfinite Curve {11 + i + 3 * j} = rows[j] + 1;
  EndFor
EndFor
For j In {0:2}
  For i In {0:1}
    s = 1 + i + 2 * j;
    Curve Loop(s) = {s, 12 + i + 3 * j, -(s + 2), -(11 + i + 3 * j)};
    Plane Surface(s) = {s};
  EndFor
EndFor
Transfinite Surface {1:6};
Recombine Surface {1:6};

Physical Surface("skin") = {1, 2, 4, 5, 6};
Physical Surface("core") = {3};
Physical Curve("bottom") = {1, 2};
Physical Curve("top")    = {7, 8};
Physical Curve("left")   = {11, 14, 17};
Physical Curve("right")  = {13, 16, 19};
