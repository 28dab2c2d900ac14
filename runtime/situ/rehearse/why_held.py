"""Why a module did not hold a resource, or did not move it (formats.md, *SPDS*)."""

from __future__ import annotations

from situ.document import words
from situ.document.names import RESERVED_ROOTS
from situ.rehearse.past import Past
from situ.rehearse.reason import Reason
from situ.rehearse.recording import Fields
from situ.rehearse.telling import moment, value_words

MODULE = RESERVED_ROOTS[1]


def why_not_held(past: Past, module: str, resource: str) -> list[Reason]:
    """What kept ``module`` from holding ``resource``; empty where it holds it."""
    holder = past.holders.get(resource)
    if holder is not None and holder["to"] == module:
        return []
    declared = past.project.resources(module)
    applications = {a.name for a in past.project.applications.values()}
    if declared is None and module not in applications:
        return [Reason(code="request", text=f"no module {module} is declared")]
    if declared is not None and resource not in declared:
        said = f"{module} did not declare {resource}, only {words.listed(declared) or 'nothing'}"
        return [Reason(code="request", text=said)]
    asking = past.requests.get(module)
    if asking is None or resource not in (*asking.resources, *asking.optional):
        return [_not_asked(past, module, resource)]
    mine = past.priority(module)
    seq = None if past.situation is None else past.situation["seq"]
    if mine is None:
        said = f"{module} has no priority in {_situation(past)}"
        return [Reason(code="priority", text=said, seq=seq)]
    if resource in asking.optional:
        return [_in_front(past, module, mine, resource)]
    held = [r for r in asking.resources if past.holder(r) not in (None, module)]
    if not held:
        held = [r for r in asking.resources if past.holder(r) is None]
    found = [_in_front(past, module, mine, one) for one in held]
    if resource not in held and len(asking.resources) > 1:
        said = f"{module} asks for {words.listed(asking.resources)} together: all of them or none"
        return [Reason(code="resources", text=said, seq=asking.event["seq"], below=tuple(found))]
    return found


def why_suspended(past: Past, application: str, suspend: Fields) -> tuple[Reason, ...]:
    """What keeps a suspended application from its resources; one reason for the same thing."""
    found: dict[str, Reason] = {}
    for resource in suspend["missing"]:
        for reason in why_not_held(past, application, resource):
            found.setdefault(reason.text, reason)
    return tuple(found.values())


def _not_asked(past: Past, module: str, resource: str) -> Reason:
    lost = past.lost.get(module)
    if lost is not None:
        said = f"{module} was lost at {moment(lost['t'])} and has not asked again"
        return Reason(code="request", text=said, seq=lost["seq"])
    gave = past.given_back.get((module, resource))
    if gave is not None:
        at = moment(gave["t"])
        said = f"{module} gave {resource} back at {at} and has not asked for it again"
        return Reason(code="request", text=said, seq=gave["seq"])
    in_vain = past.given_up.get((module, resource))
    if in_vain is not None:
        asked, ended = (moment(event["t"]) for event in in_vain)
        said = f"{module} asked for {resource} from {asked} to {ended} in vain, and not again since"
        return Reason(code="request", text=said, seq=in_vain[1]["seq"])
    asking = past.requests.get(module)
    if asking is None:
        return Reason(code="request", text=f"{module} did not ask for {resource}")
    asked = words.listed((*asking.resources, *asking.optional))
    said = f"{module} did not ask for {resource}, only for {asked}"
    return Reason(code="request", text=said, seq=asking.event["seq"])


def _in_front(past: Past, module: str, mine: int, resource: str) -> Reason:
    """Who holds a resource, and why ``module`` does not come first."""
    holder = past.holder(resource)
    event = past.holders.get(resource)
    if holder is None or event is None:
        return Reason(code="resources", text=f"nobody held {resource}")
    theirs = past.priority(holder)
    since = f"{holder} held {resource} since {moment(event['t'])}"
    if theirs is not None and theirs > mine:
        said = f"{since}: priority {theirs} against {mine} of {module} in {_situation(past)}"
    elif theirs == mine:
        said = f"{since}: priority {mine} like {module}, and it came first"
    else:
        said = since
    return Reason(code="priority", text=said, seq=event["seq"])


def _situation(past: Past) -> str:
    if past.situation is None or past.situation["to"] is None:
        return "this project" if past.project.spds is None else "no situation"
    return f"situation {past.situation['to']}"


def why_not_moved(past: Past, module: str, resource: str) -> list[Reason]:
    """What kept a command of ``module`` from ``robot/<resource>``."""
    found = why_not_held(past, module, resource)
    if found:
        return found
    mapped = past.robot.get(resource)
    command = past.board.look(f"{MODULE}{module}/{resource}")
    if mapped is None or mapped["value"] is None or mapped["module"] != module:
        said = f"{module} held {resource} but had no valid command for it"
        if command is not None:
            older = value_words(command)
            said = f"{said}; what it commanded, {older}, was older than its authority"
        return [Reason(code="command", text=said, seq=past.holders[resource]["seq"])]
    said = f"{resource} was already moved by {module}: {value_words(mapped['value'])}"
    return [Reason(code="command", text=said, seq=mapped["seq"])]
