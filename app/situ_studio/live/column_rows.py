"""What the column beside the drawing says of a moment: its rows in words. No widgets."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from situ.document import words
from situ.document.condition import Group, Test
from situ.document.spds import Situation, Spds
from situ.document.values import reach
from situ.rehearse.telling import kept_by_runtime
from situ_studio.edits import words as studio_words
from situ_studio.live.column_judging import Judging
from situ_studio.live.lanes import Lanes
from situ_studio.live.moment import BREAKPOINTS, PAUSED, Entry, Moment
from situ_studio.live.timeline.rows import RowKind
from situ_studio.live.why_places import tags_in
from situ_studio.panels.blackboard import FRESH, ago
from situ_studio.wording.language import say, tr
from situ_studio.wording.value_words import value_lines, with_unit

TESTS = 4
"""Parts of a condition that are told one by one."""


class ColumnRow(Struct, frozen=True):
    """One line: a name, what it is, and since when.

    name: of the application, resource or tag. pill: the kind in whose colours ``value`` stands.
    after: a small text behind it. lit: the situation rests on it. fresh: it became so just now.
    faint: ``value`` says that there is none. stands: why an application does not go on.
    whole: a value with parts, which the tip tells one by one. spoken: the whole, for who does not
    see it.
    """

    kind: RowKind
    name: str
    title: str
    value: str
    since: str = ""
    pill: str = ""
    after: str = ""
    lit: bool = False
    fresh: bool = False
    faint: bool = False
    stands: str = ""
    tip: str = ""
    whole: dict[str, Any] | list[Any] | None = None

    @property
    def whole_tip(self) -> str:
        """The tip, with what nobody needs before it is asked for."""
        return self.tip if self.whole is None else f"{self.name}\n{value_lines(self.whole)}"

    @property
    def spoken(self) -> str:
        since = tr("since {0}").format(self.since) if self.since else ""
        rests = tr("the situation rests on it") if self.lit else ""
        what = f"{self.title}: {self.value} {self.after}".rstrip()
        told = (what, self.stands, since, rests)
        return ", ".join(filter(None, told))


class PartTold(Struct, frozen=True):
    """A part of the situation's condition. holds None: nobody can say."""

    words: str
    holds: bool | None


class SituationTold(Struct, frozen=True):
    """place: such as ``1st of 5``. kept: why it goes on though its condition does not hold."""

    name: str
    place: str
    parts: tuple[PartTold, ...]
    kept: str
    tip: str


def ordinal(place: int, of: int) -> str:
    """``1st of 5``."""
    teen = place % 100 in (11, 12, 13)
    ending = 0 if teen else place % 10
    text = {
        1: tr("{0}st of {1}"),
        2: tr("{0}nd of {1}"),
        3: tr("{0}rd of {1}"),
    }.get(ending, tr("{0}th of {1}"))
    return text.format(place, of)


