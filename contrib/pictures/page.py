# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Pages in HTML that need nothing but themselves."""

import base64
import html

import numpy as np

STYLE = """
body { font: 15px/1.45 sans-serif; max-width: 1040px; margin: 1.5em auto; padding: 0 1em;
  color: #222; background: #fff; }
h1 { font-size: 1.6em; } h2 { font-size: 1.2em; border-bottom: 1px solid #ccc;
  padding-bottom: .2em; margin-top: 1.6em; }
img { max-width: 100%; height: auto; }
table { border-collapse: collapse; font-size: .85em; }
th, td { padding: .15em .7em; text-align: right; border-bottom: 1px solid #e4e4e4; }
th { background: #f4f4f4; position: sticky; top: 0; }
td:first-child, th:first-child { text-align: left; }
.scroll { max-height: 28em; overflow: auto; }
.pair { display: flex; gap: 1em; } .pair > * { flex: 1 1 0; min-width: 0; }
pre { background: #f7f7f7; padding: .8em; overflow: auto; font-size: .8em; }
nav a { margin-right: 1em; white-space: nowrap; }
td.differs { background: #fff0d8; }
"""


def escape(text):
    return html.escape(str(text))


def number(value):
    """A number in short, other things as they are."""
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    return str(value)


def image(bytes_of_png, title):
    code = base64.b64encode(bytes_of_png).decode()
    return f'<img alt="{escape(title)}" src="data:image/png;base64,{code}">'


def table(columns, rows, differs=lambda row, column: False):
    """Rows are lists; cells for which DIFFERS(row, column) are marked."""
    head = "".join(f"<th>{escape(column)}</th>" for column in columns)
    body = []
    for r, row in enumerate(rows):
        cells = "".join(
            f'<td{" class=differs" if differs(r, c) else ""}>{escape(number(value))}</td>'
            for c, value in enumerate(row))
        body.append(f"<tr>{cells}</tr>")
    return (f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>'
            + "\n".join(body) + "</tbody></table></div>")


def text(content):
    return f"<pre>{escape(content)}</pre>"


def folded(content, summary):
    return f"<details><summary>{escape(summary)}</summary>{content}</details>"


def pair(left, right):
    return f'<div class="pair"><div>{left}</div><div>{right}</div></div>'


def page(title, introduction, sections):
    """A page of SECTIONS, pairs of a title and HTML, with links to them on top."""
    links = "\n".join(f'<a href="#s{k}">{escape(name)}</a>'
                    for k, (name, _) in enumerate(sections))
    content = "\n".join(f'<h2 id="s{k}">{escape(name)}</h2>\n{body}'
                        for k, (name, body) in enumerate(sections))
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f"<title>{escape(title)}</title><style>{STYLE}</style></head>\n<body>"
            f"<h1>{escape(title)}</h1>\n<p>{escape(introduction)}</p>\n"
            f"<nav>{links}</nav>\n{content}\n</body></html>\n")
