// Bracket: a foot, an upright with a round hole and a flange, one sheet bent twice, in millimetres; all cells are quadrangles.
//   gmsh -2 flanged-bracket.geo -o flanged-bracket.msh
wide = 80; foot = 100; up = 120; flange = 30; hole = 20;
n = 12;   // cells across

Point(1) = {foot, 0, 0};      Point(2) = {foot, wide, 0};
Point(3) = {0, 0, 0};         Point(4) = {0, wide, 0};      // the first fold
Point(5) = {0, 0, wide};      Point(6) = {0, wide, wide};   // over the hole
Point(7) = {0, 0, up};        Point(8) = {0, wide, up};     // the second fold
Point(9) = {-flange, 0, up};  Point(10) = {-flange, wide, up};

For k In {0:4}                               // lines across, and what joins each to the next
  Line(k + 1) = {2 * k + 1, 2 * k + 2};
EndFor
For k In {0:3}
  Line(10 + k) = {2 * k + 1, 2 * k + 3};
  Line(20 + k) = {2 * k + 2, 2 * k + 4};
EndFor

h = hole * Sqrt(0.5);                        // where the diagonals meet the hole
Point(11) = {0, wide/2, wide/2};
Point(13) = {0, wide/2 - h, wide/2 - h};  Point(14) = {0, wide/2 + h, wide/2 - h};
Point(15) = {0, wide/2 - h, wide/2 + h};  Point(16) = {0, wide/2 + h, wide/2 + h};
Circle(31) = {13, 11, 14};  Circle(32) = {14, 11, 16};  Circle(33) = {16, 11, 15};  Circle(34) = {15, 11, 13};
Line(41) = {3, 13};  Line(42) = {4, 14};  Line(43) = {6, 16};  Line(44) = {5, 15};

Curve Loop(1) = {1, 20, -2, -10};    Plane Surface(1) = {1};   // foot
Curve Loop(2) = {2, 42, -31, -41};   Plane Surface(2) = {2};   // four blocks round the hole
Curve Loop(3) = {21, 43, -32, -42};  Plane Surface(3) = {3};
Curve Loop(4) = {-3, 44, -33, -43};  Plane Surface(4) = {4};
Curve Loop(5) = {-11, 41, -34, -44}; Plane Surface(5) = {5};
Curve Loop(6) = {3, 22, -4, -12};    Plane Surface(6) = {6};   // over the hole
Curve Loop(7) = {4, 23, -5, -13};    Plane Surface(7) = {7};   // flange

Transfinite Curve {1:5, 11, 21, 31:34} = n + 1;
Transfinite Curve {10, 20} = n * 5 / 4 + 1;
Transfinite Curve {41:44, 12, 22} = n / 2 + 1;
Transfinite Curve {13, 23} = n / 3 + 1;
Transfinite Surface {1:7};
Recombine Surface {1:7};

Physical Surface("foot") = {1};
Physical Surface("upright") = {2:6};
Physical Surface("flange") = {7};
Physical Curve("bolted") = {1};
