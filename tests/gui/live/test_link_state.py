"""What the status bar says of a link."""

from __future__ import annotations

import pytest

from situ_studio.live.link_state import QUIET, LinkState

AT = "tcp://192.168.4.21:5570"


@pytest.mark.parametrize(
    ("state", "now", "words"),
    [
        (LinkState(), 0.0, "no robot"),
        (LinkState("connecting", AT, since=10.0), 10.0 + QUIET - 0.1, f"connecting to {AT}"),
        (
            LinkState("connecting", AT, since=10.0),
            10.0 + QUIET,
            f"nobody answers at {AT} for 4 s; still trying",
        ),
        (LinkState("live", AT), 0.0, "live"),
        (LinkState("live", AT, behind=0.0124), 0.0, "live, 12 ms behind"),
        (
            LinkState("live", AT, behind=0.01, looks_only=True),
            0.0,
            "live, 10 ms behind, you can look only",
        ),
        (LinkState("lost", AT, since=100.0), 108.3, "lost 8 s ago"),
        (LinkState("lost", AT, since=100.0), 100.0 + 42 * 60 + 7, "lost 42 min ago"),
        (LinkState("lost", AT, since=100.0), 100.0 + 3 * 3600 + 400, "lost 3 h ago"),
        (LinkState("refused", AT, why="the key is unknown"), 0.0, "the key is unknown"),
    ],
)
def test_what_the_link_is_is_said_in_words(state: LinkState, now: float, words: str) -> None:
    assert state.words(now) == words
