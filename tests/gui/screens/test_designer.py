"""The screen designer: a view of its own, used with mouse and keys."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import (
    QCoreApplication,
    QMimeData,
    QPoint,
    QPointF,
    Qt,
    QUrl,
)
from PySide6.QtGui import QColor, QDragEnterEvent, QDropEvent, QGuiApplication, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QPushButton

from situ_studio.screens.tag_chips import dragged

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
ALT = Qt.KeyboardModifier.AltModifier
CONTROL = Qt.KeyboardModifier.ControlModifier
FILE = "reception.rbd.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


class Desk:
    """The designer of a project, and hands that use it."""

    def __init__(self, used: Any) -> None:
        self.used = used
        self.window = used.window
        used.click(self.window.tabs.views.button("screen"))
        self.designer = self.window.current_view.piece("designer")
        self.side, self.bar, self.sheet = (
            self.designer.side,
            self.designer.bar,
            self.designer.sheet,
        )

    @property
    def document(self) -> Any:
        return self.used.session.document(self.window.current_file)

    def go_to(self, no: str) -> None:
        """A click in the strip of states."""
        strip = self.designer.strip
        row = next(r for r, s in enumerate(strip.model().places) if s == ("state", no))
        index = strip.model().index(row)
        strip.scrollTo(index)
        QTest.mouseClick(strip.viewport(), LEFT, pos=strip.visualRect(index).center())
        self.used.settle()

    def components(self, no: str) -> Any:
        return self.document.state(no).screen.components

    def at(self, x: float, y: float) -> QPoint:
        return QPoint(round(self.sheet.width() * x / 100), round(self.sheet.height() * y / 100))

    def drop(self, data: QMimeData, x: float, y: float) -> bool:
        """Drags something onto the sheet; whether it was taken."""
        copy, at = Qt.DropAction.CopyAction, self.at(x, y)
        enter = QDragEnterEvent(at, copy, data, LEFT, NONE)
        QCoreApplication.sendEvent(self.sheet, enter)
        if enter.isAccepted():
            QCoreApplication.sendEvent(self.sheet, QDropEvent(QPointF(at), copy, data, LEFT, NONE))
        self.used.settle()
        return enter.isAccepted()

    def told(self) -> str:
        """What the status bar says."""
        return str(self.window.status.said.text())

    def undo(self) -> None:
        self.window.actions_.actions["undo"].trigger()
        self.used.settle()


@pytest.fixture
def desk(studio: Start, project: Copy) -> Desk:
    return Desk(studio(project("reception")))


def test_the_panel_of_the_designer_stands_where_project_outline_and_palette_stood(
    desk: Desk,
) -> None:
    window, docks = desk.window, desk.window.docks
    left = ("project", "outline", "palette")
    assert docks["designer"].isVisible()
    assert desk.side.isVisible()
    assert not any(docks[name].isVisible() for name in left)
    assert window.bottom.is_folded
    desk.used.key(Qt.Key.Key_1, CONTROL)
    assert not docks["designer"].isVisible()
    assert all(docks[name].isVisible() for name in left)
    assert not window.bottom.is_folded
    desk.used.key(Qt.Key.Key_4, CONTROL)
    assert docks["designer"].isVisible()
    # Another document has no screens.
    window.open_file("modules.xml")
    desk.used.settle()
    assert not docks["designer"].isVisible()
    assert docks["project"].isVisible()


def test_side_by_side_the_panels_stay_while_the_focus_goes_from_one_to_the_other(
    desk: Desk,
) -> None:
    window, docks = desk.window, desk.window.docks
    window.sides.beside_asked.emit(FILE, False)
    desk.used.settle()
    graph = window.current_view
    window.show_mode("graph")
    desk.used.settle()
    groups = window.sides.groups
    assert [group.current_view.shown_as for group in groups] == ["screen", "graph"]

    def standing() -> list[str]:
        return [name for name, dock in docks.items() if dock.isVisible()]

    before, folded = standing(), window.bottom.is_folded
    assert "designer" in before
    for group in (groups[0], groups[1], groups[0]):
        window.sides.enter(group)
        desk.used.settle()
        assert (standing(), window.bottom.is_folded) == (before, folded)
    # What is pressed there is done in the designer, wherever the focus was.
    window.sides.enter(groups[1])
    desk.designer.go_to(("state", "2"))
    count = len(desk.components("2"))
    desk.used.click(desk.side.components.findChildren(QAbstractButton)[0])
    assert len(desk.components("2")) == count + 1
    # When no designer is seen, everything is as it was.
    window.show_mode("graph")
    desk.used.settle()
    assert not docks["designer"].isVisible()
    assert docks["palette"].isVisible()
    assert graph.shown_as == "graph"


def test_the_state_is_chosen_in_the_strip_by_the_keys_and_left_by_the_names_above(
    desk: Desk,
) -> None:
    window, crumbs = desk.window, desk.designer.crumbs
    desk.go_to("5")
    assert window.inspector.place == ("state", "5")
    assert crumbs.button("5 verify initials").isVisible()
    desk.sheet.setFocus()
    desk.used.key(Qt.Key.Key_PageDown)
    assert window.current_view.selected == (("state", "6"),)
    desk.used.key(Qt.Key.Key_PageUp)
    desk.used.key(Qt.Key.Key_PageUp)
    assert window.current_view.selected == (("state", "4"),)
    desk.used.click(crumbs.button("4 enter initial 2"))
    assert window.current_view.shown_as == "graph"
    assert window.current_view.selected == (("state", "4"),)


def test_a_tag_is_dropped_into_a_field_and_the_background_has_its_form(desk: Desk) -> None:
    desk.go_to("2")
    # At the place where it is dropped, an edit at once.
    desk.used.select("state", "2", "screen", "continue")
    field = desk.window.inspector.form.field("text")
    at, data, copy = QPoint(2, 10), dragged("user.name"), Qt.DropAction.CopyAction
    QCoreApplication.sendEvent(field, QDragEnterEvent(at, copy, data, LEFT, NONE))
    QCoreApplication.sendEvent(field, QDropEvent(QPointF(at), copy, data, LEFT, NONE))
    desk.used.settle()
    said = next(c.text for c in desk.components("2") if c.id == "continue")
    assert said == "{user.name}CONTINUE"
    layers = desk.side.layers
    last = layers.model().index(layers.model().rowCount() - 1, 0)
    layers.scrollTo(last)
    QTest.mouseClick(layers.viewport(), LEFT, pos=layers.visualRect(last).center())
    desk.used.settle()
    assert desk.window.inspector.place == ("state", "2", "screen")
    desk.used.fill(desk.window.inspector.form.field("background"), "lobby.png")
    assert desk.document.state("2").screen.background == "lobby.png"


def test_a_picture_from_outside_is_copied_into_the_project_and_stands_where_it_was_dropped(
    desk: Desk, tmp_path: Path
) -> None:
    desk.go_to("2")
    picture = QImage(40, 20, QImage.Format.Format_RGB32)
    picture.fill(QColor("teal"))
    source = tmp_path / "My Photo.PNG"
    assert picture.save(str(source))
    count, steps = len(desk.components("2")), desk.used.session.undo_text
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(source))])
    assert desk.drop(data, 50, 50)
    made = desk.components("2")[-1]
    assert (made.element, made.src) == ("image", "my-photo.png")
    assert abs(made.x + made.width / 2 - 50) <= 1
    assert (desk.used.session.root / "media" / "my-photo.png").read_bytes() == source.read_bytes()
    desk.undo()
    assert (len(desk.components("2")), desk.used.session.undo_text) == (count, steps)
    # The clipboard's picture comes by Ctrl+V.
    picture.fill(QColor("orange"))
    QGuiApplication.clipboard().setImage(picture)
    desk.sheet.setFocus()
    desk.used.key(Qt.Key.Key_V, CONTROL)
    assert desk.components("2")[-1].src == "pasted.png"
    # What the robot's page can not show is refused in words.
    notes = tmp_path / "notes.txt"
    notes.write_text("x", encoding="utf-8")
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(notes))])
    count = len(desk.components("2"))
    desk.drop(data, 50, 50)
    assert len(desk.components("2")) == count
    assert "notes.txt" in desk.told()


def test_what_a_pressed_component_says_is_typed_at_once(desk: Desk) -> None:
    """As after a press in the palette beside the graph: no click into a field is between."""
    desk.go_to("11")
    for kind, field, words in (
        ("text", "text", "Shall I wait?"),
        ("button", "text", "Wait"),
        ("input", "tag", "user.room"),
    ):
        desk.used.click(desk.side.components.items[kind])
        desk.used.type(words)
        desk.used.key(Qt.Key.Key_Tab)
        made = desk.document.state("11").screen.components[-1]
        assert getattr(made, field) == words
        # On the screen, where it is seen at once; what has no words of its own in its form.
        assert (QApplication.focusWidget() is desk.sheet) == (kind in ("text", "button"))


def test_after_a_template_the_keyboard_is_on_the_screen(desk: Desk) -> None:
    """The form in which somebody wrote is gone with its component."""
    desk.go_to("11")
    desk.used.select("state", "11", "screen", "goodbye")
    desk.used.click(desk.window.inspector.form.field("text"))
    desk.used.click(desk.side.templates.tiles["two-answers"])
    assert desk.sheet.hasFocus()
    desk.used.key(Qt.Key.Key_Tab)
    assert desk.sheet.selected == ("question",)


def test_a_file_is_chosen_in_the_form_and_a_missing_one_is_told(desk: Desk, tmp_path: Path) -> None:
    desk.go_to("2")
    source = tmp_path / "other.png"
    QImage(8, 8, QImage.Format.Format_RGB32).save(str(source))
    desk.used.select("state", "2", "screen", "robot")
    desk.used.answers.put("media_file", str(source))
    form = desk.window.inspector.form
    button = next(b for b in form.findChildren(QAbstractButton) if "Choose" in b.toolTip())
    desk.used.click(button)
    desk.used.type("elsewhere")
    desk.used.key(Qt.Key.Key_Return)
    robot = next(c for c in desk.components("2") if c.id == "robot")
    assert robot.src == "other.png"
    assert desk.sheet.missing() == {}
    desk.used.fill(form.field("src"), "gone.png")
    assert desk.sheet.missing() == {"robot": "gone.png"}


def test_the_form_says_what_is_fit_and_where_a_touch_leads(desk: Desk) -> None:
    desk.go_to("5")
    desk.used.select("state", "5", "screen", "no")
    form = desk.window.inspector.form
    said = [label.text() for label in form.told("fit").findChildren(QLabel)]
    assert "91 × 33 mm, at least 12 mm is needed" in said
    # On another screen it is as large as it is there, and which one is told.
    desk.used.choose(desk.bar.devices, "7 inch, 1024 × 600")
    said = [label.text() for label in form.told("fit").findChildren(QLabel)]
    assert "On this screen: 7 inch, 1024 × 600" in said
    assert "64 × 22 mm, at least 12 mm is needed" in said
    desk.used.choose(desk.bar.devices, "10 inch, 1280 × 800")
    desk.used.click(form.told("align").buttons["center"])
    no = next(c for c in desk.components("5") if c.id == "no")
    assert no.x == pytest.approx(50 - no.width / 2)
    desk.undo()
    # An event that nobody expects is mended with a press.
    desk.used.fill(form.field("event"), "clickNever")
    mend = next(b for b in form.told("touched").findChildren(QPushButton) if b.isVisible())
    assert mend.text() == "Expect clickNever"
    desk.used.click(mend)
    assert desk.document.state("5").events[-1].name == "clickNever"
    assert desk.used.session.undo_text == "Expect clickNever in state 5"
    desk.used.fill(desk.window.inspector.form.field("event"), "clickNo")
    form = desk.window.inspector.form
    answer = next(b for b in form.told("touched").findChildren(QPushButton) if b.isVisible())
    desk.used.click(answer)
    assert desk.window.current_view.selected == (("state", "3"),)


def test_several_components_are_aligned_and_spread_from_the_form(desk: Desk) -> None:
    desk.go_to("1")
    chosen = tuple(("state", "1", "screen", id) for id in ("hello", "english", "japanese"))
    desk.window.select_all(chosen[1:])
    desk.used.settle()
    several = desk.window.inspector.several
    assert several.isVisible()
    assert not several.gaps.buttons["across"].isEnabled()
    desk.used.click(several.edges.buttons["left"])
    first, second = (c for c in desk.components("1") if c.id in ("english", "japanese"))
    assert first.x == second.x
    assert desk.sheet.selected == ("english", "japanese")
    desk.window.select_all(chosen)
    desk.used.settle()
    assert several.gaps.buttons["down"].isEnabled()
    desk.used.select("state", "1")
    assert not several.isVisible()


def test_another_project_leaves_nothing_of_the_designer(desk: Desk, project: Copy) -> None:
    desk.window.open_project(project("conversation"))
    desk.used.settle()
    assert not desk.window.docks["designer"].isVisible()
    assert desk.window.docks["project"].isVisible()
    assert desk.window.designer_stack.count() == 0


def test_a_double_click_on_the_small_picture_of_a_card_opens_its_screen(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    window = used.window
    canvas = window.current_view.canvas
    canvas.choose(("state", "2"))
    used.settle()
    card = canvas.graph.nodes[canvas.selected_uids()[0]].view
    spot = canvas.viewer.mapFromScene(card.mapToScene(card.picture_area().center()))
    # Beside the picture it is the form that is wanted.
    body = canvas.viewer.mapFromScene(card.mapToScene(QPointF(100, 100)))
    QTest.mouseClick(canvas.viewer.viewport(), LEFT, pos=body)
    QTest.mouseDClick(canvas.viewer.viewport(), LEFT, pos=body)
    used.settle()
    assert window.current_view.shown_as == "graph"
    QTest.mouseClick(canvas.viewer.viewport(), LEFT, pos=spot)
    QTest.mouseDClick(canvas.viewer.viewport(), LEFT, pos=spot)
    used.settle()
    assert window.current_view.shown_as == "screen"
    designer = window.current_view.piece("designer")
    assert designer.shown.place == ("state", "2")
    # An edit here costs nothing of the graph, which is brought up to date when it is seen.
    used.click(designer.side.components.findChildren(QAbstractButton)[0])
    assert canvas.document is not window.current_document
    used.key(Qt.Key.Key_1, CONTROL)
    assert canvas.document is window.current_document
    # What was selected before stays so.
    used.select("state", "10", "screen", "continue")
    used.key(Qt.Key.Key_4, CONTROL)
    assert designer.shown.place == ("state", "10")
    assert designer.sheet.selected == ("continue",)


def test_what_a_text_can_name_is_the_same_in_chips_on_the_sheet_and_in_the_form(
    studio: Start, tmp_path: Path
) -> None:
    """All that the project knows: what its script observes too, and before a state is chosen."""
    (tmp_path / "situ.toml").write_text(
        '[project]\nname = "w"\napplications = ["w.rbd.xml"]\nspds = "w.spds.xml"\n'
        '[tags]\n"ward" = "3"\n',
        encoding="utf-8",
    )
    (tmp_path / "w.rbd.xml").write_text(
        '<application name="w"><state no="1" start="true"><screen><components>'
        '<text id="t" x="10" y="10" width="80" height="20">Hi</text>'
        "</components></screen></state></application>",
        encoding="utf-8",
    )
    (tmp_path / "w.spds.xml").write_text(
        '<spds name="w"><observe><data tag="heat" type="number"/></observe>'
        '<situation name="hot"><condition><data tag="robot/speech" exists="true"/></condition>'
        '</situation><situation name="else"/></spds>',
        encoding="utf-8",
    )
    desk = Desk(studio(tmp_path))
    assert [desk.side.tags.chip(tag).text() for tag in ("heat", "ward")] == ["heat", "ward"]
    desk.go_to("1")
    desk.used.select("state", "1", "screen", "t")
    in_form = desk.window.inspector.form.field("text")
    in_form.setFocus()
    desk.used.type("{")
    every = ["heat", "robot/speech", "ward"]
    assert in_form.tags.offered == every
    desk.used.key(Qt.Key.Key_Escape)
    desk.used.key(Qt.Key.Key_Escape)
    desk.sheet.setFocus()
    desk.used.key(Qt.Key.Key_F2)
    desk.used.type("{")
    assert desk.sheet.writing.field.tags.offered == every
    desk.used.key(Qt.Key.Key_Escape)
    desk.used.key(Qt.Key.Key_Escape)


def test_a_template_that_is_kept_is_offered_beside_every_open_document(desk: Desk) -> None:
    window = desk.window
    window.open_file("register.rbd.xml")
    window.show_mode("screen")
    desk.used.settle()
    other = window.current_view.piece("designer").side.templates
    assert not other.own
    window.open_file(FILE)
    desk.go_to("2")
    desk.used.answers.put("name", "mine")
    desk.used.click(desk.side.keep)
    assert list(desk.side.templates.own) == ["mine"]
    window.open_file("register.rbd.xml")
    desk.used.settle()
    assert list(other.own) == ["mine"]
