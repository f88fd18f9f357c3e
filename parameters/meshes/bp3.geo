// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// Half-space with a fault that dips by 60 degrees to the right, in km; the
// surface is at y = 0. Quadrilaterals of 3.2 km at the upper 40 km of the fault.
//   gmsh -2 -format msh41 bp3.geo -o bp3.msh
near  = 3.2;
far   = 20;
width = 100;
depth = 100;
foot  = depth / Tan(Pi / 3);
// Lower end of the part that stays fine, 40 km down the dip.
end_x = 40 * Cos(Pi / 3);
end_y = -40 * Sin(Pi / 3);

Point(1) = {0, 0, 0, near};
Point(2) = {end_x, end_y, 0, near};
Point(3) = {foot, -depth, 0, far};
Point(4) = {-width, -depth, 0, far};
Point(5) = {-width, 0, 0, far};
Point(6) = {foot + width, -depth, 0, far};
Point(7) = {foot + width, 0, 0, far};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {3, 6};
Line(7) = {6, 7};
Line(8) = {7, 1};

Curve Loop(1) = {5, 1, 2, 3, 4};
Plane Surface(1) = {1};
Curve Loop(2) = {6, 7, 8, 1, 2};
Plane Surface(2) = {2};

Physical Surface("footwall")     = {1};
Physical Surface("hanging_wall") = {2};
Physical Curve("fault")   = {1, 2};
Physical Curve("surface") = {5, 8};
Physical Curve("far")     = {3, 4, 6, 7};

Mesh.Algorithm              = 6;
Mesh.RecombineAll           = 1;
Mesh.RecombinationAlgorithm = 3;
Mesh.Smoothing              = 10;
