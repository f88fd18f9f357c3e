#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Print a rough profile as an expression for the entry Elevation of a fault.

Usage: rough_profile.py [--ratio R] [--length L] [--waves N] [--seed S]

The profile repeats after L and is self-similar: its waves L/n, n = 1 to N, have
amplitudes proportional to their lengths and random phases, and the root of its mean
square is R L (as of natural faults with R from 1e-3 to 1e-2; Power and Tullis 1991,
Dunham et al. 2011).
"""

import argparse
import math
import random


def waves(length, count, seed):
    """Wave number in 1/m, amplitude in m for a ratio of one, and phase of each."""
    generator = random.Random(seed)
    scale = length * math.sqrt(2 / sum(1 / n**2 for n in range(1, count + 1)))
    return [
        (2 * math.pi * n / length, scale / n, 2 * math.pi * generator.random())
        for n in range(1, count + 1)
    ]


def expression(ratio, length, count, seed):
    terms = (
        f"{amplitude:.4f} * sin({2 * n}/{length:g} * pi * x + {phase:.3f})"
        for n, (_, amplitude, phase) in enumerate(waves(length, count, seed), 1)
    )
    return f"{ratio:g} * (" + " + ".join(terms) + ")"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ratio", type=float, default=1e-3)
    parser.add_argument("--length", type=float, default=4.0)
    parser.add_argument("--waves", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    print(expression(
        arguments.ratio, arguments.length, arguments.waves, arguments.seed))


if __name__ == "__main__":
    main()
