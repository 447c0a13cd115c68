// A pipe with a round hole in its wall, a quarter of it. Lengths in mm; the axis of the pipe is y, the hole looks up.
// Mesh it with Gmsh 4.15: gmsh -2 -format msh41 pipe.geo
SetFactory("OpenCASCADE");
size = DefineNumber[22];          // of a cell far from the hole
Point(1) = {0, 0, 100, size};
Point(2) = {0, 0, 0, size};
Point(3) = {100, 0, 0, size};
Point(4) = {0, 0, -100, size};
Circle(1) = {1, 2, 3};
Circle(2) = {3, 2, 4};
Extrude {0, 300, 0} { Curve{1, 2}; }
wall[] = Surface{:};
Cylinder(1000) = {0, 0, 0, 0, 0, 200, 25};
BooleanDifference{ Surface{wall[]}; Delete; }{ Volume{1000}; Delete; }
e = 1e-3;
Physical Surface("wall") = Surface{:};
rim[] = Curve In BoundingBox {-e, -e, 90, 25 + e, 25 + e, 100 + e};
Physical Curve("rim") = {rim[]};
Physical Curve("end") = Curve In BoundingBox {-e, 300 - e, -100 - e, 100 + e, 300 + e, 100 + e};
Physical Curve("middle") = Curve In BoundingBox {-e, -e, -100 - e, 100 + e, e, 100 + e};
Physical Curve("plane") = Curve In BoundingBox {-e, -e, -100 - e, e, 300 + e, 100 + e};
// Cells grow from a quarter of the size at the rim to the size 120 mm away.
Field[1] = Distance;
Field[1].CurvesList = {rim[]};
Field[1].Sampling = 200;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = size / 4;
Field[2].SizeMax = size;
Field[2].DistMin = 0;
Field[2].DistMax = 150;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromCurvature = 0;
Mesh.Algorithm = 6;
