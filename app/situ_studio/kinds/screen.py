"""The kinds of components of a screen."""

from __future__ import annotations

from typing import Any

from situ.document import rbd
from situ_studio.kinds.kind import Field, Kind, Section
from situ_studio.wording.language import tr

_ID = Field(
    attribute="id",
    label="Id",
    help="Its name in traces and scenarios; unique on the screen.",
    fixed=True,
)
_SENDS = Field(
    attribute="event", label="Sends", editor="event", help="The event that a touch raises."
)
_PLACE = Section(
    title="Place and size",
    help="In percent of the screen.",
    fields=(
        Field(
            attribute="x",
            label="X",
            editor="number",
            unit="%",
            help="How far from the left.",
            fixed=True,
        ),
        Field(
            attribute="y",
            label="Y",
            editor="number",
            unit="%",
            help="How far from the top.",
            fixed=True,
        ),
        Field(
            attribute="width",
            label="W",
            editor="number",
            unit="%",
            help="How wide it is.",
            fixed=True,
        ),
        Field(
            attribute="height",
            label="H",
            editor="number",
            unit="%",
            help="How high it is.",
            fixed=True,
        ),
    ),
)
_ALIGN = Section(
    title="Align",
    editor="align",
    hint="on the screen",
    help="Puts it to an edge or into the middle.",
)
_FIT = Section(
    title="Fit for touch and sight",
    editor="fit",
    hint="at 10 inches",
    help="What old fingers and eyes need, on a screen of 10 inches.",
)
_TOUCHED = Section(
    title="When touched", editor="touched", help="The event that it raises, and where that leads."
)
_ENDED = Section(
    title="When done", editor="touched", help="The event at its end, and where that leads."
)
_LOOKS = Section(
    title="Looks",
    help="Size and colours; by itself they fit the screen.",
    fields=(
        Field(
            attribute="size",
            label="Text size",
            editor="number",
            unit="%",
            help="The text's height in percent of the screen's.",
            placeholder="by itself",
        ),
        Field(
            attribute="align",
            label="Align",
            editor="choice",
            help="At which side of its place the text stands.",
            choices=(("", "by itself"), ("left", "left"), ("center", "centre"), ("right", "right")),
        ),
        Field(
            attribute="color",
            label="Colour",
            editor="color",
            help="Of its letters.",
            placeholder="by itself",
        ),
        Field(
            attribute="fill",
            label="Fill",
            editor="color",
            help="Of the ground behind it.",
            placeholder="by itself",
        ),
    ),
)
_FILE = Field(
    attribute="src",
    label="File",
    editor="media",
    help="Of the project's media folder.",
    empty="",
)
_SHOWN = Field(
    attribute="text",
    label="Text",
    editor="long",
    help="{tag} stands for a value on the blackboard and follows its changes.",
    empty="",
)


def event_of(id: str) -> str:
    """The event that the touch of a new button raises."""
    return f"click{id[:1].upper()}{id[1:]}"


def _box(x: float, y: float, width: float, height: float) -> dict[str, Any]:
    return {"x": x, "y": y, "width": width, "height": height}


