// A disc of radius 1 in a ring of outer radius 2: quadrilaterals.
h = 0.5;
Point(1) = {0, 0, 0, h};
For i In {0:3}
  Point(10 + i) = {Cos(i * Pi / 2), Sin(i * Pi / 2), 0, h};
  Point(20 + i) = {2 * Cos(i * Pi / 2), 2 * Sin(i * Pi / 2), 0, h};
  Point(30 + i) = {0.4 * Cos(i * Pi / 2), 0.4 * Sin(i * Pi / 2), 0, h};
EndFor
For i In {0:3}
  j = (i + 1) % 4;
  Circle(10 + i) = {10 + i, 1, 10 + j};
  Circle(20 + i) = {20 + i, 1, 20 + j};
  Line(30 + i) = {30 + i, 30 + j};
  Line(40 + i) = {10 + i, 20 + i};
  Line(50 + i) = {30 + i, 10 + i};
EndFor
For i In {0:3}
  j = (i + 1) % 4;
  Curve Loop(40 + i) = {10 + i, 40 + j, -(20 + i), -(40 + i)};
  Plane Surface(40 + i) = {40 + i};
  Curve Loop(50 + i) = {30 + i, 50 + j, -(10 + i), -(50 + i)};
  Plane Surface(50 + i) = {50 + i};
EndFor
Curve Loop(60) = {30, 31, 32, 33};
Plane Surface(60) = {60};
Transfinite Curve{10:13, 20:23, 30:33} = 5;
Transfinite Curve{40:43, 50:53} = 3;
Transfinite Surface{40:43, 50:53, 60};
Recombine Surface{40:43, 50:53, 60};
Physical Surface("ring") = {40:43};
Physical Surface("disc") = {50:53, 60};
Physical Curve("fault") = {10:13};
Physical Curve("outside") = {20:23};
