"""What was recorded when the core was killed under load: nothing that was acknowledged is missing,
and every file is decided again by itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

import situ
from situ.rehearse.recorded import Line, again, read

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0


def test_a_kill_takes_nothing_from_the_recordings(runtime: Runtime) -> None:
    file = runtime.state.with_suffix(".mcap")
    runtime.start("--record", str(file))
    acknowledged = 0
    with situ.connect(runtime.endpoint, timeout=DEADLINE) as board:
        for killed in range(3):
            for _ in range(200):
                board.set("count", acknowledged)
                acknowledged += 1
            if killed < 2:
                runtime.kill()
                runtime.start("--record", str(file))
    runtime.stop()
    named = [file, *(file.with_stem(f"{file.stem}-{n}") for n in (2, 3))]
    ring = sorted((runtime.state / "ring").glob("*.mcap"))
    assert len(ring) == 3
    for recordings in (named, ring):
        told: dict[int, object] = {}
        for one in recordings:
            assert again(read(one), str(one)) is None
            for piece in read(one):
                if isinstance(piece, Line):
                    event = msgspec.json.decode(piece.text)
                    told[event["seq"]] = event.get("value") if event["kind"] == "data" else None
        # Without a gap, and each of them once.
        assert sorted(told) == list(range(1, len(told) + 1))
        counted = [value for _, value in sorted(told.items()) if isinstance(value, int)]
        assert [value for value in counted if value][-acknowledged + 1 :] == list(
            range(1, acknowledged)
        )
