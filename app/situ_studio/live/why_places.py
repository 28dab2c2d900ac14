"""What an event of the trace is about: where it stands in the project, and the values it hung on.

No Qt; everything is read from the documents as they are open.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from situ.document.condition import Condition, Group, Test
from situ.document.project import Project
from situ.document.rbd import Event
from situ.rehearse.ways import Way, file_of, frames, ways
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.live.moment import Moment, TraceFields
from situ_studio.live.why import Thing


def meant_by(
    project: Project, file: str, document: Document, place: Place, moment: Moment
) -> tuple[Thing | None, Thing | None]:
    """What a selected place is to ask about at a moment; what is told of where that never was."""
    thing = thing_at(project, file, document, place)
    if thing is None and document is project.spds and not place:
        current = moment.situation
        return (Thing("situation", current) if current is not None else None), None
    if thing is not None and thing.kind == "application" and _stands_still(moment, thing.name):
        return Thing("halt", thing.name), thing
    if places.is_component(place):
        return thing, thing_at(project, file, document, places.root(place))
    return thing, None


def _stands_still(moment: Moment, application: str) -> bool:
    one = moment.applications.get(application)
    return one is not None and (one.suspended or one.paused)


def thing_at(project: Project, file: str, document: Document, place: Place) -> Thing | None:
    """What a selected place of a document is to ask about; the ground is what is now there."""
    if file in project.applications or file in project.parts:
        return _in_application(file, document, place)
    if document is not project.spds:
        return None
    match place:
        case ():
            return None
        case ("situation", _, "entry" | "module", name) if not name.isdigit():
            return Thing("module", name)
        case ("situation", name, "condition" | "until", *_):
            return Thing("condition", name)
        case ("situation", name, *_):
            return Thing("situation", name)
        case ("module", _, "resource", name) | ("resource", name):
            return Thing("resource", name)
        case ("module", name, *_):
            return Thing("module", name)
        case ("data", name, *_):
            return Thing("tag", name)
    return None


def _in_application(file: str, document: Any, place: Place) -> Thing | None:
    holder, own = place[1:2], place[2:]
    if place[:1] == ("always",):
        holder, own = ("",), place[1:]
    if own[:1] == ("timeout",):
        return Thing("transition", "", file, holder[0], timeout=True)
    if own[:1] == ("event",) and len(own) > 1:
        value = document.always if holder == ("",) else document.state(holder[0])
        events = value.events if value is not None else ()
        if own[1].isdigit() and int(own[1]) < len(events):
            return Thing("transition", events[int(own[1])].name or "", file, holder[0])
    event = getattr(places.get(document, place), "event", None) if len(place) > 2 else None
    if places.is_component(place) and event:
        return Thing("transition", event, file, holder[0])
    if place[:1] == ("state",):
        return Thing("state", holder[0], file)
    return Thing("application", document.name)


def where(project: Project, event: TraceFields) -> tuple[str, Place] | None:
    """The file and the place that an event is about; None where it is about none."""
    name, script = event.get("application"), project.spds_file
    if name is not None:
        state = event.get("state") or event.get("from")
        file = file_of(project, name)
        if state is None:
            return None if file is None else (file, ())
        if event["kind"] == "transition":
            way = way_of(project, event)
            if way is not None:
                return way.file, way.place
        active = frames(project, name, state)
        return (active[-1].file, ("state", active[-1].state.no)) if active else None
    if script is None:
        return None
    match event["kind"]:
        case "condition":
            return script, ("situation", event["situation"])
        case "situation" if event["to"] is not None:
            return script, ("situation", event["to"])
        case "data":
            return script, ("data", event["tag"])
    module = event.get("module") or event.get("to") or event.get("from")
    return (script, ("module", module)) if module is not None else None


def way_of(project: Project, event: TraceFields) -> Way | None:
    """The way that a transition took, as the documents have it; of two alike the first."""
    timeout = bool(event.get("timeout"))
    for way in ways(project, event["application"], event["from"]):
        if timeout and way.timeout is not None:
            return way
        if not timeout and way.event is not None and (way.event.name or None) == event["event"]:
            return way
    return None


def tags_of(project: Project, event: TraceFields) -> tuple[str, ...]:
    """The tags whose values the event hung on: of a situation's condition, of a guard."""
    script, found = project.spds, None
    if event["kind"] in ("situation", "condition") and script is not None:
        name = event["to"] if event["kind"] == "situation" else event["situation"]
        situation = script.situation(name) if name is not None else None
        found = situation.condition if situation is not None else None
    elif event["kind"] == "transition":
        way = way_of(project, event)
        says = way.says if way is not None else None
        found = says.when if isinstance(says, Event) else None
    return tags_in(found)


def tags_in(condition: Condition | None) -> tuple[str, ...]:
    """Those that a condition looks at, each once."""
    return tuple(dict.fromkeys(_tags(condition)))


def _tags(condition: Condition | None) -> Iterator[str]:
    def below(children: Iterable[Test | Group]) -> Iterator[str]:
        for child in children:
            if isinstance(child, Group):
                yield from below(child.children)
            else:
                yield child.tag

    if condition is not None:
        yield from below(condition.children)


def priorities(project: Project, event: TraceFields, moment: Moment) -> dict[str, int | None]:
    """Of who is given a resource: the priority of all that ask for it, the highest first."""
    script = project.spds
    if event["kind"] != "authority" or script is None or moment.situation is None:
        return {}
    situation = script.situation(moment.situation)
    if situation is None:
        return {}
    known = script.priorities(situation)
    asking = [m for m, wanted in moment.asking.items() if event["resource"] in wanted]
    every = {module: known.get(module) for module in asking}
    return dict(sorted(every.items(), key=lambda one: -(one[1] or 0)))
