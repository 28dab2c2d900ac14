"""A scenario fed into a live robot through the real sockets (``situ run --script``).

The scenario is a client of the blackboard like any other, but it brings the time: each
line is sent with its own, so that what follows is the same, to the microsecond, as in
the simulator. Real time only paces it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence

from situ.blackboard import protocol
from situ.blackboard.client import AsyncBoard
from situ.decide import inputs
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent
from situ.engine.live import Live
from situ.errors import Refused
from situ.rehearse.expect import Expect, Expectations
from situ.rehearse.scenario import End, Line


class Script:
    """Plays ``lines``; ``verdict`` tells what failed. ``speed``: scenario's seconds in a real one.

    ``heard`` must be told all trace events of the robot it plays to.
    """

    def __init__(self, lines: Sequence[Line], speed: float = 1.0) -> None:
        self.verdict = Expectations()
        self._lines = lines
        expected = (line.at for line in lines if isinstance(line.does, Expect))
        self._last_expected = max(expected, default=-1)
        self._speed = speed

    def heard(self, events: list[TraceEvent], _: float) -> None:
        # What no line looks for any more is not kept: a run may last for days.
        self.verdict.add(
            [event for event in events if round(event.t * SECOND) <= self._last_expected]
        )

    async def play(self, live: Live, board: AsyncBoard) -> None:
        """Plays to the end. ``board`` has the role ``scenario``, ``live`` is scripted."""
        loop = asyncio.get_running_loop()
        begin = loop.time()

        async def until(moment: int) -> None:
            await asyncio.sleep(begin + moment / SECOND / self._speed - loop.time())

        for line in self._lines:
            if line.at > live.moment:
                # The moment before is over: nothing more can come to it.
                self.verdict.judge()
            while (due := live.due()) is not None and due < line.at:
                await until(due)
                live.move(due)
            await until(line.at)
            await self._send(board, line)
            if isinstance(line.does, Expect):
                self.verdict.expect(line.number, line.at, line.does)
        self.verdict.judge()

    async def _send(self, board: AsyncBoard, line: Line) -> None:
        try:
            await board.give(lambda number: request(line, number))
        except Refused:
            # As in the simulator: the trace says so, and the scenario goes on.
            return


def request(line: Line, number: int) -> protocol.Request:
    """The request that a line is sent as; one that only lets time pass is a heartbeat."""
    return _REQUESTS[type(line.does)](number, line.at, line.does)


def _wait(number: int, at: int, _: Expect | End) -> protocol.Request:
    return protocol.Heartbeat(id=number, at=at)


def _set(number: int, at: int, does: inputs.Set) -> protocol.Request:
    return protocol.Set(id=number, at=at, tags=does.tags)


def _publish(number: int, at: int, does: inputs.Raise) -> protocol.Request:
    return protocol.Publish(id=number, at=at, event=does.event, application=does.application)


def _touch(number: int, at: int, does: inputs.Touch) -> protocol.Request:
    return protocol.Touch(id=number, at=at)


def _use(number: int, at: int, does: inputs.Use) -> protocol.Request:
    return protocol.Use(id=number, at=at, component=does.component, value=does.value)


def _acquire(number: int, at: int, does: inputs.Acquire) -> protocol.Request:
    return protocol.Acquire(
        id=number,
        at=at,
        module=does.module,
        resources=does.resources,
        optional=does.optional,
    )


def _abandon(number: int, at: int, does: inputs.Abandon) -> protocol.Request:
    return protocol.Abandon(id=number, at=at, module=does.module, resources=does.resources)


def _command(number: int, at: int, does: inputs.Command) -> protocol.Request:
    return protocol.Command(
        id=number,
        at=at,
        module=does.module,
        resource=does.resource,
        value=does.value,
        valid=does.valid,
    )


def _lost(number: int, at: int, does: inputs.Lost) -> protocol.Request:
    return protocol.Bye(id=number, at=at, module=does.module)


def _finish(number: int, at: int, does: inputs.Finish) -> protocol.Request:
    return protocol.Finish(
        id=number,
        at=at,
        action=does.action,
        name=does.name,
        application=does.application,
        ok=does.ok,
        result=does.result,
        error=does.error,
        status=does.status,
    )


_REQUESTS: dict[type, Callable[..., protocol.Request]] = {
    Expect: _wait,
    End: _wait,
    inputs.Set: _set,
    inputs.Raise: _publish,
    inputs.Touch: _touch,
    inputs.Use: _use,
    inputs.Acquire: _acquire,
    inputs.Abandon: _abandon,
    inputs.Command: _command,
    inputs.Lost: _lost,
    inputs.Finish: _finish,
}
