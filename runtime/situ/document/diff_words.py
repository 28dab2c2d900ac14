"""The words of a comparison: what things and their attributes are called, and their values."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from typing import Any

from situ.document import modules, rbd, spds, words
from situ.document.codec import Document
from situ.document.grammar import Attribute

PLACES: dict[str, tuple[str, str | None]] = {
    "states": ("state", "no"),
    "actions": ("action", None),
    "events": ("event", None),
    "says": ("say", None),
    "components": ("", "id"),
    "params": ("param", None),
    "results": ("result", None),
    "observe": ("data", "tag"),
    "modules": ("module", "name"),
    "situations": ("situation", "name"),
    "entries": ("entry", None),
    "requires": ("requires", None),
    "provides": ("provides", None),
}
"""How a place goes on into a list: its word, and the field that names a member (None: index)."""

ORDER_COUNTS = {"actions": True, "components": True, "situations": True, "results": True}
"""Lists whose order is behaviour; that of events is where they compete."""

SILENT_FIELDS = {(modules.Module, "description")}
"""What no robot acts on."""

_LABELS = {
    "no": "number",
    "always": "part of always",
    "final": "meant as an end",
    "idle": "only while nothing happens",
    "bargein": "may be interrupted by speech",
    "wait": "the next waits for it",
    "keep": "runs on when the state is left",
    "optional": "optional",
    "src": "source",
    "max": "most characters",
    "done": "event when done",
    "failed": "event when failed",
    "touched": "event of a touch",
    "size": "text size",
    "dwell": "stays at least",
    "limit": "ends at the latest after",
    "from": "taken from",
}
_SECONDS = {"seconds", "dwell", "limit"}
_TEXTS = {"text", "label", "description", "value"}


def attribute(before: Any, after: Any, element: str, one: Attribute) -> str:
    """One attribute that changed: ``timeout 30 → 60 s``, ``text “Hi” → “Hello”``."""
    old, new = getattr(before, one.field), getattr(after, one.field)
    if isinstance(after, spds.Entry) and one.field == "priority":
        return f"{shown(old)} → {shown(new)}"
    label = _LABELS.get(one.name, one.name)
    if not one.name:
        label = "timeout" if one.field == "seconds" else one.field
    if isinstance(after, rbd.Speech | rbd.Say) and one.field == "text":
        return _both(old, new)
    if element == "flow":
        label = "part"
    if isinstance(old, str) and isinstance(new, str):
        plain = one.field not in _TEXTS and all(text.split() == [text] for text in (old, new))
        return f"{label} {old} → {new}" if plain else f"{label} {_both(old, new)}"
    unit = " s" if one.field in _SECONDS else ""
    if old is None:
        return f"{label} now {shown(new)}{unit}"
    if new is None:
        return f"{label} {shown(old)}{unit} gone"
    return f"{label} {shown(old)} → {shown(new)}{unit}"


def shown(value: Any) -> str:
    """A value of an attribute or of ``situ.toml``."""
    if value is None:
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return words.number(value)
    if isinstance(value, str):
        return words.quoted(value)
    if isinstance(value, tuple | list) and all(isinstance(one, str) for one in value):
        return " ".join(value) or "none"
    return json.dumps(value, ensure_ascii=False, default=str)


def _both(old: str, new: str) -> str:
    """Two texts, of long ones what differs with a little around it."""
    first, then = words.quoted(old), words.quoted(new)
    if first == then or (len(old) > words.LONGEST or len(new) > words.LONGEST):
        start = 0
        while start < min(len(old), len(new)) and old[start] == new[start]:
            start += 1
        end = 0
        while end < min(len(old), len(new)) - start and old[-1 - end] == new[-1 - end]:
            end += 1
        first, then = (_around(text, start, len(text) - end) for text in (old, new))
    if first == then:
        first, then = (json.dumps(text, ensure_ascii=False) for text in (old, new))
    return f"{first} → {then}"


def _around(text: str, start: int, end: int) -> str:
    first = max(0, start - 20)
    last = min(len(text), end + 20)
    cut = words.quoted(text[first:last])[1:-1]
    return f"“{'…' if first else ''}{cut}{'…' if last < len(text) else ''}”"


# -- things ------------------------------------------------------------------


def member(value: Any, document: Document | None = None) -> str:
    """A thing that came or went: ``event clickNo, leads to 6 no user``."""
    match value:
        case rbd.Action():
            return words.whole_action(value)
        case rbd.Component():
            text = getattr(value, "text", "")
            return (
                f"{words.component(value)} {words.quoted(text)}" if text else words.component(value)
            )
        case rbd.Event():
            to = ""
            if value.next is not None and isinstance(document, rbd.Application):
                to = f", leads to {words.leads(document, value.next)}"
            when = f", when {words.condition(value.when)}" if value.when is not None else ""
            return f"{words.event(value)}{to}{when}"
        case rbd.Say(text=text):
            return f"phrase {words.quoted(text)}"
        case rbd.Param(name=name, text=text):
            return f"param {name} {words.quoted(text)}"
        case rbd.Result(tag=tag, path=path):
            return f"result {tag} from {words.quoted(path)}"
        case spds.Observed(tag=tag):
            return f"data {tag}"
        case spds.Declaration(name=name, resources=resources):
            return f"module {name} ({shown(resources)})"
        case spds.Entry(module=module, priority=priority):
            return f"priority of {module} {shown(priority)}"
        case modules.Requires(data=data, module=module):
            return f"need of {f'module {module}' if data is None else f'data {data}'}"
    assert isinstance(value, modules.Provides)
    return f"provided data {value.data}"


def subject(value: Any, among: Sequence[Any]) -> str:
    """A thing at the start of a line about it, told from the others of its list."""
    match value:
        case rbd.State(name=name):
            alone = sum(other.name == name for other in among) == 1
            return f"state {name}" if name and alone else f"state {words.state(value)}"
        case rbd.Event():
            return _counted(words.event(value), value, among, words.event)
        case rbd.Action():
            return _counted(_called(value), value, among, _called)
        case rbd.Component():
            return words.component(value)
        case rbd.Say():
            return f"phrase {words.quoted(value.text)}"
        case rbd.Param(name=name):
            return f"param {name}"
        case rbd.Result(tag=tag):
            return f"result {tag}"
        case spds.Situation(name=name):
            return f"situation {name}"
        case spds.Observed(tag=tag):
            return f"data {tag}"
        case spds.Entry(module=module):
            return f"priority of {module}"
        case spds.Declaration(name=name) | modules.Module(name=name):
            return f"module {name}"
    return member(value)


def _called(action: rbd.Action) -> str:
    own = getattr(action, "name", None) or getattr(action, "tag", None)
    own = own or getattr(action, "resource", None) or getattr(action, "topic", None)
    own = own or getattr(action, "program", None)
    return f"{action.element} {own}" if own else action.element


def _counted(said: str, value: Any, among: Sequence[Any], call: Callable[[Any], str]) -> str:
    """With its number among those called the same."""
    alike = [one for one in among if call(one) == said]
    if len(alike) < 2:
        return said
    number = next(n for n, one in enumerate(alike, 1) if one is value)
    return f"{said} ({number})"
