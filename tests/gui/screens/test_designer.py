"""The screen designer: a view of its own, used with mouse and keys."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import (
    QCoreApplication,
    QMimeData,
    QModelIndex,
    QPoint,
    QPointF,
    Qt,
    QTimer,
    QUrl,
)
from PySide6.QtGui import QColor, QDragEnterEvent, QDropEvent, QGuiApplication, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QPushButton

from situ.document.codec import write
from situ_studio.screens.own_device import OwnDevice
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


def row_at(view: Any, row: int) -> QPoint:
    found: QModelIndex = view.model().index(row, 0)
    view.scrollTo(found)
    point: QPoint = view.visualRect(found).center()
    return point


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


def test_a_template_gives_the_state_its_screen_and_events_in_one_step(desk: Desk) -> None:
    desk.go_to("7")
    before = write(desk.document)
    desk.used.click(desk.side.templates.tiles["two-answers"])
    state = desk.document.state("7")
    assert [c.id for c in state.screen.components] == ["question", "hint", "yes", "no"]
    assert {"clickYes", "clickNo"} <= {event.name for event in state.events}
    assert desk.used.session.undo_text == "Template Two answers for state 7"
    desk.undo()
    assert write(desk.document) == before


def test_what_lies_on_the_screen_is_selected_and_dragged_into_another_order(desk: Desk) -> None:
    desk.go_to("2")
    layers = desk.side.layers
    assert layers.ids == ["continue", "robot", "who", "hello", ""]
    QTest.mouseClick(layers.viewport(), LEFT, pos=row_at(layers, 1))
    desk.used.settle()
    assert desk.window.inspector.place == ("state", "2", "screen", "robot")
    assert desk.sheet.selected == ("robot",)
    # Onto the upper half of the first row: before all others.
    port, start, end = layers.viewport(), row_at(layers, 1), row_at(layers, 0) - QPoint(0, 8)
    QTest.mousePress(port, LEFT, pos=start)
    for part in (1, 2, 3):
        QTest.mouseMove(port, start + (end - start) * part / 3)
    QTest.mouseRelease(port, LEFT, pos=end)
    desk.used.settle()
    assert [c.id for c in desk.components("2")] == ["hello", "who", "continue", "robot"]
    assert desk.used.session.undo_text == "Reorder robot"
    layers.setFocus()
    desk.used.key(Qt.Key.Key_Down, ALT)
    assert [c.id for c in desk.components("2")] == ["hello", "who", "robot", "continue"]
    QTest.mouseClick(layers.viewport(), LEFT, pos=row_at(layers, 4))
    desk.used.settle()
    assert desk.window.inspector.place == ("state", "2", "screen")
    assert [index.row() for index in layers.selectedIndexes()] == [4]
    desk.used.fill(desk.window.inspector.form.field("background"), "lobby.png")
    assert desk.document.state("2").screen.background == "lobby.png"


def test_a_tag_is_put_into_a_text_by_a_press_or_a_drop(desk: Desk) -> None:
    desk.go_to("2")
    desk.used.click(desk.sheet, desk.at(20, 25))
    desk.used.click(desk.side.tags.chip("user.name"))
    assert desk.components("2")[0].text == "Hello! {user.name}"
    assert desk.drop(dragged("user.name"), 20, 50)
    assert desk.components("2")[1].text.endswith("today? {user.name}")
    assert desk.drop(dragged("spo2.value"), 80, 90)
    assert desk.components("2")[-1].text == "{spo2.value}"
    # Into a field of the form, at the place where it is dropped: an edit at once.
    desk.used.select("state", "2", "screen", "continue")
    field = desk.window.inspector.form.field("text")
    at, data, copy = QPoint(2, 10), dragged("user.name"), Qt.DropAction.CopyAction
    QCoreApplication.sendEvent(field, QDragEnterEvent(at, copy, data, LEFT, NONE))
    QCoreApplication.sendEvent(field, QDropEvent(QPointF(at), copy, data, LEFT, NONE))
    desk.used.settle()
    said = next(c.text for c in desk.components("2") if c.id == "continue")
    assert said == "{user.name}CONTINUE"


def test_a_screen_of_another_size_changes_the_look_and_not_the_document(desk: Desk) -> None:
    desk.go_to("2")
    before, wide = desk.document, desk.sheet.width()
    assert desk.designer.ground.zoom == pytest.approx(wide / 1280)
    desk.used.choose(desk.bar.devices, "7 inch, 1024 × 600")
    assert desk.sheet.width() / desk.sheet.height() == pytest.approx(1024 / 600, abs=0.01)
    desk.used.click(desk.bar.ways.button("upright"))
    assert desk.sheet.width() / desk.sheet.height() == pytest.approx(600 / 1024, abs=0.01)
    assert desk.bar.devices.currentText() == "7 inch, 600 × 1024"
    assert desk.document is before


def test_texts_are_filled_with_sample_values_that_a_person_chooses(desk: Desk) -> None:
    desk.go_to("10")
    before, filled = desk.document, desk.sheet.grab().toImage()
    assert "user.name = Jack Nilsen" in desk.bar.samples.accessibleName()
    desk.used.click(desk.bar.samples)
    popup = desk.designer.sampling.popup
    line = popup.fields["user.name"].lineEdit()
    QTest.mouseClick(line, LEFT)
    line.selectAll()
    QTest.keyClicks(line, "Mere")
    QTest.keyClick(line, Qt.Key.Key_Return)
    desk.used.settle()
    assert desk.bar.samples.accessibleName() == "Sample values: user.name = Mere"
    other = desk.sheet.grab().toImage()
    assert other != filled
    QTest.mouseClick(popup.use, LEFT, pos=QPoint(8, popup.use.height() // 2))
    desk.used.settle()
    assert desk.sheet.grab().toImage() not in (filled, other)
    popup.close()
    assert desk.document is before


def test_what_is_in_every_state_can_be_hidden_while_one_designs(desk: Desk) -> None:
    desk.go_to("2")
    shown = desk.sheet.grab().toImage()
    desk.used.click(desk.bar.always)
    hidden = desk.sheet.grab().toImage()
    assert hidden != shown
    desk.used.click(desk.bar.always)
    assert desk.sheet.grab().toImage() == shown


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


def test_a_file_is_chosen_in_the_form_and_a_missing_one_is_told(desk: Desk, tmp_path: Path) -> None:
    desk.go_to("2")
    source = tmp_path / "other.png"
    QImage(8, 8, QImage.Format.Format_RGB32).save(str(source))
    desk.used.select("state", "2", "screen", "robot")
    desk.used.answers.put("media_file", str(source))
    form = desk.window.inspector.form
    button = next(b for b in form.findChildren(QAbstractButton) if "Choose" in b.toolTip())
    desk.used.click(button)
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


def test_the_preview_shows_the_screen_without_marks_and_goes_with_a_key(desk: Desk) -> None:
    desk.go_to("2")
    desk.used.click(desk.sheet, desk.at(50, 80))
    desk.used.click(desk.bar.preview)
    preview = desk.designer.preview
    assert preview.isVisible()
    assert preview.screen_.width() * 800 == pytest.approx(preview.screen_.height() * 1280, rel=0.01)
    QTest.keyClick(preview, Qt.Key.Key_Escape)
    desk.used.settle()
    assert desk.designer.preview is None


def test_a_component_is_pressed_or_dropped_and_stands_in_the_middle(desk: Desk) -> None:
    desk.go_to("2")
    desk.used.click(desk.side.components.items["button"])
    made = desk.components("2")[-1]
    assert made.element == "button"
    assert desk.window.inspector.place == ("state", "2", "screen", made.id)
    assert abs(made.x + made.width / 2 - 50) <= 1


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


def test_a_state_that_runs_a_part_takes_no_component_template_or_file(
    desk: Desk, tmp_path: Path
) -> None:
    part = next(s for s in desk.document.states if s.flow is not None)
    desk.go_to(part.no)
    before = desk.document
    desk.used.click(desk.side.templates.tiles["list"])
    assert part.flow in desk.told()
    source = tmp_path / "mine.png"
    QImage(8, 8, QImage.Format.Format_RGB32).save(str(source))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(source))])
    desk.drop(data, 50, 50)
    assert desk.document is before
    assert not (desk.used.session.root / "media" / "mine.png").exists()


def test_a_screen_of_one_s_own_size_is_asked_for(desk: Desk) -> None:
    def answer(tries: int) -> None:
        asked = QApplication.activeModalWidget()
        if not isinstance(asked, OwnDevice):
            assert tries, "nobody asked"
            QTimer.singleShot(0, lambda: answer(tries - 1))
            return
        for field, text in ((asked.wide, "600"), (asked.high, "1600")):
            field.setFocus()
            field.selectAll()
            QTest.keyClicks(field, text)
        QTest.keyClick(asked, Qt.Key.Key_Return)

    QTimer.singleShot(0, lambda: answer(2000))
    # By the arrow keys, past the phone, whose diagonal is offered then.
    desk.used.choose(desk.bar.devices, "Own size…")
    desk.used.settle()
    device = desk.designer.device
    assert (device.wide, device.high, device.key) == (600, 1600, "own")
    assert desk.bar.devices.currentText() == "6 inch, 600 × 1600"
    assert desk.sheet.height() > desk.sheet.width()


def test_another_project_leaves_nothing_of_the_designer(desk: Desk, project: Copy) -> None:
    desk.window.open_project(project("conversation"))
    desk.used.settle()
    assert not desk.window.docks["designer"].isVisible()
    assert desk.window.docks["project"].isVisible()
    assert desk.window.designer_stack.count() == 0