class Telling:
    """Tells of one script; where there is none, of applications and data alone."""

    def __init__(self, script: Spds | None) -> None:
        self.script = script
        self._units = {one.tag: one.unit or "" for one in script.observe} if script else {}
        declared = script.modules if script is not None else ()
        self._resources = list(dict.fromkeys(r for one in declared for r in one.resources))
        self._known: dict[str, _Known] = {}
        self._values: dict[str, tuple[Entry, str]] = {}
        self._named: object = None
        self._tags: list[str] = []

    def _current(self, moment: Moment) -> _Known | None:
        """The current situation, as far as the script has it."""
        name = moment.situation
        if name is None or self.script is None:
            return None
        known = self._known.get(name)
        found = self.script.situation(name) if known is None else None
        if found is not None:
            known = self._known[name] = _Known(self.script, found)
        return known

    # -- the situation -----------------------------------------------------------------

    def situation(self, moment: Moment, t: float) -> SituationTold | None:
        """The current one; None where there is none."""
        if moment.situation is None:
            return None
        known = self._current(moment)
        return known.told(moment, t) if known else SituationTold(moment.situation, "", (), "", "")

    # -- applications and resources ----------------------------------------------------

    @staticmethod
    def state(name: str, moment: Moment, t: float, called: Callable[[str, str], str]) -> ColumnRow:
        """Where an application is. called: what a designer calls a state of it."""
        one = moment.applications[name]
        state = called(name, one.state) if one.state is not None else tr("not begun")
        stands = ""
        if one.paused:
            stands = tr("paused")
        elif one.suspended:
            stands = tr("suspended")
        tip = tr("{0} is in {1}").format(name, state)
        if stands:
            tip = tr("{0}, {1}").format(tip, stands)
        if one.missing and one.suspended:
            tip = tr("{0}; it waits for {1}").format(tip, ", ".join(one.missing))
        since = ago(t - one.since) if one.state is not None else ""
        pill, faint = ("warning" if stands else "live"), one.state is None
        return ColumnRow(
            "state", name, name, state, since, pill, faint=faint, stands=stands, tip=tip
        )

    def resources(self, moment: Moment) -> list[str]:
        """Those of the script, then any other that somebody holds or wants."""
        wanted = {one for asked in moment.asking.values() for one in asked}
        others = (moment.holders.keys() | wanted).difference(self._resources)
        return [*self._resources, *sorted(others)]

    def resource(self, name: str, moment: Moment, t: float) -> ColumnRow:
        """Who holds a resource, by which priority, and who else waits for it."""
        holder, since = moment.holders.get(name, (None, 0.0))
        waiting = [m for m, asked in moment.asking.items() if name in asked and m != holder]
        tip = tr("Nobody holds {0}.").format(name)
        if holder is not None:
            tip = tr("{0} has held {1} for {2}.").format(holder, name, ago(t - since))
        if waiting:
            tip += " " + tr("Waiting for it: {0}.").format(", ".join(waiting))
        if holder is None:
            nobody = tr("nobody")
            if len(waiting) == 1:
                nobody = tr("{0} waits").format(waiting[0])
            elif waiting:
                nobody = tr("{0} wait").format(len(waiting))
            return ColumnRow("resource", name, name, nobody, faint=True, tip=tip)
        known = self._current(moment)
        priority = known.priorities.get(holder) if known is not None else None
        if priority is not None:
            tip = tr("{0} Priority {1}.").format(tip, priority)
        return ColumnRow(
            "resource",
            name,
            name,
            holder,
            pill="state" if holder in moment.applications else "module",
            after="" if priority is None else f"{priority}",
            tip=tip,
        )

    # -- the blackboard ----------------------------------------------------------------

    def tags(self, moment: Moment, found: str = "") -> list[str]:
        """What the current situation rests on, then what else the script observes, then what else
        the project has set; of what the situation does not rest on, what is not set last. found:
        only those whose names have it.
        """
        board = list(moment.board)
        observed = [one.tag for one in self.script.observe] if self.script is not None else []
        # What nobody has set says little, unless the situation rests on it. A field may come and go
        # with what stands at its tag.
        unset = [tag for tag in observed if entry_of(moment, tag) is None]
        if (board, moment.situation, unset) != self._named:
            self._named = (board, moment.situation, unset)
            known = self._current(moment)
            others = sorted({*board} - {BREAKPOINTS, PAUSED})
            others = [tag for tag in others if not kept_by_runtime(tag)]
            rests = known.rests if known is not None else ()
            there = [tag for tag in observed if tag not in unset]
            self._tags = list(dict.fromkeys((*rests, *there, *others, *unset)))
        if not found:
            return self._tags
        return [tag for tag in self._tags if found.casefold() in tag.casefold()]

    def tag(self, tag: str, moment: Moment, t: float, lanes: Lanes) -> ColumnRow:
        """A value, and how long ago it was set. lanes: of the whole run."""
        known = self._current(moment)
        lit = known is not None and tag in known.rests
        entry = entry_of(moment, tag)
        if entry is None:
            return ColumnRow("data", tag, tag, tr("not set"), lit=lit, faint=True)
        told = self._values.get(tag)
        if told is None or told[0] is not entry:
            told = self._values[tag] = (entry, self._value(tag, entry.value))
        tip = f"{tag} = {told[1]}"
        whole = entry.value if isinstance(entry.value, dict | list) else None
        since = ago(max(t - entry.t, 0.0))
        fresh = _changed(tag, entry, t, lanes)
        return ColumnRow(
            "data", tag, tag, told[1], since, lit=lit, fresh=fresh, tip=tip, whole=whole
        )

    def _value(self, tag: str, value: Any) -> str:
        if isinstance(value, str):
            return words.quoted(value)
        return with_unit(value, self._units.get(tag, ""))


