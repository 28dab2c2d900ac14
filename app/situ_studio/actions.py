"""Every command of the studio in one table.

Menus, toolbar, shortcuts and the command palette are made from it. A command's
handler is a method of ``commands.Commands``, its ``when`` a method of the same
that says whether it can be done now.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from msgspec import Struct
from PySide6.QtCore import QCoreApplication, QObject, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu, QMenuBar, QToolBar, QToolButton, QWidget

from situ_studio import icons, kinds
from situ_studio.theme import Theme


class Command(Struct, frozen=True, kw_only=True):
    """One command.

    menu: the menu's title, with the submenu's behind ``/``; "": in no menu.
    toolbar: at the left or right end of the toolbar; outlined buttons show their text.
    when: must hold for the command to be enabled; shown: for it to be there at all.
    choice: commands of one choice are exclusive and checkable, ``checked`` says which one is.
    rule: a line stands before it, in its menu and in the toolbar.
    argument: given to the handler, if not None.
    """

    id: str
    text: str
    handler: str
    icon: str = ""
    shortcut: str = ""
    menu: str = ""
    toolbar: Literal["", "left", "right"] = ""
    outlined: bool = False
    when: str = ""
    shown: str = ""
    choice: str = ""
    checked: str = ""
    rule: bool = False
    argument: Any = None
    tip: str = ""


def _c(id: str, text: str, handler: str, **rest: Any) -> Command:
    return Command(id=id, text=text, handler=handler, **rest)


_INSERT = tuple(
    _c(
        f"insert.{kind.name}",
        kind.title,
        "insert",
        icon=kind.icon,
        menu="Insert",
        when=f"can_insert_{part}",
        shown=f"offers_{part}",
        argument=kind.name,
        rule=index == 0 and part != "application",
        tip=kind.help,
    )
    for part in ("application", "action", "screen", "script", "modules")
    for index, kind in enumerate(k for k in kinds.KINDS if k.palette == part)
)

COMMANDS: tuple[Command, ...] = (
    _c("new", "New project…", "new_project", icon="plus", shortcut="Ctrl+N", menu="File"),
    _c("open", "Open a project…", "open_project", icon="folder", shortcut="Ctrl+O", menu="File"),
    _c("welcome", "Welcome page", "show_welcome", menu="File"),
    _c(
        "save",
        "Save",
        "save",
        icon="save",
        shortcut="Ctrl+S",
        menu="File",
        toolbar="left",
        when="has_project",
        rule=True,
    ),
    _c(
        "close_tab",
        "Close tab",
        "close_tab",
        shortcut="Ctrl+W",
        menu="File",
        when="has_document",
        rule=True,
    ),
    _c("quit", "Quit", "quit", shortcut="Ctrl+Q", menu="File", rule=True),
    _c(
        "undo",
        "Undo",
        "undo",
        icon="undo",
        shortcut="Ctrl+Z",
        menu="Edit",
        toolbar="left",
        when="can_undo",
        rule=True,
    ),
    _c(
        "redo",
        "Redo",
        "redo",
        icon="redo",
        shortcut="Ctrl+Shift+Z",
        menu="Edit",
        toolbar="left",
        when="can_redo",
    ),
    _c(
        "cut",
        "Cut",
        "cut",
        shortcut="Ctrl+X",
        menu="Edit",
        when="can_cut",
        rule=True,
    ),
    _c(
        "copy",
        "Copy",
        "on_view",
        argument="copy",
        shortcut="Ctrl+C",
        menu="Edit",
        when="can_copy",
    ),
    _c(
        "paste",
        "Paste",
        "on_view",
        argument="paste",
        shortcut="Ctrl+V",
        menu="Edit",
        when="can_paste",
    ),
    _c(
        "duplicate",
        "Duplicate",
        "on_view",
        argument="duplicate",
        shortcut="Ctrl+D",
        menu="Edit",
        when="can_duplicate",
    ),
    _c("delete", "Delete", "delete", shortcut="Del", menu="Edit", when="has_selection"),
    _c("rename", "Rename", "rename", shortcut="F2", menu="Edit", when="has_selection"),
    _c(
        "select_all",
        "Select all",
        "on_view",
        argument="select_all",
        shortcut="Ctrl+A",
        menu="Edit",
        when="has_document",
        rule=True,
    ),
    _c(
        "find",
        "Find anything, run a command…",
        "find",
        icon="search",
        shortcut="Ctrl+K",
        menu="Edit",
        rule=True,
    ),
    _c("find_here", "Find in the outline", "find_here", shortcut="Ctrl+F", menu="Edit"),
    _c(
        "view.graph",
        "Graph",
        "show_view",
        argument="graph",
        icon="graph",
        shortcut="Ctrl+1",
        menu="View",
        when="has_graph",
        choice="view",
        checked="shows_view",
    ),
    _c(
        "view.outline",
        "Outline",
        "show_view",
        argument="outline",
        icon="table",
        shortcut="Ctrl+2",
        menu="View",
        when="has_document",
        choice="view",
        checked="shows_view",
    ),
    _c(
        "zoom_in",
        "Zoom in",
        "zoom_by",
        argument=1.25,
        icon="plus",
        shortcut="Ctrl++",
        menu="View",
        when="on_graph",
        rule=True,
    ),
    _c(
        "zoom_out",
        "Zoom out",
        "zoom_by",
        argument=0.8,
        icon="minus",
        shortcut="Ctrl+-",
        menu="View",
        when="on_graph",
    ),
    _c(
        "zoom_100",
        "Actual size",
        "zoom_to_actual_size",
        shortcut="Ctrl+0",
        menu="View",
        when="on_graph",
    ),
    _c(
        "zoom_fit",
        "Show everything",
        "on_view",
        argument="zoom_to_fit",
        icon="fit",
        shortcut="Ctrl+9",
        menu="View",
        when="on_graph",
    ),
    _c(
        "zoom_selection",
        "Show the selection",
        "zoom_to_selection",
        shortcut="Ctrl+8",
        menu="View",
        when="has_selection",
    ),
    _c(
        "part.enter",
        "Into the part",
        "enter_part",
        icon="part",
        shortcut="Alt+Right",
        menu="View",
        when="can_enter_part",
        rule=True,
        tip="Shows the application that the selected state runs.",
    ),
    _c(
        "part.leave",
        "Back out of the part",
        "leave_part",
        icon="undo",
        shortcut="Alt+Left",
        menu="View",
        when="can_leave_part",
    ),
    _c(
        "theme.system",
        "Like the system",
        "choose_theme",
        argument="system",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    _c(
        "theme.light",
        "Light",
        "choose_theme",
        argument="light",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    _c(
        "theme.dark",
        "Dark",
        "choose_theme",
        argument="dark",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    _c(
        "next_panel",
        "Next panel",
        "next_panel",
        argument=1,
        shortcut="F6",
        menu="View",
        rule=True,
    ),
    _c(
        "previous_panel",
        "Panel before",
        "next_panel",
        argument=-1,
        shortcut="Shift+F6",
        menu="View",
    ),
    *_INSERT,
    _c(
        "align.left",
        "Align left edges",
        "align",
        argument="left",
        icon="align_left",
        menu="Arrange",
        toolbar="left",
        when="can_align",
        rule=True,
    ),
    _c(
        "align.top",
        "Align upper edges",
        "align",
        argument="top",
        icon="align_top",
        menu="Arrange",
        when="can_align",
    ),
    _c(
        "distribute",
        "Distribute evenly",
        "align",
        argument="distribute",
        icon="distribute",
        menu="Arrange",
        toolbar="left",
        when="can_align",
    ),
    _c(
        "layout",
        "Arrange by itself",
        "on_view",
        argument="auto_layout",
        icon="graph",
        shortcut="Ctrl+L",
        menu="Arrange",
        toolbar="left",
        when="can_auto_layout",
        rule=True,
        tip="Moves every card to a place where the arrows are easy to follow.",
    ),
    _c(
        "part.make",
        "Make a part…",
        "make_part",
        icon="part",
        shortcut="Ctrl+G",
        menu="Arrange",
        when="can_make_part",
        rule=True,
        tip="The selected states become an application of their own, which one state runs.",
    ),
    _c(
        "connect",
        "Connect",
        "connect_robot",
        icon="unlink",
        shortcut="Ctrl+R",
        menu="Robot",
        toolbar="right",
        outlined=True,
        shown="can_connect",
        tip="Follow a robot live.",
    ),
    _c(
        "disconnect",
        "Disconnect",
        "disconnect_robot",
        icon="unlink",
        menu="Robot",
        toolbar="right",
        outlined=True,
        shown="is_connected",
    ),
    _c("about", "About Situ Studio", "about", menu="Help"),
)

MENUS = ("File", "Edit", "View", "Insert", "Arrange", "Robot", "Help")


def translated(text: str) -> str:
    """A text of the table in the user's language."""
    return QCoreApplication.translate("actions", text) if text else ""


