"""``kill -9`` of the core under load: nothing acknowledged is lost, nobody has to be restarted
(quality, *Faults*)."""

from __future__ import annotations

import json
import random
import threading
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import situ
from situ.engine.folder import StateFolder
from situ.errors import BlackboardError

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
BACK = 2.0
"""Seconds in which all clients are there again; asserted where nothing else runs."""


class Writer:
    """A client that sets a durable and another tag without pause, whatever happens to the core.

    Each acknowledgement must bring a version above the one before: else that one was lost.
    """

    def __init__(self, number: int, endpoint: str, acked: threading.Condition) -> None:
        self.durable, self.plain = f"pill.c{number}", f"plain.c{number}"
        self.count = 0
        self.at = 0.0
        self.versions: dict[str, int] = {}
        self.lost: list[str] = []
        self.error: BlackboardError | None = None
        self.fresh = False
        self._acked = acked
        self._stopped = False
        self._board = situ.connect(endpoint, timeout=DEADLINE)
        self._thread = threading.Thread(target=self._write)
        self._thread.start()

    def _write(self) -> None:
        value = 0
        while not self._stopped:
            value += 1
            try:
                versions = self._board.set({self.durable: value, self.plain: value})
            except BlackboardError as error:
                self.error = error
                return
            with self._acked:
                self._heard(versions)
                self._acked.notify_all()

    def _heard(self, versions: dict[str, int]) -> None:
        for tag, version in versions.items():
            before = self.versions.get(tag, 0)
            anew = self.fresh and tag == self.plain
            if version <= before and not anew:
                self.lost.append(f"{tag}: version {version} after {before}")
        self.versions = versions
        self.fresh = False
        self.count += 1
        self.at = time.monotonic()

    def stop(self) -> None:
        self._stopped = True
        self._thread.join()
        self._board.close()


class Load:
    """All writers together."""

    def __init__(self, endpoint: str, writers: int) -> None:
        self._acked = threading.Condition()
        self.writers = [Writer(number, endpoint, self._acked) for number in range(writers)]

    def wait(self, ready: Callable[[], bool]) -> None:
        with self._acked:
            assert self._acked.wait_for(lambda: ready() or any(self.errors()), DEADLINE)
        assert not any(self.errors())

    def errors(self) -> list[BlackboardError]:
        return [writer.error for writer in self.writers if writer.error is not None]

    def more(self, count: int) -> None:
        """Waits for so many more acknowledgements."""
        until = self.total + count
        self.wait(lambda: self.total >= until)

    @property
    def total(self) -> int:
        return sum(writer.count for writer in self.writers)

    def begins_anew(self) -> None:
        """Tags that are not durable begin anew with the next start."""
        with self._acked:
            for writer in self.writers:
                writer.fresh = True

    def back(self) -> list[float]:
        """Waits until every writer was acknowledged since the kill; when each was."""
        with self._acked:
            before = [writer.count for writer in self.writers]
        self.wait(lambda: all(w.count > n for w, n in zip(self.writers, before, strict=True)))
        return [writer.at for writer in self.writers]

    def stop(self) -> None:
        for writer in self.writers:
            writer.stop()


def test_nothing_acknowledged_is_lost_and_nobody_is_restarted(
    runtime: Runtime,
    chance: random.Random,
    often: Callable[[int, int], int],
    soaking: bool,
) -> None:
    core = ("--services", "core")
    runtime.start(*core)
    load = Load(runtime.endpoint, often(4, 20))
    starts, resynced = [], []
    with (
        situ.connect(runtime.endpoint, "nod", ["head"], timeout=DEADLINE) as nod,
        nod.authority("head") as head,
        situ.connect(runtime.endpoint, timeout=DEADLINE) as board,
        board.watch("pill.**") as changes,
    ):
        try:
            for kill in range(often(4, 50)):
                load.more(chance.randint(1, 200))
                runtime.kill()
                options = [*core]
                if kill % 3 == 2:
                    # Without its history: then it is durable.db alone that they survive by.
                    options.append("--fresh")
                    load.begins_anew()
                starts.append(runtime.start(*options))
                ready = time.monotonic()
                resynced += [max(at - ready, 0.0) for at in load.back()]
                assert head.wait(DEADLINE)
        finally:
            load.stop()
        assert [line for writer in load.writers for line in writer.lost] == []
        stands = board.entries("pill.*")
        last: dict[str, int] = {}
        while last != {tag: entry.version for tag, entry in stands.items()}:
            change = changes.next(DEADLINE)
            assert change is not None
            last[change.tag] = change.version
    assert runtime.stop() == 0
    assert max(resynced) <= BACK or not soaking
    print(
        f"\n{len(starts)} kills, {load.total} acknowledged sets of durable tags, 0 lost; "
        f"ready again in {max(starts):.2f} s, "
        f"{len(load.writers)} clients resynced in {max(resynced):.2f} s at the most"
    )


