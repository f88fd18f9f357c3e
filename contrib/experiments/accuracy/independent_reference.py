# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Event times of the independent computation, kept like those of the runs."""

import json

from . import independent

# Relative: ten thousand times finer than the shifts that are compared with it.
TOLERANCE = 1e-7
# s: after the first event, for a look.
QUICK_END, QUICK_TOLERANCE = 23.0, 1e-5


def events(case, store):
    """In the form of a run, as far as the case goes."""
    is_quick = case.end_time <= QUICK_END
    tolerance = QUICK_TOLERANCE if is_quick else TOLERANCE
    path = store.folder / f"independent_{case.end_time:g}_{tolerance:g}.json"
    if not path.is_file():
        starts = independent.event_starts(case.end_time, tolerance)
        path.write_text(json.dumps(starts.tolist()))
    return {"events": json.loads(path.read_text())}
