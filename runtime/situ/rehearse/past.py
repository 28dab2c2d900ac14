"""The robot as it was: a recording folded up to one of its events, with its documents.

What is judged here is judged by the robot's own conditions over the blackboard as the
trace tells it, so ``within`` and ``for`` count too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from msgspec import Struct, field

from situ.decide.board import Board, Entry
from situ.decide.clock import CLOCK
from situ.decide.conditions import Compiled, Conditions
from situ.decide.priorities import RUNTIME
from situ.decide.step import SECOND, Step, microseconds
from situ.document import words
from situ.document.condition import Condition, Group, GroupName, Test
from situ.document.names import only_reference
from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK
from situ.rehearse.clock import Hidden
from situ.rehearse.recording import Fields, Recording
from situ.rehearse.telling import kept_by_runtime, moment, value_words
from situ.rehearse.ways import Way, frames, label, ways


class ApplicationPast(Struct):
    """Where an application was. entered, suspended: those events.

    stacks: what ``#back`` goes back to, by what stands before the number of a state: each
    run of a part has its own.
    """

    state: str
    entered: Fields
    stacks: dict[str, list[str]] = field(default_factory=dict)
    suspended: Fields | None = None


class Asking(Struct):
    """A module's request; order: its place in time."""

    resources: tuple[str, ...]
    optional: tuple[str, ...]
    order: int
    event: Fields


class Judged(Struct, frozen=True):
    """A test or a group of a condition as it was. kind, parts: of a group; name, value: of a
    test.
    """

    holds: bool
    text: str
    kind: GroupName | None = None
    name: str | None = None
    value: Any = None
    parts: tuple[Judged, ...] = ()


