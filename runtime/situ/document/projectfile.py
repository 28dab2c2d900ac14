"""``situ.toml`` and ``robot.local.toml`` as settings (formats.md, *A project*).

Only what the file itself says is judged here; what it names is read by
``situ.document.folder``.
"""

from __future__ import annotations

import math
import re
import tomllib
from difflib import get_close_matches
from pathlib import PurePosixPath
from typing import Any

from situ.document import names
from situ.document import projectfile_mends as mends
from situ.document.datatypes import shown
from situ.document.place import Path
from situ.document.problem import Mend, Problem
from situ.document.project import SETTING_TYPES, Mqtt, Setting

MAX_BYTES = 1_000_000

_TEXT, _TEXTS, _ANY, _TABLE, _FLAG = "text", "texts", "any", "table", "flag"
_WORDS = {
    _TEXT: "a text in quotes",
    _TEXTS: 'a list of texts such as ["a", "b"]',
    _TABLE: 'a table such as { "a" = "b" }',
    _FLAG: "true or false, without quotes",
}

KEYS: dict[str, dict[str, str]] = {
    "project": {
        "name": _TEXT,
        "applications": _TEXTS,
        "spds": _TEXT,
        "modules": _TEXT,
        "media": _TEXT,
        "scenarios": _TEXT,
        "languages": _TEXTS,
    },
    "robot": {"endpoint": _TEXT, "adapter": _TEXT, "announce": _FLAG},
    "tags": {"*": _ANY},
    "durable": {"tags": _TEXTS},
    "places": {"*": _ANY},
    "mqtt": {"url": _TEXT, "in": _TABLE},
    "privacy": {"private": _TEXTS},
    "setting": {"tag": _TEXT, "label": _TEXT, "type": _TEXT, "choices": _TEXTS},
}
"""Every table and its keys; ``*`` stands for names of the designer's own."""

LOCAL = ("robot", "tags", "places", "mqtt")
"""The tables that ``robot.local.toml`` may lay over those of ``situ.toml``."""

CODE = re.compile(r"[A-Za-z]{2,3}([-_][A-Za-z0-9]{2,8})*")
"""A language as it is written, such as ``ja`` or ``pt-BR``."""

_AT = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")


