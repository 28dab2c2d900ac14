"""Carries out the effects of ``Robot.step``: speech, screen, robot, services, programs.

One object in one asyncio loop. What fails never leaves it: it becomes the action's
``Finish(ok=False, error=…)`` and a line in the log. Answers are given from the loop,
never from inside ``perform``, so that a step is never entered while one is running.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
from collections.abc import Callable, Collection, Coroutine
from functools import partial
from pathlib import Path
from typing import Any

from situ.blackboard.curve import KeysOf
from situ.blackboard.replies import Addresses
from situ.blackboard.services import PATIENCE, SERVICES, carried_by
from situ.decide.effects import AnyEffect, Begin, Cancel, Map
from situ.decide.inputs import AnyInput, Finish, Set
from situ.document.project import Project
from situ.document.texts import read_out
from situ.engine import voices
from situ.engine.actions import ActionFailed
from situ.engine.actions.launch import Launcher
from situ.engine.actions.service import Services
from situ.engine.actions.sound import Player, audible
from situ.engine.actions.speech import Speaker
from situ.engine.clock import Clock
from situ.engine.media import MediaFolder
from situ.engine.robots import Adapter, Surroundings, find
from situ.engine.screen.forms import forms
from situ.engine.screen.server import ScreenServer
from situ.engine.secrets import Secrets
from situ.engine.voices import Voice
from situ.errors import UsageError

Act = Callable[[], Coroutine[Any, Any, None]]


def _nothing(*_: Any) -> None:
    return None


class Performer:
    """Carries out effects for one project, and answers with inputs.

    submit: gets ``Finish`` of begun actions, what people do on the screen, and the
    simulated robot's tags.
    tag(name) reads the blackboard (``language``, ``speech.volume``, ``speech.rate``).
    screen: host and port, 0 for a free one. state_dir: the runtime's folder, with
    ``launch.toml`` and the screen's key; None: nothing may be launched, the key is new
    each time. services: those that are carried out here; effects for the
    others are left alone. poses: whether the simulated robot reports where it is.
    sound: whether somebody can hear; None finds out. captions: whether the screen
    keeps a line for what is being said; None: as soon as something said is not heard.
    voice: who speaks; None: espeak-ng.
    """

    def __init__(
        self,
        project: Project,
        submit: Callable[[AnyInput], None],
        *,
        tag: Callable[[str], Any] = _nothing,
        screen: tuple[str, int] = ("127.0.0.1", 0),
        state_dir: Path | None = None,
        services: Collection[str] = SERVICES,
        poses: bool = True,
        sound: bool | None = None,
        captions: bool | None = None,
        voice: Voice | None = None,
        timeout: float = PATIENCE,
        clock: Clock | None = None,
        adapter: Callable[[Surroundings], Adapter] | None = None,
        log: logging.Logger | None = None,
    ) -> None:
        self._project = project
        self._readings = project.readings
        self._submit = submit
        self._tag = tag
        self._address = screen
        self._state_dir = state_dir
        self._services = frozenset(services)
        self._poses = poses
        self._clock = clock
        self._make_adapter = adapter
        self._log = log or logging.getLogger("situ.engine")
        self._audible = audible() if sound is None else sound
        self._talks = voices.find("espeak-ng") if voice is None else voice
        self._captioning = captions is None
        silent = not self._audible or self._talks.missing is not None
        self._captions = silent if captions is None else captions
        self._media = MediaFolder(project)
        self._timeout = timeout
        self._launcher = Launcher(state_dir, self._log)
        self._loop: asyncio.AbstractEventLoop | None = None
        self._asker: Services | None = None
        self._speaker: Speaker | None = None
        self._player: Player | None = None
        self._adapter: Adapter | None = None
        self._screen: ScreenServer | None = None
        self._tasks: dict[int, asyncio.Task[None]] = {}
        self._ending: set[asyncio.Task[None]] = set()
        self._voice: asyncio.Task[None] | None = None
        self._held: dict[str, tuple[int, ...]] = {}

    # -- life --------------------------------------------------------------------

    async def start(self) -> None:
        """Opens what it needs. Raises UsageError for an unknown adapter or a taken port."""
        self._loop = asyncio.get_running_loop()
        clock: Clock = self._clock or self._loop
        if "engine" in self._services:
            told = Secrets(self._state_dir)
            self._asker = Services(self._media, clock, self._log, self._timeout, told)
            self._speaker = Speaker(self._talks, self._audible, clock, self._log, self._unheard)
            self._player = Player(self._audible, clock, self._log)
        if "screen" in self._services:
            server = ScreenServer(
                self._media,
                self._later,
                self._movie_ended,
                self._log,
                token=self._key(),
                forms=forms(self._project),
            )
            await server.start(*self._address)
            self._screen = server
            server.captions = self._captions
        if "robot" in self._services:
            report = (
                (lambda tags: self._later(Set(tags, self._project.adapter)))
                if self._poses
                else None
            )
            around = Surroundings(self._project, clock, self._moved, report, self._log)
            try:
                adapter = (self._make_adapter or find(self._project.adapter))(around)
                await adapter.start()
            except BaseException:
                await self.close()
                raise
            # One that has not started is not told to stop.
            self._adapter = adapter

    def turn_to(self, project: Project) -> None:
        """Another version of the project runs: its media and its settings are served. What the
        robot itself is, its adapter and the places that it knows, stays."""
        if self._screen is not None:
            self._screen.turn_to(project, forms(project))
        self._media.turn_to(project)
        self._readings = project.readings

    def open_door(self, addresses: Addresses, keys: KeysOf | None = None) -> None:
        """The core is there: the screen's server leads to it at ``/board``."""
        if self._screen is not None:
            self._screen.door.open(addresses.requests, addresses.notifications, keys)

    def hold(self) -> None:
        """The robot stops and holds, with all that it has."""
        if self._adapter is not None:
            for resource in sorted(self._adapter.resources):
                self.perform(Map(resource, None, None))

    def caption(self, said: Any) -> None:
        """What is being said where the engine is another process; None: nothing."""
        if self._screen is not None:
            text = said.get("text") if isinstance(said, dict) else said
            if isinstance(text, str):
                lang = said.get("lang") if isinstance(said, dict) else None
                self._screen.caption(text, str(lang or self._language()))
            else:
                self._screen.caption(None)

    async def close(self) -> None:
        """Stops everything: silences, holds the robot, ends programs, closes the screen."""
        # First of all it stands still, whatever else takes its time.
        self.hold()
        for task in self._tasks.values():
            self._end(task)
        self._tasks.clear()
        if self._voice is not None:
            self._end(self._voice)
            self._voice = None
        if self._ending:
            await asyncio.gather(*self._ending, return_exceptions=True)
        if self._adapter is not None:
            await self._adapter.close()
            self._adapter = None
        if self._asker is not None:
            await self._asker.close()
            self._asker = None
        if self._screen is not None:
            await self._screen.close()
            self._screen = None
        self._loop = None

    @property
    def screen_url(self) -> str | None:
        """The address that shows the robot's screen, its token included."""
        return self._screen.url if self._screen is not None else None

    @property
    def screen_port(self) -> int | None:
        return self._screen.port if self._screen is not None else None

    @property
    def captions(self) -> bool:
        """Whether the screen keeps a line for what is being said."""
        return self._captions

    @captions.setter
    def captions(self, on: bool) -> None:
        self._captions = on
        if self._screen is not None:
            self._screen.captions = on

    # -- effects -----------------------------------------------------------------

    def perform(self, effect: AnyEffect) -> None:
        """Begins to carry out an effect; never raises, never waits. Others are ignored."""
        try:
            if isinstance(effect, Map):
                self._map(effect)
            elif isinstance(effect, Begin):
                self._begin(effect)
            elif isinstance(effect, Cancel):
                self._cancel(effect.id)
        except Exception as error:
            self._log.exception("%s could not be carried out", type(effect).__name__)
            ids = effect.actions if isinstance(effect, Map) else ()
            if isinstance(effect, Begin):
                ids = (effect.id,)
            for action in ids:
                self._later(Finish(id=action, ok=False, error=_internal(error)))

    def _map(self, effect: Map) -> None:
        if effect.resource == "speech":
            if "engine" in self._services:
                self._speak(effect)
        elif effect.resource == "screen":
            if self._screen is not None:
                self._held["screen"] = effect.actions
                self._screen.show(effect.value, effect.actions, self._language())
        elif self._adapter is not None:
            self._move(self._adapter, effect)

    def _begin(self, effect: Begin) -> None:
        if "engine" not in self._services or not carried_by(effect):
            return
        if effect.action == "service":
            self._run(effect.id, partial(self._ask, effect))
        elif effect.action == "launch":
            program = str(effect.fields.get("program", effect.name or ""))
            self._run(effect.id, partial(self._launch, effect.id, program, effect.fields))
        else:
            self._later(
                Finish(id=effect.id, ok=False, error=f"nothing carries out {effect.action}")
            )

    def _cancel(self, action: int) -> None:
        task = self._tasks.pop(action, None)
        if task is not None:
            self._end(task)
        for resource, ids in self._held.items():
            if action in ids:
                self._held[resource] = tuple(i for i in ids if i != action)
                if resource == "speech":
                    self._silence()

    async def _ask(self, effect: Begin) -> None:
        fields = effect.fields
        params = fields.get("params")
        assert self._asker is not None
        result, status = await self._asker.ask(
            str(fields.get("url", "")),
            str(fields.get("method") or "GET"),
            params if isinstance(params, dict) else {},
        )
        self._finish(Finish(id=effect.id, result=result, status=status))

    async def _launch(self, action: int, program: str, fields: dict[str, Any]) -> None:
        params = fields.get("params")
        await self._launcher.launch(program, params if isinstance(params, dict) else {})
        self._finish(Finish(id=action))

    # -- speech ------------------------------------------------------------------

    def _speak(self, effect: Map) -> None:
        self._silence()
        self._held["speech"] = effect.actions
        value = effect.value
        if value is None:
            return
        act: Act
        if isinstance(value, dict) and isinstance(value.get("src"), str):
            act = partial(self._sound, value["src"])
        elif isinstance(value, dict) and isinstance(value.get("text"), str):
            act = partial(self._say, value["text"], str(value.get("lang") or self._language()))
        elif isinstance(value, str):
            act = partial(self._say, value, self._language())
        else:
            self._log.warning("speech was commanded %.80r, which has neither text nor src", value)
            return
        assert self._loop is not None
        self._voice = self._loop.create_task(self._guard(effect.actions, act))

    async def _say(self, text: str, lang: str) -> None:
        assert self._speaker is not None
        if self._screen is not None:
            self._screen.caption(text, lang)
        volume, rate = self._tag("speech.volume"), self._tag("speech.rate")
        said = read_out(text, self._readings.get(lang, {}), lang)
        await self._speaker.say(said, lang, volume, rate)
        if self._screen is not None:
            self._screen.caption(None)
        self._release("speech")

    async def _sound(self, src: str) -> None:
        assert self._player is not None
        file = self._media.find(src)
        if file is None:
            raise ActionFailed(f"there is no sound {src} in the project's media")
        await self._player.play(file)
        self._release("speech")

    def _silence(self) -> None:
        if self._voice is not None:
            self._end(self._voice)
            self._voice = None
            if self._screen is not None:
                self._screen.caption(None)

    def _unheard(self) -> None:
        """Something that was said was not heard: from now on it can be read."""
        if self._captioning and not self._captions:
            self.captions = True

    def _language(self) -> str:
        lang = self._tag("language")
        return lang if isinstance(lang, str) and lang else "en"

    # -- robot and movies ----------------------------------------------------------

    def _move(self, adapter: Adapter, effect: Map) -> None:
        self._held[effect.resource] = effect.actions
        if effect.resource in adapter.resources:
            adapter.apply(effect.resource, effect.value)
        elif effect.value is not None:
            known = ", ".join(sorted(adapter.resources))
            why = f"the robot {self._project.adapter} has no {effect.resource}; it has {known}"
            self._moved(effect.resource, False, why)

    def _moved(self, resource: str, ok: bool, error: str | None) -> None:
        if not ok and not self._held.get(resource):
            self._log.warning("%s: %s", resource, error)
        self._release(resource, ok, error)

    def _movie_ended(self, action: int, error: str | None) -> None:
        if action in self._held.get("screen", ()):
            self._held["screen"] = tuple(i for i in self._held["screen"] if i != action)
            self._later(Finish(id=action, ok=error is None, error=error))

    # -- answers -----------------------------------------------------------------

    def _release(self, resource: str, ok: bool = True, error: str | None = None) -> None:
        """Finishes the actions that a resource carries out."""
        for action in self._held.pop(resource, ()):
            self._later(Finish(id=action, ok=ok, error=error))

    def _finish(self, finish: Finish) -> None:
        assert finish.id is not None
        if self._tasks.pop(finish.id, None) is not None:
            self._later(finish)

    def _later(self, answer: AnyInput) -> None:
        if self._loop is not None:
            self._loop.call_soon(self._answer, answer)

    def _answer(self, answer: AnyInput) -> None:
        if self._loop is not None:
            self._submit(answer)

    def _run(self, action: int, act: Act) -> None:
        assert self._loop is not None
        self._tasks[action] = self._loop.create_task(self._guard((action,), act))

    async def _guard(self, ids: tuple[int, ...], act: Act) -> None:
        """Runs an action; however it fails, its Finish says so in plain words."""
        try:
            await act()
        except ActionFailed as failure:
            self._fail(ids, str(failure), failure.status)
        except Exception as error:
            self._log.exception("an action failed unexpectedly")
            self._fail(ids, _internal(error), None)

    def _fail(self, ids: tuple[int, ...], error: str, status: int | None) -> None:
        if ids and ids == self._held.get("speech"):
            self._held.pop("speech")
            if self._screen is not None:
                self._screen.caption(None)
        if not ids:
            self._log.warning("%s", error)
        for action in ids:
            self._tasks.pop(action, None)
            self._later(Finish(id=action, ok=False, error=error, status=status))

    def _end(self, task: asyncio.Task[None]) -> None:
        """Cancels a task and keeps it until it is gone, with the program it may have started."""
        self._ending.add(task)
        task.add_done_callback(self._ending.discard)
        task.cancel()

    def _key(self) -> str | None:
        """The screen's key: the same after a restart, so that open pages find back."""
        if self._state_dir is None:
            return None
        file = self._state_dir / "keys" / "screen"
        try:
            # A disk that was full when the key was made has left an empty file.
            key = file.read_text("utf-8").strip() if file.is_file() else ""
            if not key:
                key = secrets.token_urlsafe(24)
                file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
                file.touch(mode=0o600)
                file.write_text(key + "\n", "utf-8")
        except OSError as error:
            raise UsageError(
                f"{file}: the screen's key can not be kept there: {error.strerror}"
            ) from None
        return key


def _internal(error: Exception) -> str:
    return f"the robot's own software failed: {type(error).__name__}: {error}"
