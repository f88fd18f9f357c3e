#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that contrib/plot and contrib/compare draw runs in the program's formats.

Usage: check_plots.py CONTRIB [OUTPUT_DIRECTORY]

Writes the files of a made-up run, with periodic events that start in the
middle of the fault, and has them drawn; likewise a run without events, one of a
level fault as older files have it, one of a ring, several faults in one figure,
faults that open, and faults in three dimensions. Pages must hold all figures and ask
for nothing else; the front of the rupture, slip at equal times and what steps are
counted by are those of the made-up run; ways along strike and down dip are compared
with those on a cylinder. A missing file must give one sentence and status 1. With
OUTPUT_DIRECTORY the made-up runs are kept there.
"""

import base64
import io
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py
import matplotlib.image
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "contrib"))

from pictures import run_files, steps, style, unfolding

FAULT = "fault"
PERIOD, FIRST = 1.5, 21.0
SERIES = (
    "step,time,step_size,rate_state_iterations,tnnmg_iterations,"
    "multigrid_cycles"
)
FAULT_SERIES = (
    "max_slip_rate", "mean_slip_rate", "min_slip_rate", "mean_slip",
    "mean_state", "mean_shear_traction",
)
EVENTS = (
    "fault,start,peak_time,end,peak_mean_slip_rate,peak_slip_rate,mean_slip,"
    "nucleation_x,moment,peak_moment_rate,stress_drop,ruptured_area"
)
ENERGY = ("time,kinetic,elastic,driven_sides,loads,friction,viscosity,radiation,contact,"
          "mappings,missing")


def slip_rate(t, x):
    """Growth to both sides from the middle, once in every period."""
    background = 1e-12 * np.exp(np.minimum(t, FIRST)[:, None] + 0 * x)
    since = (t - FIRST) % PERIOD
    since[t < FIRST] = -1.0
    distance = since[:, None] - np.abs(x) / 25.0
    return background + 2e-2 * np.exp(-((distance - 0.02) / 0.01) ** 2)


def gap(t, x):
    """A blister that grows from the middle and closes again, twice."""
    height = np.maximum(0, np.sin(2 * np.pi * t / 20.0)) ** 2
    return 1e-4 * np.maximum(0, height[:, None] - (x / 1.5) ** 2)


def curve(shape, x):
    """Positions, axes and ways along a fault in two dimensions, by x."""
    if shape == "ring":
        radius = 5.0 / (2 * np.pi)
        angle = x / radius
        points = radius * np.stack((np.sin(angle), np.cos(angle)), axis=1)
        tangents = np.stack((np.cos(angle), -np.sin(angle)), axis=1)
    else:
        points, tangents = np.stack((x, 0 * x), axis=1), np.tile([1.0, 0.0], (len(x), 1))
    normals = np.stack((-tangents[:, 1], tangents[:, 0]), axis=1)
    return points, np.stack((tangents, normals), axis=1), x - x[0]


def surface(dip, x):
    """Nodes, faces and axes of a fault in space of two rows of squares, whose normal
    is inclined by an angle."""
    y = np.linspace(0.0, 1.0, 3)
    u, v = np.meshgrid(x, y)
    points = np.stack(
        (u.ravel(), np.cos(dip) * v.ravel(), np.sin(dip) * v.ravel()), axis=1)
    axes = np.array([[1.0, 0, 0], [0, np.cos(dip), np.sin(dip)],
                     [0, -np.sin(dip), np.cos(dip)]])
    n = len(x)
    faces = [[row * n + i, row * n + i + 1, (row + 1) * n + i + 1, (row + 1) * n + i]
             for row in range(2) for i in range(n - 1)]
    return points, np.array(faces), np.tile(axes, (len(points), 1, 1))


def write_openings(directory, names):
    with open(directory / "openings.csv", "w", encoding="utf-8") as file:
        file.write("fault,opens,peak_time,closes,largest_gap,largest_open_area,"
                   "begins_x,widest_x\n")
        for name in names:
            file.write(f"{name},0,5,10,1e-4,3,0,0\n{name},20,25,nan,1e-4,3,0,0\n")


def write_run(directory, with_events=True, dim=2, shape="level", n_faults=1, dip=0.0,
              opens=False):
    x = np.linspace(-2.5, 2.5, 41)
    t = np.concatenate((
        np.linspace(0.0, FIRST, 100, endpoint=False),
        np.arange(FIRST, 30.0 if with_events else FIRST + 1e-9, 5e-3),
    ))
    rate = slip_rate(t, x)
    if dim == 3:
        points, faces, axes = surface(dip, x)
        rate = np.concatenate((rate, 0.5 * rate, 0.25 * rate), axis=1)
    else:
        points, axes, along = curve(shape, x)
        faces = np.stack((np.arange(40), np.arange(1, 41)), axis=1)
    weight = np.full(len(points), 5.0 / len(points))
    names = [FAULT] + [f"{FAULT}{k}" for k in range(2, n_faults + 1)]

    values = np.stack((
        rate.max(axis=1), rate.mean(axis=1), rate.min(axis=1), 2e-4 * t,
        1.0 + 0 * t, 2.5e4 + 0 * t,
    ), axis=1)
    columns = FAULT_SERIES
    if opens:
        gaps = gap(t, points[:, 0])
        values = np.column_stack((values, gaps.max(axis=1), (gaps > 0) @ weight))
        columns += ("largest_gap", "open_area")
        write_openings(directory, names)
    with open(directory / "time_series.csv", "w", encoding="utf-8") as file:
        columns = [f"{fault}.{name}" for fault in names for name in columns]
        file.write(",".join([SERIES] + columns) + "\n")
        for i, row in enumerate(values):
            step = t[i] - t[i - 1] if i else 1e-3
            file.write(f"{i},{t[i]:.17g},{step:.17g},{2 + i % 3},{4 + i % 5},{12 + i % 9},")
            file.write(",".join(f"{v:.17g}" for v in list(row) * n_faults) + "\n")
    with open(directory / "events.csv", "w", encoding="utf-8") as file:
        file.write(EVENTS + "\n")
        for start in np.arange(FIRST, 30.0 - 0.2, PERIOD) if with_events else ():
            file.write(f"{FAULT},{start},{start + 0.05},{start + 0.13},5e-3,2e-2,"
                       "3e-4,0,2e10,4e11,1e5,5\n")
    with open(directory / "energy.csv", "w", encoding="utf-8") as file:
        file.write(ENERGY + "\n")
        for time in t:
            file.write(f"{time:.17g},0,{time * time},{2 * time * time},0,{time * time},"
                       "0,0,0,0,1e-9\n")
    (directory / "summary.txt").write_text("Run\n  program  stickslip <&> 1\n")
    (directory / "parameters.prm").write_text(
        f"subsection Time\n  set End time = {t[-1]}\nend\n")

    vectors = np.zeros(rate.shape + ((dim - 1,) if dim == 3 else ()))
    if dim == 3:
        vectors[..., 0] = rate
    else:
        vectors[...] = rate
    with h5py.File(directory / "faults.h5", "w") as file:
        for name in names:
            group = file.create_group(name)
            group["coordinates"], group["weight"], group["time"] = points, weight, t
            group["slip_rate"] = vectors
            group["slip"] = np.cumsum(1e-3 * vectors, axis=0)
            group["shear_traction"] = 1e3 * vectors
            group["state"] = np.ones(rate.shape)
            group["normal_stress"] = np.full(rate.shape, 4.9e4)
            if opens:
                group["gap"] = gaps
            if shape == "old":
                continue
            group["faces"], group["axes"] = faces, axes
            if dim == 2:
                group["arc_length"] = along


def run_script(script, *arguments):
    return subprocess.run([script, *map(str, arguments)], capture_output=True, text=True)


def check_page(path, n_pictures, texts):
    """A page with that many pictures in it, and nothing from elsewhere."""
    page = path.read_text(encoding="utf-8")
    pictures = re.findall(r'src="data:image/png;base64,([^"]+)"', page)
    if len(pictures) < n_pictures:
        yield f"{path.name} has {len(pictures)} pictures, not {n_pictures}"
    for picture in pictures:
        image = matplotlib.image.imread(io.BytesIO(base64.b64decode(picture)))[..., :3]
        if np.ptp(image) < 0.5:
            yield f"{path.name} has an empty picture"
    for other in re.findall(r'(?:src|href|url)[=(]"?(?!data:|#)([^")]+)', page):
        yield f"{path.name} asks for {other}"
    for text in texts:
        if text not in page:
            yield f"{path.name} does not hold {text!r}"


def check_numbers(folder):
    """Front, slip at equal times and counts of the made-up run in the plane."""
    run = run_files.Run(folder)
    fields, event = run.fields(FAULT), run.event(FAULT, 2)
    # Slip rates are 0.02 exp(-((s - |x|/25 - 0.02) / 0.01)^2) at a time s.
    event.threshold = 2e-2 * np.exp(-1)
    front = fields.rupture_times(event)
    x = fields.along[np.abs(fields.along) < 1.5]
    expected = FIRST + PERIOD + np.abs(x) / 25 + 0.01
    error = np.abs(front[np.abs(fields.along) < 1.5] - expected).max()
    if error > 3e-3:
        yield f"the rupture front is off by {error} s"
    times = np.array([21.5, 25.0])
    slip = fields.at_times("slip", times)
    nearest = [np.abs(fields.time - time).argmin() for time in times]
    if np.abs(slip - fields.field("slip")[nearest]).max() > 1e-4:
        yield "slip at equal times is not that of the records"
    middle, least, mean, largest = steps.in_parts(
        np.array([0.0, 0.1, 0.2, 299.0, 300.0]), np.array([3, 1, 5, 7, 9]))
    if not (np.array_equal(least, [1, 7]) and np.array_equal(largest, [5, 9])
            and np.allclose(mean, [3, 8])):
        yield f"counts of steps are {least}, {mean}, {largest}"
    for size, unit, expected in (
            (3e9, "Pa", "3 GPa"), (2.5e7, "Pa", "25 MPa"), (2e4, "m", "20 km"),
            (2.5, "m", "2.5 m"), (3e-3, "m", "3 mm"), (2e-5, "J", "20 µJ"), (0, "m", "0 m")):
        factor, name = style.scaled(size, unit)
        if f"{factor * size:.6g} {name}" != expected:
            yield f"{size} {unit} are {factor * size:.6g} {name}"
    if style.rate_limits([np.array([0, 1e-20, 3e-2])]) != (1e-13, 0.1):
        yield f"limits are {style.rate_limits([np.array([0, 1e-20, 3e-2])])}"


def check_unfolding():
    """Ways on a quarter of a cylinder whose axis is inclined in its plane, of triangles
    and squares; what is wrong with them."""
    radius, n, m = 3.0, 41, 11
    angle, z = np.meshgrid(np.linspace(0.3, 0.3 + np.pi / 2, n),
                           np.linspace(-2.0, 0.0, m))
    angle, z = angle.ravel(), z.ravel()
    out = np.stack((np.cos(angle), np.sin(angle), 0 * z), axis=1)
    points = radius * out + np.stack((0 * z, 0 * z, z), axis=1)
    strike = np.stack((-np.sin(angle), np.cos(angle), 0 * z), axis=1)
    axes = np.stack((strike, np.tile([0, 0, 1.0], (len(z), 1)), out), axis=1)
    faces = []
    for row in range(m - 1):
        for i in range(n - 1):
            a, b, c, d = (row * n + i, row * n + i + 1, (row + 1) * n + i + 1,
                          (row + 1) * n + i)
            faces += [[a, b, c, d]] if i % 2 else [[a, b, c, -1], [a, c, d, -1]]
    ways = unfolding.unfolded(points, np.array(faces), axes)
    along = radius * (angle - 0.3)
    for found, expected, what in ((ways[:, 0], along, "strike"),
                                  (ways[:, 1], -z, "dip")):
        # Chords are shorter than arcs by this much.
        error = min(np.abs(found - expected).max(),
                    np.abs(found - expected.max() + expected).max())
        if error > 1e-3 * radius:
            return f"ways along {what} on a cylinder are off by {error} m"
    return None


def check(contrib, directory, **options):
    """Draw one made-up run; yield what is wrong with the figures."""
    write_run(directory, **options)
    run = run_script(contrib / "plot", directory, "--fault", "all")
    if run.returncode != 0 or run.stderr:
        yield f"{options}: status {run.returncode}: {run.stderr}"
        return
    image = matplotlib.image.imread(directory / "run.png")[..., :3]
    if image.shape[0] < 1000 or image.shape[1] < 1000:
        yield f"{options}: the figure has only {image.shape[:2]} pixels"
    # The map of slip rates covers a part of the figure with colour.
    coloured = (image.max(axis=2) - image.min(axis=2) > 0.2).mean()
    if coloured < 0.05:
        yield f"{options}: only {coloured:.1%} of the figure is coloured"
    texts = ["stickslip &lt;&amp;&gt; 1", "End time"]
    if options.get("with_events", True):
        texts += ["stress drop", f"<td>{FAULT}</td>"]
    for problem in check_page(directory / "run.html", 5, texts):
        yield f"{options}: {problem}"


def check_comparison(contrib, one, other):
    page = one / "comparison of two.html"
    run = run_script(contrib / "compare", one, other, "-o", page)
    if run.returncode != 0 or run.stderr:
        yield f"compare: status {run.returncode}: {run.stderr}"
        return
    yield from check_page(page, 7, ["Time/End time", "start, B - A"])


def main():
    contrib = pathlib.Path(sys.argv[1]).resolve()
    errors = [check_unfolding()]
    with tempfile.TemporaryDirectory() as name:
        keep = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else name)
        folders = []
        for i, options in enumerate((
            {}, {"with_events": False, "shape": "old"}, {"shape": "ring", "n_faults": 2},
            {"dim": 3, "dip": 0.5, "opens": True}, {"dim": 3, "with_events": False},
            {"opens": True},
        )):
            folders.append(keep / f"a run {i}")
            folders[-1].mkdir(parents=True, exist_ok=True)
            errors += check(contrib, folders[-1], **options)
        errors += check_numbers(folders[0])
        errors += check_comparison(contrib, folders[0], folders[1])
        if len(sys.argv) <= 2:
            with h5py.File(folders[0] / "faults.h5", "a") as file:
                del file[FAULT]["slip_rate"]
            for what in ("slip rates", "faults.h5"):
                for script, arguments in (("plot", folders[:1]),
                                          ("compare", folders[:2])):
                    run = run_script(contrib / script, *arguments, "-o",
                                     keep / "none.html")
                    if run.returncode != 1 or len(run.stderr.splitlines()) != 1:
                        errors.append(
                            f"{script} without {what}: {run.returncode}: {run.stderr}")
                (folders[0] / "faults.h5").unlink(missing_ok=True)
    errors = [error for error in errors if error]
    print("\n".join(errors) or "All figures drawn.")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
