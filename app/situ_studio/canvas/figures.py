"""Notes and frames as values for the canvas: what is shown of them, and what gestures make of them.

A frame holds the cards, notes and frames that lie in it wholly, and takes them along. Pure; no Qt.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal

from msgspec import Struct
from msgspec.structs import replace

from situ.document import drawing
from situ.document.drawing import Drawn, Frame, Note
from situ.document.rbd import Application
from situ_studio.edits import places, words
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Area = tuple[float, float, float, float]
"""Left, top, width and height in the scene."""

USUAL = {"frame": "module", "note": "condition"}
"""The colours of those that say none, by the kind whose colour it is."""
KINDS_OF = {
    "#46536a": "state",
    "#0b7a4b": "start",
    "#0a5a4c": "module",
    "#086d9c": "data",
    "#5d4bb0": "part",
    "#8a2178": "situation",
    "#7c2d0c": "resource",
    "#8a5f00": "condition",
}
"""The colours that the studio writes: those of the kinds, so that they fit any ground."""
ROOM, HEAD = 24.0, 44.0
"""What a frame leaves round what it is put around, and above it for the title."""
LEAST = {"frame": (96.0, 64.0), "note": (64.0, 40.0)}


class Figure(Struct, frozen=True):
    """All that a note or a frame shows; as cards are, but without exits."""

    uid: str
    place: Place
    kind: Literal["note", "frame"]
    text: str
    color: str
    x: float
    y: float
    width: float
    height: float

    @property
    def name(self) -> str:
        return self.text

    @property
    def no(self) -> str:
        return ""

    @property
    def many(self) -> bool:
        return False

    @property
    def inputs(self) -> tuple[str, ...]:
        return ()

    @property
    def outputs(self) -> tuple[str, ...]:
        return ()

    @property
    def area(self) -> Area:
        return self.x, self.y, self.width, self.height

    def port(self, name: str) -> tuple[float, float]:
        return 0.0, 0.0

    def hint(self, name: str = "") -> str:
        first = self.text.partition("\n")[0]
        return f"{self.kind.capitalize()} {first}".rstrip()

    def spoken(self) -> str:
        return self.text


def shown(application: Application, before: Mapping[str, Figure]) -> dict[str, Figure]:
    """What is drawn, by uid, frames first; those that are as ``before`` are the same values."""
    counts = {"note": 0, "frame": 0}
    found: dict[str, Figure] = {}
    for value in drawing.drawn(application):
        kind: Literal["note", "frame"] = "note" if isinstance(value, Note) else "frame"
        at = str(counts[kind])
        counts[kind] += 1
        uid = f"{kind} {at}"
        made = Figure(
            uid=uid,
            place=(kind, at),
            kind=kind,
            text=value.text if isinstance(value, Note) else value.title,
            color=value.color,
            x=value.x,
            y=value.y,
            width=max(value.width, LEAST[kind][0]),
            height=max(value.height, LEAST[kind][1]),
        )
        old = before.get(uid)
        found[uid] = old if old == made and old is not None else made
    return dict(sorted(found.items(), key=lambda item: item[1].kind))


# -- what lies in a frame --------------------------------------------------------------


def held(frame: Area, areas: Mapping[str, Area]) -> list[str]:
    """Which of these lie wholly in the frame."""
    left, top, width, height = frame
    return [
        uid
        for uid, (x, y, w, h) in areas.items()
        if (x, y, w, h) != frame
        and left <= x
        and top <= y
        and x + w <= left + width
        and y + h <= top + height
    ]


def around(areas: Iterable[Area]) -> Area:
    """Where a frame goes that shall hold all these."""
    every = list(areas)
    left, top = min(a[0] for a in every) - ROOM, min(a[1] for a in every) - HEAD
    right = max(a[0] + a[2] for a in every) + ROOM
    bottom = max(a[1] + a[3] for a in every) + ROOM
    return left, top, right - left, bottom - top


def arranged(
    figures: Iterable[Figure], cards: Mapping[str, Area], placed: Mapping[str, tuple[float, float]]
) -> dict[str, Area]:
    """Where notes and frames go when cards are placed anew: a note with the card next to it, a
    frame round what it held; an empty one stays. cards: where they were."""
    before = {**cards, **{one.uid: one.area for one in figures}}
    after = {uid: (*placed.get(uid, area[:2]), *area[2:]) for uid, area in cards.items()}
    found: dict[str, Area] = {}
    every = sorted(figures, key=lambda one: (one.kind == "frame", one.width * one.height))
    for one in every:
        if one.kind == "note":
            near = min(cards, key=lambda uid: _apart(one.area, cards[uid]), default=None)
            if near is None:
                continue
            across, down = after[near][0] - cards[near][0], after[near][1] - cards[near][1]
            found[one.uid] = one.x + across, one.y + down, one.width, one.height
        else:
            inside = [u for u in held(one.area, before) if u in after]
            if not inside:
                continue
            found[one.uid] = around(after[uid] for uid in inside)
        after[one.uid] = found[one.uid]
    return found


def _apart(one: Area, other: Area) -> float:
    across = one[0] + one[2] / 2 - other[0] - other[2] / 2
    down = one[1] + one[3] / 2 - other[1] - other[3] / 2
    return across * across + down * down


# -- what gestures make of them ----------------------------------------------------------


def add(application: Application, value: Drawn) -> tuple[Application, Place, str]:
    """One more; its place, and the edit's name."""
    kind = "note" if isinstance(value, Note) else "frame"
    count = sum(1 for one in drawing.drawn(application) if isinstance(one, type(value)))
    text = tr("Add note") if kind == "note" else tr("Add frame")
    return drawing.add(application, value), (kind, str(count)), text


