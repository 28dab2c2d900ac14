"""``situ replay``: what was recorded, as the trace that it was, and decided once more."""

from __future__ import annotations

import argparse
import sys
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "replay",
        help="print the trace of a recording, or decide it again",
        description="Prints the trace of a recording (situ run --record, the files in ring/ of the "
        "robot's state folder), one JSON object a line. With --decide its inputs are decided "
        "again: exit status 1 where the trace is another than was recorded.",
    )
    parser.add_argument("recording", metavar="F.mcap", help="the recording")
    parser.add_argument(
        "--decide",
        action="store_true",
        help="feed the inputs to the robot's decisions again and compare the traces",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    return _decide(args) if args.decide else _print(args)


def _print(args: argparse.Namespace) -> int:
    from situ.rehearse.recorded import Line, Torn, read

    for piece in read(args.recording):
        if isinstance(piece, Line):
            sys.stdout.buffer.write(piece.text + b"\n")
        elif isinstance(piece, Torn):
            _say(args, "it breaks off here: the robot still runs, or was killed")
    sys.stdout.buffer.flush()
    return 0


def _decide(args: argparse.Namespace) -> int:
    from situ import __version__
    from situ.rehearse.recorded import Heading, again, read

    heading = next((one for one in read(args.recording) if isinstance(one, Heading)), Heading())
    difference = again(read(args.recording), args.recording)
    if difference is None:
        print("decided again, all is as recorded")
        return 0
    if heading.version != __version__:
        _say(args, f"recorded by situ {heading.version}, this is {__version__}")
    _say(args, str(difference))
    return 1


def _say(args: argparse.Namespace, message: str) -> None:
    print(f"{args.recording}: {message}", file=sys.stderr)
