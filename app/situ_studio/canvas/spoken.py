"""What a screen reader hears of a drawing: cards, and in them their actions and ways out. No Qt.

A thing's name alone says what it is; its description says the rest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Literal

from msgspec import Struct
from msgspec.structs import replace

from situ.document import rbd, words
from situ.document.rbd import Application
from situ_studio import kinds
from situ_studio.canvas.picture import LINE, PITCH, TIMEOUT, WIDTH, Card, Exit
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Role = Literal["node", "action", "transition"]
Area = tuple[float, float, float, float]
"""Left, top, width and height, from the corner of the card."""
SPEECH_LINE: Area = (8, 31, WIDTH - 16, LINE)
"""Where a card shows in words what it does first."""
ICONS = 92.0
"""The upper edge of a card's icons."""


class Spoken(Struct, frozen=True):
    """One thing that is heard. key: its name among its neighbours; area: None is the whole card.

    below: what is in it, made when somebody asks.
    """

    key: str
    role: Role
    name: str
    description: str = ""
    place: Place = ()
    area: Area | None = None
    below: Callable[[], Sequence[Spoken]] = tuple


def node(face: Any, place: Place, below: Callable[[], Sequence[Spoken]] = tuple) -> Spoken:
    """A card of either canvas."""
    name = face.hint().split("\n")[0]
    return Spoken(face.uid, "node", name, face.spoken(), place, None, below)


def card(application: Application, face: Card, before: Sequence[Card]) -> Spoken:
    """A state, or what is part of every state, with its actions and then its transitions.

    before: what leads here.
    """
    found = node(face, face.place, partial(_inside, application, face))
    if not before:
        return found
    comes = tr("reached from {0}").format(", ".join(one.no or tr("every state") for one in before))
    return replace(found, description=f"{found.description}; {comes}")


def _inside(application: Application, face: Card) -> tuple[Spoken, ...]:
    value = places.get(application, face.place)
    owner = tr("state {0}").format(face.no) if face.no else tr("every state")
    actions = [
        _action(
            action,
            f"action {index}",
            (*face.place, "action", str(index)),
            tr("action on entry of {0}").format(owner),
            _icon_area(face, action),
        )
        for index, action in enumerate(getattr(value, "actions", ()))
    ]
    return (*actions, *(_transition(application, face, owner, e) for e in face.exits))


def _transition(application: Application, face: Card, owner: str, leaving: Exit) -> Spoken:
    tail = (TIMEOUT,) if leaving.timeout else ("event", leaving.id)
    place = (*face.place, *tail)
    event = places.get(application, place)
    more = [tr("only if {0}").format(leaving.guard)] if leaving.guard else []
    more += [tr("said as {0}").format(words.quoted(e.text)) for e in getattr(event, "says", ())]
    more += leaving.mark.told()
    goal = leaving.next or ""
    called = words.leads(application, goal) if goal else ""
    if leaving.missing:
        called = tr("{0}, which does not exist").format(called)
    _, y = face.port(leaving.id)
    area = (WIDTH * 0.35, y - PITCH / 2, WIDTH * 0.65, PITCH)
    return Spoken(
        key=leaving.id,
        role="transition",
        name=f"{leaving.called()} {leaving.leads(called)}",
        description="; ".join((tr("transition of {0}").format(owner), *more)),
        place=place,
        area=area,
        below=partial(_on_the_way, getattr(event, "actions", ()), place, area),
    )


def _on_the_way(actions: Sequence[rbd.Action], place: Place, area: Area) -> tuple[Spoken, ...]:
    when = tr("action on the way")
    return tuple(
        _action(action, str(index), (*place, "action", str(index)), when, area)
        for index, action in enumerate(actions)
    )


def _action(action: rbd.Action, key: str, place: Place, when: str, area: Area) -> Spoken:
    name, whole = words.whole_action(action), words.action(action)
    more = [whole] if whole not in name else []
    more += [tr("then {0}").format(action.done)] if action.done else []
    more += [tr("{0} if it fails").format(action.failed)] if action.failed else []
    return Spoken(key, "action", name, "; ".join((when, *more)), place, area)


def _icon_area(face: Card, action: rbd.Action) -> Area:
    kind = kinds.kind_of(action)
    if kind is None or kind.icon not in face.icons:
        return SPEECH_LINE
    return 8.0 + 19 * face.icons.index(kind.icon), ICONS, 14.0, 14.0
