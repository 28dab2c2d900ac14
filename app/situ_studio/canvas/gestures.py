"""What gestures make of an application: pure functions, document in, document and words out.

Every function returns the new document and the edit's name as a designer reads
it in the Edit menu; the same document where the gesture changes nothing. States
go by number, exits by place (``("state", "5", "event", "0")``). No Qt.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from msgspec import Struct
from msgspec.structs import replace

from situ.document import rbd
from situ.document.aside import NOTHING
from situ.document.rbd import Application, Event, State
from situ_studio.canvas import figures
from situ_studio.canvas.picture import ALWAYS, NEW, TIMEOUT, exit_of
from situ_studio.canvas.projection import targets
from situ_studio.edits import changes, places, words
from situ_studio.edits.edit import Place
from situ_studio.wording.language import count, tr, translated

GRID = 8.0
"""Cards snap to this."""

Done = tuple[Application, str]


class Follow(Struct, frozen=True):
    """One answer to *what can follow*. key: what ``follow`` is called with."""

    key: str
    label: str
    icon: str
    words: str = ""


FOLLOWS: tuple[Follow, ...] = (
    Follow("state", "New state", "state", "empty card"),
    Follow("speech", "New state that says something", "speech", "speech talk voice"),
    Follow("question", "New question with Yes and No", "button", "ask buttons screen"),
    Follow("service", "New state that calls a service", "service", "web request"),
    Follow("robot", "New state that moves the robot", "robot", "drive head go"),
    Follow("end", "New end state", "end", "finish stop final"),
    Follow(rbd.BACK, "Back to the state before", "undo", "#back return"),
    Follow(rbd.AGAIN, "This state again", "repeat", "#again once more"),
    Follow("", "Stay here", "close", "nothing internal disconnect"),
)


def snap(value: float) -> float:
    return math.floor(value / GRID + 0.5) * GRID


def called(application: Application, place: Place) -> str:
    """What a place is called: ``state 5``, ``clickYes of state 5``, ``the timeout of state 5``."""
    if place[:1] and place[0] in places.DRAWN:
        return words.place_words(application, place)
    always = place[:1] == (ALWAYS,)
    owner = tr("every state") if always else tr("state {0}").format(place[1])
    exit = exit_of(place)
    if exit is None:
        return tr("what every state has") if always else owner
    if exit == TIMEOUT:
        return tr("the timeout of {0}").format(owner)
    event = places.get(application, place)
    name = event.name if isinstance(event, Event) and event.name else tr("the unnamed event")
    return tr("{0} of {1}").format(name, owner)


def title(application: Application, no: str) -> str:
    """A state as it is named in an edit: ``5 names``."""
    return words.state_words(application, no)


def move(application: Application, to: Mapping[Place, tuple[float, float]]) -> Done:
    """Cards put at new places; places that no card has are left out."""
    moved = 0
    states = list(application.states)
    numbers = {place[1] for place in to if place[0] == "state" and len(place) == 2}
    for index in [i for i, state in enumerate(states) if state.no in numbers]:
        state = states[index]
        at = to["state", state.no]
        if state.aside.position != at:
            states[index] = replace(state, aside=state.aside.at(*at))
            moved += 1
    always = application.always
    target = to.get((ALWAYS,))
    if always is not None and target is not None and always.aside.position != target:
        always = replace(always, aside=always.aside.at(*target))
        moved += 1
    drawn = {
        place: at
        for place, at in to.items()
        if place[0] in places.DRAWN and _drawn_at(application, place) != at
    }
    moved += len(drawn)
    if not moved:
        return application, ""
    after = figures.move(replace(application, states=tuple(states), always=always), drawn)
    one = next(iter(to))
    if len(to) == 1:
        return after, tr("Move {0}").format(called(application, one))
    many = tr("Move {0} things") if drawn else tr("Move {0} cards")
    return after, many.format(len(to))


def _drawn_at(application: Application, place: Place) -> tuple[float, float] | None:
    value = places.get(application, place)
    return (value.x, value.y) if value is not None else None


def connect(application: Application, place: Place, target: str) -> Done:
    """The exit at ``place`` leads to ``target`` (a number, ``#back`` or ``#again``)."""
    leaving = places.get(application, place)
    if leaving is None or leaving.next == target:
        return application, ""
    after = places.change(application, place, next=target)
    goal = {rbd.BACK: tr("the state before"), rbd.AGAIN: tr("itself")}.get(target)
    leads = called(application, place)
    return after, tr("Lead {0} to {1}").format(leads, goal or title(application, target))


def disconnect(application: Application, place: Place) -> Done:
    """The exit leads nowhere: its event becomes internal; an unnamed one goes."""
    leaving = places.get(application, place)
    if leaving is None or leaving.next is None:
        return application, ""
    text = tr("Disconnect {0}").format(called(application, place))
    if isinstance(leaving, Event) and leaving.name is None:
        after = places.put(application, place, None)
    else:
        after = places.change(application, place, next=None)
    return after, text


def add_event(
    application: Application, owner: Place, target: str | None, name: str | None = None
) -> Done:
    """A further expected event of a card, leading to ``target``."""
    value = places.get(application, owner)
    if value is None:
        return application, ""
    event = Event(name=name or words.expected_next(value), next=target)
    after = places.change(application, owner, events=(*value.events, event))
    added = event.name, called(application, owner)
    if not target:
        return after, tr("Add {0} of {1}").format(*added)
    return after, tr("Add {0} of {1} to {2}").format(*added, title(application, target))


def lead(application: Application, owner: Place, exit: str, target: str) -> Done:
    """What dropping a pipe on a card does: connects the exit; the new one adds an event."""
    if exit == NEW:
        return add_event(application, owner, target)
    return connect(application, exit_place(owner, exit), target)


def exit_place(owner: Place, exit: str) -> Place:
    return (*owner, TIMEOUT) if exit == TIMEOUT else (*owner, "event", exit)


def choices(application: Application, owner: Place, exit: str) -> tuple[Follow, ...]:
    """Every answer to *what can follow* an exit of a card: new states, then those there are."""
    leaving = places.get(application, exit_place(owner, exit)) if exit != NEW else None
    stays = leaving is None or leaving.next is not None
    always = owner == (ALWAYS,)
    known = (
        Follow(s.no, words.state_called(s.no, s.name), "state", tr("existing state"))
        for s in application.states
    )
    return (
        *(
            replace(f, label=translated(f.label), words=f"{f.words} {translated(f.words)}")
            for f in FOLLOWS
            if (f.key or stays) and not (always and f.key == rbd.AGAIN)
        ),
        *known,
    )


def _new(kind: str, no: str) -> State:
    name = tr("state {0}").format(no)
    match kind:
        case "speech":
            return State(no=no, name=name, actions=(rbd.Speech(text=tr("Hello")),))
        case "service":
            service = rbd.Service(name="service", url="http://", done="returned", failed="offline")
            events = (Event(name="returned"), Event(name="offline"))
            return State(no=no, name=name, actions=(service,), events=events)
        case "robot":
            action = rbd.Robot(resource="base", command="goto", done="arrived", failed="blocked")
            return State(
                no=no,
                name=name,
                actions=(action,),
                events=(Event(name="arrived"), Event(name="blocked")),
            )
        case "question":
            asked = tr("Shall I?")
            screen = rbd.Screen(
                components=(
                    rbd.Text(id="question", x=10, y=12, width=80, height=30, text=asked),
                    rbd.Button(
                        id="yes", x=10, y=60, width=35, height=24, event="clickYes", text=tr("Yes")
                    ),
                    rbd.Button(
                        id="no", x=55, y=60, width=35, height=24, event="clickNo", text=tr("No")
                    ),
                )
            )
            return State(
                no=no,
                name=name,
                screen=screen,
                actions=(rbd.Speech(text=asked),),
                events=(Event(name="clickYes"), Event(name="clickNo")),
            )
        case "end":
            return State(no=no, name=tr("end"), final=True)
        case _:
            return State(no=no, name=name)


def add_state(
    application: Application, x: float, y: float, kind: str = "state"
) -> tuple[Application, str, str]:
    """A new state at that place. Returns the document, the edit's name and the state's number."""
    no = changes.free_number(application)
    state = _new(kind, no)
    state = replace(state, aside=NOTHING.at(snap(x), snap(y)))
    after = replace(application, states=(*application.states, state))
    return after, tr("Add state {0}").format(no), no


def follow(
    application: Application, owner: Place, exit: str, key: str, x: float, y: float
) -> tuple[Application, str, str | None]:
    """The answer ``key`` to *what can follow* the exit: a kind of new state, placed at x, y,
    the number of one that there is, ``#back``, ``#again``, or "" for staying.

    Returns the document, the edit's name and the number of the state that was added, if one was.
    """
    if key == "":
        if exit == NEW:
            after, text = add_event(application, owner, None)
        else:
            after, text = disconnect(application, exit_place(owner, exit))
        return after, text, None
    kinds = {f.key for f in FOLLOWS if f.key and not f.key.startswith("#")}
    if key not in kinds or application.state(key) is not None:
        after, text = lead(application, owner, exit, key)
        return after, text, None
    after, _, no = add_state(application, x, y, key)
    after, _ = lead(after, owner, exit, no)
    return after, tr("Add state {0} after {1}").format(no, called(application, owner)), no


def last_number(application: Application) -> str:
    """The number of the state that was added last."""
    return application.states[-1].no


def insert(application: Application, link: Place, x: float, y: float) -> Done:
    """A new state in the middle of a pipe: the exit leads to it, and it leads on."""
    leaving = places.get(application, link)
    if leaving is None or leaving.next is None:
        return application, ""
    after, _, no = add_state(application, x, y)
    after = places.change(after, link, next=no)
    after, _ = add_event(after, ("state", no), leaving.next)
    return after, tr("Insert state {0}").format(no)


def put_between(application: Application, link: Place, no: str) -> Done:
    """A state that there is, put into a pipe: the exit leads to it, and it leads on."""
    leaving, state = places.get(application, link), application.state(no)
    if leaving is None or leaving.next in (None, no) or state is None:
        return application, ""
    after = places.change(application, link, next=no)
    if leaving.next not in targets(state):
        after, _ = add_event(after, ("state", no), leaving.next)
    return after, tr("Insert state {0}").format(no)


def rename(application: Application, no: str, name: str) -> Done:
    state = application.state(no)
    name = " ".join(name.split())
    if state is None or not name or state.name == name:
        return application, ""
    after = places.change(application, ("state", no), name=name)
    return after, tr("Rename state {0} to {1}").format(no, name)


def delete(application: Application, gone: Iterable[Place]) -> Done:
    """States with the pipes to them, events and timeouts; ``always`` too."""
    wanted = list(dict.fromkeys(gone))
    if not wanted:
        return application, ""
    drawn = [p for p in wanted if p[0] in places.DRAWN and places.get(application, p) is not None]
    after = figures.remove(application, drawn)
    what = [called(application, place) for place in drawn]
    # From the last event to the first, so that positions still fit.
    exits = [p for p in wanted if exit_of(p) is not None]
    exits.sort(key=lambda p: (p[:-1], int(p[-1]) if p[-1].isdigit() else -1), reverse=True)
    for place in exits:
        if places.get(after, place) is not None:
            what.append(called(application, place))
            after = places.put(after, place, None)
    for place in wanted:
        if place == (ALWAYS,) and after.always is not None:
            what.append(called(application, place))
            after = replace(after, always=None)
        elif place[:1] == ("state",) and len(place) == 2 and after.state(place[1]) is not None:
            what.append(called(application, place))
            after = changes.remove_state(after, place[1])
    if not what:
        return application, ""
    if len(what) == 1:
        return after, tr("Delete {0}").format(what[0])
    return after, tr("Delete {0} things").format(len(what))


def followers(application: Application, numbers: Iterable[str]) -> tuple[str, ...]:
    """The states to which these lead themselves, in document order."""
    wanted = set(numbers)
    reached = {t for s in application.states if s.no in wanted for t in targets(s)}
    return tuple(s.no for s in application.states if s.no in reached)


def leading(application: Application, numbers: Iterable[str]) -> tuple[str, ...]:
    """The states that lead to these themselves, in document order."""
    wanted = set(numbers)
    return tuple(s.no for s in application.states if not wanted.isdisjoint(targets(s)))


def mark_start(application: Application, no: str) -> Done:
    """The application starts in that state."""
    if application.start_no == no or application.state(no) is None:
        return application, ""
    return replace(application, start=no), tr("Start in {0}").format(title(application, no))


def snap_all(application: Application, shown: Mapping[Place, tuple[float, float]]) -> Done:
    """Cards put on the nearest points of the grid. shown: where they are."""
    to = {place: (snap(x), snap(y)) for place, (x, y) in shown.items()}
    moved = {place: at for place, at in to.items() if at != shown[place]}
    after, text = move(application, moved) if moved else (application, "")
    told = count(len(moved), tr("Put {0} card on the grid"), tr("Put {0} cards on the grid"))
    return after, told if text else ""


# -- order on the canvas ---------------------------------------------------------


class Area(Struct, frozen=True):
    """A card's rectangle, for aligning."""

    x: float
    y: float
    width: float
    height: float


def align(application: Application, areas: Mapping[Place, Area], edge: str) -> Done:
    """edge: left, center, right, top, middle, bottom; or across, down: spaced evenly."""
    if len(areas) < 2 or (edge in ("across", "down") and len(areas) < 3):
        return application, ""
    every = list(areas.items())
    values = [a for _, a in every]
    left, right = min(a.x for a in values), max(a.x + a.width for a in values)
    top, bottom = min(a.y for a in values), max(a.y + a.height for a in values)
    to: dict[Place, tuple[float, float]] = {}
    if edge == "across":
        every.sort(key=lambda i: i[1].x)
        step = (every[-1][1].x - every[0][1].x) / (len(every) - 1)
        for index, (place, area) in enumerate(every):
            to[place] = (every[0][1].x + index * step, area.y)
    elif edge == "down":
        every.sort(key=lambda i: i[1].y)
        step = (every[-1][1].y - every[0][1].y) / (len(every) - 1)
        for index, (place, area) in enumerate(every):
            to[place] = (area.x, every[0][1].y + index * step)
    else:
        for place, area in every:
            x, y = area.x, area.y
            match edge:
                case "left":
                    x = left
                case "right":
                    x = right - area.width
                case "center":
                    x = (left + right - area.width) / 2
                case "top":
                    y = top
                case "bottom":
                    y = bottom - area.height
                case "middle":
                    y = (top + bottom - area.height) / 2
            to[place] = (x, y)
    after, text = move(application, to)
    told = tr("Distribute {0} cards") if edge in ("across", "down") else tr("Align {0} cards")
    return after, told.format(len(areas)) if text else ""
