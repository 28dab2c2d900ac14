"""Editors of one value: what stands at the right of a label in a form.

Each shows a value without telling, and tells ``committed`` once when a person has
finished a different one: at Enter, at leaving the field, at a choice.
"""

from __future__ import annotations

from itertools import compress, count
from operator import ne
from typing import Any

from PySide6.QtCore import QEvent, QRectF, QSize, QStringListModel, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QDropEvent,
    QFocusEvent,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QShowEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import (
    QCheckBox,
    QCompleter,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QStyledItemDelegate,
    QWidget,
)

from situ_studio.looks import icons
from situ_studio.looks.theme import Theme
from situ_studio.panels.tag_completion import TagCompletion
from situ_studio.widgets.named_box import NamedBox

_SHIFT = Qt.KeyboardModifier.ShiftModifier
_BETWEEN = (Qt.FocusReason.PopupFocusReason, Qt.FocusReason.ActiveWindowFocusReason)
"""Another window, or a menu, comes between: what is in the field stays as it is."""


class Line(QLineEdit):
    """One line of text. Esc puts back what was shown; ``unit`` stands behind the text."""

    committed = Signal(object)
    refused = Signal(str)

    tags: TagCompletion | None = None
    """What ``{`` offers; None where nothing is."""

    def __init__(self, parent: QWidget | None = None, unit: str = "") -> None:
        super().__init__(parent)
        self._shown = ""
        self._help = ""
        self._unit: QLabel | None = None
        self._words: QStringListModel | None = None
        self.editingFinished.connect(self.on_finished)
        if unit:
            self._unit = QLabel(unit, self)
            self._unit.setProperty("role", "label")
            self._unit.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
            width = self._unit.sizeHint().width()
            self.setTextMargins(0, 0, width + 6, 0)

    def show_value(self, value: Any) -> None:
        """Shows a value; what somebody is writing over the same one stays."""
        written = self.written(value)
        if written == self._shown and self.text() != self._shown and _has_cursor(self):
            return
        self._shown = written
        self.put_back()

    def put_back(self) -> None:
        """Shows the value that was shown, where something else has been written."""
        if self.text() != self._shown:
            self.setText(self._shown)
            self.setCursorPosition(0)

    def written(self, value: Any) -> str:
        """How a value stands in the field."""
        return "" if value is None else str(value)

    def read(self, text: str) -> Any:
        """The value of a text; ValueError, with a line for the user, where it is none."""
        return text.strip()

    def complete_from(self, words: tuple[str, ...]) -> None:
        """Offers these words while somebody types."""
        if self._words is None:
            self._words = QStringListModel(self)
            completer = QCompleter(self._words, self)
            completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
            completer.setFilterMode(Qt.MatchFlag.MatchContains)
            popup = completer.popup()
            if popup is not None:
                popup.setProperty("role", "completions")
            self.setCompleter(completer)
        if self._words.stringList() != list(words):
            self._words.setStringList(list(words))

    def complete_tags(self, tags: tuple[str, ...]) -> None:
        """Offers these where somebody types ``{``."""
        if self.tags is None:
            self.tags = TagCompletion(self)
        self.tags.offer(tags)

    def refuse(self, why: str) -> None:
        """Marks the field and says why; empty: no longer."""
        self.setProperty("role", "refused" if why else "")
        self.setToolTip(why or self._help)
        self.style().unpolish(self)
        self.style().polish(self)
        if why:
            self.refused.emit(why)

    def set_help(self, words: str) -> None:
        """What its tooltip says while nothing is refused."""
        self._help = words
        self.setToolTip(words)

    def dropEvent(self, event: QDropEvent) -> None:
        """What is dropped is an edit: nobody leaves the field afterwards."""
        super().dropEvent(event)
        self.on_finished()

    def on_finished(self) -> None:
        text = self.text()
        if text == self._shown:
            self.refuse("")
            return
        try:
            value = self.read(text)
        except ValueError as error:
            self.refuse(str(error))
            return
        self.refuse("")
        self._shown = text
        self.committed.emit(value)

    def event(self, event: QEvent) -> bool:
        if self.tags is not None and self.tags.takes(event):
            return True
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            keys = (QKeySequence.StandardKey.Undo, QKeySequence.StandardKey.Redo)
            # Once the text is an edit, undo means that edit and no longer single letters.
            if self.text() == self._shown and any(event.matches(k) for k in keys):
                event.ignore()
                return False
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self.text() != self._shown:
            self.setText(self._shown)
            self.refuse("")
            return
        super().keyPressEvent(event)

    def focusNextPrevChild(self, next: bool) -> bool:
        # What is taken may show the very field that comes next.
        if self.property("role") != "refused":
            self.on_finished()
        return super().focusNextPrevChild(next)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if event.reason() not in _BETWEEN:
            self.setCursorPosition(0)
        if self.property("role") == "refused":
            self.setText(self._shown)
            self.refuse("")

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._unit is not None:
            hint = self._unit.sizeHint()
            self._unit.setGeometry(self.width() - hint.width() - 9, 0, hint.width(), self.height())


