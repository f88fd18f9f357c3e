// A box of 60 km x 40 km x 15 km with an upright fault through all of it whose
// trace bends by 4 km in the middle: tetrahedra, lengths in km.
// gmsh -3 -format msh41 curved_strike_slip.geo -o curved_strike_slip.msh
L = 30; W = 20; D = 15; // half the length, half the width, depth
n = 24;                 // points of the trace
For i In {0:n}
  x = -L + 2 * L * i / n;
  y = 2 * Tanh(x / 8);
  Point(1 + i) = {x, y, -D};
EndFor
Spline(1) = {1 : n + 1};
Point(101) = {-L, -W, -D}; Point(102) = {L, -W, -D};
Point(103) = {L, W, -D};   Point(104) = {-L, W, -D};
Line(2) = {101, 102}; Line(3) = {102, n + 1}; Line(4) = {1, 101};
Line(5) = {n + 1, 103}; Line(6) = {103, 104}; Line(7) = {104, 1};
Curve Loop(1) = {2, 3, -1, 4};
Curve Loop(2) = {1, 5, 6, 7};
Plane Surface(1) = {1}; // south
Plane Surface(2) = {2}; // north
south[] = Extrude {0, 0, D} { Surface{1}; };
north[] = Extrude {0, 0, D} { Surface{2}; };
// Cells grow with the distance from the fault.
Field[1] = Distance;
Field[1].SurfacesList = {south[4]};
Field[1].CurvesList = {1};
Field[1].NumPointsPerCurve = 100;
Field[2] = MathEval;
Field[2].F = "2.5 + 0.25 * abs(y - 2 * tanh(x / 8))";
Background Field = 2;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthFromPoints = 0;
Mesh.Optimize = 1;
Physical Volume("south") = {south[1]};
Physical Volume("north") = {north[1]};
Physical Surface("fault") = {south[4]};
Physical Surface("far") = {south[2], north[4]};
Physical Surface("ends") = {south[3], south[5], north[3], north[5]};
Physical Surface("top") = {south[0], north[0]};
Physical Surface("bottom") = {1, 2};
