"""Texts in their boxes, as the robot's page sets them (docs/screen.md); beside the page itself
tests/browser/test_agreement.py.
"""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QApplication

from situ.document import care_screen, rbd
from situ_studio.screens.component_painting import Stage
from situ_studio.screens.input_painting import date
from situ_studio.screens.lettering import Style, fit, set_lines
from situ_studio.screens.measures import measures
from situ_studio.screens.painting import layer, paint_content
from situ_studio.screens.shown import Content, content

PLAIN = Style(500, 1.18, -0.01)
TEXTS = st.text(st.sampled_from("aeiW -\n今はっ。「"), min_size=1, max_size=60)


def texts(text: str, width: float, height: float, wanted: float = 48.0) -> tuple[float, list[str]]:
    """The size of a text in a box of these px, and its lines."""
    fitted = fit(text, PLAIN, width, height, wanted, 0.0, 0.0)
    return fitted.size, [one.text for one in set_lines(text, PLAIN, fitted, width)]


def component(kind: str, name: str, x: float, width: float, **more: Any) -> dict[str, Any]:
    return {"type": kind, "id": name, "x": x, "y": 10, "width": width, "height": 20} | more


def test_a_text_that_fits_has_the_size_that_was_designed(qt: QApplication) -> None:
    assert texts("Hello", 400, 100) == (48.0, ["Hello"])


def test_a_text_that_does_not_fit_is_smaller_until_it_does(qt: QApplication) -> None:
    size, lines = texts("Please tell me your name, and sit down here", 300, 100)
    assert 11 <= size < 48
    assert len(lines) * 1.18 * size <= 101


def test_lines_are_even_and_not_one_more(qt: QApplication) -> None:
    words = "How are you today, Mrs. Yamada?"
    assert texts(words, 650, 130)[1] == ["How are you today,", "Mrs. Yamada?"]


def test_lines_end_where_the_text_itself_says(qt: QApplication) -> None:
    assert texts("One\ntwo  three\n\nfour", 700, 400)[1] == ["One", "two three", "", "four"]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("\n \nOne", ["", "", "One"]),
        (" One\n", ["One"]),
        ("One\n\n", ["One", ""]),
        ("\n", [""]),
        ("", [""]),
    ],
)
def test_what_begins_with_an_empty_line_shows_it_and_what_ends_with_one_does_not(
    qt: QApplication, text: str, lines: list[str]
) -> None:
    # As CSS has it: what a reference without a value leaves.
    assert texts(text, 700, 400)[1] == lines


def test_japanese_goes_on_after_a_phrase(qt: QApplication) -> None:
    assert texts("庭でお茶を飲みましょう", 300, 400)[1] == ["庭でお茶を", "飲みましょう"]


def test_phrases_are_parted_before_letters_become_much_smaller(qt: QApplication) -> None:
    size, lines = texts("飲みましょう", 130, 400)
    assert size == 48
    assert len(lines) > 1


@settings(max_examples=60, deadline=None)
@given(TEXTS, st.floats(40, 400), st.floats(20, 300), st.floats(12, 90))
def test_whatever_fits_lies_in_its_box_and_nothing_is_left_out(
    qt: QApplication, text: str, width: float, height: float, wanted: float
) -> None:
    fitted = fit(text, PLAIN, width, height, wanted, 0.0, 0.0)
    lines = set_lines(text, PLAIN, fitted, width)
    assert "".join("".join(one.text for one in lines).split()) == "".join(text.split())
    if not fitted.cut:
        assert fitted.size <= wanted
        assert all(one.width * fitted.size <= width + 2 for one in lines)
        assert len(lines) * PLAIN.line * fitted.size <= height + 1.1


def test_buttons_that_are_alike_are_written_alike(qt: QApplication) -> None:
    alike = [
        component("button", name, 2 + n * 20, 18, text=name)
        for n, name in enumerate(("Medication and everything else", "Games"))
    ]
    large = component("button", "large", 60, 34, text="Help")
    stage = Stage(QSizeF(1280, 800), Content((*alike, large)), None)
    sizes = [stage.fitted(one).size for one in (*alike, large)]
    assert sizes[0] == sizes[1] < sizes[2]


@pytest.mark.parametrize(
    ("widths", "first"),
    [([18], "b0"), ([18, 18], "b0"), ([24, 18, 18], "b0"), ([18, 18, 18], None), ([18] * 4, None)],
)
def test_of_a_few_answers_the_first_is_filled_but_not_of_three_equal_choices(
    qt: QApplication, widths: list[int], first: str | None
) -> None:
    buttons = [
        component("button", f"b{n}", n * 24, width, text="x") for n, width in enumerate(widths)
    ]
    coloured = component("button", "home", 80, 18, text="x", fill="teal")
    stage = Stage(QSizeF(1280, 800), Content((coloured, *buttons)), None)
    assert (stage.first["id"] if stage.first else None) == first


