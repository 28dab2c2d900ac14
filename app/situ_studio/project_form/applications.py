"""The applications of a project in its form: which there are, in what order, where each starts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Signal

from situ.document import toml_writing as writing
from situ.document.rbd import Application
from situ_studio.canvas.gestures import title
from situ_studio.panels.fields import Choice
from situ_studio.project_form.boxes import RowsSection, Tables, table_of, texts_of
from situ_studio.project_form.rows import Column
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.looks.theme import Theme


class ApplicationsSection(RowsSection):
    """Their order counts: what they do at one moment is done in it."""

    movable = True
    add_asked = Signal(QPoint)
    """Another one is wanted; where on the screen a menu for it opens."""
    remove_asked = Signal(str)
    """The file of one that the project shall not have any more."""
    start_asked = Signal(str, str)
    """The file of one, and the number of the state that it shall start in."""

    def __init__(self, theme: Theme) -> None:
        columns = (
            Column(title=tr("Name"), share=2),
            Column(title=tr("File"), share=3),
            Column(
                title=tr("Starts in"),
                make=Choice,
                share=3,
                help=tr("The state in which it begins when the robot starts."),
            ),
        )
        super().__init__(
            theme,
            tr("Applications"),
            tr("Where several have something to do at one moment, the upper one goes first."),
            columns,
            tr("an application"),
        )
        self._files: list[str] = []
        self._applications: Mapping[str, Application] = {}

    def show_applications(self, applications: Mapping[str, Application]) -> None:
        """What ``show_tables`` tells of the files that are there."""
        self._applications = applications

    def show_tables(self, tables: Tables) -> None:
        self._files = texts_of(table_of(tables, "project").get("applications"))
        known = [self._applications.get(file) for file in self._files]
        self.show_values(
            [
                (one.name if one is not None else tr("not there"), file, "")
                for file, one in zip(self._files, known, strict=True)
            ]
        )
        for row, one in enumerate(known):
            start = self.rows.field(row, 2)
            assert isinstance(start, Choice)
            states = one.states if one is not None else ()
            start.offer(tuple((state.no, title(one, state.no)) for state in states if one))
            start.show_value(one.start_no if one is not None else None)
            start.setEnabled(bool(states))

    def on_changed(self, row: int, column: int, value: str) -> None:
        self.start_asked.emit(self._files[row], value)

    def on_added(self) -> None:
        self.add_asked.emit(self.plus.mapToGlobal(QPoint(0, self.plus.height())))

    def on_removed(self, row: int) -> None:
        self.remove_asked.emit(self._files[row])

    def on_moved(self, row: int, to: int) -> None:
        files = list(self._files)
        files.insert(to, files.pop(row))
        words = tr("Move {0}").format(self._files[row])
        self.tell(lambda toml: writing.put(toml, "project", "applications", files), words)
