"""Tables and drawings for notebooks."""

from __future__ import annotations

from base64 import b64encode
from html import escape
from typing import Any


def table(head: list[str], rows: list[list[Any]]) -> str:
    """A table with a head."""
    top = "".join(f"<th>{escape(text)}</th>" for text in head)
    body = "".join(f"<tr>{''.join(f'<td>{escape(_text(cell))}</td>' for cell in row)}</tr>" for row in rows)
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _text(cell: Any) -> str:
    if cell is None:
        return ""
    return f"{cell:.8g}" if isinstance(cell, float) else str(cell)


def drawing(text: str) -> str:
    """A drawing made of letters."""
    return f'<pre style="line-height: 1.2">{escape(text)}</pre>'


def solution(found: Any) -> str:
    """Contacts of a solution with errors, the approach, warnings, and the picture."""
    rows = [
        [c.interface, c.reach, c.half_length_error, c.central_pressure, c.central_pressure_error, c.resultant]
        for c in found.contacts
    ]
    head = ["contact", "half-length", "± ", "pressure at x = 0", "± ", "resultant"]
    text = table(head, rows)
    if found.approach is not None:
        stiffness = "" if found.stiffness is None else f", stiffness {found.stiffness:.8g}"
        text += f"<p>force {found.force:.8g}, approach {found.approach:.8g}{stiffness}</p>"
    notes = "".join(f"<li>{escape(message)}</li>" for _, message in found.warnings)
    text += f"<ul>{notes}</ul>" if notes else ""
    # as an image, so that names within one picture do not meet the names of another
    picture = b64encode(found.svg().encode()).decode()
    return text + f'<img alt="{escape(repr(found))}" src="data:image/svg+xml;base64,{picture}">'
