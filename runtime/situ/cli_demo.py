"""``situ demo``: the whole loop on one machine, from an example's web service to the editor."""

from __future__ import annotations

import argparse
import contextlib
import os
import shutil
import signal
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable

    from situ.engine.children import Children

EXAMPLE = "reception"
PICTURE = "demo.png"
HEADLESS_SECONDS = 8.0
"""How long a scenario takes at most where nobody watches."""
PATIENCE = 20.0
"""Seconds that a program gets to say that it is ready."""


def add(commands: Any) -> None:
    demo = commands.add_parser(
        "demo",
        help="see it all at work: a robot, an example, the editor connected",
        description="Runs an example on a simulated robot, with the editor connected to it. "
        "Without a display (or with SITU_HEADLESS=1) plays the example's scenario, prints the "
        f"trace and leaves {PICTURE} of the connected editor. Ends with the window or Ctrl-C.",
    )
    demo.add_argument(
        "example", nargs="?", default=EXAMPLE, metavar="EXAMPLE", help=f"{EXAMPLE} unless given"
    )
    demo.add_argument(
        "--play",
        action="store_true",
        help="play the example's scenario in the window too, and end with it",
    )
    demo.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    import asyncio

    from situ.cli_studio import needs_editor
    from situ.resources import example

    project = example(args.example)
    window = os.environ.get("SITU_HEADLESS") != "1" and bool(
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    )
    needs_editor(window=window)
    return asyncio.run(_demo(project, window=window, play=args.play or not window))


async def _demo(project: Path, *, window: bool, play: bool) -> int:
    import asyncio

    from situ.engine.children import Children

    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        loop.add_signal_handler(number, stopped.set)
    with tempfile.TemporaryDirectory(prefix="situ-demo-") as folder:
        async with Children() as children:
            robot = Robot(project, Path(folder), children)
            showing = asyncio.create_task(
                _in_window(robot, play) if window else _headless(robot, Path(PICTURE).absolute())
            )
            stop = asyncio.create_task(stopped.wait())
            await asyncio.wait({showing, stop}, return_when=asyncio.FIRST_COMPLETED)
            stop.cancel()
            if not showing.done():
                showing.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await showing
                return 0 if window else 128 + signal.SIGINT
            return await showing


async def _headless(robot: Robot, picture: Path) -> int:
    """The scenario, its trace, and a picture from the midst of it; 0 where all went well."""
    script = _scenario(robot.project)
    end, moment = _moments(script)
    speed = max(1.0, end / HEADLESS_SECONDS)
    # The scenario waits for the editor, however long that takes to start.
    address = await robot.start(
        "--script", str(script), "--speed", f"{speed:g}", "--clients", "1", "--trace", "-"
    )
    picture.unlink(missing_ok=True)
    editor = await robot.editor(
        address["requests"], "--screenshot", str(picture), "--at", f"{moment:g}"
    )
    if await editor.wait():
        _tell("the editor left no picture")
        return 2
    status = await robot.ended()
    _tell(f"played {script.name}; {picture.name} shows the editor at {moment:g} s of it")
    return status


async def _in_window(robot: Robot, play: bool) -> int:
    """The editor's window and a robot to touch, until the window is closed."""
    import asyncio

    script = _scenario(robot.project) if play else None
    options = [] if script is None else ["--script", str(script), "--clients", "1"]
    address = await robot.start(*options)
    _tell(f"the robot is at {address['requests']}")
    if script is not None:
        _tell(f"playing {script.name}")
    else:
        await robot.modules(address["requests"])
        _tell(f"touch its screen at {address['http']}")
    editor = await robot.editor(address["requests"])
    closed = asyncio.create_task(editor.wait())
    ended = asyncio.create_task(robot.ended())
    await asyncio.wait({closed, ended}, return_when=asyncio.FIRST_COMPLETED)
    if not ended.done():
        ended.cancel()
        return _closed(await closed)
    closed.cancel()
    status = await ended
    if script is None:
        _tell(f"the robot ended with exit status {status}")
        return 2
    return status


def _closed(status: int) -> int:
    if status < 0:
        _tell(f"the editor was ended by {signal.Signals(-status).name}")
    return 0 if status == 0 else 2


