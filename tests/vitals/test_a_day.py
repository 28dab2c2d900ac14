"""A whole day of examples/vitals at 1,000 times its speed: ``situ run`` as a process, over its real
sockets, and the ward's records as another, in their SQLite file.

The clock is the scenario's, as ``situ run --script`` has it: leases, devices and web services have
a time of their own, which nothing can hurry. So when something ends is the scenario's to say, as
the same ward said it to the rehearsal; whatever the robot has written down is written for real.
Only with ``SITU_SOAK=1`` (``make soak``). What is random is seeded: ``SITU_SEED``.
"""

from __future__ import annotations

import json
import os
import socket
import sqlite3
import subprocess
import sys
import urllib.error
import urllib.request
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.vitals.days import BUSIEST, HOUR, SECOND, VITALS, Ward

from situ.decide.inputs import AnyInput
from situ.decide.trace import TraceEvent, to_line
from situ.document.ready import load_ready
from situ.rehearse.recorded import bare
from situ.rehearse.scenario import End, write
from situ.rehearse.simulate import Rehearsal

SPEED = 1000
DAY = 24 * HOUR
MORE = 10.0
"""MB that the rest of the day may need, from its second hour to its last."""

pytestmark = pytest.mark.skipif(not os.environ.get("SITU_SOAK"), reason="only in make soak")


class Process:
    """What the system knows of one that runs."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        self._proc = Path(f"/proc/{process.pid}")

    @property
    def memory(self) -> float:
        """MB, now."""
        status = (self._proc / "status").read_text("utf-8")
        return int(status.partition("VmRSS:")[2].split()[0]) / 1024

    @property
    def handles(self) -> int:
        return len(list((self._proc / "fd").iterdir()))


class Records:
    """The ward's, over HTTP as the robot asks them."""

    def __init__(self, folder: Path) -> None:
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        command = [sys.executable, "-m", "ward_records", str(folder), "--port", str(port)]
        self._folder = folder
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, cwd=VITALS)
        assert self.process.stdout is not None
        self._url = self.process.stdout.readline().decode().partition("/?")[0]
        tokens = json.loads((folder / "tokens.json").read_text("utf-8"))
        self._token = tokens["service"]

    def keep(self, reading: dict[str, Any]) -> int:
        """The status of the answer."""
        asked = urllib.request.Request(
            f"{self._url}/readings",
            data=json.dumps({"reading": reading}).encode(),
            headers={"Authorization": f"Bearer {self._token}"},
        )
        try:
            with urllib.request.urlopen(asked, timeout=30) as answer:
                return int(answer.status)
        except urllib.error.HTTPError as refused:
            return refused.code

    def kept(self) -> Counter[str]:
        """How much of each kind stands in the file."""
        with sqlite3.connect(self._folder / "ward.db") as db:
            found = Counter(dict(db.execute("SELECT kind, count(*) FROM reading GROUP BY kind")))
            for kind, table in (("call", "call"), ("medication", "visit"), ("reminder", "telling")):
                found[kind] = db.execute(f"SELECT count(*) FROM {table}").fetchone()[0]
        return +found

    def stop(self) -> None:
        self.process.terminate()
        self.process.communicate(timeout=30)


@pytest.fixture
def records(tmp_path: Path) -> Iterator[Records]:
    made = Records(tmp_path / "records")
    try:
        yield made
    finally:
        made.stop()


def lived(seed: int) -> tuple[list[tuple[int, AnyInput | End]], list[bytes]]:
    """A day of the ward: all that came to the robot, and its trace in the rehearsal."""
    ward = Ward(seed)
    trace: list[bytes] = []

    def hear(events: list[TraceEvent]) -> None:
        trace.extend(map(to_line, events))
        ward.hear(events)

    robot = Rehearsal(load_ready(VITALS), hear)
    lines: list[tuple[int, AnyInput | End]] = []
    for at, given in ward.inputs(1):
        robot.give(given, at)
        lines.append((at, given))
    robot.advance(DAY * SECOND)
    assert ward.wrong == []
    return [*lines, (max(DAY * SECOND, lines[-1][0]), End())], trace


@pytest.mark.timeout(600)
def test_a_day_over_real_sockets_is_the_rehearsed_one_and_nothing_grows(
    records: Records, tmp_path: Path
) -> None:
    lines, rehearsed = lived(int(os.environ.get("SITU_SEED", "0")))
    script = tmp_path / "day.jsonl"
    script.write_bytes(write(lines))
    command = [
        *(sys.executable, "-m", "situ", "run", str(VITALS), "--services", "core"),
        *("--endpoint", "tcp://127.0.0.1:0", "--state", str(tmp_path / "state")),
        *("--script", str(script), "--speed", str(SPEED), "--trace", "-"),
    ]
    robot = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    assert robot.stdout is not None
    both = [Process(robot), Process(records.process)]
    asked: Counter[str] = Counter()
    moments: Counter[float] = Counter()
    problems: list[bytes] = []
    early: list[tuple[float, int]] = []
    late: list[tuple[float, int]] = []
    said = 0
    try:
        for line in robot.stdout:
            assert bare(line.rstrip(b"\n")) == rehearsed[said], said
            said += 1
            event = json.loads(line)
            moments[event["t"]] += 1
            if event["kind"] == "error":
                problems.append(line)
            if event["kind"] == "action" and event["name"] == "keepReading":
                reading = event["params"]["reading"]
                assert records.keep(reading) == 200, reading
                asked[reading["kind"]] += 1
            if not early and event["t"] > 2 * HOUR:
                early = [(one.memory, one.handles) for one in both]
            if not late and event["t"] > 23 * HOUR:
                late = [(one.memory, one.handles) for one in both]
    finally:
        robot.terminate()
        status = robot.wait(timeout=30)
        robot.stdout.close()
    print(f"{said} events, at most {max(moments.values())} at once; {dict(asked)}")
    print(
        f"MB, handles of the robot and the records: in the third hour {early}, in the last {late}"
    )
    assert (status, said, problems) == (0, len(rehearsed), [])
    assert max(moments.values()) < BUSIEST
    assert records.kept() == +asked
    assert {"call", "medication", "reminder"} <= set(asked)
    for (memory, handles), (more, still) in zip(early, late, strict=True):
        assert more - memory < MORE
        assert still <= handles
