"""What a project's runs have shown: states, transitions, situations, conditions both ways.

Folded from recordings, so live runs count as well as scenarios. A transition is a way
out of one state: (from, exit, to); those of ``always`` are one each, whatever state they
left. A condition is a whole ``when``, ``condition`` or ``until``; a guard is judged when
its event comes or, unnamed, at the end of every step in its state, and where one that
stands after it is taken at once.
"""

from __future__ import annotations

from typing import Any

import msgspec
from msgspec import Struct

from situ.document import words
from situ.document.condition import Condition
from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK
from situ.rehearse.past import Past
from situ.rehearse.recording import Fields, Recording
from situ.rehearse.ways import Place, Way, name_of_state, states, ways


class Seen(Struct, kw_only=True):
    """One thing to be covered. place: in ``file``, as problems and changes name it."""

    file: str
    place: Place
    label: str
    application: str | None = None
    times: int = 0

    @property
    def covered(self) -> bool:
        return self.times > 0


class SeenTransition(Seen, kw_only=True, rename={"source": "from"}):
    """exit: ``clickYes``, ``at once`` or ``timeout``; to: a number, ``#again``, ``#back``."""

    source: str
    exit: str
    to: str


class SeenCondition(Seen, kw_only=True, rename={"held": "true", "failed": "false"}):
    """held, failed: how often it was judged true, false; covered where both."""

    held: int = 0
    failed: int = 0

    @property
    def covered(self) -> bool:
        return self.held > 0 and self.failed > 0

    def judged(self, holds: bool) -> None:
        self.times += 1
        if holds:
            self.held += 1
        else:
            self.failed += 1


Key = tuple[str, str, str, Place]
"""Application, what stands before the numbers of its run of a part, file, place."""


