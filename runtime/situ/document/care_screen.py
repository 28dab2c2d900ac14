"""Care with what is shown: to be hit by a finger that trembles, to be read by old eyes.

Sizes are judged on a screen of 10 inches, 16 to 10: what is large enough there is so on every
bigger one.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

from situ.document import words
from situ.document.analysis_data import screens
from situ.document.analysis_search import Search
from situ.document.care_mend import puts
from situ.document.care_speech import literal
from situ.document.colours import Colour, colour, contrast, luminance
from situ.document.finding import Place
from situ.document.project import Project
from situ.document.rbd import (
    Application,
    Button,
    Component,
    Input,
    List,
    Screen,
    Text,
)

WIDE, HIGH = 217, 136
"""Millimetres of a screen sold as 10-inch (10.1 inches across, 16 to 10)."""

TARGET = 12
"""Millimetres that a tap target needs each way (studio.md); WCAG 2.2, 2.5.5 asks for 11.6 of
everybody's fingers, and these are old ones.
"""

SIZE = 4.0
"""Percent of the screen's height that letters need. 4 % are 5.4 mm, of which capitals have 4.0
(``CAPITAL``): from an arm's length of 600 mm 23 minutes of arc, where ISO 9241-303 recommends 20
to 22 for reading with ease. It is also the 15 to 16 point of large print.
"""

CAPITAL = 0.727
"""Height of a capital beside the size of its letters, in the page's fonts."""

SIZES = {Text: 6.0, Button: 6.0, Input: 7.0}
"""What the page takes where there is no ``size`` (resources/screen/components.js, input.js)."""

LINE = {Text: 1.18, Button: 1.15 + 2 * 0.25}
"""A line's height beside its letters' size, a button's padding added (screen.css)."""

STAGE = 1.75
"""Width to height of what the page leaves for components on such a screen, its caption (8.5 % of
the height, screen.css) taken off.
"""

NARROW, LETTER, FULL = 0.19, 0.5, 0.95
"""The least widths of characters in the page's fonts, beside their size: of ``NARROW_ONES``, of
other ``LETTERS`` and digits, of Chinese and Japanese ones. All others count nothing.
"""

CONTRAST = 4.5
"""WCAG 2.2, 1.4.3 (AA) of plain text, 1.4.6 (AAA) of large text: chosen there for eyes with 20/40
vision, which is usual at eighty; studio.md asks for the same. So large letters get no less here.
"""

INK, INK_SOFT, ACCENT = "#15223b", "#43526d", "#1f4fc4"
GROUND = ("#fbfdff", "#f7fafe", "#eef4fc")
"""The page's own colours (resources/screen/screen.css): of texts, of those smaller than ``SOFT``,
of buttons; and of what is behind all, from top to bottom.
"""

SOFT = 5.5
"""Below this ``size`` the page writes softer (components.js)."""

LIGHT = 0.213
"""On a ``fill`` of more luminance the page writes a button without color dark, else white
(resources/screen/colours.js).
"""

PIXEL = 0.2
"""Percent by which the page lets a text be larger than its component (a pixel, fit.js)."""

NARROW_ONES = re.compile(r"[\]\[ijlrtfIJ1(){}|/\\'.,:;!\"ÌÍÎÏìíîï-]")
LETTERS = re.compile(r"[A-Za-z0-9À-ÖØ-öø-ÿ]")
FULL_ONES = re.compile("[\u3041-\u3096\u30a1-\u30fa\u3400-\u9fff]")


# -- tap targets -----------------------------------------------------------------


