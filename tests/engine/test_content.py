"""What the screen shows of what it is commanded, and which touches still count."""

from __future__ import annotations

import logging
from typing import Any

from situ.engine.screen.content import Content, content

LOG = logging.getLogger("test")
PLACE = {"x": 1, "y": 2.5, "width": 30, "height": 10}


def shown(
    *components: Any, before: Content | None = None, actions: tuple[int, ...] = ()
) -> Content:
    value = {"components": list(components), "background": None}
    return content(value, actions, before or Content(), LOG)


def button(name: str = "yes", **more: Any) -> dict[str, Any]:
    return {"type": "button", "id": name, **PLACE, "event": "click", "text": "YES"} | more


def test_null_and_nonsense_show_the_idle_face() -> None:
    nonsense: list[Any] = [None, 3, "x", [], {}, {"components": {}}]
    for value in nonsense:
        assert content(value, (), Content(), LOG).page() is None


def test_what_can_not_be_shown_is_left_out_and_the_rest_is_shown() -> None:
    made = shown(
        button("a"),
        button("a"),
        {"type": "window", "id": "b", **PLACE},
        {"type": "text", "id": "c", **PLACE, "x": "left"},
        {"type": "text", "id": "d", **PLACE, "y": float("nan")},
        {"type": "text", **PLACE},
        "text",
        {"type": "text", "id": "e", **PLACE, "text": 3.0, "align": "up", "size": -1, "fill": 7},
    )
    page = made.page()
    assert page is not None
    assert [one["id"] for one in page["components"]] == ["a", "e"]
    said = {"parts": (("3",),)}
    assert page["components"][1] == {"id": "e", "type": "text", **PLACE, **said}


def test_sources_become_addresses_of_the_media() -> None:
    picture = {"type": "image", "id": "p", **PLACE, "src": "a b/ü.png"}
    stream = {"type": "image", "id": "q", **PLACE, "src": "HTTP://camera/1"}
    first, second = (one.page["src"] for one in shown(picture, stream).components or ())
    assert first == "/media/a%20b/%C3%BC.png"
    assert second == "HTTP://camera/1"


def test_a_component_keeps_its_meaning_while_only_its_looks_change() -> None:
    first = shown(button())
    moved = shown(button(x=50, text="JA", fill="red"), before=first)
    other = shown(button(event="clickOther"), before=moved)
    assert [c.component("yes").since for c in (first, moved, other)] == [1, 1, 3]  # type: ignore[union-attr]
    assert [c.since for c in (first, moved, other)] == [1, 1, 1]
    assert shown(button(), button("no"), before=other).since == 4


def test_a_list_means_something_else_when_its_items_change() -> None:
    names = {"type": "list", "id": "l", **PLACE, "items": [{"label": "Ann", "value": {"n": 1}}]}
    first = shown(names)
    second = shown(names | {"items": [{"label": "Ann", "value": {"n": 2}}]}, before=first)
    found = second.component("l")
    assert found is not None
    assert (found.since, found.items) == (2, ({"n": 2},))


def test_movies_get_their_actions_in_order_and_none_when_they_have_ended() -> None:
    movies = [{"type": "movie", "id": name, **PLACE, "src": "m.webm"} for name in "ab"]

    def actions(made: Content) -> list[int | None]:
        return [one.page.get("action") for one in made.components or ()]

    first = shown(*movies, actions=(4, 5))
    assert actions(first) == [4, 5]
    # A live text changed after the first had ended.
    assert actions(shown(*movies, before=first, actions=(0, 5))) == [None, 5]
    assert actions(shown(*movies, before=first, actions=(8, 9))) == [8, 9]
