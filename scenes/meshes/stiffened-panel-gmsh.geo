// Stiffened panel: a skin on two blades that share its nodes, in millimetres; all cells are quadrangles.
//   gmsh -2 stiffened-panel-gmsh.geo -o stiffened-panel-gmsh.msh
long = 600; high = -40;
cells = 24;   // along
rib = 4;      // down a blade
y[] = {0, 100, 300, 400};
across[] = {4, 8, 4};

For k In {0:3}
  Point(2 * k + 1) = {0, y[k], 0};
  Point(2 * k + 2) = {long, y[k], 0};
  Line(k + 1) = {2 * k + 1, 2 * k + 2};
  Transfinite Curve {k + 1} = cells + 1;
EndFor

For k In {0:2}                            // three bays of skin
  Line(10 + k) = {2 * k + 1, 2 * k + 3};  // edge at x = 0
  Line(20 + k) = {2 * k + 2, 2 * k + 4};  // edge at x = long
  Transfinite Curve {10 + k, 20 + k} = across[k] + 1;
  Curve Loop(k + 1) = {k + 1, 20 + k, -(k + 2), -(10 + k)};
  Plane Surface(k + 1) = {k + 1};
EndFor

For k In {1:2}                            // two blades
  Point(10 + 2 * k) = {0, y[k], high};
  Point(11 + 2 * k) = {long, y[k], high};
  Line(30 + k) = {10 + 2 * k, 11 + 2 * k};
  Line(40 + k) = {2 * k + 1, 10 + 2 * k};
  Line(50 + k) = {2 * k + 2, 11 + 2 * k};
  Transfinite Curve {30 + k} = cells + 1;
  Transfinite Curve {40 + k, 50 + k} = rib + 1;
  Curve Loop(10 + k) = {k + 1, 50 + k, -(30 + k), -(40 + k)};
  Plane Surface(10 + k) = {10 + k};
EndFor

Transfinite Surface {1, 2, 3, 11, 12};
Recombine Surface {1, 2, 3, 11, 12};

Physical Surface("skin") = {1, 2, 3};
Physical Surface("blades") = {11, 12};
Physical Curve("sides") = {1, 4};
Physical Curve("root") = {10, 11, 12, 41, 42};       // all that ends at x = 0
Physical Curve("pushed") = {20, 21, 22, 51, 52};     // all that ends at x = long
Physical Curve("skin-ends") = {10, 11, 12, 20, 21, 22};
