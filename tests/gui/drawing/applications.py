"""An application, drawn by hand: its states with what they say and show, then what leads on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication
from tests.gui.drawing.conditions import ConditionFiller
from tests.gui.test_newcomer import CONTROL

from situ.document import rbd
from situ.document.datatypes import write_number
from situ.document.drawing import Frame, Note, drawn
from situ_studio import kinds
from situ_studio.edits.notes import note_of
from situ_studio.kinds import Field, Kind
from situ_studio.kinds.application import COLORS
from situ_studio.screens.media_picker import MediaPicker, names_data
from situ_studio.screens.media_rows import IMPORT, KEY

ALWAYS = "always"
COUNTED = {"id", "event", "x", "y", "width", "height"}
"""What something new has depends on what is there."""
PAIRS: dict[str, Callable[[Any], tuple[str, list[tuple[str, ...]]]]] = {
    "params": lambda every: ("Add a value", [(one.name, one.text) for one in every]),
    "results": lambda every: ("Add a result", [(one.tag, one.path) for one in every]),
}


class ApplicationDrawer(ConditionFiller):
    """Draws applications into the tab that is open, which is empty."""

    def draw(self, wanted: rbd.Application) -> None:
        for place in [one.place for one in self.canvas.graph.cards.values()]:
            # What an application begins with.
            self.click_state(place[-1])
            self.key(Qt.Key.Key_Delete)
        self.no_names = {state.no: f"{state.no} {state.name}".strip() for state in wanted.states}
        for state in wanted.states:
            self.state(state)
        if wanted.always is not None:
            self.press("In every state")
            self.inside(wanted.always)
        if wanted.states:
            self.click_state(wanted.states[0].no)
        self.key(Qt.Key.Key_Escape)
        about: dict[str, str | bool] = {"Name": wanted.name, "Note": note_of(wanted)}
        if wanted.start is not None:
            about["Starts with"] = self.target(wanted.start)
        self.fill_form(about)
        for state in wanted.states:
            self.leads_on(state.no, state)
        if wanted.always is not None:
            self.leads_on(ALWAYS, wanted.always)
        for one in drawn(wanted):
            self.beside(one)

    def beside(self, one: Note | Frame) -> None:
        """A note or a frame, written where it stands."""
        self.key(Qt.Key.Key_Escape)
        if isinstance(one, Note):
            self.press(kinds.NOTE.title)
            self.type(one.text, None)
            self.key(Qt.Key.Key_Return, CONTROL)
        else:
            self.press(kinds.FRAME.title)
            self.type(one.title)
        if one.color:
            self.fill_form({"Colour": dict(COLORS)[one.color]})

    # -- states ---------------------------------------------------------------------------

    def state(self, state: rbd.State) -> None:
        if state.flow is None:
            self.press("State")
        else:
            self.answer(state.flow.removesuffix(".rbd.xml"))
            self.press("Part")
            self.press_in_form("Name")
        fields: dict[str, str | bool] = {"Name": state.name, "Number": state.no}
        if state.timeout is not None:
            fields["Timeout"] = write_number(state.timeout.seconds)
        if state.final:
            fields["It may end here"] = True
        if not state.always:
            fields["As in every state"] = False
        if note_of(state):
            fields["Note"] = note_of(state)
        self.fill(fields)
        self.inside(state)

    def inside(self, part: rbd.State | rbd.Always) -> None:
        """What a state says and does, and its screen."""
        if part.screen == rbd.Screen():
            # An empty one is begun where screens are drawn.
            self.press_in_form("Open the screen")
            self.click("Graph", QAbstractButton)
        for action in getattr(part, "actions", ()):
            self.put(action)
        if part.screen is not None:
            for component in part.screen.components:
                self.put(component)
            if part.screen.background or part.screen.touched:
                self.press_in_form("Back")
                self.press_in_form("Background")
                self.form(kinds.SCREEN, part.screen)

    def put(self, value: rbd.Component | rbd.Action) -> None:
        """Something new into what is selected: from the palette, then its form."""
        kind = kinds.kind_of(value)
        assert kind is not None
        self.wanted_file = str(getattr(value, kind.file)) if kind.file else ""
        self.press(kind.title)
        if kind.file:
            self.choose_file(self.wanted_file)
            self.press_in_form("File")
        self.form(kind, value)

    def form(self, kind: Kind, value: Any) -> None:
        """The form of something new: what differs from what it begins with is written."""
        made = kind.make("new")
        self.fill(self.differing(kind.fields, value, made))
        for section in kind.sections:
            if section.attribute in PAIRS:
                self.add_rows(*PAIRS[section.attribute](getattr(value, section.attribute)))
            else:
                self.fill(self.differing(section.fields, value, made))

    def differing(self, fields: Sequence[Field], value: Any, made: Any) -> dict[str, str | bool]:
        return {
            field.label: written(field, shown(field, value))
            for field in fields
            if field.attribute in COUNTED or shown(field, value) != shown(field, made)
        }

    # -- what leads on --------------------------------------------------------------------

    def leads_on(self, card: str, part: rbd.State | rbd.Always) -> None:
        timeout = part.timeout
        if timeout is not None:
            self.click_state(card)
            self.press_in_form("Timeout")
            fields: dict[str, str | bool] = {"Timeout": write_number(timeout.seconds)}
            if timeout.next is not None:
                fields["The timeout leads to"] = self.target(timeout.next)
            if timeout.idle:
                fields["only when idle"] = True
            self.fill(fields)
        for event in part.events:
            self.event(card, event)

    def event(self, card: str, event: rbd.Event) -> None:
        self.click_state(card)
        if event.next in self.no_names and event.next != card:
            self.pull_new(card, event.next)
            self.open_last_row()
            self.press_in_form("Event")
            self.fill({"Event": event.name or ""})
        else:
            self.press("Event")
            fields: dict[str, str | bool] = {"Event": event.name or ""}
            if event.next is not None:
                fields["Leads to"] = self.target(event.next)
            self.fill(fields)
        if note_of(event):
            self.fill({"Note": note_of(event)})
        if event.when is not None:
            self.condition(event.when)
        self.add_rows("Add a phrase", [(one.text,) for one in event.says])
        for action in event.actions:
            if isinstance(action, rbd.Repeat):
                self.menu_in_form("Add", kinds.REPEAT.title)
            else:
                self.put(action)

    def target(self, no: str) -> str:
        special = {rbd.AGAIN: "the same state, anew", rbd.BACK: "back to where it came from"}
        return special.get(no) or self.no_names[no]

    # -- the drawing ----------------------------------------------------------------------

    @property
    def canvas(self) -> Any:
        return self.window.current_view.canvas

    def on_canvas(self, spot: QPointF) -> QPoint:
        viewer = self.canvas.viewer
        found: QPoint = viewer.viewport().mapToGlobal(viewer.mapFromScene(spot))
        return found

    def node(self, card: str) -> Any:
        """A card by the number of its state, or ALWAYS."""
        place = (ALWAYS,) if card == ALWAYS else ("state", card)
        cards = self.canvas.graph.cards
        return self.canvas.graph.nodes[next(u for u in cards if cards[u].place == place)]

    def click_state(self, card: str) -> None:
        face = self.node(card).view
        spot = face.scenePos() + QPointF(20, 16)
        self.see(spot)
        self.click_at(self.on_canvas(spot))

    def see(self, *spots: QPointF) -> None:
        """Shows everything where one of them can not be seen."""
        port = self.canvas.viewer.viewport()
        area = port.rect().adjusted(8, 8, -8, -8)
        if not all(area.contains(self.canvas.viewer.mapFromScene(spot)) for spot in spots):
            self.run("Show everything")

    def pull_new(self, card: str, target: str) -> None:
        """From the plus of a card that is selected onto another."""
        start = self.node(card).port("out", "new").view.centre()
        face = self.node(target).view
        end = face.scenePos() + QPointF(88, 60)
        self.see(start, end)
        self.drag(self.on_canvas(start), self.on_canvas(end))

    def choose_file(self, name: str) -> None:
        """From what the project has, or from elsewhere: the first one is asked for at once."""
        menu = QApplication.activePopupWidget()
        if isinstance(menu, MediaPicker):
            known = {choice.label for choice in menu.choices}
            if name in known or names_data(name):
                self.type(name)
            else:
                while menu.list.currentItem().data(KEY) != IMPORT:
                    self.key(Qt.Key.Key_Up)
                self.key(Qt.Key.Key_Return)


def shown(field: Field, value: Any) -> Any:
    return note_of(value) if field.editor == "note" else getattr(value, field.attribute)


def written(field: Field, value: Any) -> str | bool:
    """How a value stands in its field."""
    if isinstance(value, bool):
        return value
    if field.choices:
        return dict(field.choices)[value or ""]
    if isinstance(value, float):
        return write_number(value)
    return "" if value is None else str(value)
