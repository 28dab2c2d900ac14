"""States and events of an application: what is never reached, never left, never taken.

What is claimed: a state is *reached* where a way of reached states leads to it, from the
start state on, each of which can be taken (``situ.document.analysis_ways``). It is a *dead
end* where none leads out of it and nobody said ``final``; from it there is *no way back* where
neither the start state nor an end that is meant can be reached any more. Parts of other
applications may end anywhere: there an end raises ``done``.

Where a ``next`` names no state nothing is said about reaching: it may have meant any.
"""

from __future__ import annotations

from collections.abc import Iterable

from situ.document import words
from situ.document.analysis_data import events, holders
from situ.document.analysis_loops import search_loops
from situ.document.analysis_search import Search
from situ.document.analysis_ways import Dead, Way, Ways
from situ.document.care_every import home
from situ.document.condition import Condition, Group, Test
from situ.document.finding import Place
from situ.document.mend import written
from situ.document.problem import Change, Mend
from situ.document.rbd import AGAIN, BACK, Application, Event, State


def search_states(search: Search, file: str, application: Application) -> tuple[Ways, set[str]]:
    """Tells what is never taken, reached or left in an application; gives its ways and the
    states reached.
    """
    ways = Ways(search, file, application)
    _guards(search, file, application)
    _never_taken(search, ways)
    reached = reachable(ways)
    if not _is_whole(application):
        return ways, {state.no for state in application.states}
    into = _into(ways)
    for state in application.states:
        if state.no not in reached:
            _unreachable(search, ways, state, into)
    if file in search.project.applications:
        dead_ends = _dead_ends(search, ways, reached)
        _no_way_back(search, ways, reached, dead_ends, into)
    search_loops(search, ways, reached)
    return ways, reached


def reachable(ways: Ways) -> set[str]:
    """The states to which ways lead from the start state on, itself included."""
    start = ways.application.start_no
    if start is None or start not in ways.of:
        return set()
    reached = {start}
    waiting = [start]
    while waiting:
        for way in ways.of[waiting.pop()]:
            for target in ways.targets(way):
                if target not in reached:
                    reached.add(target)
                    waiting.append(target)
    return reached


# -- guards and events -----------------------------------------------------------


def _guards(search: Search, file: str, application: Application) -> None:
    for event, place in events(application):
        if event.when is not None and event.when.children:
            never_holds(search, file, event.when, (*place, "when"), "so this event is never taken")


def never_holds(
    search: Search, file: str, condition: Condition, place: Place, result: str
) -> bool | None:
    """Tells where a condition can never hold; gives whether it can, None where undecided."""
    node = search.moment.node(condition)
    possible = search.possible(node)
    if possible is None:
        search.undecided(file, "whether this can ever hold", condition.aside, place)
    elif not possible:
        parts = _core(search, condition.children)
        said = words.listed(words.child(part) for part in parts)
        if len(parts) == 1 and isinstance(parts[0], Test):
            said = f"no value can be so: {said}"
        else:
            said = f"these exclude each other: {said}"
        message = f"This can never hold ({said}), {result}: change or take out one of them"
        search.warn(file, "never-holds", message, condition.aside, place)
    return possible


def _core(search: Search, parts: tuple[Test | Group, ...]) -> list[Test | Group]:
    """As few of them as already exclude each other."""
    left = list(parts)
    for part in parts:
        rest = [one for one in left if one is not part]
        if rest and search.possible(*(search.moment.part(one) for one in rest)) is False:
            left = rest
    return left


def _never_taken(search: Search, ways: Ways) -> None:
    """An event of ``always`` is one that no state ever takes; a guard was told already."""
    alive = {way.place for found in ways.of.values() for way in found}
    told: set[Place] = set()
    for state in ways.application.states:
        for dead in ways.dead.get(state.no, ()):
            if dead.place in alive or dead.place in told:
                continue
            told.add(dead.place)
            if dead.why != "guard":
                _tell_never_taken(search, ways, state, dead)


def _tell_never_taken(search: Search, ways: Ways, state: State, dead: Dead) -> None:
    mend: Mend | None = None
    if dead.event is not None:
        what, aside = f"This {words.event(dead.event)} is never taken", dead.event.aside
    else:
        assert dead.timeout is not None
        what, aside = "This timeout never runs out", dead.timeout.aside
    others = words.listed(_position(place, dead.place) for place in dead.by)
    holds = "always holds" if len(dead.by) == 1 else "always hold together"
    if dead.why == "back":
        told = f"{what}: in the start state there is nowhere to go back to: name a state"
    elif dead.why == "left":
        told = (
            f"{what}: the state is left first, as {others} without a name {holds} then: give it a "
            "condition"
        )
    elif len(dead.by) == 1 and _event(ways, dead.by[0]).when is None:
        told = (
            f"{what}: {others} comes first, on no condition: put this one before it, or give it one"
        )
        mend = _move_up(search, ways, dead)
    else:
        told = (
            f"{what}: whenever it could be, {others} comes first: change a condition, or their "
            "order"
        )
    search.warn(ways.file, "event-never-taken", told, aside, dead.place, mend)


