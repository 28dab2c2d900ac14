"""The components of a screen in the accessible tree, and everything by keys alone."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible

NAME, DESCRIPTION = QAccessible.Text.Name, QAccessible.Text.Description
ROLE, EVENT = QAccessible.Role, QAccessible.Event
SHIFT = Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
CONTROL = Qt.KeyboardModifier.ControlModifier

Page = Any
Table = Any


def tree(page: Any) -> Any:
    return QAccessible.queryAccessibleInterface(page.sheet)


def below(part: Any) -> list[Any]:
    return [part.child(i) for i in range(part.childCount())]


def test_every_component_is_heard_with_its_text_its_place_and_what_it_sends(page: Page) -> None:
    found = below(tree(page))
    assert [(p.role(), p.text(NAME)) for p in found[:5]] == [
        (ROLE.StaticText, "Text What would you like to do?"),
        (ROLE.Graphic, "Image measure.png"),
        (ROLE.Graphic, "Image robot.png"),
        (ROLE.Button, "Button MEASURE"),
        (ROLE.Button, "Button GOODBYE"),
    ]
    assert found[3].text(DESCRIPTION) == (
        "6 % from the left, 70 % from the top; 91 × 33 mm, clickMeasure"
    )
    own = {c.id for c in page.components}
    above = [p for p in found if p.id not in own]
    assert above
    assert not any(p.state().selectable for p in above)
    area = page.sheet.area(page.sheet.own()["robot"]).toRect()
    assert found[2].rect().topLeft() == page.sheet.mapToGlobal(area.topLeft())
    assert tree(page).childAt(*found[2].rect().center().toTuple()) is found[2]
    assert tree(page).indexOfChild(found[2]) == 2


def test_a_component_is_selected_and_opened_by_an_assistive_program(page: Page) -> None:
    heart, measure = below(tree(page))[1], below(tree(page))[3]
    heart.actionInterface().doAction("SetFocus")
    page.settle()
    assert page.selected == (("state", "11", "screen", "heart"),)
    assert heart.state().selected
    assert heart.state().focused
    assert tree(page).focusChild() is heart
    measure.actionInterface().doAction("Press")
    assert page.sheet.writing.field.toPlainText() == "MEASURE"


def test_what_a_component_can_not_do_is_said_and_nothing_breaks(page: Page) -> None:
    # The bridge to a screen reader asks every part for each of these.
    for part in below(tree(page)):
        assert part.textInterface() is None
        assert part.valueInterface() is None
        assert part.tableCellInterface() is None
        assert part.actionInterface() is not None


def test_who_listens_hears_the_selection_and_what_comes_and_goes(
    table: Table, listening: None
) -> None:
    spoken = tree(table)
    below(spoken)
    spoken.on_shown()
    told: list[tuple[Any, str]] = []
    spoken.tell = lambda event: told.append((event.type(), event.accessibleInterface().text(NAME)))
    table.click("robot")
    assert told == [
        (EVENT.SelectionAdd, "Image robot.png"),
        (EVENT.Focus, "Image robot.png"),
    ]
    told.clear()
    table.used.key(Qt.Key.Key_Tab)
    assert told == [
        (EVENT.SelectionRemove, "Image robot.png"),
        (EVENT.SelectionAdd, "Button MEASURE"),
        (EVENT.Focus, "Button MEASURE"),
    ]
    told.clear()
    table.used.key(Qt.Key.Key_D, CONTROL)
    assert (EVENT.ObjectCreated, "Button MEASURE") in told
    measure = next(p for p in below(spoken) if p.id == "measure2")
    told.clear()
    table.used.key(Qt.Key.Key_Delete)
    assert EVENT.ObjectDestroyed in [kind for kind, _ in told]
    assert not measure.isValid()
    told.clear()
    table.click("goodbye")
    table.used.type("B")
    table.used.key(Qt.Key.Key_Return)
    assert (EVENT.NameChanged, "Button B") in told


def test_without_a_mouse_components_are_reached_moved_resized_written_and_left(
    page: Page,
) -> None:
    sheet = page.sheet
    sheet.setFocus()
    page.settle()
    page.key(Qt.Key.Key_Tab)
    assert sheet.selected == ("question",)
    page.key(Qt.Key.Key_Tab)
    page.key(Qt.Key.Key_Tab)
    page.key(Qt.Key.Key_Backtab, SHIFT)
    assert sheet.selected == ("heart",)
    heart = page.component("heart")
    page.key(Qt.Key.Key_Right, ALT)
    page.key(Qt.Key.Key_Down, CONTROL)
    page.key(Qt.Key.Key_Left, CONTROL | SHIFT)
    grown = page.component("heart")
    assert (grown.width, grown.height) == (heart.width + 1 - 10, heart.height + 1)
    assert (grown.x, grown.y) == (heart.x, heart.y)
    assert page.steps[-1] == "Resize heart"
    page.key(Qt.Key.Key_A, CONTROL)
    assert sheet.selected == tuple(c.id for c in page.components)
    page.key(Qt.Key.Key_Escape)
    assert sheet.selected == ()
    # Behind the last one Tab goes on to what comes after the sheet.
    page.click("goodbye")
    page.key(Qt.Key.Key_Tab)
    assert page.next.hasFocus()


def test_at_the_edge_of_the_screen_a_component_grows_at_its_other_side(page: Page) -> None:
    page.click("goodbye")
    for _ in range(2):
        page.key(Qt.Key.Key_Right, SHIFT)
    one = page.component("goodbye")
    assert one.x + one.width == 100
    page.key(Qt.Key.Key_Right, ALT)
    grown = page.component("goodbye")
    assert (grown.x, grown.width) == (one.x - 1, one.width + 1)
