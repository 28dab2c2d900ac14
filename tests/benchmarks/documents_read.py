"""Reading and checking a large application, beside the parse that nothing can do without."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from lxml import etree
from tests.benchmarks import documents
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

from situ.document.ready import load_ready

STATES = 10_000


@contextlib.contextmanager
def _reading() -> Iterator[Mapping[str, Sample]]:
    data = documents.dialogue(STATES)
    with tempfile.TemporaryDirectory(prefix="situ-bench-") as folder:
        file = Path(folder) / "dialogue.rbd.xml"
        file.write_bytes(data)
        yield {
            "load, validate": _times(lambda: load_ready(file)),
            "lxml's parse": _times(lambda: etree.fromstring(data)),
        }


def _times(read: Callable[[], object]) -> Sample:
    def work(times: int) -> None:
        for _ in range(times):
            read()

    return each(work, CPU, unit=1e-3)


BENCHES = (
    Bench(
        "load",
        (
            Row(
                f"load and validate an RBD of {STATES:,} states",
                "load",
                "load, validate",
                "lxml's parse",
                "ms",
                Goal(3.0),
            ),
        ),
        _reading,
    ),
)
