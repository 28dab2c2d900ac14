"""Messages: published on the blackboard for whoever watches; they end at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

Publish = Callable[[str, Any], None]
"""``publish(topic, value)``; the driver brings it."""


def send(publish: Publish, fields: dict[str, Any]) -> None:
    """Publishes a message's ``value`` under its ``topic``."""
    publish(str(fields.get("topic", "")), fields.get("value"))
