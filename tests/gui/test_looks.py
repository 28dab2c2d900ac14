"""Reference pictures of the main views: light and dark, English and Japanese.

``make pictures`` makes them anew; whoever does looks at each before it is committed. A picture
that differs is put beside the kept one in ``tests/gui/pictures/differs``, with what differs
framed.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSettings, QSize, Qt, QTimer
from PySide6.QtGui import QCursor, QImage, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractScrollArea, QApplication, QDialog, QWidget
from tests.gui.conftest import Studio
from tests.gui.likeness import differences, keep, made_small, marked
from tests.gui.live.test_comparing import until
from tests.gui.live.test_field import recorded, until_counted
from tests.gui.live.test_recordings import until_shown

from situ_studio.commands.shortcuts import Shortcuts
from situ_studio.looks import letters, theme
from situ_studio.window.dialogs import Dialogs
from situ_studio.wording.language import Speaking

PICTURES = Path(__file__).with_name("pictures")
DIFFERS = PICTURES / "differs"
ANEW = bool(os.environ.get("SITU_PICTURES"))
WAYS = [("light", "en"), ("dark", "en"), ("light", "ja"), ("dark", "ja")]

pytestmark = pytest.mark.skipif(
    sys.platform != "linux", reason="elsewhere the system draws letters in its own way"
)


@pytest.fixture(autouse=True)
def nothing_blinks(qt: QApplication) -> Iterator[None]:
    before = qt.cursorFlashTime()
    qt.setCursorFlashTime(0)
    yield
    qt.setCursorFlashTime(before)


def compared(name: str, picture: QImage) -> str:
    """Where a picture differs from the kept one: a line for a person, empty where it does not."""
    file, small = PICTURES / f"{name}.png", made_small(picture)
    if ANEW:
        keep(small, file)
        return ""
    kept = QImage(str(file))
    apart = differences(small, kept.convertToFormat(QImage.Format.Format_RGB32))
    for old in (DIFFERS / f"{name}.png", DIFFERS / f"{name}-where.png"):
        old.unlink(missing_ok=True)
    if not apart:
        return ""
    DIFFERS.mkdir(exist_ok=True)
    small.save(str(DIFFERS / f"{name}.png"))
    marked(small, apart).save(str(DIFFERS / f"{name}-where.png"))
    first = apart[0].topLeft() * 2
    return (
        f"{name}: {len(apart)} blocks differ, the first at {first.x()}, {first.y()}; see "
        f"{DIFFERS.name}/{name}-where.png; if it shall look so: make pictures"
    )


def without_mouse(made: Studio) -> None:
    """The mouse is nowhere: where it was last, in a test before, a row or a port would be lit.

    Rows remember that it came; items of a drawing ask where the cursor is.
    """
    QCursor.setPos(-1000, -1000)
    made.settle()
    for widget in QApplication.allWidgets():
        if isinstance(widget, QAbstractScrollArea) or widget.underMouse():
            entered = widget.viewport() if isinstance(widget, QAbstractScrollArea) else widget
            entered.setAttribute(Qt.WidgetAttribute.WA_UnderMouse, False)
            QApplication.sendEvent(entered, QEvent(QEvent.Type.Leave))
    made.settle()


class Views:
    """A studio that is shown view after view, each of which is compared."""

    def __init__(self, made: Studio, colours: str, code: str) -> None:
        self.made, self.window = made, made.window
        self._way = f"{colours}-{code}"
        self.found: list[str] = []

    def compare(self, name: str, shown: QWidget | QImage | None = None) -> None:
        # It is drawn so many times a second at most.
        self.window.moment.column.draw()
        without_mouse(self.made)
        picture = shown if isinstance(shown, QImage) else (shown or self.window).grab().toImage()
        self.found.append(compared(f"{name}-{self._way}", picture))

    def over(self, name: str, shown: QWidget) -> None:
        """The window, with what lies over it."""
        without_mouse(self.made)
        picture = self.window.grab()
        painter = QPainter(picture)
        painter.drawPixmap(shown.mapTo(self.window, QPoint(0, 0)), shown.grab())
        painter.end()
        self.found.append(compared(f"{name}-{self._way}", picture.toImage()))

    def answer(self, name: str) -> None:
        """Compares the dialog that asks, and says no to it."""
        asking = QApplication.activeModalWidget()
        assert isinstance(asking, QDialog)
        self.compare(name, asking)
        asking.reject()

    def open(self, file: str) -> None:
        self.window.open_file(file)
        self.made.settle()
        view = self.window.current_view
        if view is not None:
            view.call("zoom_to_fit")
            self.made.settle()

    def result(self) -> str:
        return "\n".join(filter(None, self.found))


@pytest.fixture(params=WAYS, ids="-".join)
def views(
    request: pytest.FixtureRequest,
    qt: QApplication,
    studio: Callable[..., Studio],
    project: Callable[[str], Path],
    settings: QSettings,
) -> Iterator[Callable[..., Views]]:
    colours, code = request.param

    def start(name: str = "") -> Views:
        settings.setValue("language", code)
        return Views(studio(project(name) if name else None, colours), colours, code)

    yield start
    letters.use(100)
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    assert speaking.code == code
    speaking.use("en")


FORMS: dict[str, list[tuple[str, ...]]] = {
    "reception": [
        (), ("state", "7"), ("state", "16"), ("always",), ("state", "7", "screen"),
        ("state", "7", "event", "2"), ("state", "7", "timeout"), ("state", "7", "action", "1"),
        ("state", "4", "screen", "confirm"), ("note", "0"), ("frame", "0"),
    ],
    "conversation": [
        (), ("situation", "sound"), ("module", "nod"), ("data", "sound.slap"),
    ],
}  # fmt: skip
"""A place of each kind that has a form of its own."""


def forms_of(shown: Views, name: str) -> QImage:
    """The inspector with one form after the other, side by side."""
    forms = []
    for place in FORMS[name]:
        shown.made.select(*place)
        forms.append(shown.window.docks["inspector"].grab().toImage())
    high, wide = max(f.height() for f in forms), sum(f.width() for f in forms)
    side_by_side = QImage(wide, high, forms[0].format())
    side_by_side.fill(0)
    painter = QPainter(side_by_side)
    for at, form in enumerate(forms):
        painter.drawImage(at * form.width(), 0, form)
    painter.end()
    return side_by_side


def test_the_welcome_page_and_the_keys_look_as_they_should(views: Callable[..., Views]) -> None:
    shown = views()
    shown.compare("welcome")
    shown.window.actions_.actions["shortcuts"].trigger()
    (keys,) = shown.window.findChildren(Shortcuts)
    shown.compare("keys", keys)
    keys.close()
    asks = Dialogs(shown.window)
    QTimer.singleShot(0, lambda: shown.answer("asked-name"))
    assert asks.name("?", "abc", "my-robot") is None
    QTimer.singleShot(0, lambda: shown.answer("asked-unsaved"))
    assert asks.unsaved(["reception.rbd.xml"]) == "cancel"
    assert shown.result() == ""


def test_an_application_looks_as_it_should(views: Callable[..., Views]) -> None:
    shown = views("reception")
    window = shown.window
    shown.open("reception.rbd.xml")
    shown.compare("forms-of-reception", forms_of(shown, "reception"))
    shown.made.select("state", "7")
    shown.compare("application")
    window.finder.open(window.commands.everything())
    shown.over("finder", window.finder)
    shown.made.key(Qt.Key.Key_Escape)
    menu = window.actions_.context_menu("state", window)
    menu.popup(QPoint(0, 0))
    shown.compare("menu", menu)
    menu.close()
    menu.deleteLater()
    window.helping.show_topic("kind/state")
    help_ = window.helping.shown
    assert help_ is not None
    shown.compare("help", help_)
    help_.close()
    window.show_mode("split")
    shown.compare("split")
    window.show_mode("screen")
    shown.made.select("state", "5", "screen", "no")
    shown.compare("designer")
    window.commands.insert("image")
    shown.made.settle()
    picker = window.media_choice.picker
    assert picker is not None
    shown.over("which-picture", picker)
    shown.made.key(Qt.Key.Key_Escape)
    shown.open("texts")
    shown.compare("texts")
    shown.open("media/")
    shown.compare("media")
    shown.open("situ.toml")
    shown.compare("project-form")
    shown.open("reception.rbd.xml")
    shown.made.select("state", "7")
    window.show_mode("outline")
    shown.compare("outline")
    window.show_mode("graph")
    shown.made.key(Qt.Key.Key_Delete)
    window.session.check_now()
    shown.compare("problems")
    assert shown.result() == ""


def test_a_script_looks_as_it_should(views: Callable[..., Views]) -> None:
    shown = views("conversation")
    shown.open("conversation.spds.xml")
    shown.compare("forms-of-conversation", forms_of(shown, "conversation"))
    shown.made.select("situation", "sound")
    shown.compare("script")
    shown.made.select("situation", "invited", "until", "0", "0")
    view = shown.window.current_view
    assert view is not None
    view.canvas.rename()
    shown.compare("script-test")
    shown.made.key(Qt.Key.Key_Escape)
    shown.made.select("situation", "sound")
    shown.window.show_mode("both")
    view.piece("matrix").what_if.suppose("sound.slap", 0)
    shown.compare("script-both")
    shown.window.show_mode("matrix")
    shown.compare("script-matrix")
    shown.window.show_mode("outline")
    shown.compare("script-outline")
    assert shown.result() == ""


def test_what_robots_did_looks_as_it_should(views: Callable[..., Views], tmp_path: Path) -> None:
    shown = views("reception")
    window, robot = shown.window, shown.window.robot
    shown.open("reception.rbd.xml")
    scripts = ("known-user.jsonl", "second-thoughts.jsonl")
    ours, other = recorded(tmp_path, "reception", *scripts)
    robot.open_recording(ours)
    until_shown(shown.made)
    window.bottom.choose("timeline")
    robot.follower.viewing.seek(16.0)
    shown.made.settle()
    shown.compare("live")
    window.bottom.choose("trace")
    shown.made.settle()
    shown.compare("trace")
    window.bottom.choose("timeline")
    robot.comparing.compare_with(other)
    until(robot.comparing.comparing)
    window.commands.next_difference(1)
    shown.made.settle()
    shown.compare("compared")
    shown.made.select("state", "5")
    window.commands.ask_why()
    shown.made.settle()
    shown.compare("why")
    robot.close_recording()
    window.field.count([ours, other])
    until_counted(shown.made)
    shown.compare("field")
    window.rehearsing.clock = lambda: 0.0
    window.rehearsing.rehearse()
    shown.made.settle()
    shown.compare("rehearsal")
    window.rehearsing.end()
    assert shown.result() == ""


def test_large_letters_look_as_they_should(
    views: Callable[..., Views], settings: QSettings
) -> None:
    settings.setValue("letters", "150")
    shown = views("reception")
    shown.open("reception.rbd.xml")
    shown.made.select("state", "7")
    shown.compare("large-letters")
    assert shown.result() == ""


# -- what the comparison sees, and what it does not mind --------------------------------------


@pytest.fixture
def light(studio: Callable[..., Studio], project: Callable[[str], Path]) -> Studio:
    made = studio(project("reception"))
    made.settle()
    return made


def small(made: Studio) -> QImage:
    made.settle()
    return made_small(made.window.grab().toImage())


def test_where_the_mouse_was_is_not_seen(light: Studio) -> None:
    view = light.window.current_view
    assert view is not None
    without_mouse(light)
    before = made_small(light.window.grab().toImage())
    viewer, outline = view.canvas.viewer, light.window.outline.list
    card = view.canvas.graph.nodes["7"].view
    spots = {
        viewer.viewport(): viewer.mapFromScene(card.sceneBoundingRect().center()),
        outline.viewport(): QPoint(40, 40),
    }
    for widget, spot in spots.items():
        QTest.mouseMove(widget, spot)
        light.settle()
        assert differences(made_small(light.window.grab().toImage()), before), widget
        without_mouse(light)
        assert differences(made_small(light.window.grab().toImage()), before) == []


def test_a_lost_word_is_seen_where_it_was(light: Studio) -> None:
    before = small(light)
    label = light.window.headers["outline"].title
    label.setText("")
    apart = differences(small(light), before)
    where = QRect(label.mapTo(light.window, QPoint(0, 0)) / 2, QSize(60, 16))
    assert apart
    assert all(where.intersects(block) for block in apart)


def test_another_themes_colour_is_seen(light: Studio) -> None:
    before = small(light)
    light.window.palette_.set_theme(theme.DARK)
    assert differences(small(light), before)


def test_a_panel_that_has_moved_is_seen(light: Studio) -> None:
    before = small(light)
    dock = light.window.docks["inspector"]
    light.window.resizeDocks([dock], [dock.width() + 8], Qt.Orientation.Horizontal)
    assert differences(small(light), before)


def test_letters_smoothed_otherwise_are_not_minded(light: Studio) -> None:
    drawn = light.window.grab().toImage()
    other = QImage(drawn.size(), drawn.format())
    painter = QPainter(other)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.drawImage(QPointF(0, 0), drawn)
    painter.drawImage(QPointF(0.4, 0.4), drawn)
    painter.end()
    assert differences(made_small(other), made_small(drawn)) == []


def test_a_picture_that_differs_is_put_beside_the_kept_one(
    light: Studio, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.modules[__name__], "PICTURES", tmp_path)
    monkeypatch.setattr(sys.modules[__name__], "DIFFERS", tmp_path / "differs")
    monkeypatch.setattr(sys.modules[__name__], "ANEW", False)
    drawn = light.window.grab().toImage()
    keep(made_small(drawn), tmp_path / "one.png")
    assert compared("one", drawn) == ""
    assert not (tmp_path / "differs").exists()

    other = drawn.copy()
    other.fill(0)
    assert "one: 16000 blocks differ, the first at 0, 0" in compared("one", other)
    beside = sorted(file.name for file in (tmp_path / "differs").iterdir())
    assert beside == ["one-where.png", "one.png"]
    assert compared("one", drawn) == ""
    assert list((tmp_path / "differs").iterdir()) == []
