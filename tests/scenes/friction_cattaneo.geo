// SPDX-License-Identifier: LGPL-2.1-or-later
// A body with a round top of radius 8, 64 high, for two that are pressed together and pushed. Cells are
// finest where what sticks and what touches end, x = 0.083 and 0.13, and as low as wide there:
// gmsh -2 -setnumber fine 2 friction_cattaneo.geo -o friction_cattaneo.msh
DefineConstant[fine = {1, Name "fine"}];
R = 8; base = -56; far = 64; flank = 1;
layers = 48 + 4 * Log(fine) / Log(2);
x[]     = {-far, -flank, -0.14, -0.12, -0.093, -0.073, 0.073, 0.093, 0.12, 0.14, flank, far};
cells[] = {10, 15, 13 * fine, 3 * fine, 13 * fine, 12 * fine, 13 * fine, 3 * fine, 13 * fine, 15, 10};
ratio[] = {1 / 1.4, 1 / 1.2, 1, 1, 1, 1, 1, 1, 1, 1.2, 1.4};
center = newp; Point(center) = {0, 0, 0};
For k In {0 : #x[] - 1}
  // The arc, and its top's height less the flank's where it has no arc any more.
  z = Sqrt(R^2 - Min(x[k]^2, flank^2)) - (Abs(x[k]) > flank ? flank : 0);
  top[k]  = newp; Point(top[k])  = {x[k], z, 0};
  foot[k] = newp; Point(foot[k]) = {x[k], base, 0};
  down[k] = newl; Line(down[k])  = {top[k], foot[k]};
  Transfinite Curve {down[k]} = layers + 1 Using Progression 1.2;
EndFor
For k In {0 : #x[] - 2}
  above[k] = newl;
  If (k == 0 || k == #x[] - 2)
    Line(above[k]) = {top[k], top[k + 1]};
  Else
    Circle(above[k]) = {top[k], center, top[k + 1]};
  EndIf
  below[k] = newl; Line(below[k]) = {foot[k], foot[k + 1]};
  Transfinite Curve {above[k], below[k]} = cells[k] + 1 Using Progression ratio[k];
  loop = newll; Curve Loop(loop) = {above[k], down[k + 1], -below[k], -down[k]};
  part[k] = news; Plane Surface(part[k]) = {loop};
  Transfinite Surface {part[k]};
  Recombine Surface {part[k]};
EndFor
Physical Surface("solid") = {part[]};
Physical Curve("arc")     = {above[1], above[2], above[3], above[4], above[5], above[6], above[7],
                             above[8], above[9]};
Physical Curve("flat")    = {below[]};