class Past:
    """The robot after the events taken so far; ``t`` seconds."""

    def __init__(self, project: Project, whole: bool = False) -> None:
        self.project = project
        self.t = 0.0
        self.whole = whole
        self.applications: dict[str, ApplicationPast] = {}
        self.situation: Fields | None = None
        self.holding: dict[str, Fields] = {}
        self.requests: dict[str, Asking] = {}
        self.holders: dict[str, Fields] = {}
        self.robot: dict[str, Fields] = {}
        self.lost: dict[str, Fields] = {}
        self.given_back: dict[tuple[str, str], Fields] = {}
        """(module, resource) to when it gave that back and has not asked for it since."""
        self.given_up: dict[tuple[str, str], tuple[Fields, Fields]] = {}
        """The same where it had asked in vain: that it asked, and that it does no more."""
        self._asked: dict[tuple[str, str], Fields] = {}
        self.board = Board()
        self._clock = Step()
        self._conditions = Conditions(self.board, self._clock)
        self._tests: dict[Test, Compiled] = {}
        self._written: dict[str, Fields] = {}
        self._count = 0
        for condition in _conditions(project):
            self._compile(condition.children)
        self._conditions.start()

    # -- going on ------------------------------------------------------------

    def take(self, event: Fields) -> None:
        """Goes on by one event of the trace."""
        written = next(iter(self._written.values()), None)
        if written is not None and not (
            event["kind"] == "data"
            and event["tag"] not in self._written
            and all(event[key] == written[key] for key in ("t", "cause", "writer"))
        ):
            self.settle()
        self._at(event["t"])
        accept = _ACCEPT.get(event["kind"])
        if accept is not None:
            accept(self, event)

    def keep(self, hidden: Hidden) -> None:
        """Goes on by one write of what the runtime keeps."""
        self.settle()
        self._at(hidden.t)
        if self.board.write(hidden.tag, hidden.value, hidden.writer, self._clock.now, None):
            self.board.tell(hidden.tag, None)

    def until(self, recording: Recording, t: float, before: int | None = None) -> None:
        """Takes all steps of a recording up to and at ``t``, which is then the time. before: only
        those before the step of that event, whose time it is then.
        """
        for step in recording.steps:
            if step.t > t:
                break
            if any(event["seq"] == before for event in step.events):
                t = step.t
                break
            for hidden in step.before:
                self.keep(hidden)
            for event in step.events:
                self.take(event)
            for hidden in step.after:
                self.keep(hidden)
        self.pass_time(t)

    def pass_time(self, t: float) -> None:
        """Nothing more comes before ``t``."""
        self.settle()
        self._at(t)

    def settle(self) -> None:
        """All tags of one write are there: what follows them is told."""
        if self._written:
            written, self._written = self._written, {}
            for tag, event in written.items():
                self.board.tell(tag, event["seq"])

    def _at(self, t: float) -> None:
        self.t = t
        self._clock.begin(microseconds(t))

    # -- judging -------------------------------------------------------------

    def holds(self, condition: Condition | None) -> bool:
        """Whether a condition holds now; none always does."""
        self.settle()
        return condition is None or all(self._holds(child) for child in condition.children)

    def passes(self, way: Way, application: str) -> bool:
        """Whether an expected event would be taken now, were it to come."""
        if way.next == BACK and self.back(application, way) is None:
            return False
        return self.holds(way.event.when if way.event is not None else None)

    def back(self, application: str, way: Way) -> str | None:
        """Where ``#back`` of a way goes now; None where there is nothing to go back to."""
        here = self.applications.get(application)
        stack = here.stacks.get(way.before) if here is not None else None
        return stack[-1] if stack else None

    def tried(self, application: str, name: str | None) -> list[tuple[Way, bool]]:
        """The expected events of a name as they would be tried now, up to the first that is
        taken (True).
        """
        found = []
        for way in self.ways(application):
            if way.event is None or way.event.name != name:
                continue
            passed = self.passes(way, application)
            found.append((way, passed))
            if passed:
                break
        return found

    def judge(self, child: Test | Group) -> Judged:
        """A test or a group with the values that it looks at."""
        self.settle()
        if isinstance(child, Group):
            parts = tuple(self.judge(one) for one in child.children)
            return Judged(self._holds(child), words.child(child), child.kind, parts=parts)
        holds, value = self._holds(child), self.board.look(child.tag)
        return Judged(holds, self._test_words(child, value), None, child.tag, value)

    def holder(self, resource: str) -> str | None:
        """Who holds a resource."""
        event = self.holders.get(resource)
        return None if event is None else event["to"]

    def priority(self, module: str) -> int | None:
        """A module's priority in the current situation; None: it has none."""
        script = self.project.spds
        if script is None:
            alone = any(a.name == module for a in self.project.applications.values())
            return 1 if alone else None
        name = self.situation["to"] if self.situation is not None else None
        current = script.situation(name) if name is not None else None
        return None if current is None else script.priorities(current).get(module)

    def ways(self, application: str) -> list[Way]:
        """The ways out of where an application is now."""
        here = self.applications.get(application)
        return [] if here is None else ways(self.project, application, here.state)

    def _holds(self, child: Test | Group) -> bool:
        if isinstance(child, Test):
            return self._test(child)()
        held = (self._holds(one) for one in child.children)
        if child.kind == "all":
            return all(held)
        return any(held) if child.kind == "any" else not any(held)

    def _test_words(self, test: Test, value: Any) -> str:
        """``human.distance below 1.5: it was 2.3, set at 11 s by scenario``."""
        entry = self.board.last_set(test.tag)
        said = f"{words.child(test)}: it was {value_words(value)}"
        if value is None and (entry is None or _is_lost(test.tag, entry)):
            said = f"{words.child(test)}: it was never set"
            if kept_by_runtime(test.tag) and not self.whole:
                said = f"{words.child(test)}: not told by a trace alone"
        else:
            assert entry is not None
            at = moment(entry.time / SECOND)
            if entry.value is None:
                said = f"{said}, deleted at {at} by {entry.writer}"
            else:
                said = f"{said}, set at {at} by {entry.writer}"
        other = only_reference(test.value)
        if other is not None and test.test != "exists":
            said = f"{said}; {other} was {value_words(self.board.look(other))}"
        return said

    def _test(self, test: Test) -> Compiled:
        return self._tests.get(test) or self._compiled(test)

    def _compile(self, children: tuple[Test | Group, ...]) -> None:
        for child in children:
            if isinstance(child, Group):
                self._compile(child.children)
            elif child not in self._tests:
                self._compiled(child)

    def _compiled(self, test: Test) -> Compiled:
        self._tests[test] = self._conditions.compile(Condition((test,)), None)
        return self._tests[test]

    # -- what events tell ----------------------------------------------------

    def _write(self, tag: str, value: Any, writer: str, event: Fields) -> None:
        if self.board.write(tag, value, writer, self._clock.now, event["seq"]):
            self._written[tag] = event

    def _data(self, event: Fields) -> None:
        self._write(event["tag"], event["value"], event["writer"], event)

    def _kept(self, tag: str, value: Any, event: Fields) -> None:
        self.settle()
        self._write(tag, value, "situ", event)
        self.settle()

    def _situation(self, event: Fields) -> None:
        self.situation = event
        script = self.project.spds
        found = script.situation(event["to"]) if script is not None and event["to"] else None
        priorities = script.priorities(found) if script is not None and found is not None else {}
        self._kept("situation", {"name": event["to"], "priorities": priorities}, event)

    def _condition(self, event: Fields) -> None:
        self.holding[event["situation"]] = event

    def _acquire(self, event: Fields) -> None:
        old = self.requests.get(event["module"])
        self._count += old is None
        order = self._count if old is None else old.order
        self.lost.pop(event["module"], None)
        for resource in (*event["resources"], *event.get("optional", ())):
            self.given_back.pop((event["module"], resource), None)
            self.given_up.pop((event["module"], resource), None)
            self._asked.setdefault((event["module"], resource), event)
        self.requests[event["module"]] = Asking(
            tuple(event["resources"]), tuple(event.get("optional", ())), order, event
        )

    def _abandon(self, event: Fields) -> None:
        for resource in event["resources"]:
            pair = event["module"], resource
            asked = self._asked.pop(pair, None)
            # The trace may begin after the request.
            if asked is None or self.holder(resource) == event["module"]:
                self.given_back[pair] = event
            else:
                self.given_up[pair] = asked, event
        old = self.requests.pop(event["module"], None)
        if old is None:
            return
        gone = set(event["resources"])
        kept = tuple(r for r in old.resources if r not in gone)
        able = tuple(r for r in old.optional if r not in gone)
        if kept or able:
            self.requests[event["module"]] = Asking(kept, able, old.order, event)

    def _lost(self, event: Fields) -> None:
        self.requests.pop(event["module"], None)
        self._asked = {
            pair: asked for pair, asked in self._asked.items() if pair[0] != event["module"]
        }
        self.lost[event["module"]] = event

    def _authority(self, event: Fields) -> None:
        self.holders[event["resource"]] = event

    def _mapping(self, event: Fields) -> None:
        self.robot[event["resource"]] = event
        self._kept(f"robot/{event['resource']}", event["value"], event)

    def _enter(self, event: Fields) -> None:
        name = event["application"]
        old = self.applications.get(name)
        here = ApplicationPast(event["state"], event)
        if old is not None:
            here.stacks, here.suspended = old.stacks, old.suspended
        for frame in frames(self.project, name, here.state)[-1:]:
            if frame.state.no == frame.application.start_no:
                here.stacks.pop(frame.before, None)
        self.applications[name] = here
        self._publish(name, event)

    def _transition(self, event: Fields) -> None:
        self.settle()
        here = self.applications.get(event["application"])
        if here is None:
            return
        way = self.taken(event)
        if way is None or way.next == AGAIN:
            return
        if way.next == BACK:
            here.stacks.get(way.before, [])[-1:] = []
            return
        for frame in frames(self.project, event["application"], event["from"]):
            if frame.before == way.before:
                here.stacks.setdefault(way.before, []).append(frame.no)

    def taken(self, transition: Fields) -> Way | None:
        """The way that a transition took, judged as the past is now: just before it."""
        name = transition["application"]
        if transition.get("timeout"):
            return next((w for w in self.ways(name) if w.timeout is not None), None)
        tried = self.tried(name, transition["event"])
        return tried[-1][0] if tried and tried[-1][1] else None

    def _suspend(self, event: Fields) -> None:
        here = self.applications.get(event["application"])
        if here is not None:
            here.suspended = event
            self._publish(event["application"], event)

    def _resume(self, event: Fields) -> None:
        here = self.applications.get(event["application"])
        if here is not None:
            here.suspended = None
            self._publish(event["application"], event)

    def _publish(self, name: str, event: Fields) -> None:
        here = self.applications[name]
        value = {
            "state": here.state,
            "name": label(self.project, name, here.state),
            "suspended": here.suspended is not None,
        }
        entry = self.board.get(f"application/{name}")
        if entry is None or entry.value != value:
            self._kept(f"application/{name}", value, event)


def _is_lost(tag: str, entry: Entry) -> bool:
    """Whether the clock is not known from then on: the runtime never deletes it."""
    return entry.value is None and entry.writer == RUNTIME and tag.startswith(CLOCK)


def _conditions(project: Project) -> Iterator[Condition]:
    """Every condition of a project: those with ``for`` are followed from the start."""
    for application in (*project.applications.values(), *project.parts.values()):
        for holder in (application.always, *application.states):
            for event in holder.events if holder is not None else ():
                if event.when is not None:
                    yield event.when
    for situation in project.spds.situations if project.spds is not None else ():
        for condition in (situation.condition, situation.until):
            if condition is not None:
                yield condition


_ACCEPT: dict[str, Callable[[Past, Fields], None]] = {
    "data": Past._data,
    "situation": Past._situation,
    "condition": Past._condition,
    "acquire": Past._acquire,
    "abandon": Past._abandon,
    "lost": Past._lost,
    "authority": Past._authority,
    "mapping": Past._mapping,
    "enter": Past._enter,
    "transition": Past._transition,
    "suspend": Past._suspend,
    "resume": Past._resume,
}
