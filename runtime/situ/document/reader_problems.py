"""What reading finds wrong with a file: in plain words, and with its place."""

from __future__ import annotations

from collections.abc import Collection
from difflib import get_close_matches
from typing import NamedTuple
from xml.parsers import expat

from situ.document.compiled import Frame
from situ.document.locate import locate_all
from situ.document.problem import Problem

MAX_PROBLEMS = 100

_BROKEN = {
    "not well-formed (invalid token)": (
        "Something stands here that XML does not allow: write &lt; for < and &amp; for & in "
        "texts, and look for a quote or a > that is missing before"
    ),
    "duplicate attribute": "The same attribute stands twice in this tag: take one out",
    "junk after document element": (
        "Something stands behind the end of the document: take it out, or move it inside"
    ),
    "unclosed token": "This < is never closed: finish the tag with >",
    "unclosed CDATA section": "This <![CDATA[ is never closed: finish it with ]]>",
    "XML or text declaration not at start of entity": (
        "<?xml …?> may stand only at the very beginning: take out what is before it"
    ),
}
"""What expat says, in plain words with what to do."""


class Found(NamedTuple):
    """Something wrong, at a line and column, or where an element is (``Aside.index``)."""

    code: str
    message: str
    line: int
    column: int
    element: int | None = None
    place: tuple[str, ...] = ()


class Stop(Exception):
    """Reading ends here; what is wrong is noted."""


class Findings:
    """What is wrong with one file. open: the elements that are open, innermost last."""

    def __init__(self, parser: expat.XMLParserType, open: list[Frame]) -> None:
        self.found: list[Found] = []
        self._parser = parser
        self._open = open

    def problem(self, code: str, message: str, index: int | None = None) -> None:
        """Notes a problem; its place is the element ``index``, or where the parser stands.

        Raises ``Stop`` where there are too many.
        """
        line = column = 0
        if index is None:
            line = self._parser.CurrentLineNumber
            column = self._parser.CurrentColumnNumber + 1
        self.found.append(Found(code, message, line, column, index, self.place()))
        if len(self.found) >= MAX_PROBLEMS:
            raise Stop

    def place(self) -> tuple[str, ...]:
        """The state, situation or module in which reading stands."""
        for rule, _, _, _, values in self._open[2:]:
            if rule.name == "state":
                return ("state", str(values.get("no", "")))
            if rule.name == "always":
                return ("always",)
            if rule.name == "situation" or (rule.name == "module" and not rule.part):
                return (rule.name, str(values.get("name", "")))
        return ()

    def problems(self, data: bytes, file: str) -> list[Problem]:
        """What was found in ``data``, each with line and column, in the order of the file."""
        places = locate_all(data, {one.element for one in self.found if one.element is not None})
        made = []
        for code, message, line, column, element, place in self.found:
            if element is not None:
                line, column = places.get(element, (1, 1))
            made.append(
                Problem(
                    file=file, line=line, column=column, code=code, message=message, place=place
                )
            )
        return sorted(made, key=lambda p: (p.line, p.column))


def not_text(data: bytes) -> Found | None:
    """Where bytes are not UTF-8 without NUL; expat would take some others for UTF-16."""
    try:
        data.decode()
        at = data.find(0)
        said = "A NUL character stands here: no XML file may hold one"
    except UnicodeDecodeError as wrong:
        at = wrong.start
        said = "The file is not UTF-8 here: save it as UTF-8"
    if at < 0:
        return None
    before = data[:at]
    line = before.count(b"\n") + 1
    column = len(before[before.rfind(b"\n") + 1 :].decode()) + 1
    return Found("malformed-xml", said, line, column)


def malformed(error: expat.ExpatError, data: bytes, name: str, place: tuple[str, ...]) -> Found:
    """What broke the XML. name: of the innermost element that is still open, or empty."""
    words = expat.errors.messages.get(error.code, "not well-formed")
    said = _BROKEN.get(words, f"The XML is broken here: {words}")
    if not data.strip():
        said = "The file is empty"
    elif name and "no element" in words:
        said = f"The file ends inside <{name}>: its end tag is missing"
    elif name and "mismatched" in words:
        said = f"This end tag does not fit: <{name}> is still open"
    elif "undefined entity" in words:
        said = "Only &amp; &lt; &gt; &quot; &apos; and numbers such as &#233; may follow &"
    return Found("malformed-xml", said, error.lineno, error.offset + 1, place=place)


def nearest(name: str, known: Collection[str]) -> str:
    """The known name most like ``name``; case does not count."""
    lower = {one.lower(): one for one in known}
    return lower[get_close_matches(name[:40].lower(), lower, n=1, cutoff=0.0)[0]]
