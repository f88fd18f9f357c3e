// A square of 80 km with a fault of 2 km in its middle: triangles, lengths in
// km. gmsh -2 -format msh41 crack.geo -o crack.msh
a = 1;      // half the length of the fault
h = a / 40; // cells on it
R = 40 * a;
Point(1) = {-R, -R, 0}; Point(2) = {R, -R, 0};
Point(3) = {R, R, 0};   Point(4) = {-R, R, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Point(5) = {-a, 0, 0}; Point(6) = {a, 0, 0};
Line(5) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve{5} In Surface{1};
// Cells grow with the distance from the fault.
Field[1] = Distance;
Field[1].CurvesList = {5};
Field[1].NumPointsPerCurve = 200;
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.2 * F1", h);
Background Field = 2;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Physical Surface("rock") = {1};
Physical Curve("sides") = {1, 2, 3, 4};
Physical Curve("fault") = {5};
