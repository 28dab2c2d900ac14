"""What rides along with an element outside of equality (architecture, idea 1).

Comments, foreign elements and attributes, positions on the canvas, and where
the element stood in its file. Two documents that differ only in this are
equal; the writer puts all of it back where it was.
"""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

EDITOR = "urn:situ:editor"
"""The namespace of editor-only data (prefix ``ed``); export strips it."""


class Aside(Struct, frozen=True, gc=False, eq=False):
    """Equal to every other ``Aside``.

    index: the element's place in its file, counting start tags from 0; -1 for
        one that was never in a file. Line and column follow from it
        (``situ.document.codec.locate``).
    before: comments, processing instructions and foreign elements that stand
        before the element, as XML text.
    inside: the same, standing before the element's end tag.
    after: the same, standing after the root element; empty elsewhere.
    attributes: attributes of foreign namespaces, ``ed`` included, as
        ``("{namespace}name", value)`` in the order written.
    parts: the asides of child elements that have no value of their own
        (``components``, ``backgroundactions``, ``expectedevents`` …), where something rides
        along with them, and that of ``flow``, for its place.
    """

    index: int = -1
    before: tuple[str, ...] = ()
    inside: tuple[str, ...] = ()
    after: tuple[str, ...] = ()
    attributes: tuple[tuple[str, str], ...] = ()
    parts: tuple[tuple[str, Aside], ...] = ()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Aside)

    def __hash__(self) -> int:
        return 0

    def part(self, name: str) -> Aside:
        """The aside of the child element ``name``; an empty one if there is none."""
        for key, aside in self.parts:
            if key == name:
                return aside
        return NOTHING

    def attribute(self, name: str, namespace: str = EDITOR) -> str | None:
        """An attribute of a foreign namespace, or None."""
        wanted = f"{{{namespace}}}{name}"
        for key, value in self.attributes:
            if key == wanted:
                return value
        return None

    def with_attribute(self, name: str, value: str | None, namespace: str = EDITOR) -> Aside:
        """A copy with the attribute set in place, added at the end, or (None) removed."""
        wanted = f"{{{namespace}}}{name}"
        kept = [(k, v) for k, v in self.attributes if value is not None or k != wanted]
        if value is not None:
            if any(k == wanted for k, _ in kept):
                kept = [(k, value if k == wanted else v) for k, v in kept]
            else:
                kept.append((wanted, value))
        return replace(self, attributes=tuple(kept))

    @property
    def position(self) -> tuple[float, float] | None:
        """``ed:x`` and ``ed:y`` in scene units; None where either is missing or no number."""
        try:
            return float(self.attribute("x") or ""), float(self.attribute("y") or "")
        except ValueError:
            return None

    def at(self, x: float, y: float) -> Aside:
        """A copy at this place of the canvas, in scene units, rounded to a tenth."""
        return self.with_attribute("x", f"{round(x, 1):g}").with_attribute("y", f"{round(y, 1):g}")


NOTHING = Aside()
