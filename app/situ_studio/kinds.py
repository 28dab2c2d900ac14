"""Every kind of thing that a designer edits, with its fields: one row a kind.

Palette, inspector, outline and insert menus are made from this table, so a new
action kind is one row here (and its value in ``situ.document.rbd``). Texts are
shown through ``QCoreApplication.translate("kinds", …)``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from msgspec import Struct

from situ.document import modules, rbd, spds
from situ.document.condition import Group, Test
from situ_studio.theme import Kind as Tint

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
    """A part of a form under a heading: a list of members, or more fields in two columns."""

    title: str
    attribute: str = ""
    editor: List | Literal["fields"] = "fields"
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
    palette: Literal["", "application", "action", "screen", "script", "modules"] = ""


TESTS: tuple[tuple[str, str], ...] = (
    ("is", "is"),
    ("isnot", "is not"),
    ("above", "above"),
    ("below", "below"),
    ("atleast", "at least"),
    ("atmost", "at most"),
    ("in", "is one of"),
    ("exists", "exists"),
)
GROUPS: tuple[tuple[str, str], ...] = (
    ("all", "all of these"),
    ("any", "any of these"),
    ("none", "none of these"),
)


def _params(value: Any) -> str:
    return ", ".join(f"{p.name} {p.text}" for p in value.params)


# -- actions -----------------------------------------------------------------

_WAIT = Field(
    attribute="wait",
    label="Wait for it",
    editor="flag",
    help="The actions after this one start when it has ended, well or badly.",
)
_DONE = Field(
    attribute="done",
    label="When done",
    editor="event",
    help="The event that is raised when it has ended well.",
)
_FAILED = Field(
    attribute="failed",
    label="If it fails",
    editor="event",
    help="The event that is raised when it has ended badly.",
)
_OPTIONAL = Field(
    attribute="optional",
    label="Optional",
    editor="flag",
    help="The state goes on without it where its resource is taken by another module.",
)
_KEEP = Field(
    attribute="keep",
    label="Keep running",
    editor="flag",
    help="It runs on when the state is left.",
)
_ENDING = Section(title="Ending", fields=(_WAIT, _DONE, _FAILED))
_PARAMS = Section(
    title="Values sent",
    attribute="params",
    editor="params",
    help="Name and value of each; {tag} stands for a value on the blackboard.",
)
_TAG = Field(
    attribute="tag",
    label="Tag",
    editor="tag",
    help="Where the value stands on the blackboard, such as user.name.",
    fixed=True,
)
_VALUE = Field(
    attribute="text",
    label="Value",
    help="Text, a number, true or false, a list as JSON; {tag} stands for a value.",
    empty="",
)

SPEECH = Kind(
    name="speech",
    value=rbd.Speech,
    title="Speech",
    icon="speech",
    help="The robot says something.",
    fields=(
        Field(
            attribute="text",
            label="Says",
            editor="long",
            help="{tag} stands for a value on the blackboard: Hello {user.name}",
            empty="",
        ),
        Field(
            attribute="lang",
            label="Language",
            help="Such as en or ja; empty: the language that the tag language names.",
            placeholder="as set",
        ),
        Field(
            attribute="bargein",
            label="May be cut in",
            editor="flag",
            help="People may answer while the robot still speaks.",
        ),
        _OPTIONAL,
    ),
    sections=(_ENDING,),
    make=lambda _: rbd.Speech(text="Hello"),
    summary=lambda v: str(v.text),
    palette="action",
)
ROBOT = Kind(
    name="robot",
    value=rbd.Robot,
    title="Robot",
    icon="robot",
    help="The robot moves: one of its resources gets a command.",
    fields=(
        Field(
            attribute="resource",
            label="Resource",
            editor="resource",
            help="What moves: base, head …",
            fixed=True,
        ),
        Field(
            attribute="command",
            label="Command",
            help="What the robot's adapter knows, such as goto.",
            fixed=True,
        ),
        _OPTIONAL,
    ),
    sections=(_PARAMS, _ENDING),
    make=lambda _: rbd.Robot(resource="base", command="goto"),
    summary=lambda v: f"{v.resource} {v.command} {_params(v)}".strip(),
    palette="action",
)
SERVICE = Kind(
    name="service",
    value=rbd.Service,
    title="Service",
    icon="service",
    help="Asks a web service, a module or a file, and keeps the answer.",
    fields=(
        Field(attribute="name", label="Name", help="How traces and results call it.", fixed=True),
        Field(
            attribute="url",
            label="Address",
            help="http://…, board:module/request, or media:file.json",
            fixed=True,
        ),
        Field(
            attribute="method",
            label="Method",
            editor="choice",
            choices=tuple((m, m) for m in ("GET", "POST", "PUT", "PATCH", "DELETE")),
            fixed=True,
        ),
        _KEEP,
    ),
    sections=(
        _PARAMS,
        Section(
            title="Results",
            attribute="results",
            editor="results",
            help="Which part of the answer goes to which tag.",
        ),
        _ENDING,
    ),
    make=lambda _: rbd.Service(name="ask", url="http://127.0.0.1:8080/ask"),
    summary=lambda v: str(v.name),
    palette="action",
)
MESSAGE = Kind(
    name="message",
    value=rbd.Message,
    title="Message",
    icon="message",
    help="Sends a message to whoever listens to its topic.",
    fields=(
        Field(attribute="topic", label="Topic", help="Such as nurse/call.", fixed=True),
        Field(attribute="text", label="Text", help="Sent where there are no values.", empty=""),
    ),
    sections=(_PARAMS, _ENDING),
    make=lambda _: rbd.Message(topic="nurse/call"),
    summary=lambda v: f"{v.topic} {v.text or _params(v)}".strip(),
    palette="action",
)
LAUNCH = Kind(
    name="launch",
    value=rbd.Launch,
    title="Launch",
    icon="launch",
    help="Starts a program that the robot allows.",
    fields=(
        Field(attribute="program", label="Program", help="Its name on the robot.", fixed=True),
        _KEEP,
    ),
    sections=(_PARAMS, _ENDING),
    make=lambda _: rbd.Launch(program="brain-game"),
    summary=lambda v: f"{v.program} {_params(v)}".strip(),
    palette="action",
)
SOUND = Kind(
    name="sound",
    value=rbd.Sound,
    title="Sound",
    icon="sound",
    help="Plays a sound of the media folder.",
    fields=(
        Field(attribute="src", label="File", editor="media", fixed=True),
        _OPTIONAL,
    ),
    sections=(_ENDING,),
    make=lambda _: rbd.Sound(src="chime.ogg"),
    summary=lambda v: str(v.src),
    palette="action",
)
SET = Kind(
    name="set",
    value=rbd.Set,
    title="Set value",
    icon="set",
    help="Writes a value on the blackboard.",
    fields=(_TAG, _VALUE),
    sections=(_ENDING,),
    make=lambda _: rbd.Set(tag="value", text="1"),
    summary=lambda v: f"{v.tag} = {v.text}",
    palette="action",
)
ADD = Kind(
    name="add",
    value=rbd.Add,
    title="Add to",
    icon="add",
    help="Adds a number to the number at a tag; a missing one counts 0.",
    fields=(_TAG, _VALUE),
    sections=(_ENDING,),
    make=lambda _: rbd.Add(tag="count", text="1"),
    summary=lambda v: f"{v.tag} + {v.text}",
    palette="action",
)
APPEND = Kind(
    name="append",
    value=rbd.Append,
    title="Append",
    icon="append",
    help="Puts a value at the end of the list at a tag.",
    fields=(_TAG, _VALUE),
    sections=(_ENDING,),
    make=lambda _: rbd.Append(tag="list", text="value"),
    summary=lambda v: f"{v.tag} ← {v.text}",
    palette="action",
)
TAKE = Kind(
    name="take",
    value=rbd.Take,
    title="Take from",
    icon="take",
    help="Moves one entry of a list to a tag.",
    fields=(
        Field(attribute="source", label="From list", editor="tag", fixed=True),
        Field(attribute="tag", label="To", editor="tag", fixed=True),
        Field(
            attribute="order",
            label="Which",
            editor="choice",
            choices=(("first", "the first"), ("random", "a random one")),
            fixed=True,
        ),
    ),
    sections=(_ENDING,),
    make=lambda _: rbd.Take(source="list", tag="value"),
    summary=lambda v: f"{v.tag} ← {v.source}",
    palette="action",
)
CLEAR = Kind(
    name="clear",
    value=rbd.Clear,
    title="Clear",
    icon="clear",
    help="Deletes the tags that fit a pattern: user.** is everything below user.",
    fields=(Field(attribute="tag", label="Pattern", editor="tag", fixed=True),),
    sections=(_ENDING,),
    make=lambda _: rbd.Clear(tag="user.**"),
    summary=lambda v: str(v.tag),
    palette="action",
)
REPEAT = Kind(
    name="repeat",
    value=rbd.Repeat,
    title="Say again",
    icon="repeat",
    help="Says the state's speech once more; only in an event that leads nowhere.",
    sections=(_ENDING,),
    make=lambda _: rbd.Repeat(),
    summary=lambda v: "the state's speech",
)

ACTIONS = (
    SPEECH,
    ROBOT,
    SOUND,
    SERVICE,
    MESSAGE,
    LAUNCH,
    SET,
    ADD,
    APPEND,
    TAKE,
    CLEAR,
    REPEAT,
)
STATE_ACTIONS = tuple(k for k in ACTIONS if k is not REPEAT)
EVENT_ACTIONS = tuple(k for k in ACTIONS if k.value not in rbd.VISIBLE_ACTIONS)

# -- screen ------------------------------------------------------------------

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
    fields=(
        Field(attribute="x", label="X", editor="number", unit="%", fixed=True),
        Field(attribute="y", label="Y", editor="number", unit="%", fixed=True),
        Field(attribute="width", label="W", editor="number", unit="%", fixed=True),
        Field(attribute="height", label="H", editor="number", unit="%", fixed=True),
    ),
)
_LOOKS = Section(
    title="Looks",
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
            choices=(("", "by itself"), ("left", "left"), ("center", "centre"), ("right", "right")),
        ),
        Field(attribute="color", label="Colour", editor="color", placeholder="by itself"),
        Field(attribute="fill", label="Fill", editor="color", placeholder="by itself"),
    ),
)
_SHOWN = Field(
    attribute="text",
    label="Text",
    editor="long",
    help="{tag} stands for a value on the blackboard and follows its changes.",
    empty="",
)


def _box(x: float, y: float, width: float, height: float) -> dict[str, Any]:
    return {"x": x, "y": y, "width": width, "height": height}


TEXT = Kind(
    name="text",
    value=rbd.Text,
    title="Text",
    icon="text",
    fields=(_SHOWN, _ID),
    sections=(_PLACE, _LOOKS),
    make=lambda name: rbd.Text(id=name, text="Text", size=8, **_box(10, 10, 80, 20)),
    summary=lambda v: str(v.text),
    palette="screen",
)
BUTTON = Kind(
    name="button",
    value=rbd.Button,
    title="Button",
    icon="button",
    fields=(
        Field(attribute="text", label="Text", empty=""),
        _ID,
        _SENDS,
        Field(
            attribute="tag",
            label="Sets",
            editor="tag",
            help="A tag that a touch sets, if any.",
            placeholder="nothing",
        ),
        Field(attribute="value", label="To", help="The value that the tag gets."),
    ),
    sections=(_PLACE, _LOOKS),
    make=lambda name: rbd.Button(
        id=name, text="OK", event=f"click{name[:1].upper()}{name[1:]}", **_box(35, 75, 30, 15)
    ),
    summary=lambda v: f"{v.text} → {v.event}" if v.event else str(v.text),
    palette="screen",
)
IMAGE = Kind(
    name="image",
    value=rbd.Image,
    title="Image",
    icon="image",
    fields=(Field(attribute="src", label="File", editor="media", empty=""), _ID),
    sections=(_PLACE, _LOOKS),
    make=lambda name: rbd.Image(id=name, src="picture.png", **_box(60, 30, 30, 40)),
    summary=lambda v: str(v.src),
    palette="screen",
)
MOVIE = Kind(
    name="movie",
    value=rbd.Movie,
    title="Movie",
    icon="movie",
    fields=(
        Field(attribute="src", label="File", editor="media", empty=""),
        _ID,
        Field(attribute="done", label="When done", editor="event"),
    ),
    sections=(_PLACE, _LOOKS),
    make=lambda name: rbd.Movie(id=name, src="movie.webm", **_box(10, 30, 45, 40)),
    summary=lambda v: str(v.src),
    palette="screen",
)
INPUT = Kind(
    name="input",
    value=rbd.Input,
    title="Input",
    icon="input",
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
            choices=(
                ("text", "text"),
                ("number", "a number"),
                ("date", "a date"),
                ("pin", "a PIN"),
            ),
            fixed=True,
        ),
        Field(attribute="max", label="Longest", editor="whole", unit="characters"),
        Field(
            attribute="event",
            label="Sends",
            editor="event",
            help="The event at Enter, or when it is full.",
        ),
    ),
    sections=(_PLACE, _LOOKS),
    make=lambda name: rbd.Input(id=name, tag="user.input", **_box(10, 50, 40, 12)),
    summary=lambda v: f"→ {v.tag}",
    palette="screen",
)
LIST = Kind(
    name="list",
    value=rbd.List,
    title="List",
    icon="list",
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
        Field(attribute="event", label="Sends", editor="event"),
    ),
    sections=(_PLACE, _LOOKS),
    make=lambda name: rbd.List(id=name, items="entries", **_box(10, 30, 80, 40)),
    summary=lambda v: f"{v.items} → {v.tag}" if v.tag else str(v.items),
    palette="screen",
)
COMPONENTS = (TEXT, BUTTON, IMAGE, MOVIE, INPUT, LIST)

# -- application ---------------------------------------------------------------

_TIMEOUT = Field(
    attribute="timeout",
    label="Timeout",
    editor="timeout",
    unit="s",
    help="After so many seconds without an event the state is left.",
    placeholder="none",
)
_COMPONENT_LIST = Section(
    title="On the screen", attribute="components", editor="components", hint="back to front"
)
_EVENTS = Section(
    title="Expected events",
    attribute="events",
    editor="events",
    hint="first that fits is taken",
)
SCREEN = Kind(
    name="screen",
    value=rbd.Screen,
    title="Screen",
    icon="screen",
    fields=(
        Field(
            attribute="background",
            label="Background",
            editor="media",
            help="An image of the media folder, or a colour.",
            placeholder="plain",
        ),
        Field(
            attribute="touched",
            label="On touch",
            editor="event",
            help="The event of a touch on no component.",
        ),
    ),
    sections=(_COMPONENT_LIST,),
    make=lambda _: rbd.Screen(),
    summary=lambda v: f"{len(v.components)}",
)
STATE = Kind(
    name="state",
    value=rbd.State,
    title="State",
    icon="state",
    help="What the robot shows, says and waits for.",
    fields=(
        Field(attribute="name", label="Name", empty=""),
        Field(
            attribute="no",
            label="Number",
            help="Unique; transitions lead to it.",
            fixed=True,
        ),
        _TIMEOUT,
    ),
    sections=(
        Section(title="Screen", attribute="screen", editor="components"),
        Section(title="Actions on entry", attribute="actions", editor="actions"),
        _EVENTS,
        Section(
            title="More",
            closed=True,
            fields=(
                Field(
                    attribute="final",
                    label="The end is meant",
                    editor="flag",
                    help="Nothing leads out of this state, on purpose.",
                ),
                Field(
                    attribute="always",
                    label="With Always",
                    editor="flag",
                    help="What Always adds to every state is part of this one too.",
                ),
            ),
        ),
    ),
    make=lambda name: rbd.State(no=name, name="new state"),
    summary=lambda v: next((a.text for a in v.actions if isinstance(a, rbd.Speech)), ""),
    palette="application",
)
ALWAYS = Kind(
    name="always",
    value=rbd.Always,
    title="Always",
    icon="always",
    help="What is part of every state.",
    fields=(_TIMEOUT,),
    sections=(Section(title="Screen", attribute="screen", editor="components"), _EVENTS),
    make=lambda _: rbd.Always(),
    summary=lambda v: ", ".join(e.name or "" for e in v.events),
)
EVENT = Kind(
    name="event",
    value=rbd.Event,
    title="Event",
    icon="event",
    help="What the state waits for, and where it leads.",
    fields=(
        Field(
            attribute="name",
            label="Event",
            editor="event",
            help="Empty: taken as soon as its condition holds.",
            placeholder="none",
        ),
        Field(
            attribute="next",
            label="Leads to",
            editor="next",
            help="A state; nothing: the state stays, only the actions are done.",
        ),
    ),
    sections=(
        Section(
            title="Only if",
            attribute="when",
            editor="condition",
            help="The event is taken only while this holds.",
        ),
        Section(
            title="Said as",
            attribute="says",
            editor="says",
            help="What people may say instead.",
        ),
        Section(title="Actions on the way", attribute="actions", editor="actions"),
    ),
    make=lambda name: rbd.Event(name=name),
    summary=lambda v: str(v.next or ""),
    palette="application",
)
TIMEOUT = Kind(
    name="timeout",
    value=rbd.Timeout,
    title="Timeout",
    icon="timeout",
    help="What happens when nothing happens.",
    fields=(
        Field(attribute="seconds", label="After", editor="seconds", unit="s", fixed=True),
        Field(
            attribute="next",
            label="Leads to",
            editor="next",
            help="Nothing: it raises the event timeout, which can be expected.",
        ),
        Field(
            attribute="idle",
            label="Only when idle",
            editor="flag",
            help="Counted anew after each touch and speech; still while the robot speaks.",
        ),
    ),
    make=lambda _: rbd.Timeout(seconds=30),
    summary=lambda v: f"{v.seconds:g} s",
    palette="application",
)
APPLICATION = Kind(
    name="application",
    value=rbd.Application,
    title="Application",
    icon="state",
    help="States and what leads from one to the next.",
    fields=(
        Field(attribute="name", label="Name", fixed=True),
        Field(
            attribute="start",
            label="Starts with",
            editor="state",
            help="Nothing: the first state.",
            placeholder="the first state",
        ),
    ),
    summary=lambda v: f"{len(v.states)}",
)

# -- script ------------------------------------------------------------------

TYPES: tuple[tuple[str, str], ...] = (
    ("boolean", "yes or no"),
    ("number", "number"),
    ("text", "text"),
    ("list", "list"),
    ("object", "object"),
)
"""Types of data, and what a designer reads."""


def type_words(kind: str | None, unit: str | None) -> str:
    """``yes or no``, ``number, deg``."""
    return ", ".join(part for part in (dict(TYPES).get(kind or ""), unit) if part)


SITUATION = Kind(
    name="situation",
    value=spds.Situation,
    title="Situation",
    icon="situation",
    tint="situation",
    help="What is going on, and who may use the robot then.",
    fields=(
        Field(attribute="name", label="Name", fixed=True),
        Field(
            attribute="extends",
            label="Takes over",
            editor="situation",
            help="The situation whose priorities also count here.",
            placeholder="nothing",
        ),
        Field(
            attribute="dwell",
            label="Stays",
            editor="seconds",
            unit="s at least",
            help="Once current it holds at least so long.",
        ),
        Field(
            attribute="limit",
            label="Ends",
            editor="seconds",
            unit="s at most",
            help="Once current it ends then at the latest.",
        ),
    ),
    sections=(
        Section(
            title="Holds when",
            attribute="condition",
            editor="condition",
            help="Nothing here: it always holds. The last situation must have nothing.",
        ),
        Section(
            title="Until",
            attribute="until",
            editor="condition",
            help="Once current it holds until this does.",
        ),
        Section(title="Priorities", attribute="entries", editor="entries"),
        Section(title="In words", editor="words"),
    ),
    make=lambda name: spds.Situation(name=name),
    palette="script",
)
ENTRY = Kind(
    name="entry",
    value=spds.Entry,
    title="Priority",
    icon="module",
    tint="module",
    fields=(
        Field(attribute="module", label="Module", editor="module", fixed=True),
        Field(
            attribute="priority",
            label="Priority",
            editor="whole",
            help="The higher wins; empty: taken away in this situation.",
            placeholder="none",
        ),
    ),
    make=lambda name: spds.Entry(module=name, priority=10),
    summary=lambda v: "none" if v.priority is None else str(v.priority),
)
MODULE = Kind(
    name="module",
    value=spds.Declaration,
    title="Module",
    icon="module",
    tint="module",
    help="A program that moves the robot when it has the authority.",
    fields=(
        Field(attribute="name", label="Name", fixed=True),
        Field(
            attribute="resources",
            label="Resources",
            editor="resources",
            help="What it may ask for, such as: head base",
            placeholder="none",
        ),
    ),
    make=lambda name: spds.Declaration(name=name, resources=("head",)),
    summary=lambda v: " ".join(v.resources),
    palette="script",
)
_TYPE = Field(
    attribute="type",
    label="Type",
    editor="choice",
    choices=(("", "not said"), *TYPES),
)
DATA = Kind(
    name="data",
    value=spds.Observed,
    title="Data",
    icon="data",
    tint="data",
    help="A value on the blackboard that situations look at.",
    fields=(
        Field(attribute="tag", label="Tag", editor="tag", fixed=True),
        _TYPE,
        Field(attribute="unit", label="Unit", help="Such as deg or m."),
    ),
    make=lambda name: spds.Observed(tag=name, type="boolean"),
    summary=lambda v: type_words(v.type, v.unit),
    palette="script",
)
CONDITION = Kind(
    name="condition",
    value=Test,
    title="Condition",
    icon="condition",
    tint="condition",
    help="One test of a value on the blackboard; a situation holds while all of its tests do.",
    fields=(
        Field(attribute="tag", label="Tag", editor="tag", fixed=True),
        Field(attribute="test", label="Test", editor="choice", choices=TESTS, fixed=True),
        Field(attribute="value", label="Value", help="Of exists: true or false.", fixed=True),
        Field(
            attribute="within",
            label="Within",
            editor="seconds",
            unit="s",
            help="The tag was set less than so many seconds ago.",
        ),
        Field(
            attribute="hold",
            label="For",
            editor="seconds",
            unit="s",
            help="It has held without a break for so many seconds.",
        ),
    ),
    make=lambda name: Test(name, "exists", "true"),
    summary=lambda v: condition_words(v),
    palette="script",
)
SCRIPT = Kind(
    name="script",
    value=spds.Spds,
    title="Script",
    icon="situation",
    tint="situation",
    help="Situations in their order, and the modules' priorities in each.",
    fields=(Field(attribute="name", label="Name", fixed=True),),
    summary=lambda v: f"{len(v.situations)}",
)

# -- module information --------------------------------------------------------

INFORMATION = Kind(
    name="information",
    value=modules.Module,
    title="Module",
    icon="module",
    tint="module",
    help="What its developer says of a module.",
    fields=(
        Field(attribute="name", label="Name", fixed=True),
        Field(
            attribute="resources",
            label="Resources",
            editor="resources",
            help="What it may ask for, such as: head base",
            placeholder="none",
        ),
        Field(attribute="description", label="Does", editor="long", empty=""),
    ),
    sections=(
        Section(title="Needs", attribute="requires", editor="requires"),
        Section(title="Provides", attribute="provides", editor="provides"),
    ),
    make=lambda name: modules.Module(name=name),
    summary=lambda v: str(v.description),
    palette="modules",
)
MODULES = Kind(
    name="modules",
    value=modules.Modules,
    title="Modules",
    icon="module",
    tint="module",
    help="What the developers of the modules say of them.",
    summary=lambda v: f"{len(v.modules)}",
)

# -- conditions ----------------------------------------------------------------


def test_words(test: Test) -> str:
    """A test without its tag: ``is true, within 2 s``."""
    if test.test == "exists":
        words = "exists" if test.value == "true" else "is missing"
    else:
        words = f"{dict(TESTS)[test.test]} {test.value}"
    if test.within is not None:
        words += f", within {test.within:g} s"
    if test.hold is not None:
        words += f", for {test.hold:g} s"
    return words


def condition_words(child: Test | Group) -> str:
    """A test or a group in one line: ``patients is not []``."""
    if isinstance(child, Test):
        return f"{child.tag} {test_words(child)}"
    inner = [condition_words(c) for c in child.children]
    if child.kind == "none":
        return f"none of ({'; '.join(inner)})"
    joined = (" and " if child.kind == "all" else " or ").join(inner)
    return f"({joined})" if len(inner) > 1 else joined


KINDS: tuple[Kind, ...] = (
    APPLICATION,
    ALWAYS,
    STATE,
    EVENT,
    TIMEOUT,
    SCREEN,
    *ACTIONS,
    *COMPONENTS,
    SCRIPT,
    SITUATION,
    ENTRY,
    MODULE,
    DATA,
    CONDITION,
    MODULES,
    INFORMATION,
)
_BY_VALUE = {k.value: k for k in KINDS}
_BY_NAME = {k.name: k for k in KINDS}

MIME = "application/x-situ-kind"
"""What a drag from the palette carries: a kind's name as UTF-8."""


def kind_of(value: Any) -> Kind | None:
    """The kind of a value; None for what has no form of its own."""
    return _BY_VALUE.get(type(value))


def kind(name: str) -> Kind:
    """The kind of that name; KeyError where there is none."""
    return _BY_NAME[name]
