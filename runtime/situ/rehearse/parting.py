"""Where two runs part, in plain words: what each did there."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from situ.document import words
from situ.rehearse.comparing import Difference, Stretch
from situ.rehearse.deeds import Deed
from situ.rehearse.recording import Fields
from situ.rehearse.telling import Teller, moment

SAID = 2
"""Deeds of one run that are told; more are counted."""
EventOf = Callable[[int], Fields]
"""The event of a run by its ``seq``."""


class Parting(Struct, frozen=True):
    """What each of two runs did, a sentence each; none: nothing of that. strands: of what it is
    told: applications, resources, ``situation``.
    """

    at: tuple[float, float]
    strands: tuple[str, ...]
    first: tuple[str, ...]
    second: tuple[str, ...]


def told(
    difference: Difference, tellers: tuple[Teller, Teller], events: tuple[EventOf, EventOf]
) -> Parting:
    """In the words of each run's own project."""
    stretches = difference.stretches
    sides = (
        _side([one.first for one in stretches], tellers[0], events[0]),
        _side([one.second for one in stretches], tellers[1], events[1]),
    )
    return Parting(difference.at, tuple(map(_strand, stretches)), *sides)


def _strand(stretch: Stretch) -> str:
    return stretch.strand.name or "situation"


def _side(stretches: list[tuple[Deed, ...]], teller: Teller, event_of: EventOf) -> tuple[str, ...]:
    deeds = sorted((deed for one in stretches for deed in one), key=lambda deed: deed.seq)
    shown: list[str] = []
    left = 0
    for deed in deeds:
        event = event_of(deed.seq)
        if event["kind"] == "enter" and deed is not deeds[0]:
            continue  # told by the transition before
        if len(shown) < SAID:
            shown.append(_words(teller, event))
        else:
            left += 1
    return (*shown, f"{left} more") if left else tuple(shown)


def _words(teller: Teller, event: Fields) -> str:
    if event["kind"] != "mapping":
        return teller.tell(event)
    module, value = event["module"], event["value"]
    match value:
        case {"components": _}:
            return f"{module} shows another screen"
        case {"text": str(text)}:
            return f"{module} says {words.quoted(text)}"
        case {"src": str(src)}:
            return f"{module} plays {src}"
        case {"command": str(command)}:
            return f"{module} lets {event['resource']} {command}"
    return teller.tell(event)


def lines(parting: Parting, names: tuple[str, str]) -> list[str]:
    """As three lines: when and of what, then what each did."""
    times = " | ".join(moment(t) for t in parting.at)
    wide = max(map(len, names))
    return [
        f"{times}  {words.listed(parting.strands)}",
        *(
            f"  {name + ':':<{wide + 1}} {'; '.join(said) or 'nothing of that'}"
            for name, said in zip(names, (parting.first, parting.second), strict=True)
        ),
    ]
