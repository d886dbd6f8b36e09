// SPDX-License-Identifier: LGPL-2.1-or-later
// A rib of a floor: a concrete slab, 80 mm thick and 800 mm wide, on a timber beam of
// 160 x 280 mm, with a haunch of concrete between them. In mm:
//   gmsh -2 floor.geo -o floor.msh
//
// x of this drawing is the beam's x (across), y is its z (up). (0, 0) lies in the
// middle of the timber's underside. All is divided at x = 0, so that the two halves
// of the deck are boundaries of their own.

// Points, from left to right: below and above the timber, below and above the slab.
Point(1)  = {-80, 0, 0};    Point(2)  = {0, 0, 0};     Point(3)  = {80, 0, 0};
Point(4)  = {-80, 280, 0};  Point(5)  = {0, 280, 0};   Point(6)  = {80, 280, 0};
Point(7)  = {-400, 330, 0}; Point(8)  = {-150, 330, 0}; Point(9) = {0, 330, 0};
Point(10) = {150, 330, 0};  Point(11) = {400, 330, 0};
Point(12) = {-400, 410, 0}; Point(13) = {-150, 410, 0}; Point(14) = {0, 410, 0};
Point(15) = {150, 410, 0};  Point(16) = {400, 410, 0};

// Level lines, bottom to top, each from left to right; then upright ones.
Line(1) = {1, 2};  Line(2) = {2, 3};
Line(3) = {4, 5};  Line(4) = {5, 6};
Line(5) = {7, 8};  Line(6) = {8, 9};  Line(7) = {9, 10};  Line(8) = {10, 11};
Line(9) = {12, 13};  Line(10) = {13, 14};  Line(11) = {14, 15};  Line(12) = {15, 16};
Line(13) = {1, 4};  Line(14) = {2, 5};  Line(15) = {3, 6};
Line(16) = {4, 8};  Line(17) = {5, 9};  Line(18) = {6, 10};
Line(19) = {7, 12};  Line(20) = {8, 13};  Line(21) = {9, 14};  Line(22) = {10, 15};
Line(23) = {11, 16};

// Eight blocks with four sides each: timber, haunch, slab. A side between two blocks
// is one line that both use; two lines at one place would be a crack.
Curve Loop(1) = {1, 14, -3, -13};    Curve Loop(2) = {2, 15, -4, -14};
Curve Loop(3) = {3, 17, -6, -16};    Curve Loop(4) = {4, 18, -7, -17};
Curve Loop(5) = {5, 20, -9, -19};    Curve Loop(6) = {6, 21, -10, -20};
Curve Loop(7) = {7, 22, -11, -21};   Curve Loop(8) = {8, 23, -12, -22};
For block In {1:8}
  Plane Surface(block) = {block};
EndFor

// Cells: two across each half of the timber, three in the wings of the slab; upwards
// four in the timber, two in the haunch and two in the slab. Transfinite and
// recombined, a block is a grid of quadrilaterals.
Transfinite Curve {1:4, 6, 7, 10, 11} = 2 + 1;
Transfinite Curve {5, 8, 9, 12} = 3 + 1;
Transfinite Curve {13:15} = 4 + 1;
Transfinite Curve {16:23} = 2 + 1;
Transfinite Surface {1:8};
Recombine Surface {1:8};

// Of what the parts are made: materials of the scene.
Physical Surface("timber")   = {1, 2};
Physical Surface("concrete") = {3:8};

// Boundaries for supports and loads. What has no name is called `other`.
Physical Curve("left")   = {9, 10};    // the deck left of x = 0
Physical Curve("right")  = {11, 12};   // and right of it
Physical Curve("soffit") = {1, 2};
