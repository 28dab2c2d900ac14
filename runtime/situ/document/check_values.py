"""What can be said of single values: the rules of the table, and conditions.

One walk over a document, driven by ``situ.document.elements``; it also makes
the place of each value, as the editor's selection names it.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NoReturn

from situ.document import names
from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import shown
from situ.document.elements import ROOTS, Element, Slot
from situ.document.finding import Findings, Place

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

_Rule = tuple[str, str, Callable[[Any], str | None], str]


class _Look:
    """An element, compiled: its rules and the fields in which its children are."""

    __slots__ = ("children", "rules")

    def __init__(self) -> None:
        self.rules: list[_Rule] = []
        self.children: list[tuple[str, Slot, str, str]] = []


def _compile() -> dict[int, _Look]:
    looks: dict[int, _Look] = {}

    def rules(element: Element) -> list[_Rule]:
        found: list[_Rule] = []
        for one in element.attributes:
            rule = one.type.rule
            if rule is not None:
                said = f"The {one.name} of <{element.name}>"
                found.append((one.field, said, lru_cache(4096)(rule), one.type.code))
        if element.text is not None and element.text[1].rule is not None:
            kind = element.text[1]
            assert kind.rule is not None
            found.append(
                (element.text[0], f"<{element.name}>", lru_cache(4096)(kind.rule), kind.code)
            )
        return found

    def look(element: Element) -> None:
        if id(element) in looks:
            return
        made = looks[id(element)] = _Look()
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
        for _, slot, _, _ in made.children:
            for child in (*slot.elements, *slot.misplaced):
                look(child)

    for root in ROOTS:
        look(root)
    return looks


_LOOKS = _compile()


def check_values(found: Findings, document: Any) -> None:
    """Tells what is wrong with any one value of a document, wherever it stands."""
    root = next(element for element in ROOTS if element.key is type(document))
    _visit(found, root, document, (), root.name == "spds")


def _visit(found: Findings, element: Element, value: Any, place: Place, script: bool) -> None:
    look = _LOOKS[id(element)]
    if value.aside.attributes:
        found.accepts.note(place, value.aside)
    for field, said, rule, code in look.rules:
        held = getattr(value, field)
        if held is not None:
            wrong = rule(held)
            if wrong is not None:
                found.error(code, f"{said} {wrong}", value.aside, place)
    for field, slot, word, key in look.children:
        held = getattr(value, field)
        if not slot.many:
            if held is not None:
                _visit(found, slot.element(held), held, (*place, word), script)
            continue
        for index, child in enumerate(held):
            name = str(getattr(child, key)) if key else str(index)
            inner = (*place, word, name) if word else (*place, name)
            _visit(found, slot.element(child), child, inner, script)
    kind = type(value)
    if kind is Test:
        _test(found, value, place, script)
    elif (kind is Condition or kind is Group) and not value.children:
        said = f"<{element.name}> is empty: put a <data> into it, or take it out"
        found.error("empty-condition", said, value.aside, place)


def _test(found: Findings, test: Test, place: Place, script: bool) -> None:
    if names.only_reference(test.value) is not None:
        if script:
            said = (
                f"A script compares with what is written, not with a reference: {shown(test.value)}"
            )
            found.error("reference-in-script", said, test.aside, place)
        return
    if test.test == "exists" and test.value not in ("true", "false"):
        said = f'The exists of <data> must be "true" or "false", not {shown(test.value)}'
        found.error("bad-value", said, test.aside, place)
    elif test.test == "in" and not _is_array(test.value):
        said = f'The in of <data> must be a JSON array such as ["a", "b"], not {shown(test.value)}'
        found.error("bad-value", said, test.aside, place)


def _is_array(text: str) -> bool:
    def refuse(constant: str) -> NoReturn:
        raise ValueError(constant)

    try:
        return isinstance(json.loads(text, parse_constant=refuse), list)
    except (ValueError, RecursionError):
        return False
