"""Values to XML, canonical: one order, one indentation, UTF-8, ``\\n``.

Every element stands on a line of its own, so that a change of one field is a
change of one line. What rides along (``situ.document.aside``) is written beside
the element it stood at; namespaces are declared at the root.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any

from situ.document.aside import EDITOR, Aside
from situ.document.elements import ROOTS
from situ.document.grammar import Element

_Write = Callable[[Any], str]

XMLNS = "http://www.w3.org/2000/xmlns/"
"""The namespace of namespace declarations; the root's aside holds the file's."""
XML = "http://www.w3.org/XML/1998/namespace"

_TEXT = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", "\r": "&#13;"})
ATTRIBUTE = str.maketrans(
    {"&": "&amp;", "<": "&lt;", '"': "&quot;", "\n": "&#10;", "\r": "&#13;", "\t": "&#9;"}
)
_SINGLE = {key: text for key, text in ATTRIBUTE.items() if key != ord('"')}
_IMPOSSIBLE = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_OPENING = re.compile(r"<([^\s/>!?]+)((?:\s+xmlns(?::[^\s=]+)?=(?:\"[^\"]*\"|'[^']*'))*)")
_DECLARATION = re.compile(r"\s+(xmlns(?::[^\s=]+)?)=(?:\"([^\"]*)\"|'([^']*)')")


def write(document: object) -> bytes:
    """The canonical file of an Application, Spds or Modules.

    Characters that XML cannot hold are written as U+FFFD. TypeError for
    anything that is no document.
    """
    for root in ROOTS:
        if type(document) is root.key:
            break
    else:
        raise TypeError(f"not a document: {type(document).__name__}")
    aside: Aside = document.aside  # type: ignore[attr-defined]
    prefixes = _Prefixes(aside)
    out: list[str] = []
    _element(out, root, document, "", prefixes)
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', *out, *aside.after]
    return _IMPOSSIBLE.sub("\ufffd", "\n".join(lines) + "\n").encode()


class _Prefixes:
    """Which prefix stands for which namespace in the file being written."""

    def __init__(self, root: Aside) -> None:
        self._bound: dict[str, str] = {}
        self._of: dict[str, str] = {XML: "xml"}
        for key, uri in root.attributes:
            space, _, prefix = key[1:].rpartition("}")
            if space == XMLNS and prefix not in self._bound:
                self._bound[prefix] = uri
                self._of.setdefault(uri, prefix)

    def of(self, uri: str) -> str:
        """The prefix of a namespace; bound now if it was not."""
        found = self._of.get(uri)
        if found is None:
            found = "ed" if uri == EDITOR and "ed" not in self._bound else ""
            number = 1
            while not found:
                if f"ns{number}" not in self._bound:
                    found = f"ns{number}"
                number += 1
            self._bound[found] = uri
            self._of[uri] = found
        return found

    def declarations(self) -> str:
        return "".join(
            f' xmlns:{prefix}="{uri.translate(ATTRIBUTE)}"' for prefix, uri in self._bound.items()
        )

    def fragment(self, text: str) -> str:
        """Foreign XML with those of its declarations left out that the root makes."""
        opening = _OPENING.match(text)
        if opening is None:
            return text
        if opening[1].startswith("ed:") and "xmlns:ed=" not in opening[2]:
            self.of(EDITOR)
        kept = []
        for declaration in _DECLARATION.finditer(opening[2]):
            name, uri = declaration[1], declaration[2] or declaration[3] or ""
            prefix = name[6:]
            if prefix and prefix not in self._bound:
                self._bound[prefix] = uri
                self._of.setdefault(uri, prefix)
            if not prefix or self._bound[prefix] != uri:
                kept.append(declaration[0])
        return f"<{opening[1]}{''.join(kept)}{text[opening.end() :]}"


def _element(
    out: list[str], element: Element, value: Any, indent: str, prefixes: _Prefixes
) -> None:
    aside: Aside = value.aside
    if aside.before:
        out += [indent + prefixes.fragment(fragment) for fragment in aside.before]
    _tagged(out, element, value, aside, indent, prefixes)


def _quoted(text: str) -> str:
    """An attribute's value in the quotes that need the fewest escapes (JSON has many ``"``)."""
    if text.isalnum():
        return f'"{text}"'
    if '"' in text and "'" not in text:
        return f"'{text.translate(_SINGLE)}'"
    return f'"{text.translate(ATTRIBUTE)}"'


@cache
def _attributes(element: Element) -> tuple[tuple[str, str, object, bool, _Write | None], ...]:
    """Of each attribute: the start of its text, its field, the default and whether it is written
    nevertheless, and how.
    """
    return tuple(
        (f" {one.name}=", one.field, one.default, one.required or one.always, one.type.write)
        for one in element.attributes
    )


def _tagged(
    out: list[str], element: Element, value: Any, aside: Aside, indent: str, prefixes: _Prefixes
) -> None:
    start = [indent, "<", element.name]
    if element.attributes_of is not None:
        start += [f" {name}={_quoted(text)}" for name, text in element.attributes_of(value)]
    else:
        for name, field, default, always, write in _attributes(element):
            held = getattr(value, field)
            if held != default or (always and held is not None):
                start += (name, _quoted(held if write is None else write(held)))
    own = len(start)
    for key, text in aside.attributes:
        space, _, name = key[1:].rpartition("}")
        if space != XMLNS:
            start.append(f" {prefixes.of(space)}:{name}={_quoted(text)}")
    text = ""
    if element.text is not None:
        field, kind = element.text
        written = getattr(value, field)
        text = written if kind.write is None else kind.write(written)
        if not text.isalnum():
            text = text.translate(_TEXT)
    inner: list[str] = []
    for slot in element.slots:
        children: Any = getattr(value, slot.field) if slot.field else None
        if not slot.field:
            _part(inner, slot.elements[0], value, aside, indent + "  ", prefixes)
        elif slot.many:
            for child in children:
                _element(inner, slot.element(child), child, indent + "  ", prefixes)
        elif children is not None:
            _element(inner, slot.element(children), children, indent + "  ", prefixes)
    if aside.inside:
        inside = [prefixes.fragment(fragment) for fragment in aside.inside]
        if not element.slots:
            # White space would become part of the text: what stood in it follows it directly.
            text += "".join(inside)
        else:
            inner += [f"{indent}  {fragment}" for fragment in inside]
    if not indent:
        start.insert(own, prefixes.declarations())
    if inner:
        out.append("".join(start) + ">" + text)
        out += inner
        out.append(f"{indent}</{element.name}>")
    elif text:
        out.append(f"{''.join(start)}>{text}</{element.name}>")
    else:
        out.append("".join(start) + "/>")


def _part(
    out: list[str], element: Element, value: Any, aside: Aside, indent: str, prefixes: _Prefixes
) -> None:
    """An element whose content is held by its parent: written where there is any."""
    own = aside.part(element.name)
    held = [getattr(value, slot.field) for slot in element.slots]
    held += [getattr(value, one.field) for one in element.attributes]
    if element.text is not None:
        held.append(getattr(value, element.text[0]))
    empty = not any(one is not None and one not in ((), "") for one in held)
    out += [indent + prefixes.fragment(fragment) for fragment in own.before]
    if empty and (element.attributes or not (own.inside or own.attributes)):
        return
    _tagged(out, element, value, own, indent, prefixes)
