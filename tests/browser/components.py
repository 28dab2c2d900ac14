"""Components of a screen, as the robot tells its page of them."""

from __future__ import annotations

from typing import Any


def component(
    kind: str, name: str, x: float, y: float, width: float, height: float, **more: Any
) -> dict[str, Any]:
    return {"type": kind, "id": name, "x": x, "y": y, "width": width, "height": height} | more


def button(name: str = "yes", text: str = "YES", x: float = 8, **more: Any) -> dict[str, Any]:
    return component("button", name, x, 68, 38, 22, text=text, event=f"click-{name}") | more


def text(words: str, name: str = "hello", **more: Any) -> dict[str, Any]:
    return component("text", name, 8, 10, 60, 20, text=words, size=9) | more


def field(name: str = "name", **more: Any) -> dict[str, Any]:
    given = {"tag": f"user.{name}", "kind": "text", "value": None}
    return component("input", name, 10, 40, 50, 16) | given | more


def names(*labels: str, **more: Any) -> dict[str, Any]:
    items = [{"label": label, "value": {"name": label}} for label in labels]
    return component("list", "names", 10, 30, 80, 40, items=items, event="chosen") | more
