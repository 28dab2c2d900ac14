"""Places (``Problem.place``) followed into a document: which fields and positions they mean."""

from __future__ import annotations

from typing import Any

_FIELDS = {
    "state": ("states", "no"),
    "data": ("observe", "tag"),
    "situation": ("situations", "name"),
    "module": ("modules", "name"),
    "action": ("actions", ""),
    "event": ("events", ""),
    "say": ("says", ""),
    "param": ("params", ""),
    "result": ("results", ""),
    "entry": ("entries", ""),
    "requires": ("requires", ""),
    "provides": ("provides", ""),
}
"""A word of a place: the field with the members, and what names one of them (else its position)."""

Path = tuple[str | int, ...]


def follow(document: Any, place: tuple[str, ...]) -> tuple[Path, list[Any]] | None:
    """The path to what a place names, and the values on the way, the document first.

    None where there is nothing at the place. Of two members of one name, the first.
    """
    path: list[str | int] = []
    values = [document]
    rest = list(place)
    while rest:
        word = rest.pop(0)
        value = values[-1]
        if hasattr(value, "children") or hasattr(value, "components"):
            field, key = ("children", "") if hasattr(value, "children") else ("components", "id")
            name = word
        elif word in _FIELDS and rest:
            field, key = _FIELDS[word]
            name = rest.pop(0)
        else:
            held = getattr(value, word, None)
            if held is None:
                return None
            path.append(word)
            values.append(held)
            continue
        members = getattr(value, field, ())
        if key:
            at = next((i for i, one in enumerate(members) if getattr(one, key) == name), -1)
        else:
            at = int(name) if name.isdecimal() and int(name) < len(members) else -1
        if at < 0:
            return None
        path += [field, at]
        values.append(members[at])
    return tuple(path), values
