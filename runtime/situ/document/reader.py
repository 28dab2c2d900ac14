"""XML to values: one pass of expat that makes each value where its element ends.

A file is data from anywhere: no DOCTYPE, no entities, nothing is fetched, and
depth, number and size of what it holds are bounded. Whatever is wrong becomes a
problem with its place. The table (``situ.document.elements``) is compiled into
one ``_Rule`` an element, so that the loop looks up nothing twice.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Any
from xml.parsers import expat

from msgspec.structs import replace

from situ.document.aside import EDITOR, Aside
from situ.document.datatypes import WHITE, shown
from situ.document.elements import ROOTS, Element, Misfit, every
from situ.document.problem import Problem
from situ.document.writer import ATTRIBUTE, XML, XMLNS

MAX_BYTES = 64_000_000
MAX_DEPTH = 200
MAX_ELEMENTS = 400_000
MAX_TEXT = 1_000_000
MAX_PROBLEMS = 100

_START_TAG = re.compile(rb"<[^\s/>]+(?:\s+[^\s=]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*\s*/?>")


class _Rule:
    """An element, compiled: what to look up while reading it."""

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
        "required",
        "text",
    )

    def __init__(self, element: Element) -> None:
        self.element = element
        self.name = element.name
        self.make = element.make
        self.part = element.part
        self.attributes: dict[str, tuple[str, Callable[[str], Any] | None]] = {
            one.name: (one.field, one.type.parse) for one in element.attributes
        }
        self.required = frozenset(one.field for one in element.attributes if one.required)
        self.blank = {one.field: one.type.blank for one in element.attributes}
        self.text = element.text[0] if element.text else None
        self.parse_text = element.text[1].parse if element.text else None
        self.children: dict[str, tuple[_Rule, str, bool]] = {}
        self.many: tuple[str, ...] = ()


def _compile() -> dict[str, _Rule]:
    rules: dict[int, _Rule] = {}

    def rule(element: Element) -> _Rule:
        found = rules.get(id(element))
        if found is None:
            found = rules[id(element)] = _Rule(element)
            for slot in element.slots:
                for child in (*slot.elements, *slot.misplaced):
                    found.children[child.name] = (rule(child), slot.field, slot.many)
            found.many = tuple(slot.field for slot in element.slots if slot.many)
        return found

    return {root.name: rule(root) for root in ROOTS}


_ROOTS = _compile()
_PARENTS: dict[str, dict[str, str]] = {
    root.name: {child.name: parent.name for child, parent in every(root)} for root in ROOTS
}


class _Stop(Exception):
    """Reading ends here; the problem is noted."""


class _Frame:
    """An element whose end has not been read yet."""

    __slots__ = (
        "attributes",
        "before",
        "bound",
        "field",
        "index",
        "many",
        "parts",
        "rule",
        "texts",
        "values",
    )

    def __init__(
        self, rule: _Rule, field: str, many: bool, index: int, before: tuple[str, ...]
    ) -> None:
        self.rule = rule
        self.field = field
        self.many = many
        self.index = index
        self.before = before
        self.values: dict[str, Any] = {}
        self.texts: list[str] = []
        self.attributes: tuple[tuple[str, str], ...] = ()
        self.bound: dict[str, str] | None = None
        self.parts: tuple[tuple[str, Aside], ...] = ()


def read(data: bytes, file: str) -> tuple[Any, list[Problem]]:
    """The document in ``data``, or None where there is none, and what is wrong with it.

    A document that comes with errors lacks what they name; it is good for
    showing and checking more of it, and must not be saved over the file. ``file``
    is what problems call it.
    """
    reading = _Reading(data, file)
    return reading.run()


class _Reading:
    def __init__(self, data: bytes, file: str) -> None:
        self.data = data
        self.file = file
        self.found: list[tuple[int, int, int, str, str, tuple[str, ...]]] = []
        self.index = -1
        self.stack: list[_Frame] = []
        self.pending: list[str] = []
        self.document: Any = None
        self.declared: list[tuple[str, str]] = []
        self.root_name = ""
        self.parser = expat.ParserCreate("utf-8")

    # -- problems ------------------------------------------------------------

    def problem(self, code: str, message: str, index: int | None = None) -> None:
        """Notes a problem; its place is the element ``index``, or where the parser stands."""
        line = column = 0
        if index is None:
            line = self.parser.CurrentLineNumber
            column = self.parser.CurrentColumnNumber + 1
        self.found.append(
            (-1 if index is None else index, line, column, code, message, self.place())
        )
        if len(self.found) >= MAX_PROBLEMS:
            raise _Stop

    def place(self) -> tuple[str, ...]:
        for frame in self.stack:
            name, values = frame.rule.name, frame.values
            if name == "state":
                return ("state", str(values.get("no", "")))
            if name == "always" and len(self.stack) > 1:
                return ("always",)
            if name == "situation":
                return ("situation", str(values.get("name", "")))
            if name == "module" and frame.rule.make is not None:
                return ("module", str(values.get("name", "")))
        return ()

    def problems(self) -> list[Problem]:
        places = locate_all(self.data, {index for index, *_ in self.found if index >= 0})
        made = []
        for index, line, column, code, message, place in self.found:
            if index >= 0:
                line, column = places.get(index, (0, 0))
            made.append(
                Problem(
                    file=self.file,
                    line=line,
                    column=column,
                    code=code,
                    message=message,
                    place=place,
                )
            )
        return sorted(made, key=lambda p: (p.line, p.column))

    # -- the pass ------------------------------------------------------------

    def run(self) -> tuple[Any, list[Problem]]:
        if len(self.data) > MAX_BYTES:
            self.problem("too-large", f"The file is larger than {MAX_BYTES // 1_000_000} MB", 0)
            return None, self.problems()
        if not self.is_text():
            return None, self.problems()
        parser = self.parser
        parser.buffer_text = True
        parser.StartElementHandler = self.start
        parser.EndElementHandler = self.end
        parser.CharacterDataHandler = self.text
        parser.CommentHandler = self.comment
        parser.ProcessingInstructionHandler = self.instruction
        parser.XmlDeclHandler = self.declaration
        parser.StartDoctypeDeclHandler = self.doctype
        try:
            parser.Parse(self.data, True)
        except _Stop:
            self.document = None
        except expat.ExpatError as error:
            self.document = None
            self.malformed(error)
        if self.document is not None and (self.pending or self.declared):
            self.complete()
        return self.document, self.problems() if self.found else []

    def complete(self) -> None:
        """Gives the root what stands after it, and the namespaces declared anywhere."""
        aside: Aside = self.document.aside
        declared = tuple((f"{{{XMLNS}}}{prefix}", uri) for prefix, uri in self.declared)
        aside = replace(aside, after=tuple(self.pending), attributes=(*aside.attributes, *declared))
        self.document = replace(self.document, aside=aside)

    def is_text(self) -> bool:
        """Whether the bytes are UTF-8 without NUL; expat would take some others for UTF-16."""
        try:
            self.data.decode()
            at = self.data.find(0)
            said = "A NUL character stands here: no XML file may hold one"
        except UnicodeDecodeError as wrong:
            at = wrong.start
            said = "The file is not UTF-8 here: save it as UTF-8"
        if at < 0:
            return True
        before = self.data[:at]
        line = before.count(b"\n") + 1
        column = len(before[before.rfind(b"\n") + 1 :].decode()) + 1
        self.found.append((-1, line, column, "malformed-xml", said, ()))
        return False

    def malformed(self, error: expat.ExpatError) -> None:
        words = expat.errors.messages.get(error.code, "not well-formed")
        said = f"This is no well-formed XML here: {words}"
        if not self.data.strip():
            said = "The file is empty"
        elif self.stack and "no element" in words:
            said = f"The file ends inside <{self.stack[-1].rule.name}>: its end tag is missing"
        elif self.stack and "mismatched" in words:
            said = f"This end tag does not fit: <{self.stack[-1].rule.name}> is still open"
        elif "undefined entity" in words:
            said = "Only &amp; &lt; &gt; &quot; &apos; and numbers such as &#233; may follow &"
        place = self.place()
        self.found.append((-1, error.lineno, error.offset + 1, "malformed-xml", said, place))

    def declaration(self, _version: str, encoding: str | None, _standalone: int) -> None:
        if encoding is not None and encoding.lower() not in ("utf-8", "utf8", "us-ascii"):
            self.problem(
                "not-utf-8", f"The file says that it is {shown(encoding)}: save it as UTF-8"
            )
            raise _Stop

    def doctype(self, *_: object) -> None:
        self.problem("doctype", "A DOCTYPE is not allowed: take it out")
        raise _Stop

    def comment(self, text: str) -> None:
        self.pending.append(f"<!--{text}-->")

    def instruction(self, target: str, text: str) -> None:
        self.pending.append(f"<?{target} {text}?>" if text else f"<?{target}?>")

    def text(self, text: str) -> None:
        frame = self.stack[-1]
        if frame.rule.text is not None:
            frame.texts.append(text)
        elif not text.isspace():
            self.problem(
                "unexpected-text",
                f"Text cannot stand directly in <{frame.rule.name}>: {shown(text)}",
                frame.index,
            )

    def start(self, name: str, given: dict[str, str]) -> None:
        self.index = index = self.index + 1
        stack = self.stack
        if stack:
            parent = stack[-1]
            known = parent.rule.children.get(name)
            if known is None:
                self.stranger(name, given)
                return
            rule, field, many = known
            if not many and (field in parent.values or (rule.part and _has(parent, name))):
                self.problem(
                    "duplicate-element",
                    f"<{parent.rule.name}> holds two <{name}>: only one may stand here",
                )
        else:
            rule, field, many = self.root(name), "", False
        pending = self.pending
        before: tuple[str, ...] = ()
        if pending:
            before = tuple(pending)
            pending.clear()
        frame = _Frame(rule, field, many, index, before)
        stack.append(frame)
        values, attributes = frame.values, rule.attributes
        try:
            for key, text in given.items():
                at, parse = attributes[key]
                values[at] = text if parse is None else parse(text)
                if len(text) > MAX_TEXT:
                    raise ValueError("is too long")
            if rule.required <= values.keys() and len(stack) <= MAX_DEPTH and index < MAX_ELEMENTS:
                return
        except (KeyError, ValueError):
            pass
        self.mend(frame, given)

    def end(self, _name: str) -> None:
        stack, pending = self.stack, self.pending
        frame = stack.pop()
        rule, values = frame.rule, frame.values
        inside: tuple[str, ...] = ()
        if pending:
            inside = tuple(pending)
            pending.clear()
        if rule.text is not None:
            self.texts(frame)
        for field in rule.many:
            if field in values:
                values[field] = tuple(values[field])
        aside = Aside(frame.index, frame.before, inside, (), frame.attributes, frame.parts)
        if rule.part:
            parent = stack[-1]
            parent.values.update(values)
            parent.parts = (*parent.parts, (rule.name, aside))
            return
        make = rule.make
        assert make is not None
        try:
            value = make(aside=aside, **values)
        except Misfit as wrong:
            stack.append(frame)
            self.problem(wrong.code, str(wrong), frame.index)
            stack.pop()
            value = wrong.instead
        if not stack:
            self.document = value
            return
        parent_values = stack[-1].values
        if frame.many:
            if frame.field in parent_values:
                parent_values[frame.field].append(value)
            else:
                parent_values[frame.field] = [value]
        else:
            parent_values[frame.field] = value

    def texts(self, frame: _Frame) -> None:
        rule = frame.rule
        assert rule.text is not None
        text = "".join(frame.texts).strip(WHITE)
        if len(text) > MAX_TEXT:
            self.problem("too-long", f"The text of <{rule.name}> is too long", frame.index)
            text = ""
        if not text and not rule.element.text_required:
            return
        if rule.parse_text is None:
            frame.values[rule.text] = text
            return
        try:
            frame.values[rule.text] = rule.parse_text(text)
        except ValueError as wrong:
            said = f"The text of <{rule.name}> {wrong}"
            if not text:
                said = f"<{rule.name}> is empty: write a number"
            self.stack.append(frame)
            self.problem("bad-value", said, frame.index)
            self.stack.pop()
            assert rule.element.text is not None
            frame.values[rule.text] = rule.element.text[1].blank

    # -- what is seldom ------------------------------------------------------

    def root(self, name: str) -> _Rule:
        self.root_name = name
        rule = _ROOTS.get(name)
        if rule is None:
            near = _nearest(name, _ROOTS)
            self.problem(
                "unknown-element",
                f"<{_short(name)}> is no document of Situ; did you mean <{near}>?",
            )
            raise _Stop
        return rule

    def mend(self, frame: _Frame, given: Mapping[str, str]) -> None:
        """The long way through a start tag that is not wholly plain."""
        rule, stack = frame.rule, self.stack
        if len(stack) > MAX_DEPTH:
            self.problem("too-deep", f"Elements stand more than {MAX_DEPTH} deep")
            raise _Stop
        if frame.index >= MAX_ELEMENTS:
            self.problem("too-many", f"The file holds more than {MAX_ELEMENTS} elements")
            raise _Stop
        frame.bound = self.declare(given)
        if given.get("xmlns"):
            self.problem(
                "unknown-namespace",
                f"<{rule.name}> must have no namespace: take the xmlns attribute out",
            )
            raise _Stop
        frame.values.clear()
        foreign: list[tuple[str, str]] = []
        for key, text in given.items():
            if key == "xmlns" or key.startswith("xmlns:"):
                continue
            known = rule.attributes.get(key)
            if len(text) > MAX_TEXT:
                self.problem("too-long", f'The attribute "{_short(key)}" is too long')
                if known is not None:
                    frame.values[known[0]] = rule.blank[known[0]]
            elif known is not None:
                field, parse = known
                try:
                    frame.values[field] = text if parse is None else parse(text)
                except ValueError as wrong:
                    self.problem("bad-value", f"The {key} of <{rule.name}> {wrong}")
                    if field in rule.required:
                        frame.values[field] = rule.blank[field]
            elif ":" in key:
                prefix, _, local = key.partition(":")
                foreign.append((f"{{{self.bound(prefix)}}}{local}", text))
            else:
                self.unknown_attribute(rule, key)
        frame.attributes = tuple(foreign)
        for one in rule.element.attributes:
            if one.required and one.field not in frame.values:
                self.problem("missing-attribute", f'<{rule.name}> needs the attribute "{one.name}"')
                frame.values[one.field] = one.type.blank

    def unknown_attribute(self, rule: _Rule, key: str) -> None:
        said = f'<{rule.name}> has no attribute "{_short(key)}"'
        if rule.attributes:
            said += f'; did you mean "{_nearest(key, rule.attributes)}"?'
        self.problem("unknown-attribute", said)

    def stranger(self, name: str, given: dict[str, str]) -> None:
        """An element that has no place here: foreign, or unknown."""
        parent = self.stack[-1].rule
        foreign = bool(given.get("xmlns")) or ":" in name
        if not foreign:
            belongs = _PARENTS[self.root_name].get(name)
            if belongs is not None and belongs != parent.name:
                code = "misplaced-element"
                said = f"<{name}> has no place in <{parent.name}>: it belongs in <{belongs}>"
            else:
                code = "unknown-element"
                said = f"<{_short(name)}> is not known in <{parent.name}>"
                if parent.children:
                    said += f"; did you mean <{_nearest(name, parent.children)}>?"
                else:
                    said += ": nothing can stand in it"
            self.problem(code, said)
        _Foreign(self, keep=foreign).start(name, given)

    def declare(self, given: Mapping[str, str]) -> dict[str, str] | None:
        """The namespaces that a start tag declares, taken note of for the root."""
        found = {key[6:]: uri for key, uri in given.items() if key.startswith("xmlns:")}
        for one in found.items():
            if one not in self.declared:
                self.declared.append(one)
        return found or None

    def bound(self, prefix: str) -> str:
        """The namespace of a prefix where the parser stands."""
        for frame in reversed(self.stack):
            if frame.bound is not None and prefix in frame.bound:
                return frame.bound[prefix]
        if prefix == "xml":
            return XML
        said = f'The prefix "{_short(prefix)}" is not declared'
        if prefix == "ed":
            said += f': add xmlns:ed="{EDITOR}" to the first element'
        self.problem("malformed-xml", said)
        raise _Stop


class _Foreign:
    """Reads past an element that is not ours; keeps its text where it has a namespace."""

    def __init__(self, reading: _Reading, *, keep: bool) -> None:
        self.reading = reading
        self.keep = keep
        self.scopes: list[dict[str, str]] = []
        self.own: dict[str, str] = {}
        self.needed: dict[str, str] = {}
        parser = reading.parser
        self.at = parser.CurrentByteIndex
        reading.index -= 1
        parser.StartElementHandler = self.start
        parser.EndElementHandler = self.end
        parser.CharacterDataHandler = None
        parser.CommentHandler = None
        parser.ProcessingInstructionHandler = None

    def start(self, name: str, given: dict[str, str]) -> None:
        reading = self.reading
        reading.index += 1
        if len(self.scopes) + len(reading.stack) >= MAX_DEPTH:
            reading.problem("too-deep", f"Elements stand more than {MAX_DEPTH} deep")
            raise _Stop
        if reading.index >= MAX_ELEMENTS:
            reading.problem("too-many", f"The file holds more than {MAX_ELEMENTS} elements")
            raise _Stop
        scope = {key[6:]: uri for key, uri in given.items() if key.startswith("xmlns:")}
        if not self.scopes:
            self.own = scope
        self.scopes.append(scope)
        if self.keep:
            for used in (name, *given):
                prefix, colon, _ = used.partition(":")
                if colon and prefix not in ("xml", "xmlns"):
                    self.use(prefix)

    def use(self, prefix: str) -> None:
        if prefix not in self.needed and not any(prefix in scope for scope in self.scopes):
            self.needed[prefix] = self.reading.bound(prefix)

    def end(self, _name: str) -> None:
        self.scopes.pop()
        if self.scopes:
            return
        reading, parser = self.reading, self.reading.parser
        if self.keep:
            reading.pending.append(self.fragment(parser.CurrentByteIndex))
        parser.StartElementHandler = reading.start
        parser.EndElementHandler = reading.end
        parser.CharacterDataHandler = reading.text
        parser.CommentHandler = reading.comment
        parser.ProcessingInstructionHandler = reading.instruction

    def fragment(self, end: int) -> str:
        """The element as text that stands for itself: every prefix it uses is declared in it."""
        data = self.reading.data
        match = _START_TAG.match(data, self.at)
        assert match is not None
        empty = match[0].endswith(b"/>")
        stop = match.end() if empty else data.index(b">", end) + 1
        text = data[self.at : stop].decode().replace("\r\n", "\n").replace("\r", "\n")
        if not self.needed:
            return text
        name = re.match(r"<[^\s/>]+", text)
        assert name is not None
        added = "".join(
            f' xmlns:{prefix}="{uri.translate(ATTRIBUTE)}"' for prefix, uri in self.needed.items()
        )
        return name[0] + added + text[name.end() :]


def locate_all(data: bytes, indices: set[int]) -> dict[int, tuple[int, int]]:
    """Line and column, from 1, of the elements with these places in the file (``Aside.index``)."""
    found: dict[int, tuple[int, int]] = {}
    if not indices:
        return found
    last = max(indices)
    count = -1
    parser = expat.ParserCreate("utf-8")

    def start(_name: str, _given: dict[str, str]) -> None:
        nonlocal count
        count += 1
        if count in indices:
            found[count] = (parser.CurrentLineNumber, parser.CurrentColumnNumber + 1)
        if count >= last:
            raise _Stop

    def doctype(*_: object) -> None:
        raise _Stop

    parser.StartElementHandler = start
    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(data, True)
    except (_Stop, expat.ExpatError):
        return found
    return found


def _has(frame: _Frame, part: str) -> bool:
    return any(name == part for name, _ in frame.parts)


def _short(name: str) -> str:
    return name if len(name) <= 40 else name[:37] + "..."


def _nearest(name: str, known: Mapping[str, object]) -> str:
    """The known name most like ``name``; case does not count."""
    lower = {one.lower(): one for one in known}
    return lower[get_close_matches(name[:40].lower(), lower, n=1, cutoff=0.0)[0]]
