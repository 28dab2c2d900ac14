"""Copies of states, notes and frames, within an application and from one to another."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec.structs import replace

from situ.document import drawing
from situ.document.rbd import Application, State, Timeout
from situ_studio.canvas import figures
from situ_studio.edits import changes, places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Pasted = tuple[Application, str, tuple[Place, ...]]
"""The document, the edit's name, and the places of the copies."""

COLUMN, ROW = 230.0, 228.0
OFFSET = 32.0
"""How far a copy lies from what it is one of."""


def fragment(application: Application, chosen: Iterable[Place]) -> Application:
    """What stands at some places as an application of its own: states, notes and frames.

    What leads out of the states is kept; other places are left out.
    """
    chosen = tuple(chosen)
    wanted = {place[1] for place in chosen if place[0] == "state" and len(place) == 2}
    states = tuple(s for s in application.states if s.no in wanted)
    made = Application(name=application.name, states=states)
    # Notes ride along with the state before which they stand in the file.
    made = figures.remove(made, _drawn(made))
    return figures.pasted(made, figures.copied(application, chosen), 0, 0)[0]


def is_empty(copied: Application) -> bool:
    """Whether there is nothing in it to be pasted."""
    return not copied.states and not drawing.drawn(copied)


def counted(copied: Application) -> str:
    """``1 state``, ``3 states``, ``2 notes``; ``4 things`` of several kinds."""
    every = [*("state" for _ in copied.states), *(place[0] for place in _drawn(copied))]
    kind = every[0] if len(set(every)) == 1 else ""
    if len(every) == 1:
        one = {"state": tr("1 state"), "note": tr("1 note"), "frame": tr("1 frame")}
        return one[kind]
    many = {"state": tr("{0} states"), "note": tr("{0} notes"), "frame": tr("{0} frames")}
    return many.get(kind, tr("{0} things")).format(len(every))


def named(copied: Application) -> str:
    """``state 5``, ``a note``; else as ``counted``."""
    drawn = _drawn(copied)
    if len(copied.states) + len(drawn) != 1:
        return counted(copied)
    if copied.states:
        return tr("state {0}").format(copied.states[0].no)
    return tr("a note") if drawn[0][0] == "note" else tr("a frame")


def _drawn(application: Application) -> list[Place]:
    found: list[Place] = []
    for value in drawing.drawn(application):
        kind = next(kind for kind, type_ in places.DRAWN.items() if isinstance(value, type_))
        found.append((kind, str(sum(place[0] == kind for place in found))))
    return found


def _spots(copied: Application) -> list[tuple[float, float]]:
    """Where each state is, in the document's order; one beside the other without a place."""
    return [s.aside.position or (i * COLUMN, 0.0) for i, s in enumerate(copied.states)]


def corner(copied: Application) -> tuple[float, float]:
    """The upper left corner of all of it."""
    spots = [*_spots(copied), *((one.x, one.y) for one in drawing.drawn(copied))]
    return min(x for x, _ in spots), min(y for _, y in spots)


def below(application: Application) -> tuple[float, float]:
    """A corner under everything that an application has."""
    spots = [*_spots(application), *((d.x, d.y + d.height) for d in drawing.drawn(application))]
    if not spots:
        return 0.0, 0.0
    return min(x for x, _ in spots), max(y for _, y in spots) + ROW


def fits(application: Application, copied: Application) -> bool:
    """Whether there are states among it and their numbers are free, as after a cut."""
    taken = {s.no for s in application.states}
    return bool(copied.states) and not any(s.no in taken for s in copied.states)


def paste(
    application: Application,
    copied: Application,
    at: tuple[float, float],
    text: str = "",
    same: bool = False,
) -> Pasted:
    """What was copied, with its upper left corner at ``at``.

    same: it comes from this very document. Then states whose numbers are all free, as after a
    cut, keep them, and what led from them to other states of the document still does. All others
    get new numbers. What led from one copied state to another leads between the copies; what
    else led somewhere leads nowhere: an event becomes internal, an unnamed one goes.
    """
    if is_empty(copied):
        return application, "", ()
    left, top = corner(copied)
    across, down = at[0] - left, at[1] - top
    first = int(changes.free_number(application))
    keep = same and fits(application, copied)
    numbers = {s.no: s.no if keep else str(first + i) for i, s in enumerate(copied.states)}
    here = {s.no for s in application.states} if same else set()

    def goal(target: str | None) -> str | None:
        if target is None or target.startswith("#"):
            return target
        return numbers.get(target) or (target if target in here else None)

    states: list[State] = []
    for state, (x, y) in zip(copied.states, _spots(copied), strict=True):
        events = tuple(
            event
            for event in (replace(e, next=goal(e.next)) for e in state.events)
            if event.name is not None or event.next is not None
        )
        timeout: Timeout | None = state.timeout
        if timeout is not None:
            timeout = replace(timeout, next=goal(timeout.next))
        states.append(
            replace(
                state,
                no=numbers[state.no],
                events=events,
                timeout=timeout,
                aside=state.aside.at(x + across, y + down),
            )
        )
    drawn = drawing.drawn(copied)
    stripped = figures.remove(replace(copied, states=tuple(states)), _drawn(copied))
    after = replace(application, states=(*application.states, *stripped.states))
    after, made = figures.pasted(after, drawn, across, down)
    text = (text or tr("Paste {0}")).format(named(copied))
    return after, text, (*(("state", s.no) for s in states), *made)


def duplicate(application: Application, chosen: Iterable[Place]) -> Pasted:
    """Copies of what stands at some places, a little below and to the right of it."""
    copied = fragment(application, chosen)
    if is_empty(copied):
        return application, "", ()
    left, top = corner(copied)
    return paste(application, copied, (left + OFFSET, top + OFFSET), tr("Duplicate {0}"), same=True)
