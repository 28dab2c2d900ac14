"""What the screen shows, made from the value at ``robot/screen``.

Any module may hold the screen and command any JSON value: what can not be shown is
left out and said in the log, what can be is brought into the shape that the page
expects. The same place decides which touches still count.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Iterable, Sequence
from typing import Any

from msgspec import Struct

from situ.document.phrases import parts
from situ.engine.media import MediaFolder

TYPES = ("text", "button", "image", "movie", "input", "list")
KINDS = ("text", "number", "date", "pin")
ALIGNS = ("left", "center", "right")
MOST = 200
"""Components of one screen; a list shows as many items at most five times over."""


class Shown(Struct, frozen=True):
    """A component on the screen.

    since: the revision of the content from which on a touch of it means what it
    means now. page: what is sent to the page. items: the values of a list's items.
    """

    id: str
    type: str
    since: int
    page: dict[str, Any]
    items: tuple[Any, ...] = ()
    tag: str | None = None


class Content(Struct, frozen=True):
    """All that is on the screen; ``components`` None: nobody holds the screen.

    since: the revision from which on the same components have been there.
    """

    revision: int = 0
    since: int = 0
    background: str | None = None
    components: tuple[Shown, ...] | None = None

    def component(self, name: str) -> Shown | None:
        return next((c for c in self.components or () if c.id == name), None)

    def page(self) -> dict[str, Any] | None:
        """The part of the message to the page: None for the idle face."""
        if self.components is None:
            return None
        return {"background": self.background, "components": [c.page for c in self.components]}


def content(value: Any, actions: Sequence[int], before: Content, log: logging.Logger) -> Content:
    """The content for a value of ``robot/screen``; ``actions`` are its movies' ids, in order,
    0 for one that has ended.
    """
    revision = before.revision + 1
    if value is None:
        return Content(revision, revision)
    listed = value.get("components") if isinstance(value, dict) else None
    if not isinstance(listed, list):
        log.warning("the screen was commanded %.80r, which has no list of components", value)
        return Content(revision, revision)
    background = value.get("background")
    shown: dict[str, Shown] = {}
    for raw in listed[:MOST]:
        component = _component(raw, shown, log)
        if component is not None:
            was = before.component(component.id)
            same = was is not None and _meaning(was) == _meaning(component)
            since = was.since if was is not None and same else revision
            shown[component.id] = Shown(
                component.id,
                component.type,
                since,
                component.page,
                component.items,
                component.tag,
            )
    _number_movies(shown.values(), actions)
    kept = [(c.id, c.type) for c in before.components or ()]
    return Content(
        revision,
        before.since if kept == [(c.id, c.type) for c in shown.values()] else revision,
        MediaFolder.address(background) if isinstance(background, str) and background else None,
        tuple(shown.values()),
    )


def _number_movies(shown: Iterable[Shown], actions: Sequence[int]) -> None:
    """Gives the movies their actions, in order; one that has ended (0) has none."""
    movies = (one for one in shown if one.type == "movie")
    for movie, action in zip(movies, actions, strict=False):
        if action:
            movie.page["action"] = action


def _meaning(shown: Shown) -> tuple[Any, ...]:
    """What a touch of the component says; its place and look do not count."""
    page = shown.page
    return shown.type, page.get("event"), shown.tag, page.get("kind"), shown.items


def _component(raw: Any, shown: dict[str, Shown], log: logging.Logger) -> Shown | None:
    kind = raw.get("type") if isinstance(raw, dict) else None
    name = raw.get("id") if isinstance(raw, dict) else None
    if kind not in TYPES or not isinstance(name, str) or name in shown:
        log.warning("not shown: %.80r needs one of the six types and an id of its own", raw)
        return None
    assert isinstance(raw, dict)
    place = {side: _percent(raw.get(side)) for side in ("x", "y", "width", "height")}
    if None in place.values():
        log.warning("not shown: %s needs x, y, width and height in percent", name)
        return None
    page: dict[str, Any] = {"id": name, "type": kind, **place}
    if (size := _percent(raw.get("size"))) is not None and size > 0:
        page["size"] = min(size, 100.0)
    if raw.get("align") in ALIGNS:
        page["align"] = raw["align"]
    page.update((k, raw[k]) for k in ("color", "fill", "event") if isinstance(raw.get(k), str))
    if kind in ("text", "button"):
        page["parts"] = parts(_text(raw.get("text")))
    elif kind in ("image", "movie"):
        page["src"] = MediaFolder.address(_text(raw.get("src")))
    elif kind == "input":
        page["kind"] = raw["kind"] if raw.get("kind") in KINDS else "text"
        page["value"] = _text(raw.get("value"))
        most = raw.get("max")
        if isinstance(most, int) and not isinstance(most, bool) and most > 0:
            page["max"] = most
    items: tuple[Any, ...] = ()
    if kind == "list":
        entries = raw.get("items")
        listed = entries[: MOST * 5] if isinstance(entries, list) else []
        pairs = [e if isinstance(e, dict) else {"label": e, "value": e} for e in listed]
        page["items"] = [parts(_text(p.get("label"))) for p in pairs]
        items = tuple(p.get("value") for p in pairs)
    tag = raw.get("tag")
    if isinstance(tag, str) and kind in ("input", "list"):
        page["tag"] = tag
    return Shown(name, kind, 0, page, items, tag if isinstance(tag, str) and tag else None)


def _percent(value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return None
    return float(value)


def _text(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value)
