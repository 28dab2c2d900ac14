"""``situ compare``: where two recorded runs part, and what each robot did there."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.rehearse.recording import Fields


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "compare",
        help="where two runs part: what each robot did there",
        description="Compares what two robots did: states, situations, who holds each resource, "
        "what moves it, and what is asked of the world outside. When they did it does not count. "
        "Exit status 0 when they did the same, 1 when not, 2 when one can not be read.",
    )
    parser.add_argument("first", metavar="A", help="a recording (.mcap) or a trace (.jsonl)")
    parser.add_argument("second", metavar="B", help="another one")
    parser.add_argument("--project", metavar="P", help="the project that ran, for names of states")
    parser.add_argument(
        "--json", action="store_true", help="a list of {at, strands, first, second}"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    import msgspec

    from situ.document.ready import load_ready
    from situ.rehearse.comparing import alike
    from situ.rehearse.deeds import Deeds
    from situ.rehearse.parting import lines, told
    from situ.rehearse.recording import read_trace
    from situ.rehearse.telling import Teller

    teller = Teller(load_ready(args.project) if args.project is not None else None)
    runs: list[tuple[Deeds, dict[int, Fields]]] = []
    for path in (args.first, args.second):
        deeds, events = Deeds(), read_trace(path)
        for event in events:
            deeds.add(event)
        runs.append((deeds, {event["seq"]: event for event in events}))
    (first, ones), (second, others) = runs
    found = [
        told(one, (teller, teller), (ones.__getitem__, others.__getitem__))
        for one in alike(first, second).differences
    ]
    if args.json:
        print(msgspec.json.format(msgspec.json.encode(found), indent=2).decode())
        return 1 if found else 0
    for parting in found:
        print("\n".join(lines(parting, _names(args.first, args.second))))
    if not found:
        print("They did the same.")
    return 1 if found else 0


def _names(first: str, second: str) -> tuple[str, str]:
    """The files' names, where these tell them apart."""
    short = Path(first).name, Path(second).name
    return short if short[0] != short[1] else (first, second)
