"""``situ replay``: what was recorded, as the trace that it was, and decided once more."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.rehearse.recorded import Piece


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
    parser.add_argument(
        "--role",
        choices=("operator", "viewer"),
        default="operator",
        help="who is to see it: for a viewer private values are •••, and inputs are left out; "
        "operator unless given",
    )
    parser.add_argument(
        "-o", dest="out", type=Path, metavar="OUT.mcap", help="make another recording of it here"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from situ.errors import UsageError

    if args.decide and (args.role == "viewer" or args.out is not None):
        raise UsageError("--decide goes neither with --role viewer nor with -o")
    if args.decide:
        return _decide(args)
    return _print(args) if args.out is None else _export(args)


def _pieces(args: argparse.Namespace) -> Iterator[Piece]:
    """What this role may see of it."""
    from situ.rehearse.masking import masked
    from situ.rehearse.recorded import Torn, read

    found = read(args.recording)
    for piece in masked(found) if args.role == "viewer" else found:
        if isinstance(piece, Torn):
            torn = "it breaks off here: the robot still runs, or was killed"
            _say(args, "it is damaged from here on" if piece.damaged else torn)
        else:
            yield piece


def _print(args: argparse.Namespace) -> int:
    from situ.rehearse.recorded import Line

    for piece in _pieces(args):
        if isinstance(piece, Line):
            sys.stdout.buffer.write(piece.text + b"\n")
    sys.stdout.buffer.flush()
    return 0


def _export(args: argparse.Namespace) -> int:
    from situ.engine.record import OneFile
    from situ.engine.recording_copy import write
    from situ.errors import UsageError

    if args.out.exists() and args.out.samefile(args.recording):
        raise UsageError(f"{args.out}: this is the recording itself; give another file")
    try:
        write(OneFile(args.out), _pieces(args))
    except OSError as error:
        raise UsageError(f"{args.out}: {error.strerror or error}") from None
    if args.role == "viewer":
        _say(args, f"{args.out} is masked: it can be looked at, not replayed with --decide")
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
