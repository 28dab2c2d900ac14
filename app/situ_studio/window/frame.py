"""The window's frame: panels round the canvas, toolbar, menus, looks. It knows no document."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from PySide6.QtCore import QByteArray, QEvent, QSettings, QSize, Qt, Signal
from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QSizePolicy,
    QStackedWidget,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from situ_studio.actions import command
from situ_studio.assistive import tab_order
from situ_studio.commands.keys import Keys
from situ_studio.commands.menu_bar import MenuBar
from situ_studio.commands.menus import Actions
from situ_studio.finding.find import FindAnything
from situ_studio.help.help_texts import explained
from situ_studio.help.help_topics import HELP
from situ_studio.looks.letters import px
from situ_studio.looks.theme import DARK, LIGHT, Theme
from situ_studio.looks.theme_qss import palette, qss
from situ_studio.panels.fields import Choice, Flag
from situ_studio.panels.header import PanelHeader, TitleBar
from situ_studio.panels.inspector import Inspector
from situ_studio.panels.notice import Notice
from situ_studio.panels.outline import Outline
from situ_studio.panels.palette import Palette, PaletteRoom
from situ_studio.panels.problems import Problems
from situ_studio.panels.project_tree import ProjectTree
from situ_studio.panels.tabs import BottomPanels
from situ_studio.views.document_view import DocumentView
from situ_studio.welcome import recent
from situ_studio.welcome.page import Welcome
from situ_studio.widgets.breadcrumbs import Breadcrumbs
from situ_studio.widgets.icon_widgets import IconButton, ThemedButton, retheme
from situ_studio.window.docking import FOLDED, Docking
from situ_studio.window.document_tabs import DocumentTabs
from situ_studio.window.left_place import LeftPlace
from situ_studio.window.sides import Sides
from situ_studio.window.status import Status

LEFT, RIGHT, BOTTOM = 224, 280, 132
LEFT_SMALL, RIGHT_SMALL = 208, 264
LOW = 1000
"""Px of the window's height below which rows are denser."""
LOWER = 640
"""Px below which not everything at the left has room."""
ROBOT_PANEL = 232
"""Px that a panel with the robot's tables wants."""


