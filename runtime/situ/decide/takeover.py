"""An application of the version before, taken over by that of the same name in the new one.

docs/semantics.md, *Deploy*: it stays in its state, and what that state still has goes on.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Sequence

from situ.decide.actions import ENDED, NEW, ActionsState, Run, Running
from situ.decide.machine import Machine, MachineState
from situ.decide.program import Candidate, Program
from situ.decide.timeouts import TimeoutState
from situ.document.rbd import Action


class Takeover:
    """``old`` and ``new`` are one application. For all of them in turn come ``carry``, which
    traces nothing, ``leave``, ``ask``, and, when authority has been granted, ``go_on``.

    stays: whether the state in which it is exists still; else it starts again.
    """

    def __init__(self, old: Machine, new: Machine, cause: int) -> None:
        self.stays = old.state.no in new.program.states
        self._old = old
        self._new = new
        self._cause = cause
        self._gone: list[Running] = []
        self._asked: int | None = None
        self._shows = False

    def carry(self) -> None:
        """What it was it is now."""
        if not self.stays:
            return
        old, new = self._old, self._new
        state, here = old.state, new.program.states[old.state.no]
        state.stale = self._stale(here.unnamed)
        state.stacks = [
            [no for no in stack if level.prefix + no in new.program.innermost]
            for level, stack in zip(here.levels, state.stacks, strict=True)
        ]
        shown = old.display.sources()
        new.restore(state)
        self._shows = new.display.carry(shown, state.begun, here, self._cause)
        self._carry_actions(state.actions)

    def _carry_actions(self, state: ActionsState) -> None:
        """Each to the equal one of the new version; what has none is gone."""
        before, program = self._old.program.actions, self._new.program
        equal = {action: key for key, action in reversed(list(enumerate(program.actions)))}
        entry = self._new.entry()
        keys: dict[tuple[int, int], tuple[int, int]] = {}
        for number, run in state.runs.items():
            actions = [before[key] for key in run.keys]
            if run.entry:
                others = entry
            else:
                others = [equal[action] for action in actions if action in equal]
            to = _places(actions, [program.actions[key] for key in others])
            for place, other in enumerate(to):
                if other is not None:
                    keys[number, place] = other, others[other]
            state.runs[number] = _run(run, others, to)
        state.voice = [(one[0], keys[one][0]) for one in state.voice if one in keys]
        for running in state.running.values():
            if running.action == "movie":
                continue
            if running.run:
                found = keys.get((running.run, running.place))
            else:
                key = equal.get(before[running.key])
                found = None if key is None else (running.place, key)
            if found is None:
                self._gone.append(running)
            else:
                running.place, running.key = found

    def _stale(self, unnamed: Sequence[Candidate]) -> dict[int, int | None]:
        """What is to be judged: what was, and what the state did not have before."""
        old, new = self._old, self._new.program
        there: defaultdict[object, deque[int]] = defaultdict(deque)
        for one in old.here.unnamed:
            there[_content(one, old.program)].append(one.key)
        found: dict[int, int | None] = {}
        for one in unnamed:
            same = there[_content(one, new)]
            if not same:
                found[one.key] = self._cause
            elif (was := same.popleft()) in old.state.stale:
                found[one.key] = old.state.stale[was]
        return found

    def leave(self) -> None:
        """What is gone ends."""
        old, new, cause = self._old, self._new, self._cause
        if self.stays:
            for running in self._gone:
                new.actions.cancel(running, cause)
            return
        state = old.state
        old.leave(0, cause)
        old.actions.end_movies(cause)
        old.warn(cause, f"there is no state {state.no} any longer: {old.name} starts again")
        kept = MachineState(
            queue=state.queue,
            suspended=state.suspended,
            granted=state.granted,
            timeout=TimeoutState(token=state.timeout.token, held=state.timeout.held),
            actions=ActionsState(running=state.actions.running, made=state.actions.made),
        )
        new.restore(kept)
        self._carry_actions(kept.actions)
        for running in self._gone:
            new.actions.cancel(running, cause)

    def ask(self) -> int | None:
        """What its state uses now; the seq of the event where that is something else."""
        if self.stays:
            self._asked = self._new.ask(self._cause)
        return self._asked

    def go_on(self) -> None:
        """With what it holds now."""
        new, cause = self._new, self._cause
        if not self.stays:
            new.start(cause)
        else:
            new.go_on(self._shows, self._asked, cause)
        if new.paused:
            new.hold()


def _content(one: Candidate, program: Program) -> object:
    """By what an unnamed event is known in both versions."""
    return one.level, one.next, one.when, tuple(program.actions[key] for key in one.actions)


def _places(before: Sequence[Action], after: Sequence[Action]) -> list[int | None]:
    """For each action the place of its equal, of several the first that is free."""
    free: defaultdict[Action, deque[int]] = defaultdict(deque)
    for place, action in enumerate(after):
        free[action].append(place)
    return [free[action].popleft() if free[action] else None for action in before]


def _run(run: Run, keys: list[int], to: Sequence[int | None]) -> Run:
    """The list of actions under new keys. Where all had begun, nothing of it begins any more;
    else what comes behind the last that had begun is the new version's.
    """
    begun = [(place, other) for place, other in enumerate(to[: run.next]) if other is not None]
    if run.next == len(run.keys):
        following = len(keys)
    else:
        following = 1 + max((other for _, other in begun), default=-1)
    marks = [ENDED] * following + [NEW] * (len(keys) - following)
    for place, other in begun:
        marks[other] = run.marks[place]
    waiting = None if run.waiting is None else to[run.waiting]
    return Run(run.state, run.entry, list(keys), marks, following, waiting)
