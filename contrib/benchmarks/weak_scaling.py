# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Rate problems that grow with the number of processes, and how they would go on.

Part of contrib/scaling, which has the problems and measures them.
"""

from benchmarks import scaling_model
from common import page

# Coarse cells of a block, refinements, and processes that share both blocks: about
# 3.3e5 unknowns each.
SEQUENCE = [
    ("7, 7, 2", 3, 1),
    ("10, 10, 2", 3, 2),
    ("7, 7, 1", 4, 4),
    ("7, 7, 2", 4, 8),
    ("14, 7, 2", 4, 16),
]

# Processes of the model, and unknowns of each.
PREDICTED = (16, 128, 1024)
UNKNOWNS_EACH = 1e6


def table(rows):
    """The measured sequence, and beside its messages those that the model counts with
    costs from it."""
    costs = scaling_model.fit(rows, rows[:2])
    first = float(rows[0]["largest_MiB"])
    cells = []
    for row in rows:
        n_unknowns, n_processes = float(row["unknowns"]), int(row["processes"])
        cycles = float(row["cycles"])
        model = (
            costs.messages * scaling_model.count_neighbours(n_unknowns, n_processes),
            costs.bytes * scaling_model.count_border_nodes(n_unknowns, n_processes),
        )
        cells.append([
            n_processes,
            page.thousands(n_unknowns),
            page.thousands(row["fault_nodes"]),
            row["tnnmg_iterations"],
            row["equilibrium_iterations"],
            f"{float(row['meshes_MiB']):.0f}",
            f"{float(row['largest_MiB']):.0f}",
            f"{float(row['largest_MiB']) / first:.2f}",
            f"{float(row['messages']) / cycles:.0f}",
            f"{model[0]:.0f}",
            f"{float(row['message_bytes']) / cycles / 1e3:.0f}",
            f"{model[1] / 1e3:.0f}",
        ])
    titles = [
        "processes", "unknowns", "fault nodes", "TNNMG iterations", "CG at the start",
        "MiB of a process, meshes made", "at most", "over that of one",
        "messages of a cycle", "counted by the model", "kB of a cycle",
        "counted by the model",
    ]
    return page.table(titles, cells)


def prediction(counted, timed, network=scaling_model.Network()):
    """The table of times on many processes. The costs are fitted to rows with counts of
    messages, and to two with times."""
    costs = scaling_model.fit(counted, timed)
    cells = []
    for n_processes in PREDICTED:
        n_unknowns = n_processes * UNKNOWNS_EACH
        times = scaling_model.iteration_times(n_unknowns, n_processes, costs, network)
        whole = sum(times.values())
        hidden = times["messages"] + times["bytes"]
        cells.append([
            f"{n_processes:,}",
            f"{n_unknowns:.1e}",
            *(f"{1e3 * time:.1f}" for time in times.values()),
            f"{1e3 * whole:.0f}",
            f"{times['unknowns'] / whole:.0%}",
            f"{hidden / whole:.0%}",
        ])
    titles = [
        "processes", "unknowns", "own unknowns, ms", "coarsest level", "messages",
        "bytes", "sums", "faults", "an iteration, ms", "own unknowns",
        "at most hidden",
    ]
    return (
        f"Fitted: {costs.messages:.1f} messages of a cycle for each neighbour and level, "
        f"{costs.bytes:.0f} bytes for each node at a border, "
        f"{1e6 * costs.time_of_unknown:.2f} microseconds of an iteration for each "
        f"unknown of a process, {1e3 * costs.time_of_coarsest:.0f} ms for the coarsest "
        "level.\n\n" + page.table(titles, cells)
    )
