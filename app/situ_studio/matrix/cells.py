"""How the cells of the matrix look, and the line in which one is edited."""

from __future__ import annotations

from PySide6.QtCore import QAbstractItemModel, QEvent, QObject, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPen
from PySide6.QtWidgets import (
    QAbstractItemDelegate,
    QLabel,
    QLineEdit,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ_studio.assistive.announcing import announce
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import BODY, CAPTION, LABEL, Theme, font
from situ_studio.matrix.edits import read
from situ_studio.matrix.model import AnyIndex, MatrixModel

MARK = 14
"""Px of the icon beside a number."""
SHORT = 4
"""So many letters fit into any column."""
CENTRE, MIDDLE = int(Qt.AlignmentFlag.AlignCenter), int(Qt.AlignmentFlag.AlignVCenter)

_FACES: dict[str, tuple[str, float, int]] = {
    "own": ("text", BODY, 600),
    "taken": ("text3", BODY, 400),
    "holder": ("text2", CAPTION, 400),
    "nobody": ("text3", CAPTION, 400),
    "tie": ("warning", CAPTION, 600),
}
"""By kind of text: its colour, size and weight."""


class Cells(QStyledItemDelegate):
    """Paints ``Shown``. rows, columns: those of what is selected, wherever that was done.

    An editor stays open until its text is a priority; ``refused`` says why it is none.
    """

    refused = Signal(QWidget, str)
    accepted = Signal()
    moved = Signal(int, int)
    """An editor was left: how far across and down."""

    def __init__(self, theme: Theme, model: MatrixModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = model
        self.set_theme(theme)
        self.rows: frozenset[int] = frozenset()
        self.columns: frozenset[int] = frozenset()
        self.by_typing = False
        self._fonts = {kind: font(size, weight) for kind, (_, size, weight) in _FACES.items()}

    def set_theme(self, theme: Theme) -> None:
        self.theme = theme
        self._colors: dict[str, QColor] = {}

    def _color(self, token: str) -> QColor:
        # A frame has hundreds of cells: a colour is made of its text once.
        found = self._colors.get(token)
        if found is None:
            found = self._colors[token] = self.theme.color(token)
        return found

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        row, column = index.row(), index.column()
        shown = self._model.shown(row, column)
        if shown.mark:
            painter.fillRect(option.rect, self._color(f"{shown.mark}_soft"))
        elif row in self.rows or column in self.columns:
            painter.fillRect(option.rect, self._color("accent_soft"))
        if not shown.text and not shown.mark:
            return
        area = option.rect
        token, size, _ = _FACES[shown.kind]
        painter.setFont(self._fonts[shown.kind])
        painter.setPen(self._color(shown.mark or token))
        room = area.adjusted(2, 0, -2, 0) if size == CAPTION else area.adjusted(5, 0, -5, 0)
        text, sign = shown.text, px(MARK)
        if len(text) > SHORT:
            wide = room.width() - (sign + 5 if shown.mark else 0)
            elide = Qt.TextElideMode.ElideRight
            text = painter.fontMetrics().elidedText(text, elide, wide)
        if not shown.mark:
            painter.drawText(room, CENTRE, text)
            return
        took = painter.fontMetrics().horizontalAdvance(text) + (5 if text else 0) + sign
        left = room.left() + (room.width() - took) / 2
        painter.drawText(QRectF(left, room.top(), took, room.height()), MIDDLE, text)
        spot = QRectF(left + took - sign, room.center().y() - sign / 2 + 0.5, sign, sign)
        icons.paint(painter, shown.mark, spot, self._color(shown.mark))

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(px(74), px(28))

    # -- editing --------------------------------------------------------------------

    def createEditor(
        self, parent: QWidget, option: QStyleOptionViewItem, index: AnyIndex
    ) -> QWidget:
        editor = QLineEdit(parent)
        editor.setFrame(False)
        editor.setAlignment(Qt.AlignmentFlag.AlignCenter)
        editor.setFont(font(BODY, 600))
        editor.setAccessibleName(str(index.data(Qt.ItemDataRole.AccessibleTextRole)))
        theme = self.theme
        editor.setStyleSheet(
            f"QLineEdit {{ background: {theme.panel}; color: {theme.text}; padding: 0 3px;"
            f" border: 2px solid {theme.accent}; min-height: 0; max-height: 999px;"
            f" selection-background-color: {theme.accent};"
            f" selection-color: {theme.on_accent}; }}"
        )
        return editor

    def setEditorData(self, editor: QWidget, index: AnyIndex) -> None:
        assert isinstance(editor, QLineEdit)
        if not editor.isModified():
            editor.setText(index.data(Qt.ItemDataRole.EditRole))
            editor.selectAll()

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: AnyIndex) -> None:
        assert isinstance(editor, QLineEdit)
        self.accepted.emit()
        if editor.isModified():
            model.setData(index, editor.text(), Qt.ItemDataRole.EditRole)

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, index: AnyIndex
    ) -> None:
        editor.setGeometry(option.rect.adjusted(-1, -1, 0, 0))

    def eventFilter(self, editor: QObject, event: QEvent) -> bool:
        if not isinstance(editor, QLineEdit):
            return False
        if event.type() == QEvent.Type.KeyPress:
            assert isinstance(event, QKeyEvent)
            way = self._way(event)
            if way is not None:
                self._leave(editor, way)
                return True
            if event.key() == Qt.Key.Key_Escape:
                self.accepted.emit()
        elif event.type() == QEvent.Type.ShortcutOverride:
            # What is typed into a line is no command of the window.
            event.accept()
            return True
        return super().eventFilter(editor, event)

    def _way(self, event: QKeyEvent) -> tuple[int, int] | None:
        """Where a key leads that ends editing, across and down; None for every other key."""
        key, shift = event.key(), bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            return 0, -1 if shift else 1
        if key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            return (-1 if shift or key == Qt.Key.Key_Backtab else 1), 0
        if key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            return 0, -1 if key == Qt.Key.Key_Up else 1
        # Whoever began by typing goes on to the next cell; whoever opened it moves in its text.
        if self.by_typing and key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            return (-1 if key == Qt.Key.Key_Left else 1), 0
        return None

    def _leave(self, editor: QLineEdit, way: tuple[int, int]) -> None:
        if editor.isModified():
            try:
                read(editor.text())
            except ValueError as wrong:
                self.refused.emit(editor, str(wrong))
                return
        self.commitData.emit(editor)
        self.closeEditor.emit(editor, QAbstractItemDelegate.EndEditHint.NoHint)
        self.moved.emit(*way)


class Sentence(QLabel):
    """Why a text is refused, below its cell, until it is mended or given up."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._room = parent
        self.setFont(font(LABEL, 500))
        self.setContentsMargins(8, 4, 8, 4)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def set_theme(self, theme: Theme) -> None:
        self.setStyleSheet(
            f"background: {theme.error_soft}; color: {theme.error};"
            f" border: 1px solid {theme.error}; border-radius: 6px;"
        )

    def say(self, cell: QRect, text: str) -> None:
        """Shows it below the cell, or above where there is no room."""
        self.setText(text)
        announce(self, text)
        self.adjustSize()
        room = self._room.rect()
        left = max(0, min(cell.left(), room.right() - self.width()))
        below = cell.bottom() + 3
        if below + self.height() > room.bottom():
            below = max(0, cell.top() - self.height() - 3)
        self.move(left, below)
        self.show()
        self.raise_()


def outline(painter: QPainter, area: QRect, theme: Theme, dashed: bool = False) -> None:
    """The frame round what is selected."""
    pen = QPen(theme.color("accent"), 2, Qt.PenStyle.DashLine if dashed else Qt.PenStyle.SolidLine)
    pen.setJoinStyle(Qt.PenJoinStyle.MiterJoin)
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(area)