class ProjectFile:
    """One file: its tables with the right types in them, and what was wrong.

    ``tables`` is None where the file could not be read at all.
    """

    def __init__(self, data: bytes, file: str, *, local: bool = False) -> None:
        self.file = file
        self.name = PurePosixPath(file).name
        self.problems: list[Problem] = []
        self._text = ""
        self.tables: dict[str, Any] | None = self._parse(data)
        if self.tables is not None:
            self._judge({key: KEYS[key] for key in LOCAL} if local else KEYS)

    def get(self, table: str, key: str) -> Any:
        """The value at ``table.key``, None where there is none."""
        return (self.tables or {}).get(table, {}).get(key)

    def problem(
        self,
        code: str,
        message: str,
        table: str = "",
        key: str = "",
        value: str = "",
        at: Path = (),
        mend: Mend | None = None,
    ) -> None:
        """Notes a problem at the place where ``key`` (and in it ``value``) is written.

        at: its place; ``table`` and ``key`` unless given.
        """
        line, column = place(self._text, table, key, value)
        where = tuple(map(str, at)) or tuple(filter(None, (table, key)))
        self.problems.append(
            Problem(
                file=self.file,
                line=line,
                column=column,
                code=code,
                message=message,
                place=where,
                mend=mend,
            )
        )

    def listed(self, code: str, message: str, key: str, value: str) -> None:
        """Notes a problem of the last such entry of a list of ``[project]``, or of a key there;
        its mend takes that out.
        """
        held = self.get("project", key)
        path: Path = ("project", key)
        if isinstance(held, list):
            path = (*path, len(held) - 1 - held[::-1].index(value))
        mend = mends.take_out(self.name, path, value)
        self.problem(code, message, "project", key, value, path, mend)

    def twice(self, file: str) -> None:
        """Notes that an application is named again."""
        said = f"{file} stands here twice: name each application once"
        self.listed("duplicate-file", said, "applications", file)

    def missing(self, key: str, file: str) -> None:
        """Notes that a file that ``[project]`` names is not there."""
        self.listed(
            "missing-file", f"There is no file {file}: add it, or take it out here", key, file
        )

    def mqtt(self) -> Mqtt | None:
        url, incoming = self.get("mqtt", "url"), self.get("mqtt", "in")
        if url is None and incoming is None:
            return None
        return Mqtt(url=url or "", incoming=incoming or {})

    def settings(self) -> tuple[Setting, ...]:
        listed = (self.tables or {}).get("setting", ())
        return tuple(Setting(**one | {"choices": tuple(one.get("choices", ()))}) for one in listed)

    # -- reading -----------------------------------------------------------------

    def _parse(self, data: bytes) -> dict[str, Any] | None:
        if len(data) > MAX_BYTES:
            self.problem("too-large", f"The file is larger than {MAX_BYTES // 1_000_000} MB")
            return None
        try:
            self._text = data.decode()
        except UnicodeDecodeError as wrong:
            line = data[: wrong.start].count(b"\n") + 1
            self._bad_toml("The file is not UTF-8 here: save it as UTF-8", line, 1)
            return None
        try:
            return tomllib.loads(self._text)
        except tomllib.TOMLDecodeError as wrong:
            said = str(wrong)
            match = _AT.search(said)
            assert match is not None
            said = said[: match.start()]
            if match[1]:
                line, column = int(match[1]), int(match[2])
            else:
                lines = self._text.split("\n")
                line, column = len(lines), len(lines[-1]) + 1
            self._bad_toml(f"This is no TOML here: {said}", line, column)
        except (RecursionError, ValueError) as wrong:
            self._bad_toml(f"This is no TOML: {shown(str(wrong))}", 1, 1)
        return None

    def _bad_toml(self, message: str, line: int, column: int) -> None:
        self.problems.append(
            Problem(
                file=self.file, line=line, column=column, code="malformed-toml", message=message
            )
        )

    def _judge(self, known: dict[str, dict[str, str]]) -> None:
        assert self.tables is not None
        tables, self.tables = self.tables, {}
        for table, content in tables.items():
            keys = known.get(table)
            if keys is None:
                near = get_close_matches(table[:40], known, n=1, cutoff=0.0)[0]
                where = table if isinstance(content, (dict, list)) else ""
                self.problem(
                    "unknown-key",
                    f"{shown(table)} is not known here; did you mean [{near}]?",
                    where,
                    "" if where else table,
                    mend=self._other_table(table, content, known, tables),
                )
            elif table == "setting":
                self.tables[table] = self._setting(content, keys)
            elif not isinstance(content, dict):
                self.problem("bad-value", f"{table} must be a table: [{table}]", "", table)
            else:
                self.tables[table] = {
                    key: value
                    for key, value in content.items()
                    if self._fits((table, key), keys, value, content)
                }
        self._tags()
        self._places()
        self._patterns("durable", "tags")
        self._patterns("privacy", "private")
        self._mqtt()

    def _other_table(
        self, table: str, content: Any, known: dict[str, dict[str, str]], there: dict[str, Any]
    ) -> Mend:
        """A table takes another's name only where that is one of its kind."""
        kind = list if isinstance(content, list) else dict if isinstance(content, dict) else None
        fitting = [one for one in known if kind is (list if one == "setting" else dict)]
        return mends.key(self.name, (table,), content, fitting, there)

    def _setting(self, content: Any, keys: dict[str, str]) -> list[dict[str, Any]]:
        if not isinstance(content, list) or not all(isinstance(one, dict) for one in content):
            self.problem("bad-value", "setting must be a table: [[setting]]", "setting")
            return []
        kept = []
        for at, one in enumerate(content):
            found = {
                key: value
                for key, value in one.items()
                if self._fits(("setting", at, key), keys, value, one)
            }
            if not names.is_tag(found.get("tag", "")):
                said = f"needs a tag, not {shown(str(one.get('tag', '')))}"
                where: Path = ("setting", at, "tag")
                self.problem("bad-tag", f"A [[setting]] {said}", "setting", "tag", at=where)
            elif (wrong := _wrong_form(found)) is not None:
                mend = mends.setting(self.name, at, found, SETTING_TYPES)
                named, where = found.get("type", ""), ("setting", at, "type")
                self.problem("bad-value", wrong, "setting", "type", named, where, mend)
            else:
                kept.append(found)
        return kept

    def _fits(self, path: Path, keys: dict[str, str], value: Any, there: dict[str, Any]) -> bool:
        """Whether a key, in which the path ends, is known and its value of the right kind."""
        table, key = str(path[0]), str(path[-1])
        kind = keys.get(key, keys.get("*"))
        if kind is None:
            near = get_close_matches(key[:40], keys, n=1, cutoff=0.0)[0]
            self.problem(
                "unknown-key",
                f"[{table}] has no key {shown(key)}; did you mean {near}?",
                table,
                key,
                at=path,
                mend=mends.key(self.name, path, value, list(keys), there),
            )
            return False
        fits = (
            kind == _ANY
            or (kind == _TEXT and isinstance(value, str))
            or (kind == _TABLE and isinstance(value, dict))
            or (kind == _FLAG and isinstance(value, bool))
            or (
                kind == _TEXTS
                and isinstance(value, list)
                and all(isinstance(one, str) for one in value)
            )
        )
        if not fits:
            mend = mends.kind(self.name, path, value, kind)
            said = f"{key} must be {_WORDS[kind]}"
            self.problem("bad-value", said, table, key, at=path, mend=mend)
        return fits

    # -- what the values may be --------------------------------------------------

    def _drop(
        self, table: str, key: str, code: str, message: str, mend: Mend | None = None
    ) -> None:
        self.problem(code, message, table, key, mend=mend)
        assert self.tables is not None
        del self.tables[table][key]

    def _tags(self) -> None:
        assert self.tables is not None
        every = self.tables.get("tags", {})
        for tag, value in list(every.items()):
            if not names.is_tag(tag):
                said = "a tag is words of a-z, 0-9, _ and - joined by dots"
                mend = mends.tag(self.name, ("tags", tag), value, every)
                self._drop("tags", tag, "bad-tag", f"{shown(tag)} can not be a tag: {said}", mend)
            elif names.is_reserved(tag):
                said = f"{shown(tag)} is written by the robot itself only: choose another tag"
                self._drop("tags", tag, "reserved-tag", said)
            elif not _is_json(value):
                said = "hold text, numbers, true, false, lists and tables only"
                self._drop("tags", tag, "bad-value", f"{shown(tag)} must {said}")

    def _places(self) -> None:
        assert self.tables is not None
        for place, value in list(self.tables.get("places", {}).items()):
            if not (
                isinstance(value, list)
                and len(value) == 3
                and all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in value)
                and all(_is_json(v) for v in value)
            ):
                said = "must be [x, y, heading]: two numbers in metres and one in degrees"
                self._drop("places", place, "bad-value", f"The place {shown(place)} {said}")

    def _patterns(self, table: str, key: str) -> None:
        every = self.get(table, key) or ()
        for index, pattern in enumerate(every):
            if not names.is_pattern(pattern):
                said = f"{shown(pattern)} is no tag or pattern: use words, dots, * and **"
                at = (table, key, index)
                mend = mends.pattern(self.name, at, pattern, every)
                self.problem("bad-tag", said, table, key, pattern, at, mend)

    def _mqtt(self) -> None:
        url = self.get("mqtt", "url")
        if isinstance(url, str) and url and not BROKER.fullmatch(url):
            said = "names no broker: give mqtt://HOST or mqtts://HOST, a user and a password"
            told = f"The url {said} stand in the robot's secrets.toml"
            self.problem("bad-value", told, "mqtt", "url")
        incoming = self.get("mqtt", "in")
        if incoming is None:
            return
        for topic, target in list(incoming.items()):
            if not topic or not FILTER.fullmatch(topic):
                said = "is no topic filter: + is one whole level, # the rest of them"
                at = ("mqtt", "in", topic)
                self.problem("bad-value", f"{shown(topic)} {said}", "mqtt", "in", topic, at)
                del incoming[topic]
                continue
            kind, _, name = target.partition(":") if isinstance(target, str) else ("", "", "")
            if not ((kind == "event" and name) or (kind == "tag" and names.is_tag(name))):
                said = 'must be given as "event:NAME" or "tag:NAME"'
                at = ("mqtt", "in", topic)
                told = f"What {shown(topic)} means {said}"
                mend = mends.meaning(self.name, at, target)
                self.problem("bad-value", told, "mqtt", "in", topic, at, mend)
                del incoming[topic]


