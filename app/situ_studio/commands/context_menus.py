"""Context menus: of the ground, of a state, of several, of a transition, of anything else."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QPoint, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMenu

from situ_studio.edits import places
from situ_studio.edits.edit import Place

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


def context_of(selected: tuple[Place, ...]) -> str:
    """The context of a selection, as ``actions.Command.contexts`` names it."""
    if not selected:
        return "ground"
    if all(places.is_component(place) for place in selected):
        return "component"
    if len(selected) > 1:
        return (
            "states" if all(context_of((p,)) in ("state", "always") for p in selected) else "thing"
        )
    place = selected[0]
    inner = place[1:] if place[0] == "always" else place[2:]
    if place[0] not in ("always", "state"):
        return "thing"
    if not inner:
        return place[0]
    return "exit" if inner == ("timeout",) or (len(inner) == 2 and inner[0] == "event") else "thing"


def pop_up(menu: QMenu, at: QPoint) -> None:
    """Opens a menu there, as much higher as it needs to be seen whole: only one that is higher than
    the screen scrolls.
    """
    screen = QGuiApplication.screenAt(at) or QGuiApplication.primaryScreen()
    room, high = screen.availableGeometry(), menu.sizeHint().height()
    menu.popup(QPoint(at.x(), max(room.top(), min(at.y(), room.bottom() - high))))


class ContextMenus(QObject):
    """Opens them in one window; the commands are those of the table."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.shown: QMenu | None = None

    def open(self, place: Place, at: QPoint) -> None:
        """About what was pressed; () is the ground, and a screen's place that of the screen. What
        is selected with it stays so.
        """
        window = self._window
        view = window.current_view
        if view is None:
            return
        if place[-1:] == ("screen",):
            self._pop_up("screen", at)
            return
        if place and place not in view.selected:
            window.select(place)
        cells = self._window.commands.has_cells()
        self._pop_up(self._context(view.selected) if place or cells else "ground", at)

    def open_at_selection(self) -> None:
        """About what is selected, beside it."""
        view = self._window.current_view
        if view is None:
            return
        if self._window.mending.open_for_row():
            return
        sheet, chosen = self._window.commands.components.sheet, context_of(view.selected)
        on_sheet = sheet is not None and (chosen == "component" or sheet.hasFocus())
        context = self._context(view.selected)
        if on_sheet:
            context = chosen if chosen == "component" else "screen"
        self._pop_up(context, self.corner())

    def corner(self) -> QPoint:
        """Where a menu of what is selected stands, on the desktop."""
        view = self._window.current_view
        if view is None:
            return self._window.mapToGlobal(self._window.rect().center())
        sheet, chosen = self._window.commands.components.sheet, context_of(view.selected)
        if sheet is not None and (chosen == "component" or sheet.hasFocus()):
            return sheet.menu_corner()
        shown = view.current_view()
        corner: QPoint | None = view.call("menu_corner")
        return corner or shown.mapToGlobal(shown.rect().center())

    def _context(self, selected: tuple[Place, ...]) -> str:
        return "cells" if self._window.commands.has_cells() else context_of(selected)

    def _pop_up(self, context: str, at: QPoint) -> None:
        if self.shown is not None:
            self.shown.close()
        menu = self._window.actions_.context_menu(context, self._window)
        if menu.isEmpty():
            menu.deleteLater()
            return
        self._window.mending.add_to(menu)
        menu.aboutToHide.connect(lambda: self._on_hidden(menu))
        self.shown = menu
        pop_up(menu, at)

    def _on_hidden(self, menu: QMenu) -> None:
        # What was chosen is done after this, and still wants to know where the menu was.
        QTimer.singleShot(0, self, lambda: self._forget(menu))

    def _forget(self, menu: QMenu) -> None:
        if self.shown is menu:
            self.shown = None
        menu.deleteLater()
        view = self._window.current_view
        canvas: Any = view.canvas if view is not None else None
        if canvas is not None:
            canvas.pointed = None
