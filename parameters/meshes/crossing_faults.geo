// Two faults that cross at right angles in a square of 10 m: one of 5 m along
// y = x, one of 4 m along y = -x. Triangles of 0.2 m at the faults, of 1.5 m at
// the sides.
fine = 0.2;
coarse = 1.5;
a = 2.5 / Sqrt(2);
b = 2 / Sqrt(2);
Point(1) = {-5, -5, 0, coarse}; Point(2) = {5, -5, 0, coarse};
Point(3) = {5, 5, 0, coarse};   Point(4) = {-5, 5, 0, coarse};
Point(5) = {0, 0, 0, fine};
Point(6) = {-a, -a, 0, fine};   Point(7) = {a, a, 0, fine};
Point(8) = {-b, b, 0, fine};    Point(9) = {b, -b, 0, fine};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {6, 5}; Line(6) = {5, 7};
Line(7) = {8, 5}; Line(8) = {5, 9};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve{5:8} In Surface{1};
Physical Surface("block") = {1};
Physical Curve("rising") = {5, 6};
Physical Curve("falling") = {7, 8};
Physical Curve("sides") = {1:4};
