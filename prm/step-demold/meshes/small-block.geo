// Small tread block for "Block/mesh file": tread surface 6 x 6 mm at z = 0,
// height 4 mm, draft 3 degree, no sipes, no base. Lengths in mm.
// gmsh -3 -format msh41 small-block.geo
L = 6; H = 4; a = L / 2; b = a + H * Tan(3 * Pi / 180);
nx = 6; nz = 5;

Point(1) = {-a, -a, 0}; Point(2) = {a, -a, 0};
Point(3) = {a, a, 0};   Point(4) = {-a, a, 0};
Point(5) = {-b, -b, H}; Point(6) = {b, -b, H};
Point(7) = {b, b, H};   Point(8) = {-b, b, H};

Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Line(9) = {1, 5}; Line(10) = {2, 6}; Line(11) = {3, 7}; Line(12) = {4, 8};
Transfinite Curve{1, 3, 5, 7} = nx + 1 Using Bump 0.5;
Transfinite Curve{2, 4, 6, 8} = nx + 1 Using Bump 0.5;
Transfinite Curve{9, 10, 11, 12} = nz + 1;

Curve Loop(1) = {1, 2, 3, 4};    Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8};    Plane Surface(2) = {2};
Curve Loop(3) = {1, 10, -5, -9}; Plane Surface(3) = {3};
Curve Loop(4) = {2, 11, -6, -10}; Plane Surface(4) = {4};
Curve Loop(5) = {3, 12, -7, -11}; Plane Surface(5) = {5};
Curve Loop(6) = {4, 9, -8, -12}; Plane Surface(6) = {6};
Surface Loop(1) = {1, 2, 3, 4, 5, 6}; Volume(1) = {1};
Transfinite Surface{1:6}; Recombine Surface{1:6}; Transfinite Volume{1};

// The numbers are those of the boundary names.
Physical Surface("bottom", 3)  = {1};
Physical Surface("backing", 7) = {2};
Physical Surface("wall", 8)    = {3, 4, 5, 6};
Physical Volume("rubber", 1)   = {1};
