"""A robot looked at in the whole window: events as they come, a long run scrubbed, one opened."""

from __future__ import annotations

import contextlib
import random
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec
from tests.benchmarks.drawing import qt
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample

MANY, FEW = 1_000_000, 10_000
RATE = 1_000
"""Events a second."""
FRAMES = 30
"""Frames a second that are wanted of the window meanwhile."""
FRAME = 16.0
"""Milliseconds: a frame at 60 a second."""
SCRUBS = 60
"""Places of the cursor that are looked at, of which the slowest twentieth does not count."""


def run(count: int) -> Iterator[dict[str, Any]]:
    """A trace of so many events, ``RATE`` a second: a robot that goes through ten states."""
    state, seq = 1, 0
    while seq < count:
        then = state % 10 + 1
        ends = {"application": "reception", "cause": None}
        turn: list[dict[str, Any]] = [
            {"kind": "exit", "state": f"{state}", **ends},
            {"kind": "transition", "from": f"{state}", "to": f"{then}", "event": "go", **ends},
            {"kind": "enter", "state": f"{then}", **ends},
            {"kind": "authority", "resource": "head", "from": None, "to": f"m{then}"},
            {"kind": "situation", "from": f"s{state}", "to": f"s{then}"},
        ]
        for n in range(195):
            tag, value = f"sensor.s{n % 13}", (seq + n) % 97 / 7
            turn.append({"kind": "data", "tag": tag, "value": value, "writer": "sensor"})
        for event in turn:
            seq += 1
            yield {"cause": None, **event, "seq": seq, "t": seq / RATE}
        state = then


@contextlib.contextmanager
def _watching() -> Iterator[Mapping[str, Sample]]:
    from PySide6.QtCore import QSettings

    from situ.resources import example
    from situ_studio import main
    from situ_studio.live.log import TraceLog
    from situ_studio.live.recordings import Recording

    def log_of(count: int) -> TraceLog:
        log = TraceLog()
        log.add(run(count))
        return log

    with tempfile.TemporaryDirectory() as scratch, qt() as app:
        settings = QSettings(f"{scratch}/settings.ini", QSettings.Format.IniFormat)
        window = main.create_window(example("reception"), settings)
        window.resize(1440, 900)
        window.show()
        many, few, growing = log_of(MANY), log_of(FEW), log_of(FEW)
        coming = iter(list(run(FEW + RATE * 600))[FEW:])
        side, viewing = window.robot, window.robot.follower.viewing
        rng = random.Random(5)

        def show(log: TraceLog) -> None:
            if viewing.log is not log:
                recording = Recording(Path("run.mcap"), "reception", False, {}, log)
                side.follower.show_recording(recording)
                side.settle()
                window.bottom.choose("timeline")
                app.processEvents()

        def frame() -> float:
            began = CPU()
            app.processEvents()
            return CPU() - began

        def scrubbed(log: TraceLog) -> float:
            """The frame, ms, that 95 of 100 are not slower than."""
            show(log)
            took = []
            for _ in range(SCRUBS):
                t = rng.uniform(*viewing.span)
                began = CPU()
                viewing.seek(t)
                app.processEvents()
                took.append(CPU() - began)
            return 1e3 * sorted(took)[SCRUBS * 95 // 100]

        def came(events: int) -> float:
            """The longest frame of a second, ms, in each of which so many events come."""
            show(growing)
            viewing.show(growing, lambda: growing.lanes.end)
            longest = 0.0
            for _ in range(FRAMES):
                began = CPU()
                growing.add([next(coming) for _ in range(events)])
                viewing.moved.emit()
                longest = max(longest, CPU() - began + frame())
            return 1e3 * longest

        try:
            yield {
                "a million": lambda: scrubbed(many),
                "ten thousand": lambda: scrubbed(few),
                "events": lambda: came(-(-RATE // FRAMES)),
                "one event a frame": lambda: came(1),
            }
        finally:
            window.asked = True
            window.close()


@contextlib.contextmanager
def _opening() -> Iterator[Mapping[str, Sample]]:
    from mcap.writer import Writer
    from PySide6.QtCore import QEventLoop

    from situ.rehearse import recorded
    from situ_studio.live.recordings import ReadingRecording

    with tempfile.TemporaryDirectory() as scratch, qt():
        file = Path(scratch) / "run.mcap"
        with file.open("wb") as stream:
            writer: Any = Writer(stream)
            writer.start()
            writer.add_metadata("situ", {"heading": '{"runtime":"r","project":"p","file":"f"}'})
            channel = writer.register_channel("/trace", "json", 0)
            for event in run(MANY):
                writer.add_message(channel, int(event["t"] * 1e9), msgspec.json.encode(event), 0)
            writer.finish()

        def opened() -> float:
            reading, loop = ReadingRecording(), QEventLoop()
            reading.read.connect(loop.quit)
            reading.refused.connect(loop.quit)
            began = CPU()
            reading.start(file)
            loop.exec()
            return CPU() - began

        def decoded(pieces: Iterable[Any]) -> None:
            decode = msgspec.json.decode
            for piece in pieces:
                if type(piece) is recorded.Line:
                    decode(piece.text)

        def read() -> float:
            began = CPU()
            with file.open("rb") as stream:
                decoded(recorded.pieces(stream, str(file)))
            return CPU() - began

        yield {"opened": opened, "read and decoded only": read}


BENCHES = (
    Bench(
        "watching",
        (
            Row(
                f"editor: longest frame of a second in which {RATE:,} trace events come",
                "events",
                "events",
                "one event a frame",
                "ms",
                Goal(1000 / FRAMES, of="ours"),
            ),
            Row(
                f"editor: frame while {MANY:,} trace events are scrubbed through, 95 of 100",
                "events",
                "a million",
                "ten thousand",
                "ms",
                Goal(FRAME, of="ours"),
            ),
        ),
        _watching,
    ),
    Bench(
        "trace events, opening",
        (
            Row(
                f"editor: open a recording of {MANY:,} trace events",
                "events",
                "opened",
                "read and decoded only",
                "s",
                Goal(5.0, of="ours"),
            ),
        ),
        _opening,
    ),
)
