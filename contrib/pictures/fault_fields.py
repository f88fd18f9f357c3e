# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The fields along one fault over time, from faults.h5."""

import h5py
import numpy as np

from .run_error import RunError
from .unfolding import unfolded


class FaultFields:
    """The fields of one fault, at its nodes in contact in the order of the way along
    it; in three dimensions at all nodes."""

    def __init__(self, path, name):
        if not path.is_file():
            raise RunError(f"There is no file {path}.")
        self.path, self.name = path, name
        with h5py.File(path, "r") as file:
            if name not in file:
                raise RunError(f"{path} holds no fault {name}.")
            group = file[name]
            if "slip_rate" not in group:
                raise RunError(
                    f"{path} holds no slip_rate; 'Output/Fault fields' must list it."
                )
            self.points = np.array(group["coordinates"])
            weight = np.array(group["weight"]).ravel()
            self.time = np.array(group["time"]).ravel()
            self.time = self.time[: len(group["slip_rate"])]
            self.fields = [field for field in group
                           if len(group[field].shape) > 0
                           and group[field].shape[0] >= len(self.time)]
            self.is_plane = self.points.shape[1] == 2
            self.is_level = (np.ptp(self.points[:, -1])
                             <= 1e-9 * np.ptp(self.points[:, 0]))
            if self.is_plane:
                # Files of earlier versions have no ways along faults.
                has_way = not self.is_level and "arc_length" in group
                self.along = (np.array(group["arc_length"]) if has_way
                              else self.points[:, 0])
                self.label = "position along the fault" if has_way else "x"
                order = np.argsort(self.along, kind="stable")
                self.nodes = order[weight[order] > 0]
                self.along = self.along[self.nodes]
            else:
                self.nodes = np.arange(len(self.points))
                self.faces = np.array(group["faces"])
                self.map = unfolded(self.points, self.faces, np.array(group["axes"]))
                self.labels = (("x", "y") if self.is_level
                               else ("along strike", "down dip"))
                # A long fault has its maps below each other.
                self.is_long = np.ptp(self.map[:, 0]) > 1.5 * np.ptp(self.map[:, 1])

    def has(self, field):
        return field in self.fields

    def field(self, name, records=slice(None)):
        """Records x nodes; in three dimensions of vectors x components."""
        with h5py.File(self.path, "r") as file:
            values = np.array(file[self.name][name])[: len(self.time)]
        return values[records][:, self.nodes]

    def size(self, name, records=slice(None)):
        """Magnitudes, records x nodes."""
        values = np.abs(self.field(name, records))
        return values if values.ndim == 2 else np.linalg.norm(values, axis=2)

    def first_component(self, name, records=slice(None)):
        values = self.field(name, records)
        return values if values.ndim == 2 else values[..., 0]

    def ends_of(self, window):
        """Numbers of the records at both ends of a window of time."""
        first, last = np.searchsorted(self.time, window)
        last = min(last, len(self.time) - 1)
        return max(min(first, last) - 1, 0), last

    def within(self, window):
        """The records within a window of time."""
        return np.flatnonzero((self.time >= window[0]) & (self.time <= window[1]))

    def rupture_times(self, event):
        """When each node first is faster than the event's threshold within its window,
        s, interpolated in the logarithm of the slip rate; nan where it never is."""
        records = self.within(event.window)
        if len(records) == 0:
            return np.full(len(self.nodes), np.nan)
        rate = np.maximum(self.size("slip_rate", records), 1e-300)
        fast = rate > event.threshold
        first = fast.argmax(axis=0)
        time = self.time[records]
        result = np.where(fast.any(axis=0), time[first], np.nan)
        for node in np.flatnonzero(fast.any(axis=0) & (first > 0)):
            k = first[node]
            before, after = np.log(rate[k - 1 : k + 1, node])
            part = (np.log(event.threshold) - before) / (after - before)
            result[node] = time[k - 1] + part * (time[k] - time[k - 1])
        return result

    def at_times(self, name, times):
        """First components at times between the records, times x nodes."""
        values = self.first_component(name)
        last = np.clip(np.searchsorted(self.time, times), 1, len(self.time) - 1)
        span = self.time[last] - self.time[last - 1]
        part = np.clip((times - self.time[last - 1]) / span, 0, 1)[:, None]
        return (1 - part) * values[last - 1] + part * values[last]

    def triangles(self):
        """Those that the faces are made of, without faces across periodic ends."""
        extent = np.ptp(self.map, axis=0)
        result = []
        for face in self.faces:
            face = face[face >= 0]
            if (np.ptp(self.map[face], axis=0) > 0.6 * extent).any() and len(
                    self.faces) > 8:
                continue
            result.append(face[:3])
            if len(face) == 4:
                result.append(face[[0, 2, 3]])
        return np.array(result)