def small_targets(search: Search, file: str, application: Application) -> None:
    """``small-target``: a button that does something, an input or a list is less than ``TARGET``
    wide or high, as designed. Lists and inputs of any width count; rows are the page's.
    """
    for component, place in _components(application):
        tapped = isinstance(component, (Input, List)) or (
            isinstance(component, Button) and (component.event or component.tag)
        )
        wide, high = component.width * WIDE / 100, component.height * HIGH / 100
        if not tapped or (wide >= TARGET and high >= TARGET):
            continue
        side, size = ("wide", wide) if wide < TARGET else ("high", high)
        message = (
            f"This is {math.floor(size * 10) / 10:g} mm {side} on a 10-inch screen, and fingers "
            f"need {TARGET}: make it at least {least(WIDE):g} wide and {least(HIGH):g} high"
        )
        fields: dict[str, float] = {}
        for field, beside, most in (("width", "x", WIDE), ("height", "y", HIGH)):
            needed = least(most)
            if getattr(component, field) < needed:
                fields[field] = needed
                if getattr(component, beside) + needed > 100:
                    fields[beside] = round(100 - needed, 1)
        mend = puts(search, file, place, component, f"Make it {TARGET} mm large", **fields)
        search.warn(file, "small-target", message, component.aside, place, mend)


def least(length: int) -> float:
    """Percent of a side of the screen that a target needs, rounded up to a tenth."""
    return math.ceil(TARGET / length * 1000) / 10


# -- letters -----------------------------------------------------------------------


def small_texts(search: Search, file: str, application: Application) -> None:
    """``small-text``: letters of less than ``SIZE``: by ``size``, or because the page makes a text
    smaller until it lies in its component. Of that, only what is sure is told: that its one line
    is too high, or that its letters, were they as narrow as ``NARROW``, ``LETTER`` and ``FULL``
    say, would cover more than there is. In any language of the project; values of references
    count nothing.
    """
    for component, place in _components(application):
        if isinstance(component, (Text, Button)) and not component.text:
            continue
        if not isinstance(component, (Text, Button, Input, List)):
            continue
        if component.size is not None and component.size < SIZE:
            height = component.size * HIGH / 100
            message = (
                f"These letters are {height:.1f} mm on a 10-inch screen, too small for many old "
                f"eyes: make the size at least {SIZE:g}"
            )
            mend = puts(search, file, place, component, f"Make the size {SIZE:g}", size=SIZE)
            search.warn(file, "small-text", message, component.aside, place, mend)
        elif isinstance(component, (Text, Button)):
            most, said = largest(search.project, component)
            if most < SIZE:
                message = (
                    f"So that {words.quoted(said)} fits into it, the letters become "
                    f"{most * HIGH / 100:.1f} mm or less on a 10-inch screen, too small for many "
                    "old eyes: make it larger, or say less"
                )
                search.warn(file, "small-text", message, component.aside, place)


def largest(project: Project, component: Text | Button) -> tuple[float, str]:
    """The largest size of letters that can lie in a component, and the text that needs it."""
    line = LINE[type(component)]
    high = max(component.height, 0) + PIXEL
    most = high / line
    told = component.text
    room = (max(component.width, 0) + PIXEL) * STAGE * high
    # No letter is wider than its size: most texts need no counting.
    for texts in ({}, *project.texts.values()):
        text = texts.get(component.text, component.text)
        if room < len(text) * SIZE * SIZE * line:
            covered = _width(literal(text)) * (line if isinstance(component, Text) else 1.15)
            size = math.sqrt(room / covered) if covered else most
            if size < most:
                most, told = size, text
    return most, told


def _width(text: str) -> float:
    """The least that a text can be wide, in sizes of its letters."""
    narrow = len(NARROW_ONES.findall(text))
    full = len(FULL_ONES.findall(text))
    letters = len(LETTERS.findall(NARROW_ONES.sub("", text)))
    return narrow * NARROW + letters * LETTER + full * FULL


# -- contrast ----------------------------------------------------------------------


