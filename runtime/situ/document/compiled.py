"""The table of elements, compiled for reading: what the loop looks up, in one step each."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from sys import intern
from typing import Any

from situ.document.elements import ROOTS
from situ.document.grammar import Element, Slot, every

Parse = Callable[[str], Any]
Plan = tuple[tuple[str, str, "Known | None"], ...]
"""For start tags with the same attributes: which of them, to which field, read by what.

Attributes whose field has their name and that hold plain text are not in it.
"""

_MOST_PLANS = 200
_MOST_KNOWN = 1024


class Known(dict[str, Any]):
    """Text to value, read where it is not known yet; ValueError where it is none.

    Numbers and words come again and again: looking up is faster than reading.
    """

    def __init__(self, parse: Parse) -> None:
        super().__init__()
        self._parse = parse

    def __missing__(self, text: str) -> Any:
        value = self._parse(text)
        if len(self) < _MOST_KNOWN:
            self[text] = value
        return value


class Rule:
    """An element. field, many: where its parent holds it; they differ by parent.

    many: the fields that hold several values, those of its parts included.
    mark, fresh: of a part, a field of its parent that is there once the part is, and what
    stands in it at first.
    """

    __slots__ = (
        "attributes",
        "blank",
        "children",
        "element",
        "fresh",
        "known_text",
        "make",
        "many",
        "mark",
        "name",
        "part",
        "plans",
        "required",
        "text",
    )

    def __init__(self, element: Element) -> None:
        self.element = element
        self.name = element.name
        self.make = element.make
        self.part = element.part
        self.attributes: dict[str, tuple[str, Known | None]] = {
            one.name: (one.field, _known(one.type.parse)) for one in element.attributes
        }
        self.required = tuple(one.name for one in element.attributes if one.required)
        self.blank = {one.name: one.type.blank for one in element.attributes}
        self.text = element.text[0] if element.text else None
        self.known_text = _known(element.text[1].parse) if element.text else None
        self.children: dict[str, tuple[Rule, str, bool]] = {}
        self.many: tuple[str, ...] = ()
        self.mark = ""
        self.fresh: Callable[[], Any] = str
        self.plans: dict[tuple[str, ...], Plan] = {}

    def plan(self, given: tuple[str, ...]) -> Plan | None:
        """How to read a start tag with these attributes; None: it is not wholly plain.

        Plain: it has every attribute that it needs and none that is unknown or foreign.
        """
        if any(name not in given for name in self.required):
            return None
        made = []
        for name in given:
            known = self.attributes.get(name)
            if known is None:
                return None
            field, parse = known
            if parse is not None or field != name:
                made.append((name, field, parse))
        plan = tuple(made)
        if len(self.plans) < _MOST_PLANS:
            self.plans[given] = plan
        return plan


Frame = tuple[Rule, str, bool, int, dict[str, Any]]
"""An open element: its rule, the parent's field that holds it and whether that holds
many, its place in the file, and the fields of its value so far."""


def _known(parse: Parse | None) -> Known | None:
    return Known(parse) if parse is not None else None


def _compile() -> dict[str, Rule]:
    rules: dict[int, Rule] = {}

    def rule(element: Element) -> Rule:
        found = rules.get(id(element))
        if found is None:
            found = rules[id(element)] = Rule(element)
            for slot in element.slots:
                for child in (*slot.elements, *slot.misplaced):
                    found.children[child.name] = (rule(child), slot.field, slot.many)
            found.many = tuple(slot.field for slot in _with_parts(element) if slot.many)
            if element.part:
                (found.mark,) = _held(element)
                found.fresh = list if found.many else str
        return found

    return {root.name: rule(root) for root in ROOTS}


def _with_parts(element: Element) -> Iterator[Slot]:
    """The slots whose fields the value of an element has."""
    for slot in element.slots:
        if slot.field:
            yield slot
        else:
            yield from _with_parts(slot.elements[0])


def _held(part: Element) -> Iterator[str]:
    """The fields of its parent that a part fills."""
    yield from (slot.field for slot in part.slots)
    yield from (one.field for one in part.attributes)
    if part.text is not None:
        yield part.text[0]


ROOT_RULES = _compile()
"""The rules of the documents, by the name of their first element."""

PARENTS: dict[str, dict[str, str]] = {
    root.name: {child.name: parent.name for child, parent in every(root)} for root in ROOTS
}
"""By document: each element, and one that it may stand in."""

NAMES: dict[str, str] = {
    intern(name): intern(name)
    for root in ROOTS
    for element in (root, *(child for child, _ in every(root)))
    for name in (element.name, *(one.name for one in element.attributes))
}
"""Every name of an element or attribute, to itself: the very string that the fields have,
which is found faster than one that is only equal.
"""
