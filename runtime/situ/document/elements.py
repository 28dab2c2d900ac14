"""The one table of elements and attributes of formats.md.

Reader, writer, the errors about unknown names, the rules that ``check`` applies
to single attributes, and the RELAX NG schemas all follow from it: a new action
or attribute is a row here and a field of its value. Attributes and children
stand in the order in which they are written.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any, cast

from msgspec import Struct
from msgspec.structs import fields, force_setattr, replace

from situ.document import rbd, spds
from situ.document.aside import Aside
from situ.document.condition import TESTS, Condition, Group, Test, TestName
from situ.document.datatypes import (
    BOOLEAN,
    COUNT,
    NAME,
    NUMBER,
    PATTERN,
    PRIORITY,
    RESOURCES,
    SECONDS,
    SIZE,
    SOME,
    TAG,
    TARGET,
    TEXT,
    TITLE,
    TOKEN,
    Type,
    choice,
)
from situ.document.grammar import Attribute, Element, Misfit, Slot
from situ.document.modules import Module, Modules, Provides, Requires


def _a(
    name: str,
    kind: Type = TEXT,
    *,
    field: str | None = None,
    required: bool = False,
    always: bool = False,
    alternative: bool = False,
) -> Attribute:
    return Attribute(name, kind, field or name, required, always, alternative=alternative)


def _value(
    make: type[Struct],
    name: str,
    *attributes: Attribute,
    text: tuple[str, Type] | None = None,
    text_required: bool = False,
    slots: tuple[Slot, ...] = (),
) -> Element:
    defaults = {one.name: one.default for one in fields(make)}
    return Element(
        name,
        make=make,
        key=make,
        attributes=tuple(replace(one, default=defaults[one.field]) for one in attributes),
        text=text,
        text_required=text_required,
        slots=slots,
    )


def _part(name: str, *attributes: Attribute, slot: Slot | None = None) -> Slot:
    element = Element(name, attributes=attributes, slots=() if slot is None else (slot,), part=True)
    return Slot("", (element,))


_TEXT = ("text", TEXT)

# -- conditions --------------------------------------------------------------


def _make_test(tag: str, aside: Aside, **found: Any) -> Test:
    within, hold = found.pop("within", None), found.pop("hold", None)
    if len(found) == 1:
        ((test, value),) = found.items()
        return Test(tag, cast(TestName, test), value, within, hold, aside)
    instead = Test(tag, "exists", "true", within, hold, aside)
    if not found:
        said = f"<data> tests nothing: add one of {', '.join(TESTS)}"
    else:
        said = f"<data> has {len(found)} tests ({', '.join(found)}): write one <data> for each"
    raise Misfit("one-test", said, instead)


def _test_attributes(test: Test) -> Iterator[tuple[str, str]]:
    yield "tag", test.tag
    yield test.test, test.value
    write = SECONDS.write
    assert write is not None
    if test.within is not None:
        yield "within", write(test.within)
    if test.hold is not None:
        yield "for", write(test.hold)


TEST = Element(
    "data",
    make=_make_test,
    key=Test,
    attributes=(
        _a("tag", NAME, required=True),
        *(_a(test, alternative=True) for test in TESTS),
        _a("within", SECONDS),
        _a("for", SECONDS, field="hold"),
    ),
    attributes_of=_test_attributes,
)


def _groups() -> tuple[Element, ...]:
    # Groups hold groups, so the slot is filled after the elements stand in it.
    inner = Slot("children", (), many=True)
    found = tuple(
        Element(kind, make=partial(Group, kind), key=kind, slots=(inner,))
        for kind in ("all", "any", "none")
    )
    force_setattr(inner, "elements", (TEST, *found))
    return found


_CHILDREN = Slot("children", (TEST, *_groups()), many=True)


def _condition(name: str) -> Element:
    return _value(Condition, name, slots=(_CHILDREN,))


# -- screen ------------------------------------------------------------------

_PLACE = (
    _a("id", SOME, required=True),
    _a("x", NUMBER, required=True),
    _a("y", NUMBER, required=True),
    _a("width", SIZE, required=True),
    _a("height", SIZE, required=True),
    _a("size", SIZE),
    _a("align", choice("left", "center", "right")),
    _a("color"),
    _a("fill"),
)

COMPONENTS = (
    _value(rbd.Text, "text", *_PLACE, text=_TEXT),
    _value(
        rbd.Button, "button", *_PLACE, _a("event", SOME), _a("tag", TAG), _a("value"), text=_TEXT
    ),
    _value(rbd.Image, "image", *_PLACE, _a("src", SOME, required=True)),
    _value(
        rbd.Movie,
        "movie",
        *_PLACE,
        _a("src", SOME, required=True),
        _a("done", SOME),
        _a("failed", SOME),
    ),
    _value(
        rbd.Input,
        "input",
        *_PLACE,
        _a("tag", TAG, required=True),
        _a("kind", choice("text", "number", "date", "pin"), always=True),
        _a("max", COUNT),
        _a("event", SOME),
    ),
    _value(
        rbd.List,
        "list",
        *_PLACE,
        _a("items", NAME, required=True),
        _a("label"),
        _a("tag", TAG),
        _a("event", SOME),
    ),
)

SCREEN = _value(
    rbd.Screen,
    "screen",
    _a("background", SOME),
    _a("touched", SOME),
    slots=(_part("components", slot=Slot("components", COMPONENTS, many=True)),),
)

# -- actions -----------------------------------------------------------------

_PARAMS = Slot(
    "params",
    (_value(rbd.Param, "param", _a("name", SOME, required=True), text=_TEXT),),
    many=True,
)
_RESULTS = Slot(
    "results",
    (_value(rbd.Result, "result", _a("tag", TAG, required=True), _a("path")),),
    many=True,
)
_ENDS = (_a("wait", BOOLEAN), _a("done", SOME), _a("failed", SOME))

VISIBLE = (
    _value(
        rbd.Speech,
        "speech",
        _a("lang", SOME),
        _a("bargein", BOOLEAN),
        _a("optional", BOOLEAN),
        *_ENDS,
        text=_TEXT,
    ),
    _value(
        rbd.Robot,
        "robot",
        _a("resource", TITLE, required=True),
        _a("command", SOME, required=True),
        _a("optional", BOOLEAN),
        *_ENDS,
        slots=(_PARAMS,),
    ),
    _value(rbd.Sound, "sound", _a("src", SOME, required=True), _a("optional", BOOLEAN), *_ENDS),
)
SILENT = (
    _value(
        rbd.Service,
        "service",
        _a("name", TITLE, required=True),
        _a("method", SOME),
        _a("url", SOME, required=True),
        _a("keep", BOOLEAN),
        *_ENDS,
        slots=(_PARAMS, _RESULTS),
    ),
    _value(
        rbd.Message,
        "message",
        _a("topic", SOME, required=True),
        *_ENDS,
        text=_TEXT,
        slots=(_PARAMS,),
    ),
    _value(
        rbd.Launch,
        "launch",
        _a("program", SOME, required=True),
        _a("keep", BOOLEAN),
        *_ENDS,
        slots=(_PARAMS,),
    ),
    _value(rbd.Set, "set", _a("tag", TAG, required=True), *_ENDS, text=_TEXT),
    _value(rbd.Add, "add", _a("tag", TAG, required=True), *_ENDS, text=_TEXT),
    _value(rbd.Append, "append", _a("tag", TAG, required=True), *_ENDS, text=_TEXT),
    _value(
        rbd.Take,
        "take",
        _a("from", TAG, field="source", required=True),
        _a("tag", TAG, required=True),
        _a("order", choice("first", "random")),
        *_ENDS,
    ),
    _value(rbd.Clear, "clear", _a("tag", PATTERN, required=True), *_ENDS),
)
REPEAT = _value(rbd.Repeat, "repeat", *_ENDS)
"""Actions: visible ones belong to states, ``repeat`` to events, silent ones to both."""

# -- states ------------------------------------------------------------------

EVENT = _value(
    rbd.Event,
    "event",
    _a("name", SOME),
    _a("next", TARGET),
    slots=(
        Slot("when", (_condition("when"),)),
        Slot("says", (_value(rbd.Say, "say", text=("text", SOME), text_required=True),), many=True),
        Slot("actions", (*SILENT, REPEAT), many=True, misplaced=VISIBLE),
    ),
)
TIMEOUT = _value(
    rbd.Timeout,
    "timeout",
    _a("next", TARGET),
    _a("idle", BOOLEAN),
    text=("seconds", SECONDS),
    text_required=True,
)
_EVENTS = _part("expectedevents", slot=Slot("events", (EVENT,), many=True))
STATE = _value(
    rbd.State,
    "state",
    _a("no", TOKEN, required=True),
    _a("name"),
    _a("always", BOOLEAN),
    _a("final", BOOLEAN),
    slots=(
        _part("flow", _a("src", SOME, field="flow", required=True)),
        Slot("timeout", (TIMEOUT,)),
        Slot("screen", (SCREEN,)),
        _part(
            "backgroundactions",
            slot=Slot("actions", (*VISIBLE, *SILENT), many=True, misplaced=(REPEAT,)),
        ),
        _EVENTS,
    ),
)
ALWAYS = _value(
    rbd.Always,
    "always",
    slots=(Slot("timeout", (TIMEOUT,)), Slot("screen", (SCREEN,)), _EVENTS),
)
APPLICATION = _value(
    rbd.Application,
    "application",
    _a("name", TITLE, required=True),
    _a("start"),
    slots=(Slot("always", (ALWAYS,)), Slot("states", (STATE,), many=True)),
)

# -- situated priority description script ------------------------------------

_DATA_TYPE = choice(*spds.DATA_TYPES)
SITUATION = _value(
    spds.Situation,
    "situation",
    _a("name", SOME, required=True),
    _a("extends", SOME),
    _a("dwell", SECONDS),
    _a("limit", SECONDS),
    slots=(
        Slot("condition", (_condition("condition"),)),
        Slot("until", (_condition("until"),)),
        Slot(
            "entries",
            (
                _value(
                    spds.Entry,
                    "module",
                    _a("name", TITLE, field="module", required=True),
                    _a("priority", PRIORITY, required=True),
                ),
            ),
            many=True,
        ),
    ),
)
_OBSERVED = _value(
    spds.Observed, "data", _a("tag", TAG, required=True), _a("type", _DATA_TYPE), _a("unit", SOME)
)
_DECLARATION = _value(
    spds.Declaration,
    "module",
    _a("name", TITLE, required=True),
    _a("resources", RESOURCES, always=True),
)
SPDS = _value(
    spds.Spds,
    "spds",
    _a("name", SOME, required=True),
    slots=(
        _part("observe", slot=Slot("observe", (_OBSERVED,), many=True)),
        _part("modules", slot=Slot("modules", (_DECLARATION,), many=True)),
        Slot("situations", (SITUATION,), many=True),
    ),
)

# -- module information ------------------------------------------------------

_DESCRIPTION = Slot("", (Element("description", text=("description", TEXT), part=True),))
MODULES = _value(
    Modules,
    "modules",
    slots=(
        Slot(
            "modules",
            (
                _value(
                    Module,
                    "module",
                    _a("name", TITLE, required=True),
                    _a("resources", RESOURCES, always=True),
                    slots=(
                        _DESCRIPTION,
                        Slot(
                            "requires",
                            (
                                _value(
                                    Requires,
                                    "requires",
                                    _a("data", TAG, alternative=True),
                                    _a("module", TITLE, alternative=True),
                                ),
                            ),
                            many=True,
                        ),
                        Slot(
                            "provides",
                            (
                                _value(
                                    Provides,
                                    "provides",
                                    _a("data", TAG, required=True),
                                    _a("type", _DATA_TYPE),
                                    _a("unit", SOME),
                                ),
                            ),
                            many=True,
                        ),
                    ),
                ),
            ),
            many=True,
        ),
    ),
)

ROOTS = (APPLICATION, SPDS, MODULES)
