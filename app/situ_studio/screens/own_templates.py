"""The screens that a person keeps as templates of their own, in one file beside the settings."""

from __future__ import annotations

from pathlib import Path

from msgspec.structs import replace

from situ.document import codec, folder, rbd
from situ.errors import UsageError
from situ_studio.screens.templates import raised

FILE = "templates.rbd.xml"


class OwnTemplates:
    """Read from the file at each call: another window may have kept one.

    A file that can not be read is none: what is kept next is written in its place. UsageError
    where it can not be written.
    """

    def __init__(self, home: Path) -> None:
        self._file = home / FILE

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

    def keep(self, name: str, screen: rbd.Screen) -> None:
        """One more, or another one of that name. Its background stays with its state."""
        shown = rbd.Screen(components=screen.components)
        events = tuple(rbd.Event(name=event) for event in raised(shown))
        kept = [one for one in self.all() if one.name != name]
        made = rbd.State(no="1", name=name, screen=shown, events=events)
        self._write([*kept, made])

    def remove(self, name: str) -> None:
        self._write([one for one in self.all() if one.name != name])

    def _write(self, states: list[rbd.State]) -> None:
        every = sorted(states, key=lambda one: one.name.casefold())
        numbered = tuple(replace(one, no=str(no)) for no, one in enumerate(every, 1))
        try:
            self._file.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise UsageError(f"{self._file.parent}: {error.strerror or error}") from None
        written = codec.write(rbd.Application(name="templates", states=numbered))
        folder.write(self._file, written)
