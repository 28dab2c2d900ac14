"""Who says texts, one engine a file; chosen on the robot, by ``situ run --speech``.

Engines are programs of the machine: none is bundled, and none is needed to run a project.
"""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Protocol

from situ.engine.voices.dispatcher import SpeechDispatcher
from situ.engine.voices.espeak import EspeakNg
from situ.engine.voices.piper import Piper
from situ.engine.voices.text import Said, Spoken
from situ.errors import UsageError

ENGINES = ("espeak-ng", "speech-dispatcher", "piper:FILE")


class Voice(Protocol):
    """One engine. missing: why it can not speak on this machine, in words; None: it can."""

    @property
    def missing(self) -> str | None: ...

    async def speak(self, said: Said, audible: bool) -> Spoken:
        """Says a text; only reckons how long it takes where nothing is ``audible``.

        Never raises for what the engine does; stops at once when it is cancelled, and has
        ended, with its programs, when the cancellation comes out.
        """
        ...


def find(choice: str) -> Voice:
    """The engine of that name. Raises UsageError where there is none, not where it is missing."""
    name, colon, file = choice.partition(":")
    if choice == "espeak-ng":
        return EspeakNg(shutil.which("espeak-ng"))
    if choice == "speech-dispatcher":
        return SpeechDispatcher(shutil.which("spd-say"))
    if name == "piper" and colon and file:
        return Piper(shutil.which("piper"), Path(file))
    raise UsageError(f"--speech {choice}: there is no such engine; write {_or(ENGINES)}")


def _or(names: tuple[str, ...]) -> str:
    return f"{', '.join(names[:-1])} or {names[-1]}"


__all__ = ["ENGINES", "Said", "Spoken", "Voice", "find"]
