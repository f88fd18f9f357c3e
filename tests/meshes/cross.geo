// Two faults that cross in one body with four names of quarters, triangles.
h = 0.4;
Point(1) = {-1, -1, 0, h}; Point(2) = {0, -1, 0, h}; Point(3) = {1, -1, 0, h};
Point(4) = {-1, 0, 0, h};  Point(5) = {0, 0, 0, h};  Point(6) = {1, 0, 0, h};
Point(7) = {-1, 1, 0, h};  Point(8) = {0, 1, 0, h};  Point(9) = {1, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3};
Line(3) = {4, 5}; Line(4) = {5, 6};
Line(5) = {7, 8}; Line(6) = {8, 9};
Line(7) = {1, 4}; Line(8) = {2, 5}; Line(9) = {3, 6};
Line(10) = {4, 7}; Line(11) = {5, 8}; Line(12) = {6, 9};
Curve Loop(1) = {1, 8, -3, -7};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -4, -8};  Plane Surface(2) = {2};
Curve Loop(3) = {3, 11, -5, -10}; Plane Surface(3) = {3};
Curve Loop(4) = {4, 12, -6, -11}; Plane Surface(4) = {4};
Physical Surface("south") = {1, 2};
Physical Surface("north") = {3, 4};
Physical Curve("level") = {3, 4};
Physical Curve("upright") = {8, 11};
Physical Curve("outside") = {1, 2, 5, 6, 7, 9, 10, 12};
