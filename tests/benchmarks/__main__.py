"""``make bench``: prints the table of all benches and writes ``bench.json``."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

import msgspec
from tests.benchmarks import (
    deciding,
    documents_read,
    drawing,
    editing,
    keeping,
    live,
    matrix,
    messages,
    problems,
    screens,
    scripts,
    watching,
    window,
)
from tests.benchmarks.harness import ROUNDS, Bench, Missing, Result, measure, table

BENCHES: tuple[Bench, ...] = (
    *documents_read.BENCHES,
    *deciding.BENCHES,
    *drawing.BENCHES,
    *editing.BENCHES,
    *matrix.BENCHES,
    *problems.BENCHES,
    *screens.BENCHES,
    *scripts.BENCHES,
    *keeping.BENCHES,
    *window.BENCHES,
    *watching.BENCHES,
    *messages.BENCHES,
    *live.BENCHES,
)

UNBUILT: dict[str, str] = {}
"""Figures that have no row yet; docs/performance.md names them too."""

FIGURES = (
    "round trip",
    "get",
    "notifications",
    "message",
    "situations",
    "transitions",
    "load",
    "memory",
    "frame",
    "open",
    "edit",
    "layout",
    "matrix",
    "problems",
    "keeping",
    "start",
    "events",
    *UNBUILT,
)
"""What the project is measured by; every row is ``of`` one of them."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Exit status 1 where something could not be measured though nothing is missing for it."""
    parser = argparse.ArgumentParser(prog="make bench ARGS=…", description=__doc__)
    parser.add_argument("-k", metavar="WORD", default="", help="only benches and rows with it")
    parser.add_argument("--rounds", type=int, default=ROUNDS, metavar="N", help="5 or more")
    parser.add_argument("--json", type=Path, default=Path("bench.json"), metavar="FILE")
    args = parser.parse_args(arguments)
    results: list[Result] = []
    failed = False
    for bench in chosen(BENCHES, args.k):
        print(f"{bench.name} …", file=sys.stderr, flush=True)
        try:
            results += measure(bench, args.rounds)
        except Missing as missing:
            print(f"{bench.name}: left out: {missing}", file=sys.stderr)
        except Exception as error:
            failed = True
            print(f"{bench.name}: {type(error).__name__}: {error}", file=sys.stderr)
    print(table(results))
    python, load = sys.version.split()[0], os.getloadavg()[0]
    print(f"\nPython {python}, {os.cpu_count()} cores, load {load:.1f}")
    args.json.write_bytes(msgspec.json.format(msgspec.json.encode(results)) + b"\n")
    return 1 if failed else 0


def chosen(benches: Sequence[Bench], word: str) -> list[Bench]:
    """Those whose name, or one of whose rows' names, has the word in it; of these all rows."""
    word = word.lower()
    return [
        bench
        for bench in benches
        if word in bench.name.lower() or any(word in row.name.lower() for row in bench.rows)
    ]


if __name__ == "__main__":
    sys.exit(main())
