"""``situ studio``: opens the editor, a program of its own (``python -m situ_studio``)."""

from __future__ import annotations

import argparse
import importlib.util
import os
import re
import sys
from pathlib import Path
from typing import Any

from situ import system_libraries
from situ.errors import UsageError

THEMES = ("light", "dark")
LANGUAGES = ("en", "ja")


def add(commands: Any) -> None:
    studio = commands.add_parser(
        "studio",
        help="open the editor",
        description="Opens the editor, on a project if one is given.",
    )
    studio.add_argument(
        "project", nargs="?", metavar="PROJECT", help="a project's folder, or one of its files"
    )
    studio.add_argument(
        "--new", action="store_true", help="begin with the welcome page, not with what was open"
    )
    studio.add_argument(
        "--screenshot", metavar="OUT.png", help="draw the window into a picture and end"
    )
    studio.add_argument(
        "--picture", metavar="OUT.svg|pdf|png", help="write a graph as a picture and end"
    )
    studio.add_argument(
        "--document", metavar="NAME", help="with --picture: which one; the first unless given"
    )
    studio.add_argument(
        "--size", type=_size, metavar="WxH", help="the window's size in pixels, as 1440x900"
    )
    studio.add_argument(
        "--view", metavar="NAME", help="what to show: an application's name, or spds"
    )
    studio.add_argument(
        "--connect", metavar="ENDPOINT", help="follow the robot there, as tcp://127.0.0.1:5570"
    )
    studio.add_argument(
        "--at",
        type=_moment,
        metavar="SECONDS",
        help="with --connect: the picture waits until the robot's time has come so far",
    )
    studio.add_argument("--theme", choices=THEMES, help="the colours; the desktop's unless given")
    studio.add_argument(
        "--language", choices=LANGUAGES, help="of the window; the desktop's unless given"
    )
    studio.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Becomes the editor; returns only where it cannot be started."""
    if arguments.project is not None and not Path(arguments.project).exists():
        raise UsageError(f"{arguments.project}: no such file or folder")
    needs_editor(window=arguments.screenshot is None and arguments.picture is None)
    sys.stdout.flush()
    os.execv(sys.executable, command(arguments))


def command(arguments: argparse.Namespace) -> list[str]:
    """The editor's command line with the same arguments."""
    line = [sys.executable, "-m", "situ_studio"]
    if arguments.project is not None:
        line.append(arguments.project)
    if arguments.new:
        line.append("--new")
    for name in (
        "screenshot",
        "picture",
        "document",
        "size",
        "view",
        "connect",
        "at",
        "theme",
        "language",
        "log-level",
    ):
        value = getattr(arguments, name.replace("-", "_"), None)
        if value is not None:
            line += [f"--{name}", value]
    return line


def needs_editor(*, window: bool) -> None:
    """Raises UsageError, naming what to install, where the editor cannot run here.

    ``window``: it opens one; without, it only draws a picture, which needs no display.
    """
    for package in ("PySide6", "NodeGraphQt", "situ_studio"):
        if importlib.util.find_spec(package) is None:
            raise UsageError(
                f"the editor needs {package}, which is not installed: pip install 'situ[studio]'"
            )
    missing = system_libraries.missing(_libraries(window))
    if missing:
        raise UsageError(
            f"the editor needs {', '.join(need.file for need in missing)}: "
            f"{system_libraries.install(missing)}"
        )


def _libraries(window: bool) -> tuple[system_libraries.Need, ...]:
    """By the platform that Qt will choose: a display's, unless it is told another."""
    platform = os.environ.get("QT_QPA_PLATFORM", "")
    if not window or (platform and not platform.startswith(("xcb", "wayland"))):
        return system_libraries.editor()
    wayland = platform.startswith("wayland") or bool(os.environ.get("WAYLAND_DISPLAY"))
    return system_libraries.editor(x11=bool(os.environ.get("DISPLAY")), wayland=wayland)


def _moment(text: str) -> str:
    if not re.fullmatch(r"\d{1,9}(\.\d{1,6})?", text):
        raise argparse.ArgumentTypeError(f"{text!r} is no time; write seconds, as 12.5")
    return text


def _size(text: str) -> str:
    if not re.fullmatch(r"[1-9]\d{1,4}x[1-9]\d{1,4}", text):
        raise argparse.ArgumentTypeError(f"{text!r} is no size; write it as 1440x900")
    return text
