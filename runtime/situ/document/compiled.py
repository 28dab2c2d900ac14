"""The table of elements, compiled for reading: what the loop looks up, in one step each."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from situ.document.elements import ROOTS, Element, every

Parse = Callable[[str], Any]
Plan = tuple[tuple[str, str, Parse | None], ...]
"""For start tags with the same attributes: which of them, to which field, read by what.

Attributes whose field has their name and that hold plain text are not in it.
"""

_MOST_PLANS = 200


class Rule:
    """An element. field, many: where its parent holds it; they differ by parent."""

    __slots__ = (
        "attributes",
        "blank",
        "children",
        "element",
        "make",
        "many",
        "name",
        "parse_text",
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
        self.attributes: dict[str, tuple[str, Parse | None]] = {
            one.name: (one.field, _cached(one.type.parse)) for one in element.attributes
        }
        self.required = tuple(one.name for one in element.attributes if one.required)
        self.blank = {one.name: one.type.blank for one in element.attributes}
        self.text = element.text[0] if element.text else None
        self.parse_text = _cached(element.text[1].parse) if element.text else None
        self.children: dict[str, tuple[Rule, str, bool]] = {}
        self.many: tuple[str, ...] = ()
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


def _cached(parse: Parse | None) -> Parse | None:
    # Numbers and words come again and again; looking up is faster than reading.
    return lru_cache(1024)(parse) if parse is not None else None


def _compile() -> dict[str, Rule]:
    rules: dict[int, Rule] = {}

    def rule(element: Element) -> Rule:
        found = rules.get(id(element))
        if found is None:
            found = rules[id(element)] = Rule(element)
            for slot in element.slots:
                for child in (*slot.elements, *slot.misplaced):
                    found.children[child.name] = (rule(child), slot.field, slot.many)
            found.many = tuple(slot.field for slot in element.slots if slot.many)
        return found

    return {root.name: rule(root) for root in ROOTS}


ROOT_RULES = _compile()
"""The rules of the documents, by the name of their first element."""

PARENTS: dict[str, dict[str, str]] = {
    root.name: {child.name: parent.name for child, parent in every(root)} for root in ROOTS
}
"""By document: each element, and one that it may stand in."""
