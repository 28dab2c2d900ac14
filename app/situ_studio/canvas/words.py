"""Conditions, timeouts and actions in a designer's words, for cards, pipes and menus."""

from __future__ import annotations

import json

from situ.document import rbd
from situ.document.condition import Condition, Group, Test

_TESTS = {
    "is": "is",
    "isnot": "is not",
    "above": "above",
    "below": "below",
    "atleast": "at least",
    "atmost": "at most",
    "in": "is one of",
}


def seconds(value: float) -> str:
    """``60 s``, ``1.5 s``."""
    return f"{value:g} s"


def predicate(test: Test) -> str:
    """The test without its tag: ``is true, within 5 s``."""
    if test.test == "exists":
        said = "exists" if test.value != "false" else "is missing"
    else:
        said = f"{_TESTS[test.test]} {_value(test)}"
    if test.within is not None:
        said += f", within {seconds(test.within)}"
    if test.hold is not None:
        said += f", for {seconds(test.hold)}"
    return said


def _value(test: Test) -> str:
    if test.test == "in":
        try:
            several = json.loads(test.value)
        except ValueError:
            several = None
        if isinstance(several, list):
            return ", ".join(str(v) for v in several)
    if test.value.replace(" ", "") == "[]":
        return "[ ]"
    return test.value or "empty"


def child(value: Test | Group) -> str:
    if isinstance(value, Test):
        return f"{value.tag} {predicate(value)}"
    joint = {"all": " and ", "any": " or ", "none": " or "}[value.kind]
    said = joint.join(child(c) for c in value.children)
    return f"none of: {said}" if value.kind == "none" else said


def condition(value: Condition | None) -> str:
    """The whole condition in one line; empty where there is none."""
    if value is None:
        return ""
    return " and ".join(
        f"({child(c)})" if isinstance(c, Group) and len(value.children) > 1 else child(c)
        for c in value.children
    )


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


ICONS: dict[str, str] = {
    "speech": "speech",
    "robot": "robot",
    "service": "service",
    "message": "message",
    "launch": "launch",
    "sound": "sound",
    "set": "set",
    "add": "set",
    "append": "append",
    "take": "take",
    "clear": "clear",
    "repeat": "repeat",
}
"""An action's element to the name of its icon."""
