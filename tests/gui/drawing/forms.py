"""Forms, filled in from the keyboard: Tab from field to field, what is wanted is written."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QCheckBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QScrollArea,
    QWidget,
)
from tests.gui.drawing.draughtsman import Draughtsman
from tests.gui.test_newcomer import CONTROL, NONE

from situ_studio.panels.rows import RowWidget

ANSWERS = {"true": "yes", "false": "no"}
"""What a person chooses where a value is one of two."""
FARTHEST = 60
"""Fields that one goes through before one looks elsewhere."""


class FormFiller(Draughtsman):
    """Writes into the form of what is selected, as somebody does who knows it by heart."""

    def fill(self, wanted: Mapping[str, str | bool]) -> None:
        """Each field by its name, from where the cursor is on, in the order of the form.

        What stands there already is left. The last one is left by Tab, which takes it.
        """
        left = dict(wanted)
        passed = []
        form = self.widget("Inspector")
        for _ in range(FARTHEST):
            field = self.focus()
            name = called(field)
            passed.append(name)
            if name in left and form.isAncestorOf(field):
                self.write(field, left.pop(name))
            if not left:
                break
            self.key(Qt.Key.Key_Tab)
        assert not left, f"there is no {sorted(left)}, but {passed}"
        if wanted:
            self.key(Qt.Key.Key_Tab)

    def fill_form(self, wanted: Mapping[str, str | bool]) -> None:
        """From its first field that is wanted on."""
        first = next(iter(wanted))
        self.press_in_form(first)
        if isinstance(self.in_form(first)[0], QComboBox):
            # Its list is open: it is chosen by letters.
            self.key(Qt.Key.Key_Escape)
        self.fill(wanted)

    def press(self, name: str) -> None:
        """A kind of the palette."""
        self.click(name, QAbstractButton)

    def write(self, field: QWidget, wanted: str | bool) -> None:
        """Over what stands in the field that has the focus."""
        if isinstance(field, QCheckBox):
            if field.isChecked() != wanted:
                self.key(Qt.Key.Key_Space)
            return
        assert isinstance(wanted, str)
        if isinstance(field, QComboBox):
            if field.findText(wanted) < 0:
                wanted = ANSWERS.get(wanted, wanted)
            if field.currentText() != wanted:
                self.type(wanted, None)
                assert field.currentText() == wanted, f"{wanted!r} is not offered"
        elif isinstance(field, QLineEdit | QPlainTextEdit):
            if (field.text() if isinstance(field, QLineEdit) else field.toPlainText()) == wanted:
                return
            # Tab selects all of a line.
            if not isinstance(field, QLineEdit) or field.selectedText() != field.text():
                self.key(Qt.Key.Key_A, CONTROL)
            if wanted:
                self.type(wanted, None)
            else:
                self.key(Qt.Key.Key_Delete)
        else:
            raise AssertionError(f"nobody writes into {field}")

    def add_rows(self, button: str, rows: Sequence[Sequence[str]]) -> None:
        """Rows of a short list, each begun with its plus."""
        for row in rows:
            self.press_in_form(button)
            for text in row:
                self.write(self.focus(), text)
                self.key(Qt.Key.Key_Tab)

    def press_in_form(self, name: str, which: int = 0) -> None:
        """A button of the form, of those that are called so; the wheel brings it into view."""
        button = self.in_form(name)[which]
        self.bring(button)
        self.click_at(middle(button))

    def menu_in_form(self, name: str, entry: str, which: int = 0) -> None:
        """An entry of the menu of such a button, by the arrow keys."""
        button = self.in_form(name)[which]
        self.bring(button)
        with self.counts(2):
            self.choose_in_menu(entry, lambda: self.click_at(middle(button)))

    def open_last_row(self) -> None:
        """The last row of the form's lists: what was added just now."""
        form = self.widget("Inspector")
        rows = [one for one in form.findChildren(RowWidget) if one.isVisible()]
        rows.sort(key=lambda one: one.mapToGlobal(QPoint()).y())
        self.bring(rows[-1])
        self.click_at(middle(rows[-1]))

    def in_form(self, name: str) -> list[QWidget]:
        """The form's buttons and fields of that name, as one reads; scrolled away or not."""
        form = self.widget("Inspector")
        every = [w for w in form.findChildren(QWidget) if w.isVisible() and called(w) == name]
        every.sort(key=lambda w: w.mapToGlobal(QPoint()).toTuple()[::-1])
        assert every, f"the form has no {name!r}"
        return every

    def bring(self, widget: QWidget) -> None:
        """Turns the wheel over the form until the widget can be seen whole."""
        area = widget.parentWidget()
        while area is not None and not isinstance(area, QScrollArea):
            area = area.parentWidget()
        if area is None:
            return
        port = area.viewport()
        for _ in range(FARTHEST):
            top = widget.mapTo(port, QPoint()).y()
            if top < 0:
                self.turn(port, 120)
            elif top + widget.height() > port.height():
                self.turn(port, -120)
            else:
                return

    def turn(self, port: QWidget, by: int) -> None:
        """The wheel over what scrolls."""
        self.gestures += 1
        spot = port.rect().center()
        event = QWheelEvent(
            QPointF(spot),
            QPointF(port.mapToGlobal(spot)),
            QPoint(),
            QPoint(0, by),
            Qt.MouseButton.NoButton,
            NONE,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(port, event)
        self.settle()

    def focus(self) -> QWidget:
        found = QApplication.focusWidget()
        assert found is not None, "nothing has the focus"
        return found


def middle(widget: QWidget) -> QPoint:
    """On the screen."""
    return widget.mapToGlobal(widget.rect().center())


def called(widget: QWidget) -> str:
    """Its name; a button or a box of its own words by those."""
    words = widget.text() if isinstance(widget, QAbstractButton) else ""
    return widget.accessibleName() or words
