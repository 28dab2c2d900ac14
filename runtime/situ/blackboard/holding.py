"""What one client asks for and holds of the robot, as its ``dialog`` hears it."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from situ.blackboard import notices, protocol, replies, topics
from situ.blackboard.calls import Call, Person
from situ.blackboard.subscriptions import Talk


class Holding:
    """holds: the resources that the client's module has, as last heard.

    subscribe: is given the topics to hear of it; changed: is called when ``holds`` changes.
    """

    def __init__(
        self,
        talk: Talk,
        person: Person,
        subscribe: Callable[[tuple[bytes, bool]], None],
        changed: Callable[[], None],
    ) -> None:
        self.holds: frozenset[str] = frozenset()
        self._talk = talk
        self._person = person
        self._subscribe = subscribe
        self._changed = changed
        self._seq = 0
        self._asked: dict[object, tuple[tuple[str, ...], tuple[str, ...]]] = {}
        for resource in person.resources:
            subscribe((topics.authority(resource), True))

    # -- for the dialog ------------------------------------------------------

    def hear(self, notice: notices.Authority) -> None:
        """A resource has passed on."""
        if notice.seq > self._seq:
            passed = {notice.resource}
            mine = notice.to is not None and notice.to == self._person.module
            self._hold(self.holds | passed if mine else self.holds - passed, notice.seq)

    def stands(self, holds: Iterable[str], seq: int) -> None:
        """All that is held, as the core told it at ``seq``."""
        if seq >= self._seq:
            self._hold(frozenset(holds), seq)

    def lost(self) -> None:
        """Without a connection nothing is held."""
        self._hold(frozenset(), 0)

    def renewed(self) -> None:
        """The session is another: asks anew for all that was asked for."""
        self.lost()
        if self._asked:
            self._acquire(again=False)

    # -- for its user --------------------------------------------------------

    def acquire(
        self, key: object, resources: tuple[str, ...], optional: tuple[str, ...] = ()
    ) -> Call[None]:
        """Asks for what ``key`` wants beside all that other keys ask for."""
        for resource in (*resources, *optional):
            if resource not in self._person.resources:
                self._subscribe((topics.authority(resource), True))
        self._asked[key] = (resources, optional)
        return self._acquire(again=True)

    def withdraw(self, key: object) -> None:
        """What ``key`` asked for was refused."""
        self._asked.pop(key, None)

    def abandon(self, key: object) -> Call[None]:
        """Gives back what only ``key`` asked for."""
        gone = self._asked.pop(key, ((), ()))
        if not self._asked:
            request = protocol.Abandon(id=self._talk.next_id())
            return self._talk.ask(request, self._granted, again=True)
        kept = {r for one in self._asked.values() for r in (*one[0], *one[1])}
        given_back = tuple(r for r in (*gone[0], *gone[1]) if r not in kept)
        if not given_back:
            return self._acquire(again=True)
        request = protocol.Abandon(id=self._talk.next_id(), resources=given_back)
        return self._talk.ask(request, self._granted, again=True)

    def _acquire(self, again: bool) -> Call[None]:
        wanted = dict.fromkeys(r for one in self._asked.values() for r in one[0])
        able = dict.fromkeys(r for one in self._asked.values() for r in one[1] if r not in wanted)
        number = self._talk.next_id()
        request = protocol.Acquire(id=number, resources=tuple(wanted), optional=tuple(able))
        return self._talk.ask(request, self._granted, again)

    def _granted(self, granted: replies.Granted) -> None:
        self.stands(granted.holds, granted.seq)

    def _hold(self, holds: frozenset[str], seq: int) -> None:
        self._seq = seq
        if holds != self.holds:
            self.holds = holds
            self._changed()
