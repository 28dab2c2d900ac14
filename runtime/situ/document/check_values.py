"""What can be said of single values: the rules of the table, and conditions.

One walk over a document, driven by ``situ.document.elements``. The places of values, as
the editor's selection names them, are made only in those members of a document (states,
situations, modules) in which a first look finds anything to tell.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NoReturn, get_args

from situ.document import names
from situ.document.accept import ACCEPT
from situ.document.condition import Condition, Group, GroupName, Test, TestName
from situ.document.datatypes import shown
from situ.document.elements import ROOTS
from situ.document.finding import Findings, Place
from situ.document.grammar import Element, Slot
from situ.document.mend import change, take_out
from situ.document.place import follow
from situ.document.problem import Mend
from situ.document.spds import Spds

_WORDS = {
    "states": ("state", "no"),
    "components": ("", "id"),
    "observe": ("data", "tag"),
    "situations": ("situation", "name"),
    "modules": ("module", "name"),
    "actions": ("action", ""),
    "events": ("event", ""),
    "says": ("say", ""),
    "params": ("param", ""),
    "results": ("result", ""),
    "entries": ("entry", ""),
    "requires": ("requires", ""),
    "provides": ("provides", ""),
    "children": ("", ""),
}
"""By field: the word before a member in a place, and what names it (else its position)."""

_MOST_JUDGED = 4096


class _Judged(dict[Any, "str | None"]):
    """What a rule says of values; each is judged once."""

    def __init__(self, rule: Callable[[Any], str | None]) -> None:
        super().__init__()
        self._rule = rule

    def __missing__(self, value: Any) -> str | None:
        wrong = self._rule(value)
        if len(self) < _MOST_JUDGED:
            self[value] = wrong
        return wrong


_Rule = tuple[str, str, _Judged, str]


class _Look:
    """An element, compiled: its rules, and the fields in which its children are.

    inner: those fields again, whether they hold several, and by class of a child its look.
    """

    __slots__ = ("children", "inner", "is_condition", "is_test", "rules")

    def __init__(self, element: Element) -> None:
        self.rules: list[_Rule] = []
        self.children: list[tuple[str, Slot, str, str]] = []
        self.inner: list[tuple[str, bool, dict[Any, _Look]]] = []
        self.is_test = element.key is Test
        self.is_condition = element.key is Condition or element.key in get_args(GroupName)


def _compile() -> dict[int, _Look]:
    looks: dict[int, _Look] = {}

    def rules(element: Element) -> list[_Rule]:
        found: list[_Rule] = []
        for one in element.attributes:
            rule = one.type.rule
            if rule is not None:
                said = f"The {one.name} of <{element.name}>"
                found.append((one.field, said, _Judged(rule), one.type.code))
        if element.text is not None and element.text[1].rule is not None:
            kind = element.text[1]
            assert kind.rule is not None
            found.append((element.text[0], f"<{element.name}>", _Judged(kind.rule), kind.code))
        return found

    def look(element: Element) -> _Look:
        if id(element) in looks:
            return looks[id(element)]
        made = looks[id(element)] = _Look(element)
        made.rules = rules(element)
        for slot in element.slots:
            if slot.field:
                word, key = _WORDS.get(slot.field, (slot.field, ""))
                made.children.append((slot.field, slot, word, key))
            else:
                part = slot.elements[0]
                made.rules += rules(part)
                for inner in part.slots:
                    word, key = _WORDS[inner.field]
                    made.children.append((inner.field, inner, word, key))
        for field, slot, _, _ in made.children:
            # All groups look the same.
            by_class = {
                child.key if isinstance(child.key, type) else Group: look(child)
                for child in (*slot.elements, *slot.misplaced)
            }
            made.inner.append((field, slot.many, by_class))
        return made

    for root in ROOTS:
        look(root)
    return looks


_LOOKS = _compile()


def check_values(found: Findings, document: Any) -> None:
    """Tells what is wrong with any one value of a document, wherever it stands."""
    root = next(element for element in ROOTS if element.key is type(document))
    _visit(found, root, document, (), document)


def _visit(
    found: Findings,
    element: Element,
    value: Any,
    place: Place,
    document: Any,
) -> None:
    look = _LOOKS[id(element)]
    is_root, script = value is document, type(document) is Spds
    if value.aside.attributes or value.aside.parts:
        found.accepts.note(place, value.aside)
    for field, said, judged, code in look.rules:
        held = getattr(value, field)
        if held is not None:
            wrong = judged[held]
            if wrong is not None:
                mend = _once(found, document, value, place, field)
                found.error(code, f"{said} {wrong}", value.aside, place, mend)
    for field, slot, word, key in look.children:
        held = getattr(value, field)
        if not slot.many:
            if held is not None:
                _visit(found, slot.element(held), held, (*place, word), document)
            continue
        for index, child in enumerate(held):
            inside = slot.element(child)
            if is_root and _is_sound(_LOOKS[id(inside)], child, script):
                continue
            name = str(getattr(child, key)) if key else str(index)
            inner = (*place, word, name) if word else (*place, name)
            _visit(found, inside, child, inner, document)
    if look.is_test:
        problem = _judge_test(value.test, value.value, script)
        if problem is not None:
            found.error(*problem, value.aside, place)
    elif look.is_condition and not value.children:
        said = "This condition is empty: put a test into it, or take it out"
        mend = _without(found, document, value, place)
        found.error("empty-condition", said, value.aside, place, mend)


def _once(found: Findings, document: Any, value: Any, place: Place, field: str) -> Mend | None:
    """To name each of several only once, where that is all that is wrong."""
    held = getattr(value, field)
    way = follow(document, place)
    if not isinstance(held, tuple) or way is None or way[1][-1] is not value:
        return None
    once = tuple(dict.fromkeys(held))
    made = change(way[0], value, field, once)
    return Mend(found.file, "Name each once", (made,), safe=True) if once != held else None


def _without(found: Findings, document: Any, value: Any, place: Place) -> Mend | None:
    """To take out an empty condition."""
    way = follow(document, place)
    if way is None or way[1][-1] is not value:
        return None
    path, values = way
    last = path[-1]
    if isinstance(last, int):
        made = take_out(path, value)
    else:
        made = change(path[:-1], values[-2], last, None)
    return Mend(found.file, "Take the empty condition out", (made,))


def _is_sound(look: _Look, value: Any, script: bool) -> bool:
    """Whether there is nothing to tell, or to take note of, about a value and what is in it."""
    aside = value.aside
    if aside.attributes and aside.attribute(ACCEPT) is not None:
        return False
    for _, part in aside.parts:
        if part.attributes and part.attribute(ACCEPT) is not None:
            return False
    for field, _, judged, _ in look.rules:
        held = getattr(value, field)
        if held is not None and judged[held] is not None:
            return False
    for field, many, looks in look.inner:
        held = getattr(value, field)
        if not held:
            continue
        for child in held if many else (held,):
            if not _is_sound(looks[type(child)], child, script):
                return False
    if look.is_test:
        return _judge_test(value.test, value.value, script) is None
    return not look.is_condition or bool(value.children)


@lru_cache(4096)
def _judge_test(test: TestName, value: str, script: bool) -> tuple[str, str] | None:
    """The code and the words of what is wrong with what a test compares with."""
    if names.only_reference(value) is not None:
        if script:
            return "reference-in-script", (
                f"A script cannot compare with a reference: {shown(value)}; write the value itself"
            )
    elif test == "exists" and value not in ("true", "false"):
        return "bad-value", (f'Whether it exists must be "true" or "false", not {shown(value)}')
    elif test == "in" and not _is_array(value):
        return "bad-value", (f'“Is one of” needs a list such as ["a", "b"], not {shown(value)}')
    return None


def _is_array(text: str) -> bool:
    def refuse(constant: str) -> NoReturn:
        raise ValueError(constant)

    try:
        return isinstance(json.loads(text, parse_constant=refuse), list)
    except (ValueError, RecursionError):
        return False
