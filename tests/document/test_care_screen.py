"""Care with what is shown: what the lints must find, and what they must leave alone."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.document.care_projects import always, app, mended, places, state, told, whole

from situ.document import care_screen as care
from situ.document.analysis_search import Search
from situ.document.colours import NAMED, Colour, colour, contrast, luminance
from situ.document.rbd import Application, Button, Input, Text

PAGE = Path(__file__).resolve().parents[2] / "resources" / "screen"
LONG = (
    "Your nurse comes at eight to help you into the bath, and at nine there is tea in the garden."
)


def shown(components: str, rest: str = "") -> Application:
    return app(state(components) + rest)


def of(component: str, x: float, y: float, width: float, height: float, rest: str = "") -> str:
    element, _, more = component.partition(" ")
    at = f'x="{x}" y="{y}" width="{width}" height="{height}"'
    text = "Yes" if element in ("text", "button") else ""
    return f'<{element} id="c" {at} {more} {rest}>{text}</{element}>'


# -- tap targets -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("component", "width", "height", "is_told"),
    [
        ('button event="e"', 5.6, 8.9, False),
        ('button event="e"', 5.5, 8.9, True),
        ('button event="e"', 5.6, 8.8, True),
        ('button tag="t" value="1"', 40, 5, True),
        ('input tag="t"', 40, 5, True),
        ('list items="t"', 5, 40, True),
        # A touch of these does nothing.
        ("button", 5, 5, False),
        ("text", 5, 5, False),
        ('image src="http://a/b.png"', 5, 5, False),
    ],
)
def test_a_target_of_less_than_12_mm_is_told(
    component: str, width: float, height: float, is_told: bool
) -> None:
    project = whole(shown(of(component, 10, 10, width, height)))
    assert places(project, "small-target") == ([("state", "1", "screen", "c")] if is_told else [])


def test_the_mend_of_a_target_makes_it_large_enough_and_keeps_it_on_the_screen() -> None:
    project = whole(shown(of('button event="e"', 98, 50, 2, 30)))
    (problem,) = told(project, "small-target")
    assert "4.3 mm wide" in problem.message
    after = mended(project, problem)
    assert told(after, "small-target") == []
    (button,) = after.applications["a0.rbd.xml"].states[0].screen.components  # type: ignore[union-attr]
    assert (button.x, button.y, button.width, button.height) == (94.4, 50, 5.6, 30)


def test_a_target_of_always_is_told_once() -> None:
    shared = always(of('button event="e"', 1, 1, 3, 3))
    project = whole(shared + state(no="1") + state(no="2"))
    assert places(project, "small-target") == [("always", "screen", "c")]


def test_where_two_have_one_name_nothing_is_mended() -> None:
    # The error comes first; of the warning only its place would be known.
    second = of('button event="e"', 1, 60, 3, 3)
    project = whole(shown(of('button event="e"', 1, 1, 50, 50) + second))
    assert told(project, "small-target") == []
    search = Search(project)
    care.small_targets(search, "a0.rbd.xml", project.applications["a0.rbd.xml"])
    assert [one.mend for one in search.found["a0.rbd.xml"]] == [None]


# -- letters -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("component", "height", "is_told"),
    [
        ('text size="3.9"', 30, True),
        ('text size="4"', 30, False),
        ("text", 30, False),
        ('button event="e" size="3"', 30, True),
        ('input tag="t" size="3"', 30, True),
        ('list items="t" size="3"', 30, True),
        ('image src="http://a/b.png" size="3"', 30, False),
        # One line is higher than the component.
        ('text size="9"', 4.4, True),
        ('text size="9"', 4.6, False),
        ('button event="e" size="9"', 6.3, True),
        ('button event="e" size="9"', 6.5, False),
        ('input tag="t" size="9"', 4, False),
    ],
)
def test_letters_of_less_than_4_percent_are_told(
    component: str, height: float, is_told: bool
) -> None:
    project = whole(shown(of(component, 10, 10, 60, height)))
    assert places(project, "small-text") == ([("state", "1", "screen", "c")] if is_told else [])


def test_the_mend_of_small_letters_gives_them_their_size() -> None:
    project = whole(shown(of('text size="2"', 10, 10, 60, 30)))
    (problem,) = told(project, "small-text")
    assert "2.7 mm" in problem.message
    assert told(mended(project, problem), "small-text") == []


def text(said: str, width: float, height: float, element: str = "text") -> str:
    return f'<{element} id="c" x="1" y="1" width="{width}" height="{height}">{said}</{element}>'


@pytest.mark.parametrize(
    ("component", "is_told"),
    [
        (text(LONG, 20, 8), True),
        (text(LONG, 20, 8, "button"), True),
        (text(LONG, 80, 40), False),
        (text("{user.story}" + "." * 30, 20, 20), False),
        (text("今日は良い天気ですね。" * 6, 20, 20), True),
        (text("今日は良い天気ですね。" * 2, 60, 20), False),
        # Of other scripts nothing is known.
        (text("แ" * 400, 20, 20), False),
        (text("i" * 60, 20, 20), False),
        (text("", 3, 3), False),
    ],
)
def test_a_text_that_fits_only_in_small_letters_is_told(component: str, is_told: bool) -> None:
    assert bool(told(whole(shown(component)), "small-text")) is is_told


def test_a_text_that_fits_in_one_language_only_is_told() -> None:
    one = shown(text("Tea", 20, 8))
    project = whole(one, languages=("en", "de"), texts={"de": {"Tea": LONG}})
    (problem,) = told(project, "small-text")
    assert "Your nurse comes" in problem.message
    assert told(whole(one, languages=("en",)), "small-text") == []


# -- contrast ----------------------------------------------------------------------

PALE = 'color="#9aa5b8"'


@pytest.mark.parametrize(
    ("component", "is_told"),
    [
        (f"text {PALE}", True),
        ('text color="gray"', True),
        ('text color="rgb(90, 90, 90)"', False),
        ("text", False),
        ('text size="5"', False),
        # Its own fill is behind it.
        (f'text {PALE} fill="#15223b"', False),
        ('text fill="navy"', True),
        ('text fill="#eee"', False),
        (f'button event="e" {PALE}', True),
        ('button event="e" color="#fff" fill="#1f4fc4"', False),
        ('button event="e" color="#fff" fill="orange"', True),
        # The page chooses, and not always well.
        ('button event="e"', False),
        ('button event="e" fill="yellow"', False),
        ('button event="e" fill="navy"', False),
        ('button event="e" fill="#f57c00"', False),
        ('button event="e" fill="#808080"', True),
        ('input tag="t"', False),
        (f'input tag="t" {PALE}', True),
        ('input tag="t" fill="navy"', True),
        # Its entries are white whatever its fill.
        ('list items="t" color="#fff" fill="navy"', True),
        ('list items="t"', False),
        # Nobody knows.
        ('text color="var(--x)"', False),
        ('text color="#9aa5b880"', False),
        (f'text {PALE} fill="#9aa5b880"', False),
        ('button event="e" fill="color-mix(red)"', False),
        (f'image src="http://a/b.png" {PALE}', False),
    ],
)
def test_letters_of_low_contrast_are_told(component: str, is_told: bool) -> None:
    project = whole(shown(of(component, 10, 10, 60, 30)))
    found = places(project, "low-contrast")
    assert found == ([("state", "1", "screen", "c")] if is_told else [])


@pytest.mark.parametrize("fill", ["", 'fill="#f57c00"', 'fill="#777"', 'fill="#1f4fc4"'])
def test_the_mend_of_low_contrast_is_easy_to_read(fill: str) -> None:
    project = whole(shown(of(f'text color="#808080" {fill}', 10, 10, 60, 30)))
    (problem,) = told(project, "low-contrast")
    assert told(mended(project, problem), "low-contrast") == []


PALE_TEXT = of(f"text {PALE}", 10, 10, 60, 30)


@pytest.mark.parametrize(
    ("below", "is_told"),
    [
        ('<image id="i" x="0" y="0" width="100" height="100" src="http://a/b.png"/>', False),
        ('<text id="i" x="0" y="0" width="100" height="100" fill="#000"> </text>', False),
        # Beside it, and one that hides nothing.
        ('<image id="i" x="0" y="50" width="100" height="50" src="http://a/b.png"/>', True),
        ('<text id="i" x="0" y="0" width="100" height="100"> </text>', True),
    ],
)
def test_of_a_text_on_something_else_nothing_is_said(below: str, is_told: bool) -> None:
    assert bool(told(whole(shown(below + PALE_TEXT)), "low-contrast")) is is_told
    # What comes after it lies above it, and always lies above all.
    assert told(whole(shown(PALE_TEXT + below)), "low-contrast") != []
    shared = always(PALE_TEXT)
    assert bool(told(whole(shared + state(below)), "low-contrast")) is is_told


def test_of_a_text_on_a_picture_behind_all_nothing_is_said() -> None:
    picture = '<screen background="http://a/b.png"><components>{}</components></screen>'
    framed = picture.format(PALE_TEXT)
    assert told(whole(state(framed)), "low-contrast") == []
    # The background of always is behind states without one, and a state's is behind always.
    assert told(whole(always(picture.format("")) + state(PALE_TEXT)), "low-contrast") == []
    assert told(whole(always(PALE_TEXT) + state(picture.format(""))), "low-contrast") == []
    assert told(whole(always(PALE_TEXT) + state("<screen/>")), "low-contrast") != []


def test_of_a_text_in_a_part_nothing_is_said_where_a_picture_may_be_behind_it() -> None:
    part = app(state(PALE_TEXT), "part")
    flow = '<state no="1"><flow src="part1.rbd.xml"/></state>'
    assert told(whole(flow, part), "low-contrast") != []
    around = always('<screen background="http://a/b.png"/>')
    assert told(whole(around + flow, part), "low-contrast") == []
    assert told(whole(always(PALE_TEXT) + flow, app(state(), "part")), "low-contrast") == []


# -- colours -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "known"),
    [
        (" #FFF ", (255, 255, 255)),
        ("#1f4fc4", (31, 79, 196)),
        ("rgb(1,2,3)", (1, 2, 3)),
        ("rgb( 300 2 3 )", (255, 2, 3)),
        ("RebeccaPurple", (102, 51, 153)),
        ("transparent", None),
        ("#12345", None),
        ("rgb(1,2,3,0.5)", None),
        ("", None),
    ],
)
def test_a_colour_is_read_as_css_writes_it(text: str, known: Colour | None) -> None:
    assert colour(text) == known


def test_every_named_colour_is_known() -> None:
    assert len(NAMED) == 148
    assert None not in {colour(name) for name in NAMED}


CHANNEL = st.integers(0, 255)
COLOUR = st.tuples(CHANNEL, CHANNEL, CHANNEL)


@given(COLOUR, COLOUR)
def test_contrast_is_between_1_and_21_whichever_is_in_front(one: Colour, other: Colour) -> None:
    assert contrast(one, other) == contrast(other, one)
    assert 1 <= contrast(one, other) <= 21 + 1e-9
    assert contrast(one, one) == 1


def test_contrast_is_that_of_wcag() -> None:
    assert contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21)
    # Its best known border: the lightest grey for plain text on white.
    assert contrast((118, 118, 118), (255, 255, 255)) == pytest.approx(4.54, abs=0.005)
    assert luminance((255, 0, 0)) == pytest.approx(0.2126)


@given(COLOUR)
def test_something_is_easy_to_read_on_every_colour(behind: Colour) -> None:
    text = "#{:02x}{:02x}{:02x}".format(*behind)
    letters = colour(care.readable((text,)))
    assert letters is not None
    assert contrast(letters, behind) >= care.CONTRAST


@given(COLOUR)
def test_the_page_writes_a_button_as_is_easier_to_read(fill: Colour) -> None:
    ink, white = colour(care.INK), (255, 255, 255)
    assert ink is not None
    dark = luminance(fill) > care.LIGHT
    chosen, other = (ink, white) if dark else (white, ink)
    assert contrast(chosen, fill) >= contrast(other, fill) - 0.02


# -- the page ----------------------------------------------------------------------


def test_the_page_has_the_colours_and_sizes_that_are_taken_for_granted() -> None:
    table = dict(re.findall(r"--([a-z-]+): ([^;]+);", (PAGE / "measures.css").read_text()))
    grounds = (table["ground-top"], table["ground"], table["ground-bottom"])
    assert grounds == care.GROUND
    colours = (table["ink"], table["ink-soft"], table["accent"])
    assert colours == (care.INK, care.INK_SOFT, care.ACCENT)
    sizes = {Text: "text-size", Button: "button-size", Input: "input-size"}
    assert {kind: float(table[name]) for kind, name in sizes.items()} == care.SIZES
    high = float(table["button-line"]) + 2 * float(table["button-high"])
    assert {Text: float(table["text-line"]), Button: high} == care.LINE
    assert float(table["body-from"]) == care.SOFT
    assert float(table["light"]) == care.LIGHT
