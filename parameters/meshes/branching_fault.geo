// A fault of 6 m along x in a block of 10 m x 8 m, and a branch of 3 m that
// leaves its middle at 30 degrees. Triangles of 0.2 m at the faults, of 1.5 m at
// the sides.
fine = 0.2;
coarse = 1.5;
length = 3;
Point(1) = {-5, -4, 0, coarse}; Point(2) = {5, -4, 0, coarse};
Point(3) = {5, 4, 0, coarse};   Point(4) = {-5, 4, 0, coarse};
Point(5) = {-3, 0, 0, fine};
Point(6) = {0, 0, 0, fine};
Point(7) = {3, 0, 0, fine};
Point(8) = {length * Cos(Pi / 6), length * Sin(Pi / 6), 0, fine};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7};
Line(7) = {6, 8};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve{5:7} In Surface{1};
Physical Surface("block") = {1};
Physical Curve("main") = {5, 6};
Physical Curve("branch") = {7};
Physical Curve("sides") = {1:4};
