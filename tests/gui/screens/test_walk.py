"""The preview: screens are used, and lead to others; nothing of it is kept."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from situ.document import folder, rbd
from situ.document.condition import Condition
from situ.document.condition import Test as DataTest
from situ_studio.looks.theme import LIGHT
from situ_studio.screens.devices import DEVICES
from situ_studio.screens.preview_window import PreviewWindow
from situ_studio.screens.shown import Values, content
from situ_studio.screens.walk import Walk

LEFT = Qt.MouseButton.LeftButton
BOX: Any = {"x": 10, "y": 10, "width": 20, "height": 20}

Copy = Callable[[str], Path]


def state(no: str, *parts: rbd.Component, events: tuple[rbd.Event, ...] = ()) -> rbd.State:
    screen = rbd.Screen(components=parts) if parts else None
    return rbd.State(no=no, screen=screen, events=events)


def button(event: str, **more: Any) -> rbd.Button:
    return rbd.Button(id=event, **BOX, event=event, **more)


def to(name: str, next: str | None, **more: Any) -> rbd.Event:
    return rbd.Event(name=name, next=next, **more)


def test_a_press_writes_and_leads_on_and_a_state_without_a_screen_keeps_the_one_before() -> None:
    yes = button("yes", tag="answer", value="{who} said 3")
    asked = state("1", yes, events=(to("yes", "2"),))
    app = rbd.Application(name="a", states=(asked, state("2", events=(to("go", "1"),))))
    before = Values({"who": "Mere"})
    walk = Walk(app, "1", before)
    walk.press(yes)
    assert (walk.no, walk.values["answer"], walk.seen) == ("2", "Mere said 3", (yes,))
    assert "answer" not in before
    walk.press(yes)
    assert walk.no == "2"
    assert walk.said == "yes is not expected here: nothing happens."
    walk.back()
    assert (walk.no, "answer" in walk.values, walk.can_go_back) == ("1", False, False)


def test_always_and_back_and_again_lead_as_on_the_robot() -> None:
    home, back = button("home"), button("back")
    always = rbd.Always(
        screen=rbd.Screen(touched="again", components=(home,)),
        events=(to("home", "1"), to("again", "#again"), to("back", "#back")),
    )
    one = state("1", back, events=(to("go", "2"),))
    two = state("2", back, events=(to("home", None),))
    app = rbd.Application(name="a", always=always, states=(one, two))
    walk = Walk(app, "1", Values({}))
    walk.press(back)
    assert walk.no == "1", "there is nothing before the start"
    walk.go_on("go")
    walk.press(home)
    assert walk.no == "2", "the state's own event goes before that of Always"
    walk.touch()
    assert (walk.no, walk.said) == ("2", "again leads to state 2")
    walk.press(back)
    assert walk.no == "1"


def test_conditions_are_not_judged_and_that_is_told() -> None:
    when = Condition((DataTest(tag="a", test="is", value="1"),))
    go = button("go")
    app = rbd.Application(
        "a", states=(state("1", go, events=(to("go", "2", when=when), to("go", "1"))), state("2"))
    )
    walk = Walk(app, "1", Values({}))
    walk.press(go)
    assert (walk.no, walk.said) == ("2", "go leads to state 2, if its condition holds")


def test_what_no_press_does_can_be_chosen_in_document_order() -> None:
    events = (to("said", "2"), to("go", "2"), to("done", "1"), to("said", "1"), to("in", None))
    first = rbd.State(
        no="1",
        screen=rbd.Screen(components=(button("go"),)),
        timeout=rbd.Timeout(9, next="3"),
        events=events,
    )
    part = rbd.State(no="3", name="paying", flow="pay")
    walk = Walk(rbd.Application(name="a", states=(first, state("2"), part)), "1", Values({}))
    assert walk.others() == (("said", "state 2"), ("done", "state 1"), ("", "3 paying"))
    walk.go_on("")
    assert walk.no == "3"
    assert walk.said.endswith("a part runs there, whose screens are in pay")


def test_a_number_that_is_none_is_not_written_and_a_full_input_is_told() -> None:
    field = rbd.Input(id="n", **BOX, tag="n", kind="number", max=2)
    walk = Walk(rbd.Application(name="a", states=(state("1", field),)), "1", Values({}))
    assert not walk.type(field, "x")
    assert "n" not in walk.values
    assert not walk.type(field, "4")
    assert walk.type(field, "42")
    assert walk.values["n"] == 42


def test_a_screen_speaks_the_language_of_the_sample_values() -> None:
    screen = rbd.Screen(components=(rbd.Text(id="t", **BOX, text="Hello {who}"),))
    texts = {"de": {"Hello {who}": "Guten Tag, {who}"}}

    def said(language: str) -> str:
        shown = content(screen, values=Values({"who": "Jack", "language": language}, texts))
        return str(shown.components[0]["text"])

    assert said("de") == "Guten Tag, Jack"
    assert said("ja") == "Hello Jack"


class Used:
    """The preview of the reception, and hands that use it."""

    def __init__(self, root: Path) -> None:
        project, _ = folder.load(root)
        assert project is not None
        self.application = next(iter(project.applications.values()))
        self.media = root / "media"
        self.window: Any = None

    def open(self, no: str, **values: Any) -> None:
        walk = Walk(self.application, no, Values(values))
        self.window = PreviewWindow(LIGHT, DEVICES[0], walk, self.media)
        self.window.open()
        self.window.activateWindow()
        self.settle()

    @property
    def walk(self) -> Walk:
        walk: Walk = self.window.walk
        return walk

    def settle(self) -> None:
        for _ in range(3):
            QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            QApplication.processEvents()

    def click(self, id: str, row: int = -1) -> None:
        page = self.window.page
        target = next(t for t in page.targets() if t[0].id == id and t[1] == row)
        QTest.mouseClick(page, LEFT, pos=page.area(target).center().toPoint())
        self.settle()

    def picture(self) -> QImage:
        image: QImage = self.window.page.grab().toImage()
        return image


@pytest.fixture
def used(qt: QApplication, project: Copy) -> Iterator[Used]:
    made = Used(project("reception"))
    yield made
    if made.window is not None:
        made.window.reject()
        made.settle()


def test_in_the_preview_rows_are_chosen_buttons_pressed_and_letters_typed(used: Used) -> None:
    people = [{"first": "Mere", "room": "1"}, {"first": "Tane", "room": "2"}]
    used.open("8", patients=people)
    before = used.picture()
    used.click("names", 1)
    assert used.walk.values["user"] == people[1]
    assert used.walk.no == "9"
    assert used.picture() != before
    assert "9 save profile" in used.window.here.text()
    assert "leads to 9" in used.window.said.text()
    # What no press does is in a menu.
    QTest.mouseClick(used.window.others, LEFT)
    menu = next(m for m in used.window.findChildren(QMenu) if m.isVisible())
    assert any("greeting" in action.text() for action in menu.actions())
    QTest.keyClick(menu, Qt.Key.Key_Escape)
    used.settle()
    QTest.mouseClick(used.window.back, LEFT)
    assert used.walk.no == "8"
    used.walk.go_on("clickNo")
    QTest.mouseClick(used.window.page, LEFT, pos=QPoint(2, 2))
    used.settle()
    QTest.keyClick(used.window, Qt.Key.Key_Escape)
    used.settle()
    used.window = None


def test_the_preview_is_used_by_keys_alone(used: Used) -> None:
    used.open("3")
    page = used.window.page
    assert page.hasFocus()
    # As one reads: what Always adds, the input, the button.
    for _ in range(3):
        QTest.keyClick(page, Qt.Key.Key_Tab)
    QTest.keyClick(page, Qt.Key.Key_Return)
    assert page.field.hasFocus()
    QTest.keyClicks(page.field, "K")
    assert used.walk.values["user.initial.x"] == "K"
    QTest.keyClick(page.field, Qt.Key.Key_Tab)
    assert page.hasFocus()
    QTest.keyClick(page, Qt.Key.Key_Space)
    used.settle()
    assert used.walk.no == "4"
    assert used.walk.values["user.initial.x"] == "K"


def test_a_movie_that_says_what_happens_where_it_can_not_be_played_is_tried_both_ways(
    used: Used,
) -> None:
    movie = rbd.Movie(id="intro", **BOX, src="{film}", done="seen", failed="dark")
    plain = rbd.Movie(id="end", **BOX, src="b.webm", done="over")
    silent = rbd.Movie(id="ad", **BOX, src="c.webm")
    first = state("1", movie, events=(to("seen", "2"), to("dark", "3")))
    third = rbd.State(no="3", name="sorry", screen=rbd.Screen(components=(plain, silent)))
    used.application = rbd.Application(name="a", states=(first, state("2"), third))
    used.open("1")
    # Neither is offered under *Go on*: both are a press away.
    assert used.walk.others() == ()
    used.click("intro")
    menu = next(m for m in used.window.findChildren(QMenu) if m.isVisible())
    assert [one.text() for one in menu.actions()] == [
        "The movie ends  ›  state 2",
        "The movie can not be played  ›  3 sorry",
    ]
    QTest.keyClick(menu, Qt.Key.Key_Escape)
    used.settle()
    assert used.walk.no == "1"
    used.click("intro")
    menu = next(m for m in used.window.findChildren(QMenu) if m.isVisible())
    failed = menu.actions()[1]
    QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(failed).center())
    used.settle()
    assert used.walk.no == "3"
    assert used.window.said.text().startswith("dark leads to 3 sorry")
    # One that only ends does so at once; of one that raises nothing there is nothing to press.
    assert [one.id for one, _ in used.window.page.targets()] == ["end"]
    used.click("end")
    assert used.window.said.text() == "over is not expected here: nothing happens."
    QTest.mouseClick(used.window.back, LEFT)
    used.settle()
    # By keys alone.
    page = used.window.page
    page.setFocus()
    QTest.keyClick(page, Qt.Key.Key_Tab)
    QTest.keyClick(page, Qt.Key.Key_Return)
    used.settle()
    menu = next(m for m in used.window.findChildren(QMenu) if m.isVisible())
    QTest.keyClick(menu, Qt.Key.Key_Return)
    used.settle()
    assert used.walk.no == "2"
    assert used.window.said.text().startswith("seen leads to state 2")


def test_an_ampersand_in_a_name_is_read_where_the_preview_asks_how_to_go_on(used: Used) -> None:
    movie = rbd.Movie(id="intro", **BOX, src="a.webm", done="seen", failed="dark")
    first = state("1", movie, events=(to("seen", "2"), to("dark", "2"), to("said", "2")))
    second = rbd.State(no="2", name="tea & talk")
    used.application = rbd.Application(name="a", states=(first, second))
    used.open("1")
    # In a menu a single one underlines what follows it, and is not seen.
    used.click("intro")
    menu = next(m for m in used.window.findChildren(QMenu) if m.isVisible())
    assert menu.actions()[1].text() == "The movie can not be played  ›  2 tea && talk"
    QTest.keyClick(menu, Qt.Key.Key_Escape)
    used.settle()
    QTest.mouseClick(used.window.others, LEFT)
    menu = next(m for m in used.window.findChildren(QMenu) if m.isVisible())
    assert [one.text() for one in menu.actions()] == ["said  ›  2 tea && talk"]
    QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(menu.actions()[0]).center())
    used.settle()
    assert used.walk.no == "2"
