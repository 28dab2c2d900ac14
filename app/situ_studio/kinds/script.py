"""The kinds of what a script and module information are made of."""

from __future__ import annotations

from situ.document import modules, spds, words
from situ.document.condition import Test
from situ_studio.kinds.kind import Field, Kind, Section
from situ_studio.kinds.noted import MORE
from situ_studio.kinds.said import TESTS, TYPES, type_words
from situ_studio.wording.language import tr

SITUATION = Kind(
    name="situation",
    value=spds.Situation,
    title="Situation",
    icon="situation",
    tint="situation",
    help="What is going on, and who may use the robot then.",
    fields=(
        Field(attribute="name", label="Name", help="Unique; others call it so.", fixed=True),
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
        Section(
            title="Priorities",
            attribute="entries",
            editor="entries",
            help="Of each module in this situation; the higher wins.",
        ),
        Section(title="In words", editor="words", help="The same as a sentence."),
        MORE,
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
    help="How much a module counts in a situation; the highest one that asks wins.",
    fields=(
        Field(
            attribute="module",
            label="Module",
            editor="module",
            help="Whose priority it is.",
            fixed=True,
        ),
        Field(
            attribute="priority",
            label="Priority",
            editor="whole",
            help="The higher wins; empty: taken away in this situation.",
            placeholder="none",
        ),
    ),
    make=lambda name: spds.Entry(module=name, priority=10),
    summary=lambda v: tr("none") if v.priority is None else str(v.priority),
)
MODULE = Kind(
    name="module",
    value=spds.Declaration,
    title="Module",
    icon="module",
    tint="module",
    help="A program that moves the robot when it has the authority.",
    fields=(
        Field(attribute="name", label="Name", help="Unique; others call it so.", fixed=True),
        Field(
            attribute="resources",
            label="Resources",
            editor="resources",
            help="What it may ask for, such as: head base",
            placeholder="none",
        ),
    ),
    sections=(MORE,),
    make=lambda name: spds.Declaration(name=name),
    summary=lambda v: " ".join(v.resources),
    palette="script",
)
_TYPE = Field(
    attribute="type",
    label="Type",
    editor="choice",
    help="What its values are.",
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
        Field(
            attribute="tag",
            label="Tag",
            editor="tag",
            help="Where the value stands on the blackboard, such as user.name.",
            fixed=True,
        ),
        _TYPE,
        Field(attribute="unit", label="Unit", help="Such as deg or m."),
    ),
    sections=(MORE,),
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
        Field(
            attribute="tag",
            label="Tag",
            editor="tag",
            help="Where the value stands on the blackboard, such as user.name.",
            fixed=True,
        ),
        Field(
            attribute="test",
            label="Test",
            editor="choice",
            help="How it is compared.",
            choices=TESTS,
            fixed=True,
        ),
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
    summary=words.child,
    palette="script",
)
SCRIPT = Kind(
    name="script",
    value=spds.Spds,
    title="Script",
    icon="situation",
    tint="situation",
    help="Situations in their order, and the modules' priorities in each.",
    fields=(Field(attribute="name", label="Name", help="How the robot calls it.", fixed=True),),
    sections=(MORE,),
    summary=lambda v: f"{len(v.situations)}",
)
INFORMATION = Kind(
    name="information",
    value=modules.Module,
    title="Module",
    icon="module",
    tint="module",
    help="What its developer says of a module.",
    fields=(
        Field(attribute="name", label="Name", help="Unique; others call it so.", fixed=True),
        Field(
            attribute="resources",
            label="Resources",
            editor="resources",
            help="What it may ask for, such as: head base",
            placeholder="none",
        ),
        Field(
            attribute="description",
            label="Does",
            editor="long",
            help="What it is for, in a sentence or two.",
            empty="",
        ),
    ),
    sections=(
        Section(
            title="Needs", attribute="requires", editor="requires", help="The values that it reads."
        ),
        Section(
            title="Provides",
            attribute="provides",
            editor="provides",
            help="The values that it writes.",
        ),
        MORE,
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