BROKER = re.compile(r"mqtts?://(\[[0-9a-fA-F:.]+\]|[^\s/@:\[\]?#]+)(:\d{1,5})?/?")
FILTER = re.compile(r"#|([^+#/\0]*|\+)(/([^+#/\0]*|\+))*(/#)?")


def _wrong_form(setting: dict[str, Any]) -> str | None:
    """What is wrong with the kind of a ``[[setting]]``; None where people can fill it in."""
    kind = setting.get("type", "text")
    if kind not in SETTING_TYPES:
        near = get_close_matches(kind[:40], SETTING_TYPES, n=1, cutoff=0.0)[0]
        every = ", ".join(SETTING_TYPES)
        return f"No setting is a {shown(kind)}; did you mean {near}? There are {every}"
    choices = setting.get("choices", [])
    if kind != "choice":
        return f'Choices are for the type "choice", not {kind}' if choices else None
    if len(set(choices)) < 2 or len(set(choices)) < len(choices) or "" in choices:
        return 'A choice needs choices = ["a", "b"]: two texts or more, each once'
    return None


def _is_json(value: Any) -> bool:
    if isinstance(value, dict):
        return all(_is_json(one) for one in value.values())
    if isinstance(value, list):
        return all(_is_json(one) for one in value)
    if isinstance(value, float):
        return math.isfinite(value)
    return isinstance(value, (str, bool, int))


def place(text: str, table: str, key: str, value: str = "") -> tuple[int, int]:
    """Line and column of a key in a TOML file, or of a value behind it.

    Of its table where the key is not found; (0, 0) where that is not found either.
    """
    current, header, at = "", (0, 0), (0, 0)
    wanted = re.compile(rf"""\s*(["']?){re.escape(key)}\1\s*[=.]""") if key else None
    for number, line in enumerate(text.split("\n"), 1):
        opened = re.match(r"""\s*\[+\s*["']?([^\]"']+)""", line)
        if opened is not None and not at[0] and "=" not in line.partition("]")[0]:
            current = opened[1].strip()
            if current == table and not header[0]:
                header = (number, line.index("[") + 1)
        elif wanted is not None and not at[0] and current == table and wanted.match(line):
            at = (number, len(line) - len(line.lstrip()) + 1)
        if at[0] and value:
            column = line.find(value)
            if column >= 0:
                return number, column + 1
        elif at[0]:
            return at
    return at if at[0] else header
