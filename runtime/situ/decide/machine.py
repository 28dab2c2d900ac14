"""The behaviour execution of one application (seed 001, III; formats.md, *RBD*).

A state machine that knows no clock and no screen: events come in by ``raise_event``
and are judged one at a time when the robot says so. Where it runs parts, several states are
active together, one inside the other; it stands in the innermost, which knows the others.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from msgspec import UNSET, Struct, UnsetType, field

from situ.decide import trace
from situ.decide.actions import Actions, ActionsState
from situ.decide.board import Entry
from situ.decide.display import Display, DisplayState
from situ.decide.effects import Changed
from situ.decide.priorities import RUNTIME
from situ.decide.program import Candidate, Program
from situ.decide.timeouts import Timeouts, TimeoutState
from situ.decide.way import Way, find, published
from situ.decide.world import World
from situ.document.rbd import AGAIN, BACK, RESUMED, TIMED_OUT, Application

Asked = Callable[[str, int], None]
"""Told that a module asks for something else than before, and the seq of that event."""

DONE = "done"
DEEPEST = 1_000
"""States that ``#back`` finds again; older ones are forgotten, for a robot may run for years."""


class Raised(Struct):
    """An event that waits. own: raised by the application's own actions, parts or timeout.

    holder: the path of the only state that may take it, that whose part has ended; or None.
    writer: the operator who raised it.
    """

    order: int
    name: str
    cause: int | None
    own: bool
    holder: str | None = None
    writer: str | UnsetType = UNSET


class MachineState(Struct):
    """no: the path of the innermost state. stacks: by level, the states to go back to.
    entered: the outermost level of the states entered last. stale: keys of the unnamed events
    that may hold now, each with what caused that.
    """

    no: str = ""
    entered: int = 0
    stacks: list[list[str]] = []
    queue: list[Raised] = []
    suspended: bool = False
    begun: bool = False
    granted: int | None = None
    stale: dict[int, int | None] = {}
    timeout: TimeoutState = field(default_factory=TimeoutState)
    display: DisplayState = field(default_factory=DisplayState)
    actions: ActionsState = field(default_factory=ActionsState)


