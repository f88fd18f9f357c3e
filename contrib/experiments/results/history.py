# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Fields along a fault of a plane scene over time, from faults.h5."""

import h5py
import numpy as np

FIELDS = ("slip", "slip_rate", "shear_traction", "normal_stress", "state")


class FaultHistory:
    """Nodes in contact sorted by x; fields are (records x nodes), in SI units."""

    def __init__(self, path, fault):
        self.path, self.fault = path, fault
        with h5py.File(path, "r") as file:
            group = file[fault]
            x = np.array(group["coordinates"])[:, 0]
            weight = np.array(group["weight"]).ravel()
            self.time = np.array(group["time"]).ravel()
        order = np.argsort(x, kind="stable")
        self.nodes = order[weight[order] > 0]
        self.x, self.weight = x[self.nodes], weight[self.nodes]
        self.fields = {}

    def field(self, name):
        if name not in self.fields:
            with h5py.File(self.path, "r") as file:
                values = np.array(file[self.fault][name])
            values = values.reshape(len(values), -1)[: len(self.time), self.nodes]
            self.fields[name] = values
        return self.fields[name]

    def rate(self):
        """Slip rates without their sign."""
        return np.abs(self.field("slip_rate"))

    def mean(self, values):
        """Over the fault, for each record."""
        return values @ self.weight / self.weight.sum()

    def node(self, x):
        """Index of the node next to a position."""
        return int(np.argmin(np.abs(self.x - x)))