def put(application: Application, place: Place, area: Area) -> tuple[Application, str]:
    """Another place and size, by a handle."""
    value = places.get(application, place)
    x, y, width, height = area
    if value is None or (value.x, value.y, value.width, value.height) == area:
        return application, ""
    after = places.change(application, place, x=x, y=y, width=width, height=height)
    return after, tr("Resize {0}").format(words.place_words(application, place))


def move(application: Application, to: Mapping[Place, tuple[float, float]]) -> Application:
    """Notes and frames at other places; places of other things are left out."""
    for place, (x, y) in to.items():
        if place[0] in places.DRAWN:
            application = places.change(application, place, x=x, y=y)
    return application


def write(application: Application, place: Place, text: str) -> tuple[Application, str]:
    """A note's text, or a frame's title."""
    value = places.get(application, place)
    text = text.strip()
    if isinstance(value, Note):
        if value.text == text:
            return application, ""
        return places.change(application, place, text=text), tr("Change the text of a note")
    if value is None or value.title == text:
        return application, ""
    return places.change(application, place, title=text), tr("Call a frame {0}").format(
        text
    ).rstrip()


def remove(application: Application, gone: Iterable[Place]) -> Application:
    """Without these notes and frames; places of other things are left out."""
    wanted = [place for place in dict.fromkeys(gone) if place[0] in places.DRAWN]
    for place in sorted(wanted, key=lambda p: int(p[1]), reverse=True):
        application = places.put(application, place, None)
    return application


def copied(application: Application, chosen: Iterable[Place]) -> tuple[Drawn, ...]:
    """The notes and frames at these places."""
    found = (places.get(application, p) for p in chosen if p[0] in places.DRAWN)
    return tuple(one for one in found if isinstance(one, Note | Frame))


def pasted(
    application: Application, values: Iterable[Drawn], across: float, down: float
) -> tuple[Application, tuple[Place, ...]]:
    """Copies of them, so far from where they were; and the places of the copies."""
    made: list[Place] = []
    for value in values:
        moved = replace(value, x=value.x + across, y=value.y + down)
        application, place, _ = add(application, moved)
        made.append(place)
    return application, tuple(made)
