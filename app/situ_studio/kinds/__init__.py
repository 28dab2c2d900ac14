"""Every kind of thing that a designer edits, with its fields: one row a kind.

Palette, inspector, outline and insert menus are made from this table, so a new
action kind is one row here (and its value in ``situ.document.rbd``). Texts are
shown through ``QCoreApplication.translate("kinds", …)``.
"""

from __future__ import annotations

from typing import Any

from situ.document import rbd
from situ_studio.kinds.actions import (
    ACTIONS,
    ADD,
    APPEND,
    CLEAR,
    EVENT_ACTIONS,
    LAUNCH,
    MESSAGE,
    REPEAT,
    ROBOT,
    SERVICE,
    SET,
    SOUND,
    SPEECH,
    STATE_ACTIONS,
    TAKE,
)
from situ_studio.kinds.application import (
    ALWAYS,
    APPLICATION,
    EVENT,
    FRAME,
    NOTE,
    PART,
    SCREEN,
    STATE,
    TIMEOUT,
)
from situ_studio.kinds.kind import (
    Field,
    Kind,
    Section,
)
from situ_studio.kinds.said import (
    GROUPS,
    TESTS,
    TYPES,
    type_words,
)
from situ_studio.kinds.screen import (
    BUTTON,
    COMPONENTS,
    IMAGE,
    INPUT,
    LIST,
    MOVIE,
    TEXT,
)
from situ_studio.kinds.script import (
    CONDITION,
    DATA,
    ENTRY,
    INFORMATION,
    MODULE,
    MODULES,
    SCRIPT,
    SITUATION,
)

KINDS: tuple[Kind, ...] = (
    APPLICATION,
    STATE,
    PART,
    EVENT,
    TIMEOUT,
    ALWAYS,
    SCREEN,
    *ACTIONS,
    *COMPONENTS,
    NOTE,
    FRAME,
    SCRIPT,
    SITUATION,
    ENTRY,
    MODULE,
    DATA,
    CONDITION,
    MODULES,
    INFORMATION,
)
_BY_VALUE = {k.value: k for k in KINDS if k is not PART}
_BY_NAME = {k.name: k for k in KINDS}

MIME = "application/x-situ-kind"
"""What a drag from the palette carries: a kind's name as UTF-8."""
MODULE_MIME = "application/x-situ-module"
"""What a drag from the list of modules carries: a module's name as UTF-8."""


def kind_of(value: Any) -> Kind | None:
    """The kind of a value; None for what has no form of its own."""
    if isinstance(value, rbd.State) and value.flow is not None:
        return PART
    return _BY_VALUE.get(type(value))


def kind(name: str) -> Kind:
    """The kind of that name; KeyError where there is none."""
    return _BY_NAME[name]


__all__ = [
    "ACTIONS",
    "ADD",
    "ALWAYS",
    "APPEND",
    "APPLICATION",
    "BUTTON",
    "CLEAR",
    "COMPONENTS",
    "CONDITION",
    "DATA",
    "ENTRY",
    "EVENT",
    "EVENT_ACTIONS",
    "FRAME",
    "GROUPS",
    "IMAGE",
    "INFORMATION",
    "INPUT",
    "KINDS",
    "LAUNCH",
    "LIST",
    "MESSAGE",
    "MIME",
    "MODULE",
    "MODULES",
    "MODULE_MIME",
    "MOVIE",
    "NOTE",
    "PART",
    "REPEAT",
    "ROBOT",
    "SCREEN",
    "SCRIPT",
    "SERVICE",
    "SET",
    "SITUATION",
    "SOUND",
    "SPEECH",
    "STATE",
    "STATE_ACTIONS",
    "TAKE",
    "TESTS",
    "TEXT",
    "TIMEOUT",
    "TYPES",
    "Field",
    "Kind",
    "Section",
    "kind",
    "kind_of",
    "type_words",
]
