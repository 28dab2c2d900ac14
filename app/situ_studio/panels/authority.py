"""Authority: who holds which resource of the connected robot, and who else asks for it."""

from __future__ import annotations

from typing import Any

from PySide6.QtWidgets import QWidget

from situ.decide.values import in_text
from situ_studio.live.moment import Moment
from situ_studio.looks.theme import Theme
from situ_studio.panels.blackboard import ago
from situ_studio.panels.table import Row, RowsTable
from situ_studio.wording.language import tr
from situ_studio.wording.value_words import value_words


class Authority(RowsTable):
    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        titles = (tr("Resource"), tr("Held by"), tr("Since"), tr("Also asked for by"), tr("Does"))
        widths = (120, 140, 80, 220)
        super().__init__(tr("Authority"), titles, widths, theme, parent)
        self.rows.tips = (
            tr("A part of the robot that one module at a time moves."),
            tr("The module that moves it now."),
            tr("How long it has held it."),
            tr("Modules that want it too, and do not get it."),
            tr("What it was told to do last."),
        )

    def show_moment(self, moment: Moment, t: float) -> None:
        """Every resource that is held, asked for or mapped, by name, at ``t`` seconds."""
        self.show_made(lambda: self._rows_at(moment, t))

    def _rows_at(self, moment: Moment, t: float) -> list[Row]:
        asked = {resource for wanted in moment.asking.values() for resource in wanted}
        every = sorted(asked | moment.holders.keys() | moment.robot.keys())
        return [self._row(resource, moment, t) for resource in every]

    def _row(self, resource: str, moment: Moment, t: float) -> Row:
        holder, since = moment.holders.get(resource, (None, 0.0))
        others = [m for m, wanted in moment.asking.items() if resource in wanted and m != holder]
        does = moment.robot.get(resource)
        cells = (
            resource,
            holder or self.tr("nobody"),
            ago(t - since) if holder is not None else "",
            ", ".join(others),
            self.tr("shown") if resource == "screen" and does else _does(does),
        )
        return Row(resource, cells, holder is not None)


def _does(value: Any) -> str:
    """What a resource does, in words where there are some: what is said, not the message."""
    if isinstance(value, dict) and value.get("text"):
        return f"“{in_text(value['text'])}”"
    return value_words(value) if value else ""
