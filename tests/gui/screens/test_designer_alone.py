"""The designer alone, without a window round it: its devices, values, preview and refusals."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import (
    QCoreApplication,
    QEvent,
    QMimeData,
    QModelIndex,
    QPoint,
    QPointF,
    QRect,
    Qt,
    QTimer,
    QUrl,
)
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QHBoxLayout, QLabel, QLineEdit, QWidget

from situ.document import folder, rbd
from situ_studio.edits import places
from situ_studio.looks import letters
from situ_studio.looks.theme import LIGHT
from situ_studio.screens import placing
from situ_studio.screens.designer import Designer
from situ_studio.screens.devices import DEVICES
from situ_studio.screens.own_device import OwnDevice
from situ_studio.screens.own_templates import OwnTemplates
from situ_studio.screens.sample_popup import SamplePopup
from situ_studio.screens.shown import Content, content
from situ_studio.screens.tag_chips import dragged
from situ_studio.screens.template_tiles import dragged as dragged_template

LEFT = Qt.MouseButton.LeftButton
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
NONE = Qt.KeyboardModifier.NoModifier

Copy = Callable[[str], Path]


class Desk:
    """A designer whose edits are kept, and hands that use it."""

    def __init__(self, root: Path) -> None:
        project, _ = folder.load(root)
        assert project is not None
        self.root = root
        self.document: Any = next(iter(project.applications.values()))
        self.selected: Any = ()
        self.told: list[str] = []
        self.steps: list[str] = []
        self.designer = Designer(LIGHT, lambda: project, lambda: root / "media")
        self.designer.edited.connect(self._on_edited)
        self.designer.selection_changed.connect(self._on_selected)
        self.designer.status.connect(self.told.append)
        self.bar, self.sheet = self.designer.bar, self.designer.sheet
        # In the window its panel stands in a dock.
        self.holder = QWidget()
        line = QHBoxLayout(self.holder)
        line.addWidget(self.designer.side)
        line.addWidget(self.designer, 1)
        self.holder.resize(1100, 700)
        self.holder.show()
        self.designer.side.show()
        self._show()
        self.settle()

    def _show(self) -> None:
        self.designer.show_document(self.document, [])
        self.designer.select(self.selected)

    def _on_edited(self, after: Any, text: str) -> None:
        self.document = after
        self.steps.append(text)
        self._show()

    def _on_selected(self, chosen: tuple[tuple[str, ...], ...]) -> None:
        self.selected = chosen

    def settle(self) -> None:
        for _ in range(3):
            QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            QApplication.processEvents()

    def go_to(self, no: str) -> None:
        self.designer.go_to(("state", no))
        self.settle()

    def components(self, no: str) -> Any:
        return self.document.state(no).screen.components

    def click(self, widget: QWidget, at: QPoint | None = None) -> None:
        QTest.mouseClick(widget, LEFT, pos=at if at is not None else widget.rect().center())
        self.settle()

    def ask_for_samples(self) -> Any:
        """The only popup that there is."""
        self.click(self.bar.samples)
        (popup,) = self.bar.findChildren(SamplePopup)
        return popup

    def choose(self, combo: Any, text: str) -> None:
        """By the arrow keys."""
        combo.setFocus()
        for _ in range(combo.count()):
            if combo.currentText() == text:
                return
            QTest.keyClick(combo, Qt.Key.Key_Down)
            self.settle()

    def at(self, x: float, y: float) -> QPoint:
        """A place of the screen, from percents of it."""
        return QPoint(round(self.sheet.width() * x / 100), round(self.sheet.height() * y / 100))

    def drop(self, data: QMimeData, x: float = 50, y: float = 50) -> bool:
        """Drags something onto the sheet; whether it was taken."""
        at, copy = self.at(x, y), Qt.DropAction.CopyAction
        enter = QDragEnterEvent(at, copy, data, LEFT, NONE)
        QCoreApplication.sendEvent(self.sheet, enter)
        QCoreApplication.sendEvent(self.sheet, QDropEvent(QPointF(at), copy, data, LEFT, NONE))
        self.settle()
        return enter.isAccepted()


@pytest.fixture
def desk(qt: QApplication, project: Copy) -> Iterator[Desk]:
    made = Desk(project("reception"))
    yield made
    made.holder.close()
    made.holder.deleteLater()
    made.settle()


def test_a_screen_of_another_size_changes_the_look_and_not_the_document(desk: Desk) -> None:
    desk.go_to("2")
    before, wide = desk.document, desk.sheet.width()
    assert desk.designer.ground.zoom == pytest.approx(wide / 1280)
    desk.choose(desk.bar.devices, "7 inch, 1024 × 600")
    assert desk.sheet.width() / desk.sheet.height() == pytest.approx(1024 / 600, abs=0.01)
    desk.click(desk.bar.ways.button("upright"))
    assert desk.sheet.width() / desk.sheet.height() == pytest.approx(600 / 1024, abs=0.01)
    assert desk.bar.devices.currentText() == "7 inch, 600 × 1024"
    assert desk.document is before


def test_texts_are_filled_with_sample_values_that_a_person_chooses(desk: Desk) -> None:
    desk.go_to("10")
    before, filled = desk.document, desk.sheet.grab().toImage()
    assert "user.name = Jack Nilsen" in desk.bar.samples.accessibleName()
    popup = desk.ask_for_samples()
    line = popup.fields["user.name"].lineEdit()
    assert line is not None
    QTest.mouseClick(line, LEFT)
    line.selectAll()
    QTest.keyClicks(line, "Mere")
    QTest.keyClick(line, Qt.Key.Key_Return)
    desk.settle()
    assert desk.bar.samples.accessibleName() == "Sample values: user.name = Mere"
    other = desk.sheet.grab().toImage()
    assert other != filled
    QTest.mouseClick(popup.use, LEFT, pos=QPoint(8, popup.use.height() // 2))
    desk.settle()
    assert desk.sheet.grab().toImage() not in (filled, other)
    popup.close()
    assert desk.document is before


def test_a_screen_is_looked_at_in_the_language_that_is_picked(desk: Desk) -> None:
    desk.go_to("2")
    written = {one.text for one in desk.components("2") if hasattr(one, "text")}
    popup = desk.ask_for_samples()
    desk.choose(popup.fields["language"], "ja")
    popup.close()
    screen: Any = desk.designer.shown.screen
    shown = content(screen, (), desk.designer.shown.values)
    seen = {one["text"] for one in shown.components if "text" in one}
    assert shown.language == "ja"
    assert seen
    assert not seen & written
    # The preview speaks it too.
    desk.click(desk.bar.preview)
    preview: Any = desk.designer.preview
    assert preview.walk.shown["language"] == "ja"
    QTest.keyClick(preview, Qt.Key.Key_Escape)
    desk.settle()


def test_the_entries_of_a_list_are_typed_into_a_table(desk: Desk) -> None:
    desk.go_to("8")
    before = desk.sheet.grab().toImage()
    popup = desk.ask_for_samples()
    table = popup.tables["patients"]
    heads = [table.horizontalHeaderItem(at).text() for at in range(table.columnCount())]
    assert "name" in heads
    last = table.rowCount() - 1
    at = table.visualItemRect(table.item(0, 0)).center()
    QTest.mouseClick(table.viewport(), LEFT, pos=at)
    editor = QApplication.focusWidget()
    assert isinstance(editor, QLineEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "Mere")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    desk.settle()
    shown: Any = desk.designer.shown.values
    assert "Mere" in shown["patients"][0].values()
    assert len(shown["patients"]) == last
    assert desk.sheet.grab().toImage() != before
    popup.close()


def test_a_scenario_that_is_saved_meanwhile_gives_its_values(desk: Desk) -> None:
    desk.go_to("10")
    line = '{"at":1,"set":{"user":{"name":"Aroha"}}}\n'
    (desk.root / "scenarios" / "zz.jsonl").write_text(line, encoding="utf-8")
    desk.go_to("10")
    popup = desk.ask_for_samples()
    field = popup.fields["user.name"]
    assert "Aroha" in [field.itemText(at) for at in range(field.count())]
    popup.close()
    # The one that is closed is gone.
    desk.ask_for_samples().close()


def test_what_is_in_every_state_can_be_hidden_while_one_designs(desk: Desk) -> None:
    desk.go_to("2")
    shown = desk.sheet.grab().toImage()
    desk.click(desk.bar.always)
    hidden = desk.sheet.grab().toImage()
    assert hidden != shown
    desk.click(desk.bar.always)
    assert desk.sheet.grab().toImage() == shown


def test_the_preview_shows_the_screen_without_marks_and_goes_with_a_key(desk: Desk) -> None:
    desk.go_to("2")
    desk.click(desk.sheet, QPoint(desk.sheet.width() // 2, desk.sheet.height() * 4 // 5))
    desk.click(desk.bar.preview)
    preview: Any = desk.designer.preview
    assert preview.isVisible()
    assert preview.page.width() * 800 == pytest.approx(preview.page.height() * 1280, rel=0.01)
    QTest.keyClick(preview, Qt.Key.Key_Escape)
    desk.settle()
    assert desk.designer.preview is None


def test_a_state_that_runs_a_part_takes_no_component_template_or_file(
    desk: Desk, tmp_path: Path
) -> None:
    part = next(s for s in desk.document.states if s.flow is not None)
    desk.go_to(part.no)
    assert desk.sheet.nothing() == f"{part.flow} shows its own screens."
    before = desk.document
    desk.click(desk.designer.side.templates.tiles["list"])
    assert part.flow in desk.told[-1]
    source = tmp_path / "mine.png"
    QImage(8, 8, QImage.Format.Format_RGB32).save(str(source))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(source))])
    desk.drop(data)
    assert desk.document is before
    assert not (desk.root / "media" / "mine.png").exists()


def test_the_strip_shows_the_screens_themselves_as_they_are_now(desk: Desk) -> None:
    strip = desk.designer.strip
    desk.go_to("10")

    def small() -> QImage:
        desk.settle()
        return strip.viewport().grab(strip.visualRect(strip.currentIndex())).toImage()

    before = small()
    assert small() == before
    file = desk.root / "media" / "robot.png"
    other = QImage(40, 40, QImage.Format.Format_RGB32)
    other.fill(0xFF0000)
    other.save(str(file))
    replaced = small()
    assert replaced != before
    component = desk.components("10")[0]
    at = ("state", "10", "screen", component.id)
    desk.designer.edited.emit(places.change(desk.document, at, text="Kia ora"), "")
    assert small() != replaced


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
    desk.bar.devices.setFocus()
    for _ in DEVICES:
        QTest.keyClick(desk.bar.devices, Qt.Key.Key_Down)
        desk.settle()
    device = desk.designer.device
    assert (device.wide, device.high, device.key) == (600, 1600, "own")
    assert desk.bar.devices.currentText() == "6 inch, 600 × 1600"
    assert desk.sheet.height() > desk.sheet.width()


def test_a_component_that_is_pressed_stands_in_free_room_and_is_selected(desk: Desk) -> None:
    desk.go_to("7")
    desk.document = places.change(desk.document, ("state", "7"), screen=None)
    desk.designer.show_document(desk.document, [])
    desk.designer.select((("state", "7"),))
    desk.settle()
    # What there is to do is said where nothing is yet.
    assert "Drag a component here, or press one of them." in desk.sheet.nothing()
    above = [placing.box_of(one) for one in desk.designer.shown.above]
    for kind in ("text", "button", "button", "text"):
        desk.click(desk.designer.side.components.items[kind])
        made = desk.components("7")[-1]
        assert made.element == kind
        assert desk.selected == (("state", "7", "screen", made.id),)
        # Its words are written there at once.
        assert desk.sheet.writing.is_open
        new = placing.box_of(made)
        for one in (*above, *map(placing.box_of, desk.components("7")[:-1])):
            apart = new.x >= one.right or one.x >= new.right
            assert apart or new.y >= one.bottom or one.y >= new.bottom, (made, one)


def test_an_empty_screen_invites_and_one_with_a_ground_is_shown_as_it_is(desk: Desk) -> None:
    desk.go_to("7")
    desk.click(desk.bar.always)

    def colours(screen: rbd.Screen) -> int:
        """How many there are in the middle."""
        desk.document = places.change(desk.document, ("state", "7"), screen=screen)
        desk.designer.show_document(desk.document, [])
        desk.designer.select((("state", "7"),))
        area = QRect(0, 0, 40, 12)
        area.moveCenter(desk.sheet.rect().center())
        image = desk.sheet.grab(area).toImage()
        every = ((x, y) for x in range(image.width()) for y in range(image.height()))
        return len({image.pixelColor(x, y).name() for x, y in every})

    assert colours(rbd.Screen()) > 10
    assert colours(rbd.Screen(background="#ffffff")) == 1
    # So do the tags while there are none.
    tags = desk.designer.side.tags
    assert [one.text() for one in tags.findChildren(QLabel)] == ["None yet: write {name} in a text"]
    desk.designer.offer_tags(("user.name",))
    desk.settle()
    assert tags.findChildren(QLabel) == []
    assert tags.chip("user.name").isVisible()


def row_at(view: Any, row: int) -> QPoint:
    found: QModelIndex = view.model().index(row, 0)
    view.scrollTo(found)
    point: QPoint = view.visualRect(found).center()
    return point


def test_a_template_gives_the_state_its_screen_and_events_in_one_step(desk: Desk) -> None:
    desk.go_to("7")
    desk.click(desk.designer.side.templates.tiles["two-answers"])
    state = desk.document.state("7")
    assert [c.id for c in state.screen.components] == ["question", "hint", "yes", "no"]
    assert {"clickYes", "clickNo"} <= {event.name for event in state.events}
    assert desk.steps == ["Template Two answers for state 7"]


def test_a_template_is_dropped_on_the_screen_or_on_a_state_of_the_strip(desk: Desk) -> None:
    desk.go_to("2")
    data = dragged_template(desk.designer.side.templates.tiles["list"].template)
    assert desk.drop(data)
    assert desk.steps == ["Template List for state 2"]
    strip, copy = desk.designer.strip, Qt.DropAction.CopyAction
    place = strip.visualRect(strip.currentIndex().siblingAtRow(strip.currentIndex().row() + 1))
    enter = QDragEnterEvent(place.center(), copy, data, LEFT, NONE)
    QCoreApplication.sendEvent(strip.viewport(), enter)
    assert enter.isAccepted()
    drop = QDropEvent(QPointF(place.center()), copy, data, LEFT, NONE)
    QCoreApplication.sendEvent(strip.viewport(), drop)
    desk.settle()
    assert desk.steps[-1] == "Template List for state 3"
    assert [c.element for c in desk.components("3")] == [c.element for c in desk.components("2")]


def test_a_screen_is_kept_as_a_template_used_and_removed(desk: Desk) -> None:
    designer, tiles = desk.designer, desk.designer.side.templates
    designer.use_templates(OwnTemplates(desk.root.parent / "settings"))
    designer.template_asked.connect(lambda usual: designer.keep_template(f"my {usual}"))
    desk.go_to("10")
    desk.click(designer.side.keep)
    assert list(tiles.own) == ["my greeting"]
    desk.go_to("2")
    desk.click(tiles.own["my greeting"])
    assert desk.components("2") == desk.components("10")
    tiles.own["my greeting"].setFocus()
    QTest.keyClick(tiles.own["my greeting"], Qt.Key.Key_Delete)
    desk.settle()
    assert not tiles.own


def test_a_template_brings_its_pictures_along(desk: Desk) -> None:
    """As into another project, in which there are none of them."""
    designer, tiles = desk.designer, desk.designer.side.templates
    designer.use_templates(OwnTemplates(desk.root.parent / "settings"))
    designer.template_asked.connect(lambda usual: designer.keep_template("mine"))
    desk.go_to("2")
    desk.click(designer.side.keep)
    picture = desk.root / "media" / "robot.png"
    kept = picture.read_bytes()
    picture.unlink()
    desk.go_to("3")
    desk.click(tiles.own["mine"])
    assert picture.read_bytes() == kept
    assert desk.components("3") == desk.components("2")


def test_what_lies_on_the_screen_is_selected_and_dragged_into_another_order(desk: Desk) -> None:
    desk.go_to("2")
    layers = desk.designer.side.layers
    assert layers.ids == ["continue", "robot", "who", "hello", ""]
    QTest.mouseClick(layers.viewport(), LEFT, pos=row_at(layers, 1))
    desk.settle()
    assert desk.selected == (("state", "2", "screen", "robot"),)
    assert desk.sheet.selected == ("robot",)
    # Onto the upper half of the first row: before all others.
    port, start, end = layers.viewport(), row_at(layers, 1), row_at(layers, 0) - QPoint(0, 8)
    QTest.mousePress(port, LEFT, pos=start)
    for part in (1, 2, 3):
        QTest.mouseMove(port, start + (end - start) * part / 3)
    QTest.mouseRelease(port, LEFT, pos=end)
    desk.settle()
    assert [c.id for c in desk.components("2")] == ["hello", "who", "continue", "robot"]
    assert desk.steps == ["Reorder robot"]
    layers.setFocus()
    QTest.keyClick(layers, Qt.Key.Key_Down, ALT)
    desk.settle()
    assert [c.id for c in desk.components("2")] == ["hello", "who", "robot", "continue"]
    QTest.mouseClick(layers.viewport(), LEFT, pos=row_at(layers, 4))
    desk.settle()
    assert desk.selected == (("state", "2", "screen"),)
    assert [index.row() for index in layers.selectedIndexes()] == [4]


def test_the_list_of_what_lies_on_the_screen_follows_what_is_selected_there(desk: Desk) -> None:
    desk.go_to("2")
    layers = desk.designer.side.layers

    def marked() -> set[str]:
        return {layers.ids[index.row()] for index in layers.selectedIndexes()}

    for where, held, ids in (
        ((80, 40), NONE, {"robot"}),
        ((50, 82), NONE, {"continue"}),
        ((80, 40), SHIFT, {"continue", "robot"}),
        ((2, 97), NONE, set()),
    ):
        QTest.mouseClick(desk.sheet, LEFT, held, desk.at(*where))
        desk.settle()
        assert set(desk.sheet.selected) == ids
        assert marked() == ids
    # What comes back is selected again.
    before = desk.document
    QTest.mouseClick(desk.sheet, LEFT, NONE, desk.at(80, 40))
    QTest.keyClick(desk.sheet, Qt.Key.Key_Delete)
    assert "robot" not in layers.ids
    desk.document, desk.selected = before, (("state", "2", "screen", "robot"),)
    desk._show()
    assert marked() == set(desk.sheet.selected) == {"robot"}
    desk.sheet.choose(())
    desk.sheet.setFocus()
    QTest.keyClick(desk.sheet, Qt.Key.Key_Tab)
    assert marked() == set(desk.sheet.selected) == {"hello"}
    # And the other way: with the keyboard in the list, what is behind all of it among them.
    layers.setFocus()
    QTest.keyClick(layers, Qt.Key.Key_Up, SHIFT)
    assert marked() == set(desk.sheet.selected) == {"hello", "who"}
    QTest.keyClick(layers, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    assert marked() == set(desk.sheet.selected) == {"hello", "who", "robot", "continue"}


def test_a_tag_is_put_into_a_text_by_a_press_or_a_drop(desk: Desk) -> None:
    desk.go_to("2")
    desk.click(desk.sheet, desk.at(20, 25))
    desk.designer.offer_tags(("robot/speech", "user.name"))
    desk.settle()
    with pytest.raises(LookupError):
        desk.designer.side.tags.chip("robot/speech")
    desk.click(desk.designer.side.tags.chip("user.name"))
    assert desk.components("2")[0].text == "Hello! {user.name}"
    assert desk.drop(dragged("user.name"), 20, 50)
    assert desk.components("2")[1].text.endswith("today? {user.name}")
    assert desk.drop(dragged("spo2.value"), 80, 90)
    assert desk.components("2")[-1].text == "{spo2.value}"


def test_an_edit_shows_the_screen_once_and_frames_ask_for_it_no_more(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    desk.go_to("2")
    shown: list[Any] = []
    made: list[Any] = []
    show = desk.sheet.show_screen

    def show_screen(*arguments: Any) -> None:
        shown.append(arguments[1])
        show(*arguments)

    def content_of(*arguments: Any) -> Content:
        made.append(arguments[0])
        return content(*arguments)

    monkeypatch.setattr(desk.sheet, "show_screen", show_screen)
    monkeypatch.setattr("situ_studio.panels.preview.content", content_of)
    desk.designer.write_tag("user.name")
    desk.sheet.repaint()
    desk.sheet.repaint()
    screen = desk.document.state("2").screen
    assert shown == [screen]
    assert made == [screen]
    # Without what Always adds it is another picture.
    desk.sheet.show_always(False)
    desk.sheet.repaint()
    assert made == [screen, screen]


def test_the_screen_lies_in_its_frame_however_large_the_window_is(desk: Desk) -> None:
    for wide, high in ((700, 420), (1800, 1200), (1000, 500)):
        desk.holder.resize(wide, high)
        desk.settle()
        area = desk.sheet.geometry()
        assert desk.designer.ground.rect().contains(area.adjusted(-7, -7, 7, 7))
        assert area.width() / area.height() == pytest.approx(1.6, abs=0.01)
        # Under the names above it.
        assert area.top() > desk.designer.crumbs.geometry().bottom()
        # The rulers stand above and beside all of it.
        room = desk.designer.ground.room
        assert desk.designer.crumbs.width() == room.width()
        assert room.contains(area)
        for ruler in desk.designer.ground.rulers:
            assert not ruler.geometry().intersects(room)


def test_the_names_above_the_screen_lie_on_no_frame_in_large_letters_either(
    qt: QApplication, project: Copy
) -> None:
    letters.use(150)
    try:
        made = Desk(project("reception"))
        made.holder.resize(1400, 700)
        made.settle()
        frame = made.sheet.geometry().top() - 7
        assert frame > made.designer.crumbs.geometry().bottom()
        made.holder.close()
        made.holder.deleteLater()
        made.settle()
    finally:
        letters.use(100)


def test_that_a_picture_is_missing_stands_on_it_while_it_is_dragged_too(desk: Desk) -> None:
    desk.go_to("2")
    at = ("state", "2", "screen", "robot")
    desk.designer.edited.emit(places.change(desk.document, at, src="gone.png"), "")
    box = desk.sheet.own()["robot"]
    ink: Any = LIGHT.color("error")

    def told(y: float) -> int:
        """How much is written in red between there and 8 % above."""
        image: Any = desk.sheet.grab().toImage()
        first, last = desk.at(box.x, y - 8), desk.at(box.right, y)
        seen = (
            image.pixelColor(x, y)
            for x in range(first.x() + 10, last.x() - 10)
            for y in range(first.y(), last.y() - 2)
        )
        pairs = (zip(one.getRgb(), ink.getRgb(), strict=True) for one in seen)
        return sum(all(abs(a - b) < 24 for a, b in pair) for pair in pairs)

    assert told(box.bottom)
    middle = desk.at(box.x + box.width / 2, box.y + box.height / 2)
    QTest.mousePress(desk.sheet, LEFT, pos=middle)
    for far in (10, 20):
        QTest.mouseMove(desk.sheet, middle + desk.at(0, far))
    proposal = desk.sheet.proposal
    assert proposal is not None
    assert told(proposal.boxes["robot"].bottom)
    assert not told(box.bottom)
    QTest.keyClick(desk.sheet, Qt.Key.Key_Escape)
    QTest.mouseRelease(desk.sheet, LEFT, pos=middle)
