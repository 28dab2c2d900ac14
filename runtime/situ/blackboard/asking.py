"""What applications ask of modules (``service url="board:module/request"``), and who answers.

No I/O. The core tells a module that something changed; what is asked of it stands here until
it is answered, taken back, or nobody can answer it any more.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable
from typing import Any

from msgspec import Struct

from situ.blackboard.replies import Question
from situ.blackboard.services import PATIENCE, asked_of
from situ.decide.effects import Begin
from situ.decide.inputs import Finish
from situ.decide.step import SECOND

ERROR = 500
"""Characters of what a module says that went wrong."""


class Asking:
    """All that is asked of modules and not answered yet.

    counts: module to how often that changed for it. tell: is told each such module, once a change.
    heeds: whether answers count, and nothing is waited for longer than patience (seconds); not
    so where a scenario says what ends.
    """

    def __init__(self, tell: Callable[[str], None], patience: float = PATIENCE) -> None:
        self.counts: Counter[str] = Counter()
        self.heeds = True
        self._tell = tell
        self._patience = patience
        self._asked: dict[int, _Asked] = {}
        self._serves: dict[str, frozenset[str]] = {}

    def __len__(self) -> int:
        return len(self._asked)

    def clear(self) -> None:
        """Nothing is asked, nobody has said what it answers."""
        self._asked.clear()
        self._serves.clear()

    def begin(self, effect: Begin, now: int, present: Collection[str]) -> None:
        """An application asks. present: the modules that are connected."""
        wanted = asked_of(effect)
        assert wanted is not None
        module, request = wanted
        params = effect.fields.get("params")
        question = Question(
            effect.id, request, params if isinstance(params, dict) else {}, effect.application
        )
        one = _Asked(question, module, now + int(self._patience * SECOND))
        self._asked[effect.id] = one
        if module not in present:
            one.end(now, f"{module} is not connected, so it can not be asked to {request}")
        elif not self._check(one, now):
            self._changed(module)

    def keep(self, begun: Iterable[Any]) -> None:
        """begun: effects, all that still runs; what is asked for none of them is over."""
        running = {effect.id for effect in begun if isinstance(effect, Begin)}
        for one in [one for one in self._asked.values() if one.question.id not in running]:
            del self._asked[one.question.id]
            self._changed(one.module)

    def serve(self, module: str, requests: Iterable[str], now: int) -> tuple[Question, ...]:
        """A module says what it answers; what is asked of it, in order."""
        self._serves[module] = frozenset(requests)
        mine = [one for one in self._asked.values() if one.module == module]
        return tuple(one.question for one in mine if not self._check(one, now))

    def lost(self, module: str, now: int) -> None:
        """A module is gone."""
        self._serves.pop(module, None)
        for one in self._asked.values():
            if one.module == module:
                why = f"{module} was lost before it answered {one.question.request}"
                one.end(now, f"{why}; whether it was done is not known")

    def asked_of(self, number: int) -> str | None:
        """The module that this is asked of; None where nobody waits for an answer."""
        one = self._asked.get(number)
        return None if one is None else one.module

    def due(self) -> int | None:
        """When ``overdue`` next has something, in µs."""
        if not self._asked or not self.heeds:
            return None
        return min((one.due for one in self._asked.values()), default=None)

    def overdue(self, now: int) -> list[Finish]:
        """What nobody answers any more: each fails in words."""
        return [
            Finish(id=one.question.id, ok=False, error=self._error(one), status=None)
            for one in self._asked.values()
            if self.heeds and one.due <= now
        ]

    def _check(self, one: _Asked, now: int) -> bool:
        """Whether the module says that it does not know the request."""
        serves = self._serves.get(one.module)
        request = one.question.request
        if serves is None or request in serves:
            return False
        known = ", ".join(sorted(serves)) or "none"
        one.end(now, f"{one.module} has no request {request}; it has {known}")
        return True

    def _error(self, one: _Asked) -> str:
        if one.why is not None:
            return one.why
        return f"{one.module} did not answer {one.question.request} within {self._patience:g} s"

    def _changed(self, module: str) -> None:
        self.counts[module] += 1
        self._tell(module)


class _Asked(Struct):
    """due: µs, when it fails."""

    question: Question
    module: str
    due: int
    why: str | None = None

    def end(self, now: int, why: str) -> None:
        if self.why is None:
            self.due, self.why = now, why


def one_line(module: str, error: str | None) -> str:
    """What a module says that went wrong, as an error of an action."""
    words = " ".join((error or "").split())[:ERROR]
    return f"{module}: {words}" if words else f"{module} could not do it"
