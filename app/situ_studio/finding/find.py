"""Find anything, run a command (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

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
from situ_studio import kinds
from situ_studio.assistive.announcing import CurrentRow
from situ_studio.edits import words
from situ_studio.edits.edit import Document, Place
from situ_studio.looks import icons
from situ_studio.looks.letters import enlarged, px
from situ_studio.looks.theme import Theme, face
from situ_studio.panels.lists import AnyIndex

FOUND = int(Qt.ItemDataRole.UserRole) + 1
MOST = 50
WIDTH = 560
APART = 20


class Find(Struct, frozen=True):
    """Something that can be found: a command to run, or a place to go to.

    command: its id. why: the command can not be done now; it is pale, at the end, and ``run``
    says why.
    """

    text: str
    icon: str
    token: str
    detail: str
    run: Callable[[], object]
    search: str = ""
    command: str = ""
    why: str = ""


def letters(query: str, text: str) -> int | None:
    """How well a text has a query's letters in their order; None where it has not.

    2 where each follows the one before or begins a word (``zi``, ``zoin``: Zoom in), else
    the more the further they lie apart, from ``APART``.
    """
    wanted = "".join(query.lower().split())
    text = text.lower()
    begins = [i for i, c in enumerate(text) if c.isalnum() and not (i and text[i - 1].isalnum())]
    reached: set[int] = {i for i in begins if text[i] == wanted[:1]}
    for letter in wanted[1:]:
        first = min(reached, default=len(text))
        next_to = {i + 1 for i in reached if text[i + 1 : i + 2] == letter}
        reached = next_to | {i for i in begins if i > first and text[i] == letter}
    if reached:
        return 2
    at = start = text.find(wanted[:1])
    for letter in wanted[1:]:
        at = text.find(letter, at + 1) if at >= 0 else -1
    return None if at < 0 else APART + at - start + 1 - len(wanted)


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
                words.state_called(state.no, state.name),
                " ".join(texts),
            )
            for index, event in enumerate(state.events):
                if event.name:
                    text = f"{event.name} → {words.leads_to(document, event.next)}"
                    place = ("state", state.no, "event", str(index))
                    yield place, "event", "text2", text, words.state_called(state.no, state.name)
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
        return QSize(px(200), px(32))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._paint(painter, rect, option.state, index.data(FOUND))

    def _paint(self, painter: QPainter, rect: QRectF, state: QStyle.StateFlag, found: Find) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if state & QStyle.StateFlag.State_Selected:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self.theme.color("accent_soft"))
            painter.drawRoundedRect(rect.adjusted(4, 0, -4, 0), 6, 6)
        box = QRectF(rect.x() + 14, rect.center().y() - 8, 16, 16)
        if found.icon:
            token = "text3" if found.why else found.token
            icons.paint(painter, found.icon, box, self.theme.color(token))
        middle = int(Qt.AlignmentFlag.AlignVCenter)
        painter.setFont(face(12))
        detail = painter.fontMetrics().elidedText(
            found.detail, Qt.TextElideMode.ElideRight, int(rect.width() * 0.45)
        )
        width = painter.fontMetrics().horizontalAdvance(detail)
        painter.setPen(self.theme.color("text3"))
        painter.drawText(
            QRectF(rect.right() - width - 16, rect.y(), width + 2, rect.height()), middle, detail
        )
        painter.setFont(face(13))
        painter.setPen(self.theme.color("text3" if found.why else "text"))
        room = rect.right() - width - 28 - box.right() - 10
        text = painter.fontMetrics().elidedText(found.text, Qt.TextElideMode.ElideRight, int(room))
        painter.drawText(QRectF(box.right() + 10, rect.y(), room, rect.height()), middle, text)


class FindAnything(QFrame):
    """Lies over the window below the toolbar; Esc or a click elsewhere closes it."""

    closed = Signal()

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "popup")
        self.setAccessibleName(self.tr("Find anything, run a command"))
        self._window = parent
        self._every: list[Find] = []
        self._used: Sequence[str] = ()
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
        self.current_row = CurrentRow(self.list)
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

    def open(self, every: list[Find], used: Sequence[str] = ()) -> None:
        """Shows itself with everything that can be found.

        used: ids of the commands that were used lately, the last one first.
        """
        self._every = every
        self._used = used
        width = min(px(WIDTH), self._window.width() - 32)
        self.setGeometry((self._window.width() - width) // 2, 64, width, 400)
        self.field.clear()
        self._filter("")
        self.show()
        self.raise_()
        self.field.setFocus()

    def _filter(self, query: str) -> None:
        scored = []
        for position, one in enumerate(self._every):
            every = [score(query, one.text)]
            if query.strip():
                every.append(letters(query, one.text))
            if one.search:
                beside = score(query, f"{one.text} {one.search}")
                every.append(beside + 10 if beside is not None else None)
            fits = [found for found in every if found is not None]
            if fits:
                scored.append((min(fits), position, one))
        # Letters that lie apart are meant only where nothing fits better.
        if any(s[0] < APART for s in scored):
            scored = [s for s in scored if s[0] < APART]
        self._model.clear()
        if query:
            # Of what fits equally well what was used lately is meant, then the shorter one, and
            # commands stand first.
            scored.sort(key=lambda s: (s[0], self._lately(s[2]), len(s[2].text), s[1]))
        else:
            scored.sort(key=lambda s: (self._lately(s[2]), s[1]))
        can = [s for s in scored if not s[2].why][:MOST]
        for _, _, one in can + [s for s in scored if s[2].why]:
            item = QStandardItem(one.text)
            item.setData(one, FOUND)
            item.setAccessibleText(f"{one.text} {one.detail}".strip())
            self._model.appendRow(item)
        self.list.setVisible(self._model.rowCount() > 0)
        self.nothing.setVisible(self._model.rowCount() == 0)
        if self._model.rowCount():
            self.list.setCurrentIndex(self._model.index(0, 0))

    def _lately(self, one: Find) -> int:
        """0 for the command that was used last; places and others stand behind all of those."""
        used = self._used
        return used.index(one.command) if one.command in used else len(used)

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
