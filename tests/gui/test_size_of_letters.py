"""Letters as large as the system's, or as a person chose; drawings and the robot's screen keep
theirs.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QRectF, QSettings, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFrame, QLabel, QStyle, QWidget
from tests.gui.conftest import Studio

from situ.document import folder
from situ.document.rbd import Application
from situ.resources import example
from situ_studio.canvas.gestures import FOLLOWS
from situ_studio.canvas.menu import FollowMenu
from situ_studio.commands.preferences import Preferences
from situ_studio.export import picture
from situ_studio.looks import letters
from situ_studio.looks.theme import BODY, LIGHT, face, font
from situ_studio.looks.theme_qss import qss
from situ_studio.panels.project_tree import ProjectTree
from situ_studio.panels.tabs import CountButton
from situ_studio.screens.painting import paint_screen
from situ_studio.screens.sample_table import SampleTable
from situ_studio.screens.strip import StateStrip
from situ_studio.window.windows import Windows

Start = Callable[..., Studio]
Copy = Callable[[str], Path]
NUMBER = re.compile(r"\d+(?:\.\d+)?")


@pytest.fixture(autouse=True)
def usual(qt: QApplication) -> Iterator[None]:
    """Whatever a test chose, the next one begins with letters of the usual size."""
    yield
    letters.use(100)


@pytest.mark.parametrize(
    ("points", "platform", "percent"),
    [
        (9.0, "linux", 100), (10.0, "linux", 100), (11.0, "linux", 100), (12.0, "linux", 120),
        (8.0, "linux", 80), (40.0, "linux", 150), (3.0, "linux", 80), (9.0, "win32", 100),
        (11.25, "win32", 125), (13.0, "darwin", 100), (-1.0, "linux", 100),
    ],
)  # fmt: skip
def test_letters_are_by_so_much_larger_as_the_system_s_are_than_usual(
    points: float, platform: str, percent: int
) -> None:
    assert letters.of_system(points, platform) == percent


def sizes(used: Studio) -> tuple[int, int, int]:
    """Px of a panel's heading, of a row of the outline, and of a field."""
    window = used.window
    title = window.headers["outline"].title
    assert isinstance(title, QLabel)
    form = window.inspector.form
    assert form is not None
    row = window.outline.list.visualRect(window.outline.list.model().index(0, 0)).height()
    return title.fontInfo().pixelSize(), row, form.field("name").height()


def renewed(windows: Windows, before: Studio) -> Studio:
    while before.window in windows.windows:
        QApplication.processEvents()
    made = Studio(windows.windows[0])
    made.settle()
    return made