class Coverage:
    """What of a project has been covered so far."""

    def __init__(self, project: Project) -> None:
        self._project = project
        self.states: dict[tuple[str, str], Seen] = {}
        self.transitions: dict[Key, SeenTransition] = {}
        self.situations: dict[str, Seen] = {}
        self.conditions: dict[tuple[str, Place], SeenCondition] = {}
        for application in project.applications.values():
            for frame in states(project, application.name):
                self._state(application.name, frame.no, frame.file, frame.state.no)
        self._script()

    def _state(self, application: str, no: str, file: str, inner: str) -> None:
        label = f"{application}, {self._named(application, no)}"
        self.states[application, no] = Seen(
            file=file, place=("state", inner), label=label, application=application
        )
        for way in ways(self._project, application, no):
            if way.event is not None and way.event.when is not None:
                where = f"{way.file} {' '.join(way.place)}"
                self._condition(way.file, (*way.place, "when"), where, way.event.when)
            if way.to is not None:
                key = (application, way.before, way.file, way.place)
                source = way.source
                if source != "always":
                    source = self._named(application, source)
                to = self._named(application, way.to)
                label = f"{application}, {source} – {way.exit} → {to}"
                self.transitions.setdefault(
                    key,
                    SeenTransition(
                        file=way.file, place=way.place, label=label, application=application,
                        source=way.source, exit=way.exit, to=way.to,
                    ),
                )  # fmt: skip

    def _named(self, application: str, no: str) -> str:
        return {AGAIN: "anew", BACK: "back"}.get(no) or name_of_state(
            self._project, application, no
        )

    def _script(self) -> None:
        script, file = self._project.spds, self._project.spds_file
        if script is None or file is None:
            return
        for situation in script.situations:
            place = ("situation", situation.name)
            self.situations[situation.name] = Seen(file=file, place=place, label=situation.name)
            for field in ("condition", "until"):
                found = getattr(situation, field)
                if found is not None:
                    where = f"{field} of situation {situation.name}"
                    self._condition(file, (*place, field), where, found)

    def _condition(self, file: str, place: Place, where: str, found: Condition) -> None:
        label = f"{where}: {words.condition(found)}"
        self.conditions.setdefault(
            (file, place), SeenCondition(file=file, place=place, label=label)
        )

    # -- runs ----------------------------------------------------------------

    def add(self, recording: Recording) -> None:
        """Counts what a run has shown."""
        past = Past(self._project, recording.whole)
        for number, step in enumerate(recording.steps):
            before = past.situation
            for hidden in step.before:
                past.keep(hidden)
            for event in step.events:
                self._look(past, event)
                past.take(event)
            for hidden in step.after:
                past.keep(hidden)
            past.settle()
            if number == 0:
                self._start(past)
            self._end_of_step(past, before)

    def _look(self, past: Past, event: Fields) -> None:
        """An event, seen just before the past takes it."""
        kind, name = event["kind"], event.get("application", "")
        if kind == "enter":
            self._count(self.states.get((name, event["state"])))
        elif kind == "situation":
            self._count(self.situations.get(event["to"]))
        elif kind == "condition":
            self._judged(self._of_situation(event["situation"], "condition"), event["holds"])
        elif kind == "event":
            past.pass_time(event["t"])
            here = past.applications.get(name)
            if here is not None and here.suspended is None:
                for way, passed in past.tried(name, event["name"]):
                    self._guard(way, passed)
        elif kind == "transition":
            past.pass_time(event["t"])
            taken = past.taken(event)
            if taken is not None:
                self._count(self.transitions.get((name, taken.before, taken.file, taken.place)))
                if taken.exit == "at once":
                    for way, passed in past.tried(name, None):
                        if not passed:
                            self._guard(way, False)
                    self._guard(taken, True)

    def _start(self, past: Past) -> None:
        """A condition that does not hold at the start is traced only when it comes to hold."""
        script = self._project.spds
        for situation in script.situations if script is not None else ():
            if situation.condition is not None and situation.name not in past.holding:
                self._judged(self._of_situation(situation.name, "condition"), False)

    def _end_of_step(self, past: Past, before: Fields | None) -> None:
        for name, here in past.applications.items():
            if here.suspended is not None:
                continue
            for way in past.ways(name):
                if way.event is not None and way.event.name is None:
                    holds = past.holds(way.event.when)
                    if not holds:
                        self._guard(way, False)
        script = self._project.spds
        if script is None:
            return
        now = {e["to"] for e in (before, past.situation) if e is not None}
        for situation in script.situations:
            if situation.until is not None and situation.name in now:
                holds = past.holds(situation.until)
                self._judged(self._of_situation(situation.name, "until"), holds)

    def _of_situation(self, name: str, field: str) -> tuple[str, Place]:
        return (self._project.spds_file or "", ("situation", name, field))

    def _guard(self, way: Way, holds: bool) -> None:
        self._judged((way.file, (*way.place, "when")), holds)

    def _judged(self, key: tuple[str, Place], holds: bool) -> None:
        found = self.conditions.get(key)
        if found is not None:
            found.judged(holds)

    @staticmethod
    def _count(seen: Seen | None) -> None:
        if seen is not None:
            seen.times += 1

    # -- what it says --------------------------------------------------------

    def groups(self) -> dict[str, list[Seen]]:
        """All there is to be covered, by kind, in the order of the documents."""
        return {
            "states": list(self.states.values()),
            "transitions": list(self.transitions.values()),
            "situations": list(self.situations.values()),
            "conditions": list(self.conditions.values()),
        }

    def lines(self) -> list[str]:
        """As text: a line a kind, and below it what is not covered."""
        found = []
        for kind, every in self.groups().items():
            if not every:
                continue
            done = sum(seen.covered for seen in every)
            share = f"{done} of {len(every)} ({done * 100 // len(every)} %)"
            found.append(f"{kind:<12} {share}")
            found += [f"  not {_lack(seen)}" for seen in every if not seen.covered]
        return found

    def document(self) -> dict[str, Any]:
        """As JSON: by kind {covered, all, list: [{file, place, label, …, covered}]}."""
        return {
            kind: {
                "covered": sum(seen.covered for seen in every),
                "all": len(every),
                "list": [{**_fields(seen), "covered": seen.covered} for seen in every],
            }
            for kind, every in self.groups().items()
        }


def _lack(seen: Seen) -> str:
    if isinstance(seen, SeenCondition):
        ways_ = [w for w, times in (("true", seen.held), ("false", seen.failed)) if not times]
        return f"{' nor '.join(ways_)}: {seen.label}"
    return seen.label


def _fields(seen: Seen) -> dict[str, Any]:
    found = msgspec.to_builtins(seen)
    assert isinstance(found, dict)
    return {**{k: v for k, v in found.items() if v is not None}, "place": list(seen.place)}
