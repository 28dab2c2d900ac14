"""The studio's tables: kinds, commands, colours. What one row promises, holds."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from typing import Any

import msgspec
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QKeySequence
from PySide6.QtWidgets import QApplication, QSlider

from situ.document import rbd
from situ_studio import actions, kinds
from situ_studio.commands.commands import Commands
from situ_studio.looks import theme
from situ_studio.looks.theme_qss import qss


def subclasses(base: type) -> Iterator[type]:
    one: type
    for one in base.__subclasses__():
        yield one
        yield from subclasses(one)


@pytest.mark.parametrize("base", [rbd.Action, rbd.Component])
def test_every_action_and_component_has_a_kind(base: type) -> None:
    # Those of documents; the runtime has one more of its own, which nobody writes.
    written = {one for one in subclasses(base) if one.__module__ == rbd.__name__}
    assert {k.value for k in kinds.KINDS if issubclass(k.value, base)} == written


# What a form leaves to others: the graph, and the other of the two kinds of states.
ELSEWHERE = {
    "application": {"always", "states"},
    "state": {"flow"},
    "part": {"timeout", "screen", "actions"},
    "script": {"observe", "modules", "situations"},
    "modules": {"modules"},
}


@pytest.mark.parametrize("kind", kinds.KINDS, ids=lambda k: k.name)
def test_every_attribute_of_a_kind_can_be_edited(kind: kinds.Kind) -> None:
    there = {f.name for f in msgspec.structs.fields(kind.value)} - {"aside"}
    edited = {f.attribute for f in kind.fields}
    for section in kind.sections:
        edited |= {f.attribute for f in section.fields} | {section.attribute}
    # A note rides along beside what is written, as a comment.
    assert edited - {"", "note"} == there - ELSEWHERE.get(kind.name, set())


@pytest.mark.parametrize(
    "kind", [k for k in kinds.KINDS if k.make is not str], ids=lambda k: k.name
)
def test_what_a_kind_makes_is_of_that_kind_and_has_a_summary(kind: kinds.Kind) -> None:
    made = kind.make("name1")
    assert type(made) is kind.value
    assert isinstance(kind.summary(made), str)


def test_every_command_has_its_handler_and_condition() -> None:
    for command in actions.COMMANDS:
        conditions = (*command.when.split(), command.shown, command.checked)
        for name in filter(None, (command.handler, *conditions)):
            assert inspect.isfunction(getattr(Commands, name, None)), f"{command.id}: {name}"
        menu = command.menu.split("/")[0]
        assert menu in actions.MENUS, command.id


def test_no_two_commands_share_an_id_or_a_shortcut() -> None:
    ids = [c.id for c in actions.COMMANDS]
    keys = [QKeySequence(c.shortcut).toString() for c in actions.COMMANDS if c.shortcut]
    assert len(ids) == len(set(ids))
    assert len(keys) == len(set(keys))
    assert "" not in keys


# -- colours -------------------------------------------------------------------------

TEXTS = ("text", "text2", "text3", "accent", "error", "warning", "live")
SURFACES = ("window", "panel", "card", "field")
BOTH = [theme.LIGHT, theme.DARK]


def luminance(color: QColor) -> float:
    parts = [
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4
        for share in (color.redF(), color.greenF(), color.blueF())
    ]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


def contrast(one: QColor, other: QColor) -> float:
    """WCAG 2."""
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("colours", BOTH, ids=lambda t: t.name)
def test_every_text_colour_can_be_read_on_every_surface(colours: theme.Theme) -> None:
    for text in TEXTS:
        for surface in SURFACES:
            found = contrast(colours.color(text), colours.color(surface))
            assert found >= 4.5, f"{text} on {surface}: {found:.2f}"


@pytest.mark.parametrize("colours", BOTH, ids=lambda t: t.name)
def test_every_kind_can_be_read_on_its_soft_surface(colours: theme.Theme) -> None:
    for kind in theme.KINDS:
        found = contrast(colours.kind(kind), colours.kind_soft(kind))
        assert found >= 4.5, f"{kind}: {found:.2f}"


@pytest.mark.parametrize("colours", BOTH, ids=lambda t: t.name)
def test_the_track_and_the_handle_of_a_slider_are_seen(
    colours: theme.Theme, qt: QApplication
) -> None:
    slider = QSlider(Qt.Orientation.Horizontal)
    slider.setStyleSheet(qss(colours))
    slider.resize(120, slider.sizeHint().height())
    slider.setValue(50)
    picture = slider.grab().toImage()
    middle = picture.height() // 2
    panel = colours.color("panel")
    done, handle, track = (contrast(picture.pixelColor(x, middle), panel) for x in (20, 60, 100))
    assert min(done, handle) >= 3
    assert track >= 2.5
    # The handle is higher than the track.
    assert picture.pixelColor(60, middle - 5) == picture.pixelColor(60, middle)
    assert picture.pixelColor(20, middle - 5) != picture.pixelColor(20, middle)


@pytest.mark.parametrize("colours", BOTH, ids=lambda t: t.name)
def test_the_style_sheet_knows_every_token(colours: theme.Theme, qt: QApplication) -> None:
    sheet = qss(colours)
    assert "{" not in re.sub(r"\{[^{}]*\}", "", sheet)
    used = set(re.findall(r"#[0-9A-Fa-f]{6,8}\b", sheet))
    known: set[Any] = set(msgspec.structs.asdict(colours).values())
    assert used <= known
