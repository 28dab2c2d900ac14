"""XML to values: one pass of expat that makes each value where its element ends.

A file is data from anywhere: no DOCTYPE, no entities, nothing is fetched, and
depth, number and size of what it holds are bounded. Whatever is wrong becomes a
problem with its place.

``start`` and ``end`` in ``_Reading.parse`` are the loop, written for speed: what
is plain they do themselves, everything else is a method behind them.
"""

from __future__ import annotations

import gc
from collections import defaultdict
from typing import Any
from xml.parsers import expat

from msgspec.structs import replace

from situ.document.aside import Aside
from situ.document.compiled import NAMES, PARENTS, ROOT_RULES, Frame, Rule
from situ.document.datatypes import WHITE, short, shown
from situ.document.foreign import Foreign
from situ.document.grammar import Element, Misfit
from situ.document.problem import Problem
from situ.document.reader_problems import Findings, Found, Stop, malformed, nearest, not_text
from situ.document.start_tags import LONGEST, MAX_TEXT, Rest, StartTags
from situ.document.writer import XMLNS

MAX_BYTES = 64_000_000
MAX_DEPTH = 200
MAX_ELEMENTS = 300_000

_HANDLERS = (
    "StartElementHandler",
    "EndElementHandler",
    "CharacterDataHandler",
    "CommentHandler",
    "ProcessingInstructionHandler",
    "XmlDeclHandler",
    "StartDoctypeDeclHandler",
)


def read(data: bytes, file: str) -> tuple[Any, list[Problem]]:
    """The document in ``data``, or None where there is none, and what is wrong with it.

    A document that comes with errors lacks what they name; it is good for
    showing and checking more of it, and must not be saved over the file. ``file``
    is what problems call it.
    """
    # Everything made here stays: looking for what could be freed costs as much again.
    collecting = gc.isenabled()
    gc.disable()
    try:
        reading = _Reading(data)
        reading.parse()
    finally:
        if collecting:
            gc.enable()
    return reading.document, reading.findings.problems(data, file)


