# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Tables and numbers in Markdown, and the sections of pages that scripts write."""


def marks(section, command):
    return f"<!-- {section}, by {command} -->", f"<!-- end of {section} -->"


def replace_section(section, text, page, command):
    """Put a text between the marks of a section."""
    begin, end = marks(section, command)
    before, rest = page.read_text(encoding="utf-8").split(begin)
    _, after = rest.split(end)
    page.write_text(
        f"{before}{begin}\n\n{text.strip()}\n\n{end}{after}", encoding="utf-8"
    )


def rounded(value):
    try:
        return f"{float(value):.6g}"
    except (TypeError, ValueError):
        return value


def table(titles, rows):
    """A table in Markdown."""
    lines = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def table_of(columns, rows):
    """A table of dictionaries; columns are a key, a title and a format for a number."""
    return table(
        [title for _, title, _ in columns],
        [[form.format(float(row[key])) for key, _, form in columns] for row in rows],
    )


def number(value, digits=2):
    """A number as it stands in a table, a dash if there is none."""
    try:
        value = float(value)
    except (TypeError, ValueError):
        return "–"
    if value == 0 or 1e-3 <= abs(value) < 1e5:
        size = f"{value:.{digits}g}" if abs(value) < 10**digits else f"{value:.0f}"
        return f"{float(size):g}" if "e" in size else size
    return f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e")


def thousands(value):
    return f"{int(float(value)):,}"
