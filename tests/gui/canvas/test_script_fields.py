"""What is begun from a script's data, and the fields of a test over the drawing, by keys alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication
from tests.gui.drawing.draughtsman import Draughtsman
from tests.gui.test_newcomer import CONTROL

from situ.document.condition import Test as Check
from situ.document.spds import Observed, Situation, Spds
from situ_studio.canvas.script import ScriptCanvas

GIVEN = """<spds name="ward">
  <observe>
    <data tag="door.open" type="boolean"/>
    <data tag="room.heat" type="number"/>
  </observe>
  <situation name="last"/>
</spds>
"""


@pytest.fixture
def me(studio: Callable[..., Any], tmp_path: Path) -> Draughtsman:
    file = tmp_path / "ward.spds.xml"
    file.write_text(GIVEN, encoding="utf-8")
    return Draughtsman(studio(file).window)


def looked_at_by(me: Draughtsman, name: str) -> tuple[Any, ...]:
    window: Any = me.window
    situation = window.current_document.situation(name)
    return tuple(situation.condition.children)


def test_a_new_situation_looks_at_the_data_that_is_selected(me: Draughtsman) -> None:
    """With the test that fits its type, as where a pipe is pulled from it."""
    me.click_card("room.heat")
    me.click("Situation", QAbstractButton)
    me.type("hot")
    me.click_card("door.open")
    me.click("Situation", QAbstractButton)
    me.type("open")
    assert looked_at_by(me, "hot") == (Check("room.heat", "above", "0"),)
    assert looked_at_by(me, "open") == (Check("door.open", "is", "true"),)
    # A condition more: the test that fits as well.
    me.click_card("hot")
    me.click("Condition", QAbstractButton)
    assert looked_at_by(me, "hot")[1:] == (Check("door.open", "is", "true"),)


def test_tab_goes_through_the_fields_of_a_test_over_the_drawing(me: Draughtsman) -> None:
    me.pull_to_ground("door.open", "last", "open")
    me.twice_on("door.open is true")
    went = []
    for _ in range(6):
        focus = QApplication.focusWidget()
        assert focus is not None
        went.append(focus.accessibleName())
        QTest.keyClick(focus, Qt.Key.Key_Tab)
    assert went == ["Test", "Value", "within", "for", "Tag", "Remove this test"]
    me.key(Qt.Key.Key_Tab)
    me.key(Qt.Key.Key_Tab)
    me.type("2", Qt.Key.Key_Tab)
    me.type("0.5", Qt.Key.Key_Backtab)
    me.key(Qt.Key.Key_A, CONTROL)
    me.type("3")
    assert looked_at_by(me, "open") == (Check("door.open", "is", "true", within=3.0, hold=0.5),)


def test_a_script_that_was_just_begun_says_what_to_do_next(desk: Callable[..., Any]) -> None:
    begun = Spds(name="new", situations=(Situation("otherwise"),))
    made = desk(begun, ScriptCanvas)
    advice = made.canvas.advice
    assert advice.isVisible()
    assert "Press Data" in advice.text()
    assert not advice.geometry().intersects(made.canvas.zoom_bar.geometry())
    made.change(replace(begun, observe=(Observed("door.open"),)))
    assert not advice.isVisible()
