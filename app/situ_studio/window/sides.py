"""The middle of the window: one group of tabs with their documents, or two side by side.

Commands, inspector and the other panels follow the group that had the focus last.
"""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QPoint, QRect, Qt, Signal, SignalInstance
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QApplication,
    QHBoxLayout,
    QLabel,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from situ_studio.looks.theme import Theme
from situ_studio.panels.notice import Notice
from situ_studio.views.document_view import DocumentView
from situ_studio.views.showing import Shown
from situ_studio.widgets.breadcrumbs import Breadcrumbs
from situ_studio.window.document_tabs import DocumentTabs

NARROWEST = 240
"""Px that a group of tabs has at least."""


class Group(QWidget):
    """Tabs, the way into the part that the chosen one shows, and the document itself.

    views: by file, made when first shown. ways: a tab's file to the files on the way to what it
    shows, the tab's own first. current_file: what is shown; None where nothing is. waiting: how
    documents will be shown that have no view yet, by file.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.views: dict[str, DocumentView] = {}
        self.ways: dict[str, tuple[str, ...]] = {}
        self.waiting: dict[str, Shown] = {}
        self.current_file: str | None = None
        self.setMinimumWidth(NARROWEST)
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.column.setSpacing(0)
        self.tabs = DocumentTabs(theme)
        self.crumbs = Breadcrumbs(theme)
        self.incomplete = Notice(theme)
        self.documents = QStackedWidget()
        for part in (self.tabs, self.crumbs, self.incomplete):
            self.column.addWidget(part)
        self.column.addWidget(self.documents, 1)
        self.no_document = QLabel(
            self.tr("This project has no document that can be shown. The problems below say why.")
        )
        self.no_document.setProperty("role", "dim")
        self.no_document.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.no_document.setWordWrap(True)
        self.documents.addWidget(self.no_document)

    @property
    def current_view(self) -> DocumentView | None:
        return self.views.get(self.current_file or "")

    def add_view(self, view: DocumentView) -> None:
        self.views[view.file] = view
        self.documents.addWidget(view)

    def drop_view(self, file: str) -> None:
        """Takes the view of a file away, if there is one."""
        view = self.views.pop(file, None)
        if view is not None:
            self.documents.removeWidget(view)
            # Who looks through the window's widgets meanwhile would hold it for ever.
            view.setParent(None)
            view.deleteLater()

    def reset(self) -> None:
        """Nothing is open in it."""
        for file in list(self.views):
            self.drop_view(file)
        while self.documents.count() > 1:
            # A page is made anew where it is shown again.
            page = self.documents.widget(1)
            assert page is not None
            self.documents.removeWidget(page)
            page.setParent(None)
            page.deleteLater()
        self.tabs.clear()
        self.ways.clear()
        self.waiting.clear()
        self.current_file = None
        self.incomplete.hide()

    def set_theme(self, theme: Theme) -> None:
        self.tabs.set_theme(theme)
        self.crumbs.set_theme(theme)


class Landing(QWidget):
    """Where a tab that is dragged would go."""

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self.theme = theme
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def show_at(self, area: QRect) -> None:
        self.setGeometry(area)
        self.setVisible(not area.isEmpty())
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        colour = self.theme.color("accent")
        painter.setPen(colour)
        colour.setAlpha(40)
        painter.setBrush(colour)
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.end()


class Sides(QWidget):
    """One group, or two beside each other; ``current`` is the one that commands go to.

    strips: notices about the whole window, which stand below the first group's tabs.
    """

    entered = Signal()
    """Another group is the current one."""
    chosen = Signal(str)
    closed = Signal(str)
    view_chosen = Signal(str)
    """As ``DocumentTabs`` tells them, of the current group."""
    level_asked = Signal(int)
    """As ``Breadcrumbs`` tells it, of the current group."""
    beside_asked = Signal(str, bool)
    """A document of the current group shall be shown in the other one; whether its tab goes."""

    def __init__(self, theme: Theme, strips: tuple[QWidget, ...]) -> None:
        super().__init__()
        self._theme = theme
        self._strips = strips
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        self.room = QSplitter(Qt.Orientation.Horizontal)
        self.room.setChildrenCollapsible(False)
        line.addWidget(self.room)
        self.groups: list[Group] = []
        self.current = self._made()
        self._place_strips()
        self._landing = Landing(theme, self)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._on_focus)

    @property
    def other(self) -> Group | None:
        """The group that is not the current one."""
        return next((group for group in self.groups if group is not self.current), None)

    def views(self) -> Iterator[DocumentView]:
        """The views of all groups."""
        for group in self.groups:
            yield from group.views.values()

    def views_of(self, file: str) -> list[DocumentView]:
        """The views of one file: none, one, or one in each group."""
        return [view for view in self.views() if view.file == file]

    def sizes(self) -> tuple[int, ...]:
        """The widths of the groups in px."""
        return tuple(self.room.sizes())

    def set_sizes(self, sizes: tuple[int, ...]) -> None:
        if len(sizes) == len(self.groups):
            self.room.setSizes(list(sizes))

    # -- groups ----------------------------------------------------------------------

    def _made(self) -> Group:
        group = Group(self._theme)
        group.tabs.chosen.connect(lambda file: self._from(group, self.chosen, file))
        group.tabs.closed.connect(lambda file: self._from(group, self.closed, file))
        group.tabs.view_chosen.connect(lambda name: self._from(group, self.view_chosen, name))
        group.tabs.beside_asked.connect(
            lambda file: self._from(group, self.beside_asked, file, False)
        )
        group.tabs.bar.pulled.connect(lambda at: self._landing.show_at(self._area(group, at)))
        group.tabs.bar.let_go.connect(lambda file, at: self._on_let_go(group, file, at))
        group.crumbs.asked.connect(lambda level: self._from(group, self.level_asked, level))
        self.groups.append(group)
        self.room.addWidget(group)
        return group

    def _from(self, group: Group, signal: SignalInstance, *told: object) -> None:
        self.enter(group)
        signal.emit(*told)

    def add(self) -> Group:
        """One more group, at the right, with half of the room."""
        group = self._made()
        width = max(2, self.width())
        self.room.setSizes([width // 2, width - width // 2])
        self._settle()
        return group

    def remove(self, group: Group) -> None:
        """Takes one of two groups away with all that is open in it; the other is current."""
        self.groups.remove(group)
        self._place_strips()
        if group is self.current:
            self.current = self.groups[0]
            view = self.current.current_view
            if view is not None and group.isAncestorOf(QApplication.focusWidget() or self):
                view.current_view().setFocus()
        group.reset()
        group.hide()
        group.deleteLater()
        self._settle()
        self.entered.emit()

    def reset(self) -> None:
        """One group, with nothing in it."""
        while len(self.groups) > 1:
            self.remove(self.groups[-1])
        self.current.reset()

    def enter(self, group: Group) -> None:
        """Commands go to this one from now."""
        if group is not self.current and group in self.groups:
            self.current = group
            self._settle()
            self.entered.emit()

    def _on_focus(self, _: QWidget | None, now: QWidget | None) -> None:
        if now is None or len(self.groups) < 2:
            return
        for group in self.groups:
            if group.isAncestorOf(now):
                self.enter(group)
                return

    def _settle(self) -> None:
        two = len(self.groups) > 1
        for group in self.groups:
            group.tabs.set_only(not two)
            group.tabs.set_aside(two and group is not self.current)

    def _place_strips(self) -> None:
        for strip in reversed(self._strips):
            self.groups[0].column.insertWidget(2, strip)

    def set_theme(self, theme: Theme) -> None:
        self._theme = self._landing.theme = theme
        for group in self.groups:
            group.set_theme(theme)

    # -- a tab that is dragged -----------------------------------------------------------

    def _area(self, group: Group, at: QPoint) -> QRect:
        """Where a tab of ``group`` would go that is let go ``at`` a point of the screen."""
        here = self.mapFromGlobal(at)
        if not self.rect().contains(here) or not group.tabs.bar.is_out(at):
            return QRect()
        for other in self.groups:
            area = QRect(other.mapTo(self, QPoint()), other.size())
            if other is not group and area.contains(here):
                return area
        if len(self.groups) == 1 and here.x() > self.width() // 2:
            return self.rect().adjusted(self.width() // 2, 0, 0, 0)
        return QRect()

    def _on_let_go(self, group: Group, file: str, at: QPoint) -> None:
        self._landing.hide()
        if not self._area(group, at).isEmpty():
            self._from(group, self.beside_asked, file, True)
