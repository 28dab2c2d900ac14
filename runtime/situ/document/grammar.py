"""What the table of ``elements`` is made of: elements, their attributes, and slots for children."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from msgspec import Struct

from situ.document.condition import Group
from situ.document.datatypes import Type


class Misfit(ValueError):
    """What stands in an element makes no value; ``instead`` lets reading go on."""

    def __init__(self, code: str, message: str, instead: object) -> None:
        super().__init__(message)
        self.code = code
        self.instead = instead


class Attribute(Struct, frozen=True):
    """An attribute and the field that holds it.

    required: a file without it is wrong. always: written even where it is the default.
    default: that of the field; None where the element has no value of its own.
    alternative: a file has exactly one of an element's alternatives.
    """

    name: str
    type: Type
    field: str
    required: bool = False
    always: bool = False
    default: object = None
    alternative: bool = False


class Slot(Struct, frozen=True):
    """A place for child elements, held by ``field``; ``many``: a tuple of them.

    misplaced: elements that are read here too, only for ``check`` to say in
    plain words where they belong.
    """

    field: str
    elements: tuple[Element, ...]
    many: bool = False
    misplaced: tuple[Element, ...] = ()

    def element(self, value: object) -> Element:
        """The element as which ``value`` is written here."""
        if len(self.elements) == 1:
            return self.elements[0]
        key = value.kind if isinstance(value, Group) else type(value)
        return next(e for e in (*self.elements, *self.misplaced) if e.key == key)


class Element(Struct, frozen=True, eq=False):
    """An element.

    make: the value's class, or a function with the fields as keywords.
    key: what tells its value from others in one slot.
    text: field and type of the element's text; None: it has none.
    part: it has no value of its own; its fields are those of its parent.
    attributes_of: where given, gives the attributes of a value (those of a test).
    """

    name: str
    make: Callable[..., Any] | None = None
    key: object = None
    attributes: tuple[Attribute, ...] = ()
    text: tuple[str, Type] | None = None
    text_required: bool = False
    slots: tuple[Slot, ...] = ()
    part: bool = False
    attributes_of: Callable[[Any], Iterable[tuple[str, str]]] | None = None


def every(root: Element) -> Iterator[tuple[Element, Element]]:
    """Each element below ``root`` once, with a parent that holds it."""
    seen: set[int] = set()
    waiting = [root]
    while waiting:
        parent = waiting.pop()
        for slot in parent.slots:
            for child in slot.elements:
                yield child, parent
                if id(child) not in seen:
                    seen.add(id(child))
                    waiting.append(child)
