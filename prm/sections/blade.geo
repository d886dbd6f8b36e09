// SPDX-License-Identifier: LGPL-2.1-or-later
// Section of a rotor blade: a thick airfoil (NACA 4-digit, 30 %) with a blunt trailing
// edge and a web, from plies in the planes of the walls, in mm:
//   gmsh -2 blade.geo -o blade.msh
//
// x is along the chord, from the leading to the trailing edge; (0, 0) is on the chord at
// 30 % of its length. Cells are straight-sided, one per ply.

chord = 200;
plies() = {0, 1, 2, 4};                    // depth of the ply interfaces below the surface
// Stations x / chord of one side; the web of two plies is between the third and the fifth.
s() = {0.8, 0.6, 0.415, 0.4, 0.385, 0.27, 0.16, 0.07, 0.02};
m = #s[];
n = 2 * m + 1;                             // points of a contour: both sides, and the nose

// Contour: upper side towards the nose, nose, lower side towards the trailing edge.
For i In {0 : n - 1}
  t = 0;
  If (i != m)
    t = s[i < m ? i : n - 1 - i];
  EndIf
  y = 1.5 * (0.2969 * Sqrt(t) - 0.126 * t - 0.3516 * t^2 + 0.2843 * t^3 - 0.1015 * t^4);
  X[i] = chord * (t - 0.3);
  Y[i] = i < m ? chord * y : -chord * y;
EndFor
// Parallel contours: point i is at the distance d of both edges that meet there.
For i In {0 : n - 1}
  a = (i + n - 1) % n;  b = (i + 1) % n;
  la = Hypot(X[i] - X[a], Y[i] - Y[a]);  lb = Hypot(X[b] - X[i], Y[b] - Y[i]);
  ax = -(Y[i] - Y[a]) / la;  ay = (X[i] - X[a]) / la;    // inward normals
  bx = -(Y[b] - Y[i]) / lb;  by = (X[b] - X[i]) / lb;
  For j In {0 : 3}
    d = plies[j] / (1 + ax * bx + ay * by);
    Point(1 + i + 100 * j) = {X[i] + d * (ax + bx), Y[i] + d * (ay + by), 0};
  EndFor
EndFor
For i In {0 : n - 1}
  For j In {0 : 3}
    Line(1 + i + 100 * j) = {1 + i + 100 * j, 1 + (i + 1) % n + 100 * j};
    If (j > 0)
      Line(1001 + i + 100 * j) = {1 + i + 100 * (j - 1), 1 + i + 100 * j};
    EndIf
  EndFor
EndFor
For i In {0 : n - 1}
  For j In {1 : 3}
    Curve Loop(1 + i + 100 * j) = {1 + i + 100 * j, -(1001 + (i + 1) % n + 100 * j),
                                   -(1 + i + 100 * (j - 1)), 1001 + i + 100 * j};
    Plane Surface(1 + i + 100 * j) = {1 + i + 100 * j};
  EndFor
EndFor
// The web, between the inner contours of both sides.
For i In {2 : 4}
  Line(2001 + i) = {301 + i, 301 + n - 1 - i};
EndFor
For i In {2 : 3}
  Curve Loop(2001 + i) = {2001 + i, -(301 + n - 2 - i), -(2002 + i), -(301 + i)};
  Plane Surface(2001 + i) = {2001 + i};
EndFor

Transfinite Curve {:} = 2;
Transfinite Curve {2003 : 2005} = 4;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("plus45")   = {101 : 100 + n};
Physical Surface("minus45")  = {201 : 200 + n};
Physical Surface("along")    = {301 : 300 + n};
Physical Surface("aft_web")  = {2003};
Physical Surface("fore_web") = {2004};
Physical Curve("outside")    = {1 : n};
