"""The sections of a project's form, as *Find anything* offers them."""

from __future__ import annotations

from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr


def sections() -> tuple[tuple[Place, str, str], ...]:
    """Of each its place in ``situ.toml``, its title, and other words that lead to it."""
    return (
        (("project", "name"), tr("Project"), tr("name, folders of media and scenarios")),
        (("project", "applications"), tr("Applications"), tr("new, order, add, remove")),
        (("project", "languages"), tr("Languages"), tr("translate")),
        (("readings",), tr("How words are said"), tr("readings, pronounce, voice")),
        (("robot",), tr("Robot"), tr("address, adapter")),
        (("tags",), tr("Values at the start"), tr("data, tags, blackboard")),
        (("setting",), tr("Settings for those who use the robot"), tr("end users, form")),
        (("durable",), tr("Kept when the robot restarts"), tr("durable, stored")),
        (("privacy",), tr("Private"), tr("personal data, hidden, operators")),
        (("places",), tr("Places"), tr("map, positions")),
        (("mqtt",), tr("Messages from outside"), tr("MQTT, broker, sensors, call buttons")),
    )
