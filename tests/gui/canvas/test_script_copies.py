"""Copies of situations, data and modules: within a script, to others, from canvas to canvas."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from situ.document import codec
from situ.document.condition import Condition
from situ.document.condition import Test as Question
from situ.document.modules import Module, Modules
from situ.document.project import Project
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas.script import ScriptCanvas
from situ_studio.copying import script_copies as copies
from situ_studio.wording.language import Speaking

CONTROL = Qt.KeyboardModifier.ControlModifier

WARD = Spds(
    name="ward",
    observe=(Observed("calling", "boolean"), Observed("heat", "number", "°C"), Observed("x")),
    modules=(Declaration("nod", ("head",)), Declaration("talk", ("speech",))),
    situations=(
        Situation(
            "hot",
            extends="rest",
            condition=Condition((Question("heat.skin", "above", "38"),)),
            entries=(Entry("talk", None),),
        ),
        Situation(
            "called", extends="hot", condition=Condition((Question("calling", "is", "true"),))
        ),
        Situation("rest", entries=(Entry("nod", 20), Entry("talk", 10))),
    ),
)
HOT, CALLED = ("situation", "hot"), ("situation", "called")
EMPTY = Spds(name="empty")
OTHER = Spds(
    name="other",
    modules=(Declaration("nod", ("base",)),),
    situations=(
        Situation("hot", condition=Condition((Question("x", "is", "true"),))),
        Situation("always"),
    ),
)


def names(script: Spds) -> list[str]:
    return [s.name for s in script.situations]


def test_a_duplicate_stands_right_after_under_a_name_of_its_own() -> None:
    after, text, made = copies.duplicate(WARD, [HOT])
    assert text == "Duplicate situation hot"
    assert names(after) == ["hot", "hot2", "called", "rest"]
    assert made == (("situation", "hot2"),)
    assert after.situations[1] == replace(WARD.situations[0], name="hot2")
    again, _, _ = copies.duplicate(after, made)
    assert names(again) == ["hot", "hot2", "hot3", "called", "rest"]


def test_copies_take_over_from_copies() -> None:
    after, _, _ = copies.duplicate(WARD, [HOT, CALLED])
    assert [(s.name, s.extends) for s in after.situations] == [
        ("hot", "rest"),
        ("called", "hot"),
        ("hot2", "rest"),
        ("called2", "hot2"),
        ("rest", None),
    ]


def test_into_another_script_goes_what_it_refers_to_and_that_lacks() -> None:
    copied = copies.by_itself(WARD, copies.fragment(WARD, [HOT]))
    after, text, _ = copies.paste(OTHER, copied, 1)
    assert text == "Paste situation hot"
    assert names(after) == ["hot", "hot2", "always"]
    # What looks into a datum needs it; the module that is there stays as it is.
    assert after.observe == (WARD.observe[1],)
    assert after.modules == (*OTHER.modules, WARD.modules[1])
    assert after.priorities(after.situations[1]) == {"nod": 20}


def test_the_last_of_a_script_still_always_holds() -> None:
    copied = copies.by_itself(WARD, copies.fragment(WARD, [CALLED]))
    assert names(copies.paste(OTHER, copied, 2)[0]) == ["hot", "called", "always"]
    filled = copies.paste(EMPTY, copied)[0]
    assert names(filled) == ["called", "otherwise"]
    assert filled.situations[1].condition is None


def test_data_and_modules_alone_are_copies_with_names_of_their_own() -> None:
    after, text, made = copies.duplicate(WARD, [("data", "heat"), ("module", "nod")])
    assert text == "Duplicate 2 things"
    assert made == (("data", "heat2"), ("module", "nod2"))
    assert after.observe[-1] == Observed("heat2", "number", "°C")
    assert after.modules[-1] == Declaration("nod2", ("head",))


def test_what_the_project_declares_elsewhere_goes_along_and_is_not_declared_again() -> None:
    bare = replace(WARD, modules=())
    known = {"nod": ("head",), "talk": ("speech",), "other": ()}
    copied = copies.by_itself(bare, copies.fragment(bare, [("situation", "rest")], known))
    assert copied.modules == WARD.modules
    assert copies.paste(EMPTY, copied)[0].modules == WARD.modules
    assert copies.paste(EMPTY, copied, elsewhere=known)[0].modules == ()


@settings(max_examples=40, deadline=None)
@given(st.sets(st.sampled_from(names(WARD)), min_size=1), st.integers(-1, 9))
def test_in_a_script_of_its_own_a_situation_has_the_priorities_that_it_had(
    chosen: set[str], index: int
) -> None:
    copied = copies.fragment(WARD, [("situation", name) for name in chosen])
    data = codec.write(copies.by_itself(WARD, copied))
    read, _ = codec.read(data, "clipboard")
    assert isinstance(read, Spds)
    after, _, made = copies.paste(EMPTY, read, index)
    for before, (_, name) in zip(copied.situations, made, strict=True):
        now = after.situation(name)
        assert now is not None
        assert now.condition == before.condition
        assert after.priorities(now) == WARD.priorities(before)


# -- by the clipboard ------------------------------------------------------------------------


def desk_of(desk: Callable[..., Any], script: Spds, origin: str) -> Any:
    made = desk(script, ScriptCanvas)
    made.canvas.origin = origin
    made.said = []
    made.canvas.status.connect(made.said.append)
    return made


def test_cut_and_pasted_it_is_the_same_script_and_one_step_each(desk: Callable[..., Any]) -> None:
    ward = desk_of(desk, WARD, "/ward")
    ward.canvas.select([CALLED])
    ward.canvas.cut()
    assert names(ward.document) == ["hot", "rest"]
    ward.canvas.select([HOT])
    ward.canvas.paste()
    assert ward.document == WARD
    assert ward.edits == ["Cut situation called", "Paste situation called"]
    assert ward.canvas.selection() == (CALLED,)


def test_the_last_is_not_cut(desk: Callable[..., Any]) -> None:
    ward = desk_of(desk, WARD, "/ward")
    ward.canvas.select([("situation", "rest")])
    ward.canvas.cut()
    assert ward.edits == []
    assert "the last must always hold" in ward.said[-1]


def test_what_is_copied_is_a_script_in_any_text_editor_and_other_text_is_none(
    desk: Callable[..., Any],
) -> None:
    ward = desk_of(desk, WARD, "/ward")
    ward.canvas.select([HOT])
    ward.canvas.copy()
    assert ward.said[-1] == "Copied: situation hot"
    text = QGuiApplication.clipboard().text()
    QGuiApplication.clipboard().setText(text)
    ward.canvas.clear_selection()
    ward.canvas.paste()
    # As text it has the priorities itself; without a place it goes before the last.
    assert names(ward.document) == ["hot", "called", "hot2", "rest"]
    assert ward.document.situations[2].entries == (Entry("nod", 20),)
    QGuiApplication.clipboard().setText("<nonsense")
    ward.canvas.paste()
    assert ward.said[-1] == "There are no situations, data or modules on the clipboard"
    assert len(ward.edits) == 1


def test_what_is_wrong_with_a_script_on_the_clipboard_is_said_in_the_user_s_language(
    desk: Callable[..., Any], qt: QApplication
) -> None:
    ward = desk_of(desk, WARD, "/ward")
    wrong = (
        '<spds name="a"><situation name="b"><module name="nod" priority="x"/></situation></spds>'
    )
    _, problems = codec.read(wrong.encode(), "clipboard")
    english = next(one.message for one in problems if one.severity == "error")
    QGuiApplication.clipboard().setText(wrong)
    ward.canvas.paste()
    assert english in ward.said[-1]
    speaking = qt.findChild(Speaking) or Speaking(qt)
    speaking.use("ja")
    try:
        ward.canvas.paste()
    finally:
        speaking.use("en")
    assert english not in ward.said[-1]
    assert ward.edits == []


def test_modules_of_another_project_are_declared(desk: Callable[..., Any]) -> None:
    here = Project(root="", name="", modules=Modules((Module("nod", ("head",)),)))
    ward = desk_of(desk, replace(WARD, modules=()), "/ward")
    ward.canvas.project = lambda: here
    ward.canvas.select([HOT])
    ward.canvas.copy()
    other = desk_of(desk, EMPTY, "/other")
    other.canvas.paste()
    assert other.document.modules == (Declaration("nod", ("head",)),)


# -- by the window ------------------------------------------------------------------------------


def test_keys_and_menus_copy_in_the_window(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    used = studio(project("conversation"))
    window = used.window
    window.open_file("conversation.spds.xml")
    used.settle()
    before = window.current_document
    window.current_view.canvas.viewer.setFocus()
    used.select("situation", "called")
    used.key(Qt.Key.Key_D, CONTROL)
    assert names(window.current_document)[2:4] == ["called", "called2"]
    assert window.current_view.selected == (("situation", "called2"),)
    used.key(Qt.Key.Key_X, CONTROL)
    assert window.current_document == before
    used.select("situation", "sound")
    used.key(Qt.Key.Key_V, CONTROL)
    assert names(window.current_document)[3:5] == ["sound", "called2"]
    menu = window.actions_.context_menu("thing", window)
    offered = {action.text() for action in menu.actions()}
    menu.deleteLater()
    assert {"Cut", "Copy", "Duplicate", "Show the selection"} <= offered
    used.select("situation", "sound", "condition")
    assert not window.commands.can_copy()
    # The outline has the same parts and the same keys.
    window.show_mode("outline")
    window.current_view.twin.tree.setFocus()
    used.select("situation", "called2")
    used.key(Qt.Key.Key_C, CONTROL)
    assert window.status.said.text() == "Copied: situation called2"
    used.key(Qt.Key.Key_V, CONTROL)
    assert names(window.current_document)[4:6] == ["called2", "called3"]
    assert window.current_view.selected == (("situation", "called3"),)
    used.key(Qt.Key.Key_X, CONTROL)
    used.key(Qt.Key.Key_Z, CONTROL)
    used.key(Qt.Key.Key_D, CONTROL)
    assert names(window.current_document)[5:7] == ["called3", "called4"]
    # The last of all always holds, there too.
    last = names(window.current_document)[-1]
    before = window.current_document
    used.select("situation", last)
    used.key(Qt.Key.Key_X, CONTROL)
    assert window.current_document is before
    assert window.status.said.text()
