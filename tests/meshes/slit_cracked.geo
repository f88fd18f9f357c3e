// The square of slit.geo, whose nodes on the slit Gmsh has doubled.
Merge "slit.geo";
Mesh 2;
Plugin(Crack).Dimension = 1;
Plugin(Crack).PhysicalGroup = 6;
Plugin(Crack).Run;
