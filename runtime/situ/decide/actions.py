"""The actions of one application: begun in order, queued, ended, cut off and begun again.

formats.md, *Actions*. A *run* is one list of actions in progress: those of a state's
entry, or of an event. Its places are numbered as the document has them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec import Struct

from situ.decide import trace
from situ.decide.board import reach
from situ.decide.effects import Begin, Cancel
from situ.decide.filling import Filling
from situ.decide.program import Ended, Program, is_optional, name_of
from situ.decide.quick import QUICK, Perform, ready
from situ.decide.step import FINISH
from situ.decide.world import World
from situ.document.rbd import (
    Action,
    Launch,
    Movie,
    Repeat,
    Robot,
    Service,
    Sound,
    Speech,
    resource_of,
)

NEW, QUEUED, RUNNING, ENDED, INTERRUPTED = range(5)


class Run(Struct):
    """keys: of the actions; marks: how far each is; next: the first not looked at.

    waiting: the place of the action with ``wait`` that those behind it wait for.
    """

    state: str
    entry: bool
    keys: list[int]
    marks: list[int]
    next: int = 0
    waiting: int | None = None


class Running(Struct):
    """An action that has begun and not ended. run 0: it outlives its list. seq: of its event.

    fields: as it began, of those that use no resource.
    """

    id: int
    key: int
    run: int
    place: int
    action: str
    name: str | None
    resource: str | None
    done: str | None
    failed: str | None
    keep: bool = False
    optional: bool = False
    seq: int = 0
    fields: dict[str, Any] = {}


class ActionsState(Struct):
    """voice: places of speeches and sounds that wait for the one before them to end.

    played: ids of the movies of the screen shown that have ended.
    """

    runs: dict[int, Run] = {}
    running: dict[int, Running] = {}
    voice: list[tuple[int, int]] = []
    played: list[str] = []
    made: int = 0


class Actions:
    """The actions of one application; ``raise_event(name, cause, holder)`` takes their events.

    holder: the path of the only state that may take the event, or None.
    """

    def __init__(
        self,
        world: World,
        program: Program,
        owner: str,
        raise_event: Callable[[str, int | None, str | None], None],
    ) -> None:
        self.state = ActionsState()
        self.suspended = False
        self._world = world
        self._program = program
        self._owner = owner
        self._raise = raise_event
        self._performers: dict[int, Perform] = {}
        self._filling = Filling(world, program.name)

    # -- what others may know ------------------------------------------------

    @property
    def speaking(self) -> bool:
        """Whether a speech is being said, or waits for the voice."""
        return self._is_speaking() is not None or any(
            isinstance(self._action(*place), Speech) for place in self.state.voice
        )

    def hears(self) -> bool:
        """Whether phrases are listened for: after the speech, or in one with ``bargein``."""
        speech = self._is_speaking()
        if speech is not None:
            action = self._program.actions[speech.key]
            return isinstance(action, Speech) and action.bargein
        return not any(
            mark != ENDED and isinstance(self._program.actions[key], Speech)
            for run in self.state.runs.values()
            if run.entry
            for key, mark in zip(run.keys, run.marks, strict=True)
        )

    def find(self, action: str | None, name: str | None) -> Running | None:
        """The earliest started action that fits."""
        for running in self.state.running.values():
            if action in (None, running.action) and name in (None, running.name):
                return running
        return None

    def outstanding(self) -> list[Begin]:
        """The services and launches that have begun and not ended, as they began."""
        return [
            self._begun(running)
            for running in self.state.running.values()
            if running.action in ("service", "launch")
        ]

    def _is_speaking(self) -> Running | None:
        return next((r for r in self.state.running.values() if r.action == "speech"), None)

    def _action(self, run: int, place: int) -> Action:
        return self._program.actions[self.state.runs[run].keys[place]]

    # -- beginning -----------------------------------------------------------

    def begin(self, keys: list[int], state: str, cause: int | None, entry: bool = False) -> None:
        """Begins a list of actions in order; ``state`` is the one they belong to."""
        actions = self._program.actions
        if all(isinstance(actions[key], QUICK) for key in keys):
            # Nothing of them is in progress afterwards, so nothing need be kept.
            for key in keys:
                self.performer(key)(state, cause)
            return
        self.state.made += 1
        self.state.runs[self.state.made] = Run(state, entry, list(keys), [NEW] * len(keys))
        self._go_on(self.state.made, cause)

    def _go_on(self, number: int, cause: int | None) -> None:
        run = self.state.runs.get(number)
        while run is not None and run.waiting is None and run.next < len(run.keys):
            place = run.next
            run.next += 1
            action = self._program.actions[run.keys[place]]
            if action.wait:
                run.waiting = place
            self._start(number, place, cause)
            run = self.state.runs.get(number)

    def _start(self, number: int, place: int, cause: int | None) -> None:
        run = self.state.runs[number]
        action = self._program.actions[run.keys[place]]
        if isinstance(action, (Speech, Sound)) and self._voice_taken():
            run.marks[place] = QUEUED
            self.state.voice.append((number, place))
            return
        if isinstance(action, Ended):
            self._raise(action.name, cause, action.holder)
            self._ended(number, place, cause)
            return
        if isinstance(action, Repeat):
            self.repeat(cause)
            self._ended(number, place, cause)
            return
        resource = resource_of(action)
        if resource is not None and not self._world.priorities.holds(self._program.name, resource):
            seq = self._trace_cancelled(action.element, name_of(action), cause)
            self._ended(number, place, seq)
            return
        if isinstance(action, QUICK):
            self._ended(number, place, self.performer(run.keys[place])(run.state, cause))
            return
        if isinstance(action, Robot):
            self._supersede(action.resource, cause)
        run.marks[place] = RUNNING
        running = Running(
            self._world.next_id(), run.keys[place], number, place, action.element,
            name_of(action), resource, action.done, action.failed,
            isinstance(action, (Service, Launch)) and action.keep, is_optional(action),
        )  # fmt: skip
        self._run(running)
        self._announce(running, action, run.state, cause)

    def _announce(self, running: Running, action: Action, state: str, cause: int | None) -> None:
        """Traces the begin of an action and asks for it to be carried out."""
        fields = self._filling.fields(action, state, cause)
        seq = self._world.step.trace(
            trace.Action, cause, self._program.name, state, running.action, running.name, **fields
        )
        running.seq = seq
        if running.resource is None:
            running.fields = fields
            self._world.step.effects.append(self._begun(running))
            return
        if isinstance(action, Robot):
            value = {"command": fields["command"], "params": fields["params"]}
        else:
            value = {field: fields[field] for field in ("text", "lang", "src") if field in fields}
        self._world.priorities.command(
            self._program.name, running.resource, value, None, seq, (running.id,)
        )

    def _begun(self, running: Running) -> Begin:
        return Begin(running.id, self._program.name, running.action, running.name, running.fields)

    def _run(self, running: Running) -> None:
        self.state.running[running.id] = running
        world = self._world
        if world.auto_finish is not None:
            world.step.at(world.step.now + world.auto_finish, FINISH, self._owner, running.id)

    def _voice_taken(self) -> bool:
        return bool(self.state.voice) or self._sounds()

    def _sounds(self) -> bool:
        return any(r.action in ("speech", "sound") for r in self.state.running.values())

    def _supersede(self, resource: str, cause: int | None) -> None:
        """A second robot action on a resource cancels the first."""
        for running in list(self.state.running.values()):
            if running.resource == resource:
                del self.state.running[running.id]
                seq = self._trace_cancelled(running.action, running.name, cause)
                self._ended(running.run, running.place, seq)

    def performer(self, key: int) -> Perform:
        """What carries out an action that ends at once, and raises its ``done``."""
        found = self._performers.get(key)
        if found is None:
            action = self._program.actions[key]
            found = ready(self._world, self._program.name, action)
            if action.done is not None:
                found = self._raising(found, action.done)
            self._performers[key] = found
        return found

    def _raising(self, perform: Perform, done: str) -> Perform:
        def performing(state: str, cause: int | None) -> int:
            seq = perform(state, cause)
            self._raise(done, seq, None)
            return seq

        return performing

    # -- ending --------------------------------------------------------------

    def finish(
        self,
        action_id: int,
        ok: bool,
        result: Any,
        error: str | None,
        status: int | None,
        cause: int | None,
    ) -> int:
        """An action ended, well or badly: results, its event, and what waited for it; the seq of
        its event."""
        running = self.state.running.pop(action_id)
        step, program = self._world.step, self._program
        outcome = {"result": result} if ok else {"error": error}
        seq = step.trace(
            trace.Finished, cause, program.name, running.action, running.name, ok, **outcome
        )
        if running.resource is not None:
            self._world.priorities.end_command(program.name, running.resource, seq)
        if running.action == "service":
            self._results(running, ok, result, error, status, seq)
        event = running.done if ok else running.failed
        if event is not None:
            self._raise(event, seq, None)
        if running.action in ("speech", "sound"):
            self._next_voice(seq)
        elif running.action == "movie" and running.name is not None:
            self.state.played.append(running.name)
        self._ended(running.run, running.place, seq)
        return seq

    def _ended(self, number: int, place: int, cause: int | None) -> None:
        run = self.state.runs.get(number)
        if run is None:
            return
        run.marks[place] = ENDED
        if run.waiting == place:
            run.waiting = None
            if not self.suspended and run.next > place:
                self._go_on(number, cause)

    def _next_voice(self, cause: int | None) -> None:
        while self.state.voice and not self.suspended and not self._sounds():
            waiting, self.state.voice = self.state.voice, []
            number, place = waiting[0]
            self._start(number, place, cause)
            self.state.voice = waiting[1:] + self.state.voice

    def _results(
        self,
        running: Running,
        ok: bool,
        result: Any,
        error: str | None,
        status: int | None,
        cause: int,
    ) -> None:
        tags: dict[str, Any] = {
            f"service/{running.name}": {"ok": ok, "status": status, "error": error}
        }
        action = self._program.actions[running.key]
        if ok and isinstance(action, Service):
            for wanted in action.results:
                found = reach(result, wanted.path)
                if found is None:
                    self._world.step.warn(
                        cause,
                        f"the answer of {running.name} has no “{wanted.path}”; "
                        f"{wanted.tag} is deleted",
                        self._program.name,
                    )
                tags[wanted.tag] = found
        self._world.write(tags, self._program.name, cause)

    # -- cutting off ---------------------------------------------------------

    def leave(self, cause: int | None) -> None:
        """The state is left: what still runs is cancelled but for ``keep``, and movies, which
        end with their screen.
        """
        for running in list(self.state.running.values()):
            if running.keep or running.action == "movie":
                running.run = 0
            else:
                self.cancel(running, cause)
        self.state.runs.clear()
        self.state.voice.clear()

    def suspend(self, cause: int | None) -> None:
        """What uses a resource is cut off, to begin again; services and launches run on."""
        self.suspended = True
        for running in list(self.state.running.values()):
            if running.resource is None and running.action != "movie":
                continue
            seq = self.cancel(running, cause)
            self._mark(running, ENDED if running.optional else INTERRUPTED)
            if running.optional:
                self._ended(running.run, running.place, seq)
        for number, place in self.state.voice:
            self.state.runs[number].marks[place] = INTERRUPTED
        self.state.voice.clear()

    def resume(self, cause: int | None) -> None:
        """What was cut off begins again; what had ended is not repeated."""
        self.suspended = False
        for number, run in list(self.state.runs.items()):
            for place, mark in enumerate(run.marks):
                if mark == INTERRUPTED:
                    self._start(number, place, cause)
            self._go_on(number, cause)

    def release(self, cause: int | None) -> None:
        """After a pause: what came to its turn meanwhile begins."""
        self.suspended = False
        self._next_voice(cause)
        self.resume(cause)

    def lose(self, resource: str, cause: int | None) -> None:
        """An optional resource was lost: its actions are not begun again."""
        for running in list(self.state.running.values()):
            if running.resource == resource and running.optional:
                seq = self.cancel(running, cause)
                if running.action in ("speech", "sound"):
                    self._next_voice(seq)
                self._ended(running.run, running.place, seq)

    def repeat(self, cause: int | None) -> None:
        """``<repeat/>``: says the speeches of the state once more, with their events."""
        for number, run in list(self.state.runs.items()):
            if not run.entry:
                continue
            again = [
                place
                for place, key in enumerate(run.keys)
                if run.marks[place] != NEW and isinstance(self._program.actions[key], Speech)
            ]
            self.state.voice = [
                one for one in self.state.voice if not (one[0] == number and one[1] in again)
            ]
            for running in list(self.state.running.values()):
                if running.action == "speech" and running.run == number:
                    self.cancel(running, cause)
            for place in again:
                self._start(number, place, cause)

    def cancel(self, running: Running, cause: int | None) -> int:
        """Cuts an action off; the seq of its event."""
        del self.state.running[running.id]
        seq = self._trace_cancelled(running.action, running.name, cause)
        if running.resource is not None:
            self._world.priorities.end_command(self._program.name, running.resource, seq)
        elif running.action != "movie":
            self._world.step.effects.append(Cancel(running.id))
        return seq

    def _mark(self, running: Running, mark: int) -> None:
        run = self.state.runs.get(running.run)
        if run is not None:
            run.marks[running.place] = mark

    # -- movies --------------------------------------------------------------

    def end_movies(self, cause: int | None) -> None:
        """The screen that they belong to is gone."""
        for running in list(self.state.running.values()):
            if running.action == "movie":
                self.cancel(running, cause)

    def begin_movies(
        self, movies: list[tuple[int, Movie, str]], state: str, cause: int | None
    ) -> None:
        """Movies of the screen just shown: (id, component, source filled in). One that ended
        before a suspension is not played again.
        """
        for number, movie, src in movies:
            if movie.id in self.state.played:
                continue
            seq = self._world.step.trace(
                trace.Action, cause, self._program.name, state, "movie", movie.id, src=src
            )
            ends = movie.done, movie.failed
            self._run(Running(number, -1, 0, 0, "movie", movie.id, None, *ends, seq=seq))

    def _trace_cancelled(self, action: str, name: str | None, cause: int | None) -> int:
        return self._world.step.trace(trace.Cancelled, cause, self._program.name, action, name)