class Number(Line):
    """A number, or nothing."""

    def __init__(
        self,
        parent: QWidget | None = None,
        unit: str = "",
        whole: bool = False,
        above: bool = False,
    ) -> None:
        super().__init__(parent, unit)
        self._whole, self._above = whole, above

    def written(self, value: Any) -> str:
        return "" if value is None else f"{value:g}" if not self._whole else str(value)

    def read(self, text: str) -> Any:
        text = text.strip().replace(",", ".")
        if not text:
            return None
        try:
            value = int(text) if self._whole else float(text)
        except ValueError:
            raise ValueError(
                self.tr("Write a whole number.") if self._whole else self.tr("Write a number.")
            ) from None
        if value != value or value in (float("inf"), float("-inf")):
            raise ValueError(self.tr("Write a number."))
        if self._above and value <= 0:
            raise ValueError(self.tr("Write a number above 0."))
        return value


class Words(Line):
    """Several words, divided by spaces or commas."""

    def written(self, value: Any) -> str:
        return " ".join(value or ())

    def read(self, text: str) -> Any:
        return tuple(dict.fromkeys(text.replace(",", " ").split()))


class Paragraph(QPlainTextEdit):
    """Several lines; as high as its text, from two lines to eight. Ctrl+Enter ends it too."""

    committed = Signal(object)

    tags: TagCompletion | None = None
    """What ``{`` offers; None where nothing is."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown = ""
        self.setTabChangesFocus(True)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.document().documentLayout().documentSizeChanged.connect(self.on_size_changed)
        self.on_size_changed()

    def show_value(self, value: Any) -> None:
        """Shows a text; what somebody is writing over the same one stays."""
        if (value or "") == self._shown and self.toPlainText() != self._shown and _has_cursor(self):
            return
        self._shown = value or ""
        self.put_back()

    def put_back(self) -> None:
        """Shows the text that was shown, where something else has been written."""
        if self.toPlainText() != self._shown:
            self.setPlainText(self._shown)

    def complete_tags(self, tags: tuple[str, ...]) -> None:
        """Offers these where somebody types ``{``."""
        if self.tags is None:
            self.tags = TagCompletion(self)
        self.tags.offer(tags)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # A narrower one has more lines.
        self.on_size_changed()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # Lines that were broken before it was seen run on below the bar that came with them.
        self.resizeEvent(QResizeEvent(self.viewport().size(), QSize()))

    def on_size_changed(self) -> None:
        lines = min(8, max(2, int(self.document().size().height())))
        self.setFixedHeight(lines * self.fontMetrics().lineSpacing() + 16)

    def dropEvent(self, event: QDropEvent) -> None:
        """What is dropped is an edit: nobody leaves the field afterwards."""
        super().dropEvent(event)
        self.finish()

    def finish(self) -> None:
        text = self.toPlainText()
        if text != self._shown:
            self._shown = text
            self.committed.emit(text)

    def event(self, event: QEvent) -> bool:
        if self.tags is not None and self.tags.takes(event):
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        control = event.modifiers() & Qt.KeyboardModifier.ControlModifier
        if control and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.finish()
            return
        if event.key() == Qt.Key.Key_Escape and self.toPlainText() != self._shown:
            self.setPlainText(self._shown)
            return
        super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.finish()


class Choice(NamedBox):
    """One of several; what is not among them is shown too, as it stands.

    Letters go to what begins with them, or has a word that does, however slowly they are typed;
    it is taken as what is typed into a line is.
    """

    committed = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._value: Any = None
        self._offered: tuple[tuple[Any, str], ...] = ()
        self._typed = ""
        self.setSizeAdjustPolicy(NamedBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(4)
        # The style's own delegate does not know the style sheet's colours.
        self.setItemDelegate(QStyledItemDelegate(self))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.activated.connect(self.on_activated)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def offer(self, choices: tuple[tuple[Any, str], ...]) -> None:
        """The values and what stands for each."""
        if choices == self._offered and self.count() == len(choices):
            return
        shown, self._offered = self._offered, choices
        self._typed = ""
        self.blockSignals(True)
        if self.count() == len(shown) == len(choices):
            # One state of thousands has another name: the others stand as they are.
            for index in compress(count(), map(ne, shown, choices)):
                value, text = choices[index]
                self.setItemText(index, text)
                self.setItemData(index, value)
        else:
            self.clear()
            for value, text in choices:
                self.addItem(text, value)
        self.blockSignals(False)

    def show_value(self, value: Any) -> None:
        # What a document writes as nothing is nothing chosen.
        value = None if value == "" else value
        if self._typed and value == self._value:
            return
        self._typed = ""
        self._value = value
        index = self.findData(value)
        if index < 0 and value is not None:
            self.addItem(self.tr("{0} (missing)").format(value), value)
            index = self.count() - 1
        self.setCurrentIndex(index)

    def put_back(self) -> None:
        """Shows what is chosen, where letters went to another."""
        if self._typed:
            self._typed = ""
            self.show_value(self._value)

    def finish(self) -> None:
        """Takes that to which letters went."""
        if self._typed:
            self.on_activated(self.currentIndex())

    def on_activated(self, index: int) -> None:
        self._typed = ""
        value = self.itemData(index)
        if value != self._value:
            self._value = value
            self.committed.emit(value)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, letter = event.key(), event.text()
        command = event.modifiers() & ~(_SHIFT | Qt.KeyboardModifier.KeypadModifier)
        if letter.isprintable() and letter.strip(" " if not self._typed else "") and not command:
            self._go_to(letter)
        elif self._typed and key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.finish()
        elif self._typed and key == Qt.Key.Key_Escape:
            self.put_back()
        else:
            super().keyPressEvent(event)

    def _go_to(self, letter: str) -> None:
        entries = [self.itemText(index).casefold() for index in range(self.count())]
        for typed in (self._typed + letter.casefold(), letter.casefold()):
            begins = [i for i, entry in enumerate(entries) if entry.startswith(typed)]
            inside = [i for i, entry in enumerate(entries) if f" {typed}" in entry]
            if begins or inside:
                self._typed = typed
                self.setCurrentIndex((begins or inside)[0])
                return

    def focusNextPrevChild(self, next: bool) -> bool:
        # What is taken may show the very field that comes next.
        self.finish()
        return super().focusNextPrevChild(next)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if event.reason() not in _BETWEEN:
            self.finish()

    def wheelEvent(self, event: QWheelEvent) -> None:
        # A form that is scrolled must not change what lies under the pointer.
        event.ignore()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(self.width() - 21, (self.height() - 14) / 2, 14, 14)
        icons.paint(painter, "down", rect, self._theme.color("text3"))
        painter.end()


class Flag(QCheckBox):
    """Yes or no."""

    committed = Signal(object)

    def __init__(self, theme: Theme, words: str, parent: QWidget | None = None) -> None:
        super().__init__(words, parent)
        self._theme = theme
        self.clicked.connect(self.on_clicked)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def show_value(self, value: Any) -> None:
        self.setChecked(bool(value))

    def on_clicked(self, checked: bool) -> None:
        self.committed.emit(checked)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.isChecked():
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(1, (self.height() - 14) / 2, 14, 14)
        icons.paint(painter, "check", rect, self._theme.color("on_accent"))
        painter.end()


class Swatch(Line):
    """A colour as the screen's page takes it, with a sample of it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTextMargins(0, 0, 22, 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        color = QColor(self.text())
        if not self.text() or not color.isValid():
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(self.palette().color(self.foregroundRole()))
        painter.setBrush(color)
        painter.drawRoundedRect(QRectF(self.width() - 24, (self.height() - 14) / 2, 14, 14), 4, 4)
        painter.end()


FieldWidget = Line | Paragraph | Choice | Flag


def _has_cursor(field: QWidget) -> bool:
    """Whether somebody writes there, or will go on to when the window is in front again."""
    return field.window().focusWidget() is field
