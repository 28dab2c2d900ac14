"""Modules: those that can never hold authority, and ties between them.

What is claimed: in a situation that can be current a module can *win* where the others may
ask, or not, in such a way that it is granted something. Modules decide by themselves: each may
ask for any part of what it declared, or for nothing. An application asks for what the state
that it is in uses, and it may be in any state that is reached; one with parts is taken to ask
as it likes. At equal priorities either may come first.

A *tie* is two modules of equal priority in a situation that can be current, which can ask
for the same resource: who comes first then depends on who held or asked first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set

from situ.document.analysis_raising import Raising, given, raised, taken_away
from situ.document.analysis_search import Search
from situ.document.analysis_ways import Ways
from situ.document.analysis_winning import Asker, Asks, Spent, can_win
from situ.document.aside import Aside
from situ.document.check_application import used_resources
from situ.document.datatypes import shown
from situ.document.finding import Place
from situ.document.problem import Mend
from situ.document.rbd import AGAIN, BACK, Robot, Sound, Speech, resource_of
from situ.document.spds import Situation, Spds


def search_modules(
    search: Search,
    file: str,
    script: Spds,
    current: list[Situation],
    ways: dict[str, tuple[Ways, set[str]]],
) -> None:
    """``ways``: by name of the application, its ways and the states that are reached."""
    askers = _askers(search, script, ways)
    _ties(search, file, script, current, askers)
    raising = Raising(script, current, askers)
    for name in askers:
        search.go_on()
        _never_wins(search, file, raising, current, askers, name)


def _askers(
    search: Search, script: Spds, ways: dict[str, tuple[Ways, set[str]]]
) -> dict[str, Asker]:
    project = search.project
    applications = {a.name: a for a in project.applications.values()}
    found: dict[str, Asker] = {}
    for name, resources in project.declared().items():
        application = applications.get(name)
        if application is None:
            found[name] = Asker(frozenset(resources), None)
        else:
            asks = requests(*ways[name])
            if asks is None:
                used = frozenset(used_resources(project, application))
            else:
                used = frozenset(one for needs, takes in asks for one in needs | takes)
            found[name] = Asker(used, asks)
    return found


def requests(ways: Ways, reached: set[str]) -> frozenset[Asks] | None:
    """What an application asks for in the states that are reached; None: it has parts."""
    application = ways.application
    states = [state for state in application.states if state.no in reached]
    if any(state.flow is not None for state in states):
        return None
    shown = _shown(ways, reached)
    found: set[Asks] = set()
    for state in states:
        needs: set[str] = set()
        takes: set[str] = set()
        for action in state.actions:
            resource = resource_of(action)
            if resource is not None:
                optional = isinstance(action, (Speech, Sound, Robot)) and action.optional
                (takes if optional else needs).add(resource)
        always = application.always_in(state)
        above = always.screen if always is not None else None
        if above is not None and not above.is_empty:
            needs.add("screen")
        for is_shown in shown.get(state.no, ()):
            with_screen = needs | {"screen"} if is_shown else needs
            found.add((frozenset(with_screen), frozenset(takes - with_screen)))
    return frozenset(found)


def _shown(ways: Ways, reached: set[str]) -> dict[str, set[bool]]:
    """By state, whether a screen of a state can be shown there, and whether none can be."""
    application = ways.application
    states = {state.no: state for state in application.states}
    start = application.start_no
    found: dict[str, set[bool]] = {no: set() for no in reached}
    into: dict[str, set[str]] = {no: set() for no in reached}
    for no in reached:
        for way in ways.of[no]:
            for target in ways.targets(way) if way.next != AGAIN else ():
                into[target].add(no)

    def after(no: str, before: bool) -> bool:
        screen = states[no].screen
        return before if screen is None else not screen.is_empty

    waiting: list[tuple[str, bool]] = []
    if start in reached and start is not None:
        waiting.append((start, after(start, False)))
    while waiting:
        no, is_shown = waiting.pop()
        if is_shown in found[no]:
            continue
        found[no].add(is_shown)
        for way in ways.of[no]:
            targets = into[no] if way.next == BACK else ways.targets(way)
            waiting += [(target, after(target, is_shown)) for target in targets]
    return found


# -- winning ---------------------------------------------------------------------


def _never_wins(
    search: Search,
    file: str,
    raising: Raising,
    current: list[Situation],
    askers: dict[str, Asker],
    name: str,
) -> None:
    script, asker = raising.script, askers[name]
    entries = [
        (situation, at)
        for situation in script.situations
        for at, entry in enumerate(situation.entries)
        if entry.module == name and entry.priority is not None
    ]
    is_application = any(a.name == name for a in search.project.applications.values())
    if not entries:
        if not is_application and asker.resources:
            where, place = _declaration(script, name)
            message = (
                f'The module "{name}" can never hold authority: no situation gives it a '
                "priority; give it one in a situation"
            )
            mend = given(search, file, raising, name)
            search.warn(file, "never-wins", message, where, place, mend)
        return
    first, at = entries[0]
    place = ("situation", first.name, "entry", str(at))
    aside = first.entries[at].aside
    if not asker.resources:
        if is_application:
            # It needs a priority all the same, and as it asks for nothing, nothing suspends it.
            return
        message = (
            f'The module "{name}" has no resources, so its priority has no effect: take it out'
        )
        mend = taken_away(search, file, script, name)
        search.warn(file, "never-wins", message, aside, place, mend)
        return
    try:
        wins = any(can_win(script.priorities(situation), askers, name) for situation in current)
    except Spent:
        search.undecided(file, f'whether "{name}" ever holds authority', aside, place)
        return
    if not wins:
        where_given = [s for s in current if name in script.priorities(s)]
        why = "others with a higher priority always hold what it could ask for"
        if not where_given:
            why = "the situations that give it a priority are never current"
        message = (
            f'The module "{name}" can never hold authority: {why}; raise its priority, or give '
            "it a situation of its own"
        )
        mend = raised(search, file, raising, name)
        search.warn(file, "never-wins", message, aside, place, mend)


def _declaration(script: Spds, name: str) -> tuple[Aside, Place]:
    for declared in script.modules:
        if declared.name == name:
            return declared.aside, ("module", name)
    return script.aside, ()


# -- ties ------------------------------------------------------------------------


def _ties(
    search: Search,
    file: str,
    script: Spds,
    current: list[Situation],
    askers: dict[str, Asker],
) -> None:
    resources = {name: asker.resources for name, asker in askers.items()}
    every = list(zip(script.situations, script.every_priorities(), strict=True))
    known = {one.name: set(tied(priorities, resources)) for one, priorities in every}
    names = {situation.name for situation in current}
    told = {id(situation) for situation in current}
    for situation, priorities in every:
        if id(situation) not in told:
            continue
        found = set(tied(priorities, resources))
        # Where the situation that it extends is told of already, once is enough.
        if situation.extends in names and situation.extends is not None:
            found = found - known.get(situation.extends, set())
        for one, other in sorted(found):
            shared = sorted(askers[one].resources & askers[other].resources)
            priority = priorities[one]
            aside, place = _entry(situation, one, other)
            message = (
                f'"{one}" and "{other}" both have the priority {priority} in "{situation.name}" '
                f"and can ask for {', '.join(shared)}: who asked first would win; give one of "
                "them another priority"
            )
            # Of two of one name the place means the first.
            is_meant = len(place) == 4 and script.situation(situation.name) is situation
            mend = _apart(search, file, situation, priorities, place) if is_meant else None
            search.warn(file, "tie", message, aside, place, mend)


def _apart(
    search: Search, file: str, situation: Situation, priorities: Mapping[str, int], place: Place
) -> Mend | None:
    """To give the entry that ties the next priority, or the one below, that nobody else has."""
    entry = situation.entries[int(place[3])]
    taken = set(priorities.values())
    free = [
        entry.priority + by
        for by in (1, -1)
        if entry.priority is not None and entry.priority + by not in taken
    ]
    if not free:
        return None
    said = f"Give {shown(entry.module)} the priority {free[0]} in {shown(situation.name)}"
    return search.mend(file, said, search.put(file, place, "priority", free[0]))


def tied(
    priorities: Mapping[str, int], resources: Mapping[str, Set[str]]
) -> Iterator[tuple[str, str]]:
    """Pairs of modules of equal priority that can ask for the same resource."""
    by_priority: dict[int, list[str]] = {}
    for module, priority in priorities.items():
        if module in resources:
            by_priority.setdefault(priority, []).append(module)
    for several in by_priority.values():
        several.sort()
        for at, one in enumerate(several):
            for other in several[at + 1 :]:
                if resources[one] & resources[other]:
                    yield one, other


def _entry(situation: Situation, one: str, other: str) -> tuple[Aside, Place]:
    """The entry of the situation that brings the tie about, the lower one first."""
    place: Place = ("situation", situation.name)
    for at in reversed(range(len(situation.entries))):
        if situation.entries[at].module in (one, other):
            return situation.entries[at].aside, (*place, "entry", str(at))
    return situation.aside, place
