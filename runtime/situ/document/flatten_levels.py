"""The states that are active together: one of a file, one of the part that it runs, and so on."""

from __future__ import annotations

from typing import NamedTuple

from situ.document.rbd import AGAIN, BACK, Application, Event, State, Timeout


class Level(NamedTuple):
    file: Application
    state: State
    prefix: str

    @property
    def path(self) -> str:
        return self.prefix + self.state.no

    @property
    def events(self) -> tuple[Event, ...]:
        """Its own, then those of its file's ``always``."""
        always = self.file.always_in(self.state)
        return self.state.events if always is None else (*self.state.events, *always.events)

    @property
    def timeouts(self) -> tuple[Timeout, ...]:
        always = self.file.always_in(self.state)
        every = (self.state.timeout, always.timeout if always is not None else None)
        return tuple(one for one in every if one is not None)

    def named(self, name: str) -> list[Event]:
        return [event for event in self.events if event.name == name]

    @property
    def goes_back(self) -> bool:
        targets = [*(e.next for e in self.events), *(t.next for t in self.timeouts)]
        return BACK in targets


Levels = tuple[Level, ...]
"""The outermost first."""


def serving(levels: Levels) -> tuple[int, Timeout] | None:
    """The timeout that serves, and its level. A state that holds a part has none of its own,
    only its file's ``always``.
    """
    for level, one in reversed(tuple(enumerate(levels))):
        for timeout in one.timeouts:
            return level, timeout
    return None


def states_meant(here: Level, targets: set[str | None]) -> set[str]:
    if BACK in targets:
        return {state.no for state in here.file.states}
    return {here.state.no if to == AGAIN else to for to in targets if to is not None}
