"""What the core tells whoever has subscribed to it; ``topics`` has the names of the topics."""

from __future__ import annotations

from typing import Any

from msgspec import Raw, Struct, field

from situ.blackboard.services import Carried


class Notice(Struct, frozen=True, kw_only=True, tag_field="on", tag=str.lower):
    """What is sent to all who subscribed to its topic."""


class Change(Notice, frozen=True, kw_only=True):
    """Topic ``t:TAG``. value None: deleted."""

    tag: str
    value: Any
    version: int
    writer: str
    time: int


class Authority(Notice, frozen=True, kw_only=True):
    """Topic ``a:RESOURCE``: it passed from one module (or nobody) to another."""

    resource: str
    source: str | None = field(name="from")
    to: str | None
    seq: int


class Events(Notice, frozen=True, kw_only=True):
    """Topic ``trace``: the trace events of one step."""

    events: tuple[Raw, ...]


class Message(Notice, frozen=True, kw_only=True):
    """Topic ``m:TOPIC``: an application's action ``message``."""

    topic: str
    value: Any
    application: str


class Effect(Notice, frozen=True, kw_only=True):
    """Topic ``x:SERVICE``: to be carried out. number: counts up by one for each service."""

    service: str
    number: int
    does: Carried


class Asked(Notice, frozen=True, kw_only=True):
    """Topic ``q:MODULE``: what is asked of the module has changed, so many times by now."""

    count: int


class Echo(Notice, frozen=True, kw_only=True):
    """Topic ``echo:TOKEN``, sent once when somebody subscribes to it: all that he subscribed
    to before is heard from here on."""


class End(Notice, frozen=True, kw_only=True):
    """Topic ``end``: the runtime stops."""


AnyNotice = Change | Authority | Events | Message | Effect | Asked | Echo | End
