# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""How far two runs are apart."""

import numpy as np


def difference(result, reference, characteristic_slip):
    """The largest difference of slip, of gaps and of shear traction at the end, over
    the largest slip and gap, but at least the characteristic slip, and the largest
    traction; that of the logarithm of the state; the largest of them. The faults'
    nodes must be the same."""
    worst = 0.0
    for fault, mine in result.fields.items():
        other = reference.fields[fault]
        if abs(mine["time"] - other["time"]) > 1e-9 * abs(other["time"]):
            return float("nan")
        contact = (mine["weight"] > 0) & (other["weight"] > 0)
        for name, least in (("slip", characteristic_slip), ("shear_traction", 1e-30),
                            ("gap", characteristic_slip)):
            if name not in mine:
                continue
            scale = max(np.max(np.abs(other[name])), least)
            change = np.abs(mine[name] - other[name])[contact]
            worst = max(worst, np.max(change) / scale)
        change = np.abs(np.log(mine["state"]) - np.log(other["state"]))[contact]
        worst = max(worst, np.max(change) / max(1, np.max(np.abs(np.log(other["state"])))))
    return float(worst)


def slip_rate_range(result):
    """Least and largest slip rate of the last record."""
    rates = np.concatenate(
        [np.abs(f["slip_rate"])[f["weight"] > 0] for f in result.fields.values()]
    )
    return float(rates.min()), float(rates.max())
