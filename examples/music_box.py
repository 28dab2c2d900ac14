"""Tunes of a music box: scores that belong to everybody, and what plays them."""

from __future__ import annotations

import math

RATE = 11_025
"""Samples a second."""
NOTES = {name: 2 ** (place / 12) for place, name in enumerate("C_D_EF_G_A_B")}

JOY = (
    "E4 E4 F4 G4 G4 F4 E4 D4 C4 C4 D4 E4 E4:1.5 D4:.5 D4:2 "
    "E4 E4 F4 G4 G4 F4 E4 D4 C4 C4 D4 E4 D4:1.5 C4:.5 C4:2"
)
"""Ode to Joy, Ludwig van Beethoven, 1824."""

LULLABY = (
    "E4:.5 E4:.5 G4:1.5 E4:.5 E4 G4:2 E4:.5 G4:.5 C5 B4:1.5 A4:.5 A4 G4 D4:.5 E4:.5 F4 D4 "
    "D4:.5 E4:.5 F4:2 D4:.5 F4:.5 B4:.5 A4:.5 G4 B4 C5:2 C4:.5 C4:.5 C5:2 A4:.5 F4:.5 G4:2 "
    "E4:.5 C4:.5 F4 G4 A4 G4:2 C4:.5 C4:.5 C5:2 A4:.5 F4:.5 G4:2 E4:.5 C4:.5 F4 E4 D4 C4:3"
)
"""Lullaby, Johannes Brahms, 1868."""

SAKURA = (
    "A4 A4 B4:2 A4 A4 B4:2 A4 B4 C5 B4 A4 B4:.5 A4:.5 F4:2 E4 C4 E4 F4 E4 E4:.5 C4:.5 B3:2 "
    "A4 B4 C5 B4 A4 B4:.5 A4:.5 F4:2 E4 C4 E4 F4 E4 E4:.5 C4:.5 B3:2 "
    "A4 A4 B4:2 A4 A4 B4:2 E4 F4 B4:.5 A4:.5 F4 E4:3"
)
"""Sakura, sakura: a song of the Edo period whose maker nobody knows."""


def tune(score: str, beat: float) -> list[int]:
    """A music box plays it: samples of 16 bit, mono. beat: in seconds."""
    heard: list[tuple[float, float]] = []
    at = 0.0
    for note in score.split():
        name, _, beats = note.partition(":")
        heard.append((at, 261.63 * NOTES[name[0]] * 2 ** (int(name[1]) - 4)))
        at += float(beats or 1) * beat
    mixed = [0.0] * round((at + 1.0) * RATE)
    tones = {pitch: _tone(pitch) for _, pitch in heard}
    for start, pitch in heard:
        first = round(start * RATE)
        for i, value in enumerate(tones[pitch][: len(mixed) - first], first):
            mixed[i] += value
    loudest = max(abs(value) for value in mixed)
    return [round(15_000 * value / loudest) for value in mixed]


def _tone(pitch: float) -> list[float]:
    """A tongue that is plucked, 1.4 s. pitch: in hertz."""
    found = []
    for i in range(round(1.4 * RATE)):
        t = i / RATE
        turn = 2 * math.pi * pitch * t
        ring = math.exp(-3.2 * t) * math.sin(turn) + 0.3 * math.exp(-6 * t) * math.sin(3 * turn)
        found.append(min(1.0, t / 0.006) * ring * min(1.0, (1.4 - t) / 0.05))
    return found
