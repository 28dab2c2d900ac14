"""The command ``situ``: finds the group that a command belongs to and runs it.

Each group is a module with ``add(commands)``, which registers its parsers with
``set_defaults(run=function)``; the function takes the parsed arguments and returns
the exit status: 0 well, 1 the thing checked failed, 2 wrong usage or unreadable
input (formats.md, *Command line*). Heavy imports stay inside these functions.
"""

from __future__ import annotations

import argparse
import difflib
import importlib
import logging
import os
import re
import signal
import sys
from collections.abc import Callable, Sequence
from typing import Any, NoReturn, Protocol, cast

from situ import __version__
from situ.errors import SituError

GROUPS = (
    "cli_studio",
    "cli_demo",
    "cli_new",
    "cli_check",
    "cli_export",
    "cli_diff",
    "cli_texts",
    "cli_simulate",
    "cli_test",
    "cli_why",
    "cli_replay",
    "cli_report",
    "cli_compare",
    "cli_run",
    "cli_board",
    "cli_debug",
    "cli_deploy",
    "cli_keys",
    "cli_robots",
)
"""The modules of the command line, in the order in which ``situ --help`` lists them."""

LEVELS = ("debug", "info", "warning", "error")

_log = logging.getLogger("situ")


class Group(Protocol):
    """What a module of ``GROUPS`` has."""

    def add(self, commands: Any) -> None:
        """Registers the group's parsers."""


class Parser(argparse.ArgumentParser):
    """One line for wrong usage; ``--log-level`` before or after the command."""

    def __init__(self, *args: Any, **options: Any) -> None:
        options.setdefault("allow_abbrev", False)
        super().__init__(*args, **options)
        self.add_argument(
            "--log-level",
            choices=LEVELS,
            # Suppressed, so that a command's parser does not undo what stood before it.
            default=argparse.SUPPRESS,
            metavar="LEVEL",
            help=f"what is logged to standard error: {', '.join(LEVELS)}; warning unless given",
        )

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {_line(_nearest(message))}; see {self.prog} --help\n")


def parser() -> Parser:
    """The whole command line."""
    whole = Parser(
        prog="situ",
        description="Draw a robot's states, situations and module priorities; run what you drew.",
    )
    whole.add_argument("--version", action="version", version=f"situ {__version__}")
    commands: Any = whole.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name in GROUPS:
        cast(Group, importlib.import_module(f"situ.{name}")).add(commands)
    return whole


def main(argv: Sequence[str] | None = None) -> int:
    """Runs one command and returns its exit status; never raises, never a traceback.

    ``argv``: the arguments without the program's name; ``sys.argv`` where it is None.
    """
    return guarded(lambda: _run(argv))


def _run(argv: Sequence[str] | None) -> int:
    try:
        arguments = parser().parse_args(argv)
    except SystemExit as stopped:  # how argparse ends after --help and wrong usage
        return stopped.code if isinstance(stopped.code, int) else 2
    level = getattr(arguments, "log_level", "warning")
    logging.basicConfig(
        level=level.upper(), stream=sys.stderr, format="%(levelname)s %(name)s: %(message)s"
    )
    return int(arguments.run(arguments))


def guarded(run: Callable[[], int]) -> int:
    """Runs ``run`` and turns every way in which it can fail into one line and a status."""
    try:
        status = run()
        sys.stdout.flush()
    except SituError as error:
        return _say(str(error))
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    except BrokenPipeError:
        # The reader (head, less) went away; nothing more can be said there, at exit neither.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 128 + signal.SIGPIPE
    except OSError as error:
        _log.debug("the system said no", exc_info=True)
        where = f"{error.filename}: " if error.filename else ""
        return _say(f"{where}{error.strerror or error}")
    except Exception as error:  # a fault of ours: even then the user gets one line
        _log.debug("unexpected", exc_info=True)
        return _say(
            f"a fault in situ itself ({type(error).__name__}: {error}); please report it "
            "with what --log-level debug prints"
        )
    return status


def _nearest(message: str) -> str:
    """argparse's list of choices, replaced by the nearest one where one is near."""
    wrong = re.fullmatch(r"(?s)(.*invalid choice: '(.*)') \(choose from (.*)\)", message)
    if wrong is None:
        return message
    near = difflib.get_close_matches(wrong[2], re.findall(r"[\w-]+", wrong[3]), n=1)
    return f"{wrong[1]}, did you mean {near[0]}?" if near else message


def _say(message: str) -> int:
    print(f"situ: {_line(message)}", file=sys.stderr)
    return 2


def _line(message: str) -> str:
    return " ".join(message.split())
