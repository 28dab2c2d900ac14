"""Who a client is, and one request of his with what comes of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, TypeVar

from msgspec import Struct

from situ.blackboard import protocol, replies
from situ.blackboard.protocol import Request
from situ.errors import BlackboardError, Refused

T = TypeVar("T")


class Person(Struct, frozen=True, kw_only=True):
    """Who a client is; as in ``protocol.Hello``."""

    role: protocol.Role
    module: str | None = None
    user: str | None = None
    resources: tuple[str, ...] = ()
    description: str = ""
    requires: tuple[protocol.Need, ...] = ()
    provides: tuple[protocol.Offer, ...] = ()
    services: tuple[str, ...] = ()


class Call(Generic[T]):
    """One request and, later, what came of it.

    body: the bytes it was last sent as. again: whether it may be asked once more when the
    connection was lost before an answer came, because twice is as good as once. otherwise: where
    it is meant for the robot as it is now alone, what it fails with when that is lost; not set,
    it waits for the next one.
    """

    def __init__(self, request: Request, read: Callable[[Any], T], again: bool) -> None:
        self.request = request
        self.again = again
        self.finished = False
        self.body = b""
        self.otherwise: BlackboardError | None = None
        self.error: BlackboardError | None = None
        self._then: Callable[[], None] | None = None
        self._read = read
        self._value: T | None = None

    def result(self) -> T:
        """Raises what went wrong: ``Refused``, or ``Unreachable`` where nobody answered."""
        if self.error is not None:
            raise self.error
        assert self.finished, "not answered yet"
        return self._value  # type: ignore[return-value]

    def then(self, callback: Callable[[], None]) -> None:
        """Calls it once when this is finished; at once if it is."""
        if self.finished:
            callback()
        else:
            self._then = callback

    def answer(self, reply: replies.AnyReply) -> None:
        if isinstance(reply, replies.Refused):
            self.fail(Refused(reply.message))
            return
        if type(reply) is not replies.REPLIES[type(self.request)]:
            self.fail(BlackboardError(f"the blackboard answered with {type(reply).__name__}"))
            return
        self._value = self._read(reply)
        self._end()

    def fail(self, error: BlackboardError) -> None:
        self.error = error
        self._end()

    def drop(self) -> None:
        """Ends it without a value and without an error."""
        self._end()

    def _end(self) -> None:
        if not self.finished:
            self.finished = True
            if self._then is not None:
                self._then()


def which(resources: tuple[str, ...], named: str | None) -> str:
    """The resource that a command is for, where only one can be meant."""
    if named is not None:
        return named
    if len(resources) != 1:
        raise BlackboardError(f"say which resource the command is for: {', '.join(resources)}")
    return resources[0]
