"""The ways out of states: which events and timeouts can be taken where.

What is claimed, state by state: an event is taken at some moment, whatever the values then
are. It needs a guard that can hold, no earlier event of its name that always comes first,
and a state that is not left before: an event without a name is taken as soon as it holds,
so named events and timeouts get their turn only while no such event holds. ``#back`` is
refused in the start state, where its stack is empty, and nowhere else: the stack of every
other state begins with the start state.

A state with a flow is judged carefully: its own events are tried after those of the part.
"""

from __future__ import annotations

from msgspec import Struct

from situ.document.analysis_search import Search
from situ.document.finding import Place
from situ.document.rbd import AGAIN, BACK, RESUMED, Application, Event, State, Timeout
from situ.document.satisfy import ALWAYS, NEVER, Node


class Way(Struct, frozen=True, eq=False):
    """An event (or, None, the timeout) that can be taken in a state; ``next`` None: stays.

    when: the moments at which it is taken, once its turn comes; ``place``: of the event or
    timeout.
    """

    source: str
    next: str | None
    event: Event | None
    place: Place
    when: tuple[Node, ...] = ()


class Dead(Struct, frozen=True, eq=False):
    """An event or timeout that is never taken in a state.

    why: ``guard`` (its own never holds), ``back`` (``#back`` in the start state), ``earlier``
    (those in ``by`` are always taken first), ``left`` (the state is left at once by those in
    ``by``, which have no name).
    """

    event: Event | None
    timeout: Timeout | None
    place: Place
    why: str
    by: tuple[Place, ...] = ()


class Candidate(Struct, frozen=True, eq=False):
    event: Event
    place: Place
    guard: Node


class Ways:
    """The ways of one application.

    of: by number of the state, its ways in the order in which they are tried; dead: by number,
    what is never taken there. unnamed: by number, the candidates without a name. Everything
    of ``always`` stands with each state that it is part of.
    """

    def __init__(self, search: Search, file: str, application: Application) -> None:
        self.application = application
        self.file = file
        self.of: dict[str, list[Way]] = {}
        self.dead: dict[str, list[Dead]] = {}
        self.left_at_once: set[str] = set()
        self._search = search
        self._start = application.start_no
        self._numbers = {state.no for state in application.states}
        always = application.always
        self._shared = [
            Candidate(event, ("always", "event", str(at)), search.moment.node(event.when))
            for at, event in enumerate(always.events if always is not None else ())
        ]
        for state in application.states:
            if state.no not in self.of:
                self._state(state)
        search.go_on()

    def timeout(self, state: State) -> tuple[Timeout, Place] | None:
        """The timeout that serves in a state, and where it stands."""
        if state.timeout is not None:
            return state.timeout, ("state", state.no, "timeout")
        always = self.application.always_in(state)
        if always is not None and always.timeout is not None:
            return always.timeout, ("always", "timeout")
        return None

    def candidates(self, state: State) -> list[Candidate]:
        """The events that a state expects, its own first."""
        node = self._search.moment.node
        place = ("state", state.no, "event")
        own = [
            Candidate(event, (*place, str(at)), node(event.when))
            for at, event in enumerate(state.events)
        ]
        return [*own, *self._shared] if state.always else own

    def targets(self, way: Way) -> list[str]:
        """The states to which a way leads, but for ``#back``."""
        if way.next == AGAIN:
            return [way.source]
        return [way.next] if way.next in self._numbers and way.next is not None else []

    # ------------------------------------------------------------------------

    def _state(self, state: State) -> None:
        ways: list[Way] = []
        dead: list[Dead] = []
        self.of[state.no], self.dead[state.no] = ways, dead
        in_start = state.no == self._start
        unnamed: list[Candidate] = []
        named: dict[str, list[Candidate]] = {}
        for one in self.candidates(state):
            if in_start and one.event.next == BACK:
                dead.append(Dead(one.event, None, one.place, "back"))
            elif one.event.name is None:
                if one.event.next is not None:
                    unnamed.append(one)
            else:
                named.setdefault(one.event.name, []).append(one)
        opposite = self._search.moment.opposite
        before: list[Node] = []
        if unnamed:
            self._group(state, unnamed, [], (), ways, dead)
            if state.flow is None:
                before = [opposite(one.guard) for one in unnamed]
        by = tuple(one.place for one in unnamed)
        by = next(((one.place,) for one in unnamed if one.guard is ALWAYS), by)
        at_once = bool(before) and self._is_left_at_once(before)
        if at_once:
            self.left_at_once.add(state.no)
        for name, several in named.items():
            if name == RESUMED:
                self._group(state, several, [], (), ways, dead)
            elif at_once:
                dead += [Dead(one.event, None, one.place, "left", by) for one in several]
            else:
                self._group(state, several, before, by, ways, dead)
        serves = self.timeout(state)
        if serves is not None:
            timeout, place = serves
            if in_start and timeout.next == BACK:
                dead.append(Dead(None, timeout, place, "back"))
            elif at_once:
                dead.append(Dead(None, timeout, place, "left", by))
            else:
                ways.append(Way(state.no, timeout.next, None, place, tuple(before)))

    def _is_left_at_once(self, before: list[Node]) -> bool:
        if any(node is NEVER for node in before):
            return True
        return self._search.possible(*before) is False

    def _group(
        self,
        state: State,
        several: list[Candidate],
        before: list[Node],
        unnamed: tuple[Place, ...],
        ways: list[Way],
        dead: list[Dead],
    ) -> None:
        """Parts candidates of one name, of which the first that holds is taken."""
        opposite = self._search.moment.opposite
        earlier: list[Node] = []
        closed: Place | None = None
        for at, one in enumerate(several):
            if closed is not None:
                dead.append(Dead(one.event, None, one.place, "earlier", (closed,)))
                continue
            when = (one.guard, *earlier, *before)
            if one.guard is ALWAYS:
                closed = one.place
            if one.guard is ALWAYS and not earlier and not before:
                possible: bool | None = True
            else:
                possible = self._search.possible(*when)
            if possible is None:
                self._search.undecided(
                    self.file, "whether this event is ever taken", one.event.aside, one.place
                )
            if possible is not False:
                ways.append(Way(state.no, one.event.next, one.event, one.place, when))
            elif self._search.possible(one.guard) is False:
                dead.append(Dead(one.event, None, one.place, "guard"))
            elif earlier and self._search.possible(one.guard, *earlier) is False:
                by = tuple(other.place for other in several[:at])
                dead.append(Dead(one.event, None, one.place, "earlier", by))
            elif before and self._search.possible(one.guard, *before) is False:
                dead.append(Dead(one.event, None, one.place, "left", unnamed))
            else:
                by = (*unnamed, *(other.place for other in several[:at]))
                dead.append(Dead(one.event, None, one.place, "earlier", by))
            if one.guard is not ALWAYS:
                earlier.append(opposite(one.guard))
