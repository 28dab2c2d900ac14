"""What applications ask of this module (``service url="board:MODULE/…"``), at the client."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from situ.blackboard import protocol, replies
from situ.blackboard.calls import Call
from situ.blackboard.feeds import Feed
from situ.errors import Unreachable

Send = Callable[[Callable[[int], protocol.Answer]], Call[Any] | None]
"""Sends an answer, made with the id that it must carry; None where there is no connection."""

Enter = Callable[[Callable[[], None]], None]
"""Does something with the client, in whatever thread it is asked."""


class ServiceRequest:
    """One request; answered once, by ``answer`` or ``fail``, what comes after it is passed over.

    request: its name. params: as the application sent them. application: who asks.
    """

    def __init__(self, question: replies.Question, requests: Requests) -> None:
        self.request = question.request
        self.params = question.params
        self.application = question.application
        self.withdrawn: Callable[[], object] | None = None
        self._id = question.id
        self._requests = requests
        self._cancelled = False
        # What was answered, and the call with which it was sent, if it was.
        self._given: _Given | None = None
        self._call: Call[Any] | None = None

    @property
    def cancelled(self) -> bool:
        """Whether nobody waits for the answer any more: the state was left, or time is up."""
        return self._cancelled

    def answer(self, result: Any = None) -> None:
        """It was done; result: a JSON value, which the application's ``result`` reach into."""
        self._requests.give(self, _Given(True, result, None))

    def fail(self, error: str) -> None:
        """It could not be done; error: why, in words."""
        self._requests.give(self, _Given(False, None, error))

    def __repr__(self) -> str:
        return f"<ServiceRequest {self.request} of {self.application}>"


class _Given:
    def __init__(self, ok: bool, result: Any, error: str | None) -> None:
        self.ok, self.result, self.error = ok, result, error


class Requests(Feed[ServiceRequest]):
    """The requests of these names, until taken; each once, whatever gets lost on the way."""

    def __init__(
        self,
        names: tuple[str, ...],
        callback: Callable[[ServiceRequest], None] | None,
        send: Send,
        enter: Enter,
    ) -> None:
        super().__init__(callback)
        self.names = names
        self._send = send
        self._enter = enter
        self._open: dict[int, ServiceRequest] = {}
        self._count = self._latest = 0

    def __repr__(self) -> str:
        return f"<Requests {', '.join(self.names)}, {len(self)} to be taken>"

    def give(self, request: ServiceRequest, given: _Given) -> None:
        """For a request's user, in any thread."""

        def do() -> None:
            if request._given is None:
                request._given = given
                self._tell(request)

        self._enter(do)

    # -- for the dialog ------------------------------------------------------

    def hear(self, count: int) -> bool:
        """How often what is asked has changed; False where that is not known here yet."""
        self._latest = max(self._latest, count)
        return not self.ready or self._latest <= self._count

    def lost(self) -> None:
        """The connection is; a core that comes back counts anew."""
        self._latest = 0

    def restart(self) -> None:
        """The core was started anew: nobody waits for any answer."""
        for number in list(self._open):
            self._withdraw(number)

    def stands(self, reply: replies.Questions) -> bool:
        """All that is asked now. False where more has changed meanwhile."""
        self.asking, self.ready = False, True
        self._count = reply.count
        mine = {q.id: q for q in reply.questions if q.request in self.names}
        for number in self._open.keys() - mine.keys():
            self._withdraw(number)
        for number, question in mine.items():
            before = self._open.get(number)
            if before is None:
                request = self._open[number] = ServiceRequest(question, self)
                self._queue.append(request)
            elif before._given is not None and (before._call is None or before._call.finished):
                # The core does not know of it: it was lost on the way.
                self._tell(before)
        return self._latest <= self._count

    def _withdraw(self, number: int) -> None:
        request = self._open.pop(number)
        if request in self._queue:
            self._queue.remove(request)
        request._cancelled = request._given is None
        if request._cancelled and request.withdrawn is not None:
            request.withdrawn()

    def _tell(self, request: ServiceRequest) -> None:
        given = request._given
        if given is None or self._open.get(request._id) is not request:
            return
        request._call = call = self._send(
            lambda number: protocol.Answer(
                id=number, asked=request._id, ok=given.ok, result=given.result, error=given.error
            )
        )
        if call is not None:
            call.then(lambda: self._told(request, call))

    def _told(self, request: ServiceRequest, call: Call[Any]) -> None:
        given = request._given
        if call.error is None or isinstance(call.error, Unreachable):
            return
        if given is not None and given.ok:
            # What is no JSON value can not be sent, but that can.
            request._given = _Given(False, None, f"what it answered is {call.error}")
            self._tell(request)
