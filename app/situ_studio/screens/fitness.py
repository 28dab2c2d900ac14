"""Whether a component is fit for fingers and eyes: what the care lints judge, in numbers.

Sizes are those of the device that is looked at, at first the 10-inch screen on which the lints
judge (situ.document.care_screen).
"""

from __future__ import annotations

import math

from msgspec import Struct
from PySide6.QtCore import QSize

from situ.document import care_screen as care
from situ.document import rbd
from situ.document.project import Project
from situ_studio import kinds
from situ_studio.screens.component_painting import Stage
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.input_painting import letters, rooms
from situ_studio.screens.painting import layer
from situ_studio.screens.shown import content
from situ_studio.wording.language import tr, translated

APART = 3
"""Millimetres between two targets at least: from there on older adults hit the right one as well
as with wider gaps (Jin, Plocher, Kiff 2007).
"""
EASE = math.radians(20 / 60)
"""The angle that a capital has where it is read with ease (ISO 9241-303)."""


class Fit(Struct, frozen=True):
    """One thing that was looked at. is_fit: False where it should be mended."""

    is_fit: bool
    words: str


def fits(
    project: Project,
    file: str,
    application: rbd.Application,
    screen: rbd.Screen,
    component: rbd.Component,
    device: Device = USUAL,
) -> tuple[Fit, ...]:
    """What there is to say of a component: its size as a target, its letters, their contrast and
    the nearest other target. Nothing of what is neither touched nor read.
    """
    found = [
        _target(component, device) if is_touched(component) else None,
        _letters(project, screen, component, device),
        _contrast(project, file, application, screen, component),
        _apart(application, screen, component, device) if is_touched(component) else None,
    ]
    return tuple(one for one in found if one is not None)


def is_touched(component: rbd.Component) -> bool:
    """Whether a touch of it does something."""
    if isinstance(component, rbd.Button):
        return bool(component.event or component.tag)
    return isinstance(component, rbd.Input | rbd.List)


def _target(component: rbd.Component, device: Device) -> Fit:
    wide, high = device.millimetres(component.width, component.height)
    said = tr("{0} × {1} mm, at least {2} mm is needed")
    sides = (f"{_rounded(side, care.TARGET):g}" for side in (wide, high))
    return Fit(min(wide, high) >= care.TARGET, said.format(*sides, care.TARGET))


def _letters(
    project: Project, screen: rbd.Screen, component: rbd.Component, device: Device
) -> Fit | None:
    size = _size(project, component)
    if size is None:
        return None
    high = size * care.HIGH / 100
    if device != USUAL:
        high = _painted(screen, component, device)
    metres = high * care.CAPITAL / EASE / 1000
    said = tr("Text {0} mm high, read from {1}\u00a0m")
    # Rounded down: nothing is promised that does not hold.
    text = said.format(f"{math.floor(high * 10) / 10:.1f}", f"{math.floor(metres * 10) / 10:.1f}")
    return Fit(high >= care.SIZE * care.HIGH / 100, text)


def _size(project: Project, component: rbd.Component) -> float | None:
    """Percent of the screen's height that its letters have; None where it has none."""
    if isinstance(component, rbd.Text | rbd.Button):
        if not component.text:
            return None
        size = care.SIZES[type(component)] if component.size is None else component.size
        return min(size, care.largest(project, component)[0])
    if isinstance(component, rbd.Input):
        return care.SIZES[rbd.Input] if component.size is None else component.size
    return None


def _painted(screen: rbd.Screen, component: rbd.Component, device: Device) -> float:
    """Millimetres of the letters that a device shows, where texts are as they are written."""
    shown = content(screen)
    stage = Stage(layer(QSize(device.wide, device.high)), shown, None)
    one = next(one for one in shown.components if one["id"] == component.id)
    if isinstance(component, rbd.Input):
        return letters(stage, one, rooms(stage, one, "")[0]) * device.pixel
    return stage.fitted(one).size * device.pixel


def _contrast(
    project: Project,
    file: str,
    application: rbd.Application,
    screen: rbd.Screen,
    component: rbd.Component,
) -> Fit | None:
    if care.colours_of(component) is None:
        return None
    best = care.contrast_of(project, file, application, screen, component)
    if best is None:
        return Fit(True, tr("Contrast not known: something is behind it"))
    said = tr("Contrast {0} to 1").format(f"{math.floor(best * 10) / 10:g}")
    if best < care.CONTRAST:
        said = tr("Contrast {0} to 1, {1} is needed").format(
            f"{math.floor(best * 10) / 10:g}", f"{care.CONTRAST:g}"
        )
    return Fit(best >= care.CONTRAST, said)


def _apart(
    application: rbd.Application, screen: rbd.Screen, component: rbd.Component, device: Device
) -> Fit | None:
    """From the nearest other target of the screen, and of what Always adds to it."""
    every = list(screen.components)
    above = application.always.screen if application.always is not None else None
    for state in application.states:
        if state.screen is screen and state.always and above is not None:
            every += above.components
    others = [one for one in every if one is not component and is_touched(one)]
    if not others:
        return None
    nearest = min(others, key=lambda one: _gap(component, one, device))
    gap, kind = _gap(component, nearest, device), kinds.kind(nearest.element)
    called = translated(kind.title).lower()
    if gap <= 0:
        return Fit(False, tr("No room to the next {0}").format(called))
    said = tr("{0} mm to the next {1}").format(f"{_rounded(gap, APART):g}", called)
    return Fit(gap >= APART, said)


def _rounded(length: float, needed: float) -> float:
    """To whole millimetres, but never so that too little looks like enough."""
    return round(length) if length >= needed else math.floor(length * 10) / 10


def _gap(one: rbd.Component, other: rbd.Component, device: Device) -> float:
    """Millimetres between two boxes; 0 where they touch or overlap."""
    across = max(one.x - other.x - other.width, other.x - one.x - one.width, 0.0)
    down = max(one.y - other.y - other.height, other.y - one.y - one.height, 0.0)
    return math.hypot(*device.millimetres(across, down))
