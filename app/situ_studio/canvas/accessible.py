"""The drawing for screen readers: cards, transitions and actions in the accessible tree.

Qt exposes no items of a graphics view by itself (canvas.md). One factory is installed
per process, before a viewer is first asked for; it knows viewers by their class. What is
heard are the values of ``spoken``; each one that somebody asked for has one interface.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, Protocol

from PySide6.QtCore import QCoreApplication, QObject, QRect, QRectF
from PySide6.QtGui import (
    QAccessible,
    QAccessibleActionInterface,
    QAccessibleEvent,
    QAccessibleInterface,
    QColor,
    QWindow,
)
from PySide6.QtWidgets import QAccessibleWidget

from situ_studio.assistive.accessible_actions import NOTHING_MORE, PartActions
from situ_studio.canvas.spoken import Spoken
from situ_studio.canvas.viewer import Viewer
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

INSTALLED = "situ_cards_are_accessible"
ROLES = {
    "node": QAccessible.Role.ListItem,
    "action": QAccessible.Role.StaticText,
    "transition": QAccessible.Role.Link,
}
MANY = 20
"""More changes at once than these are told as one."""
Path = tuple[str, ...]
"""Keys from a card inwards."""


class Speaker(Protocol):
    """The canvas, as far as its accessible tree needs it."""

    def heard(self) -> Sequence[str]:
        """Keys of what stands at the top, in order."""
        ...

    def spoken(self, key: str) -> Spoken: ...
    def lately(self, key: str) -> str:
        """What the robot that is looked at does there, in words that may be others each time."""
        ...

    def cards_at(self, places: Iterable[Place]) -> set[str]:
        """The keys of what stands at the top and is at these places, or has them in it."""
        ...

    def card_area(self, uid: str) -> QRectF: ...
    def selection(self) -> tuple[Place, ...]: ...
    def choose(self, place: Place) -> None:
        """As a click would."""
        ...

    def begin(self, place: Place) -> None:
        """As a double click would."""
        ...


class AccessibleViewer(QAccessibleWidget):
    """The drawing: a list of its cards in document order."""

    def __init__(self, viewer: Viewer, speaker: Speaker) -> None:
        super().__init__(viewer, QAccessible.Role.Canvas, tr("Drawing"))
        viewer.setAccessibleDescription(tr("Tab goes from card to card, F6 to the next panel."))
        self.viewer = viewer
        self.speaker = speaker
        self.tell: Callable[[QAccessibleEvent], None] = QAccessible.updateAccessibility
        self._keys: dict[str, int] | None = None
        self._order: list[str] = []
        self._values: dict[Path, tuple[Spoken, dict[str, Spoken]]] = {}
        # Qt holds no reference to what Python hands it.
        self._parts: dict[Path, AccessiblePart] = {}
        self._chosen: tuple[Place, ...] = ()

    # -- what is heard ---------------------------------------------------------------

    def keys(self) -> dict[str, int]:
        """Of the cards, each with its position."""
        if self._keys is None:
            self._keys = {key: index for index, key in enumerate(self.speaker.heard())}
            self._order = list(self._keys)
        return self._keys

    def value(self, path: Path) -> Spoken | None:
        """What is at ``path`` now; None where there is nothing any more."""
        found = self._entry(path)
        return found[0] if found is not None else None

    def below(self, path: Path) -> list[str]:
        """The keys of what is in it."""
        found = self._entry(path)
        return list(found[1]) if found is not None else []

    def _entry(self, path: Path) -> tuple[Spoken, dict[str, Spoken]] | None:
        if path not in self._values:
            if len(path) == 1:
                value = self.speaker.spoken(path[0]) if path[0] in self.keys() else None
            else:
                outer = self._entry(path[:-1])
                value = outer[1].get(path[-1]) if outer is not None else None
            if value is None:
                return None
            self._values[path] = value, {one.key: one for one in value.below()}
        return self._values[path]

    def part(self, path: Path) -> AccessiblePart | None:
        """The interface of what is at ``path``."""
        if self.value(path) is None:
            return None
        if path not in self._parts:
            self._parts[path] = AccessiblePart(self, path)
        return self._parts[path]

    def path_of(self, place: Place) -> Path | None:
        """Where a place of the document is heard; None where it is not."""
        for key in self.speaker.cards_at((place,)):
            top = self.value((key,))
            if top is not None:
                return self._search((key,), top, place)
        return None

    def _search(self, path: Path, value: Spoken, place: Place) -> Path | None:
        if value.place == place:
            return path
        for key in self.below(path):
            inner = self.value((*path, key))
            if inner is not None and place[: len(inner.place)] == inner.place:
                return self._search((*path, key), inner, place)
        return None

    # -- what Qt asks ------------------------------------------------------------------

    def childCount(self) -> int:
        return len(self.keys())

    def child(self, index: int) -> Any:
        if not 0 <= index < self.childCount():
            return None
        return self.part((self._order[index],))

    def childAt(self, x: int, y: int) -> Any:
        for key in reversed(list(self.keys())):
            found = self.part((key,))
            if found is not None and found.rect().contains(x, y):
                return found.childAt(x, y) or found
        return None

    def focusChild(self) -> Any:
        chosen = self.speaker.selection()
        path = self.path_of(chosen[0]) if len(chosen) == 1 else None
        return self.part(path) if path is not None and self.viewer.hasFocus() else None

    def indexOfChild(self, child: QAccessibleInterface) -> int:
        if isinstance(child, AccessiblePart) and len(child.path) == 1:
            return self.keys().get(child.path[0], -1)
        return -1

    # -- what is told ------------------------------------------------------------------

    def on_shown(self) -> None:
        """The drawing shows another document: what is heard is asked for anew."""
        old = {path: value.name for path, (value, _) in self._values.items()}
        keys = self._keys
        self._keys, self._values = None, {}
        gone = [path for path in self._parts if self.value(path) is None]
        if QAccessible.isActive():
            for path in gone[:MANY]:
                self._event(path, QAccessible.Event.ObjectDestroyed)
            for path in [p for p in self._parts if p in old and p not in gone]:
                value = self.value(path)
                if value is not None and value.name != old[path]:
                    self._event(path, QAccessible.Event.NameChanged)
            new = [k for k in self.keys() if k not in keys] if keys is not None else []
            for key in new[:MANY]:
                self._event((key,), QAccessible.Event.ObjectCreated)
        for path in gone:
            self._forget(path)

    def on_selected(self) -> None:
        """Another thing is selected: the one that it is has the focus where the drawing has it."""
        before, self._chosen = self._chosen, self.speaker.selection()
        if not QAccessible.isActive():
            return
        for places, kind in (
            (set(before) - set(self._chosen), QAccessible.Event.SelectionRemove),
            (set(self._chosen) - set(before), QAccessible.Event.SelectionAdd),
        ):
            if len(places) > MANY:
                self.tell(QAccessibleEvent(self.viewer, QAccessible.Event.SelectionWithin))
                continue
            for place in sorted(places):
                self._event(self.path_of(place), kind)
        if self.viewer.hasFocus():
            self.on_focused()

    def on_focused(self) -> None:
        """The drawing has the focus, and what is selected in it has it there."""
        chosen = self.speaker.selection()
        if QAccessible.isActive() and len(chosen) == 1:
            self._event(self.path_of(chosen[0]), QAccessible.Event.Focus)

    def _event(self, path: Path | None, kind: QAccessible.Event) -> None:
        part = None
        if path is not None:
            part = self._parts.get(path) or self.part(path)
        if part is not None:
            self.tell(QAccessibleEvent(part, kind))

    def _forget(self, path: Path) -> None:
        # Where an assistive program listens, Qt knows it by a number: it must not keep that.
        part = self._parts.pop(path)
        QAccessible.deleteAccessibleInterface(QAccessible.uniqueId(part))

    def forget_all(self) -> None:
        """The viewer is gone: this, which Qt may keep, keeps nothing of it."""
        for path in list(self._parts):
            self._forget(path)
        self._keys, self._values, self._chosen = None, {}, ()
        del self.viewer, self.speaker


class AccessiblePart(QAccessibleInterface):
    """A card, a transition or an action: what it is called, where it is, whether it is chosen.

    It is valid while there is something at its path.
    """

    def __init__(self, drawing: AccessibleViewer, path: Path) -> None:
        super().__init__()
        self._drawing = drawing
        self.path = path
        self._actions = PartActions(self)

    @property
    def _value(self) -> Spoken:
        return self._drawing.value(self.path) or Spoken(self.path[-1], "node", "")

    def place(self) -> Place:
        return self._value.place

    def isValid(self) -> bool:
        return self._drawing.value(self.path) is not None

    def object(self) -> Any:
        return None

    def window(self) -> QWindow:
        return self._drawing.window()

    def parent(self) -> QAccessibleInterface:
        if len(self.path) == 1:
            return self._drawing
        return self._drawing.part(self.path[:-1]) or self._drawing

    def childCount(self) -> int:
        return len(self._drawing.below(self.path))

    def child(self, index: int) -> Any:
        keys = self._drawing.below(self.path)
        return self._drawing.part((*self.path, keys[index])) if 0 <= index < len(keys) else None

    def childAt(self, x: int, y: int) -> Any:
        for index in range(self.childCount()):
            found = self.child(index)
            if found is not None and found.rect().contains(x, y):
                return found
        return None

    def indexOfChild(self, child: QAccessibleInterface) -> int:
        keys = self._drawing.below(self.path)
        if isinstance(child, AccessiblePart) and child.path[:-1] == self.path:
            return keys.index(child.path[-1]) if child.path[-1] in keys else -1
        return -1

    def role(self) -> QAccessible.Role:
        return ROLES[self._value.role]

    def state(self) -> QAccessible.State:
        state = QAccessible.State()
        chosen = self._drawing.speaker.selection()
        place = self._value.place
        state.selectable = state.focusable = True
        state.selected = bool(place) and place in chosen
        state.focused = state.selected and len(chosen) == 1 and self._drawing.viewer.hasFocus()
        viewport = self._drawing.viewer.viewport()
        seen = QRect(viewport.mapToGlobal(viewport.rect().topLeft()), viewport.size())
        state.offscreen = not seen.intersects(self.rect())
        return state

    def rect(self) -> QRect:
        viewer = self._drawing.viewer
        if not self.isValid():
            return QRect()
        area = self._drawing.speaker.card_area(self.path[0])
        inner = self._value.area
        if inner is not None:
            area = QRectF(area.left() + inner[0], area.top() + inner[1], inner[2], inner[3])
        found = viewer.mapFromScene(area).boundingRect()
        return QRect(viewer.viewport().mapToGlobal(found.topLeft()), found.size())

    def text(self, kind: QAccessible.Text) -> str:
        if kind == QAccessible.Text.Name:
            return self._value.name
        if kind != QAccessible.Text.Description:
            return ""
        lately = self._drawing.speaker.lately(self.path[0]) if len(self.path) == 1 else ""
        return ". ".join(one for one in (self._value.description, lately) if one)

    def setText(self, kind: QAccessible.Text, text: str) -> None:
        return

    def interface_cast(self, kind: QAccessible.InterfaceType) -> Any:
        if kind == QAccessible.InterfaceType.ActionInterface:
            return self._actions
        return NOTHING_MORE

    def do(self, name: str) -> None:
        """``Press`` is a double click, ``SetFocus`` a click."""
        place = self._value.place
        if name == QAccessibleActionInterface.pressAction():
            self._drawing.speaker.begin(place)
        elif name == QAccessibleActionInterface.setFocusAction():
            self._drawing.speaker.choose(place)

    def backgroundColor(self) -> QColor:
        return QColor()

    def foregroundColor(self) -> QColor:
        return QColor()


def install() -> None:
    """Makes drawings known to screen readers; once a process, further calls do nothing."""
    application = QCoreApplication.instance()
    if application is not None and not application.property(INSTALLED):
        application.setProperty(INSTALLED, True)
        QAccessible.installFactory(_factory)


def _factory(name: str, watched: QObject) -> Any:
    if not isinstance(watched, Viewer) or watched.speaker is None:
        return None
    # Kept by what it speaks for: Qt holds no reference.
    spoken_as = watched.spoken_as = AccessibleViewer(watched, watched.speaker)
    watched.destroyed.connect(lambda: spoken_as.forget_all())
    return spoken_as
