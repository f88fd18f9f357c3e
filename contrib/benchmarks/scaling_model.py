# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""A model of an iteration of the rate problem in three dimensions on many processes.

What a process computes and sends is fitted to runs on up to 16 processes; what a
network makes of that is assumed.
"""

import dataclasses
import math

# Nodes of a level that a process has at least, else fewer processes share it, and
# nodes of the coarsest level, which belongs to one process.
LEAST_NODES = 500
COARSEST_NODES = 2000
# Time of the update of the state, s, and bytes of a tangential jump, for each fault
# node: every process has all of them.
FAULT_NODE_TIME = 4e-8
FAULT_NODE_BYTES = 16


@dataclasses.dataclass(frozen=True)
class Network:
    """Time of a message, s, and bytes a second of a process while all of them send."""

    latency: float = 2e-6
    bandwidth: float = 0.4e9


@dataclasses.dataclass(frozen=True)
class Costs:
    """What an iteration takes of a process: messages of a cycle for each level and
    neighbour, bytes of a cycle for each node at a border, s for each of its unknowns
    and for the coarsest level."""

    messages: float
    bytes: float
    time_of_unknown: float
    time_of_coarsest: float
    cycles: float = 1.5
    sums: float = 4


def shared_levels(n_unknowns, n_processes):
    """Nodes and processes of each level but the coarsest, the finest first."""
    n_nodes = n_unknowns / 3
    while n_nodes > COARSEST_NODES:
        yield n_nodes, min(n_processes, max(1, math.floor(n_nodes / LEAST_NODES)))
        n_nodes /= 8


def neighbours(n_processes):
    """Of a process in the middle, if the parts are cubes."""
    return min(n_processes ** (1 / 3), 3) ** 3 - 1


def border_nodes(n_nodes, n_processes):
    """Nodes of a part at those of others, if the parts are cubes."""
    inner_faces = 6 * (1 - n_processes ** (-1 / 3))
    return inner_faces * (n_nodes / n_processes) ** (2 / 3)


def count_neighbours(n_unknowns, n_processes):
    """Neighbours of a process, added up over the levels."""
    return sum(neighbours(p) for _, p in shared_levels(n_unknowns, n_processes))


def count_border_nodes(n_unknowns, n_processes):
    """Nodes at the border of a process, added up over the levels."""
    levels = shared_levels(n_unknowns, n_processes)
    return sum(border_nodes(n, p) for n, p in levels)


def most_of_a_cycle(rows, column, count):
    """The most that any row of rate_problem has in a column, of a cycle and for each of
    what is counted."""
    return max(
        float(row[column]) / float(row["cycles"])
        / count(float(row["unknowns"]), int(row["processes"]))
        for row in rows if int(row["processes"]) > 1
    )


def fit_messages(rows):
    """Messages for each level and neighbour, and bytes for each node at a border."""
    return (
        most_of_a_cycle(rows, "messages", count_neighbours),
        most_of_a_cycle(rows, "message_bytes", count_border_nodes),
    )


def fit(counted, timed):
    """Costs from rows of rate_problem: messages from the first, and times from the
    straight line through two more, on the same coarse cells."""
    messages, sent = fit_messages(counted)
    (small, time_of_small), (large, time_of_large) = [
        (float(row["unknowns"]) / float(row["processes"]),
         float(row["solve_s"]) / float(row["tnnmg_iterations"]))
        for row in timed
    ]
    slope = (time_of_large - time_of_small) / (large - small)
    return Costs(
        messages=messages,
        bytes=sent,
        time_of_unknown=slope,
        time_of_coarsest=max(0.0, time_of_small - slope * small),
    )


def fault_nodes(n_unknowns):
    """Between two blocks that are five times as long and wide as thick."""
    return (5 * n_unknowns / 6) ** (2 / 3)


def iteration_times(n_unknowns, n_processes, costs, network):
    """Parts of the time of an iteration, s."""
    at_faults = fault_nodes(n_unknowns)
    messages = costs.messages * count_neighbours(n_unknowns, n_processes)
    sent = costs.bytes * count_border_nodes(n_unknowns, n_processes)
    steps_of_sum = 2 * math.log2(n_processes)
    return {
        "own": costs.time_of_unknown * n_unknowns / n_processes,
        "coarsest": costs.time_of_coarsest,
        "messages": costs.cycles * messages * network.latency,
        "bytes": costs.cycles * sent / network.bandwidth,
        "sums": costs.sums * steps_of_sum * network.latency,
        "faults": FAULT_NODE_TIME * at_faults
        + 2 * FAULT_NODE_BYTES * at_faults / network.bandwidth,
    }
