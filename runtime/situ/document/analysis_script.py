"""Situations: those that can never be current, and those that never end.

What is claimed: a situation is *shadowed* where there is no moment at which it could begin
and none of those above it must hold, whatever the values then are. One above must hold
while its condition does; but one with ``until`` or ``limit`` that has ended does not, until
its condition was false once, so it leaves room where it can be current itself, and end. Each
is taken for itself: whether several can have ended at the same time is not asked. Moments are
judged one by one: what a ``dwell`` above may cover for a while is not counted.
"""

from __future__ import annotations

from situ.document import words
from situ.document.analysis_cover import Cover
from situ.document.analysis_search import Search
from situ.document.analysis_states import never_holds
from situ.document.datatypes import shown
from situ.document.finding import Place
from situ.document.mend import written
from situ.document.problem import Change, Mend
from situ.document.satisfy import NEVER, Node, every
from situ.document.spds import Situation, Spds


def search_situations(search: Search, file: str, script: Spds) -> list[Situation]:
    """Tells which situations can never be current; gives those that can."""
    cover = Cover(search)
    opposite = search.moment.opposite
    above: list[tuple[Situation, Node]] = []
    current: list[Situation] = []
    for situation in script.situations:
        search.go_on()
        begins = _begins(search, file, situation)
        found = begins is not None and cover.possible(begins)
        if begins is not None and found is False:
            _shadowed(search, file, situation, begins, cover, above)
        elif found is None:
            what = "whether this situation is ever current"
            search.undecided(file, what, situation.aside, ("situation", situation.name))
        if found is not False:
            current.append(situation)
        if begins is not None and not (found is not False and _can_end(search, situation)):
            cover.add(opposite(begins))
            above.append((situation, opposite(begins)))
    return current


def _begins(search: Search, file: str, situation: Situation) -> Node | None:
    """The moments at which a situation could begin if it stood first; None, and told: never."""
    place = ("situation", situation.name)
    moment = search.moment
    can = True
    if situation.condition is not None and situation.condition.children:
        result = "so this situation is never current"
        can = (
            never_holds(search, file, situation.condition, (*place, "condition"), result)
            is not False
        )
    until = moment.node(situation.until) if situation.until is not None else NEVER
    if situation.until is not None and situation.until.children:
        result = "so this situation never ends by it"
        if never_holds(search, file, situation.until, (*place, "until"), result) is False:
            until = NEVER
    if not can:
        return None
    begins = every((moment.node(situation.condition), moment.opposite(until)))
    if until is not NEVER and search.possible(begins) is False:
        message = (
            "This situation never begins: whenever its condition holds, so does its until; "
            "change one of them"
        )
        search.warn(file, "never-holds", message, situation.aside, place)
        return None
    return begins


def _can_end(search: Search, situation: Situation) -> bool:
    """Whether a situation can end while its condition still holds."""
    if situation.limit is not None:
        return True
    if situation.until is None:
        return False
    moment = search.moment
    nodes = (moment.node(situation.condition), moment.node(situation.until))
    return search.possible(*nodes) is not False


def _shadowed(
    search: Search,
    file: str,
    situation: Situation,
    begins: Node,
    cover: Cover,
    above: list[tuple[Situation, Node]],
) -> None:
    by = cover.core(begins, among=[node for _, node in above])
    named = [f'"{above[at][0].name}"' for at in by]
    if len(named) > 5:
        named = [*named[:4], f"{len(named) - 4} more"]
    joint = "holds too" if len(by) == 1 else "always holds too"
    who = words.listed(named) if len(by) == 1 else f"one of {words.listed(named)}"
    message = (
        f"This situation is never current: whenever it could begin, {who} above it {joint}; "
        "move it up, or change a condition"
    )
    place: Place = ("situation", situation.name)
    mend = _put_above(search, file, situation, begins, above[by[0]]) if len(by) == 1 else None
    search.warn(file, "shadowed-situation", message, situation.aside, place, mend)


def _put_above(
    search: Search, file: str, situation: Situation, begins: Node, upper: tuple[Situation, Node]
) -> Mend | None:
    """To put it before the only one that shadows it, where that would still be current then."""
    opposite = search.moment.opposite
    if search.possible(opposite(upper[1]), opposite(begins)) is not True:
        return None
    path, to = (search.path(file, ("situation", one.name)) for one in (situation, upper[0]))
    change = Change(path, "move", str(to[-1]), written(situation))
    return search.mend(file, f"Put it before {shown(upper[0].name)}", change)
