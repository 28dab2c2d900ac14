"""A cell of the table of texts: painted with its mark and words, edited in place."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QRectF, QSize, Qt
from PySide6.QtGui import QFontMetrics, QKeyEvent, QPainter, QPen, QTextOption
from PySide6.QtWidgets import (
    QPlainTextEdit,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ_studio.looks import icons
from situ_studio.looks.letters import enlarged, factor, px
from situ_studio.looks.theme import Theme, face, font
from situ_studio.panels.tag_completion import TagCompletion
from situ_studio.texts.model import CELL, ICONS, ROW, STATE, WHAT, AnyIndex, TextsModel
from situ_studio.texts.sheet import Cell, Standing

LINE = 18
ONE_LINE = 30
"""Px that a row of one line is high."""
LINES = 3
"""Lines of a text that are shown at most; its tooltip says all."""
CAPTION = 15
MARKS: dict[Standing, tuple[str, str]] = {
    "missing": ("warning", "warning"),
    "unsure": ("why", "condition"),
    "lacking": ("error", "error"),
}
"""Of what is left to do, icon and colour."""
_ROOM = 8


class CellEditor(QPlainTextEdit):
    """Enter ends it, Shift+Enter makes a new line; ``{`` offers tags."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "cell")
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setTabChangesFocus(True)
        self.document().setDocumentMargin(4)
        self.tags = TagCompletion(self)


class TextDelegate(QStyledItemDelegate):
    """tags: what ``{`` offers, at the time of the call. Tab and Enter tell ``went``."""

    def __init__(
        self,
        theme: Theme,
        tags: Callable[[], tuple[str, ...]],
        went: Callable[[Qt.Key, bool], None],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self.theme, self._tags, self._went = theme, tags, went
        self.hovered: tuple[int, int] | None = None
        self._metrics = QFontMetrics(face(13))
        self._wide: dict[str, list[int]] = {}
        """By text, px of each of its lines where none is broken."""

    # -- painting ----------------------------------------------------------------

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(px(160), px(ONE_LINE))

    def height(self, index: AnyIndex, width: int) -> int:
        """Px that a cell of this width wants."""
        cell: Cell | None = index.data(CELL)
        if cell is None:
            return px(ONE_LINE)
        inner = max(1, int(width / factor()) - 2 * _ROOM - (20 if cell.standing in MARKS else 0))
        wide = self._wide.get(cell.text)
        if wide is None:
            lines = cell.text.split("\n")
            wide = self._wide[cell.text] = [self._metrics.horizontalAdvance(one) for one in lines]
        rows = sum(max(1, -(-one // inner)) for one in wide)
        caption = CAPTION if self._caption(index, cell) else 0
        return px(ONE_LINE + (min(rows, LINES) - 1) * LINE + caption)

    def _caption(self, index: AnyIndex, cell: Cell) -> str:
        model = index.model()
        assert isinstance(model, TextsModel)
        if cell.standing in ("missing", "as_is", "own"):
            return ""
        return model.standing_words(index.data(ROW), cell)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._paint(painter, rect, option.state, index)

    def _paint(
        self, painter: QPainter, rect: QRectF, state: QStyle.StateFlag, index: AnyIndex
    ) -> None:
        theme = self.theme
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if state & QStyle.StateFlag.State_Selected:
            painter.fillRect(rect, theme.color("accent_soft"))
        painter.setPen(theme.color("line"))
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())
        painter.drawLine(rect.topRight(), rect.bottomRight())
        if index.column() in (STATE, WHAT):
            self._paint_place(painter, rect, index)
        else:
            self._paint_text(painter, rect, index)
        if state & QStyle.StateFlag.State_HasFocus:
            painter.setPen(QPen(theme.color("accent"), 2))
            painter.drawRect(rect.adjusted(1, 1, -2, -2))

    def _paint_place(self, painter: QPainter, rect: QRectF, index: AnyIndex) -> None:
        theme = self.theme
        x = rect.x() + _ROOM
        if index.column() == WHAT:
            box = QRectF(x, rect.y() + 7.5, 15, 15)
            icons.paint(painter, ICONS[index.data(ROW).kind], box, theme.color("text2"))
            x += 23
        linked = self.hovered == (index.row(), index.column()) and index.column() == STATE
        made = face(13)
        made.setUnderline(linked)
        painter.setFont(made)
        painter.setPen(theme.color("accent" if index.column() == STATE else "text2"))
        area = QRectF(x, rect.y(), rect.right() - x - 8, ONE_LINE)
        text = painter.fontMetrics().elidedText(
            index.data(), Qt.TextElideMode.ElideRight, int(area.width())
        )
        painter.drawText(area, int(Qt.AlignmentFlag.AlignVCenter), text)

    def _paint_text(self, painter: QPainter, rect: QRectF, index: AnyIndex) -> None:
        theme = self.theme
        cell: Cell = index.data(CELL)
        model = index.model()
        assert isinstance(model, TextsModel)
        area = rect.adjusted(_ROOM, 6, -_ROOM, -5)
        mark = MARKS.get(cell.standing)
        if mark is not None:
            box = QRectF(area.x(), rect.y() + 8, 14, 14)
            icons.paint(painter, mark[0], box, theme.color(mark[1]))
            area.setLeft(area.x() + 20)
        caption = self._caption(index, cell)
        told = cell.text
        if cell.standing in ("missing", "as_is", "own"):
            told = told or model.standing_words(index.data(ROW), cell)
            painter.setFont(face(12))
            painter.setPen(theme.color(mark[1] if mark is not None else "text3"))
        else:
            painter.setFont(face(13))
            painter.setPen(theme.color("text"))
        if caption:
            area.setBottom(area.bottom() - CAPTION)
        wrapped = QTextOption(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        wrapped.setWrapMode(QTextOption.WrapMode.WrapAtWordBoundaryOrAnywhere)
        painter.save()
        painter.setClipRect(area.adjusted(0, -2, 0, 2))
        painter.drawText(area, told, wrapped)
        painter.restore()
        if caption:
            painter.setFont(face(11))
            painter.setPen(theme.color(mark[1] if mark is not None else "text2"))
            below = QRectF(area.x(), area.bottom() + 1, area.width(), CAPTION)
            shown = painter.fontMetrics().elidedText(
                caption, Qt.TextElideMode.ElideRight, int(below.width())
            )
            painter.drawText(below, int(Qt.AlignmentFlag.AlignVCenter), shown)

    # -- editing -----------------------------------------------------------------

    def createEditor(
        self, parent: QWidget, option: QStyleOptionViewItem, index: AnyIndex
    ) -> QWidget:
        made = CellEditor(parent)
        made.setFont(font(13))
        made.tags.offer(self._tags())
        model = index.model()
        title = model.headerData(index.column(), Qt.Orientation.Horizontal)
        made.setAccessibleName(str(title).split(",")[0])
        return made

    def setEditorData(self, editor: QWidget, index: AnyIndex) -> None:
        assert isinstance(editor, CellEditor)
        editor.setPlainText(index.data(Qt.ItemDataRole.EditRole))
        editor.selectAll()

    def setModelData(self, editor: QWidget, model: object, index: AnyIndex) -> None:
        assert isinstance(editor, CellEditor)
        assert isinstance(model, TextsModel)
        model.setData(index, editor.toPlainText())

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, index: AnyIndex
    ) -> None:
        # What is written needs room, more than its cell may have.
        rect = option.rect
        high = max(rect.height(), px(3 * LINE + 12))
        parent = editor.parentWidget()
        below = parent.height() - rect.y() if parent is not None else high
        top = rect.y() if below >= high else max(0, rect.bottom() - high)
        editor.setGeometry(rect.x(), top, rect.width(), high)

    def eventFilter(self, editor: QObject, event: QEvent) -> bool:
        if isinstance(editor, CellEditor) and isinstance(event, QKeyEvent):
            pressed = event.type() == QEvent.Type.KeyPress
            key, held = Qt.Key(event.key()), event.modifiers()
            ends = key in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
            shift = bool(held & Qt.KeyboardModifier.ShiftModifier)
            if pressed and editor.tags.takes(event):
                return True
            if pressed and ends and shift:
                editor.textCursor().insertText("\n")
                return True
            if pressed and (ends or key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab)):
                self.commitData.emit(editor)
                self.closeEditor.emit(editor, QStyledItemDelegate.EndEditHint.NoHint)
                self._went(key, shift)
                return True
        return super().eventFilter(editor, event)
