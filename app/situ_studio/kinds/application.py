"""The kinds of what an application is made of, but for actions and components."""

from __future__ import annotations

from situ.document import drawing, rbd
from situ_studio.kinds.kind import Field, Kind, Section
from situ_studio.kinds.noted import MORE, NOTED
from situ_studio.wording.language import tr

_TIMEOUT = Field(
    attribute="timeout",
    label="Timeout",
    editor="timeout",
    unit="s",
    help="After so many seconds without an event the state is left.",
    placeholder="none",
)
_COMPONENT_LIST = Section(
    title="On the screen",
    attribute="components",
    editor="components",
    hint="back to front",
    help="Its components; those further down lie in front.",
)
_EVENTS = Section(
    title="Expected events",
    attribute="events",
    editor="events",
    hint="the first that fits",
    help="What is waited for, and where each leads.",
)
SCREEN = Kind(
    name="screen",
    value=rbd.Screen,
    title="Screen",
    icon="screen",
    help="What the robot shows, until another screen comes.",
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
_STATE_NAME = (
    Field(
        attribute="name",
        label="Name",
        help="What you call it; a few words will do.",
        empty="",
    ),
    Field(
        attribute="no",
        label="Number",
        help="Unique; transitions lead to it.",
        fixed=True,
    ),
)
_SHOWN = Section(
    title="Screen",
    attribute="screen",
    editor="components",
    help="What the robot shows. Without one, what was shown before stays.",
)
_MORE = Section(
    title="More",
    help="What is seldom needed.",
    closed=True,
    fields=(
        Field(
            attribute="final",
            label="It may end here",
            editor="flag",
            help="Nothing leads out of this state, and that is meant.",
        ),
        Field(
            attribute="always",
            label="As in every state",
            editor="flag",
            help="What “In every state” adds is part of this one too.",
        ),
        NOTED,
    ),
)
PART = Kind(
    name="part",
    value=rbd.State,
    title="Part",
    icon="part",
    tint="part",
    help="A state that runs another application until that ends.",
    fields=(
        *_STATE_NAME,
        Field(
            attribute="flow",
            label="Runs",
            help="The application's file. Its ends are the events done.NUMBER, else done.",
            fixed=True,
        ),
    ),
    sections=(_EVENTS, _MORE),
    summary=lambda v: v.flow or "",
    palette="application",
)
STATE = Kind(
    name="state",
    value=rbd.State,
    title="State",
    icon="state",
    help="What the robot shows, says and waits for.",
    fields=(*_STATE_NAME, _TIMEOUT),
    sections=(
        _SHOWN,
        Section(
            title="Actions on entry",
            attribute="actions",
            editor="actions",
            help="What the robot says and does when the state is entered.",
        ),
        _EVENTS,
        _MORE,
    ),
    make=lambda name: rbd.State(no=name, name=tr("new state")),
    summary=lambda v: next((a.text for a in v.actions if isinstance(a, rbd.Speech)), ""),
    palette="application",
)
ALWAYS = Kind(
    name="always",
    value=rbd.Always,
    title="In every state",
    icon="always",
    help="What is part of every state: a Home button, a timeout, what people may say at any time.",
    fields=(_TIMEOUT,),
    sections=(_SHOWN, _EVENTS, MORE),
    make=lambda _: rbd.Always(),
    summary=lambda v: ", ".join(e.name or "" for e in v.events),
    palette="application",
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
        Section(
            title="Actions on the way",
            attribute="actions",
            editor="actions",
            help="What is done before the next state is entered.",
        ),
        MORE,
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
        Field(
            attribute="seconds",
            label="After",
            editor="seconds",
            unit="s",
            help="How long the state waits.",
            fixed=True,
        ),
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
    summary=lambda v: tr("{0} s").format(f"{v.seconds:g}"),
    palette="application",
)
COLORS = (
    ("", "The usual"),
    ("#46536a", "Grey"),
    ("#0b7a4b", "Green"),
    ("#0a5a4c", "Teal"),
    ("#086d9c", "Blue"),
    ("#5d4bb0", "Violet"),
    ("#8a2178", "Plum"),
    ("#7c2d0c", "Rust"),
    ("#8a5f00", "Yellow"),
)
"""The colours of notes and frames: those of the kinds on light ground, for any ground."""
_COLOR = Field(
    attribute="color",
    label="Colour",
    editor="choice",
    help="To tell it from others at a glance.",
    choices=COLORS,
    empty="",
)
_SIZE = Section(
    title="Place and size",
    help="On the drawing.",
    closed=True,
    fields=tuple(
        Field(attribute=name, label=label, editor="number", help=help, fixed=True)
        for name, label, help in (
            ("x", "X", "How far from the left."),
            ("y", "Y", "How far from the top."),
            ("width", "Width", "How wide it is."),
            ("height", "Height", "How high it is."),
        )
    ),
)
NOTE = Kind(
    name="note",
    value=drawing.Note,
    title="Note",
    icon="note",
    tint="condition",
    help="A few words for those who draw; the robot does not see them.",
    fields=(
        Field(attribute="text", label="Text", editor="long", help="What it says.", empty=""),
        _COLOR,
    ),
    sections=(_SIZE,),
    make=lambda text: drawing.Note(text=text),
    summary=lambda v: v.text,
    palette="drawing",
)
FRAME = Kind(
    name="frame",
    value=drawing.Frame,
    title="Frame",
    icon="frame",
    tint="module",
    help="Goes round states that belong together, and moves with them.",
    fields=(
        Field(attribute="title", label="Title", help="Stands at its upper edge.", empty=""),
        _COLOR,
    ),
    sections=(_SIZE,),
    make=lambda title: drawing.Frame(title=title),
    summary=lambda v: v.title,
    palette="drawing",
)
APPLICATION = Kind(
    name="application",
    value=rbd.Application,
    title="Application",
    icon="state",
    help="States and what leads from one to the next.",
    fields=(
        Field(attribute="name", label="Name", help="How the robot calls it.", fixed=True),
        Field(
            attribute="start",
            label="Starts with",
            editor="state",
            help="Nothing: the first state.",
            placeholder="the first state",
        ),
    ),
    sections=(MORE,),
    summary=lambda v: f"{len(v.states)}",
)
