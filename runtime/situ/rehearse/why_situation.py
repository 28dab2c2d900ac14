"""Why a situation was not current (formats.md, *SPDS*)."""

from __future__ import annotations

from situ.document import words
from situ.document.spds import Situation, Spds
from situ.rehearse.past import Past
from situ.rehearse.reason import Reason, not_held
from situ.rehearse.recording import Fields
from situ.rehearse.telling import moment


def why_not_current(
    past: Past, script: Spds, events: list[Fields], wanted: Situation
) -> list[Reason]:
    """What kept ``wanted``, which is not current, from being so. events: up to that moment."""
    current = past.situation["to"] if past.situation is not None else None
    found: list[Reason] = []
    if not past.holds(wanted.condition) and wanted.condition is not None:
        said, values = not_held(past.judge(child) for child in wanted.condition.children)
        text = f"the condition of {wanted.name} did not hold: {'; '.join(said)}"
        seq = past.holding[wanted.name]["seq"] if wanted.name in past.holding else None
        found.append(Reason(code="condition", text=text, seq=seq, values=values))
    if wanted.until is not None and past.holds(wanted.until):
        _, values = not_held(past.judge(child) for child in wanted.until.children)
        held = "; ".join(past.judge(child).text for child in wanted.until.children)
        text = f"until of {wanted.name} held, so it does not begin: {held}"
        found.append(Reason(code="until", text=text, values=values))
    names = [situation.name for situation in script.situations]
    if current in names and names.index(current) < names.index(wanted.name):
        assert past.situation is not None
        found.append(_goes_first(past, script, past.situation, wanted.name))
    return found or [_spent(events, wanted.name)]


def _goes_first(past: Past, script: Spds, event: Fields, name: str) -> Reason:
    first = script.situation(event["to"])
    assert first is not None
    said = (
        f"situation {first.name}, which goes before {name}, was current since {moment(event['t'])}"
    )
    if past.holds(first.condition):
        assert first.condition is not None  # only the last one has none
        said += f": {words.condition(first.condition)}"
        return Reason(code="order", text=said, seq=event["seq"])
    keeps = []
    if first.dwell is not None:
        keeps.append(f"it stays at least {words.seconds(first.dwell)}")
    if first.until is not None:
        keeps.append(f"it stays until {words.condition(first.until)}")
    if first.limit is not None:
        keeps.append(f"it ends after {words.seconds(first.limit)} at the latest")
    return Reason(code="kept", text=f"{said}; {words.listed(keeps)}", seq=event["seq"])


def _spent(events: list[Fields], name: str) -> Reason:
    """Its condition holds and nothing goes before it: ``until`` or ``limit`` has ended it."""
    last = [e for e in events if e["kind"] == "situation" and e["from"] == name]
    said = (
        f"{name} has ended by until or limit and begins again only after its condition has once "
        "been false"
    )
    if last:
        said = (
            f"{name} has ended at {moment(last[-1]['t'])} by until or limit and begins again only "
            "after its condition has once been false"
        )
    return Reason(code="spent", text=said, seq=last[-1]["seq"] if last else None)
