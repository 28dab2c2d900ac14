"""The topics that notices are sent under, and what to subscribe to (docs/protocol.md)."""

from __future__ import annotations

ECHO = b"echo:"
TRACE = b"trace\n"
END = b"end\n"
MASKED = b"masked:"
"""Begins the topic of a notice from which private values were taken."""


def change(tag: str) -> bytes:
    return b"t:%s\n" % tag.encode()


def changes(pattern: str) -> bytes:
    """What to subscribe to for a pattern of tags: all topics that can fit begin with it."""
    return change(pattern) if "*" not in pattern else b"t:" + _beginning(pattern)


def messages(pattern: str) -> bytes:
    """The same for a pattern of messages' topics."""
    pattern = one_line(pattern)
    return message(pattern) if "*" not in pattern else b"m:" + _beginning(pattern)


def _beginning(pattern: str) -> bytes:
    star = pattern.index("*")
    head = pattern[:star]
    # ``user.**`` fits ``user`` too, so the separator before it may be missing.
    return (head[:-1] if pattern[star : star + 2] == "**" else head).encode()


def authority(resource: str) -> bytes:
    return b"a:%s\n" % resource.encode()


def effect(service: str) -> bytes:
    return b"x:%s\n" % service.encode()


def asked(module: str) -> bytes:
    return b"q:%s\n" % module.encode()


def message(topic: str) -> bytes:
    return b"m:%s\n" % one_line(topic).encode()


def one_line(topic: str) -> str:
    """A message's topic as it is subscribed to: a line break would end it."""
    return " ".join(topic.split())


def masked(role: str) -> tuple[bytes, ...]:
    """Beginnings of the topics that this role hears masked, where the project has private
    values: a module needs the values of tags, a viewer does not."""
    return _MASKED.get(role, ())


_MASKED = {"viewer": (b"t:", b"m:", TRACE), "module": (TRACE,)}


def is_open(role: str, topic: bytes) -> bool:
    """Whether this role may subscribe to what begins so, where there are private values."""
    if role == "viewer":
        return topic.startswith((MASKED, b"a:", ECHO, END[:-1]))
    return not any(whole.startswith(topic) or topic.startswith(whole) for whole in masked(role))
