"""Plain words for places and values: for headings, undo steps and summaries."""

from __future__ import annotations

import re
from typing import Any

from situ.document import rbd, spds
from situ.document import words as said
from situ.document.condition import Condition
from situ.document.drawing import Drawn, Note
from situ.document.project import Project
from situ.rehearse.ways import label
from situ_studio import kinds
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.wording.language import say, tr, translated


def state_words(document: Document, no: str) -> str:
    """``6 show names``, as ``state_called`` has it; the number alone where there is none."""
    state = document.state(no) if isinstance(document, rbd.Application) else None
    return state_called(no, state.name) if state is not None else no


def state_called(no: str, name: str) -> str:
    """What a state is called where nothing else says that it is one: ``6 show names``, and
    ``state 6`` where its name says no more than the number."""
    return state_alone(no, said.numbered(no, name))


def state_alone(no: str, told: str) -> str:
    """The same of what ``situ.document.words`` or a ``Teller`` tells of it."""
    return tr("state {0}").format(no) if told == no else told


def running_state(project: Project | None, application: str, no: str) -> str:
    """The same of a state that a trace names; of one in a part its own name."""
    return state_called(no, label(project, application, no) if project is not None else "")


def leads_to(document: Document, next_: str | None) -> str:
    """Where an event leads, in words."""
    if next_ is None:
        return tr("stays")
    if next_ == rbd.AGAIN:
        return tr("anew")
    if next_ == rbd.BACK:
        return tr("back")
    return state_words(document, next_)


def member_words(value: Any) -> str:
    """One member of a list: ``event clickNo``, ``speech``, ``button no``."""
    kind = kinds.kind_of(value)
    title = translated(kind.title).lower() if kind is not None else type(value).__name__.lower()
    if isinstance(value, rbd.Event):
        return tr("event {0}").format(value.name) if value.name else tr("unnamed event")
    if isinstance(value, rbd.Component):
        return f"{title} {value.id}"
    return title


def drawn_words(value: Drawn) -> str:
    """A note's first line or a frame's title; what it is where it has none."""
    text = value.text if isinstance(value, Note) else value.title
    return text.partition("\n")[0] or (tr("Note") if isinstance(value, Note) else tr("Frame"))


def place_words(document: Document, place: Place) -> str:
    """A place in words, from the inside out: ``event clickNo of state 6``."""
    if not place:
        return tr("the modules") if not hasattr(document, "name") else document.name
    if place[0] == "always":
        inner = place[1:]
        # Alone it is the card of that name: who deletes it deletes no state.
        outer = tr("every state") if inner else tr("“In every state”")
    elif place[0] == "state":
        outer, inner = tr("state {0}").format(place[1]), place[2:]
    elif place[0] in places.DRAWN:
        value = places.get(document, place)
        title = drawn_words(value) if value is not None else ""
        return tr("the frame {0}").format(title) if place[0] == "frame" else tr("a note")
    else:
        kind = next((k for k in kinds.KINDS if k.name == place[0]), None)
        what = translated(kind.title).lower() if kind is not None else place[0]
        outer, inner = " ".join((what, *place[1:2])), place[2:]
    if not inner:
        return outer
    value = places.get(document, place)
    if inner == ("screen",):
        return tr("the screen of {0}").format(outer)
    if value is None:
        return outer
    found = member_words(value)
    parent = places.get(document, place[:-2])
    if isinstance(parent, rbd.Event):
        found = tr("{0} in {1}").format(found, member_words(parent))
    return tr("{0} of {1}").format(found, outer)


def change_words(document: Document, place: Place, attribute: str, label: str) -> str:
    """The name of the step that changes one attribute of what stands at ``place``."""
    where = place_words(document, place)
    if attribute == "name" and place:
        return tr("Rename {0}").format(where)
    return tr("Change {0} of {1}").format(label.lower(), where)