class _Known:
    """A situation of a script, and what is the same of it at every moment."""

    def __init__(self, script: Spds, situation: Situation) -> None:
        every = script.situations
        self._situation = situation
        self._place = ordinal(every.index(situation) + 1, len(every))
        self._tip = studio_words.situation_words(script, situation)
        self.priorities = script.priorities(situation)
        self.rests = tags_in(situation.condition)
        condition = situation.condition
        self._children = condition.children if condition is not None else ()
        self._words = [words.child(_timeless(child), say) for child in self._children]
        self._judging = Judging(condition) if condition is not None else None

    def told(self, moment: Moment, t: float) -> SituationTold:
        name, judged = self._situation.name, [True] * len(self._children)
        if name in moment.holding or self._judging is None:
            return SituationTold(name, self._place, _parts(self._words, judged), "", self._tip)
        parts = _parts(self._words, self._judging.holds(moment, t))
        return SituationTold(name, self._place, parts, _kept(self._situation), self._tip)


def _timeless(child: Test | Group) -> Test | Group:
    """A test without its times, for there is little room: the card's tip has them."""
    return replace(child, within=None, hold=None) if isinstance(child, Test) else child


def _parts(every: Sequence[str], judged: Sequence[bool | None]) -> tuple[PartTold, ...]:
    told = [PartTold(said, holds) for said, holds in zip(every, judged, strict=True)]
    if len(told) > TESTS:
        told[TESTS - 1 :] = [_rest([one.holds for one in told[TESTS - 1 :]])]
    return tuple(told)


def _rest(judged: Sequence[bool | None]) -> PartTold:
    """Those that have no line of their own; where one is known not to hold, no other one counts."""
    if False not in judged:
        return PartTold(tr("and {0} more").format(len(judged)), None if None in judged else True)
    failing = judged.count(False)
    text = tr("and {0} more, {1} does not hold")
    if failing > 1:
        text = tr("and {0} more, {1} do not hold")
    return PartTold(text.format(len(judged), failing), False)


def _changed(tag: str, entry: Entry, t: float, lanes: Lanes) -> bool:
    """Whether it became another value a moment ago: that it was set again is no news."""
    if t - entry.t >= FRESH or entry.t <= 0:
        return False
    series = lanes.data.get(tag)
    if series is None:
        return True
    times, y = series.t, series.y
    at = bisect_right(times, t) - 1
    while at > 0 and times[at] > t - FRESH:
        if y[at] != y[at - 1]:
            return True
        at -= 1
    return at == 0 and times[0] > t - FRESH


def entry_of(moment: Moment, name: str) -> Entry | None:
    """What stands at a name: a tag, or a tag and fields."""
    entry = moment.board.get(name)
    cut = name.rfind(".")
    while entry is None and cut > 0:
        whole = moment.board.get(name[:cut])
        if whole is not None:
            value = reach(whole.value, name[cut + 1 :])
            return None if value is None else Entry(value, whole.writer, whole.t)
        cut = name.rfind(".", 0, cut)
    return entry


def _kept(situation: Situation) -> str:
    """Why a situation goes on that does not hold any more."""
    if situation.until is not None and situation.until.children:
        return tr("until {0}").format(studio_words.condition_words(situation.until))
    if situation.dwell is not None:
        return tr("stays {0} s at least").format(f"{situation.dwell:g}")
    return ""
