"""The care lint ``small-text`` beside the page: letters are never larger than it takes them."""

from __future__ import annotations

from typing import Any

import pytest

from situ.document.analysis_search import Search
from situ.document.care_screen import SIZE, largest
from situ.document.project import Project
from situ.document.rbd import Button, Text

pytestmark = pytest.mark.chromium

TEXTS = (
    "Your nurse comes at eight to help you into the bath, and at nine there is tea in the garden.",
    "little ill till fill jiffy " * 4,
    "MEASURE BLOOD OXYGEN NOW, PLEASE. " * 3,
    "今日は良い天気ですね。庭でお茶を飲みましょう。" * 3,
    "Zimmer 0123456789, Größe: éàîï – (1/2) [ja] 'nein' " * 2,
    "Tea",
)
KIOSK_HEIGHT = 800
SIZES = """() => Object.fromEntries(
    [...document.querySelectorAll(".component")].map((one) =>
        [one.dataset.id, [parseFloat(getComputedStyle(one).fontSize), Boolean(one.dataset.cut)]]))
"""
BOXES = ((20, 8), (30, 12), (8, 30), (60, 5), (40, 10), (25, 16))


@pytest.mark.parametrize("kind", [Text, Button])
def test_what_fits_is_never_larger_on_the_page_than_the_lint_says(
    play: Any, kind: type[Text] | type[Button]
) -> None:
    search = Search(Project(root="nowhere", name="p"))
    made = [
        kind(id=f"c{number}", x=0.0, y=0.0, width=float(w), height=float(h), text=words.strip())
        for number, (words, (w, h)) in enumerate((t, b) for t in TEXTS for b in BOXES)
    ]

    async def scenario(stage: Any) -> None:
        fields = ("id", "x", "y", "width", "height", "text")
        plain = {"type": kind.element, "event": "e"}
        stage.show(*(plain | {name: getattr(one, name) for name in fields} for one in made))
        await stage.component(made[-1].id).wait_for()
        # Letters are laid out anew once their font has come.
        await stage.page.evaluate("document.fonts.ready")
        sizes = await stage.page.evaluate(SIZES)
        told = 0
        for one in made:
            pixels, is_cut = sizes[one.id]
            most, _ = largest(search.project, one)
            # What fits at no size is shown in part, in the smallest letters that there are.
            assert is_cut or pixels / (KIOSK_HEIGHT / 100) <= most + 0.05, one
            told += most < SIZE and not is_cut
        assert told > 3

    play(scenario)