class Frame(QMainWindow):
    """Everything that the window shows, with nothing in it yet.

    settings: where it was, and which colours were chosen.
    """

    looks_changed = Signal()
    """The desktop has other letters or colours."""

    def __init__(self, settings: QSettings, theme: str | None) -> None:
        super().__init__()
        self.settings = settings
        self.theme_choice = theme or str(settings.value("theme", "system"))
        self.theme = self._chosen_theme()
        self.docking = Docking(self)
        self.left_place = LeftPlace(self, self.docking.docks, ("designer", "moment"))
        self._bottom_high = px(BOTTOM)
        self.setWindowTitle(self.tr("Situ Studio"))
        self.setMinimumSize(800, 500)
        self.setDockOptions(
            QMainWindow.DockOption.AnimatedDocks
            | QMainWindow.DockOption.AllowNestedDocks
            | QMainWindow.DockOption.AllowTabbedDocks
        )
        for corner, area in (
            (Qt.Corner.BottomLeftCorner, Qt.DockWidgetArea.LeftDockWidgetArea),
            (Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea),
        ):
            self.setCorner(corner, area)
        self._build_centre()
        self._build_panels()
        self.status = Status(self.theme)
        self.setStatusBar(self.status)
        self.finder = FindAnything(self.theme, self)
        self.bottom.folded.connect(self._on_folded)
        self.bottom.chosen.connect(self._on_bottom)
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._on_scheme)

    def add_commands(self, actions: Actions) -> None:
        """Menus and toolbar, from the table of commands."""
        self.actions_ = actions
        self.keys = Keys(self.settings)
        actions.set_keys(self.keys.every())
        actions.used.connect(partial(recent.used, self.settings))
        self.setMenuBar(MenuBar(self))
        actions.fill_menus(self.menuBar())
        self._fill_panels_menu()
        self._build_toolbar()
        self.docking.begin()

    @property
    def docks(self) -> dict[str, QDockWidget]:
        """The panels' docks by name."""
        return self.docking.docks

    @property
    def tabs(self) -> DocumentTabs:
        """Of the current group."""
        return self.sides.current.tabs

    @property
    def crumbs(self) -> Breadcrumbs:
        """Of the current group."""
        return self.sides.current.crumbs

    @property
    def documents(self) -> QStackedWidget:
        """Of the current group."""
        return self.sides.current.documents

    @property
    def incomplete(self) -> Notice:
        """Of the current group."""
        return self.sides.current.incomplete

    # -- building ------------------------------------------------------------------

    def _build_centre(self) -> None:
        self.stack = QStackedWidget()
        self.welcome = Welcome(self.theme)
        self.stack.addWidget(self.welcome)
        centre = QWidget()
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.recovered = Notice(self.theme)
        self.notice = Notice(self.theme)
        self.sides = Sides(self.theme, (self.recovered, self.notice))
        column.addWidget(self.sides)
        self.stack.addWidget(centre)
        self.setCentralWidget(self.stack)

    def _build_panels(self) -> None:
        theme = self.theme
        left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        self.project_tree = ProjectTree(theme)
        self.outline = Outline(theme)
        self.palette_ = Palette(theme)
        self.inspector = Inspector(theme)
        self.problems = Problems(theme)
        self.bottom = BottomPanels(theme)
        self.bottom.add("problems", self.tr("Problems"), self.problems)
        headers = {
            "project": PanelHeader(self.tr("Project")),
            "outline": PanelHeader(self.tr("Outline")),
            "palette": PanelHeader(self.tr("Palette"), self.tr("drag onto the canvas")),
        }
        search = IconButton(theme, "search", self.tr("Find in the outline"), "text3", 14)
        search.clicked.connect(self.outline.toggle_search)
        headers["outline"].add(search)
        self.headers = headers
        self._palette_room = PaletteRoom(self.palette_)
        sides: tuple[tuple[str, QWidget], ...] = (
            ("project", self.project_tree),
            ("outline", self.outline),
            ("palette", self._palette_room),
        )
        for name, widget in sides:
            self.docking.add(name, headers[name].title.text(), widget, headers[name], left)
        self.designer_stack = QStackedWidget()
        self.docking.add(
            "designer",
            self.tr("What is on the screen"),
            self.designer_stack,
            TitleBar(0),
            left,
        )
        self.docks["designer"].hide()
        self.docking.add(
            "inspector", self.tr("Inspector"), self.inspector, self.inspector.header, right
        )
        self.docking.add(
            "bottom",
            self.tr("Problems and more"),
            self.bottom,
            self.bottom.strip,
            Qt.DockWidgetArea.BottomDockWidgetArea,
        )

    def _fill_panels_menu(self) -> None:
        menu = self.actions_.menu("View").addMenu(self.tr("Panels"))
        for dock in self.docks.values():
            action = dock.toggleViewAction()
            action.setText(dock.windowTitle())
            menu.addAction(action)

    def _build_toolbar(self) -> None:
        bar = QToolBar(self.tr("Toolbar"))
        bar.setObjectName("toolbar")
        bar.setMovable(False)
        bar.setFloatable(False)
        bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        bar.setFixedHeight(px(40))
        # A toolbar gives its buttons its own size when it is shown; that of the desktop is larger.
        bar.setIconSize(QSize(px(18), px(18)))
        self.addToolBar(Qt.ToolBarArea.TopToolBarArea, bar)
        self.toolbar = bar
        self.actions_.fill_toolbar(bar, "left")
        bar.addWidget(_spring())
        self.search = ThemedButton(
            self.theme,
            "search",
            self.tr("Find anything, run a command"),
            "search",
            "text3",
            14,
        )
        self.search.setToolTip(explained(command("find")))
        self.search.setProperty(HELP, "command/find")
        self.search.setFixedWidth(px(304))
        line = QHBoxLayout(self.search)
        line.setContentsMargins(0, 0, 7, 0)
        line.addStretch(1)
        self.search_keys = QLabel()
        self.search_keys.setProperty("role", "kbd")
        self.search_keys.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        line.addWidget(self.search_keys, 0, Qt.AlignmentFlag.AlignVCenter)
        self._tell_search_keys()
        bar.addWidget(self.search)
        bar.addWidget(_spring())
        self.actions_.fill_toolbar(bar, "right")

    def settle_keys(self) -> None:
        """The commands have the keys that the settings say now."""
        self.actions_.set_keys(self.keys.every())
        self._tell_search_keys()

    def _tell_search_keys(self) -> None:
        key = self.actions_.actions["find"].shortcut().toString()
        self.search_keys.setText(key.replace("+", " "))

    # -- the focus ----------------------------------------------------------------------------

    @property
    def panels_in_order(self) -> tuple[QWidget, ...]:
        """From the toolbar by the left, the middle and the right to the lower edge."""
        sides = ("project", "outline", "palette")
        left = (w for name in sides for w in (self.headers[name], self.docks[name].widget()))
        return (
            self.toolbar,
            *left,
            self.designer_stack,
            *(self.docks["moment"].titleBarWidget(), self.docks["moment"].widget()),
            self.welcome,
            *self._middle_in_order(),
            *(self.inspector.header, self.inspector),
            *(self.docks["rehearsal"].titleBarWidget(), self.docks["rehearsal"].widget()),
            *(self.bottom.strip, self.bottom),
            self.status,
        )

    def _middle_in_order(self) -> Iterator[QWidget]:
        for group in self.sides.groups:
            yield group.tabs
            if group is self.sides.groups[0]:
                yield from (self.recovered, self.notice)
            shown = group.documents.currentWidget()
            pieces = shown.shown_pieces if isinstance(shown, DocumentView) else ()
            yield from (group.incomplete, *(pieces or (group.documents,)))

    def focusNextPrevChild(self, next: bool) -> bool:
        return tab_order.next_stop(self.panels_in_order, self.documents, 1 if next else -1)

    def next_panel(self, way: int) -> None:
        """The focus goes to the next panel (1), or to the one before (-1)."""
        tab_order.next_panel(self.panels_in_order, way)

    # -- looks --------------------------------------------------------------------------------

    def _chosen_theme(self) -> Theme:
        if self.theme_choice == "system":
            scheme = QGuiApplication.styleHints().colorScheme()
            return DARK if scheme == Qt.ColorScheme.Dark else LIGHT
        return DARK if self.theme_choice == "dark" else LIGHT

    def choose_theme(self, choice: str) -> None:
        """``system``, ``light`` or ``dark``; kept for the next time."""
        self.theme_choice = choice
        self.settings.setValue("theme", choice)
        self.welcome.themes.show_choice(choice)
        self.set_theme(self._chosen_theme())

    def _on_scheme(self, scheme: Qt.ColorScheme) -> None:
        if self.theme_choice == "system":
            self.set_theme(DARK if scheme == Qt.ColorScheme.Dark else LIGHT)

    def set_theme(self, theme: Theme) -> None:
        """Every widget of the window takes the theme."""
        self.theme = theme
        QApplication.setPalette(palette(theme))
        self.setStyleSheet(qss(theme))
        self.actions_.set_theme(theme)
        retheme(self, theme)
        for choice in self.findChildren(Choice):
            choice.set_theme(theme)
        for flag in self.findChildren(Flag):
            flag.set_theme(theme)
        panels: tuple[Any, ...] = (
            self.project_tree,
            self.outline,
            self.palette_,
            self.inspector,
            self.problems,
            self.sides,
            self.bottom,
            self.welcome,
            self.finder,
        )
        for panel in panels:
            panel.set_theme(theme)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.DevicePixelRatioChange and hasattr(self, "actions_"):
            # The icons hold pictures for the screens that there were.
            self.set_theme(self.theme)
        if event.type() == QEvent.Type.ThemeChange:
            self.looks_changed.emit()
        if event.type() == QEvent.Type.MouseButtonPress:
            self.docking.watch(event)
        handled = super().event(event)
        if event.type() == QEvent.Type.MouseButtonRelease:
            self.docking.watch(event)
        return handled

    def size_docks(self) -> None:
        """The panels' usual sizes, unless a person has changed them before."""
        if self.docking.sized:
            return
        small = self.width() < px(1360)
        horizontal, vertical = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        self.resizeDocks(
            [self.docks["project"], self.docks["inspector"]],
            [px(LEFT_SMALL if small else LEFT), px(RIGHT_SMALL if small else RIGHT)],
            horizontal,
        )
        tree = self.project_tree.height_wanted() + px(32)
        self.resizeDocks(
            [self.docks["project"], self.docks["outline"], self.docks["palette"]],
            [tree, 10000, self.palette_.height() + px(32)],
            vertical,
        )
        # Large letters leave a low window's middle its room.
        below = min(px(BOTTOM), max(BOTTOM, self.height() // 6))
        self.resizeDocks([self.docks["bottom"]], [below], vertical)

    def _on_bottom(self, name: str) -> None:
        """Tables of what a robot tells want more room than problems and what was found do."""
        if name not in ("problems", "find") and self.docks["bottom"].height() < px(ROBOT_PANEL):
            room = min(px(ROBOT_PANEL), self.height() // 3)
            self.resizeDocks([self.docks["bottom"]], [room], Qt.Orientation.Vertical)

    def _on_folded(self, folded: bool) -> None:
        """What is unfolded is as high as it was."""
        dock = self.docks["bottom"]
        if folded:
            self._bottom_high = max(px(BOTTOM), dock.height())
        else:
            self.resizeDocks([dock], [self._bottom_high], Qt.Orientation.Vertical)

    def reset_layout(self) -> None:
        """Panels where they lie at first, of their usual sizes."""
        self.docking.reset()
        self.bottom.set_folded(False)
        self._bottom_high = px(BOTTOM)
        self.size_docks()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.palette_.set_dense(self.height() < px(LOW))
        self._palette_room.set_low(self.height() < px(LOWER))
        if self.stack.currentIndex() == 1:
            self.size_docks()

    def restore(self) -> None:
        """Puts the window and its panels where they were."""
        geometry = self.settings.value("geometry")
        self.resize(1440, 900)
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)
        self.docking.restore(self.settings)
        if self.settings.value(FOLDED, False, bool):
            self.bottom.set_folded(True)

    def keep(self) -> None:
        """Keeps where the window and its panels are."""
        self.settings.setValue("geometry", self.saveGeometry())
        self.docking.keep(self.settings)
        self.settings.setValue(FOLDED, self.bottom.is_folded)


def _spring() -> QWidget:
    widget = QWidget()
    widget.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    return widget
