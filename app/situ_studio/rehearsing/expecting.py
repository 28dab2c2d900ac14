"""What a scenario made of a rehearsal can expect: the events that a designer would tell of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Any

from msgspec import Struct

from situ.decide import inputs
from situ.decide.step import SECOND, microseconds
from situ.document.project import Project
from situ.rehearse import scenario
from situ.rehearse.expect import Expect
from situ.rehearse.scenario import End
from situ_studio.edits.words import running_state
from situ_studio.live.moment import TraceFields
from situ_studio.rehearsing.course import Course
from situ_studio.wording.language import tr

_FIELDS = {
    "enter": ("application", "state"),
    "situation": ("to",),
    "authority": ("resource", "to"),
    "action": ("application", "action", "name", "text"),
}
"""By kind, what is expected of an event: what does not depend on how it came there."""
_USUAL = ("enter", "situation")
"""Kinds that are chosen at first."""
_TOLD = ("speech", "robot", "service", "launch", "message", "sound")
"""Actions that are worth an expectation: those that somebody hears of."""


class Chance(Struct, frozen=True):
    """One event that may be expected. at: µs. usual: it is, unless somebody says otherwise."""

    at: int
    fields: dict[str, Any]
    usual: bool

    def words(self, project: Project) -> str:
        """As a designer tells it, of that project."""
        fields = self.fields
        match fields["kind"]:
            case "enter":
                state = running_state(project, fields["application"], fields["state"])
                what = tr("{0} is in {1}").format(fields["application"], state)
            case "situation":
                what = tr("the situation is {0}").format(fields["to"] or tr("none"))
            case "authority":
                holder = fields["to"] or tr("nobody")
                what = tr("{0} is held by {1}").format(fields["resource"], holder)
            case _:
                said = fields.get("text") or fields.get("name") or ""
                what = (
                    tr("{0} begins: {1} {2}")
                    .format(fields["application"], fields["action"], said)
                    .rstrip()
                )
        return tr("{0} s: {1}").format(f"{self.at / SECOND:g}", what)


def chances(events: Iterable[TraceFields]) -> list[Chance]:
    """Those of a run, in its order. That an application which then did nothing has begun is not
    usual: it says nothing of what somebody rehearsed."""
    kept = [
        event
        for event in events
        if event["kind"] in _FIELDS and event.get("action", "speech") in _TOLD
    ]
    entered = Counter(event["application"] for event in kept if event["kind"] == "enter")
    return [
        Chance(
            microseconds(event["t"]),
            _expected(event),
            event["kind"] in _USUAL and entered.get(event.get("application"), 2) > 1,
        )
        for event in kept
    ]


def written(course: Course, expected: Iterable[Chance]) -> bytes:
    """A scenario: what was done in a course, what is expected of it, and its end.

    What is expected at a moment stands behind what is done then. That another version was taken in
    is left out: a scenario runs the project as it is then.
    """
    done = [(o.at, 0, o.does) for o in course.done if not isinstance(o.does, inputs.Deploy)]
    wanted = [(one.at, 1, Expect(one.fields)) for one in expected]
    ordered = sorted([*done, *wanted], key=lambda one: one[:2])
    return scenario.write([*((at, does) for at, _, does in ordered), (course.now, End())])


def _expected(event: TraceFields) -> dict[str, Any]:
    found = {"kind": event["kind"]}
    for name in _FIELDS[event["kind"]]:
        # That nobody holds something, or no situation is, is told by null; else it says nothing.
        if name == "to" or event.get(name) is not None:
            found[name] = event[name]
    return found
