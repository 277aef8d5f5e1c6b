// Mould of small-block.geo for "Mould/mesh file": bottom and four walls with
// normals out of the metal, into the rubber; a physical group per smooth
// patch. Lengths in mm.
// gmsh -2 -format msh41 small-mould.geo
L = 6; H = 4; a = L / 2; b = a + H * Tan(3 * Pi / 180);
n = 5;

Point(1) = {-a, -a, 0}; Point(2) = {a, -a, 0};
Point(3) = {a, a, 0};   Point(4) = {-a, a, 0};
Point(5) = {-b, -b, H}; Point(6) = {b, -b, H};
Point(7) = {b, b, H};   Point(8) = {-b, b, H};

Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Line(9) = {1, 5}; Line(10) = {2, 6}; Line(11) = {3, 7}; Line(12) = {4, 8};
Transfinite Curve{1:8} = n + 1;
Transfinite Curve{9:12} = n;

Curve Loop(1) = {1, 2, 3, 4};     Plane Surface(1) = {1};
Curve Loop(3) = {9, 5, -10, -1};  Plane Surface(3) = {3};
Curve Loop(4) = {10, 6, -11, -2}; Plane Surface(4) = {4};
Curve Loop(5) = {11, 7, -12, -3}; Plane Surface(5) = {5};
Curve Loop(6) = {12, 8, -9, -4};  Plane Surface(6) = {6};
Transfinite Surface{1, 3:6}; Recombine Surface{1, 3:6};

Physical Surface("bottom", 1)     = {1};
Physical Surface("wall front", 2) = {3};
Physical Surface("wall right", 3) = {4};
Physical Surface("wall back", 4)  = {5};
Physical Surface("wall left", 5)  = {6};
