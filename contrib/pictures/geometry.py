# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The bodies of a scene and its faults."""

import h5py
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from common.vtu_file import names_in, sections

from .style import BLACK, COLOURS, VERMILION, panels, scaled, title

# Triangles of VTK, and quadrilaterals, by the number of their corners.
SHAPES = {5: 3, 9: 4}


def cells_of_bodies(path):
    """Corners of all cells of a plane scene, the number of the body of each, and the
    names of the bodies; None where the file does not have them."""
    arrays, names = sections(path), names_in(path)
    cells, body = arrays["Cells"], arrays["CellData"].get("body")
    if body is None or not names or not set(cells["types"]) <= set(SHAPES):
        return None
    points = arrays["Points"]["Points"][:, :2]
    corners = np.split(cells["connectivity"], cells["offsets"][:-1])
    return [points[corner] for corner in corners], body.astype(int), names


def faces_of_faults(path):
    """The corners of the faces of each fault."""
    result = {}
    with h5py.File(path, "r") as file:
        for name, group in file.items():
            if "faces" not in group:
                continue
            points = np.array(group["coordinates"])
            faces = [points[face[face >= 0]] for face in np.array(group["faces"])]
            # Faces across periodic ends are no faces of the picture.
            size = np.linalg.norm(np.ptp(points, axis=0))
            result[name] = [face for face in faces
                            if len(faces) < 8
                            or np.linalg.norm(np.ptp(face, axis=0)) < 0.5 * size]
    return result


def draw_plane(run, faults):
    factor, unit = 1.0, "m"
    figure, ((axis,),) = panels([3.2])
    volumes = [run.folder / f"solution_00000.{ending}" for ending in ("vtu", "pvtu")]
    bodies = next((cells_of_bodies(v) for v in volumes if v.is_file()), None)
    every = np.concatenate([np.concatenate(faces) for faces in faults.values()])
    if bodies:
        every = np.concatenate(bodies[0])
    factor, unit = scaled(np.ptp(every, axis=0).max(), "m")
    if bodies:
        cells, body, names = bodies
        for number, name in enumerate(names):
            own = [factor * cell for cell, b in zip(cells, body) if b == number]
            colour = COLOURS[(number + 1) % len(COLOURS)]
            axis.add_collection(PolyCollection(
                own, facecolors=colour, edgecolors="white", alpha=0.45,
                linewidths=0.2 if len(cells) > 400 else 0.5))
            axis.plot([], [], "s", color=colour, alpha=0.6, label=name)
    for number, (name, faces) in enumerate(faults.items()):
        axis.add_collection(LineCollection(
            [factor * face for face in faces], linewidths=2,
            colors=(VERMILION, BLACK)[number % 2]))
        axis.plot([], [], color=(VERMILION, BLACK)[number % 2], linewidth=2, label=name)
    low, high = factor * every.min(axis=0), factor * every.max(axis=0)
    margin = 0.03 * (high - low).max()
    axis.set(xlim=(low[0] - margin, high[0] + margin),
             ylim=(low[1] - margin, high[1] + margin), aspect="equal",
             xlabel=f"x [{unit}]", ylabel=f"y [{unit}]")
    axis.legend(loc="upper left", bbox_to_anchor=(1.01, 1))
    title(axis, "Bodies and faults at the start")
    return figure


def draw_space(faults):
    figure, _ = panels([4.0])
    figure.clear()
    axis = figure.add_subplot(projection="3d")
    every = np.concatenate([np.concatenate(faces) for faces in faults.values()])
    factor, unit = scaled(np.ptp(every, axis=0).max(), "m")
    for number, (name, faces) in enumerate(faults.items()):
        colour = COLOURS[number % len(COLOURS)]
        axis.add_collection3d(Poly3DCollection(
            [factor * face for face in faces], facecolors=colour, edgecolors="white",
            linewidths=0.3, alpha=0.8))
        axis.plot([], [], [], "s", color=colour, label=name)
    low, high = factor * every.min(axis=0), factor * every.max(axis=0)
    high = np.maximum(high, low + 0.05 * (high - low).max())
    axis.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]),
             xlabel=f"x [{unit}]", ylabel=f"y [{unit}]", zlabel=f"z [{unit}]")
    axis.set_box_aspect(high - low)
    for number, one in enumerate((axis.xaxis, axis.yaxis, axis.zaxis)):
        # Short edges have room for a few numbers only.
        part = (high - low)[number] / (high - low).max()
        one.set_major_locator(MaxNLocator(max(1, int(6 * part))))
    axis.legend(loc="upper left")
    title(axis, "Faults at the start")
    return figure


def draw(run):
    """A figure of the scene, or None where files do not have it."""
    faults = faces_of_faults(run.folder / "faults.h5")
    if not faults:
        return None
    if len(next(iter(faults.values()))[0][0]) == 2:
        return draw_plane(run, faults)
    return draw_space(faults)
