"""What a row of the table of kinds says."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal

from msgspec import Struct

if TYPE_CHECKING:
    from situ_studio.looks.theme import Kind as Tint

Editor = Literal[
    "text",  # one line
    "long",  # several lines
    "number",  # a number; with `unit` behind it
    "seconds",  # a number above 0
    "whole",  # a whole number
    "flag",  # yes or no
    "choice",  # one of `choices`
    "state",  # a state of this application
    "next",  # a state, #again or #back
    "event",  # an event's name
    "tag",  # a name on the blackboard
    "resource",  # a resource of the robot
    "resources",  # several, divided by spaces
    "media",  # a file of the project's media folder
    "color",  # a colour as the screen's page takes it
    "situation",  # a situation of this script
    "module",  # a declared module
    "timeout",  # seconds, next and idle in one
    "note",  # what stands beside the value for those who draw
]
List = Literal[
    "actions",
    "events",
    "components",
    "condition",
    "says",
    "params",
    "results",
    "entries",
    "requires",
    "provides",
    "words",
]


class Field(Struct, frozen=True, kw_only=True):
    """One field of a form.

    attribute: of the value. empty: what an empty field means (None, or "").
    fixed: the field cannot be left empty: an empty one goes back to what it was.
    """

    attribute: str
    label: str
    editor: Editor = "text"
    help: str = ""
    unit: str = ""
    choices: tuple[tuple[str, str], ...] = ()
    empty: Any = None
    fixed: bool = False
    placeholder: str = ""


class Section(Struct, frozen=True, kw_only=True):
    """A part of a form under a heading: a list of members, more fields in two columns, or what is
    told of a component (panels/component_sections.py).
    """

    title: str
    attribute: str = ""
    editor: List | Literal["fields", "align", "fit", "touched"] = "fields"
    hint: str = ""
    help: str = ""
    fields: tuple[Field, ...] = ()
    closed: bool = False


class Kind(Struct, frozen=True, kw_only=True):
    """One kind: how it is called, looks and is edited, and how a new one is made.

    make: gives a new value; its first argument is what names it where that must be unique
        (a state's number, a component's id, a situation's name).
    summary: what a list shows behind the kind's title, one line.
    palette: the part of the palette it stands in, "" for none.
    file: the attribute of the file that is asked for before a new one is put in, "" for none.
    """

    name: str
    value: type
    title: str
    icon: str
    tint: Tint = "state"
    help: str = ""
    fields: tuple[Field, ...] = ()
    sections: tuple[Section, ...] = ()
    make: Callable[[str], Any] = str
    summary: Callable[[Any], str] = str
    palette: Literal["", "application", "action", "screen", "drawing", "script", "modules"] = ""
    file: Literal["", "src"] = ""
