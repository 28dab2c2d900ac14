"""What tells two documents apart, by meaning: laws."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import Struct
from msgspec.structs import fields, replace

from situ.document.aside import Aside
from situ.document.condition import Group
from situ.document.diff import compare

Place = tuple[str, ...]
SEEDS = st.integers(0, 10**9)


@given(seed=SEEDS)
@settings(max_examples=60, deadline=None)
def test_a_document_does_not_differ_from_itself(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    assert compare(document, _copied(document)) == []


@given(seed=SEEDS)
@settings(max_examples=150, deadline=None)
def test_every_edit_of_one_field_is_told_at_its_place(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document, random = make_document(seed), Random(seed)
    every = list(_edits(document))
    if not every:  # an empty <modules/>
        return
    place, path, edited = random.choice(every)
    assert edited != document
    for before, after in ((document, edited), (edited, document)):
        changes = compare(before, after)
        assert any(_names(change.place, place) for change in changes), (path, place, changes)
        assert all(len(change.text.splitlines()) == 1 for change in changes)


@given(seed=SEEDS, other=SEEDS)
@settings(max_examples=60, deadline=None)
def test_any_two_documents_are_told_apart_where_they_differ(
    make_document: Callable[[int], Any], seed: int, other: int
) -> None:
    before, after = make_document(seed), make_document(other)
    if type(before) is not type(after):
        assert [change.behaviour for change in compare(before, after)] == [True]
        return
    changes = compare(before, after)
    assert bool([c for c in changes if c.kind not in ("moved", "drawing")]) == (before != after)


@given(seed=SEEDS)
@settings(max_examples=60, deadline=None)
def test_what_only_moved_is_no_change_of_behaviour(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    moved = _moved(document)
    changes = compare(document, moved)
    assert changes
    assert {change.kind for change in changes} == {"moved"}
    assert not any(change.behaviour for change in changes)


def _copied(value: Any) -> Any:
    """An equal value that is nowhere the same object."""
    if isinstance(value, tuple):
        return tuple(_copied(one) for one in value)
    if isinstance(value, Struct):
        return replace(value, **{f.name: _copied(getattr(value, f.name)) for f in fields(value)})
    return value


def _moved(value: Any) -> Any:
    """With another position at every element."""
    if isinstance(value, Aside):
        x, y = value.position or (0.0, 0.0)
        return value.at(x + 1, y)
    if isinstance(value, tuple):
        return tuple(_moved(one) for one in value)
    if isinstance(value, Struct):
        return replace(value, **{f.name: _moved(getattr(value, f.name)) for f in fields(value)})
    return value


_WORDS = {
    "states": ("state", "no"), "actions": ("action", ""), "events": ("event", ""),
    "says": ("say", ""), "params": ("param", ""), "results": ("result", ""),
    "components": (None, "id"), "children": (None, ""), "observe": ("data", "tag"),
    "modules": ("module", "name"), "situations": ("situation", "name"), "entries": ("entry", ""),
    "requires": ("requires", ""), "provides": ("provides", ""),
}  # fmt: skip

_OTHER = {
    "kind": ("text", "pin"), "align": ("left", "right"), "order": ("first", "random"),
    "test": ("is", "isnot"), "type": ("text", "number"),
}  # fmt: skip


def _edits(value: Any, place: Place = (), path: str = "") -> Iterator[tuple[Place, str, Any]]:
    """Every edit of one field of a document: its place, its path, the document edited."""
    for field in fields(value):
        name, held = field.name, getattr(value, field.name)
        if isinstance(held, Aside) or held is None:
            continue
        if name in _WORDS and isinstance(held, tuple) and (name != "resources"):
            word, key = _WORDS[name]
            for index, one in enumerate(held):
                last = getattr(one, key) if key else str(index)
                inner = (*place, *([word] if word else []), last)
                rest = (held[:index], held[index + 1 :])
                yield inner, f"{path}.-{name}", replace(value, **{name: (*rest[0], *rest[1])})
                for where, way, edited in _edits(one, inner, f"{path}.{name}"):
                    whole = (*rest[0], edited, *rest[1])
                    yield where, way, replace(value, **{name: whole})
        elif isinstance(held, Struct):
            inner = (*place, name)
            if field.default is None:
                yield inner, f"{path}.-{name}", replace(value, **{name: None})
            for where, way, edited in _edits(held, inner, f"{path}.{name}"):
                yield where, way, replace(value, **{name: edited})
        else:
            yield place, f"{path}.{name}", replace(value, **{name: _changed(name, held, value)})


def _changed(name: str, held: Any, value: Any) -> Any:
    if name in _OTHER and not (name == "kind" and isinstance(value, Group)):
        first, second = _OTHER[name]
        return second if held == first else first
    if name == "kind":
        return "any" if held != "any" else "none"
    if isinstance(held, bool):
        return not held
    if isinstance(held, tuple):
        return (*held, "tail")
    return held + (1 if isinstance(held, (int, float)) else "z")


def _names(told: Place, place: Place) -> bool:
    """Whether a change's place names an edit's: it, or a condition or a group around it; the
    last word may be another where the edit is of the name itself or of the order.
    """
    if told == place[: len(told)] and len(told) >= min(len(place), 2):
        return True
    return len(told) == len(place) and told[:-1] == place[:-1]
