"""What is told of a component's fitness is what the care lints judge, with the numbers."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtWidgets import QApplication
from tests.document.care_projects import app, state, whole

from situ.document.check import check
from situ_studio.screens.devices import DEVICES, Device
from situ_studio.screens.fitness import fits

JUDGED = {"small-target", "small-text", "low-contrast"}
COLOURS = st.sampled_from(["", 'color="#777777"', 'color="#ffffff"', 'fill="#1f4fc4"'])
SIZES = st.sampled_from(["", 'size="3"', 'size="4"', 'size="9"'])
KINDS = st.sampled_from(['button event="e"', "button", "text", 'input tag="t"', 'list items="t"'])


def told(kind: str, box: tuple[float, float], more: str, text: str) -> tuple[set[str], list[bool]]:
    """The codes of the lints about the one component, and what is said to be fit or not."""
    element, _, rest = kind.partition(" ")
    place = f'x="10" y="10" width="{box[0]}" height="{box[1]}"'
    words = text if element in ("text", "button") else ""
    written = app(state(f'<{element} id="c" {place} {rest} {more}>{words}</{element}>'))
    project = whole(written)
    application = next(iter(project.applications.values()))
    screen = application.states[0].screen
    assert screen is not None
    at = ("state", "1", "screen", "c")
    codes = {one.code for one in check(project) if one.place == at} & JUDGED
    file = next(iter(project.applications))
    found = fits(project, file, application, screen, screen.components[0])
    return codes, [one.is_fit for one in found]


@given(KINDS, st.floats(3, 60), st.floats(3, 60), COLOURS, SIZES, st.sampled_from(["Yes", ""]))
@settings(max_examples=60, deadline=None)
def test_what_a_lint_tells_is_not_fit_and_nothing_else_is(
    kind: str, width: float, height: float, colours: str, size: str, text: str
) -> None:
    codes, fit = told(kind, (round(width, 1), round(height, 1)), f"{colours} {size}", text)
    # A list is not read by itself: its entries are.
    codes -= {"small-text"} if kind.startswith("list") else set()
    assert len(codes) == fit.count(False), (codes, fit)


def test_the_numbers_are_those_of_a_10_inch_screen() -> None:
    components = (
        '<button id="a" x="10" y="60" width="38" height="22" size="8" event="e">YES</button>'
        '<button id="b" x="52" y="60" width="38" height="22" size="8" event="f">NO</button>'
    )
    application = app(state(components))
    project = whole(application)
    screen = application.states[0].screen
    assert screen is not None
    found = fits(
        project, next(iter(project.applications)), application, screen, screen.components[1]
    )
    assert [one.words for one in found] == [
        "82 × 30 mm, at least 12 mm is needed",
        "Text 10.8 mm high, read from 1.3\u00a0m",
        "Contrast 7 to 1",
        "9 mm to the next button",
    ]
    assert all(one.is_fit for one in found)


def test_on_another_device_sizes_are_those_that_it_shows(qt: QApplication) -> None:
    components = (
        '<button id="a" x="10" y="60" width="38" height="22" size="8" event="e">YES</button>'
        '<button id="b" x="52" y="60" width="38" height="22" size="8" event="f">NO</button>'
    )
    application = app(state(components))
    project = whole(application)
    file = next(iter(project.applications))
    screen = application.states[0].screen
    assert screen is not None

    def told(device: Device) -> list[str]:
        every = fits(project, file, application, screen, screen.components[1], device)
        assert len(every) == 4
        return [one.words for one in every]

    seven, phone = DEVICES[1], DEVICES[3]
    assert told(seven)[0] == "58 × 20 mm, at least 12 mm is needed"
    assert told(seven)[3] == "6 mm to the next button"
    small = fits(project, file, application, screen, screen.components[1], phone)
    # 22 % of a side of 65 mm still take a finger; 8 % of it are read from half as far.
    assert small[0].words == "53 × 14 mm, at least 12 mm is needed"
    assert [one.is_fit for one in small] == [True, False, True, True]
    # Held upright it is narrower, and components share less than its height.
    assert told(phone.turned())[0].startswith("25 × ")