def low_contrast(search: Search, file: str, application: Application) -> None:
    """``low-contrast``: a text's colour against what is behind it is below ``CONTRAST``.

    Behind it is its ``fill``; without one white for buttons and inputs, and always for entries
    of a list; for a text without one it is the page, of which the shade that helps most counts.
    Nothing is said of a text that lies, or in another state may lie, on a picture or on another
    component, nor of colours that ``situ.document.colours`` does not know. Where there is no
    color, the page's own counts.
    """
    for screen, place in screens(application):
        for component in screen.components:
            given = colours_of(component)
            best = contrast_of(search.project, file, application, screen, component)
            if given is None or best is None or best >= CONTRAST:
                continue
            ink, behind = given
            message = (
                f"The color {ink} on {behind[0] if behind else 'the page'} is hard to read: their "
                f"contrast is {math.floor(best * 10) / 10:g}, and {CONTRAST:g} is needed; choose a "
                "darker or a lighter color"
            )
            at = (*place, component.id)
            better = readable(behind or GROUND)
            mend = puts(search, file, at, component, f"Make the color {better}", color=better)
            search.warn(file, "low-contrast", message, component.aside, at, mend)


def contrast_of(
    project: Project, file: str, application: Application, screen: Screen, component: Component
) -> float | None:
    """The contrast of a component's letters with what is behind them; None where it has none, or
    where it is not known, as ``low_contrast`` says.
    """
    given = colours_of(component)
    if given is None:
        return None
    ink, behind = given
    best = _best(ink, behind or GROUND)
    if best is None or behind:
        return best
    if not _is_plain(project, file, application, screen):
        return None
    below = list(screen.components[: _position(screen, component)])
    above = application.always.screen if application.always is not None else None
    if screen is above:
        below += [
            one
            for state in application.states
            if state.screen is not None
            for one in state.screen.components
        ]
    return None if any(_hides(one, component) for one in below) else best


def _position(screen: Screen, component: Component) -> int:
    return next(at for at, one in enumerate(screen.components) if one is component)


def colours_of(component: Component) -> tuple[str, tuple[str, ...]] | None:
    """The colour of the letters and those behind them (none: the page's); None: nothing to say."""
    white = ("#ffffff",)
    fill = (component.fill,) if component.fill else ()
    if isinstance(component, Text) and component.text:
        size = SIZES[Text] if component.size is None else component.size
        return component.color or (INK_SOFT if size < SOFT else INK), fill
    if isinstance(component, Button) and component.text:
        known = colour(component.fill or "#ffffff")
        own = ACCENT if not fill else INK if known and luminance(known) > LIGHT else "#ffffff"
        return component.color or own, fill or white
    if isinstance(component, Input):
        return component.color or INK, fill or white
    if isinstance(component, List):
        return component.color or INK, white
    return None


def _is_plain(project: Project, file: str, application: Application, screen: Screen) -> bool:
    """Whether nothing but the page's ground is behind a screen's components.

    ``always`` lies above every state, and in a part above those of others; its background, if it
    has one, is behind every state that has none.
    """
    above = application.always.screen if application.always is not None else None
    if screen.background is not None or (above is not None and above.background is not None):
        return False
    if file in project.parts:
        around = project.flows.values()
        shared = [one.always.screen for one in around if one.always is not None]
        if any(one is not None and one.background is not None for one in shared):
            return False
    if screen is not above:
        return True
    states = application.states
    return not any(s.flow is not None or (s.screen and s.screen.background) for s in states)


def _hides(one: Component, other: Component) -> bool:
    """Whether ``one`` lies between a component above it and the page."""
    if isinstance(one, Text) and not one.fill:
        return False
    return (
        one.x < other.x + other.width
        and other.x < one.x + one.width
        and one.y < other.y + other.height
        and other.y < one.y + one.height
    )


def _best(ink: str, behind: tuple[str, ...]) -> float | None:
    """The highest contrast; None where a colour is not known."""
    letters = colour(ink)
    grounds: list[Colour] = [known for one in behind if (known := colour(one)) is not None]
    if letters is None or not grounds:
        return None
    return max(contrast(letters, ground) for ground in grounds)


def readable(behind: tuple[str, ...]) -> str:
    """The first colour that is easy to read there: the page's own, else white, else black."""
    for one in (INK, "#ffffff"):
        best = _best(one, behind)
        if best is not None and best >= CONTRAST:
            return one
    return "#000000"


def _components(application: Application) -> Iterator[tuple[Component, Place]]:
    for screen, place in screens(application):
        for component in screen.components:
            yield component, (*place, component.id)
