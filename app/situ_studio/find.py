"""Find anything, run a command (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from msgspec import Struct
from PySide6.QtCore import QEvent, QObject, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import (
    QFrame,
    QLabel,
    QLineEdit,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from situ.document import rbd, spds
from situ_studio import icons, kinds, words
from situ_studio.edit import Document, Place
from situ_studio.panels.lists import AnyIndex
from situ_studio.theme import Theme, font

FOUND = int(Qt.ItemDataRole.UserRole) + 1
MOST = 50
WIDTH = 560


class Find(Struct, frozen=True):
    """Something that can be found: a command to run, or a place to go to."""

    text: str
    icon: str
    token: str
    detail: str
    run: Callable[[], object]
    search: str = ""


def score(query: str, text: str) -> int | None:
    """How well a text fits: 0 is best; None where a word of the query is not in it."""
    text = text.lower()
    query = query.lower().strip()
    if text.startswith(query):
        return 0
    found = 1
    for word in query.split():
        at = text.find(word)
        if at < 0:
            return None
        if at > 0 and text[at - 1].isalnum():
            found += 2
    return found + (text.find(query) < 0)


def places_of(document: Document) -> Iterable[tuple[Place, str, str, str, str]]:
    """Everything in a document that has a name: place, icon, token, text, what else is searched."""
    if isinstance(document, rbd.Application):
        for state in document.states:
            texts = [a.text for a in state.actions if isinstance(a, rbd.Speech)]
            if state.screen is not None:
                texts += [getattr(c, "text", "") for c in state.screen.components]
            token = "start" if state.no == document.start_no else "state"
            yield (
                ("state", state.no),
                token,
                token,
                f"{state.no} {state.name}".strip(),
                " ".join(texts),
            )
            for index, event in enumerate(state.events):
                if event.name:
                    text = f"{event.name} → {words.leads_to(document, event.next)}"
                    place = ("state", state.no, "event", str(index))
                    yield place, "event", "text2", text, f"{state.no} {state.name}"
    elif isinstance(document, spds.Spds):
        for situation in document.situations:
            yield ("situation", situation.name), "situation", "situation", situation.name, ""
        for module in document.modules:
            yield ("module", module.name), "module", "module", module.name, ""
        for data in document.observe:
            yield ("data", data.tag), "data", "data", data.tag, ""
    else:
        for one in document.modules:
            yield ("module", one.name), kinds.INFORMATION.icon, "module", one.name, one.description


class _Delegate(QStyledItemDelegate):
    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self.theme = theme

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(200, 32)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        found: Find = index.data(FOUND)
        rect = QRectF(option.rect)
        state = option.state
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if state & QStyle.StateFlag.State_Selected:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self.theme.color("accent_soft"))
            painter.drawRoundedRect(rect.adjusted(4, 0, -4, 0), 6, 6)
        box = QRectF(rect.x() + 14, rect.center().y() - 8, 16, 16)
        if found.icon:
            icons.paint(painter, found.icon, box, self.theme.color(found.token))
        middle = int(Qt.AlignmentFlag.AlignVCenter)
        painter.setFont(font(12))
        detail = painter.fontMetrics().elidedText(
            found.detail, Qt.TextElideMode.ElideRight, int(rect.width() * 0.45)
        )
        width = painter.fontMetrics().horizontalAdvance(detail)
        painter.setPen(self.theme.color("text3"))
        painter.drawText(
            QRectF(rect.right() - width - 16, rect.y(), width + 2, rect.height()), middle, detail
        )
        painter.setFont(font(13))
        painter.setPen(self.theme.color("text"))
        room = rect.right() - width - 28 - box.right() - 10
        text = painter.fontMetrics().elidedText(found.text, Qt.TextElideMode.ElideRight, int(room))
        painter.drawText(QRectF(box.right() + 10, rect.y(), room, rect.height()), middle, text)
        painter.restore()


class FindAnything(QFrame):
    """Lies over the window below the toolbar; Esc or a click elsewhere closes it."""

    closed = Signal()

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "popup")
        self.setAccessibleName(self.tr("Find anything, run a command"))
        self._window = parent
        self._every: list[Find] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(8)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Find anything, run a command"))
        self.field.setAccessibleName(self.tr("What to find or run"))
        self.field.textChanged.connect(self._filter)
        self.field.installEventFilter(self)
        column.addWidget(self.field)
        self.list = QListView()
        self.list.setAccessibleName(self.tr("Found"))
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self._delegate = _Delegate(theme, self.list)
        self.list.setItemDelegate(self._delegate)
        self._model = QStandardItemModel(self)
        self.list.setModel(self._model)
        self.list.clicked.connect(lambda index: self._run(index.data(FOUND)))
        column.addWidget(self.list, 1)
        self.nothing = QLabel(self.tr("Nothing here has that in its name or text."))
        self.nothing.setProperty("role", "dim")
        self.nothing.setContentsMargins(8, 4, 8, 8)
        column.addWidget(self.nothing)
        column.addStretch(0)
        self.hide()

    def set_theme(self, theme: Theme) -> None:
        self._delegate.theme = theme

    def open(self, every: list[Find]) -> None:
        """Shows itself with everything that can be found."""
        self._every = every
        width = min(WIDTH, self._window.width() - 32)
        self.setGeometry((self._window.width() - width) // 2, 64, width, 400)
        self.field.clear()
        self._filter("")
        self.show()
        self.raise_()
        self.field.setFocus()

    def _filter(self, query: str) -> None:
        scored = []
        for position, one in enumerate(self._every):
            found = score(query, one.text)
            if found is None and one.search:
                beside = score(query, f"{one.text} {one.search}")
                found = beside + 10 if beside is not None else None
            if found is not None:
                scored.append((found, position, one))
        self._model.clear()
        if query:
            # Of what fits equally well the shorter one is meant, and commands stand first.
            scored.sort(key=lambda s: (s[0], len(s[2].text), s[1]))
        for _, _, one in scored[:MOST]:
            item = QStandardItem(one.text)
            item.setData(one, FOUND)
            item.setAccessibleText(f"{one.text} {one.detail}".strip())
            self._model.appendRow(item)
        self.list.setVisible(self._model.rowCount() > 0)
        self.nothing.setVisible(self._model.rowCount() == 0)
        if self._model.rowCount():
            self.list.setCurrentIndex(self._model.index(0, 0))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FocusOut and self.isVisible():
            self._close()
            return False
        if event.type() != QEvent.Type.KeyPress or not isinstance(event, QKeyEvent):
            return False
        key = event.key()
        if key == Qt.Key.Key_Escape:
            self._close()
            return True
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            index = self.list.currentIndex()
            if index.isValid():
                self._run(index.data(FOUND))
            return True
        if key in (Qt.Key.Key_Down, Qt.Key.Key_Up):
            step = 1 if key == Qt.Key.Key_Down else -1
            row = min(max(self.list.currentIndex().row() + step, 0), self._model.rowCount() - 1)
            self.list.setCurrentIndex(self._model.index(row, 0))
            return True
        return False

    def _run(self, found: Find) -> None:
        self._close()
        found.run()

    def _close(self) -> None:
        if self.isVisible():
            self.hide()
            self.closed.emit()
