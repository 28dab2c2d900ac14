"""What the robot says in a rehearsal: shown for as long as it lasts, and heard by who wants to."""

from __future__ import annotations

import os
import wave
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QFileSystemWatcher, QObject, Qt, SignalInstance
from PySide6.QtTest import QSignalSpy

from situ.document.spoken import estimate

HELLO = "Hello. I am glad to see you. Shall we talk a little?"
SLEEP = "Did you sleep well?"


def until(told: SignalInstance, true: Callable[[], bool]) -> None:
    """Waits for it, judging at each coming of the signal."""
    spy = QSignalSpy(told)
    while not true():
        assert spy.wait(20_000), "it did not come"


class Voice:
    """An espeak-ng that speaks until it is let end, and remembers what it was given."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, parent: QObject) -> None:
        self._folder = folder / "voice"
        self._folder.mkdir()
        self._breath = self._folder / "breath"
        os.mkfifo(self._breath)
        # Held open both ways: neither side ever waits for the other to open it.
        self._lungs = os.open(self._breath, os.O_RDWR)
        (folder / "bin").mkdir()
        program = folder / "bin" / "espeak-ng"
        program.write_text(
            f'#!/bin/sh\ncd "{self._folder}"; n=$(ls | wc -l)\n'
            'echo "$@" > new; cat >> new; mv new said.$n; read _ < breath\n'
        )
        program.chmod(0o755)
        monkeypatch.setenv("PATH", str(folder / "bin"), prepend=os.pathsep)
        self._watch = QFileSystemWatcher([str(self._folder)], parent)

    @property
    def said(self) -> list[str]:
        """What it was given to say, with how, in order."""
        return [file.read_text() for file in sorted(self._folder.glob("said.*"))]

    def wait(self, texts: int) -> list[str]:
        until(self._watch.directoryChanged, lambda: len(self.said) >= texts)
        return self.said

    def end(self) -> None:
        """What it says is over."""
        os.write(self._lungs, b"\n")

    def close(self) -> None:
        self._watch.deleteLater()
        os.close(self._lungs)


@pytest.fixture
def voice(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, qt: Any) -> Iterator[Voice]:
    made = Voice(tmp_path, monkeypatch, qt)
    yield made
    made.close()


def test_what_the_robot_says_is_shown_with_how_long_it_still_lasts(desk: Any) -> None:
    used = desk("conversation")
    says = used.desk.says
    assert says.words.text() == f"“{HELLO}”"
    whole = estimate(HELLO)
    assert says.left.text() == f"{whole:.1f} s left"
    used.go_on(1)
    assert says.left.text() == f"{whole - 1:.1f} s left"
    # As long as a robot without a voice takes, not a moment longer.
    used.go_on(whole - 1)
    assert says.words.text() == "The robot says nothing"
    assert says.left.text() == ""
    # Its rate counts as it does on the robot.
    used.desk.ensureWidgetVisible(used.desk.other)
    used.studio.fill(used.desk.other, "speech.rate = 50")
    used.touch("YES")
    assert says.words.text() == f"“{SLEEP}”"
    assert says.left.text() == f"{estimate(SLEEP, 50):.1f} s left"


def test_it_is_heard_once_somebody_wants_to_and_one_text_after_the_other(
    voice: Voice, desk: Any
) -> None:
    used = desk("conversation")
    says = used.desk.says
    assert not says.sound.isChecked()
    assert not used.desk.sounding.on
    used.studio.click(says.sound)
    assert voice.wait(1) == [f"-v en --stdin\n{HELLO}"]
    # This voice is slow: the robot has said all of it, and speaks again.
    used.go_on(6)
    used.desk.ensureWidgetVisible(used.desk.other)
    used.studio.fill(used.desk.other, "speech.rate = 120")
    used.touch("YES")
    assert len(voice.said) == 1
    voice.end()
    assert voice.wait(2)[1:] == [f"-v en -s 210 --stdin\n{SLEEP}"]
    assert used.desk.sounding.talks
    # What is cut off by another state is silent at once.
    used.touch("YES")
    assert voice.wait(3)[2].endswith("A good night makes a good day.")
    used.studio.click(says.sound)
    assert not used.desk.sounding.talks


def test_nothing_is_heard_while_time_stands_or_runs_and_after_the_end(
    voice: Voice, desk: Any
) -> None:
    used = desk("conversation")
    sounding, clock = used.desk.sounding, used.desk.clock
    used.studio.click(used.desk.says.sound)
    voice.wait(1)
    used.studio.click(clock.pause)
    assert not sounding.talks
    used.studio.click(clock.paces.button("10"))
    used.touch("YES")
    assert not sounding.talks
    used.studio.click(clock.paces.button("1"))
    used.touch("YES")
    voice.wait(2)
    used.studio.key(Qt.Key.Key_F5, Qt.KeyboardModifier.ShiftModifier)
    assert not sounding.talks
    used.studio.key(Qt.Key.Key_F5)
    voice.wait(3)
    used.window.close()
    assert not sounding.talks


def test_without_a_voice_it_is_said_in_a_line(
    desk: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    used = desk("conversation")
    says = used.desk.says
    assert not says.unheard.isVisible()
    used.studio.click(says.sound)
    assert says.unheard.isVisible()
    assert "espeak-ng is not installed" in says.unheard.text()
    assert not says.sound.isChecked()


@pytest.mark.espeak
def test_espeak_says_what_the_robot_says(
    espeak: str, desk: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    heard = tmp_path / "heard.wav"
    (tmp_path / "bin").mkdir()
    into_a_file = tmp_path / "bin" / "espeak-ng"
    into_a_file.write_text(f'#!/bin/sh\nexec {espeak} -w "{heard}" "$@"\n')
    into_a_file.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path / "bin"), prepend=os.pathsep)
    used = desk("conversation")
    used.studio.click(used.desk.says.sound)
    until(used.desk.sounding.ended, lambda: not used.desk.sounding.talks)
    assert used.desk.says.unheard.text() == ""
    with wave.open(str(heard)) as sound:
        seconds = sound.getnframes() / sound.getframerate()
    # It takes about as long as the rehearsal reckons.
    assert seconds == pytest.approx(estimate(HELLO), rel=0.5)
