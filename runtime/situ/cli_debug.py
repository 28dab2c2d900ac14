"""The debugger of a running robot: ``situ debug``."""

from __future__ import annotations

import argparse
from typing import Any

from situ.cli_board import add_robot, connect


def add(commands: Any) -> None:
    about = "breakpoints, pause, step and go on, of a running robot's applications"
    debug = commands.add_parser("debug", help=about, description=f"{about.capitalize()}.")
    verbs = debug.add_subparsers(metavar="VERB", required=True)

    stop = _verb(verbs, "break", "set a breakpoint; prints its number")
    _application(stop, "whose; may be left out where there is one, or on a situation")
    stop.add_argument("--state", metavar="STATE", help="pause after this state was entered")
    stop.add_argument(
        "--from", dest="source", metavar="STATE", help="pause before a transition from there"
    )
    stop.add_argument("--to", metavar="STATE", help="pause before a transition to there")
    stop.add_argument("--situation", metavar="NAME", help="pause when it becomes current")
    stop.add_argument("--when", metavar="XML", help='only if: \'<data tag="x" above="2"/>\'')
    stop.set_defaults(run=_break)

    gone = _verb(verbs, "unbreak", "take breakpoints away")
    gone.add_argument("breakpoint", nargs="?", type=int, metavar="NUMBER", help="else all of them")

    for verb, does in (("pause", "pause applications"), ("resume", "let applications go on")):
        _application(_verb(verbs, verb, does), "this one only; else all")

    step = _verb(verbs, "step", "let a paused application do the next thing")
    _application(step, "may be left out where there is one")

    goto = _verb(verbs, "goto", "send an application to a state")
    goto.add_argument("state", metavar="STATE", help="its number; in a part its path: 5/q")
    _application(goto, "may be left out where there is one")

    listed = _verb(verbs, "list", "list breakpoints and paused applications")
    listed.set_defaults(run=_list)


def _verb(verbs: Any, verb: str, does: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = verbs.add_parser(
        verb, help=does, description=f"{does.capitalize()}."
    )
    add_robot(parser)
    parser.set_defaults(run=_ask, verb=verb)
    return parser


def _application(parser: argparse.ArgumentParser, about: str) -> None:
    parser.add_argument("--application", metavar="NAME", help=about)


_FIELDS = ("application", "state", "source", "to", "situation", "when", "breakpoint")


def _given(args: argparse.Namespace) -> dict[str, Any]:
    found = {name: getattr(args, name, None) for name in _FIELDS}
    return {name: value for name, value in found.items() if value is not None}


def _ask(args: argparse.Namespace) -> int:
    with connect(args, "operator") as board:
        board.debug(args.verb, **_given(args))
    return 0


def _break(args: argparse.Namespace) -> int:
    with connect(args, "operator") as board:
        board.debug("break", **_given(args))
        print(max(one["id"] for one in board.get("debugger.breakpoints")))
    return 0


def _list(args: argparse.Namespace) -> int:
    with connect(args, "operator") as board:
        breakpoints = board.get("debugger.breakpoints") or []
        paused = board.get("debugger.paused") or {}
    for one in breakpoints:
        told = " ".join(f"{name} {value}" for name, value in one.items() if name != "id")
        print(f"breakpoint {one['id']}  {told}")
    for application, stopped in paused.items():
        print(f"paused {application}" + ("" if stopped is None else f"  breakpoint {stopped}"))
    return 0