TEXT = Kind(
    name="text",
    value=rbd.Text,
    title="Text",
    icon="text",
    help="Words on the screen.",
    fields=(_SHOWN, _ID),
    sections=(_PLACE, _ALIGN, _FIT, _LOOKS),
    make=lambda name: rbd.Text(id=name, text=tr("Text"), size=8, **_box(10, 10, 80, 20)),
    summary=lambda v: str(v.text),
    palette="screen",
)
BUTTON = Kind(
    name="button",
    value=rbd.Button,
    title="Button",
    icon="button",
    help="Is touched, and raises an event.",
    fields=(
        Field(attribute="text", label="Text", help="What stands on it.", empty=""),
        _ID,
        _SENDS,
        Field(
            attribute="tag",
            label="Sets",
            editor="tag",
            help="A tag that a touch sets, if any.",
            placeholder="nothing",
        ),
        Field(attribute="value", label="Value", help="The value that the tag gets."),
    ),
    sections=(_PLACE, _ALIGN, _FIT, _TOUCHED, _LOOKS),
    make=lambda name: rbd.Button(id=name, text="OK", event=event_of(name), **_box(35, 75, 30, 15)),
    summary=lambda v: f"{v.text} → {v.event}" if v.event else str(v.text),
    palette="screen",
)
IMAGE = Kind(
    name="image",
    value=rbd.Image,
    title="Image",
    icon="image",
    help="A picture of the media folder.",
    fields=(_FILE, _ID),
    sections=(_PLACE, _ALIGN, _LOOKS),
    make=lambda name: rbd.Image(id=name, src="picture.png", **_box(60, 30, 30, 40)),
    summary=lambda v: str(v.src),
    palette="screen",
    file="src",
)
MOVIE = Kind(
    name="movie",
    value=rbd.Movie,
    title="Movie",
    icon="movie",
    help="A film of the media folder, played once.",
    fields=(
        _FILE,
        _ID,
        Field(
            attribute="done",
            label="When done",
            editor="event",
            help="The event that is raised at its end.",
        ),
        Field(
            attribute="failed",
            label="If it fails",
            editor="event",
            help="The event that is raised where the robot can not play it.",
        ),
    ),
    sections=(_PLACE, _ALIGN, _ENDED, _LOOKS),
    make=lambda name: rbd.Movie(id=name, src="movie.webm", **_box(10, 30, 45, 40)),
    summary=lambda v: str(v.src),
    palette="screen",
    file="src",
)
INPUT = Kind(
    name="input",
    value=rbd.Input,
    title="Input",
    icon="input",
    help="A field that people type into; what they type goes to a tag.",
    fields=(
        Field(
            attribute="tag",
            label="Writes to",
            editor="tag",
            help="The tag that gets what is typed.",
            fixed=True,
        ),
        _ID,
        Field(
            attribute="kind",
            label="What",
            editor="choice",
            help="Which keys the robot offers.",
            choices=(
                ("text", "text"),
                ("number", "a number"),
                ("date", "a date"),
                ("pin", "a PIN"),
            ),
            fixed=True,
        ),
        Field(
            attribute="max",
            label="Longest",
            editor="whole",
            help="More is not taken.",
            unit="characters",
        ),
        Field(
            attribute="event",
            label="Sends",
            editor="event",
            help="The event at Enter, or when it is full.",
        ),
    ),
    sections=(_PLACE, _ALIGN, _FIT, _TOUCHED, _LOOKS),
    make=lambda name: rbd.Input(id=name, tag="user.input", **_box(10, 50, 40, 12)),
    summary=lambda v: f"→ {v.tag}",
    palette="screen",
)
LIST = Kind(
    name="list",
    value=rbd.List,
    title="List",
    icon="list",
    help="The entries of a list on the blackboard, to choose one.",
    fields=(
        Field(
            attribute="items",
            label="Shows",
            editor="tag",
            help="The tag at which the list stands.",
            fixed=True,
        ),
        Field(
            attribute="label",
            label="Each as",
            help="How an entry is shown: {item.name}, room {item.room}",
            empty="{item}",
        ),
        _ID,
        Field(
            attribute="tag", label="Choice to", editor="tag", help="The tag that gets the entry."
        ),
        Field(
            attribute="event", label="Sends", editor="event", help="The event that a choice raises."
        ),
    ),
    sections=(_PLACE, _ALIGN, _FIT, _TOUCHED, _LOOKS),
    make=lambda name: rbd.List(id=name, items="entries", **_box(10, 30, 80, 40)),
    summary=lambda v: f"{v.items} → {v.tag}" if v.tag else str(v.items),
    palette="screen",
)
COMPONENTS = (TEXT, BUTTON, IMAGE, MOVIE, INPUT, LIST)
