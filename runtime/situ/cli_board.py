"""Looking at and touching a running robot: ``situ get``, ``set``, ``watch``, ``event``,
``modules`` and ``trace``."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from situ.blackboard.client import Board, Following
    from situ.blackboard.protocol import Role
    from situ.blackboard.replies import ModuleState
    from situ.engine.trace_file import TraceFile

T = TypeVar("T")

PATIENCE = 1.0
"""Seconds that the robot has to answer."""


def add(commands: Any) -> None:
    get = _command(commands, "get", _get, "print what stands at a tag", as_json=True)
    get.add_argument("tag", metavar="TAG", help="a tag, a name into one, or a pattern: face.*")
    _role(get)

    put = _command(commands, "set", _set, "set a tag")
    put.add_argument("tag", metavar="TAG")
    put.add_argument("value", metavar="VALUE", help="JSON, else a text; null deletes")

    watch = _command(commands, "watch", _watch, "print each change of a tag", as_json=True)
    watch.add_argument("tag", metavar="TAG", help="a tag or a pattern: face.*")
    watch.add_argument(
        "--messages",
        action="store_true",
        help="the messages of applications instead; TAG is a topic or a pattern: spo2/*",
    )
    _role(watch)
    _waits(watch)

    event = _command(commands, "event", _event, "raise an event")
    event.add_argument("name", metavar="NAME")
    event.add_argument("--application", metavar="NAME", help="for this one only; else for all")

    modules = _command(commands, "modules", _modules, "list the modules", as_json=True)
    modules.add_argument(
        "--wanted", action="store_true", help="what is required and nobody provides"
    )

    trace = _command(commands, "trace", _trace, "follow the trace (one JSON object a line)")
    trace.add_argument(
        "--since", type=int, metavar="SEQ", help="from this event on; 1: all there is"
    )
    trace.add_argument(
        "--record",
        type=Path,
        metavar="F.mcap",
        help="record it here instead of printing it; it can be looked at, not decided again",
    )
    _role(trace)
    _waits(trace)


def _command(
    commands: Any, name: str, run: Any, about: str, as_json: bool = False
) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        name, help=f"{about} of a running robot", description=f"{about.capitalize()}."
    )
    add_robot(parser)
    if as_json:
        parser.add_argument("--json", action="store_true", help="for a program to read")
    parser.set_defaults(run=run)
    return parser


def _role(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--role",
        choices=("viewer", "operator"),
        default="viewer",
        help="as whom: a viewer, as unless given, is shown ••• for what is private",
    )


def _waits(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--wait", action="store_true", help="when the robot ends, wait until it is started again"
    )


def add_robot(parser: argparse.ArgumentParser) -> None:
    """Which robot: what ``connect`` needs."""
    parser.add_argument(
        "--at",
        default="tcp://127.0.0.1:5570",
        metavar="ENDPOINT",
        help="the robot's address; tcp://127.0.0.1:5570 unless given",
    )
    parser.add_argument(
        "--keys",
        metavar="DIR",
        help="the folder with your keys, where the robot lets in only whom it knows",
    )


def connect(args: argparse.Namespace, role: Role) -> Board:
    from situ.blackboard import client

    return client.connect(args.at, role=role, timeout=PATIENCE, keys=args.keys)


def _print(value: Any) -> None:
    import msgspec

    sys.stdout.write(msgspec.json.encode(value).decode() + "\n")
    sys.stdout.flush()


def _get(args: argparse.Namespace) -> int:
    with connect(args, args.role) as board:
        entries = board.entries(args.tag)
    if args.json:
        _print(entries)
    elif "*" in args.tag:
        for tag, entry in entries.items():
            _say(tag, entry.value)
    else:
        _print(entries[args.tag].value)
    return 0


def _set(args: argparse.Namespace) -> int:
    from situ.decide.values import read

    with connect(args, "operator") as board:
        board.set(args.tag, read(args.value))
    return 0


def _watch(args: argparse.Namespace) -> int:
    if args.messages:
        return _listen(args)
    with connect(args, args.role) as board, board.watch(args.tag) as changes:
        for change in _coming(args, board, changes):
            if args.json:
                _print(change)
            else:
                _say(change.tag, change.value)
    return 0


def _listen(args: argparse.Namespace) -> int:
    from msgspec.structs import asdict

    with connect(args, args.role) as board, board.messages(args.tag) as messages:
        for message in _coming(args, board, messages):
            if args.json:
                _print(asdict(message))
            else:
                _say(message.topic, message.value)
    return 0


def _event(args: argparse.Namespace) -> int:
    with connect(args, "operator") as board:
        applications = board.expected()
        board.publish(args.name, args.application)
    asked = applications.values() if args.application is None else [applications[args.application]]
    names = dict.fromkeys(event.name for one in asked for event in one.events)
    if args.name not in names:
        who = args.application or "the robot"
        what = f"only {', '.join(names)}" if names else "no event"
        print(f"situ: {args.name} is not expected now; {who} expects {what}", file=sys.stderr)
    return 0


def _modules(args: argparse.Namespace) -> int:
    with connect(args, "viewer") as board:
        states = board.modules()
    if args.json:
        _print(states.wanted if args.wanted else states.modules)
    elif args.wanted:
        for want in states.wanted:
            what = f"data {want.data}" if want.data is not None else f"module {want.module}"
            print(f"{what}  wanted by {', '.join(want.by)}")
    else:
        _table([_HEADINGS, *(_row(state) for state in states.modules)])
    return 0


_HEADINGS = ("MODULE", "KIND", "PRESENT", "RESOURCES", "HOLDS", "PROVIDES", "NEEDS")


def _row(state: ModuleState) -> tuple[str, ...]:
    needs = [
        need.data if need.data is not None else f"module {need.module}" for need in state.requires
    ]
    return (
        state.name,
        "application" if state.application else "module",
        "yes" if state.present else "no",
        " ".join(state.resources),
        " ".join(state.holds),
        ", ".join(offer.data for offer in state.provides),
        ", ".join(needs),
    )


def _table(rows: list[tuple[str, ...]]) -> None:
    """Columns as wide as what stands in them; - where there is nothing."""
    widths = [max(len(cell) for cell in column) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = ((cell or "-").ljust(width) for cell, width in zip(row, widths, strict=True))
        print("  ".join(cells).rstrip())


def _trace(args: argparse.Namespace) -> int:
    from situ import __version__
    from situ.engine.trace_file import TraceFile
    from situ.rehearse.mcap_file import heading

    with connect(args, args.role) as board, board.trace(args.since) as events:
        said = board.documents()
        head = heading(said.project, said.files, __version__, masked=args.role == "viewer")
        if args.record is not None:
            documents = {} if head.masked else said.files
            return _record(args, board, events, TraceFile(args.record, head, documents))
        for event in _coming(args, board, events):
            _print(event)
    return 0


def _record(
    args: argparse.Namespace,
    board: Board,
    events: Following[dict[str, Any]],
    file: TraceFile,
) -> int:
    flushed = time.monotonic()
    try:
        for event in _coming(args, board, events, file.flush):
            file.add(event)
            if time.monotonic() - flushed > PATIENCE:
                flushed = time.monotonic()
                file.flush()
    finally:
        file.close()
    return 0


def _coming(
    args: argparse.Namespace,
    board: Board,
    following: Following[T],
    idle: Callable[[], None] = lambda: None,
) -> Iterator[T]:
    """What comes, until the robot ends. One that was killed is waited for: it may come back.

    idle: called while nothing comes."""
    while True:
        item = following.next(PATIENCE)
        if item is not None:
            yield item
            continue
        idle()
        if board.stopped and not args.wait:
            print(f"situ: {args.at}: the robot has ended", file=sys.stderr)
            return


def _say(tag: str, value: Any) -> None:
    import msgspec

    print(tag, msgspec.json.encode(value).decode(), flush=True)
