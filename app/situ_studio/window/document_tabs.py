"""The strip of tabs above the canvas: the open documents."""

from __future__ import annotations

from collections.abc import Collection
from functools import partial

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QMenu, QTabBar, QWidget

from situ_studio.assistive.announcing import soon
from situ_studio.commands.menus import translated
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.tabs import Segments
from situ_studio.views.table import VIEWS
from situ_studio.widgets.icon_widgets import IconButton

READABLE = 168
"""Px that a tab has at least, if its name wants them."""
NARROW = 560
"""Px of the strip below which the views have no words."""
OUT = 24
"""Px outside of the strip from which on a tab is dragged to another place of the window."""


class DocumentBar(QTabBar):
    """Tabs that are dragged to another place, or out of the strip; the middle button closes one."""

    close_asked = Signal(int)
    menu_asked = Signal(int, QPoint)
    resized = Signal()
    pulled = Signal(QPoint)
    """The chosen tab is dragged: to where on the screen."""
    let_go = Signal(str, QPoint)
    """A file's tab was let go outside of the strip: where on the screen."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pressed = -1
        self._dragged = False
        self._out = False
        self.setMovable(True)
        self.setUsesScrollButtons(True)

    def is_out(self, at: QPoint) -> bool:
        """Whether a tab that is dragged to this point of the screen leaves the strip."""
        room = self.rect().adjusted(-OUT, -OUT, OUT, OUT)
        return not room.contains(self.mapFromGlobal(at))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.MiddleButton:
            self._pressed = self.tabAt(event.position().toPoint())
            return
        self._dragged = (
            event.button() == Qt.MouseButton.LeftButton
            and self.tabAt(event.position().toPoint()) >= 0
        )
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not self._dragged:
            super().mouseMoveEvent(event)
            return
        at = event.globalPosition().toPoint()
        self._out = self.is_out(at)
        self.pulled.emit(at)
        if not self._out:
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.MiddleButton:
            if self._pressed >= 0 and self.tabAt(event.position().toPoint()) == self._pressed:
                self.close_asked.emit(self._pressed)
            self._pressed = -1
            return
        super().mouseReleaseEvent(event)
        out, self._out, self._dragged = self._out, False, False
        if out:
            file = self.tabData(self.currentIndex())
            self.let_go.emit(file, event.globalPosition().toPoint())

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        index = self.tabAt(event.pos())
        if index >= 0:
            self.menu_asked.emit(index, event.globalPos())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.resized.emit()

    def minimumTabSizeHint(self, index: int) -> QSize:
        # A name is cut only where it is long: rather fewer tabs are seen than none can be read.
        return self.tabSizeHint(index).boundedTo(QSize(px(READABLE), px(38)))

    def tabLayoutChange(self) -> None:
        super().tabLayoutChange()
        self.resized.emit()

    @property
    def overflows(self) -> bool:
        """Whether not all tabs can be seen at once."""
        wide = sum(self.tabRect(index).width() for index in range(self.count()))
        return wide > self.width()


class DocumentTabs(QFrame):
    """One tab a document, in the order that a person dragged them to. The shown one has a button
    that closes it, each a menu; where not all have room, a list names them all. What is not saved
    has a dot behind its name. At the right, what views the document has.

    The last tab can not be closed while the strip is the only one.
    """

    chosen = Signal(str)
    closed = Signal(str)
    view_chosen = Signal(str)
    beside_asked = Signal(str)
    """A document shall be shown beside this group of tabs."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "tabs")
        self.setFixedHeight(px(36))
        self._theme = theme
        self._looks: dict[str, tuple[str, str]] = {}
        self._words: dict[str, str] = {}
        self._gone: list[tuple[str, int]] = []
        self._only = True
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 8, 0)
        line.setSpacing(8)
        self.bar = DocumentBar()
        self.bar.setProperty("role", "documents")
        self.bar.setAccessibleName(self.tr("Open documents"))
        self.bar.setExpanding(False)
        self.bar.setDrawBase(False)
        self.bar.setIconSize(QSize(px(16), px(16)))
        self.bar.setElideMode(Qt.TextElideMode.ElideRight)
        self.bar.currentChanged.connect(self._on_current)
        self.bar.close_asked.connect(lambda index: self._ask_to_close(self.bar.tabData(index)))
        self.bar.menu_asked.connect(self._on_menu)
        # Within a layout that is being made it would be shown and hidden at once, and be neither.
        self._overflowing = soon(self, self._settle_all)
        self.bar.resized.connect(self._overflowing.start)
        line.addWidget(self.bar, 0, Qt.AlignmentFlag.AlignBottom)
        self.all = IconButton(theme, "down", self.tr("All open documents"), "text2", 14)
        self.all.clicked.connect(self._show_all)
        self.all.hide()
        line.addWidget(self.all)
        line.addStretch(1)
        self.views = Segments(
            theme,
            tuple((view.name, view.icon, translated(view.text)) for view in VIEWS),
            self.tr("View"),
        )
        self.views.chosen.connect(self.view_chosen)
        line.addWidget(self.views)

    def set_only(self, only: bool) -> None:
        """Whether the window has no other strip."""
        self._only = only
        self._settle_close()

    def set_aside(self, aside: bool) -> None:
        """Whether commands go to another strip's document."""
        if self.bar.property("aside") != aside:
            self.bar.setProperty("aside", aside)
            self.bar.style().polish(self.bar)
            self.bar.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.views.set_narrow(self.width() < px(NARROW))

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for index in range(self.bar.count()):
            icon, token = self._looks[self.bar.tabData(index)]
            self.bar.setTabIcon(index, icons.icon(icon, theme.color(token), 16))

    def add(self, file: str, words: str, icon: str, token: str) -> None:
        """One more tab, without choosing it."""
        # What && stands for is shown as & by the tab, and by the menu of all of them.
        self._looks[file], self._words[file] = (icon, token), words.replace("&", "&&")
        self.bar.blockSignals(True)
        index = self.bar.addTab(icons.icon(icon, self._theme.color(token), 16), self._words[file])
        self.bar.setTabData(index, file)
        self.bar.setTabToolTip(index, file)
        self.bar.blockSignals(False)

    def remove(self, file: str) -> None:
        index = self.files().index(file)
        self._gone.append((file, index))
        self.bar.removeTab(index)
        self._settle_close()

    def last_closed(self) -> tuple[str, int] | None:
        """The file whose tab was closed last and its place, which are forgotten by this."""
        return self._gone.pop() if self._gone else None

    @property
    def has_closed(self) -> bool:
        """Whether a tab was closed that is not open again."""
        return any(file not in self.files() for file, _ in self._gone)

    def put(self, file: str, index: int) -> None:
        """Puts the tab of a file at a place, the last one at most."""
        self.bar.moveTab(self.files().index(file), min(index, self.bar.count() - 1))

    def show_unsaved(self, files: Collection[str]) -> None:
        """A dot behind the names of these."""
        for index, file in enumerate(self.files()):
            unsaved = file in files
            text = f"{self._words[file]} •" if unsaved else self._words[file]
            if self.bar.tabText(index) != text:
                self.bar.setTabText(index, text)
                tip = self.tr("{0}, not saved").format(file) if unsaved else file
                self.bar.setTabToolTip(index, tip)

    def clear(self) -> None:
        self._gone = []
        self.bar.blockSignals(True)
        while self.bar.count():
            self.bar.removeTab(0)
        self.bar.blockSignals(False)

    def files(self) -> list[str]:
        return [self.bar.tabData(i) for i in range(self.bar.count())]

    @property
    def chosen_file(self) -> str | None:
        """The file of the chosen tab."""
        index = self.bar.currentIndex()
        return self.bar.tabData(index) if index >= 0 else None

    def step(self, by: int) -> None:
        """Chooses the next tab, round the end."""
        files = self.files()
        if files:
            self.choose(files[(self.bar.currentIndex() + by) % len(files)])

    def choose(self, file: str) -> None:
        """Chooses a tab and tells it, also if it was chosen already."""
        index = self.files().index(file)
        self.bar.blockSignals(True)
        self.bar.setCurrentIndex(index)
        self.bar.blockSignals(False)
        self._on_current(index)

    @property
    def may_close(self) -> bool:
        """Whether a tab can be closed."""
        return self.bar.count() > (1 if self._only else 0)

    def _ask_to_close(self, file: str) -> None:
        if self.may_close:
            self.closed.emit(file)

    def _ask_to_close_all(self, files: list[str]) -> None:
        for file in files:
            self._ask_to_close(file)

    def _on_menu(self, index: int, at: QPoint) -> None:
        file = self.bar.tabData(index)
        others = [other for other in self.files() if other != file]
        menu = self._menu()
        one = menu.addAction(self.tr("Close"))
        one.triggered.connect(lambda: self._ask_to_close(file))
        rest = menu.addAction(self.tr("Close the others"))
        rest.triggered.connect(partial(self._ask_to_close_all, others))
        one.setEnabled(self.may_close)
        rest.setEnabled(bool(others))
        menu.addSeparator()
        beside = menu.addAction(self.tr("Open beside"))
        beside.triggered.connect(lambda: self.beside_asked.emit(file))
        menu.popup(at)

    def _show_all(self) -> None:
        menu = self._menu()
        for index, file in enumerate(self.files()):
            action = menu.addAction(self.bar.tabIcon(index), self.bar.tabText(index))
            action.setCheckable(True)
            action.setChecked(index == self.bar.currentIndex())
            action.triggered.connect(partial(self.choose, file))
        menu.popup(self.all.mapToGlobal(self.all.rect().bottomLeft()))

    def _menu(self) -> QMenu:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        return menu

    def _settle_all(self) -> None:
        self.all.setVisible(self.bar.overflows)

    def _on_current(self, index: int) -> None:
        self._settle_close()
        if index >= 0:
            self.chosen.emit(self.bar.tabData(index))

    def _settle_close(self) -> None:
        """Only the chosen tab has a button that closes it, if it can be closed."""
        side, index = QTabBar.ButtonPosition.RightSide, self.bar.currentIndex()
        for other in range(self.bar.count()):
            unwanted = other != index or not self.may_close
            if unwanted and self.bar.tabButton(other, side) is not None:
                self.bar.setTabButton(other, side, None)
        if index < 0 or not self.may_close:
            return
        file = self.bar.tabData(index)
        if self.bar.tabButton(index, side) is None:
            close = IconButton(self._theme, "close", self.tr("Close"), "text3", 12)
            close.setFixedSize(px(22), px(18))
            close.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            close.clicked.connect(lambda: self.closed.emit(file))
            self.bar.setTabButton(index, side, close)
