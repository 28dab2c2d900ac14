"""How a machine can take away what is wrong in ``situ.toml``: mends as data (``mend_toml`` applies
them).
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Sequence
from difflib import get_close_matches
from typing import Any

from msgspec.structs import replace

from situ.document import names
from situ.document.datatypes import shown
from situ.document.place import Path
from situ.document.problem import Change, Mend

SURE = 0.75
"""From which likeness on (difflib's ratio) a key was plainly meant to be another."""


def put(file: str, path: Path, was: Any, to: Any, words: str, safe: bool = False) -> Mend:
    """The mend that gives what stands at a path another value; None takes it out."""
    return Mend(file, words, (Change(path, "set", _written(to), _written(was)),), safe)


def take_out(file: str, path: Path, was: Any) -> Mend:
    """The mend that takes out a key, or an entry of a list where the path ends in its position."""
    if isinstance(path[-1], int):
        words = f"Take {shown(str(was))} out"
        return Mend(file, words, (Change(path, "remove", was=_written(was)),))
    return put(file, path, was, None, f"Take {shown(str(path[-1]))} out")


def add(file: str, path: Path, value: str, words: str, safe: bool = False) -> Mend:
    """The mend that puts a text into a list, at the position in which the path ends."""
    return Mend(file, words, (Change(path, "insert", _written(value)),), safe)


def rename(file: str, path: Path, was: Any, new: str, safe: bool = False) -> Mend:
    """The mend that gives the key in which a path ends another name."""
    change = Change(path, "rename", _written(new), _written(was))
    return Mend(file, f"Rename it to {shown(new)}", (change,), safe)


def key(file: str, path: Path, was: Any, known: Sequence[str], taken: Collection[str]) -> Mend:
    """For a key that is not known: its plain meaning, if that is not there yet; else it goes."""
    near = get_close_matches(str(path[-1])[:40], known, n=1, cutoff=SURE)
    if near and near[0] not in taken:
        return rename(file, path, was, near[0], safe=True)
    return take_out(file, path, was)


def tag(file: str, path: Path, was: Any, taken: Collection[str]) -> Mend | None:
    """For a key that is no tag: the tag that is written most like it, where that is free."""
    near = _plain(str(path[-1]), r"[^a-z0-9_.-]+")
    good = names.is_tag(near) and not names.is_reserved(near) and near not in taken
    return rename(file, path, was, near) if good else None


def pattern(file: str, path: Path, was: str, taken: Collection[str]) -> Mend:
    """For what is no tag or pattern: the one that is written most like it; else it goes."""
    near = _plain(was, r"[^a-z0-9_.*-]+")
    if names.is_pattern(near) and near not in taken:
        return put(file, path, was, near, f"Write {shown(near)}")
    return take_out(file, path, was)


def kind(file: str, path: Path, was: Any, wanted: str) -> Mend | None:
    """For a value of another kind than its key takes: the same as that kind."""
    if wanted == "text" and isinstance(was, (int, float)):
        return put(file, path, was, _written(was), f"Write it as the text {shown(_written(was))}")
    if wanted == "texts" and isinstance(was, str):
        return put(file, path, was, [was], "Make it a list")
    if wanted == "flag" and was in ("true", "false"):
        return put(file, path, was, was == "true", f"Write it as {was}, without quotes")
    return None


def setting(file: str, at: int, found: dict[str, Any], types: Sequence[str]) -> Mend | None:
    """For a ``[[setting]]`` that people can not fill in: a kind that they can."""
    named, choices = found.get("type", "text"), found.get("choices")
    once = list(dict.fromkeys(one for one in choices or () if one))
    where = ("setting", at, "type")
    if named not in types:
        near = get_close_matches(named[:40], types, n=1, cutoff=0.5)
        return put(file, where, named, near[0], f"Make it a {near[0]}") if near else None
    offered = ("setting", at, "choices")
    if len(once) < 2:
        if named != "choice":
            return take_out(file, offered, choices)
        made = put(file, where, named, None, "Let any text be put in")
        # Choices are for a choice only.
        gone = () if choices is None else take_out(file, offered, choices).changes
        return replace(made, changes=(*made.changes, *gone))
    several = put(file, offered, choices, once, "Offer each choice once")
    if named == "choice":
        return several
    made = put(file, where, found.get("type"), "choice", "Make it a choice")
    return replace(made, changes=(*made.changes, *(several.changes if once != choices else ())))


def meaning(file: str, path: Path, was: Any) -> Mend | None:
    """For what a message from outside means, without the word that says of what kind it is."""
    if not isinstance(was, str) or ":" in was or not was.strip():
        return None
    name = was.strip()
    return put(file, path, was, f"event:{name}", f"Make it the event {shown(name)}")


def _plain(text: str, other: str) -> str:
    """The text in small letters, with - for what stands in no tag."""
    return re.sub(other, "-", text.strip().lower()).strip("-.")


def _written(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, default=str)
