"""What a robot did, out of a trace: its deeds, each in the strand of who or what did it.

A deed is a state entered or left by a way, a situation, a resource's new holder, what moves a
resource, a call of what lies outside. Two runs are compared by them (``comparing``), so a deed has
no time in it, and nothing that is another in each run of the same robot: of what a module commands
and of what the screen shows numbers do not count, and what goes on alike is one deed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal, NamedTuple

import msgspec
from msgspec import Struct

from situ.rehearse.recording import Fields

StrandKind = Literal["state", "situation", "resource"]
OUTSIDE = frozenset({"service", "launch", "message"})
"""Actions that use no resource, but are seen outside of the robot."""
_DIGITS = str.maketrans("", "", "0123456789")


class Strand(NamedTuple):
    """What goes its own way through a run: an application's states, the situation (name: empty),
    a resource. In which order those of different strands come is chance."""

    kind: StrandKind
    name: str


class Deed(Struct, frozen=True, gc=False):
    """The event ``seq`` at ``t`` seconds. what: equal where two robots did the same."""

    seq: int
    t: float
    what: str


class Deeds:
    """Gathered event by event. ``strands`` has each one's deeds in their order."""

    def __init__(self) -> None:
        self.strands: dict[Strand, list[Deed]] = {}
        self.count = 0
        self.seq = 0
        """Of the last event that was looked at."""
        self._applications: set[str] = set()

    def add(self, event: Fields) -> None:
        """The next event of the trace; those of other kinds are passed over."""
        self.seq = event["seq"]
        match event["kind"]:
            case "enter":
                self._applications.add(event["application"])
                self._take(event, Strand("state", event["application"]), "enter", event["state"])
            case "transition":
                how = (event["from"], event["to"], event["event"], bool(event.get("timeout")))
                self._take(event, Strand("state", event["application"]), "go", *how)
            case "action" if event["action"] in OUTSIDE:
                said = [event.get(key) for key in ("action", "name", "topic", "params", "value")]
                self._take(event, Strand("state", event["application"]), *said)
            case "situation":
                self._take(event, Strand("situation", ""), event["to"])
            case "authority":
                self._take(event, Strand("resource", event["resource"]), "held", event["to"])
            case "mapping" if event["value"] is not None:
                self._output(event)

    def _output(self, event: Fields) -> None:
        resource, module, value = event["resource"], event["module"], event["value"]
        strand = Strand("resource", resource)
        if resource == "screen":
            self._take_once(event, strand, "does", module, _each(value, _without_digits))
        elif module in self._applications:
            self._take(event, strand, "does", module, value)
        else:
            self._take_once(event, strand, "does", module, _each(value, _without_numbers))

    def _take_once(self, event: Fields, strand: Strand, *what: Any) -> None:
        """A stream that goes on alike is one deed."""
        before = self.strands.get(strand)
        if not before or before[-1].what != _text(what):
            self._take(event, strand, *what)

    def _take(self, event: Fields, strand: Strand, *what: Any) -> None:
        self.strands.setdefault(strand, []).append(Deed(event["seq"], event["t"], _text(what)))
        self.count += 1


def _text(what: tuple[Any, ...]) -> str:
    return msgspec.json.encode(what, order="sorted").decode()


def _each(value: Any, leaf: Callable[[Any], Any]) -> Any:
    """The same with each of its leaves made another."""
    if isinstance(value, dict):
        return {key: _each(one, leaf) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_each(one, leaf) for one in value]
    return leaf(value)


def _without_numbers(value: Any) -> Any:
    return 0 if isinstance(value, int | float) and not isinstance(value, bool) else value


def _without_digits(value: Any) -> Any:
    """A live text may count seconds."""
    return value.translate(_DIGITS) if isinstance(value, str) else value