def test_a_screen_held_upright_is_measured_by_its_width(qt: QApplication) -> None:
    assert Stage(layer(QSize(800, 1280)), Content(()), None).unit == 10
    # A phone keeps the shape that it was designed in, as far as it can.
    assert layer(QSize(390, 844)) == QSizeF(390, 702)


def test_texts_are_filled_in_as_the_robot_fills_them_in(qt: QApplication) -> None:
    place: dict[str, Any] = {"x": 0.0, "y": 0.0, "width": 50.0, "height": 20.0}
    screen = rbd.Screen(
        background="{room}.png",
        components=(
            rbd.Text(id="t", text=" Hello {user.name}, {age} {{ok}} {none}", **place),
            rbd.Image(id="i", src="{user.name}.png", **place),
            rbd.List(id="l", items="meals", label="{item} – {age}", **place),
            rbd.Input(id="n", tag="age", **place),
        ),
    )
    values = {"user": {"name": "Ann"}, "age": 81.0, "meals": ["Soup"], "room": "lobby"}
    text, image, meals, number = content(screen, (), values).components
    assert text["text"] == "Hello Ann, 81 {ok} "
    assert image["src"] == "Ann.png"
    assert meals["items"] == [{"label": "Soup – 81", "value": "Soup"}]
    assert number["value"] == 81.0
    shown = content(screen, (), values | {"language": "de"})
    assert (shown.background, shown.language) == ("lobby.png", "de")
    # Without values it is as it is written.
    written = content(screen)
    assert written.components[0]["text"] == "Hello {user.name}, {age} {{ok}} {none}"
    assert written.components[2]["items"] is None


def test_what_has_the_id_of_another_is_left_out_as_on_the_robot(qt: QApplication) -> None:
    place: dict[str, Any] = {"x": 0.0, "y": 0.0, "width": 50.0, "height": 20.0}
    own, always = (rbd.Text(id="t", text=text, **place) for text in ("own", "always"))
    shown = content(rbd.Screen(components=(own,)), (always,)).components
    assert [one["text"] for one in shown] == ["own"]


@pytest.mark.parametrize(
    ("language", "typed", "asked"),
    [
        ("en", "05/07/1941", "MM/DD/YYYY"),
        ("de", "07.05.1941", "TT.MM.JJJJ"),
        ("ja", "1941/05/07", "YYYY/MM/DD"),
        ("en_GB", "07/05/1941", "DD/MM/YYYY"),
        ("fi", "07.05.1941", "DD.MM.YYYY"),
        ("xx", "05/07/1941", "MM/DD/YYYY"),
    ],
)
def test_a_date_is_shown_in_the_order_of_the_language(
    language: str, typed: str, asked: str
) -> None:
    assert date("1941-05-07", language) == typed
    assert date("", language) == asked
    assert date("soon", language) == "soon"


def test_a_list_whose_entries_are_not_known_shows_rows_all_the_same(qt: QApplication) -> None:
    place: dict[str, Any] = {"x": 10.0, "y": 10.0, "width": 80.0, "height": 60.0}
    screen = rbd.Screen(components=(rbd.List(id="l", items="meals", **place),))
    image = QImage(1280, 800, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.black)
    painter = QPainter(image)
    paint_content(painter, QRectF(0, 0, 1280, 800), content(screen))
    painter.end()
    assert image.pixelColor(640, 120).name() == "#ffffff"


def test_the_care_lints_reckon_with_the_measures_of_the_page() -> None:
    known = measures()
    sizes = {kind: known[f"{kind.__name__.lower()}-size"] for kind in care_screen.SIZES}
    assert sizes == care_screen.SIZES
    lines = {
        rbd.Text: known["text-line"],
        rbd.Button: known["button-line"] + 2 * known["button-high"],
    }
    assert lines == care_screen.LINE
    assert (known["body-from"], known["light"]) == (care_screen.SOFT, care_screen.LIGHT)
    inks = tuple(known.colour(name).name() for name in ("ink", "ink-soft", "accent"))
    assert inks == (care_screen.INK, care_screen.INK_SOFT, care_screen.ACCENT)
    shades = ("ground-top", "ground", "ground-bottom")
    assert tuple(known.colour(name).name() for name in shades) == care_screen.GROUND
