// A square of side 2 with a slit of length 1 in its middle: triangles.
h = 0.25;
Point(1) = {-1, -1, 0, h}; Point(2) = {1, -1, 0, h};
Point(3) = {1, 1, 0, h};   Point(4) = {-1, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Point(5) = {-0.5, 0, 0, h}; Point(6) = {0.5, 0, 0, h};
Line(5) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve{5} In Surface{1};
Physical Surface("block") = {1};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Curve("slit") = {5};
