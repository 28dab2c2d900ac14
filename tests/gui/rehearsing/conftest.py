"""A window that rehearses, and hands at its desk."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

LEFT = Qt.MouseButton.LeftButton
ABOVE = [QPointF(x, -5) for x in range(20, 120, 9)]
"""Places at the upper edge of a card, outside of it."""


def ringed(window: Any) -> set[str]:
    """The states of the current drawing with a ring round their cards."""
    viewer, ground = window.current_view.canvas.viewer, window.theme.color("canvas").rgb()
    picture = viewer.viewport().grab().toImage()
    scale = picture.devicePixelRatio()
    found = set()
    for node in window.current_view.canvas.graph.nodes.values():
        card = node.view
        places = [viewer.mapFromScene(card.mapToScene(point)) for point in ABOVE]
        seen = [at * scale for at in places if viewer.viewport().rect().contains(at)]
        pixels = {picture.pixel(at) for at in seen}
        if pixels and ground not in pixels:
            found.add(card.face.no)
    return found


class Desk:
    """A window that rehearses; its clock goes on only when told."""

    def __init__(self, studio: Any) -> None:
        self.studio = studio
        self.time = 0.0
        self.window = studio.window
        self.side = studio.window.rehearsing
        self.side.clock = lambda: self.time
        studio.key(Qt.Key.Key_F5)
        self.desk = self.side.desk

    @property
    def state(self) -> str | None:
        """Where the first application is, as every live view sees it."""
        moment = self.window.robot.follower.viewing.moment()
        return str(next(iter(moment.applications.values())).state)

    def go_on(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.25)):
            self.time += 0.25
            self.side.running.catch_up()
        self.studio.settle()

    def touch(self, words: str) -> None:
        """A click on what has these words on the robot's screen."""
        shown = self.desk.screen_
        target = next(t for t in shown.targets if t.words == words)
        at = shown.place_of(target).toPoint()
        QTest.mouseClick(shown, LEFT, pos=at)
        self.studio.settle()

    def glowing(self) -> set[str]:
        """The states whose cards are painted in the colour of what is live."""
        self.window.robot.follower.refresh()
        self.studio.settle()
        return ringed(self.window)


@pytest.fixture
def glowing() -> Callable[[Any], set[str]]:
    """``glowing(window)``: the states of its current drawing that glow."""
    return ringed


@pytest.fixture
def rehearsed() -> Callable[[Any], Desk]:
    """``rehearsed(studio)``: the project of that window, from its start."""
    return Desk


@pytest.fixture
def desk(studio: Callable[..., Any], project: Callable[[str], Path]) -> Callable[[str], Desk]:
    """``desk(name)``: a copy of an example is rehearsed."""

    def start(name: str) -> Desk:
        return Desk(studio(project(name)))

    return start
