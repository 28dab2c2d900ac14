"""The section of the project form about the robot: where it is asked, and whether it says so."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from situ.document import toml_writing as writing
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.project_form.boxes import FieldsSection, Tables, table_of
from situ_studio.wording.language import tr


class RobotSection(FieldsSection):
    """everywhere: whether robots announce themselves where the file that is shown is silent."""

    def __init__(
        self,
        theme: Theme,
        title: str,
        hint: str,
        fields: Sequence[tuple[str, str, str, str, Callable[[str], str]]],
    ) -> None:
        super().__init__(theme, title, hint, fields)
        self.everywhere = True
        self.announce = Flag(theme, tr("Announce it in the network"))
        self.announce.setToolTip(
            tr("A robot that others can reach is found by them when they connect.")
        )
        self.announce.committed.connect(self._on_announce)
        self.body.addWidget(self.announce, 0, Qt.AlignmentFlag.AlignLeft)

    def show_tables(self, tables: Tables) -> None:
        super().show_tables(tables)
        self.announce.show_value(announces(tables, self.everywhere))

    def field_of(self, table: str, key: str) -> QWidget | None:
        return self.announce if key == "announce" else super().field_of(table, key)

    def _on_announce(self, wanted: bool) -> None:
        # What counts anyway need not stand there.
        value = None if wanted == self.everywhere else wanted
        words = tr("Announce the robot") if wanted else tr("Do not announce the robot")
        self.tell(lambda toml: writing.put(toml, "robot", "announce", value), words)


def announces(tables: Tables, usual: bool) -> bool:
    """What a file says of it; usual: where it says nothing, or nothing right."""
    value = table_of(tables, "robot").get("announce")
    return value if isinstance(value, bool) else usual
