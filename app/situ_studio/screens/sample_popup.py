"""The values that texts stand for while a screen is designed: chosen or typed, tag by tag."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFrame,
    QGridLayout,
    QLabel,
    QStyledItemDelegate,
    QVBoxLayout,
    QWidget,
)

from situ.decide.values import in_text
from situ.document.values import read
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.screens import samples
from situ_studio.screens.sample_table import SampleTable
from situ_studio.widgets.icon_widgets import Elided
from situ_studio.widgets.layouts import clear
from situ_studio.widgets.named_box import NamedBox

WIDE = 400
MOST = 14
"""Tags that are shown."""


class SamplePopup(QFrame):
    """A row a name that the screen shows. What is typed is read as JSON where it is some."""

    picked = Signal(str, object)
    """A name and its value; None: as the project has it."""
    shown = Signal(bool)
    """Whether texts are filled in at all."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setProperty("role", "popup")
        self.setAccessibleName(self.tr("Sample values"))
        self.setFixedWidth(px(WIDE))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        column = QVBoxLayout(self)
        column.setContentsMargins(12, 8, 12, 12)
        column.setSpacing(8)
        self.use: QCheckBox = Flag(theme, self.tr("Fill texts with sample values"), self)
        self.use.setToolTip(self.tr("Else texts are shown as they are written"))
        self.use.toggled.connect(self._enable)
        self.use.toggled.connect(self.shown)
        column.addWidget(self.use)
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(4)
        self._grid.setColumnStretch(1, 1)
        column.addLayout(self._grid)
        hint = QLabel(self.tr("From the tags at the start and the scenarios; type another one."))
        hint.setProperty("role", "hint")
        hint.setWordWrap(True)
        column.addWidget(hint)
        self.fields: dict[str, NamedBox] = {}
        self.tables: dict[str, SampleTable] = {}

    def show_values(
        self,
        used: bool,
        names: tuple[str, ...],
        known: Mapping[str, tuple[Any, ...]],
        values: Mapping[str, Any],
        columns: Mapping[str, tuple[str, ...]] | None = None,
    ) -> None:
        """names: of the rows. known: what is offered; values: what they are now. columns: of the
        names that are lists, the fields of their entries.
        """
        self.use.blockSignals(True)
        self.use.setChecked(used)
        self.use.blockSignals(False)
        clear(self._grid)
        self.fields, self.tables = {}, {}
        for row, name in enumerate(names[:MOST]):
            if columns is not None and name in columns:
                self._add_table(row, name, columns[name], samples.value_of(values, name))
                continue
            label = Elided(name, "label")
            label.setFixedWidth(px(112))
            field = NamedBox()
            field.setEditable(True)
            field.setItemDelegate(QStyledItemDelegate(field))
            field.setInsertPolicy(NamedBox.InsertPolicy.NoInsert)
            field.setAccessibleName(name)
            for value in samples.offered(known, name):
                field.addItem(in_text(value), value)
            field.setCurrentText(in_text(samples.value_of(values, name)))
            field.activated.connect(lambda _, n=name: self._on_chosen(n))
            line = field.lineEdit()
            assert line is not None
            line.setCursorPosition(0)
            line.editingFinished.connect(lambda n=name: self._on_typed(n))
            self._grid.addWidget(label, row, 0)
            self._grid.addWidget(field, row, 1)
            self.fields[name] = field
        self._enable(used)
        if not names:
            none = QLabel(self.tr("No text of this screen refers to a value."))
            none.setProperty("role", "dim")
            self._grid.addWidget(none, 0, 0, 1, 2)

    def _enable(self, used: bool) -> None:
        """Values can be picked while texts are filled in."""
        for field in (*self.fields.values(), *self.tables.values()):
            field.setEnabled(used)

    def _add_table(self, row: int, name: str, fields: tuple[str, ...], value: Any) -> None:
        label = Elided(name, "label")
        label.setFixedWidth(px(112))
        table = SampleTable(name, fields, value if isinstance(value, list) else [])
        table.edited.connect(lambda entries: self.picked.emit(name, entries))
        self._grid.addWidget(label, row, 0, Qt.AlignmentFlag.AlignTop)
        self._grid.addWidget(table, row, 1)
        self.tables[name] = table

    def open_below(self, widget: QWidget) -> None:
        self.adjustSize()
        self.move(widget.mapToGlobal(QPoint(0, widget.height() + 4)))
        self.show()
        # Else keys would go to what has the focus below it.
        self.use.setFocus(Qt.FocusReason.PopupFocusReason)

    def _on_chosen(self, name: str) -> None:
        self.picked.emit(name, self.fields[name].currentData())

    def _on_typed(self, name: str) -> None:
        field = self.fields.get(name)
        if field is None:
            return
        text = field.currentText().strip()
        at = field.findText(text)
        value = field.itemData(at) if at >= 0 else read(text)
        self.picked.emit(name, None if text == "" else value)
