"""Why an action did not begin (formats.md, *Actions*)."""

from __future__ import annotations

import re
from typing import Any

from situ.decide.program import is_optional, name_of
from situ.document import names, words
from situ.document.project import Project
from situ.document.rbd import Action, Sound, Speech, resource_of
from situ.rehearse.past import Past
from situ.rehearse.reason import Reason
from situ.rehearse.recording import Fields
from situ.rehearse.stays import Stay
from situ.rehearse.telling import moment
from situ.rehearse.ways import Frame, Place, actions, ways
from situ.rehearse.why_held import why_not_held
from situ.rehearse.why_state import Stuck

MOST = 3
"""Actions that fit what was asked for, of which is told; more are only counted."""

_SAME = ("resource", "command", "program", "topic", "tag", "src", "lang", "text")


def why_not_begun(
    past: Past, stuck: Stuck, application: str, wanted: dict[str, Any]
) -> list[Reason]:
    """What kept the actions that fit ``wanted`` from beginning."""
    found = [
        (file, place, frame, action)
        for file, place, frame, action in actions(past.project, application)
        if _fits(action, frame, wanted)
    ]
    if not found:
        return [Reason(code="no-way", text=f"{application} has no such action")]
    reasons: list[Reason] = []
    for file, place, frame, action in found[:MOST]:
        below = _one(past, stuck, application, file, place, frame, action)
        text = f"{words.whole_action(action)} of state {words.state(frame.state)}"
        if place[0] == "always" or "event" in place:
            text = f"{words.whole_action(action)} of an event of {' '.join(place[:2])}"
        reasons.append(Reason(code="note", text=text, below=tuple(below)))
    if len(found) > MOST:
        said = f"{len(found) - MOST} more actions fit; name its state to be told of one"
        reasons.append(Reason(code="note", text=said))
    return list(reasons[0].below) if len(found) == 1 else reasons


def _fits(action: Action, frame: Frame, wanted: dict[str, Any]) -> bool:
    if wanted.get("action") not in (None, action.element):
        return False
    if wanted.get("state") not in (None, frame.no):
        return False
    if "name" in wanted and wanted["name"] != name_of(action):
        return False
    return all(
        _may_be(getattr(action, field), wanted[field])
        for field in _SAME
        if field in wanted and isinstance(getattr(action, field, None), str)
    )


def _may_be(written: str, wanted: Any) -> bool:
    """Whether a text with references may be ``wanted`` once it is filled in."""
    pieces = names.split(written)
    pattern = "".join(re.escape(text) + (".*" if name else "") for text, name in pieces)
    return isinstance(wanted, str) and re.fullmatch(pattern, wanted, re.DOTALL) is not None


def _one(
    past: Past, stuck: Stuck, application: str, file: str, place: Place, frame: Frame,
    action: Action,
) -> list[Reason]:  # fmt: skip
    if "event" in place:
        return _of_event(past, stuck, application, file, place, frame)
    elsewhere = stuck.why_not_in(frame.no)
    if elsewhere:
        return elsewhere
    stay = next(s for s in stuck.now() if f"{s.state}/".startswith(f"{frame.no}/"))
    if stay.suspended is not None:
        said = f"the state is the right one, but {stuck.since(stay.suspended)}"
        return [stuck.suspended(said, stay.suspended)]
    return [_in_turn(past, stay, application, frame, int(place[-1]), action)]


def _in_turn(
    past: Past, stay: Stay, application: str, frame: Frame, index: int, action: Action
) -> Reason:
    """The state is there and not suspended: what comes before the action in its turn."""
    began = [e for e in stay.events if e["kind"] == "action" and _is(past.project, action, e)]
    if began:
        said = f"it began at {moment(began[-1]['t'])} already"
        return Reason(code="already", text=said, seq=began[-1]["seq"])
    resource = resource_of(action)
    if resource is not None and is_optional(action):
        below = tuple(why_not_held(past, application, resource))
        said = f"it is optional, and {application} did not hold {resource}"
        return Reason(code="optional", text=said, below=below)
    speaks = isinstance(action, (Speech, Sound))
    for before in frame.state.actions[:index]:
        running = _running(past.project, stay, before)
        if running is None:
            continue
        at = moment(running["t"])
        if before.wait:
            said = f"it waits for {words.whole_action(before)}, running since {at}"
            return Reason(code="wait", text=said, seq=running["seq"])
        if speaks and isinstance(before, (Speech, Sound)):
            said = f"the voice was taken by {words.whole_action(before)} since {at}"
            return Reason(code="voice", text=said, seq=running["seq"])
    said = "it waits for an action before it, or has been superseded"
    return Reason(code="wait", text=said, seq=stay.entered["seq"])


def _running(project: Project, stay: Stay, action: Action) -> Fields | None:
    """The event by which an action began that has not ended in this stay."""
    found: Fields | None = None
    for event in stay.events:
        if event["kind"] == "action" and _is(project, action, event):
            found = event
        elif (
            found is not None
            and event["kind"] in ("finished", "cancelled")
            and (event["action"], event["name"]) == (found["action"], found["name"])
        ):
            found = None
    return found


def _is(project: Project, action: Action, event: Fields) -> bool:
    """Whether a trace event is this action's; of speeches by what they say, in any language."""
    if event["action"] != action.element or event["name"] != name_of(action):
        return False
    if not isinstance(action, Speech):
        return True
    said = [action.text, *(known.get(action.text, "") for known in project.texts.values())]
    return any(_may_be(text, event.get("text")) for text in said if text)


def _of_event(
    past: Past, stuck: Stuck, application: str, file: str, place: Place, frame: Frame
) -> list[Reason]:
    at = place[: place.index("event") + 2]
    for stay in stuck.now():
        for way in ways(past.project, application, stay.state):
            if (way.file, way.place) == (file, at):
                return stuck.why_not_taken(stay, way)
    return stuck.why_not_in(frame.no)
