"""What one application has on the screen: its state's own, kept, and what ``always`` adds.

formats.md, *Screen* and *always*.
"""

from __future__ import annotations

from msgspec import UNSET, Struct

from situ.decide import trace
from situ.decide.actions import Actions
from situ.decide.program import Program, StateProgram
from situ.decide.screens import ScreenProgram, Shown
from situ.decide.texts import translator
from situ.decide.world import World
from situ.document.rbd import Component, Screen

Key = tuple[str | None, int]
"""The state whose own screen it is, and the number of the screens of ``always`` above it."""


class DisplayState(Struct):
    """base: the state whose own screen is kept. shown: what is on the screen by this
    application's command, None where nothing is. lacking: what was told to be missing on it.
    stale: a live text may have changed.
    """

    base: str | None = None
    shown: Key | None = None
    components: list[Shown] = []
    background: str | None = None
    lacking: list[str] = []
    stale: bool = False
    cause: int | None = None


class Display:
    """The screen of one application."""

    def __init__(self, world: World, program: Program, actions: Actions) -> None:
        self.state = DisplayState()
        self._world = world
        self._program = program
        self._actions = actions
        self._tags: dict[Key, set[str]] = {}
        own = [one.screen for one in program.states.values() if one.screen is not None]
        every = [*own, *(screen for screens in program.shared for screen in screens)]
        world.board.listen(
            sorted({"language", *(tag for one in every for tag in one.tags())}), self._written
        )

    def wanted(self, here: StateProgram) -> Key | None:
        """What the application has to show in a state; None: nothing.

        A state without a screen keeps what was shown: a screen that was never shown, its state
        having been left suspended, is not kept.
        """
        base = self.state.base
        if here.screen is not None:
            base = None if here.screen.source.is_empty else here.no
        return None if base is None and not here.shared else (base, here.shared)

    def begin(self, here: StateProgram, cause: int | None) -> None:
        """The state begins: its screen is shown, unless what it wants is kept."""
        if here.screen is not None:
            self.state.base = None if here.screen.source.is_empty else here.no
            self._actions.state.played.clear()
        if here.screen is not None or self.wanted(here) != self.state.shown:
            self.show(here, cause)

    def resume(self, here: StateProgram, cause: int | None) -> None:
        """What the state has to show is shown again."""
        if self.wanted(here) is not None:
            self.show(here, cause)

    def sources(self) -> tuple[Screen, ...]:
        """The screens that make up what is shown now."""
        return tuple(one.source for one in self._layers())

    def carry(self, shown: tuple[Screen, ...], begun: bool, here: StateProgram, cause: int) -> bool:
        """Another version: ``shown`` is what its ``sources`` were. Whether the state, if it has
        begun, has something else to show. What it shows is looked at once more in any case, for
        its texts may be others.
        """
        state = self.state
        base = self._program.states.get(state.base or "")
        if base is None or base.screen is None or base.screen.source.is_empty:
            state.base = None
        if begun and here.screen is not None:
            state.base = None if here.screen.source.is_empty else here.no
        wanted, was_shown = self.wanted(here), state.shown is not None
        if not was_shown:
            return wanted is not None
        state.shown, state.stale, state.cause = wanted, True, cause
        return self.sources() != shown

    def lose(self) -> None:
        """The screen is another's."""
        self.state.shown = None

    def component(self, component_id: str) -> Component | None:
        """A component of what is shown now."""
        for screen in reversed(self._layers()):
            found = screen.component(component_id)
            if found is not None:
                return found
        return None

    def touched(self) -> str | None:
        """The event of a touch on no component of what is shown."""
        return next((s.source.touched for s in self._layers() if s.source.touched), None)

    def refresh(self, here: StateProgram) -> None:
        """The end of a step: a live text that changed is shown once more."""
        state = self.state
        if not state.stale:
            return
        state.stale = False
        if state.shown is None:
            return
        missing: list[str] = []
        components, background = self._resolve(missing)
        if (components, background) == (state.components, state.background):
            return
        state.components, state.background = components, background
        self._warn(here, missing, state.cause)
        running = self._actions.state.running.values()
        self._trace(here, state.cause, tuple(r.id for r in running if r.action == "movie"))

    def _layers(self) -> list[ScreenProgram]:
        if self.state.shown is None:
            return []
        base, shared = self.state.shown
        own = None if base is None else self._program.states[base].screen
        return [*([] if own is None else [own]), *self._program.shared[shared]]

    def _resolve(self, missing: list[str]) -> tuple[list[Shown], str | None]:
        board = self._world.board
        translate = translator(self._world.project, board)
        layers = self._layers()
        shown = [c.show(board, translate, missing) for one in layers for c in one.components]
        background = next((one.background for one in layers if one.background is not None), None)
        return shown, None if background is None else background.text(board.look)

    def show(self, here: StateProgram, cause: int | None) -> None:
        """Shows what the application has to show in a state."""
        state, world = self.state, self._world
        self._actions.end_movies(cause)
        state.shown = self.wanted(here)
        missing: list[str] = []
        state.components, state.background = self._resolve(missing)
        state.lacking = []
        self._warn(here, missing, cause)
        movies = [movie for one in self._layers() for movie in one.movies()]
        played = self._actions.state.played
        ids = [0 if movie.id in played else world.next_id() for movie in movies]
        seq = self._trace(here, cause, tuple(ids))
        sources = {c["id"]: c["src"] for c in state.components if c["type"] == "movie"}
        self._actions.begin_movies(
            [(number, movie, sources[movie.id]) for number, movie in zip(ids, movies, strict=True)],
            here.no,
            seq,
        )

    def _trace(self, here: StateProgram, cause: int | None, ids: tuple[int, ...]) -> int:
        state = self.state
        background = state.background
        state.stale = False
        seq = self._world.step.trace(
            trace.Screen, cause, self._program.name, here.no, state.components,
            UNSET if background is None else background,
        )  # fmt: skip
        if state.shown is not None:
            value = {"components": state.components, "background": background}
            self._world.priorities.command(self._program.name, "screen", value, None, seq, ids)
        return seq

    def _warn(self, here: StateProgram, missing: list[str], cause: int | None) -> None:
        """Tells what the screen lacks, unless that was told when it was shown before."""
        for sentence in dict.fromkeys(missing):
            if sentence not in self.state.lacking:
                where = f"{self._program.name}, state {here.no}"
                self._world.step.warn(cause, sentence, where)
        self.state.lacking = missing

    def _written(self, tag: str, cause: int | None) -> None:
        shown = self.state.shown
        if shown is None:
            return
        tags = self._tags.get(shown)
        if tags is None:
            tags = {"language", *(t for one in self._layers() for t in one.tags())}
            self._tags[shown] = tags
        if tag in tags:
            self.state.stale = True
            self.state.cause = cause
