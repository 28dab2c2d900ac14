"""A document's parts in plain words: times, tests, conditions, actions, events, components.

The words of ``situ diff``, ``situ why`` and ``situ test``; the editor may say the same.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable

from situ.document import rbd
from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import write_number

Say = Callable[[str], str]
"""Gives a text of these in the reader's language; ``str``: in English, as it is."""

_TESTS = {
    "is": "is {0}",
    "isnot": "is not {0}",
    "above": "above {0}",
    "below": "below {0}",
    "atleast": "at least {0}",
    "atmost": "at most {0}",
    "in": "is one of {0}",
}

LONGEST = 60
"""Characters of the user's text that are quoted."""


def quoted(text: str) -> str:
    """A piece of the user's text in quotation marks: one line, not long."""
    text = " ".join(text.split())
    return f"“{text if len(text) <= LONGEST else text[: LONGEST - 1] + '…'}”"


def listed(words: Iterable[str], joint: str = "and") -> str:
    """``a, b and c``."""
    several = list(words)
    if len(several) < 2:
        return "".join(several)
    return f"{', '.join(several[:-1])} {joint} {several[-1]}"


def number(value: float) -> str:
    """``60``, ``1.5``: the shortest decimal that reads as the same number."""
    return write_number(value)


def seconds(value: float, say: Say = str) -> str:
    """``60 s``, ``1.5 s``."""
    return say("{0} s").format(number(value))


# -- conditions --------------------------------------------------------------


def predicate(test: Test, say: Say = str) -> str:
    """The test without its tag: ``is true, within 5 s``."""
    if test.test == "exists":
        said = say("exists") if test.value != "false" else say("is missing")
    else:
        said = say(_TESTS[test.test]).format(_wanted(test, say))
    if test.within is not None:
        said = say("{0}, within {1}").format(said, seconds(test.within, say))
    if test.hold is not None:
        said = say("{0}, for {1}").format(said, seconds(test.hold, say))
    return said


def _wanted(test: Test, say: Say) -> str:
    if test.test == "in":
        try:
            several = json.loads(test.value)
        except ValueError:
            several = None
        if isinstance(several, list):
            return ", ".join(one if isinstance(one, str) else json.dumps(one) for one in several)
    if test.value.replace(" ", "") == "[]":
        return "[ ]"  # two brackets alone are read as one box
    return test.value or say("empty")


def child(value: Test | Group, say: Say = str) -> str:
    """A test or a group: ``patients.0 exists``, ``none of: a is 1 or b is 2``."""
    if isinstance(value, Test):
        return f"{value.tag} {predicate(value, say)}"
    joint = say(" and ") if value.kind == "all" else say(" or ")
    said = joint.join(_inner(c, value.children, say) for c in value.children)
    return say("none of: {0}").format(said) if value.kind == "none" else said


def condition(value: Condition | None, say: Say = str) -> str:
    """The whole condition in one line; empty where there is none."""
    if value is None:
        return ""
    return say(" and ").join(_inner(c, value.children, say) for c in value.children)


def _inner(value: Test | Group, among: tuple[Test | Group, ...], say: Say) -> str:
    # One child alone is joined with nothing: its group needs no brackets.
    while isinstance(value, Group) and value.kind != "none" and len(value.children) == 1:
        value = value.children[0]
    said = child(value, say)
    return f"({said})" if isinstance(value, Group) and len(among) > 1 else said


# -- applications ------------------------------------------------------------


def state(value: rbd.State) -> str:
    """``6 show names``, or the number alone, also where the name says no more than it: ``state 6``,
    as new states are called."""
    return numbered(value.no, value.name)


def numbered(no: str, name: str) -> str:
    """A state by its number and name, as ``state`` does; ``4/6`` is 6 of a part."""
    own = no.rpartition("/")[2]
    return no if name == f"state {own}" else f"{no} {name}".strip()


def leads(application: rbd.Application, target: str | None) -> str:
    """Where an event or a timeout leads: ``6 show names``, ``back``, ``stays``."""
    if target is None:
        return "stays"
    if target == rbd.AGAIN:
        return "the same state anew"
    if target == rbd.BACK:
        return "back"
    found = application.state(target)
    return target if found is None else state(found)


def event(value: rbd.Event) -> str:
    """``event clickNo``, ``unnamed event``."""
    return f"event {value.name}" if value.name else "unnamed event"


def action(value: rbd.Action) -> str:
    """What an action does, in a few words: its text, its command, its name."""
    match value:
        case rbd.Speech(text=text) | rbd.Message(text=text) if text:
            return text
        case rbd.Robot(command=command, params=params):
            return " ".join([command, *(p.text for p in params)])
        case rbd.Service(name=name):
            return name
        case rbd.Message(topic=topic):
            return topic
        case rbd.Launch(program=program):
            return program
        case rbd.Sound(src=src):
            return src
        case rbd.Set(tag=tag, text=text):
            return f"{tag} = {text}"
        case rbd.Add(tag=tag, text=text):
            return f"{tag} + {text}"
        case rbd.Append(tag=tag, text=text):
            return f"{text} to {tag}"
        case rbd.Take(source=source, tag=tag):
            return f"{tag} from {source}"
        case rbd.Clear(tag=tag):
            return f"clear {tag}"
        case _:
            return value.element


def whole_action(value: rbd.Action) -> str:
    """An action with its kind: ``speech “Hello”``, ``robot base goto lobby``, ``service find``."""
    match value:
        case rbd.Speech(text=text):
            return f"speech {quoted(text)}"
        case rbd.Robot(resource=resource):
            return f"robot {resource} {action(value)}"
        case rbd.Clear() | rbd.Repeat():
            return action(value)
        case rbd.Message(topic=topic, text=text) if text:
            return f"message {topic} {quoted(text)}"
        case _:
            return f"{value.element} {action(value)}"


def component(value: rbd.Component) -> str:
    """``button yes``."""
    return f"{value.element} {value.id}"
