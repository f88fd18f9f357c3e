# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""What scenes have in common whose bodies come from mesh files made here, held below and
pushed on top."""

END = """  subsection {top}
    set x condition = traction
    set x value     = 28e3
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Initial step = 1e-3
end
subsection Output
  set Event start slip rate = 1e-4
end
subsection TNNMG
  set Tolerance        = 1e-8
  set Smoothing sweeps = {sweeps}
end
"""


def mesh_text(groups, nodes, elements):
    """A mesh in the format of Gmsh: groups of (dimension, name), coordinates of the nodes
    as text, in the order of their numbers, and elements of (kind, group, *nodes)."""
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", len(groups)]
    text += [f'{dimension} {k + 1} "{name}"' for k, (dimension, name) in enumerate(groups)]
    text += ["$EndPhysicalNames", "$Nodes", len(nodes)]
    text += [f"{k + 1} {place}" for k, place in enumerate(nodes)]
    text += ["$EndNodes", "$Elements", len(elements)]
    text += [" ".join(map(str, (k + 1, kind, 2, group, 1, *corners)))
             for k, (kind, group, *corners) in enumerate(elements)]
    return "\n".join(map(str, text + ["$EndElements", ""]))
