"""The screens that a person keeps as templates of their own, in one file beside the settings.

Their pictures and movies lie in a folder beside that file, and go into the project in which a
template is used.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable
from pathlib import Path

from msgspec.structs import replace

from situ.document import codec, folder, rbd
from situ.document.project import Project
from situ.errors import UsageError
from situ_studio.screens import media_import
from situ_studio.screens.templates import raised

FILE = "templates.rbd.xml"
FOLDER = "templates"
"""Where their pictures lie; what they are called begins with it."""


class OwnTemplates:
    """Read from the file at each call: another window may have kept one.

    A file that can not be read is none: what is kept next is written in its place. UsageError
    where it can not be written.
    """

    def __init__(self, home: Path) -> None:
        self._file = home / FILE
        self._folder = home / FOLDER

    def all(self) -> tuple[rbd.State, ...]:
        """Each a state with nothing but a screen and the events that it raises, by name."""
        try:
            document, problems = codec.read(self._file.read_bytes(), str(self._file))
        except OSError:
            return ()
        if not isinstance(document, rbd.Application):
            return ()
        if any(problem.severity == "error" for problem in problems):
            return ()
        return document.states

    def keep(self, name: str, screen: rbd.Screen, file_of: Callable[[str], Path | None]) -> None:
        """One more, or another one of that name. Its background stays with its state.

        file_of: the file that a picture or movie of the screen names; a copy of it is kept.
        """
        components = tuple(self._kept(one, file_of) for one in screen.components)
        shown = rbd.Screen(components=components)
        events = tuple(rbd.Event(name=event) for event in raised(shown))
        kept = [one for one in self.all() if one.name != name]
        made = rbd.State(no="1", name=name, screen=shown, events=events)
        self._write([*kept, made])

    def remove(self, name: str) -> None:
        self._write([one for one in self.all() if one.name != name])

    def brought(self, template: rbd.State, project: Project) -> rbd.State:
        """A template as that project can show it: what it shows is copied into its media.

        Of others than one's own, the very same. Raises UsageError as ``media_import.bring``.
        """
        screen = template.screen
        if screen is None:
            return template
        every = tuple(self._brought(one, project) for one in screen.components)
        if every == screen.components:
            return template
        return replace(template, screen=replace(screen, components=every))

    def _kept(
        self, component: rbd.Component, file_of: Callable[[str], Path | None]
    ) -> rbd.Component:
        source = file_of(component.src) if isinstance(component, rbd.Image | rbd.Movie) else None
        if source is None:
            return component
        return replace(component, src=f"{FOLDER}/{media_import.put(self._folder, source)}")

    def _brought(self, component: rbd.Component, project: Project) -> rbd.Component:
        source = self._file_of(component)
        if source is None:
            return component
        return replace(component, src=media_import.bring(project, source))

    def _file_of(self, component: rbd.Component) -> Path | None:
        """The file of ours that a component shows."""
        first, _, name = getattr(component, "src", "").partition("/")
        file = self._folder / name
        ours = first == FOLDER and name not in ("", "..") and "/" not in name
        return file if ours and file.is_file() else None

    def _write(self, states: list[rbd.State]) -> None:
        every = sorted(states, key=lambda one: one.name.casefold())
        numbered = tuple(replace(one, no=str(no)) for no, one in enumerate(every, 1))
        try:
            self._file.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise UsageError(f"{self._file.parent}: {error.strerror or error}") from None
        written = codec.write(rbd.Application(name="templates", states=numbered))
        folder.write(self._file, written)
        self._sweep(numbered)

    def _sweep(self, states: Iterable[rbd.State]) -> None:
        """Without files that no template shows."""
        screens = [one.screen for one in states if one.screen is not None]
        shown = {self._file_of(one) for screen in screens for one in screen.components}
        for file in self._folder.iterdir() if self._folder.is_dir() else ():
            if file not in shown:
                with contextlib.suppress(OSError):
                    file.unlink()
