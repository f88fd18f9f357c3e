// Two blocks with a fault between them that dips by 60 degrees: hexahedra.
d = 1 / Tan(Pi / 3);
Point(1) = {-2, 0, -1}; Point(2) = {d, 0, -1};  Point(3) = {2, 0, -1};
Point(4) = {-2, 0, 1};  Point(5) = {-d, 0, 1};  Point(6) = {2, 0, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {4, 5}; Line(4) = {5, 6};
Line(5) = {1, 4}; Line(6) = {2, 5}; Line(7) = {3, 6};
Curve Loop(1) = {1, 6, -3, -5}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 7, -4, -6}; Plane Surface(2) = {2};
Transfinite Curve{1:4} = 4;
Transfinite Curve{5:7} = 3;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
west[] = Extrude{0, 1, 0} { Surface{1}; Layers{2}; Recombine; };
east[] = Extrude{0, 1, 0} { Surface{2}; Layers{2}; Recombine; };
Physical Volume("footwall") = {west[1]};
Physical Volume("hanging_wall") = {east[1]};
// Sides of extruded surfaces: those of the lines of the loop in turn.
Physical Surface("fault") = {west[3]};
Physical Surface("bottom") = {west[2], east[2]};
Physical Surface("top") = {west[4], east[4]};
Physical Surface("west") = {west[5]};
Physical Surface("east") = {east[3]};
Physical Surface("south") = {1, 2};
Physical Surface("north") = {west[0], east[0]};
