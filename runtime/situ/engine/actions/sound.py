"""Sounds: played by a player that the machine has, else as long as they would last.

The length of WAV, Ogg (Vorbis, Opus) and MP3 files is read from the file; one
that can not be read counts as ``UNKNOWN`` seconds.
"""

from __future__ import annotations

import logging
import os
import shutil
import struct
from collections.abc import Mapping
from pathlib import Path

from situ.engine.actions import ActionFailed
from situ.engine.clock import Clock, pause
from situ.engine.process import run

UNKNOWN = 1.0

# Program, its options, and the endings that it can play.
PLAYERS = (
    ("ffplay", ("-nodisp", "-autoexit", "-loglevel", "error", "--"), None),
    ("pw-play", (), (".wav", ".ogg", ".oga", ".flac", ".mp3")),
    ("paplay", (), (".wav", ".ogg", ".oga", ".flac")),
    ("aplay", ("-q",), (".wav",)),
)

# What plays samples (16 bit, one channel) from standard input; {} is how many a second.
RAW_PLAYERS = (
    ("pacat", ("--playback", "--raw", "--format=s16le", "--channels=1", "--rate={}")),
    ("aplay", ("-q", "-t", "raw", "-f", "S16_LE", "-c", "1", "-r", "{}", "-")),
)


class Player:
    """Plays sound files. audible: whether there is a sound device."""

    def __init__(self, audible: bool, clock: Clock, log: logging.Logger) -> None:
        self.audible = audible
        self._clock = clock
        self._log = log

    async def play(self, file: Path) -> None:
        """Returns when the sound was heard to its end, or would have been.

        Raises ActionFailed where the file can not be read.
        """
        begun = self._clock.time()
        try:
            seconds = length(file)
        except OSError as error:
            raise ActionFailed(
                f"the sound {file.name} can not be read: {error.strerror}"
            ) from error
        if seconds is None:
            self._log.warning("how long %s lasts can not be read: %g s", file.name, UNKNOWN)
        argv = player(file) if self.audible else None
        if argv is not None:
            try:
                ended = await run(argv)
            except OSError as error:
                raise ActionFailed(f"{argv[0]} can not be started: {error.strerror}") from error
            if ended.status == 0:
                return
            self._log.warning("%s could not play %s: %s", argv[0], file.name, ended.complaint)
        await pause(self._clock, begun + (seconds or UNKNOWN) - self._clock.time())


def player(file: Path) -> list[str] | None:
    """What plays this file on this machine: program and arguments, or None."""
    for program, options, endings in PLAYERS:
        found = shutil.which(program)
        if found and (endings is None or file.suffix.lower() in endings):
            return [found, *options, str(file.resolve())]
    return None


def raw_player(rate: int) -> list[str] | None:
    """What plays raw samples from standard input on this machine, ``rate`` of them a second."""
    for program, options in RAW_PLAYERS:
        found = shutil.which(program)
        if found:
            return [found, *(option.format(rate) for option in options)]
    return None


def audible(environment: Mapping[str, str] = os.environ, devices: Path = Path("/dev/snd")) -> bool:
    """Whether somebody could hear something: a sound server, or a playback device."""
    if environment.get("PULSE_SERVER"):
        return True
    runtime = environment.get("XDG_RUNTIME_DIR")
    if runtime and any((Path(runtime) / s).exists() for s in ("pulse/native", "pipewire-0")):
        return True
    return any(devices.glob("pcm*p"))


def length(file: Path) -> float | None:
    """Seconds of a sound file; None for kinds that are not understood. Raises OSError."""
    with file.open("rb") as stream:
        head = stream.read(65_536)
        size = stream.seek(0, os.SEEK_END)
        stream.seek(max(0, size - 65_536))
        tail = stream.read()
    if head[:4] == b"RIFF" and head[8:12] == b"WAVE":
        return _wave(head)
    if head[:4] == b"OggS":
        return _ogg(head, tail)
    return _mp3(head, size)


def _wave(head: bytes) -> float | None:
    place, rate = 12, 0
    while place + 8 <= len(head):
        kind, size = head[place : place + 4], struct.unpack_from("<I", head, place + 4)[0]
        if kind == b"fmt " and place + 20 <= len(head):
            rate = struct.unpack_from("<I", head, place + 16)[0]
        if kind == b"data":
            return float(size / rate) if rate else None
        place += 8 + size + size % 2
    return None


def _ogg(head: bytes, tail: bytes) -> float | None:
    if (vorbis := head.find(b"\x01vorbis")) >= 0 and len(head) >= vorbis + 16:
        rate = struct.unpack_from("<I", head, vorbis + 12)[0]
    elif b"OpusHead" in head:
        rate = 48_000
    else:
        return None
    last = tail.rfind(b"OggS")
    if last < 0 or len(tail) < last + 14 or not rate:
        return None
    return float(struct.unpack_from("<q", tail, last + 6)[0] / rate)


_MP3_KILOBITS = (0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 0)


def _mp3(head: bytes, size: int) -> float | None:
    """By the first frame's bit rate (MPEG 1, layer III), as if it were constant."""
    start = 0
    if head[:3] == b"ID3" and len(head) >= 10:
        start = 10 + sum(
            (byte & 0x7F) << shift for byte, shift in zip(head[6:10], (21, 14, 7, 0), strict=True)
        )
    if len(head) < start + 3 or head[start] != 0xFF or head[start + 1] & 0xFE != 0xFA:
        return None
    kilobits = _MP3_KILOBITS[head[start + 2] >> 4]
    return (size - start) * 8 / (kilobits * 1000) if kilobits else None
