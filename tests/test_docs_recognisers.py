"""Both programs of docs/recognisers.md, against ``situ run examples/conversation``."""

from __future__ import annotations

import json
import os
import queue
import re
import select
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.live_trace import DEADLINE, find

import situ

ROOT = Path(__file__).parent.parent
PAGE = (ROOT / "docs" / "recognisers.md").read_text("utf-8")
PROGRAMS = dict(re.findall(r"```python\n# (\w+\.py)\n(.*?)```", PAGE, re.DOTALL))

SPD_SAY = """#!/bin/sh
case "$*" in *--cancel) exit 0 ;; esac
for text; do :; done
echo "$text" > "$0.begun"
read x < "$0.end"
"""
"""A voice that tells what it begins to say, and speaks until it is told that it has been heard."""

ARECORD = """#!/bin/sh
exec cat "$0.sound"
"""

VOSK = '''
"""Behaves like vosk, but for the sound: a chunk is a text, or silence."""
import json

def Model(path):
    return path

class KaldiRecognizer:
    def __init__(self, model, rate, grammar):
        self.phrases = json.loads(grammar)
    def SetWords(self, on):
        pass
    def AcceptWaveform(self, sound):
        self.said = sound.decode().strip()
        return bool(self.said)
    def Result(self):
        if self.said not in self.phrases:
            return json.dumps({"text": ""})
        words = [{"word": one, "conf": 0.8} for one in self.said.split()]
        return json.dumps({"text": self.said, "result": words})
'''


HELLO = "Hello. I am glad to see you. Shall we talk a little?"
GLAD = "I am glad. A good night makes a good day."


class Line:
    """A named pipe that is written into, whether or not somebody reads yet."""

    def __init__(self, path: Path) -> None:
        os.mkfifo(path)
        self._end = os.open(path, os.O_RDWR)

    def write(self, data: bytes) -> None:
        os.write(self._end, data)

    def read(self) -> str:
        """What has been written into it since, at least a line. Raises AssertionError."""
        data = b""
        while not data.endswith(b"\n"):
            assert select.select([self._end], [], [], DEADLINE)[0], f"no line, but {data!r}"
            data += os.read(self._end, 4096)
        return data.decode()

    def close(self) -> None:
        os.close(self._end)