def test_another_size_of_letters_holds_at_once_in_all_windows_and_at_the_next_start(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    used = studio(folder)
    used.select("state", "2")
    windows = used.window.windows
    assert windows is not None
    windows.open_window()
    assert sizes(used) == (12, 22, 28)
    used.key(Qt.Key.Key_Comma, Qt.KeyboardModifier.ControlModifier)
    (shown,) = used.window.findChildren(Preferences)
    assert shown.letters.currentData() == "system"
    shown.letters.setFocus()
    for _ in letters.SIZES:
        QTest.keyClick(shown.letters, Qt.Key.Key_Down)
    made = renewed(windows, used)
    assert len(windows.windows) == 2
    assert made.session is used.session
    assert made.window.current_view is not None
    assert made.window.current_view.selected == (("state", "2"),)
    assert sizes(made) == (18, 33, 41)
    assert all(w.status.fontInfo().pixelSize() == round(1.5 * 13) for w in windows.windows)
    again = studio(folder)
    again.select("state", "2")
    assert sizes(again) == (18, 33, 41)
    used = Studio(again.window)
    again.window.commands.choose_letters("system")
    assert again.window.windows is not None
    made = renewed(again.window.windows, again)
    assert sizes(made) == (12, 22, 28)
    assert settings.value("letters") == "system"


def test_windows_follow_the_system_s_letters_unless_a_person_chose(
    studio: Start, project: Copy, monkeypatch: pytest.MonkeyPatch
) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    windows = used.window.windows
    assert windows is not None
    monkeypatch.setattr(letters, "of_system", lambda: 125)
    QApplication.sendEvent(used.window, QEvent(QEvent.Type.ThemeChange))
    made = renewed(windows, used)
    assert sizes(made)[0] == 15
    windows.choose_letters("100")
    made = renewed(windows, made)
    QApplication.sendEvent(made.window, QEvent(QEvent.Type.ThemeChange))
    made.settle()
    assert windows.windows == [made.window]
    assert sizes(made)[0] == 12


def test_drawings_and_the_robot_s_screen_keep_their_letters(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    document = studio(project("reception")).session.document("reception.rbd.xml")
    assert isinstance(document, Application)
    screen = document.states[3].screen
    assert screen is not None
    drawn: list[tuple[str, QImage]] = []
    for size in (100, 150):
        letters.use(size)
        file = tmp_path / f"{size}.svg"
        picture.draw(document, file, "reception")
        image = QImage(640, 400, QImage.Format.Format_RGB32)
        image.fill(Qt.GlobalColor.white)
        painter = QPainter(image)
        paint_screen(painter, QRectF(image.rect()), screen)
        painter.end()
        drawn.append((file.read_text("utf-8"), image))
    (one, screen_of_one), (other, screen_of_other) = drawn
    assert screen_of_one == screen_of_other
    # The outlines of letters differ by a 64th of a px where they were drawn in other sizes before.
    assert NUMBER.split(one) == NUMBER.split(other)
    numbers = [[float(number) for number in NUMBER.findall(text)] for text in (one, other)]
    assert numbers[0] == pytest.approx(numbers[1], abs=0.05)
    assert font(BODY).pixelSize() == 20
    assert face(BODY).pixelSize() == 13


@pytest.mark.parametrize("size", [100, 150])
def test_what_lists_a_few_things_is_as_high_as_their_rows(qt: QApplication, size: int) -> None:
    letters.use(size)
    window = QWidget()
    menu = FollowMenu(FOLLOWS[:4], LIGHT, window)
    table = SampleTable("patients", ("name",), ["Ana", "Jack"])
    tree = ProjectTree(LIGHT)
    project, _ = folder.load(example("reception"))
    assert project is not None
    tree.show_project(project, list(project.flows))
    tree.resize(300, tree.maximumHeight())
    for shown, rows in ((menu, menu.list), (table, table), (tree, tree.tree)):
        shown.show()
        QApplication.processEvents()
        assert rows.verticalScrollBar().maximum() == 0
        shown.close()
        shown.deleteLater()
    window.deleteLater()


def test_the_pictures_of_states_grow_with_the_words_below_them(qt: QApplication) -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    edges: list[int] = []
    for size in (100, 150):
        letters.use(size)
        strip = StateStrip(LIGHT, lambda: None)
        strip.show_state(next(iter(project.flows.values())), ())
        strip.resize(900, strip.height())
        picture = strip.grab(strip.visualRect(strip.model().index(1, 0))).toImage()
        row = [picture.pixelColor(x, picture.height() // 3) for x in range(picture.width())]
        edges.append(max(x for x, colour in enumerate(row) if colour != row[0]))
        strip.deleteLater()
    assert edges[1] == pytest.approx(1.5 * edges[0], abs=2)


def test_a_tab_below_without_room_ends_with_dots_and_says_its_words_in_its_tooltip(
    qt: QApplication,
) -> None:
    tab = CountButton(LIGHT, "Breakpoints")
    tab.set_count(12)
    tab.resize(300, 28)
    tab.grab()
    assert (tab._fitting(), tab.toolTip()) == ("Breakpoints", "")
    tab.resize(90, 28)
    tab.grab()
    assert tab._fitting().endswith("…")
    assert tab.toolTip() == "Breakpoints"
    tab.deleteLater()


@pytest.mark.parametrize("chosen", [True, False])
def test_no_letter_of_a_tab_below_is_painted_in_part(qt: QApplication, chosen: bool) -> None:
    """Whatever little room there is: its words are whole, or end with dots."""
    letters.use(150)
    strip = QFrame()
    strip.setProperty("role", "bottomtabs")
    strip.setStyleSheet(qss(LIGHT))
    for words in ("Problems", "Authority"):
        tab = CountButton(LIGHT, words, strip)
        tab.setChecked(chosen)
        tab.ensurePolished()
        natural = tab.sizeHint().width()

        def inked(width: int, tab: CountButton = tab) -> int:
            """Px from the first to the last column with ink."""
            tab.resize(width, 42)
            picture = tab.grab().toImage()
            ground = picture.pixelColor(1, 21)
            ink = [
                x
                for x in range(width)
                if any(picture.pixelColor(x, y) != ground for y in range(8, 36))
            ]
            return ink[-1] - ink[0]

        whole = inked(3 * natural)
        for width in range(natural - 12, natural + 3):
            seen = inked(width)
            assert tab.toolTip() or abs(seen - whole) <= 1, f"{words}: {seen} of {whole} px"
        assert tab.toolTip() == "", "it has room in what it asks for"
    strip.deleteLater()


def test_the_number_of_a_tab_below_stands_apart_from_its_words(
    studio: Start, project: Copy
) -> None:
    """Also of the tab that is chosen, whose words are bolder."""
    used = studio(project("reception"))
    bottom = used.window.bottom
    bottom.choose("problems")
    for count in (8, 44, 108):
        bottom.set_count("problems", count)
        used.settle()
        tab = next(
            b for b in used.window.findChildren(CountButton) if b.text().startswith("Problems")
        )
        picture = tab.grab().toImage()
        middle = tab.height() // 2
        row = [picture.pixelColor(x, middle).name() for x in range(tab.width())]
        begins = row.index(LIGHT.color("hover").name())
        before = {
            picture.pixelColor(x, y).name()
            for x in (begins - 3, begins - 2)
            for y in range(middle - 8, middle + 8)
        }
        assert len(before) == 1, f"the words reach to {count}"


def test_only_the_panel_below_that_is_shown_asks_for_width(studio: Start, project: Copy) -> None:
    bottom = studio(project("reception")).window.bottom
    bottom.choose("timeline")
    wide = bottom.minimumSizeHint().width()
    bottom.choose("problems")
    assert bottom.minimumSizeHint().width() < wide


def test_a_menu_that_is_higher_than_the_screen_scrolls(studio: Start) -> None:
    menu = studio().window.actions_.menu("Insert")
    menu.ensurePolished()
    assert menu.style().styleHint(QStyle.StyleHint.SH_Menu_Scrollable, None, menu) == 1
