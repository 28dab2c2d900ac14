"""Everything that formats.md allows in a script can be drawn: a row for each element and attribute.

What there is stands in the table of the reader and writer (``situ.document.elements``); a new one
there without a row here fails. Everything is done by mouse and keys, in one window.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox
from tests.gui.drawing.draughtsman import Draughtsman
from tests.gui.test_newcomer import CONTROL

from situ.document import codec, elements
from situ.document.condition import TESTS
from situ.document.grammar import Element
from situ_studio.canvas.test_editor import TestEditor

GIVEN = """<spds name="ward">
  <observe>
    <data tag="door.open" type="boolean"/>
    <data tag="room.heat" type="number"/>
  </observe>
  <modules>
    <module name="nod" resources="head"/>
    <module name="talk" resources="speech"/>
  </modules>
  <situation name="first">
    <condition><data tag="room.heat" above="30"/></condition>
    <until><data tag="room.heat" below="20"/></until>
  </situation>
  <situation name="second" extends="last">
    <condition><data tag="room.heat" above="40"/><data tag="door.open" is="true"/></condition>
  </situation>
  <situation name="last"><module name="talk" priority="10"/></situation>
</spds>
"""
WORDS = {
    "is": "is",
    "isnot": "is not",
    "above": "above",
    "below": "below",
    "atleast": "at least",
    "atmost": "at most",
    "in": "is one of",
    "exists": "exists",
}
"""Each test, as a designer reads it."""
IN_TESTS = ("tag", "within", "for", *TESTS)
"""The attributes of a test: one of ``TESTS``, and the others."""


def new_data(me: Draughtsman) -> None:
    me.click("Data", QAbstractButton)
    me.type("lamp")


def kind_of_data(me: Draughtsman) -> None:
    me.click_card("room.heat")
    me.run("Kind of value")
    me.type("text")


def unit_of_data(me: Draughtsman) -> None:
    me.click_card("room.heat")
    me.run("Unit")
    me.type("deg")


def new_module(me: Draughtsman) -> None:
    me.click("Module", QAbstractButton)
    me.type("wave")


def resource(me: Draughtsman) -> None:
    me.pull("talk", "head")


def name_of_script(me: Draughtsman) -> None:
    me.click_card("first")
    me.key(Qt.Key.Key_Escape)
    me.write_into("Name", "night")


def name_of_situation(me: Draughtsman) -> None:
    me.twice_on("first")
    me.key(Qt.Key.Key_A, CONTROL)
    me.type("earliest")


def extends(me: Draughtsman) -> None:
    me.pull("first", "last")


def extends_no_more(me: Draughtsman) -> None:
    me.click_card("second")
    me.run("Take over from")
    me.type("nothing")


def dwell(me: Draughtsman) -> None:
    me.click_card("second")
    me.run("Stay at least")
    me.type("2.5")


def limit(me: Draughtsman) -> None:
    me.click_card("first")
    me.run("End after")
    me.type("90")


def condition(me: Draughtsman) -> None:
    me.pull_to_ground("room.heat", "last", "hot")


def until(me: Draughtsman) -> None:
    me.pull_to_ground("door.open", "last", "second holds until")


def priority(me: Draughtsman) -> None:
    me.priority("first", "nod", 40)


def priority_over_one_taken_over(me: Draughtsman) -> None:
    me.click_card("second")
    me.run("Situation: Priority")
    me.type("talk")
    me.type("15")


def no_priority(me: Draughtsman) -> None:
    me.click_card("second")
    me.run("Situation: Priority")
    me.type("talk")
    me.type("none")


def joint(kind: str) -> Callable[[Draughtsman], None]:
    """Another sign for a whole condition."""

    def draw(me: Draughtsman) -> None:
        sign = me.drawn("Condition of second")
        me.twice(QPoint(sign.left() + 12, sign.center().y()))
        me.type(f"{kind} of")

    return draw


def inner(kind: str) -> Callable[[Draughtsman], None]:
    """One line of a condition becomes a group of its own."""

    def draw(me: Draughtsman) -> None:
        me.click_at(me.drawn("door.open is true").center())
        me.run(f"Tests: {kind} of these")

    return draw


def until_joint(kind: str) -> Callable[[Draughtsman], None]:
    def draw(me: Draughtsman) -> None:
        me.click_at(me.drawn("room.heat below 20").center())
        me.run(f"Tests: {kind} of these")

    return draw


TABLE: dict[str, tuple[Callable[[Draughtsman], None], str]] = {
    "spds@name": (name_of_script, '<spds name="night">'),
    "observe/data@tag": (new_data, '<data tag="lamp"'),
    "observe/data@type": (kind_of_data, '<data tag="room.heat" type="text"/>'),
    "observe/data@unit": (unit_of_data, '<data tag="room.heat" type="number" unit="deg"/>'),
    "modules/module@name": (new_module, '<module name="wave"'),
    "modules/module@resources": (resource, '<module name="talk" resources="speech head"/>'),
    "situation@name": (name_of_situation, '<situation name="earliest">'),
    "situation@extends": (extends, '<situation name="first" extends="last">'),
    "situation@extends taken away": (extends_no_more, '<situation name="second">'),
    "situation@dwell": (dwell, '<situation name="second" extends="last" dwell="2.5">'),
    "situation@limit": (limit, '<situation name="first" limit="90">'),
    "condition": (
        condition,
        '<situation name="hot"><condition><data tag="room.heat" above="0"/></condition>',
    ),
    "until": (until, '<until><data tag="door.open" is="true"/></until>'),
    "situation/module@name": (priority, '<module name="nod" priority="40"/>'),
    "situation/module@priority": (
        priority_over_one_taken_over,
        '<module name="talk" priority="15"/>',
    ),
    "situation/module@priority none": (no_priority, '<module name="talk" priority="none"/>'),
    "condition/all": (inner("All"), '<all><data tag="door.open" is="true"/></all></condition>'),
    "condition/any": (
        joint("Any"),
        '<any><data tag="room.heat" above="40"/><data tag="door.open" is="true"/></any>',
    ),
    "condition/none": (
        joint("None"),
        '<none><data tag="room.heat" above="40"/><data tag="door.open" is="true"/></none>',
    ),
    "until/all": (until_joint("All"), "<until><all>"),
    "until/any": (until_joint("Any"), "<until><any>"),
    "until/none": (until_joint("None"), "<until><none>"),
}


GROUPS = ("all", "any", "none")


def known(element: Element, where: str = "") -> Iterator[str]:
    """Every element and attribute of a script; groups in groups are groups, tests in them tests."""
    if element.name in ("condition", "until"):
        where = ""
    name = f"{where}{element.name}"
    if element.name in ("condition", "until", *GROUPS):
        yield name
    for attribute in element.attributes:
        yield f"{name}@{attribute.name}"
    if element.name in GROUPS:
        return
    for one in (one for slot in element.slots for one in slot.elements):
        yield from known(one, "" if element.name == "spds" else f"{element.name}/")


def test_every_element_and_attribute_has_a_row() -> None:
    every = set(known(elements.SPDS))
    wanted = {key for key in every if not key.startswith(("condition/data", "until/data"))}
    tests = {key for key in every if key.startswith(("condition/data", "until/data"))}
    assert wanted <= set(TABLE), wanted - set(TABLE)
    assert tests == {f"{word}/data@{one}" for word in ("condition", "until") for one in IN_TESTS}


@pytest.fixture
def me(studio: Any, tmp_path: Path) -> Draughtsman:
    file = tmp_path / "ward.spds.xml"
    file.write_text(GIVEN, encoding="utf-8")
    window = studio(file).window
    window.resize(1700, 1000)
    return Draughtsman(window)


def studio_of(me: Draughtsman) -> Any:
    return me.window


def given(me: Draughtsman) -> None:
    """The script as it was, without a selection."""
    document, _ = codec.read(GIVEN.encode(), "ward.spds.xml")
    studio_of(me).commit(document, "as it was")
    studio_of(me).select_all(())
    me.settle()


def written(me: Draughtsman) -> str:
    text = codec.write(studio_of(me).current_document).decode()
    return "".join(line.strip() for line in text.splitlines())


def test_each_is_drawn_and_comes_out_in_the_file(me: Draughtsman) -> None:
    for name, (draw, wanted) in TABLE.items():
        given(me)
        before = written(me)
        assert wanted not in before or name == "situation@extends taken away", name
        draw(me)
        assert wanted in written(me), name
        me.key(Qt.Key.Key_Z, CONTROL)
        if not name.endswith("taken away"):
            assert wanted not in written(me), name


@pytest.mark.parametrize(
    ("row", "word"), [("room.heat above 30", "condition"), ("room.heat below 20", "until")]
)
def test_each_test_is_drawn(me: Draughtsman, row: str, word: str) -> None:
    """In the fields that open at a line; the time limits stay when the test changes."""
    me.test(row, within="3", **{"for": "0.5"})
    me.twice_on(next(c for c in lines(me) if "within 3 s" in c))
    editor = me.widget("Test", TestEditor)
    box = editor.findChildren(QComboBox)[0]
    for test in TESTS:
        me.click_at(box.mapToGlobal(box.rect().center()))
        me.choose(WORDS[test])
        found = written(me)
        inside = found[found.index(f"<{word}>") : found.index(f"</{word}>")]
        assert f' {test}="' in inside, test
        assert ' within="3" for="0.5"' in inside
    me.key(Qt.Key.Key_Escape)
    assert not [w for w in QApplication.allWidgets() if isinstance(w, TestEditor) and w.isVisible()]


def lines(me: Draughtsman) -> list[str]:
    """The lines of all conditions, as they are heard."""
    canvas = studio_of(me).current_view.canvas
    return [f"{row.tag} {row.text}" for node in canvas.graph.cards.values() for row in node.rows]
