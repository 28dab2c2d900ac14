"""Cells as spreadsheets write and read them: text with tabs, and tables of HTML. No Qt."""

from __future__ import annotations

import csv
import html
import io
from collections.abc import Sequence
from html.parser import HTMLParser


def to_text(rows: Sequence[Sequence[str]]) -> str:
    """One line a row, tabs between the cells; quoted where a cell has such signs itself."""
    return "".join("\t".join(map(_quoted, row)) + "\n" for row in rows)


def _quoted(cell: str) -> str:
    # The csv module quotes a row's only cell where it is empty; a spreadsheet shows the quotes.
    return '"' + cell.replace('"', '""') + '"' if any(c in cell for c in '\t\r\n"') else cell


def to_html(rows: Sequence[Sequence[str]]) -> str:
    lines = ("".join(f"<td>{_marked(cell)}</td>" for cell in row) for row in rows)
    return f"<table>{''.join(f'<tr>{line}</tr>' for line in lines)}</table>"


def _marked(cell: str) -> str:
    return html.escape(cell).replace("\n", "<br>")


def from_text(text: str) -> list[list[str]]:
    """Rows of cells, all of one length; empty where there is nothing."""
    read = csv.reader(io.StringIO(text, newline=""), dialect="excel-tab")
    return _even([row or [""] for row in read])


def from_html(text: str) -> list[list[str]]:
    """The cells of the first table; empty where there is none. A cell that covers several others
    stands in the first of them.
    """
    reader = _Tables()
    reader.feed(text)
    reader.close()
    return _even([[_tidy(cell) for cell in row] for row in reader.rows])


def _tidy(cell: str) -> str:
    return "\n".join(" ".join(line.split()) for line in cell.split("\n")).strip()


def _even(rows: list[list[str]]) -> list[list[str]]:
    wide = max((len(row) for row in rows), default=0)
    return [row + [""] * (wide - len(row)) for row in rows] if wide else []


class _Tables(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self._depth = 0
        self._done = False
        self._inside = False
        self._below: dict[tuple[int, int], None] = {}

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "table":
            self._depth += 1
        if self._depth != 1 or self._done:
            return
        if tag == "tr":
            self.rows.append([])
            self._inside = False
        elif tag in ("td", "th") and self.rows:
            self._begin(dict(attrs))
        elif tag == "br":
            self.handle_data("\n", "\n")

    def _begin(self, attributes: dict[str, str | None]) -> None:
        row, at = self.rows[-1], len(self.rows) - 1
        while (at, len(row)) in self._below:
            row.append("")
        self._at, self._inside = len(row), True
        wide, high = (_span(attributes.get(name)) for name in ("colspan", "rowspan"))
        row += [""] * wide
        for down in range(1, high):
            self._below |= dict.fromkeys((at + down, self._at + across) for across in range(wide))

    def handle_endtag(self, tag: str) -> None:
        if tag == "table" and self._depth:
            self._depth -= 1
            self._done = self._done or not self._depth
        if tag in ("td", "th", "tr", "table"):
            self._inside = False

    def handle_data(self, data: str, end: str = " ") -> None:
        if self._inside and self._depth == 1:
            # The ends of lines in the page's text are no more than blanks.
            self.rows[-1][self._at] += data.replace("\n", end)


def _span(text: str | None) -> int:
    """At most as many as anybody means: what is pasted comes from anywhere."""
    return min(max(int(text), 1), 1000) if text is not None and text.isdecimal() else 1