def test_the_trace_and_the_robot_go_on_over_a_kill(
    runtime: Runtime, chance: random.Random, tmp_path: Path
) -> None:
    file = tmp_path / "trace.jsonl"
    runtime.start("--trace", str(file))
    events: list[dict[str, Any]] = []
    news = threading.Condition()
    with situ.connect(runtime.endpoint, timeout=DEADLINE) as board:

        def heard(event: dict[str, Any]) -> None:
            with news:
                events.append(event)
                news.notify_all()

        def counted(more: int) -> int:
            """Waits until the robot has made more rounds; how many it has."""
            with news:
                assert news.wait_for(lambda: _rounds(events) > more, DEADLINE)
                return _rounds(events)

        board.trace(since=1, callback=heard)
        seen = 0
        for _ in range(2):
            for _ in range(chance.randint(1, 10)):
                board.publish("go")
            runtime.kill()
            runtime.start("--trace", str(file))
            # A new one, so that nothing is asked of the connection that was lost.
            with situ.connect(runtime.endpoint, timeout=DEADLINE) as other:
                other.publish("go")
            seen = counted(seen)
        rounds = board.get("rounds")
        counted(rounds - 1)
        seqs = [event["seq"] for event in events]
        with (
            situ.connect(runtime.endpoint, timeout=DEADLINE) as late,
            late.trace(since=1) as all_of_it,
        ):
            # Who begins to look only now sees it from its first event on.
            assert [_next(all_of_it)["seq"] for _ in seqs] == seqs
    # One run, of which no event came twice and none is missing.
    assert seqs == list(range(1, len(seqs) + 1))
    assert {json.loads(line)["seq"] for line in file.read_bytes().splitlines()} >= set(seqs)
    assert all(a["t"] <= b["t"] for a, b in pairwise(events))


def _next(events: Any) -> dict[str, Any]:
    event = events.next(DEADLINE)
    assert event is not None
    return dict(event)


def _rounds(events: list[dict[str, Any]]) -> int:
    counted = [e["value"] for e in events if e["kind"] == "data" and e["tag"] == "rounds"]
    return counted[-1] if counted else 0


def test_after_a_good_end_only_durable_tags_come_back(runtime: Runtime) -> None:
    runtime.start("--services", "core")
    with situ.connect(runtime.endpoint, timeout=DEADLINE) as board:
        board.set({"pill.a": "08:00", "pill.b": 1, "lamp": "on"})
        board.set("pill.b", None)
    assert runtime.stop() == 0
    runtime.start("--services", "core", "--sync")
    with situ.connect(runtime.endpoint, timeout=DEADLINE) as board:
        assert board.get("lamp") is None
        entry = board.entries("pill.a")["pill.a"]
        assert (entry.value, entry.version) == ("08:00", 1)
        assert board.set({"pill.a": "09:00", "pill.b": 2}) == {"pill.a": 2, "pill.b": 3}


def test_a_second_core_on_one_state_folder_says_so_and_ends(runtime: Runtime) -> None:
    first = StateFolder(runtime.state)
    status, said = runtime.start_in_vain()
    first.close()
    assert status == 2
    assert said.startswith(f"situ: {runtime.state}: another situ run keeps its state there; ")
    assert said.count("\n") == 1
