"""Guides that a hand places in the screen designer: drawn out of rulers, moved, snapped to."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.test_adding_to_a_project import open_menu
from tests.gui.test_tables import contrast

from situ.document import codec
from situ.document.aside import NOTHING
from situ.document.export import deployable
from situ.document.folder import load
from situ.document.rbd import Application
from situ_studio.looks import letters
from situ_studio.looks.theme import DARK, LIGHT, Theme
from situ_studio.screens import guides
from situ_studio.screens.guides import Guide

Start = Callable[..., Any]
Copy = Callable[[str], Path]
LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

PLACED = st.builds(guides.at, st.sampled_from(("x", "y")), st.floats(-5, 105))


# -- in the file -------------------------------------------------------------------------


@given(st.lists(PLACED))
def test_guides_are_in_the_file_as_they_were_put_each_once_and_in_order(put: list[Guide]) -> None:
    after = guides.put(Application(name="a"), put)
    assert guides.of(after) == tuple(sorted(set(put)))
    data = codec.write(after)
    again, problems = codec.read(data, "a.rbd.xml")
    assert isinstance(again, Application)
    assert [p for p in problems if "ed:" in p.message] == []
    assert guides.of(again) == guides.of(after)
    assert codec.write(again) == data
    assert guides.put(again, reversed(put)) is again
    assert b"ed:guides" not in codec.write(guides.put(again, ()))


def test_what_is_written_by_hand_and_is_no_guide_is_left_out() -> None:
    aside = NOTHING.with_attribute("guides", "y80 x12.50 x z3 x-1 y101 xnan x12.5 x yinf")
    application = Application(name="a", aside=aside)
    assert guides.of(application) == (Guide("x", 12.5), Guide("y", 80.0))


def test_a_new_guide_stands_in_the_middle_or_beside_those_there() -> None:
    found: tuple[Guide, ...] = ()
    for _ in range(4):
        found = (*found, guides.free(found, "x"))
    assert [one.at for one in found] == [50.0, 51.0, 49.0, 52.0]
    full = tuple(Guide("y", float(at)) for at in range(101))
    assert guides.free(full, "y") in full


# -- by hand -----------------------------------------------------------------------------


class Drawing:
    """The designer of state 6, and what a hand does there."""

    def __init__(self, used: Any) -> None:
        self.used = used
        used.window.select(("state", "6"))
        used.window.show_mode("screen")
        used.settle()
        self.designer = used.window.current_view.piece("designer")
        self.sheet, self.ground = self.designer.sheet, self.designer.ground
        self.above, self.beside = self.ground.rulers

    @property
    def guides(self) -> list[str]:
        document = self.used.session.document("reception.rbd.xml")
        return [f"{one.axis}{one.at:g}" for one in guides.of(document)]

    def spot(self, x: float, y: float) -> QPoint:
        """A place of the ground, by percent of the screen."""
        at = QPoint(round(self.sheet.width() * x / 100), round(self.sheet.height() * y / 100))
        begin: QPoint = self.sheet.pos()
        return begin + at

    def drag(
        self, on: Any, start: QPoint, end: QPoint, held: Any = NONE, release: bool = True
    ) -> None:
        """From one place of the ground to another, over a widget in it."""
        off = on.pos() if on is not self.ground else QPoint()
        QTest.mousePress(on, LEFT, held, start - off)
        for part in (1, 2, 3):
            at = start + (end - start) * part / 3 - off
            self._move(on, at, held)
        if release:
            QTest.mouseRelease(on, LEFT, held, end - off)
        self.used.settle()

    def _move(self, on: Any, at: QPoint, held: Any) -> None:
        # QTest.mouseMove holds neither a button nor a key.
        where = QPointF(at)
        moved = QEvent.Type.MouseMove
        event = QMouseEvent(moved, where, on.mapToGlobal(where), LEFT, LEFT, held)
        QApplication.sendEvent(on, event)

    def undo(self) -> None:
        self.used.window.actions_.actions["undo"].trigger()
        self.used.settle()


@pytest.fixture
def drawing(studio: Start, project: Copy) -> Drawing:
    return Drawing(studio(project("reception")))


def test_a_guide_comes_out_of_a_ruler_goes_with_the_mouse_and_back_into_the_ruler(
    drawing: Drawing,
) -> None:
    used, ground = drawing.used, drawing.ground
    drawing.drag(drawing.beside, QPoint(4, 200), drawing.spot(22.3, 30))
    assert drawing.guides == ["x22"]
    assert used.session.undo_text == "Add a guide"
    drawing.drag(drawing.above, QPoint(200, 4), drawing.spot(30, 63.5), ALT)
    assert drawing.guides[0] == "x22"
    assert 63.2 <= float(drawing.guides[1][1:]) <= 63.8
    # The mouse shows what it would take, on the screen where nothing lies and on the ground.
    for on, y in ((drawing.sheet, 97), (ground, -3)):
        off = on.pos() if on is not ground else QPoint()
        for x, shape in ((22, Qt.CursorShape.SplitHCursor), (60, Qt.CursorShape.ArrowCursor)):
            QTest.mouseMove(on, drawing.spot(x, y) - off)
            used.settle()
            assert on.cursor().shape() == shape
    drawing.drag(drawing.sheet, drawing.spot(22, 97), drawing.spot(33, 97))
    assert drawing.guides[0] == "x33"
    assert used.session.undo_text == "Move a guide"
    drawing.drag(ground, drawing.spot(33, -3), drawing.spot(40, -3))
    assert drawing.guides[0] == "x40"
    # To the edge of a component that is near: the button NO begins at 52.
    drawing.drag(ground, drawing.spot(40, -3), drawing.spot(51.6, -3))
    no = drawing.sheet.own()["no"]
    assert drawing.guides[0] == f"x{no.x:g}"
    # On a component the component is taken, not the guide.
    drawing.drag(
        drawing.sheet, drawing.spot(no.x + 0.3, no.y + 3), drawing.spot(no.x + 5, no.y + 3)
    )
    assert used.session.undo_text == "Move no"
    drawing.undo()
    # Given up, and back into the ruler.
    before = used.session.undo_text
    start = drawing.spot(no.x, -3)
    drawing.drag(ground, start, drawing.spot(70, -3), release=False)
    used.key(Qt.Key.Key_Escape)
    QTest.mouseRelease(ground, LEFT, NONE, drawing.spot(70, -3))
    assert drawing.guides[0] == f"x{no.x:g}"
    assert used.session.undo_text == before
    drawing.drag(ground, start, QPoint(5, start.y()))
    assert len(drawing.guides) == 1
    assert used.session.undo_text == "Remove a guide"
    drawing.undo()
    assert drawing.guides[0] == f"x{no.x:g}"
    # One that is let go over the ruler it came from was never there, nor one that is given up;
    # what is selected stays so.
    drawing.drag(drawing.beside, QPoint(4, 200), QPoint(6, 220))
    assert len(drawing.guides) == 2
    drawing.sheet.choose(("no",))
    drawing.drag(drawing.beside, QPoint(4, 200), drawing.spot(70, 30), release=False)
    used.key(Qt.Key.Key_Escape)
    QTest.mouseRelease(drawing.beside, LEFT, NONE, QPoint(4, 200))
    assert len(drawing.guides) == 2
    assert drawing.sheet.selected == ("no",)
    # A double click takes it as a click does: arrows move it.
    for press in (QTest.mouseClick, QTest.mouseDClick):
        press(ground, LEFT, NONE, start)
    used.settle()
    used.key(Qt.Key.Key_Right, ALT)
    assert used.session.undo_text == "Move a guide"
    assert drawing.sheet.selected == ("no",)


def test_arrows_move_the_guide_that_has_the_focus_and_delete_removes_it(drawing: Drawing) -> None:
    used = drawing.used
    used.window.context_menus.open(("screen",), drawing.ground.mapToGlobal(QPoint(30, 30)))
    assert "Guides" in [one.text() for one in open_menu().actions()]
    open_menu().close()
    used.settle()
    used.window.actions_.actions["guide.upright"].trigger()
    used.settle()
    line = drawing.designer.guiding.lines[0]
    assert drawing.guides == ["x50"]
    assert line.hasFocus()
    assert line.accessibleName() == "Upright guide at 50 %"
    for key, held, at in (
        (Qt.Key.Key_Left, NONE, "x49"),
        (Qt.Key.Key_Right, SHIFT, "x59"),
        (Qt.Key.Key_Right, ALT, "x59.1"),
        (Qt.Key.Key_Up, NONE, "x59.1"),
    ):
        used.key(key, held)
        assert drawing.guides == [at]
        assert drawing.designer.guiding.lines[0].hasFocus()
    assert line.accessibleName() == "Upright guide at 59.1 %"
    drawing.undo()
    assert drawing.guides == ["x59"]
    used.key(Qt.Key.Key_Escape)
    assert drawing.sheet.hasFocus()
    # Tab comes to it, behind the last component.
    drawing.sheet.choose((next(reversed(drawing.sheet.own())),))
    used.key(Qt.Key.Key_Tab)
    assert QApplication.focusWidget() is drawing.designer.guiding.lines[0]
    # Delete takes the guide, not the component or the state that is selected.
    states = len(used.session.document("reception.rbd.xml").states)
    components = len(drawing.sheet.own())
    used.key(Qt.Key.Key_Delete)
    assert drawing.guides == []
    assert drawing.designer.guiding.lines == ()
    assert drawing.sheet.hasFocus()
    assert len(used.session.document("reception.rbd.xml").states) == states
    assert len(drawing.sheet.own()) == components
    used.window.actions_.actions["guide.upright"].trigger()
    used.window.actions_.actions["guide.lying"].trigger()
    assert drawing.guides == ["x50", "y50"]
    # One that is undone hands the keyboard to no other guide.
    used.window.actions_.actions["guide.upright"].trigger()
    assert [line.hasFocus() for line in drawing.designer.guiding.lines] == [False, True, False]
    drawing.undo()
    assert drawing.guides == ["x50", "y50"]
    assert drawing.sheet.hasFocus()
    used.window.actions_.actions["guide.clear"].trigger()
    assert drawing.guides == []
    used.settle()
    assert not used.window.actions_.actions["guide.clear"].isEnabled()


def test_tab_goes_through_all_guides_behind_the_last_component_wherever_they_stand(
    drawing: Drawing,
) -> None:
    used = drawing.used
    document = used.session.document("reception.rbd.xml")
    every = (Guide("x", 2), Guide("x", 70), Guide("y", 20), Guide("y", 85))
    used.session.commit("reception.rbd.xml", guides.put(document, every), "Guides")
    used.settle()
    sheet, lines = drawing.sheet, drawing.designer.guiding.lines
    sheet.setFocus()
    sheet.choose((next(reversed(sheet.own())),))
    visited = []
    for _ in range(6):
        used.key(Qt.Key.Key_Tab)
        visited.append(QApplication.focusWidget())
    assert visited[:4] == list(lines)
    assert not {*visited[4:]} & {sheet, *lines}
    back = []
    for _ in range(6):
        used.key(Qt.Key.Key_Backtab, SHIFT)
        back.append(QApplication.focusWidget())
    assert back[1:] == [*reversed(lines), sheet]


def test_the_place_of_a_guide_is_read_whole_in_large_letters_too(drawing: Drawing) -> None:
    used = drawing.used
    document = used.session.document("reception.rbd.xml")
    letters.use(150)
    try:
        used.session.commit(
            "reception.rbd.xml", guides.put(document, (Guide("x", 58.8),)), "Guides"
        )
        used.settle()
        (line,) = drawing.designer.guiding.lines
        line.setFocus()
        seen, ink = line.grab().toImage(), used.window.theme.color("guides")
    finally:
        letters.use(100)
    # Its ground is seen in the row of pixels where the pill stands, and ends within.
    row = round((line.height() - 8) * seen.devicePixelRatio())
    inked = [x for x in range(seen.width()) if seen.pixelColor(x, row) == ink]
    assert len(inked) > 10
    assert inked[0] > 0
    assert inked[-1] < seen.width() - 1


@pytest.mark.parametrize("colours", [LIGHT, DARK], ids=lambda one: one.name)
def test_a_guide_is_seen_on_the_robot_s_screen_and_on_the_ground_in_both_themes(
    drawing: Drawing, colours: Theme
) -> None:
    used, sheet, ground = drawing.used, drawing.sheet, drawing.ground
    document = used.session.document("reception.rbd.xml")
    both = (Guide("x", 33.3), Guide("y", 97.3))
    used.session.commit("reception.rbd.xml", guides.put(document, both), "Guides")
    used.window.set_theme(colours)
    used.settle()
    upright, lying = (line.geometry().center() for line in drawing.designer.guiding.lines)
    seen = ground.grab().toImage()
    ratio = seen.devicePixelRatio()

    def told(x: float, y: float, across: int, down: int) -> float:
        """How far the line there differs from what is beside it."""
        beside = seen.pixelColor(round((x + 5 * across) * ratio), round((y + 5 * down) * ratio))
        on = (
            seen.pixelColor(round((x + by * across) * ratio), round((y + by * down) * ratio))
            for by in (-1, 0, 1)
        )
        return max(contrast(colour, beside) for colour in on)

    free = sheet.geometry()
    assert told(upright.x(), free.bottom() - 3, 1, 0) >= 3
    assert told(upright.x(), ground.room.bottom() - 3, 1, 0) >= 3
    assert told(free.left() + 3, lying.y(), 0, 1) >= 3
    assert told(ground.room.right() - 3, lying.y(), 0, 1) >= 3


def test_components_are_drawn_to_guides_which_no_robot_gets(drawing: Drawing) -> None:
    used = drawing.used
    drawing.drag(drawing.beside, QPoint(4, 200), drawing.spot(31, 97), ALT)
    at = float(drawing.guides[0][1:])
    yes = drawing.sheet.own()["yes"]
    middle = QPoint(round(yes.x + yes.width / 2), round(yes.y + yes.height / 2))
    start = drawing.spot(middle.x(), middle.y())
    # Its left edge comes near the guide, and is on it then.
    drawing.drag(drawing.sheet, start, drawing.spot(middle.x() + at - yes.x + 0.6, middle.y()))
    assert drawing.sheet.own()["yes"].x == pytest.approx(at, abs=0.06)
    # With the mouse on a guide it follows, too: its middle is drawn to the guide then.
    start = drawing.spot(round(at + yes.width / 2), middle.y())
    drawing.drag(drawing.sheet, start, drawing.spot(at, 97))
    moved = drawing.sheet.own()["yes"]
    assert moved.x + moved.width / 2 == pytest.approx(at, abs=0.06)
    # On other screens of the application the guides are the same.
    used.window.select(("state", "5"))
    used.settle()
    assert [line.guide.at for line in drawing.designer.guiding.lines] == [at]
    used.window.actions_.actions["save"].trigger()
    root = used.session.root
    assert f'ed:guides="x{at:g}"' in (root / "reception.rbd.xml").read_text()
    project, _ = load(root)
    assert project is not None
    assert b"guides" not in deployable(project)["reception.rbd.xml"]


def test_guides_are_seen_and_drawn_to_beside_the_graph_too(drawing: Drawing) -> None:
    used = drawing.used
    drawing.drag(drawing.beside, QPoint(4, 200), drawing.spot(31, 97), ALT)
    at = float(drawing.guides[0][1:])
    used.click(used.window.tabs.views.button("split"))
    used.settle()
    sheet = used.window.beside.sheet

    def is_seen() -> bool:
        seen = sheet.grab().toImage()
        ratio, ink = seen.devicePixelRatio(), LIGHT.color("guides")
        x = round(sheet.scale.point(at, 3).x() * ratio)
        y = round(sheet.scale.point(at, 3).y() * ratio)
        return any(seen.pixelColor(x + by, y) == ink for by in (-1, 0, 1))

    assert is_seen()
    yes = sheet.own()["yes"]
    middle = (yes.x + yes.width / 2, yes.y + yes.height / 2)
    start = sheet.scale.point(*middle).toPoint()
    end = sheet.scale.point(middle[0] + at - yes.x + 0.6, middle[1]).toPoint()
    QTest.mousePress(sheet, LEFT, NONE, start)
    for part in (1, 2, 3):
        drawing._move(sheet, start + (end - start) * part / 3, NONE)
    QTest.mouseRelease(sheet, LEFT, NONE, end)
    used.settle()
    assert sheet.own()["yes"].x == pytest.approx(at, abs=0.06)
    drawing.undo()
    drawing.undo()
    assert drawing.guides == []
    assert not is_seen()
