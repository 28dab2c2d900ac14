"""A dial as a row: a slider or a switch, or a field, which writes a tag."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAccessible, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSlider, QWidget

from situ.decide.values import in_text
from situ.document.values import is_number, read
from situ_studio.assistive.announcing import announce
from situ_studio.assistive.heard_as import hear_as
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.rehearsing.dials import Dial
from situ_studio.widgets.focus_ring import paint_ring
from situ_studio.widgets.icon_widgets import Elided
from situ_studio.widgets.named_box import NamedBox
from situ_studio.wording.value_words import with_unit

STEPS = 100
"""Places of a slider between its bounds."""
TITLE = 116


class DialSlider(QSlider):
    """Shows whether it has the keyboard: the style does not."""

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.hasFocus():
            paint_ring(self)


class DialRow(QWidget):
    """``written``: somebody has given it a value; shown values are not told."""

    written = Signal(str, object)

    def __init__(self, theme: Theme, dial: Dial, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.dial = dial
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(6)
        title = Elided(dial.tag, "label")
        title.setFixedWidth(px(TITLE))
        line.addWidget(title)
        self.flag: Flag | None = None
        self.slider: QSlider | None = None
        self.choice: NamedBox | None = None
        # Only a number has it, and without a parent it would be a window.
        self.value = QLabel(self)
        self.value.setVisible(dial.kind == "number")
        if dial.kind == "boolean":
            self.flag = Flag(theme, "")
            self.flag.setAccessibleName(dial.tag)
            self.flag.committed.connect(lambda on: self.written.emit(dial.tag, bool(on)))
            line.addWidget(self.flag, 1)
        elif dial.kind == "number":
            self.slider = DialSlider(Qt.Orientation.Horizontal)
            self.slider.setAccessibleName(dial.tag)
            # Of a slider readers tell its place between its bounds, which says nothing here.
            hear_as(self.slider, QAccessible.Role.Slider)
            self.slider.setRange(0, STEPS)
            self.slider.setPageStep(STEPS // 10)
            self.slider.valueChanged.connect(self._on_slid)
            line.addWidget(self.slider, 1)
            self.value.setFixedWidth(px(58))
            self.value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            self.value.setProperty("role", "label")
            line.addWidget(self.value)
        else:
            self.choice = NamedBox()
            self.choice.setEditable(True)
            self.choice.setInsertPolicy(NamedBox.InsertPolicy.NoInsert)
            self.choice.setAccessibleName(dial.tag)
            self.choice.addItems(list(dial.values))
            self.choice.setCurrentText("")
            edit = self.choice.lineEdit()
            assert edit is not None
            # Of one Return Qt tells up to three times, by both of these.
            soon = QTimer(self)
            soon.setSingleShot(True)
            soon.timeout.connect(lambda: self._on_chosen(edit.text()))
            self.choice.activated.connect(lambda _: soon.start())
            edit.returnPressed.connect(soon.start)
            line.addWidget(self.choice, 1)
        self.show_value(None)

    def show_value(self, value: Any) -> None:
        """The tag has this value now."""
        dial = self.dial
        if self.flag is not None:
            self.flag.show_value(value is True)
        elif self.slider is not None:
            self.value.setText(self._written(value))
            self.slider.setAccessibleDescription(self.value.text())
            if is_number(value) and not self.slider.isSliderDown():
                self.slider.blockSignals(True)
                self.slider.setValue(round((value - dial.low) / (dial.high - dial.low) * STEPS))
                self.slider.blockSignals(False)
        elif self.choice is not None:
            edit = self.choice.lineEdit()
            assert edit is not None
            if not edit.hasFocus():
                edit.setText(in_text(value))

    def _on_slid(self, place: int) -> None:
        dial = self.dial
        value = round(dial.low + (dial.high - dial.low) * place / STEPS, 3)
        announce(self, self._written(value))
        self.written.emit(dial.tag, value)

    def _on_chosen(self, text: str) -> None:
        self.written.emit(self.dial.tag, read(text) if text else None)

    def _written(self, value: Any) -> str:
        if not is_number(value):
            return self.tr("not set")
        return with_unit(value, self.dial.unit)