def _position(place: Place, beside: Place) -> str:
    where = "" if place[:-1] == beside[:-1] or beside[-1] == "timeout" else " of every state"
    where = where if place[0] == "always" else ""
    return f"event {int(place[-1]) + 1}{where}"


def _event(ways: Ways, place: Place) -> Event:
    holder = ways.application.always if place[0] == "always" else ways.application.state(place[1])
    assert holder is not None
    return holder.events[int(place[-1])]


def _move_up(search: Search, ways: Ways, dead: Dead) -> Mend | None:
    """To put an event before the one that hides it, where that helps: it has a guard."""
    (other,) = dead.by
    if dead.event is None or dead.event.when is None or other[:-1] != dead.place[:-1]:
        return None
    path = search.path(ways.file, dead.place)
    change = Change(path, "move", other[-1], written(dead.event))
    return search.mend(ways.file, f"Put it before event {int(other[-1]) + 1}", change)


# -- states ----------------------------------------------------------------------


def _is_whole(application: Application) -> bool:
    """Whether every ``next`` names a state, and each state has a number of its own."""
    numbers = {state.no for state in application.states}
    if application.start_no not in numbers or len(numbers) != len(application.states):
        return False
    nexts = [event.next for event, _ in events(application)]
    nexts += [one.timeout.next for one, _ in holders(application) if one.timeout is not None]
    return all(n is None or n in (AGAIN, BACK) or n in numbers for n in nexts)


def _into(ways: Ways) -> dict[str, list[str]]:
    """By state, the states from which ways lead to it, each as often as it does."""
    into: dict[str, list[str]] = {}
    for way in _all(ways):
        for target in ways.targets(way):
            into.setdefault(target, []).append(way.source)
    return into


def _unreachable(search: Search, ways: Ways, state: State, into: dict[str, list[str]]) -> None:
    others = set(into.get(state.no, ())) - {state.no}
    if others:
        several = words.listed(sorted(others)[:4])
        why = f"only states that cannot be reached themselves lead to it ({several})"
    else:
        why = "no event or timeout that can be taken leads to it"
    message = f"The state {words.state(state)} cannot be reached: {why}; connect it, or take it out"
    search.warn(ways.file, "unreachable-state", message, state.aside, ("state", state.no))


def _all(ways: Ways) -> Iterable[Way]:
    return (way for found in ways.of.values() for way in found)


def _leads_out(ways: Ways, no: str) -> bool:
    for way in ways.of[no]:
        if way.next == BACK:
            return True
        if any(target != no for target in ways.targets(way)):
            return True
    return False


def _dead_ends(search: Search, ways: Ways, reached: set[str]) -> set[str]:
    found: set[str] = set()
    for state in ways.application.states:
        if state.no not in reached or _leads_out(ways, state.no):
            continue
        found.add(state.no)
        if state.final or state.flow is not None:
            continue
        place: Place = ("state", state.no)
        message = (
            f"Nothing leads out of the state {words.state(state)}: add an event or a timeout "
            "that leads on, or say that it may end here, if that is meant"
        )
        change = search.put(ways.file, place, "final", True)
        mend = search.mend(ways.file, "Say that it is meant to be the end", change)
        search.warn(ways.file, "dead-end", message, state.aside, place, mend)
    return found


def _no_way_back(
    search: Search,
    ways: Ways,
    reached: set[str],
    dead_ends: set[str],
    into: dict[str, list[str]],
) -> None:
    """From where neither the start nor an end can be reached; a dead end is told by itself."""
    start = ways.application.start_no
    good = {start, *dead_ends} if start is not None else set(dead_ends)
    good |= {state.no for state in ways.application.states if state.final or state.flow is not None}
    # What can go back leads to wherever it was entered from.
    back: dict[str, list[str]] = {}
    for no in {way.source for way in _all(ways) if way.next == BACK}:
        for source in set(into.get(no, ())):
            back.setdefault(source, []).append(no)
    waiting = list(good)
    while waiting:
        no = waiting.pop()
        for source in (*into.get(no, ()), *back.get(no, ())):
            if source not in good:
                good.add(source)
                waiting.append(source)
    lost = [s for s in ways.application.states if s.no in reached and s.no not in good]
    if lost:
        several = words.listed(words.state(state) for state in lost[:4])
        more = f" and {len(lost) - 4} more" if len(lost) > 4 else ""
        message = (
            f"There is no way back to the start from {several}{more}: add an event or a timeout "
            "that leads there, or a Home button to every state"
        )
        place = ("state", lost[0].no)
        mend = home(search, ways.file, ways.application, lost)
        search.warn(ways.file, "no-way-back", message, lost[0].aside, place, mend)
