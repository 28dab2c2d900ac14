"""Which cards of an application are others than a moment ago, without a look at all the rest.

An edit exchanges a state or two; whoever shows thousands of them needs no more than these.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import compress, count
from operator import is_not
from typing import NamedTuple

from situ.document.rbd import Always, Application, State


class Exchanged(NamedTuple):
    """at: where it stands, ``always`` first where there is one, then the states."""

    at: int
    old: State | Always
    new: State | Always


def exchanged(before: Application | None, now: Application) -> list[Exchanged] | None:
    """What stands in another's place; None where there are other numbers than before, or more, or
    fewer."""
    if before is None or (before.always is None) != (now.always is None):
        return None
    if len(before.states) != len(now.states):
        return None
    old, new = _parts(before), _parts(now)
    found = [Exchanged(at, old[at], new[at]) for at in compress(count(), map(is_not, old, new))]
    return None if any(_no(one.old) != _no(one.new) for one in found) else found


def draws_the_same(before: Application | None, now: Application) -> bool:
    """Whether it has the notes and frames that it had; False where that is not told at once."""
    parts = exchanged(before, now)
    if before is None or parts is None or before.aside.inside != now.aside.inside:
        return False
    return all(one.old.aside.before == one.new.aside.before for one in parts)


def _parts(application: Application) -> Sequence[State | Always]:
    if application.always is None:
        return application.states
    return (application.always, *application.states)


def _no(part: State | Always) -> str | None:
    return part.no if isinstance(part, State) else None
