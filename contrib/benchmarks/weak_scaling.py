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
    ("10, 10, 2", 4, 16),
]

# Processes of the model, and unknowns of each.
PREDICTED = (16, 128, 1024)
UNKNOWNS_EACH = 1e6


COLUMNS = [
    ("processes", "processes", "{:.0f}"),
    ("unknowns", "unknowns", "{:,.0f}"),
    ("fault_nodes", "fault nodes", "{:,.0f}"),
    ("tnnmg_iterations", "TNNMG iterations", "{:.0f}"),
    ("equilibrium_iterations", "CG at the start", "{:.0f}"),
    ("meshes_MiB", "MiB of a process, meshes made", "{:.0f}"),
    ("largest_MiB", "at most", "{:.0f}"),
    ("memory", "over that of one", "{:.2f}"),
    ("messages_of_cycle", "messages of a cycle", "{:.0f}"),
    ("messages_of_model", "counted by the model", "{:.0f}"),
    ("kB_of_cycle", "kB of a cycle", "{:.0f}"),
    ("kB_of_model", "counted by the model", "{:.0f}"),
]

PREDICTED_COLUMNS = [
    ("processes", "processes", "{:,.0f}"),
    ("unknowns", "unknowns", "{:.1e}"),
    ("own", "own unknowns, ms", "{:.1f}"),
    ("coarsest", "coarsest level", "{:.1f}"),
    ("messages", "messages", "{:.1f}"),
    ("bytes", "bytes", "{:.1f}"),
    ("sums", "sums", "{:.1f}"),
    ("faults", "faults", "{:.1f}"),
    ("all", "an iteration, ms", "{:.0f}"),
    ("part_of_own", "own unknowns", "{:.0%}"),
    ("part_of_messages", "at most hidden", "{:.0%}"),
]


def table(rows):
    """The measured sequence, and beside its messages those that the model counts with
    costs from it."""
    messages, sent = scaling_model.fit_messages(rows)
    cells = []
    for row in rows:
        size = float(row["unknowns"]), int(row["processes"])
        cycles = float(row["cycles"])
        cells.append(row | {
            "memory": float(row["largest_MiB"]) / float(rows[0]["largest_MiB"]),
            "messages_of_cycle": float(row["messages"]) / cycles,
            "messages_of_model": messages * scaling_model.count_neighbours(*size),
            "kB_of_cycle": float(row["message_bytes"]) / cycles / 1e3,
            "kB_of_model": sent * scaling_model.count_border_nodes(*size) / 1e3,
        })
    return page.table_of(COLUMNS, cells)


def prediction(counted, timed, network=scaling_model.Network()):
    """The table of times on many processes. The costs are fitted to rows with counts of
    messages, and to two with times."""
    costs = scaling_model.fit(counted, timed)
    cells = []
    for n_processes in PREDICTED:
        n_unknowns = n_processes * UNKNOWNS_EACH
        times = scaling_model.iteration_times(n_unknowns, n_processes, costs, network)
        whole = sum(times.values())
        cells.append({part: 1e3 * time for part, time in times.items()} | {
            "processes": n_processes,
            "unknowns": n_unknowns,
            "all": 1e3 * whole,
            "part_of_own": times["own"] / whole,
            "part_of_messages": (times["messages"] + times["bytes"]) / whole,
        })
    return (
        f"Fitted: {costs.messages:.1f} messages of a cycle for each neighbour and level, "
        f"{costs.bytes:.0f} bytes for each node at a border, "
        f"{1e6 * costs.time_of_unknown:.2f} microseconds of an iteration for each "
        f"unknown of a process, {1e3 * costs.time_of_coarsest:.0f} ms for the coarsest "
        "level.\n\n" + page.table_of(PREDICTED_COLUMNS, cells)
    )
