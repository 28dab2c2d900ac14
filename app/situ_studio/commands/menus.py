"""The table of commands as one window's QActions: menus, context menus, toolbar, shortcuts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Literal

from PySide6.QtCore import QCoreApplication, QObject, QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu, QMenuBar, QToolBar, QToolButton, QWidget

from situ_studio.actions import COMMANDS, MENUS, SUBMENU_ICONS, Command
from situ_studio.commands.reasons import reasons
from situ_studio.help.help_texts import explained
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme


def translated(text: str) -> str:
    """A text of the table in the user's language."""
    return QCoreApplication.translate("actions", text) if text else ""


def told(command: Command) -> str:
    """A command as it is told outside of the menus, with its submenu: ``Select: Everything``."""
    _, _, below = command.menu.partition("/")
    text = translated(command.text).rstrip("…")
    return f"{translated(below)}: {text}" if below else text


class Actions(QObject):
    """The table as QActions of one window.

    handlers: has every method that the table names.
    """

    used = Signal(str)
    """The id of a command that was done, by whatever way."""

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
        # A button without words is named by its tip, which is the text as it is at the moment.
        if command.tip or not command.toolbar:
            action.setToolTip(explained(command))
        handler: Callable[..., Any] = getattr(self._handlers, command.handler)
        if command.argument is None:
            action.triggered.connect(lambda _=False: handler())
        else:
            action.triggered.connect(lambda _=False: handler(command.argument))
        if command.choice:
            action.setCheckable(True)
            group = self._groups.setdefault(command.choice, QActionGroup(self))
            group.addAction(action)
        action.triggered.connect(lambda _=False: self.used.emit(command.id))
        parent.addAction(action)
        return action

    def set_keys(self, keys: Mapping[str, list[QKeySequence]]) -> None:
        """Gives every command its keys. keys: by the commands' ids."""
        for id, action in self.actions.items():
            action.setShortcuts(keys[id])

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for command in COMMANDS:
            if command.icon:
                made = icons.icon(command.icon, theme.color("text2"), 18)
                self.actions[command.id].setIcon(made)
        for title, name in SUBMENU_ICONS.items():
            if "/" in title and title in self._menus:
                self._menus[title].setIcon(icons.icon(name, theme.color("text2"), 18))

    def refresh(self) -> None:
        """Enables, shows and checks every command as it can be done now."""
        # Many commands ask the same.
        known: dict[str, bool] = {}
        for command in COMMANDS:
            action = self.actions[command.id]
            for asked in (*command.shown.split(), *command.when.split()):
                if asked not in known:
                    known[asked] = bool(getattr(self._handlers, asked)())
            if command.shown:
                action.setVisible(known[command.shown])
            if command.when:
                lacking = [one for one in command.when.split() if not known[one]]
                action.setEnabled(not lacking)
                if command.tip and command.toolbar:
                    told = [explained(command), *(reasons()[one] for one in lacking[:1])]
                    action.setToolTip("\n".join(told))
            if command.checked:
                action.setChecked(bool(getattr(self._handlers, command.checked)(command.argument)))

    def reason(self, command: Command) -> str:
        """Why it can not be done now, in the user's language; "" where it can."""
        asked = command.when.split()
        lacking = next((one for one in asked if not getattr(self._handlers, one)()), "")
        return reasons()[lacking] if lacking else ""

    def fill_menus(self, bar: QMenuBar) -> None:
        """Makes the menus."""
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
        self.set_theme(self._theme)

    def context_menu(self, context: str, parent: QWidget) -> QMenu:
        """What can be done now in a context, in the table's order; a line between its menus."""
        self.refresh()
        menu = QMenu(parent)
        menu.setToolTipsVisible(True)
        below: dict[str, QMenu] = {}
        before = ""
        for command in COMMANDS:
            action = self.actions[command.id]
            if context not in command.contexts.split() or not action.isVisible():
                continue
            if not action.isEnabled():
                continue
            head, _, tail = command.menu.partition("/")
            if before and head != before:
                menu.addSeparator()
            before = head
            if command.handler == "insert":
                tail = head
            if tail and tail not in below:
                below[tail] = menu.addMenu(translated(tail))
                name = SUBMENU_ICONS.get(command.menu, SUBMENU_ICONS.get(tail, ""))
                below[tail].setIcon(icons.icon(name, self._theme.color("text2"), 18))
            below.get(tail, menu).addAction(action)
        return menu

    @property
    def menus(self) -> tuple[QMenu, ...]:
        """Those of the menu bar, with their submenus."""
        return tuple(self._menus.values())

    def menu(self, title: str) -> QMenu:
        """A menu by its title in the table."""
        return self._menus[title]

    def _menu(self, title: str, bar: QMenuBar) -> QMenu:
        if title in self._menus:
            return self._menus[title]
        head, _, tail = title.rpartition("/")
        parent: QMenuBar | QMenu = self._menu(head, bar) if head else bar
        if head and not (parent.actions() and parent.actions()[-1].menu() is not None):
            parent.addSeparator()
        menu = parent.addMenu(translated(tail) if head else _with_key(tail))
        menu.setToolTipsVisible(True)
        self._menus[title] = menu
        return menu

    def fill_toolbar(self, bar: QToolBar, end: Literal["left", "right"]) -> None:
        """Puts the commands of one end into the toolbar; a line between those of two menus."""
        before = ""
        for command in COMMANDS:
            if command.toolbar != end:
                continue
            if before and command.menu.partition("/")[0] != before:
                bar.addSeparator()
            before = command.menu.partition("/")[0]
            action = self.actions[command.id]
            bar.addAction(action)
            button = bar.widgetForAction(action)
            if isinstance(button, QToolButton):
                button.setAccessibleName(translated(command.text))
                size = 16 if command.outlined else 18
                button.setIconSize(QSize(px(size), px(size)))
                button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
                if command.outlined:
                    button.setProperty("role", "outlined")
                    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)


def _with_key(title: str) -> str:
    """A menu's title with the letter that opens it; where titles are not in Latin letters, the
    English one's stands behind it, as is usual there.
    """
    text = translated(title)
    return f"&{text}" if text.isascii() else f"{text}(&{title[0]})"
