"""What the link to a robot is, in words that are true at every moment. No Qt."""

from __future__ import annotations

from msgspec import Struct

from situ_studio.wording.language import tr
from situ_studio.wording.lasting import lasting

QUIET = 4.0
"""Seconds after which it is said that nobody answers, should the address be wrong."""


class LinkState(Struct, frozen=True):
    """What the status bar says, always honestly.

    kind: ``none`` (no robot), ``connecting``, ``live``, ``lost`` or ``refused``.
    since: seconds of the link's clock when it became so. behind: seconds between the
    last event at the robot and here; None before the first. apart: as ``Delay.apart``.
    looks_only: whether the robot takes nothing from us but questions.
    """

    kind: str = "none"
    endpoint: str = ""
    project: str = ""
    since: float = 0.0
    behind: float | None = None
    apart: float = 0.0
    why: str = ""
    looks_only: bool = False

    def words(self, now: float) -> str:
        """As a designer reads it, at ``now`` of the link's clock."""
        if self.kind == "live":
            told = tr("live")
            if self.behind is not None:
                told = tr("live, {0} ms behind").format(round(self.behind * 1000))
            if self.apart:
                words = tr("{0}, its clock is {1} ahead")
                if self.apart > 0:
                    words = tr("{0}, its clock is {1} late")
                told = words.format(told, lasting(abs(self.apart)))
            return tr("{0}, you can look only").format(told) if self.looks_only else told
        if self.kind == "lost":
            return tr("lost {0} ago").format(lasting(_whole(now - self.since)))
        if self.kind == "connecting":
            if now < self.since + QUIET:
                return tr("connecting to {0}").format(self.endpoint)
            waited = lasting(_whole(now - self.since))
            return tr("nobody answers at {0} for {1}; still trying").format(self.endpoint, waited)
        return self.why if self.kind == "refused" else tr("no robot")


def _whole(seconds: float) -> float:
    """Whole seconds, minutes from two on, hours from two on."""
    unit = 1 if seconds < 120 else 60 if seconds < 7200 else 3600
    return float(round(seconds / unit) * unit)
