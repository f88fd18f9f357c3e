# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The speed of the kernels, and what changes of the operator cost."""

from common import page, programs

from . import measuring
from .scenes import MESHES, STATES, UNIFORM, Mesh

# The rows of matrices of meshes of cells of one size.
KERNELS = {dim: Mesh("kernel", UNIFORM, {}, "", int(dim), 1) for dim in "23"}


class Kernels:
    SECTION = "kernels"

    @staticmethod
    def measure(quick, log):
        rows = {"native": measuring.run("kernel_speed", [], 120)}
        if not quick:
            rows["portable"] = measuring.run("kernel_speed_portable", [], 120)
        log("kernels measured")
        records = [
            measuring.make_record(
                Kernels.SECTION,
                KERNELS[row["dim"]],
                "",
                "",
                f"{row['kernel']}, {row['number']}",
                unknowns=row["unknowns"],
                solve_s=float(row["ns_per_unknown"]) * float(row["unknowns"]) * 1e-9,
                bytes_per_unknown=row["bytes_per_unknown"],
                note=build,
            )
            for build, measured in rows.items()
            for row in measured
            if row["dim"] != "0"
        ]
        return records, rows

    @staticmethod
    def text(_, measured):
        native = measured["native"]
        portable = {
            (row["kernel"], row["dim"], row["number"]): row
            for row in measured.get("portable", ())
        }
        bandwidth = {row["kernel"]: row for row in native if row["dim"] == "0"}
        rows = []
        for row in native:
            if row["dim"] == "0":
                continue
            other = portable.get((row["kernel"], row["dim"], row["number"]))
            rows.append(
                (
                    row["dim"],
                    page.thousands(row["unknowns"]),
                    row["kernel"],
                    row["number"],
                    page.number(row["bytes_per_unknown"], 3),
                    page.number(row["ns_per_unknown"], 3),
                    f"{float(row['percent_of_bound']):.0f} %",
                    page.number(other["ns_per_unknown"], 3) if other else "–",
                )
            )
        return (
            f"Triad {page.number(bandwidth['triad']['GB_per_s'], 3)} GB/s, reading "
            f"alone {page.number(bandwidth['read']['GB_per_s'], 3)} GB/s. With d "
            "components a node, e blocks in a row and numbers of s bytes, a "
            "product moves e (d² s + 4) + 4 + 2 d s bytes for a node; what a write "
            "reads first does not count, as in the triad. The bound is these bytes "
            "over the triad's bandwidth.\n\n"
            + page.table(
                (
                    "dimension",
                    "unknowns",
                    "kernel",
                    "numbers",
                    "bytes an unknown",
                    "ns an unknown",
                    "of the bound",
                    "ns without STICKSLIP_NATIVE",
                ),
                rows,
            )
        )


class Costs:
    SECTION = "costs"

    @staticmethod
    def measure(quick, log):
        names = ["uniform-1e5", "graded-1e5"]
        if not quick:
            names += ["blocks-1e5", "uniform-1e6", "graded-1e6"]
        rows = []
        for name in names:
            try:
                (row,) = measuring.rate_rows(
                    MESHES[name],
                    {"nucleating": STATES["nucleating"]},
                    ["1e-3"],
                    ["--costs"],
                )
                rows.append({"problem": name} | row)
            except programs.Failed as reason:
                log(f"{name}: {reason}")
        log("costs measured")
        records = [
            measuring.make_record(
                Costs.SECTION,
                MESHES[row["problem"]],
                "",
                row["tau"],
                what,
                unknowns=row["unknowns"],
                setup_s=row["assembly_s"],
                solve_s=row[f"{part}_s"],
                bytes_per_unknown=row["bytes_per_unknown"],
            )
            for row in rows
            for what, part in (
                ("V-cycle", "v_cycle"),
                ("new step size", "new_tau"),
                ("new curvature", "new_hessian"),
                ("new truncation", "new_truncation"),
                ("truncation at 1 %", "moved_front"),
                ("new contact mapping", "contact"),
            )
        ]
        return records, rows

    @staticmethod
    def text(_, rows):
        def with_ratio(row, part, unit):
            return (
                f"{page.number(row[part + '_s'])} s "
                f"({page.number(row[part + '_' + unit])})"
            )

        return "In brackets V-cycles, for the contact mapping assemblies:\n\n" + page.table(
            (
                "mesh",
                "unknowns",
                "fault nodes",
                "levels",
                "meshes, s",
                "assembly, s",
                "V-cycle, s",
                "new step size",
                "new curvature of friction",
                "new truncation everywhere",
                "at 1 % of the fault nodes",
                "new contact mapping",
                "memory of the meshes, MiB",
                "of all, MiB",
            ),
            [
                (
                    MESHES[row["problem"]].description,
                    page.thousands(row["unknowns"]),
                    page.thousands(row["fault_nodes"]),
                    row["levels"],
                    page.number(row["meshes_s"]),
                    page.number(row["assembly_s"]),
                    page.number(row["v_cycle_s"]),
                    with_ratio(row, "new_tau", "cycles"),
                    with_ratio(row, "new_hessian", "cycles"),
                    with_ratio(row, "new_truncation", "cycles"),
                    with_ratio(row, "moved_front", "cycles"),
                    with_ratio(row, "contact", "assemblies"),
                    page.number(
                        float(row["meshes_MiB"]) - float(row["start_MiB"]), 3
                    ),
                    page.number(row["largest_MiB"], 4),
                )
                for row in rows
            ],
        )
