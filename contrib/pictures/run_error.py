# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors


class RunError(Exception):
    """A file of the run is missing or is not what it should be."""
