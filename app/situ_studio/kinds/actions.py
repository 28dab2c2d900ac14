"""The kinds of actions."""

from __future__ import annotations

from typing import Any

from situ.document import rbd
from situ_studio.kinds.kind import Field, Kind, Section
from situ_studio.kinds.noted import MORE
from situ_studio.wording.language import tr


def _params(value: Any) -> str:
    return ", ".join(f"{p.name} {p.text}" for p in value.params)


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
_ENDING = Section(
    title="Ending", help="What happens when it has ended.", fields=(_WAIT, _DONE, _FAILED)
)
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
    sections=(_ENDING, MORE),
    make=lambda _: rbd.Speech(text=tr("Hello")),
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
    sections=(_PARAMS, _ENDING, MORE),
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
            help="GET asks; the others change something there.",
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
        MORE,
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
    sections=(_PARAMS, _ENDING, MORE),
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
    sections=(_PARAMS, _ENDING, MORE),
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
        Field(
            attribute="src",
            label="File",
            editor="media",
            help="Of the project's media folder.",
            fixed=True,
        ),
        _OPTIONAL,
    ),
    sections=(_ENDING, MORE),
    make=lambda _: rbd.Sound(src="chime.ogg"),
    summary=lambda v: str(v.src),
    palette="action",
    file="src",
)
SET = Kind(
    name="set",
    value=rbd.Set,
    title="Set value",
    icon="set",
    help="Writes a value on the blackboard.",
    fields=(_TAG, _VALUE),
    sections=(_ENDING, MORE),
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
    sections=(_ENDING, MORE),
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
    sections=(_ENDING, MORE),
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
        Field(
            attribute="source",
            label="From list",
            editor="tag",
            help="The tag at which the list stands.",
            fixed=True,
        ),
        Field(
            attribute="tag",
            label="To",
            editor="tag",
            help="The tag that gets the entry.",
            fixed=True,
        ),
        Field(
            attribute="order",
            label="Which",
            help="The entry that is taken; it is in the list no more.",
            editor="choice",
            choices=(("first", "the first"), ("random", "a random one")),
            fixed=True,
        ),
    ),
    sections=(_ENDING, MORE),
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
    fields=(
        Field(
            attribute="tag",
            label="Pattern",
            editor="tag",
            help="A tag; * stands for one name in it, ** for all below.",
            fixed=True,
        ),
    ),
    sections=(_ENDING, MORE),
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
    sections=(_ENDING, MORE),
    make=lambda _: rbd.Repeat(),
    summary=lambda v: tr("the state's speech"),
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
