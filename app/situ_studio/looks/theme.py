"""The looks: every colour and measure of the design tokens, light and dark, and the typeface.

All lengths are device-independent px; every text colour reaches a contrast of
4.5 : 1 on the surfaces that it stands on, in both themes.
"""

from __future__ import annotations

from typing import Literal

from msgspec import Struct
from PySide6.QtGui import QColor, QFont, QFontDatabase

from situ.resources import resource
from situ_studio.looks.letters import factor

Kind = Literal["state", "start", "part", "data", "condition", "situation", "module", "resource"]
KINDS: tuple[Kind, ...] = (
    "state",
    "start",
    "part",
    "data",
    "condition",
    "situation",
    "module",
    "resource",
)


class Theme(Struct, frozen=True, kw_only=True):
    """Colours as ``#RRGGBB`` (``#AARRGGBB`` for ``shadow``), as QColor and style sheets take them.

    A kind's colour is named after the kind, its soft surface ``<kind>_soft``.
    """

    name: Literal["light", "dark"]
    title: str
    window: str
    panel: str
    card: str
    canvas: str
    dots: str
    field: str
    row_alt: str
    hover: str
    line: str
    line_strong: str
    card_border: str
    pipe: str
    guides: str
    shadow: str
    text: str
    text2: str
    text3: str
    accent: str
    accent_over: str
    on_accent: str
    accent_soft: str
    accent_line: str
    error: str
    error_soft: str
    warning: str
    warning_soft: str
    live: str
    live_soft: str
    state: str
    state_soft: str
    start: str
    start_soft: str
    part: str
    part_soft: str
    data: str
    data_soft: str
    condition: str
    condition_soft: str
    situation: str
    situation_soft: str
    module: str
    module_soft: str
    resource: str
    resource_soft: str

    def color(self, token: str) -> QColor:
        """The colour of a token's name; AttributeError for a name that is none."""
        return QColor(str(getattr(self, token)))

    def kind(self, kind: Kind) -> QColor:
        """A kind's colour: its icon, strip and number."""
        return self.color(kind)

    def kind_soft(self, kind: Kind) -> QColor:
        """A kind's soft surface: the strip of a script node, the header of start and part."""
        return self.color(f"{kind}_soft")


LIGHT = Theme(
    name="light",
    title="#E9EBEF",
    window="#F4F5F7",
    panel="#FFFFFF",
    card="#FFFFFF",
    canvas="#F0F2F5",
    dots="#D3D8E0",
    field="#F5F6F8",
    row_alt="#FAFBFC",
    hover="#EEF1F5",
    line="#E2E5EA",
    line_strong="#C6CCD6",
    card_border="#CDD3DC",
    pipe="#7F8A9C",
    guides="#C2255C",
    shadow="#12141C2D",
    text="#1A1F29",
    text2="#4A5364",
    text3="#5F6878",
    accent="#2D5BD0",
    accent_over="#244BB0",
    on_accent="#FFFFFF",
    accent_soft="#E7EEFC",
    accent_line="#B5C8F5",
    error="#B3261E",
    error_soft="#FCEBE9",
    warning="#855000",
    warning_soft="#FDF3DC",
    live="#0B7A4B",
    live_soft="#E2F4EA",
    state="#46536A",
    state_soft="#EDF0F4",
    start="#0B7A4B",
    start_soft="#E2F4EA",
    part="#5D4BB0",
    part_soft="#EEEBFA",
    data="#086D9C",
    data_soft="#E3F1F8",
    condition="#8A5F00",
    condition_soft="#FAF0DA",
    situation="#8A2178",
    situation_soft="#F8E9F5",
    module="#0A5A4C",
    module_soft="#DFF3EF",
    resource="#7C2D0C",
    resource_soft="#FBE9DF",
)

DARK = Theme(
    name="dark",
    title="#0E1115",
    window="#16191F",
    panel="#1B1F27",
    card="#20252E",
    canvas="#111419",
    dots="#262C37",
    field="#13161C",
    row_alt="#1E222A",
    hover="#252B35",
    line="#2A303B",
    line_strong="#414A5A",
    card_border="#39414F",
    pipe="#5E697B",
    guides="#FF7AA8",
    shadow="#59000000",
    text="#E9ECF2",
    text2="#B1B9C7",
    text3="#919BAC",
    accent="#82A6FF",
    accent_over="#A3BEFF",
    on_accent="#0D1424",
    accent_soft="#1F2B49",
    accent_line="#3B5596",
    error="#FF8F85",
    error_soft="#3A1E1F",
    warning="#F2B84B",
    warning_soft="#372A12",
    live="#4ADE9C",
    live_soft="#143327",
    state="#A9B4C8",
    state_soft="#252B36",
    start="#4ADE9C",
    start_soft="#143327",
    part="#B7AAFF",
    part_soft="#2A2645",
    data="#8CD3F5",
    data_soft="#15303D",
    condition="#F0CB7C",
    condition_soft="#352A14",
    situation="#E07FD2",
    situation_soft="#3A2038",
    module="#45BFA0",
    module_soft="#143530",
    resource="#F58C5E",
    resource_soft="#3D2417",
)

FAMILY = "Inter"
FAMILIES = [FAMILY, "Noto Sans CJK JP", "Noto Sans", "sans-serif"]
"""The bundled typeface, then the bundled one that has Japanese."""
FONT_FILES = (
    "Inter-Regular.otf",
    "Inter-Medium.otf",
    "Inter-SemiBold.otf",
    "NotoSansCJKjp-Regular.otf",
    "NotoSansCJKjp-Bold.otf",
)

CAPTION, LABEL, FORM, BODY, SECTION, PAGE, WELCOME = 11.0, 12.0, 12.5, 13.0, 15.0, 20.0, 28.0
"""Type sizes in px."""


def load_fonts() -> None:
    """Makes the bundled typefaces known to Qt; needs a QGuiApplication. Once is enough."""
    for file in FONT_FILES:
        QFontDatabase.addApplicationFont(str(resource("fonts", file)))


def font(size: float = BODY, weight: int = 400) -> QFont:
    """Inter at ``size`` px of the design, as large as the letters of the windows are now."""
    return face(size * factor(), weight)


def face(size: float = BODY, weight: int = 400) -> QFont:
    """Inter at ``size`` px with tabular figures; weights 400, 500 and 600 are bundled."""
    made = QFont()
    made.setFamilies(FAMILIES)
    # Qt's font engines take whole px only; the tokens' halves go up.
    made.setPixelSize(int(size + 0.5))
    made.setWeight(QFont.Weight(weight))
    made.setFeature(QFont.Tag("tnum"), 1)
    made.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    return made
