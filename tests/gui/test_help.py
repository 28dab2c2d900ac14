"""The help: everything is explained, by F1, by a click after Shift+F1, and by a search."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenuBar,
    QPlainTextEdit,
    QTableView,
    QWhatsThis,
    QWidget,
)

from situ_studio import actions, kinds
from situ_studio.help import help_texts
from situ_studio.help.help_topics import HELP, topics

SHIFT = Qt.KeyboardModifier.ShiftModifier
Start = Callable[..., Any]
Copy = Callable[[str], Path]


@pytest.fixture
def used(studio: Start, project: Copy) -> Any:
    made = studio(project("reception"))
    made.window.open_file("reception.rbd.xml")
    made.settle()
    return made


def asked(used: Any) -> str:
    """The topic that F1 opens."""
    used.key(Qt.Key.Key_F1)
    shown = used.window.helping.shown
    assert shown.isVisible()
    topic = str(shown.topic)
    shown.close()
    used.settle()
    return topic


# -- the topics --------------------------------------------------------------------------------


def test_every_kind_field_command_and_panel_is_explained(qt: QApplication) -> None:
    found = topics()
    assert [topic.id for topic in found.values() if not all(topic.paragraphs)] == []
    assert {f"kind/{kind.name}" for kind in kinds.KINDS} <= found.keys()
    commands = {c.id for c in actions.COMMANDS if c.handler != "insert"}
    assert {f"command/{id}" for id in commands} <= found.keys()


def test_every_section_of_a_form_is_explained() -> None:
    every = [(k.name, s.title) for k in kinds.KINDS for s in k.sections if not s.help]
    assert every == []


def test_a_command_is_explained_once() -> None:
    there = {command.id: command for command in actions.COMMANDS}
    assert [id for id in help_texts.COMMANDS if id not in there or there[id].tip] == []


def test_every_link_leads_to_a_topic(qt: QApplication) -> None:
    found = topics()
    assert [(t.id, id) for t in found.values() for id in t.see if id not in found] == []


# -- F1 ----------------------------------------------------------------------------------------


def test_f1_explains_what_is_selected_and_the_field_that_has_the_keyboard(used: Any) -> None:
    window = used.window
    window.current_view.current_view().setFocus()
    for place, topic in (
        ((), "panel/canvas"),
        (("state", "7"), "kind/state"),
        (("state", "16"), "kind/part"),
        (("state", "7", "event", "2"), "kind/event"),
        (("state", "7", "timeout"), "kind/timeout"),
        (("always",), "kind/always"),
        (("note", "0"), "kind/note"),
    ):
        used.select(*place)
        assert asked(used) == topic
    used.select("state", "7")
    window.inspector.form.field("name").setFocus()
    assert asked(used) == "field/state.name"
    window.palette_.item("speech").setFocus()
    assert asked(used) == "kind/speech"
    window.project_tree.setFocus()
    assert asked(used) == "panel/project"
    window.welcoming.show()
    window.welcome.new.setFocus()
    assert asked(used) == "panel/welcome"


def test_f1_in_a_menu_explains_the_entry_that_is_marked(used: Any) -> None:
    menu = used.window.actions_.menu("Edit")
    menu.popup(QPoint(0, 0))
    menu.setActiveAction(used.window.actions_.actions["find_in_project"])
    QTest.keyClick(menu, Qt.Key.Key_F1)
    used.settle()
    shown = used.window.helping.shown
    assert shown.topic == "command/find_in_project"
    assert not menu.isVisible()
    assert "Ctrl+F" in shown.pages.toPlainText()


def test_why_a_command_can_not_be_done_now_is_told(used: Any) -> None:
    used.select()
    used.window.helping.show_topic("command/rename")
    assert "select something first" in used.window.helping.shown.pages.toPlainText()


def test_the_help_is_searched_and_goes_from_link_to_link_and_back(used: Any) -> None:
    used.key(Qt.Key.Key_F1)
    shown = used.window.helping.shown
    QTest.keyClicks(shown.field, "priority")
    assert shown.topic == "search/priority"
    first = shown.found("priority")[0]
    assert "priorit" in first.title.casefold()
    QTest.keyClick(shown.field, Qt.Key.Key_Return)
    assert shown.topic == first.id
    used.click(shown.home)
    assert "First steps" in shown.pages.toPlainText()
    used.click(shown.back)
    assert shown.topic == first.id
    QTest.keyClick(shown.field, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClicks(shown.field, "zzzz")
    assert "Nothing." in shown.pages.toPlainText()
    QTest.keyClick(shown.pages, Qt.Key.Key_Escape)
    assert not shown.isVisible()


def test_the_help_is_as_large_the_next_time_as_it_was(studio: Start, project: Copy) -> None:
    folder = project("reception")
    first = studio(folder)
    first.key(Qt.Key.Key_F1)
    first.window.helping.shown.resize(500, 400)
    first.settle()
    QTest.keyClick(first.window.helping.shown.pages, Qt.Key.Key_Escape)
    again = studio(folder)
    again.key(Qt.Key.Key_F1)
    assert again.window.helping.shown.size() == QSize(500, 400)


# -- What is this ------------------------------------------------------------------------------


def test_a_click_after_shift_f1_explains_and_does_nothing_else(used: Any) -> None:
    window, view = used.window, used.window.current_view
    before = view.selected
    window.current_view.current_view().setFocus()
    used.key(Qt.Key.Key_F1, SHIFT)
    assert QWhatsThis.inWhatsThisMode()
    used.click(window.palette_.item("speech"))
    assert not QWhatsThis.inWhatsThisMode()
    told = [w for w in QApplication.topLevelWidgets() if w.inherits("QWhatsThat")]
    assert len(told) == 1
    QWhatsThis.hideText()
    used.settle()
    assert view.selected == before
    assert window.session.undo_text is None


def test_what_is_clicked_is_explained_on_canvas_toolbar_form_and_status(used: Any) -> None:
    window = used.window
    used.select("state", "7")
    helping, viewer = window.helping, window.current_view.canvas.viewer

    def title(widget: QWidget, at: QPoint | None = None) -> str:
        spot = widget.mapToGlobal(at if at is not None else widget.rect().center())
        return str(helping.words_at(widget, spot)[0])

    canvas = window.current_view.canvas
    (card,) = [
        item
        for item in canvas.graph.nodes.values()
        if canvas._place_of(item.view) == ("state", "7")
    ]
    spot = viewer.mapFromScene(card.view.sceneBoundingRect().center())
    assert title(viewer.viewport(), spot) == "State"
    button = window.toolbar.widgetForAction(window.actions_.actions["undo"])
    assert title(button) == "Undo"
    assert title(window.inspector.form.field("timeout")) == "Timeout: After"
    assert title(window.status.counts) == "Size"
    assert title(window.bottom.button("problems")) == "Problems"


# -- tooltips ----------------------------------------------------------------------------------


def unexplained(window: QWidget) -> Iterator[str]:
    """Buttons, fields, labels and heads of columns that neither a tip nor a topic explains."""
    fields = QAbstractButton | QComboBox | QLineEdit | QPlainTextEdit | QAbstractSpinBox
    for widget in window.findChildren(QWidget):
        parent = widget.parentWidget()
        if not widget.isVisibleTo(window) or isinstance(parent, QMenuBar | QTableView):
            continue
        if isinstance(parent, QComboBox | QAbstractSpinBox | QLineEdit):
            continue
        label = type(widget) is QLabel and widget.property("role") == "label" and widget.buddy()
        if (label or isinstance(widget, fields)) and not (
            widget.toolTip() or widget.property(HELP)
        ):
            said = widget.text() if hasattr(widget, "text") else widget.accessibleName()
            yield f"{type(widget).__name__} in {type(parent).__name__}: {said}"
    for head in window.findChildren(QHeaderView):
        if head.isVisibleTo(window):
            heads = head.model(), head.orientation()
            for section in range(head.count()):
                if not heads[0].headerData(section, heads[1], Qt.ItemDataRole.ToolTipRole):
                    yield f"{type(head.parent()).__name__}, column {section}"


PLACES: dict[str, list[tuple[str, ...]]] = {
    "reception": [
        (), ("always",), ("state", "7"), ("state", "16"), ("state", "7", "screen"),
        ("state", "7", "event", "2"), ("state", "7", "timeout"), ("state", "7", "action", "1"),
        ("state", "4", "screen", "confirm"), ("note", "0"), ("frame", "0"),
    ],
    "conversation": [(), ("situation", "sound"), ("module", "nod"), ("data", "sound.slap")],
}  # fmt: skip


A_ROW_OF_EACH = """
[places]
desk = [1.0, 2.0, 90.0]
[mqtt]
url = "mqtt://127.0.0.1:1883"
[mqtt.in]
"ward/button" = "event:called"
[[setting]]
tag = "user.name"
label = "Name"
type = "text"
"""
"""What stands in no example, for the project form."""


@pytest.mark.parametrize("name", PLACES)
def test_nothing_is_without_an_explanation(studio: Start, project: Copy, name: str) -> None:
    folder = project(name)
    with (folder / "situ.toml").open("a") as toml:
        toml.write(A_ROW_OF_EACH)
    used = studio(folder)
    window = used.window
    found: set[str] = set()
    window.open_file("conversation.spds.xml" if name == "conversation" else "reception.rbd.xml")
    for place in PLACES[name]:
        used.select(*place)
        found.update(unexplained(window))
    for mode in window.current_view.ways_to_show:
        window.show_mode(mode)
        used.settle()
        found.update(unexplained(window))
    for page in ("texts", "situ.toml"):
        window.open_file(page)
        used.settle()
        assert window.pages.page(page).isVisible()
        found.update(unexplained(window))
    for panel in window.bottom.names:
        window.bottom.set_shown(panel, True)
        window.bottom.choose(panel)
        used.settle()
        found.update(unexplained(window))
    window.welcoming.show()
    used.settle()
    found.update(unexplained(window))
    assert sorted(found) == []
