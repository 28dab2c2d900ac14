"""The timeout of an application's current state: it counts, stands still, counts anew."""

from __future__ import annotations

from msgspec import Struct

from situ.decide.step import TIMEOUT, Step


class Clock(Struct):
    """length: of the whole timeout, in µs. due None: it stands still with ``remaining`` µs."""

    length: int
    remaining: int
    started: int
    cause: int | None
    due: int | None = None


class TimeoutState(Struct):
    """clock: None where the state has no timeout. token: of the timer that counts. held: since
    when (µs) the application is paused; its own time, in which the clock counts, stands still.
    """

    token: int = 0
    clock: Clock | None = None
    held: int | None = None


class Timeouts:
    """The clock of one application; ``owner`` stands in its timers."""

    def __init__(self, step: Step, owner: str) -> None:
        self.state = TimeoutState()
        self._step = step
        self._owner = owner

    @property
    def clock(self) -> Clock | None:
        return self.state.clock

    def is_live(self, token: int) -> bool:
        """Whether a timer of this token is that of the timeout now."""
        return token == self.state.token

    def begin(self, length: int, cause: int | None) -> None:
        """Begins to count ``length`` µs."""
        self.state.clock = Clock(length, length, self._step.now, cause)
        self._run()

    def become(self, length: int | None, cause: int, stands: bool) -> None:
        """Another version's: what counts goes on under the new ``length`` (µs), what is new
        counts from now. stands: whether it stands still.
        """
        clock = self.state.clock
        if length is None:
            self.leave()
        elif clock is None:
            self.begin(length, cause)
            if stands:
                self.stop()
        elif length != clock.length:
            longer, clock.length = length - clock.length, length
            if clock.due is None:
                clock.remaining = max(0, clock.remaining + longer)
            else:
                clock.remaining = max(0, clock.due + longer - self._now())
                self._run()

    def run_unless(self, idle: bool) -> None:
        """What stood still, because the state spoke, goes on where it no longer does so."""
        clock = self.state.clock
        if clock is not None and clock.due is None and not idle:
            self._run()

    def go_on(self, cause: int | None) -> None:
        """Counts what remained; ``cause`` now stands behind it."""
        clock = self.state.clock
        if clock is not None:
            clock.cause, clock.started = cause, self._step.now
            self._run()

    def restart(self) -> None:
        """Counts anew."""
        clock = self.state.clock
        assert clock is not None
        clock.remaining = clock.length
        clock.started = self._step.now
        self._run()

    def stop(self) -> None:
        """Stands still with what remains."""
        clock = self.state.clock
        self.state.token += 1
        if clock is not None and clock.due is not None:
            clock.remaining = clock.due - self._now()
            clock.due = None

    def hold(self) -> None:
        """The application's time stands still from now on; what begins meanwhile counts then."""
        if self.state.held is None:
            self.state.held = self._step.now
            self.state.token += 1

    def release(self) -> None:
        """The application's time goes on."""
        held, clock = self.state.held, self.state.clock
        assert held is not None
        self.state.held = None
        if clock is not None and clock.due is not None:
            clock.remaining = clock.due - held
            self._run()

    def leave(self) -> None:
        """The state that it belonged to is left."""
        self.state.token += 1
        self.state.clock = None

    def _run(self) -> None:
        clock = self.state.clock
        assert clock is not None
        self.state.token += 1
        clock.due = self._now() + clock.remaining
        if self.state.held is None:
            self._step.at(clock.due, TIMEOUT, self._owner, self.state.token, clock.started)

    def _now(self) -> int:
        held = self.state.held
        return self._step.now if held is None else held