class Robot:
    """The example with a voice that takes its time, and the programs of the page beside it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for name, text in {"spd-say": SPD_SAY, "arecord": ARECORD, "vosk.py": VOSK}.items():
            (folder / name).write_text(text, "utf-8")
            (folder / name).chmod(0o755)
        self.begun = Line(folder / "spd-say.begun")
        self.voice = Line(folder / "spd-say.end")
        self.sound = Line(folder / "arecord.sound")
        self._programs: list[subprocess.Popen[str]] = []
        free = ("--endpoint", "tcp://127.0.0.1:0", "--state", str(folder / "state"))
        speech = ("--speech", "speech-dispatcher")
        self.process = self._start(
            "-m", "situ", "run", "examples/conversation", "--json", *free, *speech
        )
        self.endpoint: str = json.loads(self.line(self.process))["requests"]
        for name, text in PROGRAMS.items():
            text = text.replace("situ.connect(", f'situ.connect("{self.endpoint}", ')
            (folder / name).write_text(text, "utf-8")

    def _start(self, *arguments: str) -> subprocess.Popen[str]:
        environment = dict(os.environ) | {
            "PATH": f"{self.folder}:{os.environ['PATH']}",
            # There is a sound server, as far as anybody can tell.
            "PULSE_SERVER": "tcp:127.0.0.1:1",
        }
        pipe = subprocess.PIPE
        started = subprocess.Popen(
            [sys.executable, *arguments],
            cwd=ROOT,
            env=environment,
            stdin=pipe,
            stdout=pipe,
            stderr=pipe,
            text=True,
        )
        self._programs.append(started)
        return started

    def hear(self, text: str) -> None:
        """Has the voice end this text. One that has been cut off may still be about to go, and
        would take its end."""
        said = ""
        while not said.endswith(f"{text}\n"):
            said = self.begun.read()
        self.voice.write(b"end\n")

    def start(self, name: str) -> subprocess.Popen[str]:
        return self._start(str(self.folder / name))

    @staticmethod
    def line(program: subprocess.Popen[str]) -> str:
        """The next line that a program prints."""
        said: queue.Queue[str] = queue.Queue()
        assert program.stdout is not None
        out = program.stdout
        reader = threading.Thread(target=lambda: said.put(out.readline()))
        reader.start()
        try:
            return said.get(timeout=DEADLINE)
        finally:
            if not said.empty() or program.poll() is not None:
                reader.join()

    def close(self) -> None:
        # What records ends with its sound, and who listens to it too.
        self.sound.close()
        self.begun.close()
        self.voice.close()
        for program in reversed(self._programs):
            program.terminate()
            program.communicate(timeout=DEADLINE)


@pytest.fixture
def robot(tmp_path: Path) -> Iterator[Robot]:
    running = Robot(tmp_path)
    yield running
    running.close()


def until(listen: Any, phrase: str | None) -> list[str]:
    """What stands at ``listen`` when the phrase does; None: when nothing does."""
    end = time.monotonic() + DEADLINE
    while (left := end - time.monotonic()) > 0:
        change = listen.next(left)
        value = change.value or [] if change is not None else []
        if change is not None and (phrase in value if phrase else not value):
            return list(value)
    raise AssertionError(f"never listened for {phrase}")


def say(ears: subprocess.Popen[str], text: str) -> None:
    assert ears.stdin is not None
    ears.stdin.write(f"{text}\n")
    ears.stdin.flush()


def test_both_programs_of_the_page_are_run_here() -> None:
    assert PAGE.count("```python") == len(PROGRAMS) == 2


def test_the_worked_recogniser_is_a_page_long() -> None:
    assert len([line for line in PROGRAMS["ears.py"].splitlines() if line]) <= 20


def test_a_conversation_by_word_of_mouth(robot: Robot) -> None:
    with (
        situ.connect(robot.endpoint, timeout=DEADLINE) as board,
        board.trace() as events,
        board.watch("listen") as listen,
    ):
        ears = robot.start("ears.py")
        find(events, kind="connected", module="ears")
        # It is speaking still: nobody listens.
        until(listen, None)
        say(ears, "yes")
        assert robot.line(ears) == "nobody listens\n"
        assert board.get("heard") is None
        robot.hear(HELLO)
        assert {"yes please", "not now", "pardon"} <= set(until(listen, "yes please"))
        # Hard to hear: it asks once more, and hears nothing meanwhile.
        say(ears, "yes please?")
        assert "'yes please'" in robot.line(ears)
        find(events, kind="event", name="notunderstood")
        until(listen, None)
        robot.hear(HELLO)
        until(listen, "yes please")
        say(ears, "Yes, please!")
        find(events, kind="transition", event="clickYes", to="2")
        # The next question may be broken in upon.
        until(listen, "very well")
        say(ears, "very well")
        find(events, kind="cancelled", action="speech")
        find(events, kind="transition", event="clickYes", to="3")
        assert ears.stdin is not None
        ears.stdin.close()
        ears.stdin = None
        find(events, kind="lost", module="ears")
        robot.hear(GLAD)
        # The same with sound, and a recogniser that knows what may be said.
        until(listen, "very much")
        robot.start("ears_vosk.py")
        find(events, kind="connected", module="ears")
        for said in ("", "something else", "very much"):
            robot.sound.write(said.encode().ljust(4000))
        heard = find(events, kind="data", tag="heard")
        assert heard["value"] == {"text": "very much", "confidence": 0.8}
        find(events, kind="transition", event="clickYes", to="6")
