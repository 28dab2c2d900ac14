"""Start tags that are not wholly plain: with attributes foreign, unknown, missing, wrong or long.

What is wrong with them, and how to read them all the same. Plain ones are the reader's own.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NoReturn

from situ.document.aside import EDITOR, Aside
from situ.document.compiled import Frame, Known, Plan, Rule
from situ.document.datatypes import short
from situ.document.foreign import declared
from situ.document.reader_problems import Findings, Stop, nearest
from situ.document.writer import XML

MAX_TEXT = 1_000_000
LONGEST = "a million characters are the most"


class Rest:
    """What an open element has that most have not. bound: the namespaces that it declares."""

    before: tuple[str, ...] = ()
    attributes: tuple[tuple[str, str], ...] = ()
    parts: tuple[tuple[str, Aside], ...] = ()
    texts: tuple[str, ...] = ()
    bound: Mapping[str, str] = MappingProxyType({})


class StartTags:
    """Those of one file. open: the elements that are open, innermost last; rests: by their places
    in the file. declared: the namespaces declared anywhere, for the root. long: whether any
    attribute of the file may be too long.
    """

    def __init__(
        self, findings: Findings, open: list[Frame], rests: defaultdict[int, Rest]
    ) -> None:
        self.declared: list[tuple[str, str]] = []
        self.long = False
        self._findings = findings
        self._open = open
        self._rests = rests
        self._plans: dict[tuple[Rule, tuple[str, ...]], tuple[Plan, _Foreign]] = {}

    def irregular(
        self, rule: Rule, given: dict[str, Any], names: tuple[str, ...], index: int
    ) -> Plan:
        """How to read a start tag with attributes that are foreign, unknown or missing."""
        plan, foreign = self._plans.get((rule, names)) or self._plan(rule, given, names, index)
        if self.long:
            self.shorten(rule, given)
        if foreign:
            attributes = [(full, given.pop(key)) for key, full in foreign]
            self._rests[index].attributes = tuple(attributes)
        return plan

    def shorten(self, rule: Rule, given: dict[str, Any]) -> None:
        """Empties attributes that are too long."""
        for key, text in given.items():
            if len(text) > MAX_TEXT:
                said = f"The {short(key)} of <{rule.name}> is too long: {LONGEST}"
                self._findings.problem("too-long", said)
                given[key] = ""

    def bad_attribute(self, rule: Rule, key: str, wrong: ValueError) -> Any:
        """What stands for the value of an attribute that is missing or can not be read."""
        if isinstance(wrong, _Absent):
            said = f'<{rule.name}> needs the attribute "{key}": add {key}="…"'
            self._findings.problem("missing-attribute", said)
        else:
            self._findings.problem("bad-value", f"The {key} of <{rule.name}> {wrong}")
        if key in rule.required:
            return rule.blank[key]
        field = rule.attributes[key][0]
        return next(one.default for one in rule.element.attributes if one.field == field)

    def declare(self, given: Mapping[str, str]) -> dict[str, str]:
        """The namespaces that a start tag declares, taken note of for the root."""
        found = declared(given)
        self.declared += [one for one in found.items() if one not in self.declared]
        return found

    def bound(self, prefix: str) -> str:
        """The namespace of a prefix where the parser stands; ends reading where there is none."""
        for _, _, _, index, _ in reversed(self._open):
            rest = self._rests.get(index)
            if rest is not None and prefix in rest.bound:
                return rest.bound[prefix]
        if prefix == "xml":
            return XML
        said = f'The prefix "{short(prefix)}" is not declared'
        if prefix == "ed":
            said += f': add xmlns:ed="{EDITOR}" to the first element'
        self._findings.problem("malformed-xml", said)
        raise Stop

    def _plan(
        self, rule: Rule, given: dict[str, Any], names: tuple[str, ...], index: int
    ) -> tuple[Plan, _Foreign]:
        """How to read a start tag, and its foreign attributes with their full names.

        Takes declarations and what is unknown out of ``given``. A plan is kept where
        the same attributes always mean the same: with no declaration but the root's.
        """
        if given.get("xmlns"):
            said = f"<{rule.name}> must have no namespace: take the xmlns attribute out"
            self._findings.problem("unknown-namespace", said)
            raise Stop
        bound = self.declare(given)
        if bound:
            self._rests[index].bound = bound
        plain: list[tuple[str, str, Known | None]] = []
        foreign: list[tuple[str, str]] = []
        keep = not bound and "xmlns" not in given
        for key in names:
            if key in rule.attributes:
                field, values = rule.attributes[key]
                if values is not None or field != key:
                    plain.append((key, field, values))
            elif key == "xmlns" or key.startswith("xmlns:"):
                del given[key]
            elif ":" in key:
                prefix, _, local = key.partition(":")
                foreign.append((key, f"{{{self.bound(prefix)}}}{local}"))
            else:
                keep = False
                del given[key]
                said = f'<{rule.name}> has no attribute "{short(key)}"'
                if rule.attributes:
                    said += f'; did you mean "{nearest(key, rule.attributes)}"?'
                self._findings.problem("unknown-attribute", said)
        for key in rule.required:
            if key not in given:
                keep = False
                given[key] = ""
                plain.append((key, rule.attributes[key][0], _ABSENT))
        made = (tuple(plain), tuple(foreign))
        if keep and not any(rest.bound for at, rest in self._rests.items() if at > 0):
            self._plans[rule, names] = made
        return made


_Foreign = tuple[tuple[str, str], ...]


class _Absent(ValueError):
    """An attribute that must be there is not."""


def _absent(_text: str) -> NoReturn:
    raise _Absent


_ABSENT = Known(_absent)
