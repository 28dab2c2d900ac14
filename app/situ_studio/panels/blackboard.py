"""Blackboard: every tag of the connected robot, its value, who set it and how long ago."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from situ.document import names
from situ_studio.live.moment import Entry, Moment
from situ_studio.looks.theme import Theme
from situ_studio.panels.table import Row, RowsTable
from situ_studio.wording.language import tr
from situ_studio.wording.value_words import value_lines, value_words

HIDDEN = "•••"
FRESH = 2.0
"""Seconds for which a value that was just set is marked."""


class Blackboard(RowsTable):
    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        titles = (tr("Tag"), tr("Value"), tr("Set by"), tr("Ago"))
        super().__init__(tr("Blackboard"), titles, (200, 320, 140), theme, parent)
        self.rows.tips = (
            tr("What the value is about, such as user.name."),
            tr("The value as the robot knows it now; private ones are hidden."),
            tr("Which program or application set it last."),
            tr("How long ago it was set."),
        )

    def show_moment(self, moment: Moment, t: float, private: Sequence[str] = ()) -> None:
        """The board at ``t`` seconds. private: patterns of tags whose values are not shown."""
        self.show_made(
            lambda: [_row(tag, moment, t, private) for tag in sorted(moment.board, key=_order)]
        )


def _order(tag: str) -> tuple[bool, str]:
    """The project's own data first, then what the runtime keeps of applications and the robot."""
    return tag.startswith(names.RESERVED_ROOTS), tag


def _row(tag: str, moment: Moment, t: float, private: Sequence[str]) -> Row:
    entry = moment.board[tag]
    hidden = any(names.matches(pattern, tag) for pattern in private)
    words = HIDDEN if hidden else value_words(entry.value)
    tip = f"{tag} = {words}"
    if not hidden and isinstance(entry.value, dict | list):
        tip = f"{tag}\n{value_lines(entry.value)}"
    age = max(t - entry.t, 0.0)
    marked = age < FRESH and entry.t > 0
    return Row(tag, (tag, words, _writer(entry), ago(age)), marked, tip)


def _writer(entry: Entry) -> str:
    role, _, name = (entry.writer or "–").partition(":")
    return tr("operator {0}").format(name) if role == "operator" and name else entry.writer or "–"


def ago(seconds: float) -> str:
    """A length of time as it is read at a glance: ``0.4 s``, ``12 s``, ``3 min``."""
    if seconds < 10:
        return tr("{0} s").format(f"{seconds:.1f}")
    if seconds < 120:
        return tr("{0} s").format(f"{seconds:.0f}")
    return tr("{0} min").format(f"{seconds / 60:.0f}")
