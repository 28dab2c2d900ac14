"""Unsaved changes kept while one draws: how long the window waits meanwhile."""

from __future__ import annotations

import contextlib
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path

from tests.benchmarks import documents
from tests.benchmarks.drawing import qt
from tests.benchmarks.editing import PROJECT
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

SIZE = 5_000
FRAME = 16.0
"""Milliseconds: a frame at 60 a second."""


@contextlib.contextmanager
def _keeping() -> Iterator[Mapping[str, Sample]]:
    from msgspec.structs import replace

    from situ.document.rbd import Application
    from situ_studio.edits import edit
    from situ_studio.files.recovery import Recovery
    from situ_studio.looks.theme import LIGHT
    from situ_studio.panels.notice import Notice
    from situ_studio.project.session import Session

    with tempfile.TemporaryDirectory() as scratch, qt() as app:
        folder = Path(scratch)
        (folder / "situ.toml").write_text(PROJECT)
        (folder / "dialogue.rbd.xml").write_bytes(documents.dialogue(SIZE))
        session, notice = Session(), Notice(LIGHT)
        session.open(folder)
        recovery = Recovery(session, folder / "recovery", notice)
        (file,) = session.files
        turns = iter(range(1_000_000))

        def rename() -> None:
            document = session.document(file)
            assert isinstance(document, Application)
            state = replace(document.states[7], name=f"another {next(turns)}")
            states = (*document.states[:7], state, *document.states[8:])
            session.commit(file, replace(document, states=states), "Rename")

        def longest() -> float:
            """The longest turn of the loop, ms, until the change is kept."""
            rename()
            app.processEvents()
            most, last = 0.0, time.perf_counter()
            recovery._keep_soon()
            while recovery._worker.is_busy:
                app.processEvents()
                now = time.perf_counter()
                most, last = max(most, now - last), now
            return 1e3 * most

        def written(times: int) -> None:
            value = session.value(file)
            assert value is not None
            for _ in range(times):
                edit.write(value)

        longest()
        try:
            yield {"longest": longest, "write": each(written, CPU, unit=1e-3)}
        finally:
            recovery.forget()
            for worker in (recovery._worker, session.checker._worker):
                worker.end()


BENCHES = (
    Bench(
        "keeping",
        (
            Row(
                f"editor: the window waits while {SIZE:,} states are kept",
                "keeping",
                "longest",
                "write",
                "ms",
                Goal(FRAME, of="ours"),
            ),
        ),
        _keeping,
    ),
)
