"""A rehearsal becomes a scenario: its name, and which of what happened is expected from now on."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QLabel,
    QLineEdit,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from situ.decide.inputs import Deploy
from situ.document import folder
from situ.errors import UsageError
from situ.rehearse.suite import ENDING
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.rehearsing.choices import Choices
from situ_studio.rehearsing.course import Course
from situ_studio.rehearsing.expecting import Chance, chances, written
from situ_studio.widgets.dialog_buttons import add_buttons
from situ_studio.wording.language import said


class SavingScenario(QDialog):
    """Asks, and writes the file into ``home``. The course must not go on meanwhile."""

    saved = Signal(Path)

    def __init__(self, course: Course, home: Path, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self._course, self._home = course, home
        self.setWindowTitle(self.tr("Save as a scenario"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(px(460), 460)
        column = QVBoxLayout(self)
        column.setContentsMargins(24, 24, 24, 24)
        column.setSpacing(8)
        column.addWidget(self._label(self.tr("Name")))
        self.name = QLineEdit()
        self.name.setAccessibleName(self.tr("Name of the scenario"))
        self.name.textChanged.connect(self._settle)
        column.addWidget(self.name)
        column.addWidget(self._label(self.tr("What shall happen again")))
        self.list = Choices(theme)
        self.list.setAccessibleName(self.tr("What is expected"))
        for one in chances(course.log):
            item = QListWidgetItem(one.words(course.project))
            item.setToolTip(item.text())
            item.setData(Qt.ItemDataRole.UserRole, one)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            checked = Qt.CheckState.Checked if one.usual else Qt.CheckState.Unchecked
            item.setCheckState(checked)
            self.list.addItem(item)
        column.addWidget(self.list, 1)
        words = self.tr(
            "Changes were taken in on the way. The scenario runs all of it with the project as it "
            "is then: look whether it goes well."
        )
        self.on_the_way = self._label(words)
        self.on_the_way.setVisible(any(isinstance(one.does, Deploy) for one in course.done))
        column.addWidget(self.on_the_way)
        self.why = QLabel()
        self.why.setProperty("role", "refused")
        self.why.setWordWrap(True)
        column.addWidget(self.why)
        self.keep = add_buttons(self, column, self.tr("Save"), self._save)
        self._settle()

    @property
    def expected(self) -> list[Chance]:
        """What is chosen."""
        every = [self.list.item(row) for row in range(self.list.count())]
        chosen = [item for item in every if item.checkState() == Qt.CheckState.Checked]
        found: list[Chance] = [item.data(Qt.ItemDataRole.UserRole) for item in chosen]
        return found

    def _label(self, text: str) -> QLabel:
        label = QLabel(text)
        label.setProperty("role", "label")
        label.setWordWrap(True)
        return label

    @property
    def _file(self) -> Path:
        return self._home / f"{self.name.text().strip()}{ENDING}"

    def _settle(self) -> None:
        """What is wrong with the name is told at once."""
        name = self.name.text().strip()
        why = ""
        if any(sign in '/\\:*?"<>|' or sign < " " for sign in name) or name.startswith("."):
            why = self.tr("A file can not be called that.")
        elif name and self._file.exists():
            why = self.tr("There is a scenario of that name.")
        self.why.setText(why)
        self.keep.setEnabled(bool(name) and not why)

    def _save(self) -> None:
        try:
            self._home.mkdir(parents=True, exist_ok=True)
            folder.write(self._file, written(self._course, self.expected))
        except (OSError, UsageError) as error:
            self.why.setText(said(str(error)))
            return
        self.saved.emit(self._file)
        self.accept()
