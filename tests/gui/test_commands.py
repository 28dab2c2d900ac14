"""One table of commands makes menus, context menus, toolbar, shortcuts, palette and help."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QContextMenuEvent, QKeySequence, QShortcut
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from situ.document.condition import Test as Question
from situ_studio.actions import COMMANDS, MENUS, command
from situ_studio.commands.commands import Commands
from situ_studio.commands.menus import told
from situ_studio.commands.shortcuts import Shortcuts

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def test_every_row_of_the_table_can_be_run() -> None:
    assert [i for i, n in Counter(c.id for c in COMMANDS).items() if n > 1] == []
    for row in COMMANDS:
        for method in (row.handler, *row.when.split(), row.shown, row.checked):
            assert not method or hasattr(Commands, method), f"{row.id}: no {method}"
        assert row.menu.partition("/")[0] in MENUS, row.id


def test_no_two_commands_have_one_shortcut() -> None:
    keys = [QKeySequence(k).toString() for c in COMMANDS for k in (c.shortcut, c.also) if k]
    assert all(keys)
    assert [k for k, n in Counter(keys).items() if n > 1] == []


def test_menus_toolbar_palette_and_help_show_the_table(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    actions = window.actions_.actions
    in_menus: set[QAction] = set()
    for menu in window.menuBar().findChildren(QMenu):
        in_menus |= set(menu.actions())
    assert {c.id for c in COMMANDS if actions[c.id] not in in_menus} == set()
    assert {c.id for c in COMMANDS if c.toolbar} == {
        a.objectName() for a in window.toolbar.actions() if a.objectName()
    }
    assert window.findChildren(QShortcut) == []
    by_hand = [
        a.text()
        for a in window.findChildren(QAction)
        if not a.shortcut().isEmpty() and a.objectName() not in actions
    ]
    assert by_hand == []
    palette = {f.text for f in window.commands.everything()}
    can = [c.id for c in COMMANDS if actions[c.id].isEnabled() and actions[c.id].isVisible()]
    assert {told(command(i)) for i in can if i != "find"} <= palette


def test_alt_and_a_letter_open_a_menu(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    letters = [m.title() for m in used.window.menuBar().findChildren(QMenu) if "&" in m.title()]
    assert letters == [f"&{title}" for title in MENUS]
    assert len({title[1] for title in letters}) == len(MENUS)
    used.key(Qt.Key.Key_G, ALT)
    shown = QApplication.activePopupWidget()
    assert isinstance(shown, QMenu)
    assert shown.title() == "&Go"
    shown.close()
    used.window.menuBar().setActiveAction(QAction())
    used.settle()


def test_the_letters_of_the_menus_are_underlined_while_alt_is_held(studio: Start) -> None:
    used = studio()
    bar = used.window.menuBar()
    before = bar.grab().toImage()
    QTest.keyPress(QApplication.focusWidget() or used.window, Qt.Key.Key_Alt)
    held = bar.grab().toImage()
    QTest.keyRelease(QApplication.focusWidget() or used.window, Qt.Key.Key_Alt)
    assert held != before
    assert bar.grab().toImage() == before


def test_the_list_of_shortcuts_has_every_key_and_is_filtered(studio: Start) -> None:
    used = studio()
    used.key(Qt.Key.Key_F1, CONTROL)
    (shown,) = used.window.findChildren(Shortcuts)
    assert shown.isVisible()
    rows = {}
    for at in range(shown.list.tree.topLevelItemCount()):
        head = shown.list.tree.topLevelItem(at)
        for row in range(head.childCount()):
            rows[head.child(row).text(0)] = head.child(row)
    for one in COMMANDS:
        if one.shortcut:
            assert QKeySequence(one.shortcut).toString(
                QKeySequence.SequenceFormat.NativeText
            ) in rows[told(one)].text(1)
    QTest.keyClicks(shown.list.field, "rename everywhere")
    assert [t for t, r in rows.items() if not r.isHidden()] == ["Rename everywhere"]
    shown.close()
    used.settle()


# -- context menus -------------------------------------------------------------------


def offered(used: Studio) -> list[str]:
    """What the open context menu and its submenus offer, as ids of commands."""
    menu = used.window.context_menus.shown
    assert menu is not None
    found: list[str] = []
    waiting = [menu]
    while waiting:
        for action in waiting.pop().actions():
            below = action.menu()
            if isinstance(below, QMenu):
                waiting.append(below)
            elif not action.isSeparator():
                found.append(action.objectName())
    return found


def right_click(used: Studio, canvas: Any, spot: Any) -> None:
    port = canvas.viewer.viewport()
    at = canvas.viewer.mapFromScene(spot)
    QTest.mouseClick(port, Qt.MouseButton.RightButton, pos=at)
    reason = QContextMenuEvent.Reason.Mouse
    QApplication.sendEvent(port, QContextMenuEvent(reason, at, port.mapToGlobal(at)))
    used.settle()


def close(used: Studio) -> None:
    used.window.context_menus.shown.close()
    used.settle()
    assert used.window.context_menus.shown is None


def test_a_right_click_offers_what_fits_what_is_under_it(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    canvas.zoom_to_fit()
    card = canvas.card_area(canvas._find(("state", "2"))[0])
    right_click(used, canvas, card.center())
    assert used.window.current_view.selected == (("state", "2"),)
    of_state = offered(used)
    assert {"mark_start", "lead_to", "insert.event", "insert.timeout", "copy"} <= set(of_state)
    assert "align.left" not in of_state
    close(used)
    right_click(used, canvas, canvas.extent().bottomRight())
    assert {"insert.state", "select_all", "zoom_fit"} <= set(offered(used))
    assert "delete" not in offered(used)
    close(used)


def test_a_right_click_on_one_of_several_keeps_them(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    canvas.zoom_to_fit()
    several = tuple(("state", no) for no in ("1", "2", "3"))
    canvas.select(several)
    right_click(used, canvas, canvas.card_area(canvas._find(("state", "2"))[0]).center())
    assert used.window.current_view.selected == several
    assert {"align.left", "align.bottom", "distribute.down", "part.make"} <= set(offered(used))
    assert "mark_start" not in offered(used)
    close(used)


@pytest.mark.parametrize(
    "keys", [(Qt.Key.Key_F10, SHIFT), (Qt.Key.Key_Menu, Qt.KeyboardModifier(0))]
)
def test_a_key_opens_the_menu_of_the_selection(studio: Start, project: Copy, keys: Any) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    used.select("state", "2", "event", "0")
    used.key(*keys)
    assert {"go_target", "guard", "find_usages", "rename_everywhere"} <= set(offered(used))
    corner = canvas.viewer.viewport().mapFromGlobal(used.window.context_menus.shown.pos())
    assert canvas.viewer.viewport().rect().contains(corner)
    close(used)
    used.window.show_mode("outline")
    used.select("state", "2")
    used.key(*keys)
    assert "rename" in offered(used)
    close(used)


def test_a_state_added_from_the_menu_of_the_ground_stands_there(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    canvas.look_at((1.0, -600.0, -600.0))
    used.select("state", "2")
    spot = canvas.viewer.mapToScene(QPoint(80, 120))
    right_click(used, canvas, spot)
    shown = used.window.context_menus.shown
    insert = next(a for a in shown.actions() if a.text() == "Insert")
    shown.setActiveAction(insert)
    menu = insert.menu()
    menu.setActiveAction(used.window.actions_.actions["insert.state"])
    QTest.keyClick(menu, Qt.Key.Key_Return)
    used.settle()
    ((_, no),) = used.window.current_view.selected
    x, y = used.session.document("reception.rbd.xml").state(no).aside.position
    assert abs(x - spot.x()) <= 4
    assert abs(y - spot.y()) <= 4
    assert canvas.pointed is None


# -- the keyboard on the canvas ----------------------------------------------------------


def test_from_transition_to_transition_and_on_to_its_target(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    view = used.window.current_view
    used.select("state", "6")
    used.key(Qt.Key.Key_Down, ALT)
    assert view.selected == (("state", "6", "event", "0"),)
    used.key(Qt.Key.Key_Up, ALT)
    last = view.selected[0]
    assert last != ("state", "6", "event", "0")
    used.key(Qt.Key.Key_Down, ALT)
    used.key(Qt.Key.Key_J, CONTROL)
    event = used.session.document("reception.rbd.xml").state("6").events[0]
    assert view.selected == (("state", event.next),)
    used.key(Qt.Key.Key_Home, CONTROL)
    assert view.selected == (("state", "1"),)


def test_a_transition_is_led_elsewhere_by_keys(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "6", "event", "0")
    used.key(Qt.Key.Key_E, CONTROL)
    used.type("greeting")
    used.key(Qt.Key.Key_Return)
    event = used.session.document("reception.rbd.xml").state("6").events[0]
    assert used.session.document("reception.rbd.xml").state(event.next).name == "greeting"


def test_a_state_gets_one_more_transition_by_keys(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    count = len(used.session.document("reception.rbd.xml").state("6").events)
    used.select("state", "6")
    used.key(Qt.Key.Key_E, CONTROL)
    used.type("new end state")
    used.key(Qt.Key.Key_Return)
    document = used.session.document("reception.rbd.xml")
    assert len(document.state("6").events) == count + 1
    new = document.state(document.state("6").events[-1].next)
    assert new.final
    used.key(Qt.Key.Key_Z, CONTROL)
    assert len(used.session.document("reception.rbd.xml").state("6").events) == count


def test_a_folded_pipe_is_drawn_and_folded_again(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    used.select("state", "2", "timeout")
    (id,) = (i for i in canvas.graph.links if canvas.link_place(i) == ("state", "2", "timeout"))
    assert canvas.graph.pipe(id).route.folded
    used.window.actions_.actions["turn_pipe"].trigger()
    used.settle()
    assert not canvas.graph.pipe(id).route.folded
    used.window.actions_.actions["turn_pipe"].trigger()
    used.settle()
    assert canvas.graph.pipe(id).route.folded
    used.select("state", "2", "event", "0")
    used.window.actions_.actions["turn_pipe"].trigger()
    said = used.window.status.said.text()
    assert said == "Only long pipes are folded, and this one is not"


def test_followers_and_what_leads_here_are_added_to_the_selection(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    view = used.window.current_view
    used.select("state", "2")
    used.key(Qt.Key.Key_Right, CONTROL | SHIFT)
    document = used.session.document("reception.rbd.xml")
    reached = {e.next for e in document.state("2").events if e.next}
    timeout = document.state("2").timeout
    reached |= {timeout.next} if timeout is not None and timeout.next else set()
    assert {p[1] for p in view.selected} == reached | {"2"}
    used.select("state", "2")
    used.key(Qt.Key.Key_Left, CONTROL | SHIFT)
    assert ("state", "1") in view.selected


def test_what_follows_in_a_script_is_what_its_pipes_lead_to(studio: Start, project: Copy) -> None:
    """From data to the conditions that look at them, and on to the resources; and back."""
    used = studio(project("conversation"))
    used.window.open_file("conversation.spds.xml")
    used.settle()
    view, script = used.window.current_view, used.window.current_document
    situation = next(s for s in script.situations if s.condition is not None and s.entries)
    first = next(c for c in situation.condition.children if isinstance(c, Question))
    uses = {m.name: m.resources for m in used.session.project.spds.modules}
    used.select("data", first.tag)
    for _ in range(2):
        used.key(Qt.Key.Key_Right, CONTROL | SHIFT)
    place = ("situation", situation.name)
    assert {("data", first.tag), (*place, "condition"), place} <= set(view.selected)
    used.select(*place)
    used.key(Qt.Key.Key_Right, CONTROL | SHIFT)
    asked = {("module", e.module) for e in situation.entries}
    assert set(view.selected) == {place, *asked}
    used.key(Qt.Key.Key_Right, CONTROL | SHIFT)
    resources = {("resource", r) for _, name in asked for r in uses[name]}
    assert set(view.selected) == {place, *asked, *resources}
    used.key(Qt.Key.Key_Right, CONTROL | SHIFT)
    assert used.window.status.said.text() == "All of them are selected already"
    used.select(*place)
    used.key(Qt.Key.Key_Left, CONTROL | SHIFT)
    assert {place, (*place, "condition")} <= set(view.selected)
    used.key(Qt.Key.Key_Left, CONTROL | SHIFT)
    assert ("data", first.tag) in view.selected
    # From a priority to the module that has it.
    used.select(*place, "entry", "0")
    used.key(Qt.Key.Key_Right, CONTROL | SHIFT)
    assert ("module", situation.entries[0].module) in view.selected


def test_a_new_module_asks_for_nothing_but_the_resource_that_is_selected(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    used.window.open_file("conversation.spds.xml")
    used.settle()
    viewer = used.window.current_view.canvas.viewer
    for card, wanted in (("situation called", ()), ("resource base", ("base",))):
        area = used.window.current_view.canvas.card_area(card)
        viewer.reveal(area)
        used.click(viewer.viewport(), viewer.mapFromScene(area.topLeft() + QPointF(20, 10)))
        used.click(used.window.palette_.item("module"))
        made = used.session.document("conversation.spds.xml").modules[-1]
        assert made.resources == wanted
        assert used.window.inspector.place == ("module", made.name)


def test_a_state_is_marked_as_the_start(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "6")
    used.window.actions_.actions["mark_start"].trigger()
    assert used.session.document("reception.rbd.xml").start_no == "6"
    assert used.session.undo_text == "Start in 6 show names"


def test_problems_are_gone_through_by_a_key(studio: Start, project: Copy) -> None:
    folder = project("reception")
    file = folder / "reception.rbd.xml"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace('next="14"', 'next="77"'), encoding="utf-8")
    used = studio(folder)
    count = used.window.problems.list.model().rowCount()
    assert count > 1
    places = []
    for _ in range(count + 1):
        used.key(Qt.Key.Key_F8)
        places.append(used.window.current_view.selected)
    assert places[0] == places[-1]
    assert len(set(places)) > 1
    used.key(Qt.Key.Key_F8, SHIFT)
    assert used.window.current_view.selected == places[-2]


def test_a_guard_is_added_and_filled_in_by_keys(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "6", "event", "0")
    assert used.session.document("reception.rbd.xml").state("6").events[0].when is None
    used.window.actions_.actions["guard"].trigger()
    used.settle()
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("patients")
    used.key(Qt.Key.Key_Return)
    when = used.session.document("reception.rbd.xml").state("6").events[0].when
    assert [t.tag for t in when.children] == ["patients"]


def test_cards_off_the_grid_are_put_on_it(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    from situ_studio.edits import places

    document = used.session.document("reception.rbd.xml")
    state = document.state("2")
    crooked = places.change(document, ("state", "2"), aside=state.aside.at(13, 27))
    used.window.commit(crooked, "Elsewhere")
    used.select("state", "2")
    used.window.actions_.actions["snap"].trigger()
    after = used.session.document("reception.rbd.xml").state("2")
    assert after.aside.position == (16, 24)
    assert command("snap").menu == "Arrange"


# -- the same in the outline ---------------------------------------------------------------


def test_the_outline_leads_a_transition_elsewhere_and_marks_the_start(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.window.show_mode("outline")
    used.select("state", "6", "event", "0")
    used.key(Qt.Key.Key_E, CONTROL)
    used.type("greeting")
    used.key(Qt.Key.Key_Return)
    document = used.session.document("reception.rbd.xml")
    assert document.state(document.state("6").events[0].next).name == "greeting"
    used.key(Qt.Key.Key_J, CONTROL)
    assert used.window.current_view.selected == (("state", "10"),)
    used.window.actions_.actions["mark_start"].trigger()
    assert used.session.document("reception.rbd.xml").start_no == "10"
    assert not used.window.actions_.actions["align.left"].isEnabled()


def test_the_outline_adds_what_follows_a_state(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.show_mode("outline")
    used.select("state", "6")
    count = len(used.session.document("reception.rbd.xml").states)
    used.key(Qt.Key.Key_E, CONTROL)
    used.type("new state that says")
    used.key(Qt.Key.Key_Return)
    document = used.session.document("reception.rbd.xml")
    assert len(document.states) == count + 1
    assert document.state("6").events[-1].next == document.states[-1].no
    assert used.window.current_view.selected == (("state", document.states[-1].no),)
