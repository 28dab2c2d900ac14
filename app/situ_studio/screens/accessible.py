"""A sheet for screen readers: its components in the accessible tree, as cards are on the canvas.

One factory is installed per process, before a sheet is first asked for. Each component that
somebody asked for has one interface, for as long as it is on the screen.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QCoreApplication, QObject, QPoint, QRect
from PySide6.QtGui import (
    QAccessible,
    QAccessibleActionInterface,
    QAccessibleEvent,
    QAccessibleInterface,
    QColor,
    QWindow,
)
from PySide6.QtWidgets import QAccessibleWidget

from situ.document import rbd
from situ_studio import kinds
from situ_studio.assistive.accessible_actions import NOTHING_MORE, PartActions
from situ_studio.screens import marks
from situ_studio.screens.placing import box_of
from situ_studio.screens.problem_marks import spoken
from situ_studio.wording.language import tr, translated

if TYPE_CHECKING:
    from situ_studio.screens.sheet import Sheet

INSTALLED = "situ_sheets_are_accessible"
ROLES = {
    "text": QAccessible.Role.StaticText,
    "button": QAccessible.Role.Button,
    "image": QAccessible.Role.Graphic,
    "movie": QAccessible.Role.Animation,
    "input": QAccessible.Role.EditableText,
    "list": QAccessible.Role.List,
}
MANY = 20
"""More changes at once than these are told as one."""


def called(component: rbd.Component) -> str:
    """What a component is called: its kind, and what is written on it or its id."""
    kind = kinds.kind_of(component)
    title = translated(kind.title) if kind is not None else component.element
    text = getattr(component, "text", "") or getattr(component, "src", "") or component.id
    return f"{title} {' '.join(str(text).split())}"


def described(component: rbd.Component) -> str:
    """Where it lies, how large it is, and what a touch sends."""
    where = tr("{0} % from the left, {1} % from the top").format(
        f"{component.x:g}", f"{component.y:g}"
    )
    return f"{where}; {marks.measured(box_of(component), [component])}"


class AccessibleSheet(QAccessibleWidget):
    """The screen: its own components back to front, then those that Always adds."""

    def __init__(self, sheet: Sheet) -> None:
        super().__init__(sheet, QAccessible.Role.Canvas, sheet.accessibleName())
        self.sheet = sheet
        self.tell: Callable[[QAccessibleEvent], None] = QAccessible.updateAccessibility
        # Qt holds no reference to what Python hands it.
        self._parts: dict[str, AccessibleComponent] = {}
        self._names: dict[str, str] = {}
        self._chosen: tuple[str, ...] = ()

    # -- what Qt asks ------------------------------------------------------------------

    def component(self, id: str) -> rbd.Component | None:
        return next((c for c in self.sheet.components if c.id == id), None)

    def part(self, id: str) -> AccessibleComponent:
        if id not in self._parts:
            self._parts[id] = AccessibleComponent(self, id)
        return self._parts[id]

    def childCount(self) -> int:
        return len(self.sheet.components)

    def child(self, index: int) -> Any:
        every = self.sheet.components
        return self.part(every[index].id) if 0 <= index < len(every) else None

    def childAt(self, x: int, y: int) -> Any:
        for component in reversed(self.sheet.components):
            part = self.part(component.id)
            if part.rect().contains(x, y):
                return part
        return None

    def focusChild(self) -> Any:
        chosen = self.sheet.selected
        return self.part(chosen[0]) if len(chosen) == 1 and self.sheet.hasFocus() else None

    def indexOfChild(self, child: QAccessibleInterface) -> int:
        if isinstance(child, AccessibleComponent):
            ids = [c.id for c in self.sheet.components]
            return ids.index(child.id) if child.id in ids else -1
        return -1

    # -- what is told ------------------------------------------------------------------

    def on_shown(self) -> None:
        """The sheet shows another screen."""
        names = {c.id: called(c) for c in self.sheet.components}
        before, self._names = self._names, names
        gone = [id for id in self._parts if id not in names]
        if QAccessible.isActive():
            new = [id for id in names if id not in before]
            told = [
                *((id, QAccessible.Event.ObjectDestroyed) for id in gone[:MANY]),
                *((id, QAccessible.Event.ObjectCreated) for id in new[:MANY] if before),
                *(
                    (id, QAccessible.Event.NameChanged)
                    for id in names
                    if before.get(id, names[id]) != names[id]
                ),
            ]
            for id, kind in told:
                self.tell(QAccessibleEvent(self.part(id), kind))
        for id in gone:
            self._forget(id)

    def on_selected(self) -> None:
        """Another component is selected: the one that it is has the focus."""
        before, self._chosen = self._chosen, self.sheet.selected
        if not QAccessible.isActive() or before == self._chosen:
            return
        off = [id for id in before if id not in self._chosen and self.component(id) is not None]
        on = [id for id in self._chosen if id not in before]
        if len(off) + len(on) > MANY:
            self.tell(QAccessibleEvent(self.sheet, QAccessible.Event.SelectionWithin))
        else:
            for id in off:
                self.tell(QAccessibleEvent(self.part(id), QAccessible.Event.SelectionRemove))
            for id in on:
                self.tell(QAccessibleEvent(self.part(id), QAccessible.Event.SelectionAdd))
        if len(self._chosen) == 1:
            self.tell(QAccessibleEvent(self.part(self._chosen[0]), QAccessible.Event.Focus))

    def _forget(self, id: str) -> None:
        # Where an assistive program listens, Qt knows it by a number: it must not keep that.
        part = self._parts.pop(id)
        QAccessible.deleteAccessibleInterface(QAccessible.uniqueId(part))

    def forget_all(self) -> None:
        """The sheet is gone: this, which Qt may keep, keeps nothing of it."""
        for id in list(self._parts):
            self._forget(id)
        self._names, self._chosen = {}, ()
        del self.sheet


class AccessibleComponent(QAccessibleInterface):
    """What it is called, where it is, whether it is selected. Valid while it is on the screen."""

    def __init__(self, shown: AccessibleSheet, id: str) -> None:
        super().__init__()
        self._shown = shown
        self.id = id
        self._actions = PartActions(self)

    def isValid(self) -> bool:
        return hasattr(self._shown, "sheet") and self._shown.component(self.id) is not None

    def object(self) -> Any:
        return None

    def window(self) -> QWindow:
        return self._shown.window()

    def parent(self) -> QAccessibleInterface:
        return self._shown

    def childCount(self) -> int:
        return 0

    def child(self, index: int) -> Any:
        return None

    def childAt(self, x: int, y: int) -> Any:
        return None

    def indexOfChild(self, child: QAccessibleInterface) -> int:
        return -1

    def role(self) -> QAccessible.Role:
        component = self._shown.component(self.id) if self.isValid() else None
        element = component.element if component is not None else ""
        return ROLES.get(element, QAccessible.Role.StaticText)

    def state(self) -> QAccessible.State:
        state = QAccessible.State()
        if not self.isValid():
            state.invalid = True
            return state
        sheet = self._shown.sheet
        own = sheet.component(self.id) is not None
        state.selectable = state.focusable = own
        state.selected = own and self.id in sheet.selected
        state.focused = state.selected and len(sheet.selected) == 1 and sheet.hasFocus()
        # What Always adds is placed there.
        state.readOnly = not own
        return state

    def rect(self) -> QRect:
        component = self._shown.component(self.id) if self.isValid() else None
        if component is None:
            return QRect()
        area = self._shown.sheet.area(box_of(component)).toRect()
        return QRect(self._shown.sheet.mapToGlobal(QPoint(area.topLeft())), area.size())

    def text(self, kind: QAccessible.Text) -> str:
        component = self._shown.component(self.id) if self.isValid() else None
        if component is None:
            return ""
        if kind == QAccessible.Text.Name:
            return called(component)
        if kind != QAccessible.Text.Description:
            return ""
        wrong = spoken(self._shown.sheet.problems.told.get(self.id, ()))
        return "; ".join(one for one in (described(component), wrong) if one)

    def setText(self, kind: QAccessible.Text, text: str) -> None:
        return

    def interface_cast(self, kind: QAccessible.InterfaceType) -> Any:
        if kind == QAccessible.InterfaceType.ActionInterface:
            return self._actions
        return NOTHING_MORE

    def do(self, name: str) -> None:
        """``Press`` is a double click, ``SetFocus`` a click."""
        sheet = self._shown.sheet
        if sheet.component(self.id) is None:
            return
        if name == QAccessibleActionInterface.setFocusAction():
            sheet.setFocus()
            sheet.choose((self.id,))
        elif name == QAccessibleActionInterface.pressAction():
            sheet.choose((self.id,))
            sheet.open(self.id)

    def backgroundColor(self) -> QColor:
        return QColor()

    def foregroundColor(self) -> QColor:
        return QColor()


def install() -> None:
    """Makes sheets known to screen readers; once a process, further calls do nothing."""
    application = QCoreApplication.instance()
    if application is not None and not application.property(INSTALLED):
        application.setProperty(INSTALLED, True)
        QAccessible.installFactory(_factory)


def _factory(name: str, watched: QObject) -> Any:
    from situ_studio.screens.sheet import Sheet

    if not isinstance(watched, Sheet):
        return None
    # Kept by what it speaks for: Qt holds no reference.
    spoken_as = watched.spoken_as = AccessibleSheet(watched)
    watched.destroyed.connect(lambda: spoken_as.forget_all())
    return spoken_as
