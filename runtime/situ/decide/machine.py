"""The behaviour execution of one application (seed 001, III; formats.md, *RBD*).

A state machine that knows no clock and no screen: events come in by ``raise_event``
and are judged one at a time when the robot says so.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec import UNSET, Struct, field

from situ.decide import trace
from situ.decide.actions import Actions, ActionsState
from situ.decide.program import Candidate, Program, StateProgram, shows_nothing
from situ.decide.screens import ScreenProgram, Shown
from situ.decide.step import TIMEOUT
from situ.decide.texts import heard_as, translator
from situ.decide.values import template
from situ.decide.world import World
from situ.document.rbd import AGAIN, BACK, Application, Component, Screen

Asked = Callable[[str, int], None]
"""Told that a module asks for something else than before, and the seq of that event."""

RESUMED = "resumed"
TIMED_OUT = "timeout"


class Raised(Struct):
    """An event that waits. own: raised by the application's own actions or timeout."""

    order: int
    name: str
    cause: int | None
    own: bool


class Clock(Struct):
    """The timeout of the current state. due None: it stands still with ``remaining`` µs."""

    remaining: int
    started: int
    cause: int | None
    due: int | None = None


class MachineState(Struct):
    """base: the state whose own screen is kept. shown: (base, with ``always``) that is
    on the screen by this application's command, None where nothing is. lacking: what was
    told to be missing on it. stale: keys of
    the unnamed events that may hold now, each with what caused that.
    """

    no: str = ""
    base: str | None = None
    shown: tuple[str | None, bool] | None = None
    components: list[Shown] = []
    background: str | None = None
    lacking: list[str] = []
    stack: list[str] = []
    queue: list[Raised] = []
    suspended: bool = False
    begun: bool = False
    granted: int | None = None
    clock: Clock | None = None
    token: int = 0
    stale: dict[int, int | None] = {}
    screen_stale: bool = False
    screen_cause: int | None = None
    actions: ActionsState = field(default_factory=ActionsState)


