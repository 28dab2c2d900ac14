"""What module authors build on: it changes only where somebody means it to."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import situ
import situ.testing
from situ.blackboard import client
from situ.blackboard.client import (
    AsyncAuthority,
    AsyncBoard,
    AsyncFollowing,
    Authority,
    Board,
    Following,
)

KEPT = Path(__file__).parent / "public_names.txt"
MODULES: dict[ModuleType, list[str]] = {
    situ: [name for name in dir(situ) if name[0].isalpha() and name in situ._CLIENT],
    client: client.__all__,
    situ.testing: situ.testing.__all__,
}
# The others are for the editor and for drivers of other kinds.
FOR_AUTHORS = (
    *(AsyncAuthority, AsyncBoard, AsyncFollowing, Authority, Board, Following),
    situ.testing.Robot,
)


def told(thing: Any) -> str:
    """Annotations are as they are written; an empty string as a default is kept."""
    if not callable(thing):
        return ""
    return str(inspect.signature(thing)).replace("''", '""').replace("'", "")


def members(kind: type) -> Iterator[str]:
    for name, member in inspect.getmembers(kind):
        if not name.startswith("_") and not isinstance(member, property):
            yield name + told(member)
        elif isinstance(member, property):
            yield name


def names() -> Iterator[str]:
    for module, public in MODULES.items():
        for name in sorted(public):
            thing = getattr(module, name)
            if thing.__module__ != module.__name__ and module is situ:
                yield f"{module.__name__}.{name} is {thing.__module__}.{name}"
                continue
            yield f"{module.__name__}.{name}{told(thing)}"
            if thing in FOR_AUTHORS:
                yield from (f"{module.__name__}.{name}.{one}" for one in members(thing))


def test_public_names_and_signatures_stay() -> None:
    found = "\n".join(names()) + "\n"
    assert found == KEPT.read_text("utf-8"), (
        "a public name has changed: if that is meant, write it into public_names.txt and into "
        "docs/modules.md"
    )


@pytest.mark.parametrize(
    ("blocking", "awaited"),
    [(Board, AsyncBoard), (Following, AsyncFollowing), (Authority, AsyncAuthority)],
)
def test_both_forms_have_the_same_names_and_parameters(blocking: type, awaited: type) -> None:
    for name, member in inspect.getmembers(blocking):
        if not name.startswith("_"):
            other = getattr(awaited, name)
            assert isinstance(member, property) == isinstance(other, property), name
            if not isinstance(member, property):
                mine, its = inspect.signature(member), inspect.signature(other)
                assert list(mine.parameters) == list(its.parameters), name
                defaults = [one.default for one in mine.parameters.values()]
                assert defaults == [one.default for one in its.parameters.values()], name


def test_whatever_is_public_tells_what_it_does() -> None:
    for module, public in MODULES.items():
        for name in public:
            thing = getattr(module, name)
            assert inspect.getdoc(thing), f"{module.__name__}.{name}"
    for kind in (Board, Following, Authority, situ.testing.Robot):
        for name, member in inspect.getmembers(kind):
            if not name.startswith("_"):
                assert inspect.getdoc(member), f"{kind.__name__}.{name}"