class _Reading:
    def __init__(self, data: bytes) -> None:
        self.data = data
        self.document: Any = None
        self._parser = expat.ParserCreate("utf-8", None, dict(NAMES))
        top = Rule(Element("", make=dict))
        top.children = {name: (rule, "document", False) for name, rule in ROOT_RULES.items()}
        self._stack: list[Frame] = [(top, "", False, -1, {})]
        self._rests: defaultdict[int, Rest] = defaultdict(Rest)
        self.findings = Findings(self._parser, self._stack)
        self._tags = StartTags(self.findings, self._stack, self._rests)
        self._texts: list[str] = []
        self._pending: list[str] = []
        self._foreign: Foreign | None = None

    # -- the loop ----------------------------------------------------------------

    def parse(self) -> None:
        """Reads all of the data; what comes of it is in ``document`` and ``findings``."""
        wrong = _too_large(self.data) or not_text(self.data)
        if wrong is not None:
            self.findings.found.append(wrong)
            return
        parser, stack, rests, tags = self._parser, self._stack, self._rests, self._tags
        texts, pending = self._texts, self._pending
        tags.long = long = self._has_long()
        index = -1

        def start(name: str, given: dict[str, Any]) -> None:
            nonlocal index
            index += 1
            parent, _, _, _, held = stack[-1]
            known = parent.children.get(name)
            if texts:
                if len(texts) == 1 and parent.text is None and texts[0].isspace():
                    texts.clear()
                else:
                    self._text_before_child()
            if known is None or index >= MAX_ELEMENTS or len(stack) > MAX_DEPTH:
                self._stranger(name, given, index)
                return
            rule, field, many = known
            if rule.part:
                if rule.mark in held:
                    self._duplicate(name)
                held[rule.mark] = rule.fresh()
                stack.append((rule, field, many, index, held))
            else:
                if not many and field in held:
                    self._duplicate(name)
                stack.append((rule, field, many, index, given))
            if pending:
                rests[index].before = tuple(pending)
                pending.clear()
            if given or rule.required:
                names = tuple(given)
                plan = rule.plans.get(names)
                if plan is None:
                    plan = rule.plan(names)
                    if plan is None:
                        plan = tags.irregular(rule, given, names, index)
                if long:
                    tags.shorten(rule, given)
                for key, at, values in plan:
                    value = given[key]
                    if values is not None:
                        try:
                            value = values[value]
                        except ValueError as wrong:
                            value = tags.bad_attribute(rule, key, wrong)
                    if at is not key:
                        del given[key]
                    given[at] = value
                if rule.part:
                    held.update(given)

        def end(_name: str) -> None:
            rule, field, many, index, values = stack[-1]
            if rule.text is None:
                if texts:
                    if len(texts) == 1 and texts[0].isspace():
                        texts.clear()
                    else:
                        self._text_before_child()
            else:
                if rule.known_text is None and len(texts) == 1 and not long and index not in rests:
                    values[rule.text] = texts.pop().strip(WHITE)
                else:
                    self._take_text(rule, index, values)
            stack.pop()
            if rule.part:
                if pending or index in rests or rule.attributes:
                    rest = rests[stack[-1][3]]
                    rest.parts = (*rest.parts, (rule.name, self._aside(index)))
                return
            for one in rule.many:
                if one in values:
                    values[one] = tuple(values[one])
            values["aside"] = self._aside(index) if pending or index in rests else Aside(index)
            try:
                value = rule.make(**values)  # type: ignore[misc]
            except Misfit as wrong:
                self.findings.problem(wrong.code, str(wrong), index)
                value = wrong.instead
            held = stack[-1][4]
            if not many:
                held[field] = value
            elif field in held:
                held[field].append(value)
            else:
                held[field] = [value]

        def foreign_start(name: str, given: dict[str, str]) -> None:
            nonlocal index
            index += 1
            assert self._foreign is not None
            self._limit(len(stack) + self._foreign.depth, index)
            self._foreign.start(name, given)

        def foreign_end(_name: str) -> None:
            assert self._foreign is not None
            if self._foreign.end():
                text = self._foreign.text(parser.CurrentByteIndex)
                if text is not None:
                    pending.append(text)
                self._foreign = None
                texts.clear()
                self._listen()

        def listen() -> None:
            foreign = self._foreign is not None
            parser.StartElementHandler = foreign_start if foreign else start
            parser.EndElementHandler = foreign_end if foreign else end

        self._listen = listen
        parser.buffer_text = True
        parser.CharacterDataHandler = texts.append
        parser.CommentHandler = self._comment
        parser.ProcessingInstructionHandler = self._instruction
        parser.XmlDeclHandler = self._xml_declaration
        parser.StartDoctypeDeclHandler = self._doctype
        listen()
        try:
            parser.Parse(self.data, True)
            self.document = self._complete(stack[0][4]["document"])
        except Stop:
            pass
        except expat.ExpatError as error:
            name = stack[-1][0].name
            self.findings.found.append(malformed(error, self.data, name, self.findings.place()))
        finally:
            # The functions above and the parser hold each other: let go of the file at once.
            for handler in _HANDLERS:
                setattr(parser, handler, None)
            self._listen = _nothing
            self._foreign = None

    # -- what is not an element --------------------------------------------------

    def _xml_declaration(self, _version: str, encoding: str | None, _alone: int) -> None:
        if encoding is not None and encoding.lower() not in ("utf-8", "utf8", "us-ascii"):
            said = f"The file says that it is {shown(encoding)}: save it as UTF-8"
            self.findings.problem("not-utf-8", said)
            raise Stop

    def _doctype(self, *_: object) -> None:
        self.findings.problem("doctype", "A DOCTYPE is not allowed: take it out")
        raise Stop

    def _comment(self, text: str) -> None:
        if self._foreign is None:
            self._pending.append(f"<!--{text}-->")

    def _instruction(self, target: str, text: str) -> None:
        if self._foreign is None:
            self._pending.append(f"<?{target} {text}?>" if text else f"<?{target}?>")

    # -- text --------------------------------------------------------------------

    def _text_before_child(self) -> None:
        """Text before a child, or before the end of an element that has no text."""
        text = "".join(self._texts)
        self._texts.clear()
        rule, _, _, index, _ = self._stack[-1]
        if rule.text is not None:
            rest = self._rests[index]
            rest.texts = (*rest.texts, text)
        elif not text.isspace():
            said = (
                f"Text cannot stand directly in <{rule.name}>: {shown(text)}; put it into an "
                "element that holds text, such as <speech>, or into a comment <!-- … -->"
            )
            self.findings.problem("unexpected-text", said, index)

    def _take_text(self, rule: Rule, index: int, values: dict[str, Any]) -> None:
        rest = self._rests.get(index)
        if rest is not None and rest.texts:
            self._texts[:0] = rest.texts
        text = "".join(self._texts).strip(WHITE)
        self._texts.clear()
        if not text and not rule.element.text_required:
            return
        if len(text) > MAX_TEXT:
            self.findings.problem(
                "too-long", f"The text of <{rule.name}> is too long: {LONGEST}", index
            )
            text = ""
        assert rule.text is not None
        if rule.known_text is None:
            values[rule.text] = text
            return
        try:
            values[rule.text] = rule.known_text[text]
        except ValueError as wrong:
            said = f"The text of <{rule.name}> {wrong}"
            if not text:
                said = f"<{rule.name}> is empty: write a number"
            self.findings.problem("bad-value", said, index)
            assert rule.element.text is not None
            values[rule.text] = rule.element.text[1].blank

    # -- what rides along --------------------------------------------------------

    def _aside(self, index: int) -> Aside:
        inside: tuple[str, ...] = ()
        if self._pending:
            inside = tuple(self._pending)
            self._pending.clear()
        rest = self._rests.pop(index, None)
        if rest is None:
            return Aside(index, (), inside)
        return Aside(index, rest.before, inside, (), rest.attributes, rest.parts)

    def _complete(self, document: Any) -> Any:
        """The document with what stands after its root, and the namespaces declared anywhere."""
        declared = self._tags.declared
        if not self._pending and not declared:
            return document
        aside: Aside = document.aside
        spaces = tuple((f"{{{XMLNS}}}{prefix}", uri) for prefix, uri in declared)
        after = tuple(self._pending)
        aside = replace(aside, after=after, attributes=(*aside.attributes, *spaces))
        return replace(document, aside=aside)

    # -- what may not stand where it does ----------------------------------------

    def _limit(self, depth: int, index: int) -> None:
        if depth > MAX_DEPTH:
            said = f"Elements stand more than {MAX_DEPTH} deep in each other: close some before"
            self.findings.problem("too-deep", said)
            raise Stop
        if index >= MAX_ELEMENTS:
            said = f"The file holds more than {MAX_ELEMENTS} elements: split it into parts"
            self.findings.problem("too-many", said)
            raise Stop

    def _has_long(self) -> bool:
        """Whether any attribute may be too long: somewhere no ``<`` stands for long."""
        at, size = 0, len(self.data)
        while at + MAX_TEXT < size:
            found = self.data.rfind(b"<", at, at + MAX_TEXT)
            if found < 0:
                return True
            at = found + 1
        return False

    def _duplicate(self, name: str) -> None:
        said = f"<{self._stack[-1][0].name}> holds two <{name}>: only one may stand here"
        self.findings.problem("duplicate-element", said)

    def _stranger(self, name: str, given: dict[str, Any], index: int) -> None:
        """An element that has no place here: foreign, or unknown."""
        self._limit(len(self._stack), index)
        parent = self._stack[-1][0]
        if not parent.name:
            said = f"<{short(name)}> is no document of Situ"
            self.findings.problem(
                "unknown-element", f"{said}; did you mean <{nearest(name, ROOT_RULES)}>?"
            )
            raise Stop
        foreign = bool(given.get("xmlns")) or ":" in name
        self._tags.declare(given)
        if not foreign:
            belongs = PARENTS[self._stack[1][0].name].get(name)
            if belongs is not None and belongs != parent.name:
                said = f"<{name}> has no place in <{parent.name}>: it belongs in <{belongs}>"
                self.findings.problem("misplaced-element", said)
            else:
                said = f"<{short(name)}> is not known in <{parent.name}>"
                if parent.children:
                    said += f"; did you mean <{nearest(name, parent.children)}>?"
                else:
                    said += ": nothing can stand in it"
                self.findings.problem("unknown-element", said)
        self._foreign = Foreign(
            self.data, self._parser.CurrentByteIndex, self._tags.bound, keep=foreign
        )
        self._foreign.start(name, given)
        self._listen()


def _nothing() -> None:
    """Nobody listens any more."""


def _too_large(data: bytes) -> Found | None:
    if len(data) <= MAX_BYTES:
        return None
    said = f"The file is larger than {MAX_BYTES // 1_000_000} MB: split it into parts"
    return Found("too-large", said, 1, 1)