class Machine:
    """One application of a robot; ``asked`` grants authority anew for all of the robot."""

    def __init__(self, world: World, source: Application, number: int, asked: Asked) -> None:
        self.name = source.name
        self.state = MachineState()
        self._world = world
        self._asked = asked
        self._owner = f"application:{number}"
        self.program = Program(source, world.conditions, self._watch)
        self.actions = Actions(world, self.program, f"action:{number}", self._raise_own)
        self.actions.state = self.state.actions
        self._always = _screen(source.always.screen if source.always is not None else None)
        self._screens = {no: _screen(s.screen) for no, s in self.program.states.items()}
        self._tags: dict[tuple[str | None, bool] | None, set[str]] = {None: set()}
        every = [one for one in (self._always, *self._screens.values()) if one is not None]
        world.board.listen(
            sorted({"language", *(tag for one in every for tag in one.tags())}), self._written
        )

    def restore(self, state: MachineState) -> None:
        """Goes on from a state that was taken of the same application."""
        self.state = state
        self.actions.state = state.actions
        self.actions.suspended = state.suspended

    # -- what the robot asks -------------------------------------------------

    @property
    def here(self) -> StateProgram:
        return self.program.states[self.state.no]

    def missing(self) -> list[str]:
        """The resources that it asks for and does not hold, sorted."""
        request = self._world.priorities.request(self.name)
        if request is None:
            return []
        return [r for r in request.resources if not self._world.priorities.holds(self.name, r)]

    def may_resume(self) -> bool:
        return self.state.suspended and not self.missing()

    def earliest(self) -> int | None:
        """The order of the raised event that is next here; None where none is."""
        found = self._next()
        return None if found is None else found.order

    def phrases(self) -> list[str]:
        """What a person may say now."""
        return [text for text, _ in self._phrases()]

    def event_for(self, heard: str) -> str | None:
        """The event that an utterance means here."""
        for text, name in self._phrases():
            if heard_as(text) == heard_as(heard):
                return name
        return None

    def component(self, component_id: str) -> Component | None:
        """A component of the screen that this application shows now."""
        for screen in reversed(self._parts()):
            found = screen.component(component_id)
            if found is not None:
                return found
        return None

    def touched(self) -> str | None:
        """The event of a touch on no component of the screen shown."""
        return next((s.source.touched for s in self._parts() if s.source.touched), None)

    # -- events --------------------------------------------------------------

    def raise_event(self, name: str, cause: int | None, order: int) -> None:
        """An event from outside; ``order`` is shared by all applications it goes to."""
        self.state.queue.append(Raised(order, name, cause, own=False))

    def _raise_own(self, name: str, cause: int | None) -> None:
        self.state.queue.append(Raised(self._world.next_raise(), name, cause, own=True))

    def _next(self) -> Raised | None:
        for raised in self.state.queue:
            if not (self.state.suspended and raised.own):
                return raised
        return None

    def stay(self) -> None:
        """A livelock: what waits is dropped, and the state stays until something new comes."""
        self.state.queue.clear()
        self.state.stale.clear()

    def judge_event(self) -> None:
        """Takes the event that is next out of the queue and finishes it."""
        raised = self._next()
        if raised is None:
            return
        self.state.queue.remove(raised)
        seq = self._world.step.trace(trace.Event, raised.cause, self.name, raised.name)
        if self.state.suspended:
            self._world.step.trace(trace.Ignored, seq, self.name, raised.name, "suspended")
            return
        candidates = self.here.named.get(raised.name, ())
        taken = self._first(candidates)
        if taken is not None:
            self._take(taken, seq)
        else:
            reason = "guard" if candidates else "unexpected"
            self._world.step.trace(trace.Ignored, seq, self.name, raised.name, reason)
        self._settle_idle()

    def unnamed(self) -> Candidate | None:
        """The first unnamed event that holds now."""
        stale = self.state.stale
        if not stale or self.state.suspended:
            return None
        for one in self.here.unnamed:
            if one.key in stale:
                if self._passes(one):
                    return one
                del stale[one.key]
        return None

    def take_unnamed(self, taken: Candidate) -> None:
        if taken.next is not None:
            self._transition(taken.next, taken.actions, self.state.stale[taken.key], None)
            self._settle_idle()

    def _first(self, candidates: tuple[Candidate, ...] | list[Candidate]) -> Candidate | None:
        return next((one for one in candidates if self._passes(one)), None)

    def _passes(self, one: Candidate) -> bool:
        return (one.guard is None or one.guard()) and (one.next != BACK or bool(self.state.stack))

    def _take(self, taken: Candidate, cause: int) -> None:
        if taken.next is not None:
            self._transition(taken.next, taken.actions, cause, taken.name)
            return
        self.actions.begin(taken.actions, self.state.no, cause)

    def _watch(self, key: int, cause: int | None) -> None:
        """An unnamed event may have come to hold; those of other states do not matter."""
        if self.state.no and key in self.here.waits:
            self.state.stale[key] = cause

    def _watch_all(self, cause: int | None) -> None:
        self.state.stale = dict.fromkeys(self.here.waits, cause)

    # -- states --------------------------------------------------------------

    def start(self) -> None:
        """Time 0: enters the start state."""
        self._enter(self.program.start, None)
        self._settle_idle()

    def _transition(
        self, to: str, keys: list[int], cause: int | None, event: str | None, timeout: bool = False
    ) -> None:
        state, step = self.state, self._world.step
        source = state.no
        left = step.trace(trace.Exit, cause, self.name, source)
        self._stop_clock()
        self.actions.leave(left)
        if to == AGAIN:
            target = source
        elif to == BACK:
            target = state.stack.pop()
        else:
            target = to
            state.stack.append(source)
        seq = step.trace(
            trace.Transition, cause, self.name, source, target, event, True if timeout else UNSET
        )
        self.actions.begin(keys, target, seq)
        self._enter(target, seq)

    def _enter(self, no: str, cause: int | None) -> None:
        state = self.state
        state.no = no
        state.begun = False
        state.clock = None
        here = self.here
        if no == self.program.start:
            state.stack.clear()
        seq = self._world.step.trace(trace.Enter, cause, self.name, no)
        self._watch_all(seq)
        uses = set(here.uses)
        if self._display() is not None:
            uses.add("screen")
        asked = self._world.priorities.ask(self.name, tuple(uses), tuple(here.may_use - uses), seq)
        if asked is not None:
            self._asked(self.name, asked)
        missing = self.missing()
        if missing and not state.suspended:
            self._suspend(missing, asked if asked is not None else seq)
        self._publish(seq)
        if not state.suspended:
            self._begin(seq)

    def _begin(self, cause: int | None) -> None:
        """Screen, actions and timeout of the state begin."""
        state, here = self.state, self.here
        state.begun = True
        self.actions.suspended = False
        if here.screen is not None:
            state.base = None if shows_nothing(here.screen) else state.no
            self.actions.state.played.clear()
        if here.screen is not None or self._display() != state.shown:
            self._show(cause)
        # What an event began and what was held up while the state was entered suspended.
        self.actions.resume(cause)
        self.actions.begin(here.actions, state.no, cause, entry=True)
        if here.timeout is not None:
            state.clock = Clock(here.timeout, self._world.step.now, cause)
            self._run_clock()

    def _publish(self, cause: int | None) -> None:
        value = {
            "state": self.state.no,
            "name": self.here.source.name,
            "suspended": self.state.suspended,
        }
        self._world.keep_if_new(f"application/{self.name}", value, cause)

    # -- authority -----------------------------------------------------------

    def on_authority(self, changed: Mapping[str, int], cause: int | None) -> None:
        """Who holds what has changed: resource to the seq of its ``authority`` event. ``cause``
        changed it: what this application now asks for, if it misses nothing that it held.
        """
        state = self.state
        if not state.no:
            return
        missing = self.missing()
        for resource, seq in changed.items():
            if self._world.priorities.holds(self.name, resource):
                state.granted = seq
        if not state.suspended and missing:
            causes = [changed[r] for r in missing if r in changed]
            self._suspend(missing, causes[0] if causes else cause)
            return
        for resource, seq in changed.items():
            if not self._world.priorities.holds(self.name, resource):
                self.actions.lose(resource, seq)
        self._settle_idle()

    def _suspend(self, missing: list[str], cause: int | None) -> None:
        state = self.state
        state.suspended = True
        seq = self._world.step.trace(trace.Suspend, cause, self.name, tuple(missing))
        self._stop_clock()
        state.shown = None
        self.actions.suspend(seq)
        self._publish(seq)

    def resume(self) -> None:
        """It holds all that it asks for again: ``resumed`` first, then what was cut off."""
        state, step = self.state, self._world.step
        seq = step.trace(trace.Resume, state.granted, self.name, ())
        state.suspended = False
        self.actions.suspended = False
        self._publish(seq)
        event = step.trace(trace.Event, seq, self.name, RESUMED)
        taken = self._first(self.here.named.get(RESUMED, ()))
        if taken is not None and taken.next is not None:
            self._take(taken, event)
            self._settle_idle()
            return
        if taken is not None:
            self.actions.begin(taken.actions, self.state.no, event)
        self._watch_all(seq)
        if not state.begun:
            self._begin(seq)
        else:
            if self._display() is not None:
                self._show(seq)
            self.actions.resume(seq)
            if state.clock is not None:
                state.clock.cause, state.clock.started = seq, step.now
                self._run_clock()
        self._settle_idle()

    # -- the timeout ---------------------------------------------------------

    def due(self, token: int) -> None:
        """The timeout falls due."""
        state, here = self.state, self.here
        clock = state.clock
        if token != state.token or clock is None or clock.due is None:
            return
        if here.next is None:
            self._raise_own(TIMED_OUT, clock.cause)
        elif here.next != BACK or state.stack:
            self._transition(here.next, [], clock.cause, None, timeout=True)
            self._settle_idle()
            return
        else:
            self._world.step.trace(trace.Ignored, clock.cause, self.name, TIMED_OUT, "guard")
        self._restart_clock()

    def attend(self) -> None:
        """A person touched, typed or was heard: an ``idle`` timeout counts anew."""
        clock = self.state.clock
        if clock is None or not self.here.idle or self.state.suspended:
            return
        if clock.due is not None or not self.actions.speaking:
            self._restart_clock()

    def _settle_idle(self) -> None:
        """An ``idle`` timeout stands still while the state speaks and counts anew after it."""
        state = self.state
        if not state.no or state.clock is None or not self.here.idle or state.suspended:
            return
        if self.actions.speaking:
            self._stop_clock()
        elif state.clock.due is None:
            self._restart_clock()

    def _restart_clock(self) -> None:
        clock = self.state.clock
        if clock is not None and self.here.timeout is not None:
            clock.remaining = self.here.timeout
            clock.started = self._world.step.now
            self._run_clock()

    def _run_clock(self) -> None:
        clock = self.state.clock
        assert clock is not None
        self.state.token += 1
        clock.due = self._world.step.now + clock.remaining
        self._world.step.at(clock.due, TIMEOUT, self._owner, self.state.token, clock.started)

    def _stop_clock(self) -> None:
        clock = self.state.clock
        self.state.token += 1
        if clock is not None and clock.due is not None:
            clock.remaining = clock.due - self._world.step.now
            clock.due = None

    # -- actions that end ----------------------------------------------------

    def finish(
        self,
        action_id: int,
        ok: bool,
        result: object,
        error: str | None,
        status: int | None,
        cause: int | None,
    ) -> None:
        """The running action ``action_id`` ended."""
        self.actions.finish(action_id, ok, result, error, status, cause)
        self._settle_idle()

    # -- screen and phrases --------------------------------------------------

    def _display(self) -> tuple[str | None, bool] | None:
        """What this application has to show in its state: (state of the screen, always too).

        A state without a screen keeps what was shown: a screen that was never shown, its state
        having been left suspended, is not kept.
        """
        here = self.here
        base = self.state.base
        if here.screen is not None:
            base = None if shows_nothing(here.screen) else self.state.no
        shared = self._always is not None and here.source.always
        return None if base is None and not shared else (base, shared)

    def _parts(self) -> list[ScreenProgram]:
        if self.state.shown is None:
            return []
        base, shared = self.state.shown
        own = self._screens.get(base) if base is not None else None
        return [one for one in (own, self._always if shared else None) if one is not None]

    def _resolve(self, missing: list[str] | None) -> tuple[list[Shown], str | None]:
        board = self._world.board
        translate = translator(self._world.project, board)
        parts = self._parts()
        shown = [c.show(board, translate, missing) for part in parts for c in part.components]
        background = next((p.background for p in parts if p.background is not None), None)
        return shown, None if background is None else background.text(board.look)

    def _show(self, cause: int | None) -> None:
        state, world = self.state, self._world
        self.actions.end_movies(cause)
        state.shown = self._display()
        missing: list[str] = []
        state.components, state.background = self._resolve(missing)
        state.lacking = []
        self._warn(missing, cause)
        movies = [movie for part in self._parts() for movie in part.movies()]
        played = self.actions.state.played
        ids = [0 if movie.id in played else world.next_id() for movie in movies]
        seq = self._trace_screen(cause, tuple(ids))
        sources = {c["id"]: c["src"] for c in state.components if c["type"] == "movie"}
        self.actions.begin_movies(
            [(number, movie, sources[movie.id]) for number, movie in zip(ids, movies, strict=True)],
            state.no,
            seq,
        )

    def _trace_screen(self, cause: int | None, ids: tuple[int, ...]) -> int:
        state = self.state
        background = state.background
        state.screen_stale = False
        seq = self._world.step.trace(
            trace.Screen, cause, self.name, state.no, state.components,
            UNSET if background is None else background,
        )  # fmt: skip
        if state.shown is not None:
            value = {"components": state.components, "background": background}
            self._world.priorities.command(self.name, "screen", value, None, seq, ids)
        return seq

    def _warn(self, missing: list[str], cause: int | None) -> None:
        """Tells what the screen lacks, unless that was told when it was shown before."""
        state = self.state
        for sentence in dict.fromkeys(missing):
            if sentence not in state.lacking:
                self._world.step.warn(cause, sentence, f"{self.name}, state {state.no}")
        state.lacking = missing

    def refresh(self) -> None:
        """The end of a step: a live text that changed is shown once more."""
        state = self.state
        if not state.screen_stale:
            return
        state.screen_stale = False
        if state.shown is None:
            return
        missing: list[str] = []
        components, background = self._resolve(missing)
        if (components, background) == (state.components, state.background):
            return
        state.components, state.background = components, background
        self._warn(missing, state.screen_cause)
        ids = tuple(r.id for r in self.actions.state.running.values() if r.action == "movie")
        self._trace_screen(state.screen_cause, ids)

    def _written(self, tag: str, cause: int | None) -> None:
        shown = self.state.shown
        if shown is None:
            return
        tags = self._tags.get(shown)
        if tags is None:
            tags = self._tags[shown] = {"language", *(t for p in self._parts() for t in p.tags())}
        if tag in tags:
            self.state.screen_stale = True
            self.state.screen_cause = cause

    def _phrases(self) -> list[tuple[str, str]]:
        state = self.state
        if state.suspended or not state.begun or not self.here.heard or not self.actions.hears():
            return []
        board = self._world.board
        translate = translator(self._world.project, board)
        return [
            (template(translate(phrase, None)).text(board.look), candidate.name)
            for candidate in self.here.heard
            for phrase in candidate.says
            if candidate.name is not None
        ]


def _screen(source: Screen | None) -> ScreenProgram | None:
    return None if source is None or shows_nothing(source) else ScreenProgram(source)
