"""How the bundled adapters tell where a robot is; when they do is in their own tests."""

from __future__ import annotations

from typing import Any

from situ.engine.robots.reports import Reports


def test_a_place_is_told_to_the_hundredth_and_a_zero_has_no_sign() -> None:
    told: list[dict[str, Any]] = []
    Reports(told.append).tell({"pose.x": 1.234, "pose.y": -0.001})
    assert repr(told) == "[{'pose.x': 1.23, 'pose.y': 0.0}]"
