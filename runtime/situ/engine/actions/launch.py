"""Programs that an application may start: only those on the robot's own list.

The list is ``launch.toml`` in the runtime's state folder, written by whoever
looks after the robot, never by a project::

    brain-game = ["/usr/games/brain-game", "--level={level}"]

``{level}`` is filled with the param of that name; one that the list does not
mention is left out. An argument that is a param alone may not begin with ``-``.
No shell is involved. The list is read anew for each launch.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import os
import re
import signal
import tomllib
from pathlib import Path
from typing import Any

import msgspec

from situ.engine.actions import ActionFailed
from situ.engine.ending import ending_with_us
from situ.engine.process import kill

GRACE = 1.0
"""Seconds between asking a program to end and killing it."""

_PLACE = re.compile(r"\{([\w-]+)\}")


class Launcher:
    """Starts programs from the list in ``folder`` (None: there is no list)."""

    def __init__(self, folder: Path | None, log: logging.Logger) -> None:
        self._list = folder / "launch.toml" if folder is not None else None
        self._log = log

    async def launch(self, program: str, params: dict[str, Any]) -> None:
        """Returns when the program has ended with exit status 0.

        Raises ActionFailed for any other end, and for a program that is not on the
        list. Cancelled, it ends the program and all it started, and waits for it. Where we
        are killed the system tells it to end: the core that comes back starts it again.
        """
        argv = arguments(self._allowed(program), params)
        try:
            process = await asyncio.create_subprocess_exec(
                *argv,
                stdin=asyncio.subprocess.DEVNULL,
                stdout=asyncio.subprocess.DEVNULL,
                stderr=asyncio.subprocess.DEVNULL,
                start_new_session=True,
                preexec_fn=ending_with_us(signal.SIGTERM),
            )
        except OSError as error:
            raise ActionFailed(f"{program} can not be started: {error.strerror}") from error
        try:
            status = await process.wait()
        except BaseException:
            kill(process, signal.SIGTERM)
            await asyncio.shield(_gone(process))
            raise
        if status:
            how = f"exit status {status}" if status > 0 else signal.Signals(-status).name
            raise ActionFailed(f"{program} ended with {how}")

    def _allowed(self, program: str) -> list[str]:
        if self._list is None or not self._list.is_file():
            where = self._list or "launch.toml in the runtime's state folder"
            raise ActionFailed(f"{program} may not be started: list it in {where}")
        try:
            listed = msgspec.convert(
                tomllib.loads(self._list.read_text("utf-8")), dict[str, list[str]]
            )
        except (OSError, ValueError, msgspec.ValidationError) as error:
            raise ActionFailed(f"{self._list} can not be read: {error}") from error
        if not listed.get(program):
            raise ActionFailed(f"{program} may not be started: it is not listed in {self._list}")
        return listed[program]


def arguments(template: list[str], params: dict[str, Any]) -> list[str]:
    """The command with its places filled: strings as they are, all else compact JSON.

    Raises ActionFailed where a param would become an option or can not be passed.
    """
    filled = []
    for number, part in enumerate(template):
        if number == 0:
            filled.append(part)
            continue
        text = _PLACE.sub(lambda place: _text(params.get(place[1])), part)
        if "\x00" in text or (text.startswith("-") and part.startswith("{")):
            raise ActionFailed(f"the param for {part} may not be {text!r}")
        filled.append(text)
    return filled


def _text(value: Any) -> str:
    if value is None:
        return ""
    return value if isinstance(value, str) else msgspec.json.encode(value).decode()


async def _gone(process: asyncio.subprocess.Process) -> None:
    try:
        async with asyncio.timeout(GRACE):
            await process.wait()
    except TimeoutError:
        kill(process)
        await process.wait()
    # What it started and left behind, in its group.
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)