class Robot:
    """The processes of a demonstration, each on ports that are free.

    The robot runs a copy of the project in ``folder``, whose ``robot.local.toml`` says where
    the example's own services answer; the editor opens the project itself.
    """

    def __init__(self, project: Path, folder: Path, children: Children) -> None:
        self.project = project
        self._folder = folder
        self._children = children
        self._core: asyncio.subprocess.Process | None = None
        self._said: list[asyncio.Task[None]] = []

    async def start(self, *options: str) -> dict[str, Any]:
        """Starts services and ``situ run``; the addresses that it announces."""
        import asyncio

        import msgspec

        robot = self._folder / self.project.name
        shutil.copytree(
            self.project, robot, ignore=shutil.ignore_patterns("__pycache__", "robot.local.toml")
        )
        services = await self._services()
        lines = ["[tags]", *(f'"services.{name}" = "{at}"' for name, at in services.items())]
        (robot / "robot.local.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
        self._core = await self._children.start(
            [
                *(sys.executable, "-m", "situ", "run", str(robot), "--json"),
                *("--endpoint", "tcp://127.0.0.1:0", "--http", "127.0.0.1:0"),
                *("--state", str(self._folder / "state"), *options),
            ],
            # Where the trace goes to standard output, it is announced on the other.
            stderr=asyncio.subprocess.PIPE if "--trace" in options else None,
            stdout=None if "--trace" in options else asyncio.subprocess.PIPE,
        )
        announced = self._core.stderr or self._core.stdout
        assert announced is not None
        line = await _line(announced, "the robot", lambda line: line.startswith("{"))
        self._said.append(asyncio.create_task(_forward(announced)))
        addresses: dict[str, Any] = msgspec.json.decode(line)
        return addresses

    async def _services(self) -> dict[str, str]:
        """``NAME_service.py`` answers at the tag ``services.NAME``; it prints its address."""
        import asyncio

        found = {}
        for program in sorted(self.project.glob("*_service.py")):
            started = await self._children.start(
                [sys.executable, str(program), "--port", "0"], stdout=asyncio.subprocess.PIPE
            )
            assert started.stdout is not None
            address = await _line(started.stdout, program.name, lambda line: "://" in line)
            self._said.append(asyncio.create_task(_forward(started.stdout)))
            found[program.stem.removesuffix("_service")] = address
        return found

    async def modules(self, endpoint: str) -> None:
        """Starts the example's modules, where it has any, for a robot that nobody plays."""
        program = self.project / "modules" / "start_all.py"
        if not program.is_file():
            return
        await self._children.start([sys.executable, str(program), endpoint])
        sensors = program.with_name("sensors.py")
        if sensors.is_file():
            _tell(f"say what it perceives with: {sys.executable} {sensors} {endpoint}")

    async def editor(self, endpoint: str, *options: str) -> asyncio.subprocess.Process:
        return await self._children.start(
            [
                *(sys.executable, "-m", "situ_studio", str(self.project)),
                *("--connect", endpoint, *options),
            ]
        )

    async def ended(self) -> int:
        """The exit status of ``situ run``, when all that it said is printed."""
        assert self._core is not None
        status = await self._core.wait()
        await self._said[-1]
        return status


def _scenario(project: Path) -> Path:
    """The one with the most to see."""
    from situ.errors import UsageError

    scenarios = sorted((project / "scenarios").glob("*.jsonl"))
    if not scenarios:
        raise UsageError(f"{project}: no scenario to play")
    return max(scenarios, key=lambda path: path.read_bytes().count(b"\n"))


def _moments(script: Path) -> tuple[float, float]:
    """The scenario's end, and that of its last doing before three quarters of it; seconds."""
    from situ.decide.inputs import Input
    from situ.rehearse import scenario

    lines = scenario.load(script)
    end = lines[-1].at
    doing = [line.at for line in lines if isinstance(line.does, Input)]
    return end / 1e6, max((at for at in doing if at <= end * 3 / 4), default=0) / 1e6


async def _line(stream: asyncio.StreamReader, who: str, wanted: Callable[[str], bool]) -> str:
    """The first line that is wanted; those before it go to standard error."""
    import asyncio

    from situ.errors import UsageError

    async def find() -> str:
        while line := (await stream.readline()).decode(errors="replace"):
            if wanted(line):
                return line.strip()
            sys.stderr.write(line)
        raise UsageError(f"{who} did not start")

    try:
        return await asyncio.wait_for(find(), PATIENCE)
    except TimeoutError:
        raise UsageError(f"{who} was not ready after {PATIENCE:g} s") from None


async def _forward(stream: asyncio.StreamReader) -> None:
    while line := await stream.readline():
        sys.stderr.write(line.decode(errors="replace"))


def _tell(message: str) -> None:
    print(f"situ demo: {message}", file=sys.stderr, flush=True)