class Actions(QObject):
    """The table as QActions of one window.

    handlers: has every method that the table names.
    """

    def __init__(self, handlers: object, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self._handlers = handlers
        self._theme = theme
        self._menus: dict[str, QMenu] = {}
        self._groups: dict[str, QActionGroup] = {}
        self.actions: dict[str, QAction] = {}
        for command in COMMANDS:
            self.actions[command.id] = self._action(command, parent)
        self.set_theme(theme)

    def _action(self, command: Command, parent: QWidget) -> QAction:
        action = QAction(translated(command.text), parent)
        action.setObjectName(command.id)
        if command.shortcut:
            action.setShortcut(QKeySequence(command.shortcut))
        if command.tip:
            action.setToolTip(translated(command.tip))
        handler: Callable[..., Any] = getattr(self._handlers, command.handler)
        if command.argument is None:
            action.triggered.connect(lambda _=False: handler())
        else:
            action.triggered.connect(lambda _=False: handler(command.argument))
        if command.choice:
            action.setCheckable(True)
            group = self._groups.setdefault(command.choice, QActionGroup(self))
            group.addAction(action)
        parent.addAction(action)
        return action

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for command in COMMANDS:
            if command.icon:
                made = icons.icon(command.icon, theme.color("text2"), 18)
                self.actions[command.id].setIcon(made)

    def refresh(self) -> None:
        """Enables, shows and checks every command as it can be done now."""
        for command in COMMANDS:
            action = self.actions[command.id]
            if command.shown:
                action.setVisible(bool(getattr(self._handlers, command.shown)()))
            if command.when:
                action.setEnabled(bool(getattr(self._handlers, command.when)()))
            if command.checked:
                action.setChecked(bool(getattr(self._handlers, command.checked)(command.argument)))

    def fill_menus(self, bar: QMenuBar) -> None:
        """Makes the menus; one without a visible command is not shown."""
        for title in MENUS:
            self._menu(title, bar)
        for command in COMMANDS:
            if not command.menu:
                continue
            menu = self._menu(command.menu, bar)
            if command.rule and not menu.isEmpty():
                menu.addSeparator()
            menu.addAction(self.actions[command.id])
        for menu in self._menus.values():
            menu.aboutToShow.connect(self.refresh)

    def menu(self, title: str) -> QMenu:
        """A menu by its title in the table."""
        return self._menus[title]

    def _menu(self, title: str, bar: QMenuBar) -> QMenu:
        if title in self._menus:
            return self._menus[title]
        head, _, tail = title.rpartition("/")
        parent: QMenuBar | QMenu = self._menu(head, bar) if head else bar
        if head:
            parent.addSeparator()
        menu = parent.addMenu(translated(tail))
        menu.setToolTipsVisible(True)
        self._menus[title] = menu
        return menu

    def show_menus(self) -> None:
        """Hides the menus in which nothing is visible."""
        for title, menu in self._menus.items():
            if "/" not in title:
                there = any(a.isVisible() and not a.isSeparator() for a in menu.actions())
                menu.menuAction().setVisible(there)

    def fill_toolbar(self, bar: QToolBar, end: Literal["left", "right"]) -> None:
        """Puts the commands of one end into the toolbar."""
        first = True
        for command in COMMANDS:
            if command.toolbar != end:
                continue
            if command.rule and not first:
                bar.addSeparator()
            first = False
            action = self.actions[command.id]
            bar.addAction(action)
            button = bar.widgetForAction(action)
            if isinstance(button, QToolButton):
                button.setAccessibleName(translated(command.text))
                size = 16 if command.outlined else 18
                button.setIconSize(QSize(size, size))
                button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
                if command.outlined:
                    button.setProperty("role", "outlined")
                    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)


def command(id: str) -> Command:
    """The command of that id; KeyError where there is none."""
    for one in COMMANDS:
        if one.id == id:
            return one
    raise KeyError(id)
