"""The ways out of a state: every expected event and timeout that counts there, as tried.

formats.md, *Events*, *always*, *Parts*: those of the innermost state first, then those of
its file's ``always``, then outwards.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from situ.document import words
from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK, Action, Always, Application, Event, State, Timeout

Place = tuple[str, ...]


class Frame(Struct, frozen=True):
    """One file on the way into a part: the state of it that is active, and its full number."""

    file: str
    application: Application
    state: State
    no: str

    @property
    def before(self) -> str:
        """What stands before the numbers of this run: empty, or ``5/``."""
        return self.no[: len(self.no) - len(self.state.no)]


class Way(Struct, frozen=True):
    """An expected event or a timeout that counts in a state.

    place: in ``file``. source: the state that has it, by full number, or ``always``.
    before: what stands before the numbers of its file's states. next: as written; to:
    the full number it leads to, ``#again``, ``#back``, or None.
    """

    file: str
    place: Place
    source: str
    before: str
    says: Event | Timeout
    next: str | None
    to: str | None

    @property
    def event(self) -> Event | None:
        return self.says if isinstance(self.says, Event) else None

    @property
    def timeout(self) -> Timeout | None:
        return self.says if isinstance(self.says, Timeout) else None

    @property
    def exit(self) -> str:
        """What it is called: ``clickYes``, ``at once``, ``timeout``."""
        return "timeout" if self.event is None else self.event.name or "at once"


def file_of(project: Project, application: str) -> str | None:
    """The file of the application of that name."""
    return next((f for f, a in project.applications.items() if a.name == application), None)


def frames(project: Project, application: str, no: str) -> list[Frame]:
    """The active states of an application at ``no``, outermost first; empty: no such state."""
    file = file_of(project, application)
    return [] if file is None else _frames(project, file, no, "", ())


def _frames(
    project: Project, file: str, no: str, before: str, seen: tuple[str, ...]
) -> list[Frame]:
    application = _document(project, file)
    if application is None or file in seen:
        return []
    state = application.state(no)
    if state is not None:
        return [Frame(file, application, state, before + no)]
    # The states of a part stand behind the number of the state that holds it.
    for outer in application.states:
        if outer.flow is not None and no.startswith(f"{outer.no}/"):
            rest, path = no[len(outer.no) + 1 :], f"{before}{outer.no}"
            inner = _frames(project, outer.flow, rest, f"{path}/", (*seen, file))
            if inner:
                return [Frame(file, application, outer, path), *inner]
    return []


def _document(project: Project, file: str) -> Application | None:
    return project.applications.get(file) or project.parts.get(file)


def name_of_state(project: Project, application: str, no: str) -> str:
    """``6 show names``: number and label of a state, the number alone where that says no more."""
    return words.numbered(no, label(project, application, no))


def label(project: Project, application: str, no: str) -> str:
    """``show names``: the name of a state, of one of a part the inner one; empty for none."""
    found = frames(project, application, no)
    return found[-1].state.name if found else ""


def ways(project: Project, application: str, no: str) -> list[Way]:
    """All ways of the state ``no``: its events in the order in which they are tried, last the
    timeout that serves.
    """
    found: list[Way] = []
    timeout: Way | None = None
    inward = frames(project, application, no)
    for frame in reversed(inward):
        place = ("state", frame.state.no)
        always = frame.application.always if frame.state.always else None
        found += [_way(frame, place, frame.no, i, e) for i, e in enumerate(frame.state.events)]
        if always is not None:
            found += [_way(frame, ("always",), "always", i, e) for i, e in enumerate(always.events)]
        if timeout is None:
            timeout = _timeout(frame, frame.state, place, frame.no)
        if timeout is None and always is not None:
            timeout = _timeout(frame, always, ("always",), "always")
    return found if timeout is None else [*found, timeout]


def _way(frame: Frame, place: Place, source: str, index: int, event: Event) -> Way:
    where = (*place, "event", str(index))
    return Way(
        frame.file, where, source, frame.before, event, event.next, _target(frame, event.next)
    )


def _timeout(frame: Frame, holder: State | Always, place: Place, source: str) -> Way | None:
    timeout = holder.timeout
    if timeout is None:
        return None
    where, to = (*place, "timeout"), _target(frame, timeout.next)
    return Way(frame.file, where, source, frame.before, timeout, timeout.next, to)


def _target(frame: Frame, target: str | None) -> str | None:
    if target is None or target in (AGAIN, BACK):
        return target
    return frame.before + target


def states(project: Project, application: str) -> Iterator[Frame]:
    """Every state of an application, those of its parts under their full numbers too."""
    file = file_of(project, application)
    if file is not None:
        yield from _states(project, file, "", ())


def _states(project: Project, file: str, before: str, seen: tuple[str, ...]) -> Iterator[Frame]:
    application = _document(project, file)
    if application is None or file in seen:
        return
    for state in application.states:
        path = before + state.no
        yield Frame(file, application, state, path)
        if state.flow is not None:
            yield from _states(project, state.flow, f"{path}/", (*seen, file))


def entered(project: Project, application: str, way: Way) -> str | None:
    """The state that a way ends in, of a part its start; None where only the run can tell."""
    return None if way.to == AGAIN else _inmost(project, application, way.to)


def _inmost(project: Project, application: str, to: str | None) -> str | None:
    if to is None or to == BACK:
        return None
    flow = frames(project, application, to)[-1].state.flow
    part = None if flow is None else _document(project, flow)
    return to if part is None else _inmost(project, application, f"{to}/{part.start_no}")


def leads_to(project: Project, application: str, way: Way, here: str, target: str) -> bool:
    """Whether a way out of ``here``, not back, leads to ``target``."""
    to = way.to
    if to == AGAIN:
        to = next(f.no for f in frames(project, application, here) if f.before == way.before)
    inmost = _inmost(project, application, to)
    return (
        inmost is not None
        and f"{inmost}/".startswith(f"{target}/")
        and f"{target}/".startswith(f"{to}/")
    )


def actions(project: Project, application: str) -> Iterator[tuple[str, Place, Frame, Action]]:
    """Every action of an application with its file, place and the state that it belongs to;
    those of events and of ``always`` too.
    """
    told: set[tuple[str, Place]] = set()
    for frame in states(project, application):
        for index, action in enumerate(frame.state.actions):
            yield frame.file, ("state", frame.state.no, "action", str(index)), frame, action
        for way in ways(project, application, frame.no):
            if way.event is None or (way.file, way.place) in told:
                continue
            told.add((way.file, way.place))
            for index, action in enumerate(way.event.actions):
                yield way.file, (*way.place, "action", str(index)), frame, action


def way_words(way: Way) -> str:
    """An event in words: ``event clickYes of always``, ``the unnamed event (x is 1)``."""
    event = way.event
    assert event is not None
    said = f"event {event.name}" if event.name else "the unnamed event"
    if event.when is not None and not event.name:
        said = f"the unnamed event ({words.condition(event.when)})"
    return f"{said} of always" if way.source == "always" else said
