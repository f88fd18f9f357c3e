// A cube of side 2 with a square fault of side 1 in its middle: tetrahedra.
SetFactory("OpenCASCADE");
Box(1) = {-1, -1, -1, 2, 2, 2};
Rectangle(100) = {-0.5, -0.5, 0, 1, 1};
Surface{100} In Volume{1};
MeshSize{:} = 0.8;
MeshSize{PointsOf{Surface{100};}} = 0.3;
Physical Volume("block") = {1};
Physical Surface("patch") = {100};
Physical Surface("sides") = {1, 2, 3, 4};
Physical Surface("bottom") = {5};
Physical Surface("top") = {6};