class Machine:
    """One application of a robot; ``asked`` grants authority anew for all of the robot."""

    def __init__(self, world: World, source: Application, number: int, asked: Asked) -> None:
        self.name = source.name
        self._world = world
        self._step = world.step
        self._asked = asked
        self._tag = f"application/{source.name}"
        self.program = Program(source, world.conditions, self._watch, world.project.flow)
        self.actions = Actions(world, self.program, f"action:{number}", self._raise_own)
        self.timeouts = Timeouts(world.step, f"application:{number}")
        self.display = Display(world, self.program, self.actions)
        looks = {tag for one in self.program.states.values() for tag in one.looks}
        world.board.listen(sorted(looks), self._written)
        self.restore(MachineState())

    def restore(self, state: MachineState) -> None:
        """Goes on from a state that was taken of the same application."""
        self.state = state
        states = self.program.states
        self.here = states.get(state.no, states[self.program.start])
        self.timeouts.state = state.timeout
        self.display.state = state.display
        self.actions.state = state.actions
        self.actions.suspended = state.suspended or self.paused

    # -- what the robot asks -------------------------------------------------

    @property
    def paused(self) -> bool:
        """Whether the debugger holds it."""
        return self.state.timeout.held is not None

    def missing(self) -> list[str]:
        """The resources that it asks for and does not hold, sorted."""
        request = self._world.priorities.request(self.name)
        if request is None:
            return []
        return [r for r in request.resources if not self._world.priorities.holds(self.name, r)]

    def may_resume(self) -> bool:
        return self.state.suspended and not self.missing()

    def earliest(self) -> Raised | None:
        """The raised event that is next here; None where none is."""
        for raised in self.state.queue:
            if not (self.state.suspended and raised.own):
                return raised
        return None

    def refresh(self) -> None:
        """The end of a step: a live text that changed is shown once more."""
        self.display.refresh(self.here)

    # -- events --------------------------------------------------------------

    def raise_event(
        self, name: str, cause: int | None, order: int, writer: str | UnsetType = UNSET
    ) -> None:
        """An event from outside; ``order`` is shared by all applications it goes to."""
        self.state.queue.append(Raised(order, name, cause, own=False, writer=writer))

    def _raise_own(self, name: str, cause: int | None, holder: str | None = None) -> None:
        raised = Raised(self._world.next_raise(), name, cause, own=True, holder=holder)
        self.state.queue.append(raised)

    def stay(self) -> None:
        """A livelock: what waits is dropped, and the state stays until something new comes."""
        self.state.queue.clear()
        self.state.stale.clear()

    def judge_event(self, raised: Raised) -> None:
        """Takes the event, which is next, out of the queue and finishes it."""
        self.state.queue.remove(raised)
        self.judge(raised.name, raised.cause, raised.holder, raised.writer)

    def judge(
        self,
        name: str,
        cause: int | None,
        holder: str | None = None,
        writer: str | UnsetType = UNSET,
    ) -> None:
        """The turn of an event has come; what else may follow is the robot's to see."""
        step = self._step
        step.seq = seq = step.seq + 1
        step.events.append(trace.Event(seq, step.seconds, cause, self.name, name, writer))
        here = self.here
        if self.state.suspended:
            step.trace(trace.Ignored, seq, self.name, name, "suspended")
            return
        if holder is None:
            self._offer(name, here.named.get(name, ()), seq)
        else:
            self._judge_done(name, holder, seq)
        if here.idle or self.here.idle:
            self._settle_idle()

    def _offer(self, name: str, candidates: Sequence[Candidate], seq: int) -> None:
        for one in candidates:
            guard = one.guard
            if (guard is None or guard()) and (not one.back or self.state.stacks[one.level]):
                self._take(one, seq)
                return
        reason = "guard" if candidates else "unexpected"
        self._step.trace(trace.Ignored, seq, self.name, name, reason)

    def _judge_done(self, name: str, holder: str, seq: int) -> None:
        """A part has ended: ``done.x``, or else ``done``, for the state that holds it alone."""
        taken = self.first(self.of_holder(name, holder))
        if taken is not None:
            self._take(taken, seq)
            return
        second = self._step.trace(trace.Event, seq, self.name, DONE)
        self._offer(DONE, self.of_holder(DONE, holder), second)

    def of_holder(self, name: str, holder: str) -> list[Candidate]:
        """The expected events of this name that the state ``holder`` has of its own."""
        level = next((n for n, one in enumerate(self.here.levels) if one.path == holder), None)
        return [one for one in self.here.named.get(name, ()) if one.level == level]

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
        self._take(taken, self.state.stale[taken.key])
        self._settle_idle()

    def first(self, candidates: Sequence[Candidate]) -> Candidate | None:
        """The one that would be taken now."""
        for one in candidates:
            if self._passes(one):
                return one
        return None

    def _passes(self, one: Candidate) -> bool:
        guard = one.guard
        return (guard is None or guard()) and (not one.back or bool(self.state.stacks[one.level]))

    def _take(self, taken: Candidate, cause: int | None) -> None:
        if taken.next is None:
            self.actions.begin(taken.actions, self.state.no, cause)
            return
        here, state, actions = self.here, self.state, self.state.actions
        # With nothing to be cancelled, and all that the state has to show shown.
        if state.begun and not actions.runs and not actions.running:
            try:
                way = here.ways[taken.key]
            except KeyError:
                way = here.ways[taken.key] = find(self.program, self.actions, here, taken)
            if way is not None:
                self._go(way, cause)
                return
        self._move(taken.next, taken.level, taken.actions, cause, taken.name, UNSET)

    def _watch(self, key: int, cause: int | None) -> None:
        """An unnamed event may have come to hold by time; those of other states do not matter."""
        if self.state.no and key in self.here.waits:
            self.state.stale[key] = cause

    def _written(self, tag: str, cause: int | None) -> None:
        """A tag was written that unnamed events, of this state perhaps, look at."""
        if self.state.no:
            for key in self.here.looks.get(tag, ()):
                self.state.stale[key] = cause

    def _watch_all(self, cause: int | None) -> None:
        self.state.stale = dict.fromkeys(self.here.waits, cause)

    # -- states --------------------------------------------------------------

    def start(self, cause: int | None = None) -> None:
        """At time 0, or where a new version lets it: enters the start state."""
        self._enter(self.program.start, 0, cause)
        self._settle_idle()

    def leave(self, level: int, cause: int | None) -> None:
        """Leaves the state of ``level`` with all inside it."""
        self.timeouts.leave()
        # What runs belongs to the innermost state, which is left in any case.
        self.actions.leave(self._step.trace(trace.Exit, cause, self.name, self.state.no))
        levels = self.here.levels
        if len(levels) > 1:
            for outer in reversed(levels[level:-1]):
                self._step.trace(trace.Exit, cause, self.name, outer.path)

    def _move(
        self,
        to: str,
        level: int,
        keys: list[int],
        cause: int | None,
        event: str | None,
        timeout: bool | UnsetType,
        writer: str | UnsetType = UNSET,
    ) -> None:
        """Leaves the state of ``level`` with all inside it for another of the same file."""
        step, levels = self._step, self.here.levels
        self.leave(level, cause)
        source, target = self.leads(to, level)
        if to == BACK:
            self.state.stacks[level].pop()
        elif to != AGAIN and self.program.goes_back:
            _remember(self.state.stacks[level], levels[level].no)
        seq = step.trace(trace.Transition, cause, self.name, source, target, event, timeout, writer)
        if keys:
            self.actions.begin(keys, self.program.innermost[target], seq)
        self._enter(target, level, seq)

    def leads(self, to: str, level: int) -> tuple[str, str]:
        """The paths of the state of ``level`` and of that to which ``to`` leads from it."""
        source = self.here.levels[level]
        if to == AGAIN:
            to = source.no
        elif to == BACK:
            to = self.state.stacks[level][-1]
        return source.path, source.prefix + to

    def _go(self, way: Way, cause: int | None) -> None:
        """``_move`` on a short way."""
        step, state, target, name = self._step, self.state, way.target, self.name
        if state.timeout.clock is not None:
            self.timeouts.leave()
        seq, seconds, no = step.seq, step.seconds, target.no
        step.seq = moved = seq + 2
        step.events += (
            trace.Exit(seq + 1, seconds, cause, name, way.source),
            trace.Transition(moved, seconds, cause, name, way.source, no, way.event),
        )
        for perform in way.leaving:
            perform(no, moved)
        if way.starts:
            state.stacks[0].clear()
        elif way.back:
            _remember(state.stacks[0], way.source)
        state.no, state.entered = no, 0
        self.here = target
        step.seq = seq = step.seq + 1
        step.events.append(trace.Enter(seq, seconds, moved, name, no))
        if target.waits or state.stale:
            self._watch_all(seq)
        if not way.stays:
            tag, value, board, now = self._tag, way.published, self._world.board, step.now
            version = board.state[tag].version + 1
            board.state[tag] = Entry(value, version, RUNTIME, now, seq)
            step.effects.append(Changed(tag, value, version, RUNTIME, now))
            if tag in board.listeners:
                board.tell(tag, seq)
        for perform in way.entering:
            perform(no, seq)
        if target.timeout is not None:
            self.timeouts.begin(target.timeout, seq)

    def _enter(self, path: str, level: int, cause: int | None) -> None:
        """Enters a state of ``level``, and the start of the part that it runs, if any."""
        state = self.state
        state.no = self.program.innermost[path]
        state.entered = level
        state.begun = False
        self.here = here = self.program.states[state.no]
        del state.stacks[level + 1 :]
        for one in here.levels[level:]:
            if len(state.stacks) == level:
                state.stacks.append([])
            elif one.path == one.start:
                state.stacks[level].clear()
            level += 1
            cause = self._step.trace(trace.Enter, cause, self.name, one.path)
        seq = cause
        self._watch_all(seq)
        asked = self.ask(seq)
        if asked is not None:
            self._asked(self.name, asked)
        missing = self.missing()
        if missing and not state.suspended:
            self._suspend(missing, asked if asked is not None else seq)
        self._publish(seq)
        if not state.suspended:
            self._begin(seq)

    def ask(self, cause: int | None) -> int | None:
        """Asks for what the state uses; the seq of the event where that is something else."""
        uses = set(self.here.uses)
        if self.display.wanted(self.here) is not None:
            uses.add("screen")
        able = tuple(self.here.may_use - uses)
        return self._world.priorities.ask(self.name, tuple(uses), able, cause)

    def _begin(self, cause: int | None) -> None:
        """Screen, actions and timeout of the state begin."""
        state, here = self.state, self.here
        state.begun = True
        self.actions.suspended = False
        self.display.begin(here, cause)
        # What an event began and what was held up while the state was entered suspended.
        self.actions.resume(cause)
        self.actions.begin(self.entry(), state.no, cause, entry=True)
        if here.timeout is not None:
            self.timeouts.begin(here.timeout, cause)

    def entry(self) -> list[int]:
        """The actions of the state, and what tells of the parts that it ends, innermost first."""
        here = self.here
        if len(here.levels) == 1:
            return here.actions
        entered = reversed(here.ended[self.state.entered :])
        return [*here.actions, *(key for key in entered if key is not None)]

    def _publish(self, cause: int | None) -> None:
        self._world.keep_if_new(self._tag, published(self.here, self.state.suspended), cause)

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
        seq = self._step.trace(trace.Suspend, cause, self.name, tuple(missing))
        self.timeouts.stop()
        self.display.lose()
        self.actions.suspend(seq)
        self._publish(seq)

    def resume(self) -> None:
        """It holds all that it asks for again: ``resumed`` first, then what was cut off."""
        state, step = self.state, self._step
        seq = step.trace(trace.Resume, state.granted, self.name, ())
        state.suspended = False
        self.actions.suspended = False
        self._publish(seq)
        event = step.trace(trace.Event, seq, self.name, RESUMED)
        taken = self.first(self.here.named.get(RESUMED, ()))
        if taken is not None and taken.next is not None:
            # The screen is not shown again yet: no short way leads on from here.
            self._move(taken.next, taken.level, taken.actions, event, taken.name, UNSET)
            self._settle_idle()
            return
        if taken is not None:
            self.actions.begin(taken.actions, self.state.no, event)
        self._watch_all(seq)
        if not state.begun:
            self._begin(seq)
        else:
            self.display.resume(self.here, seq)
            self.actions.resume(seq)
            self.timeouts.go_on(seq)
        self._settle_idle()

    # -- another version ------------------------------------------------------

    def go_on(self, shows: bool, asked: int | None, cause: int) -> None:
        """In the same state of another version. shows: whether it has another screen; asked: the
        seq of what it asked for now.
        """
        state, here = self.state, self.here
        missing = self.missing()
        if missing and not state.suspended:
            self._suspend(missing, cause if asked is None else asked)
        elif asked is not None and not missing:
            state.granted = asked
        self._publish(cause)
        if shows and not state.suspended:
            self.display.show(here, cause)
        self.timeouts.become(here.timeout, cause, stands=state.suspended)
        if not state.suspended:
            if not self.paused:
                self.actions.release(cause)
            self.timeouts.run_unless(here.idle)
        self._settle_idle()

    def warn(self, cause: int | None, message: str) -> None:
        """Warns of it in its own name."""
        self._step.warn(cause, message, self.name)

    # -- the timeout ---------------------------------------------------------

    def due(self) -> None:
        """The timeout falls due."""
        here, clock = self.here, self.timeouts.clock
        assert clock is not None
        if here.next is None:
            self._raise_own(TIMED_OUT, clock.cause)
        elif here.next != BACK or self.state.stacks[here.timeout_level]:
            self._move(here.next, here.timeout_level, [], clock.cause, None, True)
            self._settle_idle()
            return
        else:
            self._step.trace(trace.Ignored, clock.cause, self.name, TIMED_OUT, "guard")
        self.timeouts.restart()

    def attend(self) -> None:
        """A person touched, typed or was heard: an ``idle`` timeout counts anew."""
        clock = self.timeouts.clock
        if clock is None or not self.here.idle or self.state.suspended:
            return
        if clock.due is not None or not self.actions.speaking:
            self.timeouts.restart()

    def _settle_idle(self) -> None:
        """An ``idle`` timeout stands still while the state speaks and counts anew after it."""
        state = self.state
        clock = state.timeout.clock
        if clock is None or not state.no or not self.here.idle or state.suspended:
            return
        if self.actions.speaking:
            self.timeouts.stop()
        elif clock.due is None:
            self.timeouts.restart()

    # -- the debugger ---------------------------------------------------------

    def hold(self) -> None:
        """Its timeout stands still, and nothing new of its actions begins."""
        self.timeouts.hold()
        self.actions.suspended = True

    def release(self, cause: int | None) -> None:
        """Its timeout counts on, and what came to its turn meanwhile begins."""
        self.timeouts.release()
        if not self.state.suspended:
            self.actions.release(cause)
            self._settle_idle()

    def go_to(self, path: str, writer: str) -> None:
        """Leaves the state for another, which an operator names."""
        levels = self.here.levels
        level = max(n for n, one in enumerate(levels) if path.startswith(one.prefix))
        to = path.removeprefix(levels[level].prefix)
        self._move(to, level, [], None, None, UNSET, writer)
        self._settle_idle()

    # -- actions that end ----------------------------------------------------

    def finish(
        self,
        action_id: int,
        ok: bool,
        result: object,
        error: str | None,
        status: int | None,
        cause: int | None,
    ) -> int:
        """The running action ``action_id`` ended; the seq of the event that tells it."""
        seq = self.actions.finish(action_id, ok, result, error, status, cause)
        self._settle_idle()
        return seq


def _remember(stack: list[str], no: str) -> None:
    """no: a state to which ``#back`` leads."""
    stack.append(no)
    if len(stack) > DEEPEST:
        del stack[0]
