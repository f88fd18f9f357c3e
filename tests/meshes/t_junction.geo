// Three blocks: a fault through the whole width that bends, and one that ends
// at it from above: quadrilaterals.
Point(1) = {-2, -1, 0};  Point(2) = {0.2, -1, 0}; Point(3) = {2, -1, 0};
Point(4) = {-2, 0, 0};   Point(5) = {0, 0.1, 0};  Point(6) = {2, 0, 0};
Point(7) = {-2, 1, 0};   Point(8) = {0.5, 1, 0};  Point(9) = {2, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3};
Line(3) = {4, 5}; Line(4) = {5, 6};
Line(5) = {7, 8}; Line(6) = {8, 9};
Line(7) = {1, 4}; Line(8) = {2, 5}; Line(9) = {3, 6};
Line(10) = {4, 7}; Line(11) = {5, 8}; Line(12) = {6, 9};
Curve Loop(1) = {1, 8, -3, -7};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -4, -8};  Plane Surface(2) = {2};
Curve Loop(3) = {3, 11, -5, -10}; Plane Surface(3) = {3};
Curve Loop(4) = {4, 12, -6, -11}; Plane Surface(4) = {4};
Transfinite Curve{1:6} = 5;
Transfinite Curve{7:12} = 4;
Transfinite Surface{1:4};
Recombine Surface{1:4};
Physical Surface("base") = {1, 2};
Physical Surface("west") = {3};
Physical Surface("east") = {4};
Physical Curve("main") = {3, 4};
Physical Curve("branch") = {11};
Physical Curve("bottom") = {1, 2};
Physical Curve("top") = {5, 6};
Physical Curve("left") = {7, 10};
Physical Curve("right") = {9, 12};