def title(document: Document, place: Place) -> tuple[str, str, str, str]:
    """Heading of a place: icon, the colour's token, its name, and what it is (for the pill)."""
    value = places.get(document, place)
    kind = kinds.kind_of(value)
    if kind is None:
        return "info", "text2", "", ""
    icon, tint, called = kind.icon, str(kind.tint), translated(kind.title)
    if isinstance(value, Drawn):
        return icon, tint, drawn_words(value), called
    if isinstance(value, rbd.State):
        assert isinstance(document, rbd.Application)
        if document.start_no == value.no:
            icon, tint = "start", "start"
        number = tr("State {0}").format(value.no)
        return icon, tint, value.name or number.lower(), number
    if isinstance(value, rbd.Event):
        return icon, tint, value.name or tr("at once"), tr("Event of {0}").format(_owner(place))
    if isinstance(value, rbd.Component):
        name = kind.summary(value).split(" → ")[0] or value.id
        return icon, tint, name, tr("{0} of {1}").format(called, _owner(place))
    if isinstance(value, rbd.Action | rbd.Screen | rbd.Timeout):
        return icon, tint, called, _owner(place).capitalize()
    if isinstance(value, spds.Situation):
        assert isinstance(document, spds.Spds)
        where = tr("Situation {0} of {1}").format(
            document.situations.index(value) + 1, len(document.situations)
        )
        return icon, tint, value.name, where
    if isinstance(value, spds.Entry):
        return icon, tint, tr("{0} in {1}").format(value.module, place[1]), called
    if isinstance(value, rbd.Always):
        return icon, tint, called, tr("Part of every state")
    name = getattr(value, "name", None) or getattr(value, "tag", None) or called
    return icon, tint, name, called


def _owner(place: Place) -> str:
    return tr("every state") if place[0] == "always" else tr("state {0}").format(place[1])


def _raised(part: Any) -> list[str]:
    """The events that the screen and the actions of a state raise."""
    raised: list[str | None] = []
    if part.screen is not None:
        for component in part.screen.components:
            raised += [getattr(component, field, None) for field in ("event", "done", "failed")]
        raised.append(part.screen.touched)
    for action in getattr(part, "actions", ()):
        raised += [action.done, action.failed]
    return [name for name in raised if name]


def sent_next(part: Any) -> str | None:
    """The event that one more button sends: one without a name of its own that nothing raises yet.

    Somebody who first drew the way and then the button means that they belong together.
    """
    raised = _raised(part)
    for event in part.events:
        if event.name and event.name not in raised and re.fullmatch(r"event\d+", event.name):
            return str(event.name)
    return None


def expected_next(part: Any) -> str:
    """A name for one more event: of a button or action that the state does not expect yet."""
    known = {e.name for e in part.events}
    for name in _raised(part):
        if name not in known:
            return name
    number = len(part.events) + 1
    while f"event{number}" in known:
        number += 1
    return f"event{number}"


def situation_words(script: spds.Spds, situation: spds.Situation) -> str:
    """A situation in two or three sentences."""
    index = script.situations.index(situation)
    if situation.condition is None or not situation.condition.children:
        told = [tr("This always holds.")]
    else:
        told = [tr("This holds while {0}.").format(_clause(situation.condition))]
    if situation.until is not None and situation.until.children:
        told.append(tr("Once current it stays until {0}.").format(_clause(situation.until)))
    if situation.dwell is not None:
        told.append(tr("Once current it stays for {0} s at least.").format(f"{situation.dwell:g}"))
    if situation.limit is not None:
        text = tr("Once current it ends after {0} s at the latest.")
        told.append(text.format(f"{situation.limit:g}"))
    before = [s.name for s in script.situations[:index]]
    if not before:
        told.append(tr("It goes before all others."))
    elif len(before) == 1:
        told.append(tr("{0} goes first.").format(before[0]))
    else:
        told.append(tr("{0} go first.").format(listed(before)))
    every = sorted(script.priorities(situation).items(), key=lambda pair: -pair[1])
    if len(every) == 1:
        told.append(tr("{0} may move the robot.").format(every[0][0]))
    elif every:
        movers = listed([module for module, _ in every])
        told.append(tr("{0} may move the robot, in this order.").format(movers))
    else:
        told.append(tr("Nothing may move the robot."))
    return " ".join(told)


def listed(names: list[str]) -> str:
    """``a, b and c`` in the user's language."""
    if len(names) < 2:
        return "".join(names)
    return tr("{0} and {1}").format(tr(", ").join(names[:-1]), names[-1])


def _clause(condition: Condition) -> str:
    """A condition as a part of a sentence: each test has its verb."""
    verbs = {
        "above {0}": tr("is above {0}"),
        "below {0}": tr("is below {0}"),
        "at least {0}": tr("is at least {0}"),
        "at most {0}": tr("is at most {0}"),
    }
    return said.condition(condition, lambda text: verbs.get(text) or say(text))


def condition_words(condition: Condition | None) -> str:
    """A condition in one line; empty where there is none."""
    return said.condition(condition, say)
