"""The texts of a project in another language, written into their table."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView
from tests.gui.drawing.draughtsman import Draughtsman

from situ_studio.texts.model import WRITTEN


class Translator(Draughtsman):
    """Goes down the column of a language."""

    def translate(self, language: str, wanted: Mapping[str, str]) -> None:
        """On the page of all texts. wanted: by the text as it is written, which is translated once
        wherever it stands.
        """
        self.answer(language)
        self.click("Add a language…")
        table = self.focus_table()
        self.key(Qt.Key.Key_Home, Qt.KeyboardModifier.ControlModifier)
        for _ in range(table.currentIndex().column(), WRITTEN + 1):
            self.key(Qt.Key.Key_Right)
        for row in range(table.model().rowCount()):
            index = table.currentIndex()
            assert index.row() == row
            said = wanted.get(str(index.siblingAtColumn(WRITTEN).data()), "")
            if said and index.data() != said:
                self.key(Qt.Key.Key_Return)
                self.type(said)
            else:
                self.key(Qt.Key.Key_Down)

    def focus_table(self) -> QAbstractItemView:
        found = self.hears()
        assert isinstance(found, QAbstractItemView), f"the cursor is in {found}"
        return found
